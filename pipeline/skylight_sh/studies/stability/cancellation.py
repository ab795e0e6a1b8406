"""Classes that cancel: how much larger than a channel's weights their parts are, and what that costs."""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from skylight_sh.fit.errors import norms
from skylight_sh.runtime import Packed, Table, orders_of, unpack
from skylight_sh.studies import single_fit
from skylight_sh.studies.grid_samples import Samples
from skylight_sh.studies.page import Row, Section
from skylight_sh.studies.stability import rounding, wide
from skylight_sh.table import prefactor
from skylight_sh.table.packed import lengths_of
from skylight_sh.table.table import whole

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

_SUNS = 19
_SHARES = (0.0, 0.5, 1.0)
_SHARE = "share of the others' ranges"
TABLES = (
    "A channel's weight is a sum over classes, each a factor times a polynomial. `parts` is the sum of the shares' "
    "magnitudes over the sum's, as norms over all weights of a set and channel; 1 is no cancellation, and its base-2 "
    "logarithm is how many bits are lost. `float32`: the largest E_mean that the table's own arithmetic adds to its "
    "polynomials in double precision, and `factors` what the factors alone add; the bound follows every operation's "
    "rounding to the result. `steps`: the whole fit with the terms that the packed table keeps, each coefficient rounded to "
    "the nearest multiple of its step; `expected` is of roundings that know nothing of each other, the bound of half a step "
    "in each, all the worst way round. All as E_mean, on random sets and corners."
)
WEIGHTS = (
    "The recommended table's weights one by one: the RMS over sets of their parts without signs over the RMS of the weight, "
    "for each channel; and the largest error in float32 over the RMS of the weight, with its bound, in the channel where "
    "the bound is largest."
)
MAP = (
    "The recommended table's parts over their sum, as norms over all weights, where the sun moves and the other axes are at "
    "their low ends, middles and high ends."
)


def sections(
    samples: Samples, recommended: Table, tables: Mapping[str, Table], published: Mapping[str, float]
) -> list[Section]:
    """Measure every table that is made of classes; sections have no rows where none is."""
    rows = [
        row for name, table in tables.items() if is_mixed(table) for row in _of_table(samples, name, table, published[name])
    ]
    mine = recommended if is_mixed(recommended) else None
    return [
        Section("cancellation", "Classes that cancel", TABLES, rows),
        Section(
            "cancellation-weights",
            "Classes that cancel, weight by weight",
            WEIGHTS,
            _of_weights(samples, mine) if mine else [],
        ),
        Section("cancellation-map", "Where classes cancel", MAP, _over_suns(mine) if mine else [], _draw),
    ]


def is_mixed(table: Table) -> bool:
    """Say whether channels are sums of classes, in single precision."""
    scale = table.spec.scale
    return scale is not None and len(scale.program.outputs) > 1 and table.dtype == np.float32


def amplification(parts: wide.Parts) -> Array:
    """Return how much larger the classes' shares are than their sum, ``(n, channels)``: 1 where nothing cancels."""
    return np.asarray(norms(parts.magnitudes) / norms(parts.weights))


def _of_table(samples: Samples, name: str, table: Table, published: float) -> list[Row]:
    sets, least = _sets(samples, table), samples.reference.headline
    parts = wide.parts(table, sets)
    larger = amplification(parts)
    single = norms(np.asarray(table.evaluate(sets) - parts.weights, dtype=np.float64)) / least[:, np.newaxis]
    bound = norms(rounding.bound(table, sets)) / least[:, np.newaxis]
    alone = norms(_by_factors(table, sets, parts)) / least[:, np.newaxis]
    steps = rounded_to_steps(samples, table, sets) if isinstance(table.body, Packed) else None
    rows: list[Row] = []
    for c, channel in enumerate(table.channels):
        row: dict[str, object] = {
            "table": name,
            "channel": channel,
            "parts, median": float(np.median(larger[:, c])),
            "parts, largest": float(larger[:, c].max()),
            "bits lost": float(np.log2(larger[:, c].max())),
            "float32": float(single[:, c].max()),
            "factors": float(alone[:, c].max()),
            "float32 bound": float(bound[:, c].max()),
        }
        row |= {f"steps{key}": float(found[:, c].max()) if steps else None for key, found in (steps or _NO_STEPS).items()}
        holds = bool((single[:, c] <= bound[:, c]).all())
        if steps:
            holds = holds and bool((steps[""][:, c] <= steps[" bound"][:, c]).all())
        row["published E_mean"] = published
        row["float32 of published"] = float(single[:, c].max()) / published
        row["holds"] = "yes" if holds else "no"
        rows.append(row)
    return rows


_NO_STEPS: Mapping[str, Array] = dict.fromkeys(("", " expected", " bound"), np.zeros((0, 0)))


def _sets(samples: Samples, table: Table) -> Array:
    return wide.in_single(table, samples.reference.parameters)


def _by_factors(table: Table, sets: Array, parts: wide.Parts) -> Array:
    """Return how far weights are off by factors in single precision alone, ``(n, channels, count)``."""
    rounded = prefactor.evaluate(table.spec.scale, sets.astype(np.float32)).astype(np.float64)
    return replace(parts, factors=rounded.reshape(parts.factors.shape)).weights - parts.weights


def rounded_to_steps(samples: Samples, table: Table, sets: Array) -> dict[str, Array]:
    """Return E_mean of rounding the whole fit to the table's steps: measured, expected, bounded, each ``(n, channels)``."""
    body = table.body
    if not isinstance(body, Packed):
        raise TypeError(f"A table laid out as {body.kind!r} has no steps.")
    step, sizes = float(np.float32(body.step)), [degree + 1 for degree in table.degrees]
    kept = _kept(table, body)
    highest = [min(a.degrees[1], n.size - 1) for a, n in zip(samples.config.axes, samples.nodes, strict=True)]
    made = single_fit.fit(samples, samples.half, highest, table.spec.basis, "svd", single_fit.OWN)
    cut = made.dense[(slice(None), slice(table.places.size), *(slice(size) for size in sizes))]
    cut = np.where(kept.reshape(cut.shape), cut, 0.0)
    exact, rounded = (whole(table.spec, dense, table.bands, "float64") for dense in (cut, step * np.rint(cut / step)))
    least = samples.reference.headline[:, np.newaxis]
    parts = wide.parts(table, sets)
    squares = np.einsum("nt,kwt->nkw", parts.terms**2, kept)
    magnitudes = np.einsum("nt,kwt->nkw", np.abs(parts.terms), kept)
    waves = parts.powers[:, np.newaxis]
    expected = step / np.sqrt(12.0) * np.sqrt(np.einsum("nck,nkw->ncw", parts.factors**2, squares)) * waves
    bound = step / 2.0 * np.einsum("nck,nkw->ncw", np.abs(parts.factors), magnitudes) * waves
    return {
        "": norms(rounded.evaluate(sets) - exact.evaluate(sets)) / least,
        " expected": norms(expected) / least,
        " bound": norms(bound) / least,
    }


def _kept(table: Table, body: Packed) -> NDArray[np.bool_]:
    """Return which products of functions a packed table keeps for each class and weight, ``(classes, count, products)``."""
    numbers = unpack(body, table.places)
    lengths = lengths_of(numbers)
    first, rest = table.degrees[0] + 1, int(np.prod([degree + 1 for degree in table.degrees[1:]], dtype=int))
    lengths = np.pad(lengths, ((0, 0), (0, 0), (0, rest - lengths.shape[2])))
    inside = np.arange(first)[:, np.newaxis] < lengths[:, :, np.newaxis, :]
    return np.asarray(inside.swapaxes(0, 1).reshape(lengths.shape[1], lengths.shape[0], -1))


def _of_weights(samples: Samples, table: Table) -> list[Row]:
    sets = _sets(samples, table)
    parts = wide.parts(table, sets)
    size = _rms(parts.weights)
    # Of irradiance some degrees carry nothing.
    carried = np.flatnonzero(size.any(axis=0))
    size = np.where(size > 0.0, size, 1.0)
    larger = _rms(parts.magnitudes) / size
    error, limit = np.abs(table.evaluate(sets) - parts.weights), rounding.bound(table, sets)
    single, bound = error.max(axis=0) / size, limit.max(axis=0) / size
    rows: list[Row] = []
    for w in carried.tolist():
        worst = int(bound[:, w].argmax())
        row: dict[str, object] = {"l": math.isqrt(int(table.places[w])), "m": int(orders_of(table.places)[w])}
        row |= {channel: float(larger[c, w]) for c, channel in enumerate(table.channels)}
        row |= {"float32": float(single[worst, w]), "float32 bound": float(bound[worst, w])}
        rows.append({**row, "holds": "yes" if (error[..., w] <= limit[..., w]).all() else "no"})
    return rows


def _rms(values: Array) -> Array:
    return np.asarray(np.sqrt(np.square(values).mean(axis=0)))


def _over_suns(table: Table) -> list[Row]:
    low, high = np.transpose([(axis.low, axis.high) for axis in table.axes])
    rows: list[Row] = []
    for share, sun in itertools.product(_SHARES, np.linspace(0.0, 1.0, _SUNS)):
        at = low + (high - low) * np.array([sun, *[share] * (len(table.axes) - 1)])
        larger = amplification(wide.parts(table, at[np.newaxis]))[0]
        named = {axis.name: float(value) for axis, value in zip(table.axes, at, strict=True)}
        rows.append({**named, _SHARE: share, **dict(zip(table.channels, larger.tolist(), strict=True))})
    return rows


def _draw(rows: Sequence[Row]) -> Figure:
    from skylight_sh.report import style

    figure = style.figure(style.WIDTH, 5.8)
    axes = figure.subplots()
    first, columns = next(iter(rows[0])), list(rows[0])
    channels = columns[columns.index(_SHARE) + 1 :]
    for c, channel in enumerate(channels):
        for share, line, marker in zip(_SHARES, ("-", "--", ":"), style.MARKERS, strict=False):
            mine = [row for row in rows if row[_SHARE] == share]
            x, y = ([float(str(row[key])) for row in mine] for key in (first, channel))
            look: dict[str, Any] = {
                "color": style.SERIES[c],
                "linestyle": line,
                "marker": marker,
                "markersize": 5,
                "markevery": (c, 3),
            }
            axes.plot(x, y, label=f"{channel}, others at {100 * share:g} %", **look)
    axes.set_xlabel(first.replace("_", " "))
    axes.set_ylabel("parts / sum")
    axes.grid(True, alpha=0.3)
    figure.legend(*axes.get_legend_handles_labels(), loc="outside lower center", fontsize=11, frameon=False)
    return figure
