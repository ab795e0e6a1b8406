"""What the polynomials are multiplied by: a light's closed form, or the reciprocal of a polynomial found from samples."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh.fit.axis import Axis
from skylight_sh.fit.bases import BASES
from skylight_sh.light import PREFACTORS

Array = NDArray[np.float64]
Floats = NDArray[np.floating]


@dataclass(frozen=True)
class ClosedForm:
    """The prefactor ``name`` of a light, with its ``constants``; ``fixed`` are parameters that are no axes any more."""

    name: str
    constants: tuple[float, ...]
    fixed: tuple[tuple[str, float], ...] = ()

    @property
    def numbers(self) -> int:
        """How many numbers an evaluation reads, those written into the code included."""
        return len(self.constants) + len(self.fixed) + PREFACTORS[self.name].literals


@dataclass(frozen=True)
class Reciprocal:
    """1 over a Chebyshev polynomial in the table's own variables: ``coefficients`` ``(d_1+1, .., d_D+1)``."""

    coefficients: Floats

    @property
    def numbers(self) -> int:
        """How many numbers an evaluation reads."""
        return int(self.coefficients.size)


Factor = ClosedForm | Reciprocal


def evaluate(factor: Factor | None, axes: Sequence[Axis], values: Floats) -> Floats:
    """Return the factor at parameter sets ``(n, axes)``, shape ``(n,)``, in their dtype; ones where there is none."""
    if factor is None:
        return np.ones(len(values), dtype=values.dtype)
    if isinstance(factor, ClosedForm):
        named = {axis.name: np.ascontiguousarray(values[:, i]) for i, axis in enumerate(axes)}
        named |= {name: np.full(len(values), value, dtype=values.dtype) for name, value in factor.fixed}
        return np.asarray(PREFACTORS[factor.name].evaluate(named, factor.constants), dtype=values.dtype)
    out: Floats = np.broadcast_to(factor.coefficients.astype(values.dtype), (len(values), *factor.coefficients.shape))
    for i, axis in enumerate(axes):
        # The first axis left is summed over, again and again, in a fixed order.
        vander = BASES["chebyshev"].vander(axis.scaled(np.ascontiguousarray(values[:, i])), factor.coefficients.shape[i] - 1)
        terms = (out[:, k] * vander[:, k].reshape(-1, *(1,) * (out.ndim - 2)) for k in range(out.shape[1]))
        out = sum(terms, start=np.zeros(1, dtype=values.dtype))
    return np.asarray(1 / out, dtype=values.dtype)
