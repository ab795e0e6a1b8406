"""Bases in one scaled variable u, -1 to 1 (``monomial`` takes any)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh.reproducible import in_double

Floats = NDArray[np.floating]


@dataclass(frozen=True)
class Basis:
    """One family of functions.

    ``vander(u, degree)`` has shape ``(..., degree+1)`` in the dtype of u. ``nested``: orthogonal on Chebyshev nodes, so that
    lower fits are truncations. ``c_fill`` are C statements over ``real u``, ``real *t``, ``int i`` and ``n``, the number of
    functions, that fill ``t[1]`` to ``t[n-1]`` where ``t[0]`` is 1.
    """

    vander: Callable[[Floats, int], Floats]
    nested: bool
    c_fill: str


def _recurrence(step: Callable[[Floats, int, Floats, Floats], Floats]) -> Callable[[Floats, int], Floats]:
    """Return a basis 1, u, .. whose function k follows from the two before it: ``step(u, k, before, before_that)``."""

    def vander(u: Floats, degree: int) -> Floats:
        out = np.ones((*u.shape, degree + 1), dtype=u.dtype)
        if degree:
            out[..., 1] = u
        for k in range(2, degree + 1):
            out[..., k] = step(u, k, out[..., k - 1], out[..., k - 2])
        return out

    return vander


def _fourier(u: Floats, degree: int) -> Floats:
    """1, cos(pi u), sin(pi u), cos(2 pi u), ..: what the paper tried first; it takes u = -1 and 1 for one point."""
    out = np.ones((*u.shape, degree + 1), dtype=u.dtype)
    angle = np.asarray(np.pi, dtype=u.dtype) * u
    for k in range(1, degree + 1):
        out[..., k] = in_double(np.cos, (k + 1) // 2 * angle) if k % 2 else in_double(np.sin, k // 2 * angle)
    return out


_C_RECURRENCE = "if (n > 1) t[1] = u;\nfor (i = 2; i < n; ++i) t[i] = {step};"

BASES: dict[str, Basis] = {
    "chebyshev": Basis(
        _recurrence(lambda u, _, one, two: 2 * u * one - two),
        nested=True,
        # By products of lower ones: few steps wait for each other.
        c_fill=_C_RECURRENCE.format(step="2 * t[i / 2] * t[i - i / 2] - t[i & 1]"),
    ),
    "legendre": Basis(
        _recurrence(lambda u, k, one, two: ((2 * k - 1) * u * one - (k - 1) * two) / k),
        nested=False,
        c_fill=_C_RECURRENCE.format(step="((real)(2 * i - 1) * u * t[i - 1] - (real)(i - 1) * t[i - 2]) / (real)i"),
    ),
    "monomial": Basis(
        _recurrence(lambda u, _, one, __: u * one),
        nested=False,
        c_fill=_C_RECURRENCE.format(step="u * t[i - 1]"),
    ),
    "fourier": Basis(
        _fourier,
        nested=False,
        c_fill="for (i = 1; i < n; ++i) {\n"
        "    const real a = (real)3.14159265358979324 * (real)((i + 1) / 2) * u;\n"
        "    t[i] = i % 2 ? COS(a) : SIN(a);\n}",
    ),
}
