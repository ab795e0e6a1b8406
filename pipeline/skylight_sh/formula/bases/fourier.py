"""1, cos(pi u), sin(pi u), cos(2 pi u), ..: what the paper tried first; it takes u = -1 and 1 for one point."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi
from typing import Any

from skylight_sh.formula.bases.protocol import Basis
from skylight_sh.formula.elementary import cos, sin


def _function(k: int, u: Any, _: Sequence[Any]) -> Any:
    angle = pi * u
    return cos((k + 1) // 2 * angle) if k % 2 else sin(k // 2 * angle)


BASIS = Basis(function=_function)
