"""Named axes of a parameter space: range, change of variable, nodes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh import runtime
from skylight_sh.formula.expression import trace
from skylight_sh.formula.variables import VARIABLES

Array = NDArray[np.float64]
Floats = NDArray[np.floating]


@dataclass(frozen=True)
class Axis:
    """A parameter ``name`` over ``[low, high]`` in ``unit``, with a change of variable ``map`` about ``point``."""

    name: str
    low: float
    high: float
    unit: str = "1"
    map: str = "identity"
    point: float = 0.0

    @property
    def constants(self) -> tuple[float, ...]:
        """The numbers of the change of variable."""
        return VARIABLES[self.map].constants(self.low, self.high, self.point)

    def scaled(self, values: Floats) -> Floats:
        """Map parameter values to the fit's variable, in [-1, 1] unless the map is ``raw``; keeps the dtype.

        >>> Axis("turbidity", 2.5, 6.0, map="log", point=0.5).scaled(np.array([2.5, 6.0])).round(12).tolist()
        [-1.0, 1.0]
        """
        numbers = np.array(self.constants, dtype=values.dtype)
        return np.asarray(VARIABLES[self.map].forward(values, numbers))

    def unscaled(self, variable: Array) -> Array:
        """Map the fit's variable back to parameter values, inside the range to the last bit.

        >>> Axis("turbidity", 2.5, 6.0).unscaled(np.array([-1.0, 0.0, 1.0])).tolist()
        [2.5, 4.25, 6.0]
        """
        values = VARIABLES[self.map].inverse(variable, np.array(self.constants))
        return np.clip(values, self.low, self.high)

    @property
    def specified(self) -> runtime.Axis:
        """What a table's reader needs of the axis."""
        variable = trace(lambda v, k=(): [VARIABLES[self.map].forward(v, k)], [self.name], self.constants)
        return runtime.Axis(self.name, self.low, self.high, self.unit, self.map, self.point, variable)

    def fit_nodes(self, count: int, spacing: str) -> Array:
        """Return ``count`` rising nodes: Chebyshev roots in the fit's variable, or ``uniform`` with both ends.

        Of maps that have no nodes of their own, roots in the parameter itself.

        >>> Axis("height", -1.0, 1.0).fit_nodes(2, "chebyshev").round(4).tolist()
        [-0.7071, 0.7071]
        """
        if self.low == self.high:
            return np.full(count, self.low)
        if spacing == "uniform":
            return np.linspace(self.low, self.high, count)
        u = -np.cos(np.pi * (np.arange(count) + 0.5) / count)
        return self.unscaled(u) if VARIABLES[self.map].own_nodes else self._spread(u)

    def verification_nodes(self, count: int, avoid: Array) -> Array:
        """Return ``count`` rising nodes with both ends, dense towards them, that share no interior one with ``avoid``.

        >>> Axis("height", -1.0, 1.0).verification_nodes(3, avoid=np.array([0.5])).round(4).tolist()
        [-1.0, 0.0, 1.0]
        """
        if self.low == self.high or count == 1:
            return np.full(1, self.low)
        x = np.cos(np.pi * np.arange(count - 1, -1, -1) / (count - 1))
        nodes = self._spread(x)
        nodes[0], nodes[-1] = self.low, self.high
        spacing = np.diff(nodes).min()
        for i in range(1, count - 1):
            if np.abs(avoid - nodes[i]).min() < 1e-3 * spacing:
                nodes[i] += 0.25 * (nodes[i + 1] - nodes[i])
        return nodes

    def _spread(self, x: Array) -> Array:
        """Map [-1, 1] evenly onto the range."""
        return np.asarray((self.low + self.high + (self.high - self.low) * x) / 2)


def of_table(axis: runtime.Axis) -> Axis:
    """Return a table's axis as the fit knows it.

    >>> of_table(Axis("height", 0.0, 1.0).specified) == Axis("height", 0.0, 1.0)
    True
    """
    return Axis(axis.name, axis.low, axis.high, axis.unit, axis.map, axis.point)
