"""All measurements of error against time for one config, as a page, CSVs and text."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

from skylight_sh.config.schema import Config
from skylight_sh.studies import illuminance, page
from skylight_sh.studies.grid_samples import sample
from skylight_sh.studies.published import exported
from skylight_sh.studies.speed import batch, discs, evaluation, fits, growth, profiles, rules, speed

_BANDS = 7
LEAD = (
    "Error against time, measured in one run on one thread: medians after a warm-up, candidates timed in turn, so that "
    "ratios hold on a noisy machine where seconds do not. Errors are fractions."
)


def run(config: Config, reports: Path, repeats: int, advance: Callable[[int, int], None]) -> str:
    """Measure everything, publish ``reports/<name>/bench/`` and return all rows as text; the run must exist.

    The figures of speed are also in its ``speed.json``.
    """
    folder = reports / config.name
    tables, _ = exported(folder)
    samples = sample(config, max(_BANDS, *(t.bands for t in tables.values())), like=tables[config.export.recommended])

    def timed() -> page.Section:
        section = evaluation.section(samples, tables, repeats)
        speed.save(folder / "bench", section, tables, repeats)
        return section

    sections = (
        partial(rules.section, config, repeats),
        partial(fits.section, samples, repeats),
        timed,
        partial(batch.section, tables, repeats),
        partial(discs.section, repeats),
        illuminance.section,
        partial(profiles.section, config, samples, repeats),
        partial(growth.section, config),
    )
    return page.publish(folder / "bench", f"Benchmarks of {config.name}", LEAD, sections, advance)
