"""Test vectors: which inputs they hold, put together here once more from what the format promises."""

from __future__ import annotations

from itertools import product

import numpy as np
from conftest import with_spec
from numpy.typing import NDArray
from skylight_sh.export import vectors
from skylight_sh.studies.stability.flavours import flavours
from skylight_sh.table.table import float32_limits

Singles = NDArray[np.float32]


def parsed(text: str) -> tuple[dict[str, str], Singles]:
    """The keys, and the inputs ``(vectors, inputs)``."""
    keys = dict(line.split() for line in text.splitlines()[:7])
    inputs, channels, weights = (int(keys[key]) for key in ("inputs", "channels", "weights"))
    numbers = np.array(text.split()[14:], dtype=np.float32).reshape(int(keys["vectors"]), inputs + 1 + channels * weights)
    return keys, numbers[:, :inputs]


def test_inputs_are_corners_edges_no_numbers_and_random_ones() -> None:
    table = flavours()["twilight"]
    keys, inputs = parsed(vectors.write(table))
    assert (keys["skylight_sh_vectors"], keys["bound"], keys["vectors"]) == ("1", "2e-06", str(len(inputs)))
    end = np.pi / 2 + np.radians(12.0)
    ranges = [(0.0, end), (2.5, 6.0)]
    middle = [np.pi / 4, 4.25]

    expected = [[a, 0.7, b] for a, b in product(*ranges)]
    for axis, ends in enumerate([(0.0, np.pi / 2), (2.5, 6.0)]):
        for value in (*ends, *float32_limits(table)[axis]):
            at = np.float32(value)
            for one in (np.nextafter(at, np.float32(-np.inf)), at, np.nextafter(at, np.float32(np.inf))):
                expected.append([one, -2.0, middle[1]] if axis == 0 else [middle[0], -2.0, one])
    azimuths = (0.0, -0.0, 1e-45, 1e-38, np.pi / 2, np.pi, -np.pi, 2 * np.pi, 1e4, -1e8, 3e38)
    expected += [[middle[0], azimuth, middle[1]] for azimuth in azimuths]
    huge = float(np.finfo(np.float32).max)
    for place in range(3):
        for value in (np.nan, np.inf, -np.inf, 1e-45, -1e-45, 1e-39, -0.0, huge, -huge):
            row = [middle[0], 0.3, middle[1]]
            row[place] = value
            expected.append(row)
    expected += [[np.inf, 1.0, np.inf], [-np.inf, -1.0, -np.inf], [np.nan] * 3]
    known = np.array(expected, dtype=np.float32)
    assert np.array_equal(inputs[: len(known)], known, equal_nan=True)
    assert np.array_equal(np.signbit(inputs[: len(known)]), np.signbit(known))

    drawn = inputs[len(known) :]
    assert len(drawn) == 110
    rng = np.random.default_rng(2008)
    beyond = np.arange(110) % 8 == 7
    columns = [rng.uniform(low - beyond * (high - low), high + beyond * (high - low)) for low, high in ranges]
    columns.insert(1, rng.uniform(-7.0, 7.0, 110))
    assert np.array_equal(drawn, np.stack(columns, axis=-1).astype(np.float32))


def test_a_file_stays_small_by_fewer_random_vectors() -> None:
    table = flavours()["rows"]
    text = vectors.write(table)
    head = sum(map(len, text.splitlines(keepends=True)[:7]))
    lines = text.splitlines(keepends=True)[7:]
    count = len(parsed(text)[1])
    assert len(lines) == 5 * count
    # The next of the 110 would not have fitted.
    assert len(text) - head <= 290_000 < len(text) - head + 1.2 * len("".join(lines[-5:]))


def test_a_fixed_azimuth_is_no_input() -> None:
    assert parsed(vectors.write(with_spec(flavours()["rows"], azimuth=0.5)))[1].shape[1] == 2
