"""Truth rules against closed forms: where their nodes lie, what these weigh, and how many a tolerance takes."""

from __future__ import annotations

import tracemalloc
from collections.abc import Callable, Mapping

import numpy as np
import pytest
from numpy.typing import NDArray
from skylight_sh import sphere
from skylight_sh.light import Domain, Hints
from skylight_sh.light.preetham import Preetham
from skylight_sh.quadrature import adaptive, convergence, least_luminance, monte_carlo, rings, sun_centred, zenith_gauss
from skylight_sh.quadrature.registry import RULES, suited
from skylight_sh.quadrature.samples import Samples, keep_least
from skylight_sh.scene import clear_day

Array = NDArray[np.float64]
HALF_PI = float(np.pi / 2)


class Seen:
    """A constant light, or one of a function of the direction, that remembers what it was asked for."""

    title, channels, luminance_row = "seen", ("value",), np.ones(1)

    def __init__(self, hints: Hints | None = None, side: float = 0.0) -> None:
        self.hints, self.side = hints or Hints(), side
        self.domains = {name: Domain(0.0, HALF_PI, "rad", "a test") for name in ("sun_zenith", "haze")}
        self.directions: list[Array] = []
        self.parameters: list[Mapping[str, Array]] = []

    def radiance(self, directions: Array, parameters: Mapping[str, Array]) -> Array:
        self.directions.append(directions)
        self.parameters.append(parameters)
        shape = np.broadcast_shapes(directions.shape[:-1], *(value.shape for value in parameters.values()))
        return np.broadcast_to(1.0 + self.side * np.sign(directions[..., 1]), shape)[..., np.newaxis]


def check_solid_angles(directions: Array, weights: Array) -> None:
    """Half a sky's nodes, each standing for its mirror image, integrate polynomials exactly."""
    assert np.abs(np.linalg.norm(directions, axis=-1) - 1.0).max() < 1e-14
    assert directions[:, 2].min() >= 0.0
    x, _, z = directions.T
    for power in range(6):
        assert weights @ z**power == pytest.approx(2 * np.pi / (power + 1), rel=1e-12)
    assert weights @ x == pytest.approx(0.0, abs=1e-12)
    assert weights @ x**2 == pytest.approx(2 * np.pi / 3, rel=1e-12)
    assert weights @ (x**2 * z) == pytest.approx(np.pi / 4, rel=1e-12)


@pytest.mark.parametrize("theta", [0.0, 0.4, 1.2, HALF_PI])
def test_sun_centred_nodes_are_graded_gauss_nodes(theta: float) -> None:
    """Full circles: 0.75 n radii in 1 - (1-t)^3, 0.8 n azimuths in 1 - (1-t)^2; then n arcs, pi/2 + theta sin u."""
    n = 100
    directions, weights = sun_centred.half_sky(theta, n)
    check_solid_angles(directions, weights)
    assert len(directions) == (75 + 100) * 80
    peak = np.array([np.sin(theta), 0.0, np.cos(theta)])
    angle = np.arctan2(np.linalg.norm(np.cross(directions, peak), axis=-1), directions @ peak).reshape(175, 80)
    x75, x80, x100 = (np.polynomial.legendre.leggauss(count)[0] for count in (75, 80, 100))
    circles = (HALF_PI - theta) * (1 - ((1 - x75) / 2) ** 3)
    arcs = HALF_PI + theta * np.sin(HALF_PI * x100)
    expected = np.concatenate([circles, arcs])
    assert np.abs(angle - expected[:, np.newaxis]).max() < 1e-7
    if 0.0 < theta < HALF_PI:
        # On a full circle psi, counted from the way up, is pi times the graded nodes.
        along = np.array([-np.cos(theta), 0.0, np.sin(theta)])
        psi = np.arctan2(-directions[:, 1], directions @ along).reshape(175, 80)[40]
        assert psi == pytest.approx(np.pi * (1 - ((1 - x80) / 2) ** 2), abs=1e-9)
    assert len(sun_centred.half_sky(theta, 8)[0]) == (8 + 8) * 8
    assert len(sun_centred.half_sky(theta, 24)[0]) == (18 + 24) * 19


@pytest.mark.parametrize(("theta", "bands"), [(0.0, 7), (0.4, 7), (1.2, 24), (HALF_PI, 7)])
def test_ring_nodes_are_graded_at_the_peak_and_the_horizon(theta: float, bands: int) -> None:
    """Rings by incomplete beta functions, cubic towards the peak from above, quadratic from below, cubic to the horizon."""
    n = 100
    directions, weights = rings.half_sky(theta, n, bands)
    check_solid_angles(directions, weights)
    azimuth = np.arctan2(directions[:, 1], directions[:, 0]).reshape(-1, n)
    height = np.arctan2(np.hypot(directions[:, 0], directions[:, 1]), directions[:, 2]).reshape(-1, n)[:, 0]

    def nodes(count: int) -> Array:
        return np.asarray((1 + np.polynomial.legendre.leggauss(count)[0]) / 2)

    parts = []
    if theta:
        t = nodes(round(n * (0.2 + 0.75 * theta / HALF_PI)))
        parts.append((theta * (1 - (1 - t) ** 3), theta * (1 - t) ** 3))
    if theta < HALF_PI:
        t = nodes(round(n * (0.3 + 0.75 * ((HALF_PI - theta) / HALF_PI) ** 0.75)))
        away = (HALF_PI - theta) * t**2 * (6 - 8 * t + 3 * t**2)
        parts.append((theta + away, away))
    expected, away = (np.concatenate(column) for column in zip(*parts, strict=True))
    assert height == pytest.approx(expected, abs=1e-7)

    # asinh(azimuth / k) + c azimuth runs evenly through Gauss nodes; k is the distance over the radius, at least 1e-3.
    # A sun at the zenith leaves no radius, and even azimuths.
    k = 2 * np.sin(away / 2) / np.maximum(np.sqrt(np.sin(expected) * np.sin(theta)), 1e-9)
    k = np.clip(k, 1e-3, 1e9)[:, np.newaxis]
    c = max(2.0, bands / 4)
    u = np.arcsinh(azimuth / k) + c * azimuth
    assert u == pytest.approx((np.arcsinh(np.pi / k) + c * np.pi) * nodes(n), rel=1e-7)
    few = rings.half_sky(theta, 8, bands)[0]
    assert len(few) == (8 + 8 if 0.0 < theta < HALF_PI else 8) * 8


def test_rules_that_know_no_sun_have_plain_nodes() -> None:
    directions, weights = zenith_gauss.directions(3)
    x, w = np.polynomial.legendre.leggauss(3)
    assert directions[:, 2] == pytest.approx(np.repeat((1 + x) / 2, 6))
    assert np.arctan2(directions[:6, 1], directions[:6, 0]) % (2 * np.pi) == pytest.approx(np.pi / 6 * np.arange(1, 12, 2))
    assert weights == pytest.approx(np.repeat(w * np.pi / 6, 6))
    directions, weights = monte_carlo.directions(4, seed=3)
    assert weights.tolist() == [pytest.approx(np.pi / 8)] * 16
    assert np.floor(4 * directions[:, 2]).tolist() == np.repeat(range(4), 4).tolist()
    turn = np.arctan2(directions[:, 1], directions[:, 0]) % (2 * np.pi)
    assert np.floor(turn / HALF_PI).tolist() == np.tile(range(4), 4).tolist()
    assert np.abs(np.linalg.norm(directions, axis=-1) - 1.0).max() < 1e-15


@pytest.mark.parametrize("rule", [sun_centred.project, rings.project, zenith_gauss.project])
def test_a_constant_sky_has_the_weights_of_half_a_sphere(rule: Callable[..., Samples]) -> None:
    parameters = {"sun_zenith": np.array([[0.3], [1.2]]), "haze": np.array([[0.1, 0.2, 0.3], [0.4, 0.5, 0.6]])}
    got = rule(Seen(Hints(peak_axis="sun_zenith")), parameters, nodes=40, harmonics=sphere.Harmonics(5))
    x, w = np.polynomial.legendre.leggauss(20)
    z = (1 + x) / 2
    half = np.sqrt((2 * np.arange(5) + 1) / (4 * np.pi)) * 2 * np.pi * (w / 2 @ np.polynomial.legendre.legvander(z, 4))
    degrees, orders = sphere.Harmonics(5).degrees, sphere.Harmonics(5).orders
    expected = np.where(orders == 0, half[degrees], 0.0)
    assert got.weights.shape == (2, 3, 1, 25)
    assert np.abs(got.weights - expected).max() < 1e-12
    assert got.least.tolist() == [[1.0] * 3] * 2
    assert np.isnan(got.estimate).all()


def test_plain_nodes_are_summed_in_blocks_of_bounded_memory() -> None:
    """The basis of a block is 64 MB; with what makes it, three times as much, whatever the number of nodes."""
    light = Preetham()
    parameters = {"sun_zenith": np.array([[0.3]]), "turbidity": np.array([[3.0]])}
    tracemalloc.start()
    zenith_gauss.project(light, parameters, nodes=160, harmonics=sphere.Harmonics(24))
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 250e6


def test_ladders_start_where_the_bands_ask() -> None:
    fine = [24, 32, 40, 48, 56, 64, 72, 88, 104, 128, 160, 200, 256]
    for name, more in (("sun-centred", 12), ("rings", 8)):
        ladder = RULES[name].ladder
        assert ladder is not None
        for bands in (1, 12, 13, 16, 17, 64):
            assert list(ladder(bands)) == [n for n in fine if n >= bands + more]
    zenith, stratified = RULES["zenith"].ladder, RULES["stratified"].ladder
    assert zenith is not None
    assert stratified is not None
    assert list(zenith(40)) == [2**k for k in range(4, 11)]
    assert list(stratified(40)) == [2**k for k in range(5, 12)]
    assert RULES["adaptive"].ladder is None
    assert [suited(Preetham(), bands) for bands in (15, 16)] == ["sun-centred", "rings"]
    assert suited(Seen(), 4) == "adaptive"
    assert suited(Seen(Hints(peak_zenith=0.0)), 4) == "sun-centred"


def test_nodes_are_chosen_on_five_values_an_axis() -> None:
    light = Seen(Hints(peak_axis="sun_zenith"))
    ranges = {"sun_zenith": (0.25, 1.25), "haze": (1.0, 3.0)}
    nodes, estimate = convergence.choose_nodes(light, ranges, harmonics=sphere.Harmonics.even(3), tolerance=1e-10)
    # The coarser of the two that agree, by 24 and by 32 nodes.
    assert nodes == 24
    assert estimate < 1e-12
    zeniths = np.concatenate([named["sun_zenith"].ravel() for named in light.parameters])
    hazes = np.concatenate([named["haze"].ravel() for named in light.parameters])
    assert sorted(set(zeniths)) == pytest.approx([0.25, 0.5, 0.75, 1.0, 1.25])
    assert sorted(set(hazes)) == pytest.approx([1.0, 1.5, 2.0, 2.5, 3.0])
    # Two runs of two pieces, the full circles and the arcs.
    assert hazes.size == 2 * 2 * 25
    assert (
        convergence.choose_nodes(light, ranges, rule="adaptive", harmonics=sphere.Harmonics.even(3), tolerance=1e-6)[0] == 0
    )


def test_symmetry_is_asked_for_in_512_seeded_directions_to_1e_12() -> None:
    ranges = {"sun_zenith": (0.25, 1.25), "haze": (1.0, 3.0)}
    light = Seen()
    assert convergence.is_mirrored(light, ranges)
    drawn = np.random.default_rng(1).normal(size=(512, 3))
    drawn[:, 2] = np.abs(drawn[:, 2])
    drawn /= np.linalg.norm(drawn, axis=1, keepdims=True)
    one, other = light.directions
    assert one == pytest.approx(drawn, abs=1e-15)
    assert other == pytest.approx(drawn * [1, -1, 1], abs=1e-15)
    values = np.random.default_rng(1).random((512, 2))
    assert light.parameters[0]["sun_zenith"] == pytest.approx(0.25 + values[:, 0])
    assert light.parameters[0]["haze"] == pytest.approx(1.0 + 2.0 * values[:, 1])
    assert convergence.is_mirrored(Seen(side=0.4e-12), ranges)
    assert not convergence.is_mirrored(Seen(side=0.6e-12), ranges)


def test_the_least_is_kept_with_its_direction() -> None:
    luminance = np.array([[3.0, 1.0, 2.0], [5.0, 6.0, 4.0]])
    directions = np.arange(9.0).reshape(3, 3)
    value, where = np.array([2.0, 4.0]), np.full((2, 3), -1.0)
    keep_least(luminance, directions, value, where)
    assert value.tolist() == [1.0, 4.0]
    assert where.tolist() == [[3.0, 4.0, 5.0], [-1.0, -1.0, -1.0]]


def test_the_search_for_the_least_walks_in_thirds_of_a_twentieth() -> None:
    """Eight neighbours, a step of 0.05 rad to begin with; each failure ends a step, until it would be below 5e-4."""
    light = Seen()
    start = np.array([[np.sin(1.0), 0.0, np.cos(1.0)]])
    assert least_luminance.refine(light, {"sun_zenith": np.zeros(1)}, start, np.array([0.5])).tolist() == [0.5]
    steps = [0.05 / 3**k for k in range(5)]
    assert len(light.directions) == len(steps)
    for step, tried in zip(steps, light.directions, strict=True):
        zenith = np.arccos(tried[0, :, 2])
        azimuth = np.arctan2(tried[0, :, 1], tried[0, :, 0])
        expected = [(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1) if i or j]
        assert (zenith - 1.0) / step == pytest.approx([i for i, _ in expected], abs=1e-9)
        assert azimuth * np.sin(1.0) / step == pytest.approx([j for _, j in expected], abs=1e-9)


def test_adaptive_starts_with_cells_of_thirty_by_45_degrees() -> None:
    """6 x 6 Gauss nodes in each of 3 x 4 cells, and of their quarters; there 5 x 5 as well."""
    for held, turns in ((sphere.Harmonics.even(1), 4), (sphere.Harmonics(1), 8)):
        light = Seen()
        adaptive.project(light, {"sun_zenith": np.zeros((1, 1))}, tolerance=1e-3, harmonics=held)
        found = np.concatenate([directions.reshape(-1, 3) for directions in light.directions])
        assert len(found) == 3 * turns * (5 * 36 + 4 * 25)
        zenith = np.unique(np.round(np.arccos(found[:, 2]), 9))
        for count, parts in ((6, 3), (6, 6), (5, 6)):
            x = (1 + np.polynomial.legendre.leggauss(count)[0]) / 2
            expected = HALF_PI * (np.arange(parts)[:, np.newaxis] + x).ravel() / parts
            assert np.abs(expected[:, np.newaxis] - zenith).min(axis=1).max() < 1e-8


@pytest.mark.parametrize("turn", [0, 8], ids=["mirrored", "all around"])
def test_neighbouring_cells_differ_by_one_halving_at_most(turn: int) -> None:
    """After any splits: cells that touch, corners and the turn's seam included, are as large, twice or half as large."""
    rng = np.random.default_rng(3)
    cells = adaptive._first_mesh(sides=2 if turn else 1)
    assert len(cells) == 3 * (turn or 4)
    for _ in range(7):
        wanted = np.zeros(len(cells), dtype=np.bool_)
        wanted[rng.choice(np.flatnonzero(cells[:, 0] == cells[:, 0].max()))] = True
        split = adaptive._balanced(cells, wanted, turn)
        assert split[wanted].all()
        cells = np.concatenate([cells[~split], adaptive._quarters(cells[split])])
    deep = int(cells[:, 0].max())
    assert deep == 7
    size = 1 << (deep - cells[:, 0])
    top, left = cells[:, 1] * size, cells[:, 2] * size
    owner = np.full((3 << deep, (turn or 4) << deep), -1)
    for number, (row, column, side) in enumerate(zip(top, left, size, strict=True)):
        assert np.all(owner[row : row + side, column : column + side] == -1)
        owner[row : row + side, column : column + side] = number
    assert owner.min() >= 0
    level = cells[owner, 0]
    steps = [
        np.diff(level, axis=0),
        np.diff(level, axis=1),
        level[1:, 1:] - level[:-1, :-1],
        level[1:, :-1] - level[:-1, 1:],
    ]
    if turn:
        steps.append(level[:, 0] - level[:, -1])
    assert max(int(np.abs(step).max()) for step in steps) == 1
    # No more than that asks for: far fewer than all.
    assert len(cells) < 400


def test_daylight_of_the_literature() -> None:
    """The Explanatory Supplement's logarithms at its joints, and IES RP-21's clear day at the zenith."""
    assert np.log10(clear_day.twilight(np.radians([0.0, 0.9, 4.5]))) == pytest.approx(
        [2.88, 2.88 - 0.2181 - 0.025811 + 0.00085836, 2.88 - 1.0905 - 0.645275 + 0.107295], abs=1e-9
    )
    assert np.log10(clear_day.twilight(np.radians([9.0, 11.7]))) == pytest.approx(
        [2.70 - 1.217 - 4.3169 + 1.89983, 2.70 - 1.5821 - 7.295561 + 4.17392651], abs=1e-9
    )
    sky, sun = clear_day.published(np.array([0.0, np.pi / 3]))
    assert sky == pytest.approx([16_300.0, 800.0 + 15_500.0 * np.sqrt(0.5)])
    assert sun[0] == pytest.approx(127_500.0 * np.exp(-0.21), rel=1e-3)
    assert sun[1] == pytest.approx(127_500.0 * np.exp(-0.21 * 1.995) / 2, rel=1e-3)
