"""The paper's own polynomials as someone competent would write them: the rival that a speed-up is honest against."""

from __future__ import annotations

import math

from skylight_sh.formula.printers import C_SINGLE
from skylight_sh.studies import compiled, single_fit
from skylight_sh.studies.grid_samples import Samples
from skylight_sh.studies.speed import race
from skylight_sh.studies.speed.candidate import Candidate, parameters, variable
from skylight_sh.table.grid_fit import GridFit

# The most rows that are summed before the sums are stored: of 1, 2, 4, 8, 16 and Horner's rule this is within a few per cent
# of the fastest in every build.
_GROUP = 4


def well_written(samples: Samples) -> Candidate:
    """Return the scheme's polynomials over parameters scaled to [-1, 1], in float32, orders m >= 0 alone.

    The polynomials are those of the paper's degrees; over raw parameters single precision could not hold them.
    """
    made = single_fit.fit(samples, samples.half, single_fit.paper_degrees(samples), "monomial", "svd", "identity")
    return Candidate(header(made, samples.config.truth.bands), made.dense.size * 4, samples.config.truth.bands, "paper")


def header(made: GridFit, bands: int) -> str:
    """Return C of a fit of monomials ``(channels, N(N+1)/2, d_1+1, .., d_D+1)`` without a factor."""
    channels, count, *sizes = made.dense.shape
    rows = made.dense.reshape(channels * count, -1).T
    group = max(k for k in range(1, _GROUP + 1) if len(rows) % k == 0)
    return race.template(
        "well_written.h.j2",
        p=compiled.PREFIX,
        P=compiled.PREFIX.upper(),
        bands=bands,
        channels=channels,
        rows=math.prod(sizes),
        outputs=channels * count,
        group=group,
        numbers=[[C_SINGLE.number(value) for value in row] for row in rows.tolist()],
        parameters=parameters(made.axes),
        axes=[variable(axis) | {"size": size} for axis, size in zip(made.axes, sizes, strict=True)],
    )
