"""Everything the report shows, gathered once."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.fit.axis import Axis
from skylight_sh.fit.errors import published
from skylight_sh.light.protocol import Light
from skylight_sh.report import ringing
from skylight_sh.runtime import Surroundings, Table

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Entry:
    """A table with its measured errors.

    ``e_max``, ``e_mean`` ``(conventions, channels, bands)``, ``rel_l2`` ``(channels, bands)``, ``at`` ``(conventions,
    channels, bands, axes)``; ``per_set`` ``(sets,)`` the E_mean of each verification set, where a picture shows it.
    """

    name: str
    table: Table
    e_max: Array
    e_mean: Array
    rel_l2: Array
    at: Array
    per_set: Array | None = None
    condition: float | None = None

    @property
    def headline(self) -> tuple[float, float]:
        """E_mean and E_max over all bands and channels, first convention."""
        return self.headline_at(self.table.bands)

    def headline_at(self, bands: int) -> tuple[float, float]:
        """E_mean and E_max over the first ``bands`` bands and all channels, first convention, as published."""
        return published(self.e_mean[0, :, bands - 1].max()), published(self.e_max[0, :, bands - 1].max())

    @property
    def worst(self) -> Array:
        """The parameter set of the largest E_mean, shape ``(axes,)``."""
        channel = int(self.e_mean[0, :, -1].argmax())
        return np.asarray(self.at[0, channel, -1])


@dataclass(frozen=True)
class Sweep:
    """The sweep's errors: ``degrees`` ``(combinations, axes)``; the rest as in ``Entry``, combinations before channels."""

    degrees: NDArray[np.int64]
    e_max: Array
    e_mean: Array
    rel_l2: Array
    at: Array


@dataclass(frozen=True)
class ReportData:
    """What pictures and page are made of.

    ``sample`` gives a set's true weights ``(channels, count)``; ``fronts`` the Pareto front of bytes and E_mean,
    ``(points, 2)``, for each number of bands and layout; ``origins`` and ``lighting`` what the stages of these names
    found, if they ran, ``pictures`` by what they show; ``held_out`` counts the sets that errors were measured on;
    ``surroundings`` are by the number of bands.
    """

    name: str
    basis: str
    light: Light
    axes: tuple[Axis, ...]
    conventions: tuple[str, ...]
    fronts: Mapping[tuple[int, str], Array]
    origins: Mapping[str, NDArray[Any]] | None
    winners: tuple[Entry, ...]
    references: tuple[Entry, ...]
    recommended: str
    sweep: Sweep
    grid: tuple[Array, ...]
    least: Array
    held_out: int
    harmonics: sphere.Harmonics
    condition: float
    cases: Mapping[str, Array]
    sample: Callable[[Array], Array]
    settings: Mapping[str, Any]
    rule: Mapping[str, Any]
    surroundings: Mapping[int, Surroundings]
    lighting: Mapping[str, NDArray[Any]] | None = None
    pictures: Mapping[str, Mapping[str, NDArray[Any]]] = field(default_factory=dict)

    @property
    def best(self) -> Entry:
        """The recommended table."""
        return next(entry for entry in self.winners if entry.name == self.recommended)

    @property
    def middle(self) -> Array:
        """The middle of all ranges, a parameter set ``(axes,)``."""
        return np.array([(axis.low + axis.high) / 2 for axis in self.axes])

    @cached_property
    def ringing(self) -> ringing.Study | None:
        """How the light's expansions ring over its whole domain; measured once, when it is asked for."""
        return ringing.study(self.light, self.axes, self.best.table, self.harmonics.bands, self.full)

    def full(self, values: Array) -> Array:
        """Return a set's true weights ``(channels, N*N)``, all orders among them."""
        return np.asarray(self.harmonics.unmirror(self.sample(values)), dtype=np.float64)

    def describe(self, values: Array, first: int = 0) -> str:
        """Return a parameter set in words, angles in degrees, from the axis ``first`` on."""
        parts = []
        for axis, value in zip(self.axes[first:], values[first:], strict=True):
            shown = f"{np.degrees(value):.1f}°" if axis.unit == "rad" else f"{value:.3g}"
            parts.append(f"{axis.name.replace('_', ' ')} {shown}")
        return ", ".join(parts)
