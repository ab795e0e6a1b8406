"""What a basis is: functions of one variable, each by the ones before it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from skylight_sh.formula.expression import trace
from skylight_sh.runtime import Program

Floats = NDArray[np.floating]


@dataclass(frozen=True)
class Basis:
    """One family of functions; function 0 is 1.

    ``function(k, u, before)`` is function ``k >= 1`` of generic numbers ``u`` by those ``before`` it. ``nested``: orthogonal
    on Chebyshev nodes, so that lower fits are truncations. ``shallow`` is the same by products of lower functions, where
    there is such a way: few steps wait for each other, which compiled code likes.
    """

    function: Callable[[int, Any, Sequence[Any]], Any]
    nested: bool = False
    shallow: Callable[[int, Any, Sequence[Any]], Any] | None = None

    def vander(self, u: Floats, degree: int) -> Floats:
        """Return functions 0 to ``degree`` at ``u`` of any shape, ``(..., degree+1)``, in its dtype.

        >>> from skylight_sh.formula.bases import BASES
        >>> BASES["chebyshev"].vander(np.array([0.5]), 3).tolist()
        [[1.0, 0.5, -0.5, -1.0]]
        """
        out = np.ones((*u.shape, degree + 1), dtype=u.dtype)
        before: list[Floats] = [out[..., 0]]
        for k in range(1, degree + 1):
            out[..., k] = self.function(k, u, before)
            before.append(out[..., k])
        return out

    def program(self, degree: int, *, shallow: bool = False) -> Program:
        """Return functions 0 to ``degree`` as a program over ``u``; ``shallow`` where the basis has that way.

        >>> from skylight_sh.formula.bases import BASES
        >>> [float(value) for value in BASES["legendre"].program(2).run([np.float64(0.5)])]
        [1.0, 0.5, -0.125]
        """
        function = self.shallow if shallow and self.shallow else self.function

        def functions(u: Any) -> list[Any]:
            found: list[Any] = [1.0]
            for k in range(1, degree + 1):
                found.append(function(k, u, found))
            return found

        return trace(functions, ["u"])
