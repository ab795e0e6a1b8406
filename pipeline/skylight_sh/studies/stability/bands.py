"""Bands from 1 to 32: the truth by two rules, and the fit in two number types."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from skylight_sh import sphere
from skylight_sh.config.schema import Config
from skylight_sh.quadrature import rings, sun_centred
from skylight_sh.runtime import Table
from skylight_sh.studies import outcomes, single_fit
from skylight_sh.studies.grid_samples import sample
from skylight_sh.studies.page import Row, Section
from skylight_sh.table.errors import measure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_BANDS = 32
_HELD = sphere.Harmonics.even(_BANDS)
_SETS = 12
_NODES = 96
TEXT = (
    "The config's whole fit, all degrees, for every number of bands to 32: the largest per-set E_mean on random sets "
    "and corners, kept and evaluated in double and in single precision; and how far the ring rule and the sun-centred "
    "rule are apart, two quadratures that share no node, relative to each set's largest weight. A band at which "
    "something broke would show as a step."
)


def section(config: Config, like: Table) -> Section:
    """Sample 32 bands once, and measure every prefix."""
    samples = sample(config, _BANDS, random=200, like=like)
    degrees = [min(a.degrees[1], n.size - 1) for a, n in zip(config.axes, samples.nodes, strict=True)]
    made = single_fit.fit(samples, samples.half, degrees, config.fit.basis, "svd", single_fit.OWN)
    errors = {
        dtype: measure(single_fit.table_of(samples, made, dtype), samples.reference).e_mean[0].max(axis=0)
        for dtype in ("float64", "float32")
    }
    apart = _apart(config, samples.reference.parameters[:_SETS])
    rows = [
        {
            "bands": n,
            "E_mean float64": float(errors["float64"][n - 1]),
            "E_mean float32": float(errors["float32"][n - 1]),
            "rules apart": float(apart[n - 1]),
        }
        for n in range(1, _BANDS + 1)
    ]
    return Section("bands", "Bands from 1 to 32", TEXT, rows, _draw, outcomes.bands(rows))


def _apart(config: Config, sets: np.ndarray) -> np.ndarray:
    """Return the largest difference of both rules over the first 1, 2, .. bands, ``(bands,)``."""
    named = {axis.name: sets[:, i, np.newaxis] for i, axis in enumerate(config.axes)}
    one, other = (rule.project(config.source, named, nodes=_NODES, harmonics=_HELD).weights for rule in (rings, sun_centred))
    relative = np.abs(one - other) / np.abs(one).max(axis=-1, keepdims=True)
    return np.array([relative[..., _HELD.degrees < n].max() for n in range(1, _BANDS + 1)])


def _draw(rows: Sequence[Row]) -> Figure:
    from skylight_sh.report import style

    figure = style.figure(style.WIDTH, 4.8)
    axes = figure.subplots()
    for i, key in enumerate(("E_mean float64", "E_mean float32", "rules apart")):
        values = [max(float(str(row[key])), 1e-17) for row in rows]
        told = key if key.startswith("E_mean") else f"{key}, of the largest weight"
        axes.semilogy([row["bands"] for row in rows], values, label=told, **{**style.look(i), "markevery": (i, 3)})
    axes.set_xlabel("bands N")
    axes.set_ylabel("fraction")
    style.decades(axes.yaxis)
    axes.grid(True, which="major", alpha=0.3)
    figure.legend(*axes.get_legend_handles_labels(), loc="outside lower center", fontsize=11, frameon=False)
    return figure
