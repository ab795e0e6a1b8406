"""Tables against counting by hand: layouts, sizes, limits, runs of terms, and what surrounds a sky."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import ArrayLike, NDArray
from skylight_sh import runtime, sphere
from skylight_sh.fit.axis import Axis
from skylight_sh.light.preetham import Preetham
from skylight_sh.runtime import BitReader, ClassRows, Packed, Rows, Surroundings, Table
from skylight_sh.scene import surroundings
from skylight_sh.scene.surroundings import Clouds
from skylight_sh.table import bits, packed, prefactor, rows, twilight
from skylight_sh.table.powers import POWERS, in_powers
from skylight_sh.table.prefactor import bytes_of_factor, closed_form, reciprocal
from skylight_sh.table.row_layout import carried, columns, widths
from skylight_sh.table.size import bytes_of, coefficients_of
from skylight_sh.table.surroundings import gain
from skylight_sh.table.table import fast, float32_limits, small, specification

Array = NDArray[np.float64]
ZENITH = Axis("sun_zenith", 0.0, float(np.pi / 2), map="reciprocal", point=5.0)
HAZE = Axis("haze", 1.0, 3.0, map="log", point=0.5)


def staircase(dtype: str = "float32", around: Surroundings | None = None, **scene: Any) -> Table:
    """Two channels, three bands, lengths 3, 2 and 0 of one, 2, 1 and 0 of the other: eight terms."""
    rng = np.random.default_rng(1)
    spec = specification((ZENITH, HAZE), ("a", "b"), True, "chebyshev", None, **scene)
    dense = rng.normal(size=(2, sphere.Harmonics.even(3).count, 4, 3))
    return fast(spec, dense, np.array([[3, 2, 0], [2, 1, 0]]), 3, dtype, around)


def order(bands: int, *, mirrored: bool, quantity: str = "radiance") -> tuple[list[int], tuple[int, ...]]:
    """Each stored weight's column, and how many columns the first 1, 2, .. bands take."""
    spec = specification((ZENITH,), ("a",), mirrored, "chebyshev", quantity=quantity)
    return columns(spec, bands).tolist(), widths(spec, bands)


def test_columns_are_the_stored_weights_that_carry_anything() -> None:
    assert order(3, mirrored=True) == ([0, 1, 2, 3, 4, 5], (1, 3, 6))
    assert order(2, mirrored=False) == ([0, 1, 2, 3], (1, 4))
    # Diffuse irradiance has no band 3.
    assert order(5, mirrored=True, quantity="irradiance") == ([*range(6), *[-1] * 4, *range(6, 11)], (1, 3, 6, 6, 11))


def test_diffuse_irradiance_has_no_odd_bands_but_the_first() -> None:
    assert carried("irradiance", 7) == (0, 1, 2, 4, 6)
    assert carried("radiance", 4) == (0, 1, 2, 3)


def test_bands_that_carry_nothing_are_zero() -> None:
    table = fast(
        specification((ZENITH,), ("a",), True, "chebyshev", None, quantity="irradiance"),
        np.ones((1, 10, 2)),
        np.array([2]),
        4,
        "float32",
    )
    found = table.evaluate(np.array([[0.3]]))[0, 0]
    assert found[:6].all()
    assert found[6:].tolist() == [0.0] * 4
    assert coefficients_of(table) == 2 * 6


def test_rows_hold_the_terms_in_order() -> None:
    assert runtime.kept_terms(np.array([3, 0, 1])).tolist() == [0, 3, 6, 2]
    assert rows.used_degrees(np.array([3, 2, 0]), [9, 2]) == (2, 1)
    assert rows.used_degrees(np.array([0, 0]), [9, 1]) == (0, 0)
    assert rows.used_degrees(np.array([4]), [9]) == (3,)
    assert rows.used_degrees(np.array([0, 2, 0, 1, 0, 0]), [5, 1, 2]) == (1, 1, 1)


def test_sizes_are_those_of_every_number_read() -> None:
    """Of rows: width times terms, ranges and constants of the axes, a byte a length and a band's width."""
    table = staircase()
    assert table.degrees == (2, 1)
    assert coefficients_of(table) == 8 * 6
    # An axis has two ends; reciprocal and log have three constants each.
    axes = (2 + 3) + (2 + 3)
    assert bytes_of(table) == 4 * (8 * 6 + axes) + 4 + 3
    assert bytes_of(table, 1) == 4 * (8 * 1 + axes) + 4 + 3
    assert bytes_of(table, 2) == 4 * (8 * 3 + axes) + 4 + 3
    assert bytes_of(staircase(dtype="float64")) == 8 * (8 * 6 + axes) + 4 + 3
    assert bytes_of(staircase(peak_axis="sun_zenith", twilight=twilight.TWILIGHT)) - bytes_of(table) == 4 * 4
    around = Surroundings(np.eye(9), np.ones((2, 9)), np.zeros(0))
    surrounded = staircase(around=around)
    assert bytes_of(surrounded) - bytes_of(table) == 4 * (81 + 18)
    assert bytes_of(surrounded, 1) == bytes_of(surrounded)

    found = reciprocal(np.array([[2.0, 0.3], [0.4, 0.1]], dtype=np.float32), (ZENITH.specified, HAZE.specified))
    spec = specification((ZENITH, HAZE), ("a",), True, "chebyshev", found)
    numbers = np.zeros((6, 1, 3, 2), dtype=np.int64)
    numbers[:, 0, :2, 0] = np.arange(1, 13).reshape(6, 2)
    whole = small(spec, numbers, 0.5, (2, 1), 3)
    assert whole.degrees == (1, 0)
    assert coefficients_of(whole) == 12
    assert isinstance(whole.body, Packed)
    profiles = whole.body.rest_profile.size + whole.body.channel_profile.size
    assert bytes_of(whole) == len(whole.body.stream) + profiles + 4 * (axes + 4 + 1)
    assert bytes_of(whole, 2) < bytes_of(whole)


def test_prefactors_count_what_stands_in_their_code() -> None:
    sky = Preetham().hints.prefactor
    assert sky is not None
    turbid = Axis("turbidity", 2.5, 6.0)
    closed = closed_form(sky, (ZENITH.specified, turbid.specified))
    # 4/9, 1/120, pi, 2, 105, 10, 45, 1, 0.25, 1/32, 0.125, 1/128, 0.5, 1/24, 1/720 and the zenith's four, 1000 times.
    assert bytes_of_factor(closed, 4, packed=False) == 4 * (len(sky.constants) + 20)
    fixed = closed_form(sky, (ZENITH.specified,), {"turbidity": 3.0})
    assert fixed.fixed == (("turbidity", 3.0),)
    assert bytes_of_factor(fixed, 4, packed=False) == 4 * (len(sky.constants) + 1 + 20)
    # All but 4/9, 1/120, pi, 1/128, 1/24 and 1/720 have few digits: of ten powers, but for 1, there are 10^1 to 10^5.
    short = len(sky.constants) + 20 - 6
    assert bytes_of_factor(closed, 4, packed=True) == 2 * short + 4 * 6 + 4 * 5
    zeniths = np.array([0.0, 0.6, 1.5])
    pairs = np.stack([zeniths, np.full(3, 3.0)], axis=-1)
    assert prefactor.evaluate(fixed, zeniths[:, np.newaxis]).tolist() == prefactor.evaluate(closed, pairs).tolist()
    # 2 + 0.3 T1(v) + 0.4 T1(u) + 0.1 T1(u) T1(v) at two places.
    axes = (Axis("a", 0.0, 1.0).specified, Axis("b", 0.0, 4.0).specified)
    found = reciprocal(np.array([[2.0, 0.3], [0.4, 0.1]]), axes)
    assert bytes_of_factor(found, 4, packed=False) == 4 * 4
    assert bytes_of_factor(found, 4, packed=True) == 4 * 4
    got = prefactor.evaluate(found, np.array([[0.75, 1.0], [0.0, 4.0]]))
    assert got[:, 0] == pytest.approx([1 / (2 - 0.15 + 0.2 - 0.025), 1 / (2 + 0.3 - 0.4 - 0.1)])
    assert prefactor.evaluate(None, np.zeros((3, 2))).tolist() == [[1.0]] * 3
    assert bytes_of_factor(None, 4, packed=False) == 0


def test_limits_leave_a_millionth() -> None:
    table = staircase()
    values = np.array([1.0, 1.0 - 1.9e-6, 1.0 - 2.1e-6, 3.0 + 1.9e-6, 3.0 + 2.1e-6, np.nan])
    clamped, outside = table.clamp(np.stack([np.full(6, 0.5), values], axis=-1))
    assert outside.tolist() == [False, False, True, False, True, False]
    assert clamped[:5, 1].tolist() == [1.0, 1.0, 1.0, 3.0, 3.0]
    # The slack's own ends are inside.
    ends = np.array([[0.5, 1.0 - 1e-6 * 2.0], [0.5, 3.0 + 1e-6 * 2.0]])
    assert table.clamp(ends)[1].tolist() == [False, False]
    # A range narrower than 1 has the slack of 1.
    narrow = fast(
        specification((Axis("a", 0.0, 0.25),), ("one",), True, "chebyshev", None),
        np.ones((1, 1, 2)),
        np.array([2]),
        1,
        "float32",
    )
    assert narrow.clamp(np.array([[0.25 + 0.9e-6], [0.25 + 1.1e-6], [-0.9e-6], [-1.1e-6]]))[1].tolist() == [
        False,
        True,
        False,
        True,
    ]
    for (low, high), (first, last) in zip(table.ranges, float32_limits(table), strict=True):
        slack = 1e-6 * max(high - low, 1.0)
        assert np.float32(first) == first >= low - slack > float(np.nextafter(np.float32(first), np.float32(-9)))
        assert np.float32(last) == last <= high + slack < float(np.nextafter(np.float32(last), np.float32(9)))


def test_twilight_is_its_formula() -> None:
    """(1 - x)^10 (1 + 10 x) over twelve degrees: 0.6 % at six of them, and nothing at the end."""
    table = staircase(peak_axis="sun_zenith", twilight=twilight.TWILIGHT)

    def fade(zeniths: ArrayLike) -> Array:
        zeniths = np.atleast_1d(zeniths)
        return table.fade(np.stack([zeniths, np.full(zeniths.size, 2.0)], axis=-1))

    assert fade([0.0, np.pi / 2]).tolist() == [1.0, 1.0]
    assert fade(np.pi / 2 + np.radians([6.0, 3.0])) == pytest.approx([6 / 1024, 0.75**10 * 3.5])
    assert fade(np.pi / 2 + np.radians([12.0, 20.0])) == pytest.approx([0.0, 0.0], abs=1e-150)
    assert table.ranges[0] == (0.0, pytest.approx(np.pi / 2 + np.radians(12.0)))
    assert table.fade(np.array([[np.pi / 2 + np.radians(6.0), 2.0]])) == pytest.approx([6 / 1024])
    assert table.fade(np.array([[0.3, 2.0]])).tolist() == [1.0]


def test_the_runtime_sums_polynomials_and_turns_them() -> None:
    """One weight at a time: T_i(u) T_j(v) times its coefficient, m > 0 by the cosine, m < 0 by the sine (eq. 4)."""
    table = staircase(dtype="float64")
    assert isinstance(table.body, ClassRows)
    theta, phi, haze = 0.7, 1.1, 2.2
    u = (1 / (5 - theta) - 1 / 5) / (1 / (5 - np.pi / 2) - 1 / 5) * 2 - 1
    v = np.log((haze - 0.5) / 0.5) / np.log(2.5 / 0.5) * 2 - 1
    terms = (np.array([1, u, 2 * u * u - 1, v, u * v]), np.array([1, u, v]))
    loaded = runtime.Runtime(table)
    got, status = loaded.weights_and_status(theta, phi, haze)
    assert status == runtime.OK == 0
    for c, (own, values) in enumerate(zip(terms, np.split(table.body.rows, [5]), strict=True)):
        for column, (l, m) in enumerate([(0, 0), (1, 0), (1, 1), (2, 0), (2, 1), (2, 2)]):
            value = own @ values[:, column]
            assert got[c, l * (l + 1) + m] == pytest.approx(value * np.cos(m * phi))
            assert got[c, l * (l + 1) - m] == pytest.approx(value * (np.sin(m * phi) if m else 1.0))
    assert loaded.status(theta, phi, [0.0, 1.0, 3.0, 3.5, np.nan]).tolist() == [1, 0, 0, 1, 2]
    assert loaded.status(theta, [np.inf, -np.inf, 1e9], haze).tolist() == [2, 2, 0]
    assert loaded.weights([[0.1], [0.2]], [0.0, 0.5, 1.0], haze).shape == (2, 3, 2, 9)
    assert loaded.weights(theta, phi, haze, bands=2) == pytest.approx(got[:, :4])
    for bands in (0, 4):
        with pytest.raises(ValueError, match="Should be 1 to 3"):
            loaded.weights(theta, phi, haze, bands=bands)


def test_powers_are_the_same_polynomials() -> None:
    """T2 = 2 u^2 - 1 and T1 T1 = u v; what grows too much, or is no polynomial, stays."""
    table = staircase()
    held = in_powers(table)
    assert (held.spec.basis, held.degrees) == (POWERS, table.degrees)
    assert isinstance(table.body, ClassRows)
    assert isinstance(held.body, ClassRows)
    assert held.body.lengths.tolist() == table.body.lengths.tolist() == [[3, 2], [2, 1]]
    one, two = table.body.rows.astype(np.float64), held.body.rows
    expected = np.stack([one[0] - one[2], one[1], 2 * one[2], *one[3:]])
    assert two == pytest.approx(expected, rel=1e-6)
    values = np.random.default_rng(4).uniform([0.0, 1.0], [np.pi / 2, 3.0], (50, 2))
    assert held.evaluate(values) == pytest.approx(table.evaluate(values), abs=2e-6)
    flat = np.ones((1, 1, 12))
    steep = fast(specification((ZENITH,), ("a",), True, "chebyshev"), flat, np.array([12]), 1, "float32")
    assert in_powers(steep) is steep
    assert in_powers(staircase(dtype="float64")).spec.basis == "chebyshev"
    waves = fast(specification((ZENITH,), ("a",), True, "fourier"), flat, np.array([12]), 1, "float32")
    assert in_powers(waves) is waves


def test_rows_of_earlier_versions_are_those_of_classes() -> None:
    """A row that all channels kept becomes one of each; columns between them go."""
    spec = specification((ZENITH,), ("a", "b"), True, "chebyshev")
    columns_of_channels = np.array([[0, 2, 3], [1, 5, 6]], np.int16)
    body = Rows(np.array([2], np.uint8), np.arange(16.0, dtype=np.float32).reshape(2, 8), columns_of_channels)
    older = replace(fast(spec, np.ones((2, 3, 2)), np.array([2, 2]), 2, "float32"), body=body)
    found = rows.by_class(older)
    assert isinstance(found.body, ClassRows)
    assert found.body.rows.tolist() == [[0, 2, 3], [8, 10, 11], [1, 5, 6], [9, 13, 14]]
    assert (found.body.lengths.tolist(), found.body.columns.tolist()) == ([[2], [2]], [0, 1, 2])
    values = np.array([[0.1], [1.2]])
    assert np.array_equal(found.evaluate(values), older.evaluate(values))
    assert rows.by_class(found) is found


def test_bits_are_rice_codes() -> None:
    assert bits.zigzag(np.array([0, -1, 1, -2, 2, -3])).tolist() == [0, 1, 2, 3, 4, 5]
    assert bits.rice_bits(np.array([0, 5, 5, 5]), np.array([0, 0, 1, 3])).tolist() == [1, 6, 4, 4]
    writer = bits.Writer()
    # 3 folds to 6 = 110 over one low bit: three ones, a zero, 0; then 5 in three bits, lowest first: 101.
    writer.rice(3, 1)
    writer.fixed(5, 3)
    assert writer.bytes() == bytes([0b10100111])
    writer.rice(-1, 0)
    # -1 folds to 1: a one and a zero.
    assert writer.bytes() == bytes([0b10100111, 0b01])
    reader = BitReader(bytes([0b10100111, 0b01]))
    assert (reader.rice(1), reader.fixed(3), reader.rice(0)) == (3, 5, -1)


def test_a_packed_table_holds_the_largest_numbers_and_runs() -> None:
    largest = (1 << 30) - 1
    degrees = np.zeros(1, dtype=np.int64)
    numbers = np.array([largest, -largest]).reshape(1, 1, 2, 1)
    assert runtime.unpack(packed.pack(numbers, degrees), degrees).ravel().tolist() == [largest, -largest]
    with pytest.raises(ValueError, match="up to 1073741823, not 1073741824"):
        packed.pack(-numbers - np.array([1, 1]).reshape(1, 1, 2, 1), degrees)
    ones = np.ones((1, 1, 31, 1), dtype=np.int64)
    assert runtime.unpack(packed.pack(ones, degrees), degrees).ravel().tolist() == [1] * 31
    with pytest.raises(ValueError, match="at most 31 terms"):
        packed.pack(np.ones((1, 1, 32, 1), dtype=np.int64), degrees)


def test_packing_takes_no_more_bytes_than_it_took() -> None:
    """Twelve tables of numbers that fall off with degree and powers, of channels alike and unlike: 7,333 bytes in all."""
    total = 0
    for seed in (1, 2):
        for bands in (4, 7):
            degrees = sphere.Harmonics.even(bands).degrees
            for channels in ((1.0, 0.2, 3.0), (1.0, 1.0, 1.0), (0.01, 1.0, 30.0)):
                size = 3000.0 * np.reshape(channels, (3, 1, 1)) * 0.3 ** np.arange(7)[:, np.newaxis] * 0.15 ** np.arange(4)
                drawn = np.random.default_rng(seed).normal(size=(degrees.size, 3, 7, 4))
                numbers = np.rint(drawn * size * 0.5 ** degrees.reshape(-1, 1, 1, 1)).astype(np.int64)
                total += packed.cost(numbers, degrees)
    # Another CPU's logarithms may tip an entry.
    assert total <= 7340


def test_lights_add_to_what_clouds_shine() -> None:
    """Clouds hide by their opacity and shine themselves; lights come on top, and do not light the ground."""
    bands = 3
    wide = surroundings.mask_bands(bands)
    assert wide == 5
    opacity = np.zeros(wide * wide)
    opacity[0] = 0.25 * np.sqrt(4 * np.pi)
    lights = np.arange(18.0).reshape(2, 9)
    cloudy = surroundings.build(bands, clouds=Clouds(opacity, np.array([2.0, 3.0])))
    both = surroundings.build(bands, clouds=Clouds(opacity, np.array([2.0, 3.0])), lights=lights)
    alone = surroundings.build(bands, lights=lights)
    assert np.array_equal(alone.own, lights)
    assert not alone.transfer.size
    assert both.own == pytest.approx(cloudy.own + lights)
    assert np.array_equal(both.transfer, cloudy.transfer)
    level = sphere.horizon(0.0, wide)[:9]
    assert cloudy.own == pytest.approx(np.multiply.outer([0.5, 0.75], level), abs=1e-12)
    assert cloudy.transfer.size + cloudy.own.size + cloudy.below.size == 81 + 18

    ground = surroundings.build(bands, skyline=[0.1, 0.2, 0.1, 0.05], albedo=[0.5, 0.25], lights=lights)
    dark = np.zeros((2, 9))
    assert ground.apply(dark, bands) == pytest.approx(lights)
    lit = surroundings.build(bands, skyline=[0.1, 0.2, 0.1, 0.05], albedo=[0.5, 0.25])
    weights = np.random.default_rng(3).normal(size=(2, 9))
    seen = weights @ lit.transfer.T
    # Radiance albedo E / pi, E = 2 sqrt(pi / 3) times the weight l = 1, m = 0.
    shape = sphere.horizon([0.1, 0.2, 0.1, 0.05], wide)[:9] * -1
    shape[0] += np.sqrt(4 * np.pi)
    radiance = np.array([0.5, 0.25]) * 2 * np.sqrt(np.pi / 3) * seen[:, 2] / np.pi
    assert lit.apply(weights, bands) == pytest.approx(seen + radiance[:, np.newaxis] * shape)
    assert lit.apply(weights, 2).shape == (2, 4)
    with pytest.raises(ValueError, match="at least two bands"):
        surroundings.build(1, skyline=[0.1, 0.1], albedo=[0.5])


def test_the_gain_is_the_largest_stretch() -> None:
    assert gain(Surroundings()) == 1.0
    assert gain(Surroundings(own=np.ones((1, 4)))) == 1.0
    stretch = np.diag([1.0, 2.0, 0.5, 0.25])
    assert gain(Surroundings(stretch)) == pytest.approx(2.0)
    below = np.array([[0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 5.0, 0.0]])
    # The ground's share of the third weight: 0.5 + 5 * 0.5.
    assert gain(Surroundings(stretch, below=below)) == pytest.approx(3.0)
