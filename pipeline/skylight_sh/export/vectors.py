"""Test vectors of a table: inputs, and the status and weights that an evaluation must give, as text that C can scan.

The file starts with lines of a key and a value: ``skylight_sh_vectors`` (the format's version), ``inputs``, ``channels``,
``weights``, ``bound``, ``largest`` and ``vectors``. Each vector is then a line of inputs in the header's order, the status,
and a line of weights for each channel. ``bound`` holds for every weight, as a share of ``largest``, the largest weight.
Numbers are float32 to nine digits, which gives them back exactly; ``nan``, ``inf`` and ``-inf`` are what strtod reads.
"""

from __future__ import annotations

from itertools import product

import numpy as np
from numpy.typing import NDArray

from skylight_sh.export.template import template
from skylight_sh.runtime import Runtime, Table
from skylight_sh.table.table import float32_limits

FORMAT = 1
# The tests measure up to 5.8e-7 (contraction) and 6.5e-7 (-ffast-math): one bound does for every build.
BOUND = 2e-6

_RANDOM = 110
_SEED = 2008
# A file stays below this, by fewer random vectors (but never below _FEWEST) where a table has many weights.
_BYTES = 290_000
_FEWEST = 8
_HUGE = np.finfo(np.float32).max
_DENORMAL = np.float32(1e-45)
_AZIMUTHS = (0.0, -0.0, 1e-45, 1e-38, np.pi / 2, np.pi, -np.pi, 2 * np.pi, 1e4, -1e8, 3e38)

Singles = NDArray[np.float32]


def write(table: Table) -> str:
    """Return the text of the vectors of ``table``."""
    inputs = np.concatenate([_edges(table), _no_numbers(table), _inside(table)])
    if table.spec.azimuth is not None:
        inputs = np.delete(inputs, 1, axis=1)
    weights, status = Runtime(table).weights_and_status(*inputs.T)
    expected = weights.astype(np.float32)
    count = inputs.shape[0]
    texts = [_vector(inputs[i], int(status[i]), expected[i]) for i in range(count)]
    while sum(map(len, texts[:count])) > _BYTES and count > len(texts) - _RANDOM + _FEWEST:
        count -= 1
    keys = {
        "skylight_sh_vectors": FORMAT,
        "inputs": inputs.shape[1],
        "channels": expected.shape[1],
        "weights": expected.shape[2],
        "bound": f"{BOUND:.9g}",
        "largest": _number(np.abs(expected[:count]).max()),
        "vectors": count,
    }
    return "".join(f"{key} {value}\n" for key, value in keys.items()) + "".join(texts[:count])


def self_test(table: Table, prefix: str = "skylight_sh") -> str:
    """Return a C program, C99 and C++11, that holds ``skylight_sh.h`` against the vectors in its first argument."""
    return template("selftest.c.j2").render(
        p=prefix,
        P=prefix.upper(),
        format=FORMAT,
        inputs=len(Runtime(table).inputs),
        arguments=", ".join(f"in[{i}]" for i in range(len(Runtime(table).inputs))),
    )


def _vector(inputs: Singles, status: int, weights: Singles) -> str:
    lines = [" ".join(map(_number, inputs)), str(status)]
    lines += [" ".join(map(_number, channel)) for channel in weights]
    return "\n".join(lines) + "\n"


def _number(value: np.floating) -> str:
    return f"{value:.9g}"


def _row(azimuth: float, *values: float) -> Singles:
    """Return one row of inputs: the azimuth after the first axis."""
    return np.array([[values[0], azimuth, *values[1:]]], dtype=np.float32)


def _middle(table: Table) -> list[float]:
    return [(axis.low + axis.high) / 2 for axis in table.axes]


def _edges(table: Table) -> Singles:
    """All corners; every axis at, one float below and above its ends and the ends of its slack; the azimuth's own."""
    rows = [_row(0.7, *corner) for corner in product(*table.ranges)]
    for i, axis in enumerate(table.axes):
        for end in (axis.low, axis.high, *float32_limits(table)[i]):
            at = np.float32(end)
            for value in (np.nextafter(at, np.float32(-np.inf)), at, np.nextafter(at, np.float32(np.inf))):
                rows.append(_row(-2.0, *_middle(table)[:i], float(value), *_middle(table)[i + 1 :]))
    rows += [_row(azimuth, *_middle(table)) for azimuth in _AZIMUTHS]
    return np.concatenate(rows)


def _no_numbers(table: Table) -> Singles:
    """Each input in turn as NaN, infinite, denormal, zero and huge."""
    rows = []
    middle = _row(0.3, *_middle(table))
    for i in range(middle.shape[1]):
        for value in (np.nan, np.inf, -np.inf, _DENORMAL, -_DENORMAL, np.float32(1e-39), -0.0, _HUGE, -_HUGE):
            row = middle.copy()
            row[0, i] = value
            rows.append(row)
    everything = np.full_like(middle, np.inf)
    everything[0, 1] = 1.0
    return np.concatenate([*rows, everything, -everything, np.full_like(middle, np.nan)])


def _inside(table: Table) -> Singles:
    """Random inputs, one in eight of them beyond its range by up to its width."""
    rng = np.random.default_rng(_SEED)
    beyond = np.where(np.arange(_RANDOM) % 8 == 7, 1.0, 0.0)
    columns = []
    for low, high in table.ranges:
        width = high - low
        columns.append(rng.uniform(low - beyond * width, high + beyond * width, _RANDOM))
    columns.insert(1, rng.uniform(-7.0, 7.0, _RANDOM))
    return np.stack(columns, axis=-1).astype(np.float32)
