"""Polynomial bases in one variable."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.floating]


@dataclass(frozen=True)
class Basis:
    """``vander(u, degree)`` has shape ``(..., degree+1)`` in the dtype of u; ``nested``: lower fits are truncations."""

    vander: Callable[[Floats, int], Floats]
    nested: bool
    c_step: str


def _chebyshev(u: Floats, degree: int) -> Floats:
    out = np.ones((*u.shape, degree + 1), dtype=u.dtype)
    if degree:
        out[..., 1] = u
    for k in range(2, degree + 1):
        out[..., k] = 2 * u * out[..., k - 1] - out[..., k - 2]
    return out


def _monomial(u: Floats, degree: int) -> Floats:
    out = np.ones((*u.shape, degree + 1), dtype=u.dtype)
    for k in range(1, degree + 1):
        out[..., k] = u * out[..., k - 1]
    return out


BASES: dict[str, Basis] = {
    "chebyshev": Basis(_chebyshev, True, "2 * u * t[i - 1] - t[i - 2]"),
    "monomial": Basis(_monomial, False, "u * t[i - 1]"),
}
