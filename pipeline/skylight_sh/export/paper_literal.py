"""The 2008 scheme as written, for comparison: every weight a polynomial of monomials, in double precision, then eq. 4."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from skylight_sh.export.template import template
from skylight_sh.formula import printers
from skylight_sh.formula.azimuth import TURN
from skylight_sh.formula.printers import C_DOUBLE
from skylight_sh.sphere import bands_of

Array = NDArray[np.float64]


def write(coefficients: Array, names: Sequence[str], channels: Sequence[str], prefix: str) -> str:
    """Return the header of ``coefficients`` ``(channels, N*N, d_1+1, .., d_D+1)`` over raw monomials of axes ``names``."""
    bands = bands_of(coefficients.reshape(*coefficients.shape[:2], -1)[0, :, 0])
    sizes = coefficients.shape[2:]
    return template("paper_literal.h.j2").render(
        p=prefix,
        P=prefix.upper(),
        bands=bands,
        channels=channels,
        names=names,
        sizes=sizes,
        terms=int(np.prod(sizes)),
        numbers=[f"{value:.17e}" for value in coefficients.ravel().tolist()],
        turned=printers.statements(TURN, C_DOUBLE, ["plus", "minus", "wave_cos[m]", "wave_sin[m]"])[1],
        parameters=", ".join(f"float {name}" for name in (names[0], "sun_azimuth", *names[1:])),
    )
