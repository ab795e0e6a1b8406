"""What a change of variable is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Variable:
    """A monotone map of a parameter's range onto [-1, 1], singular at most at a ``point``.

    ``constants(low, high, point)`` gives the numbers ``k`` of ``forward(v, k)``, a formula of generic numbers, and of
    ``inverse(u, k)``, which arrays alone ask for. ``allowed(low, high, point)`` says where the point must lie, or nothing
    where it lies well. ``own_nodes``: a grid has Chebyshev's nodes in the variable; else in the parameter itself.
    """

    constants: Callable[[float, float, float], tuple[float, ...]]
    forward: Callable[[Any, Any], Any]
    inverse: Callable[[Array, Any], Array]
    allowed: Callable[[float, float, float], str] = lambda *_: ""
    own_nodes: bool = True
