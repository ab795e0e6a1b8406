"""The stresses: bases, schemes, compilers, noise, harmonics, bands, edges, and the published tables on new sets."""

from __future__ import annotations

from skylight_sh.studies.run import Study
from skylight_sh.studies.stability import bands, bases, contraction, edges, harmonics, noise, schemes, winners

STABILITY = Study(
    name="stability",
    title="Stability",
    lead="What breaks, where, and what the pipeline does about it. Errors are fractions; E_mean is per set unless it says "
    "else.",
    sections=(
        lambda on: bases.section(on.samples),
        lambda on: schemes.section(on.samples),
        lambda on: contraction.section(on.samples, on.tables),
        lambda on: noise.section(on.samples),
        lambda _: harmonics.section(),
        lambda on: bands.section(on.config, on.recommended),
        lambda on: edges.section(on.samples, on.recommended),
        lambda on: winners.second_verification(on.samples, on.tables, on.published),
        lambda on: winners.smoothness(on.samples, on.tables),
    ),
)
