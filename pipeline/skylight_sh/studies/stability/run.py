"""All stresses of one config, as a page, CSVs and text."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

from skylight_sh.config.schema import Config
from skylight_sh.studies import page
from skylight_sh.studies.grid_samples import sample
from skylight_sh.studies.published import exported
from skylight_sh.studies.stability import bands, bases, contraction, edges, harmonics, noise, schemes, winners

_BANDS = 7
LEAD = (
    "What breaks, where, and what the pipeline does about it. Errors are fractions; E_mean is per set unless it says else."
)


def run(config: Config, reports: Path, advance: Callable[[int, int], None]) -> str:
    """Run every stress, publish ``reports/<name>/stability/`` and return all rows as text; the run must exist."""
    folder = reports / config.name
    tables, published = exported(folder)
    recommended = tables[config.export.recommended]
    samples = sample(config, max(_BANDS, *(t.bands for t in tables.values())), like=recommended)
    sections = (
        partial(bases.section, samples),
        partial(schemes.section, samples),
        partial(contraction.section, samples, tables),
        partial(noise.section, samples),
        harmonics.section,
        partial(bands.section, config, recommended),
        partial(edges.section, samples, recommended),
        partial(winners.second_verification, samples, tables, published),
        partial(winners.smoothness, samples, tables),
    )
    return page.publish(folder / "stability", f"Stability of {config.name}", LEAD, sections, advance)
