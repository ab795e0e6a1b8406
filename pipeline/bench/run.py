"""All measurements of error against time for one config, as a page, CSVs and text."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

from threadpoolctl import threadpool_limits

from pipeline.bench import batch, discs, evaluation, fits, growth, page, profiles, rules
from pipeline.bench.exported import exported
from pipeline.bench.samples import sample
from pipeline.config.schema import Config

_BANDS = 7
LEAD = (
    "Error against time, measured in one run on one thread: medians after a warm-up, candidates timed in turn, so that "
    "ratios hold on a noisy machine where seconds do not. Errors are fractions."
)
_COUNT = 7


def run(config: Config, reports: Path, repeats: int, advance: Callable[[int, int], None]) -> str:
    """Measure everything, publish ``reports/<name>/bench/`` and return all rows as text; the run must exist."""
    folder = reports / config.name
    with threadpool_limits(1):
        sections = []
        for done, section in enumerate(_sections(config, folder, repeats)):
            advance(done + 1, _COUNT)
            sections.append(section)
    return page.publish(folder / "bench", f"Benchmarks of {config.name}", LEAD, sections)


def _sections(config: Config, folder: Path, repeats: int) -> Iterator[page.Section]:
    tables, _ = exported(folder)
    samples = sample(config, max(_BANDS, *(t.bands for t in tables.values())), like=tables[config.export.recommended])
    yield rules.section(config, repeats)
    yield fits.section(samples, repeats)
    yield evaluation.section(samples, tables, repeats)
    yield batch.section(tables, repeats)
    yield discs.section(repeats)
    yield profiles.section(config, samples, repeats)
    yield growth.section(config)
