"""The stresses: bases, schemes, compilers, noise, harmonics, bands, edges, tables as they are evaluated, and on new sets."""

from __future__ import annotations

from skylight_sh.studies.run import Study
from skylight_sh.studies.stability import (
    bands,
    bases,
    cancellation,
    contraction,
    decoded,
    edges,
    gradients,
    harmonics,
    noise,
    schemes,
    turning,
    winners,
    zenith,
)

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
        lambda on: cancellation.sections(on.samples, on.recommended, on.tables, on.published),
        lambda on: zenith.sections(on.recommended, on.tables),
        lambda on: turning.section(on.recommended),
        lambda on: decoded.section(on.tables),
        lambda on: gradients.section(on.tables),
        lambda on: winners.second_verification(on.samples, on.tables, on.published),
        lambda on: winners.smoothness(on.samples, on.tables),
    ),
)
