"""All stresses of one config, as a page, CSVs and text."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

from threadpoolctl import threadpool_limits

from pipeline.bench import page
from pipeline.bench.exported import exported
from pipeline.bench.samples import sample
from pipeline.config.schema import Config
from pipeline.stability import bands, bases, contraction, edges, harmonics, noise, schemes, winners

_BANDS = 7
LEAD = (
    "What breaks, where, and what the pipeline does about it. Errors are fractions; E_mean is per set unless it says else."
)


def run(config: Config, reports: Path, advance: Callable[[int, int], None]) -> str:
    """Run every stress, publish ``reports/<name>/stability/`` and return all rows as text; the run must exist."""
    folder = reports / config.name
    with threadpool_limits(1):
        sections = []
        for done, section in enumerate(_sections(config, folder)):
            advance(done + 1, _COUNT)
            sections.append(section)
    return page.publish(folder / "stability", f"Stability of {config.name}", LEAD, sections)


_COUNT = 9


def _sections(config: Config, folder: Path) -> Iterator[page.Section]:
    tables, published = exported(folder)
    samples = sample(config, max(_BANDS, *(t.bands for t in tables.values())), like=tables[config.export.recommended])
    yield bases.section(samples)
    yield schemes.section(samples)
    yield contraction.section(samples, tables)
    yield noise.section(samples)
    yield harmonics.section()
    yield bands.section(config, tables[config.export.recommended])
    yield edges.section(samples, tables[config.export.recommended])
    yield winners.second_verification(samples, tables, published)
    yield winners.smoothness(samples, tables)
