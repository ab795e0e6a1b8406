"""What a scene folds in, against the scene itself integrated: sky, sun, ground, mirror, irradiance, window."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from conftest import scene_config
from numpy.typing import NDArray
from skylight_sh import sphere
from skylight_sh.light import sun_disc
from skylight_sh.run import from_config
from skylight_sh.scene import fold as folding
from skylight_sh.scene.fold import Scene, Sun, luminance_scale, window
from skylight_sh.scene.surroundings import build
from skylight_sh.store.dataset import Dataset, Variable

from golden.oracles import (
    REC709,
    WHITE,
    basis,
    degrees,
    gauss,
    hemisphere,
    lobe,
    orders,
    preetham_xyz,
    sinc,
    towards,
    xyz_to_rgb,
)

Array = NDArray[np.float64]
BANDS = 4
MATRIX = np.round(xyz_to_rgb(REC709, WHITE), 7)
ABOVE, SOLID = hemisphere(40)
BELOW, _ = hemisphere(40, lower=True)
SETS = [(0.6, 3.0), (1.45, 5.5), (math.pi / 2, 2.5)]
L, M = degrees(BANDS), orders(BANDS)


def sky(theta: float, tau: float) -> Array:
    """Linear RGB of the Preetham sky over the nodes above the horizon, ``(n, 3)``."""
    return preetham_xyz("published", ABOVE, theta, tau) @ MATRIX.T


def disc(theta: float) -> tuple[Array, Array]:
    """Directions and solid angles of the sun's disc, horizon or not."""
    z, w = gauss(math.cos(math.radians(0.2665)), 1.0, 60)
    phi = (np.arange(720) + 0.5) * math.pi / 360
    flat = np.sqrt(1 - z * z)[:, np.newaxis]
    local = np.stack(np.broadcast_arrays(flat * np.cos(phi), flat * np.sin(phi), z[:, np.newaxis]), axis=-1).reshape(-1, 3)
    frame = np.stack([towards(theta - math.pi / 2), towards(math.pi / 2, math.pi / 2), towards(theta)])
    return local @ frame, np.repeat(w * math.pi / 360, phi.size)


def project(values: Array, where: Array, solid: Array) -> Array:
    """Weights ``(channels, N*N)`` of values ``(n, channels)``."""
    return (values * solid[:, np.newaxis]).T @ basis(where, BANDS)


SUN = Sun("sun_zenith", "turbidity")
SCENE = Scene(("sun_zenith", "turbidity"))
ALBEDO = (0.1, 0.25, 0.6)


def fold(scene: Scene, weights: Array, sets: Array) -> Array:
    kept = M >= 0
    return folding.fold(scene, weights[..., kept], L[kept], sets)


@pytest.mark.parametrize(("theta", "tau"), SETS)
@pytest.mark.parametrize("shines", [False, True])
def test_ground_and_sun(theta: float, tau: float, shines: bool) -> None:
    """Albedo / pi times the irradiance of the horizontal, from below evenly; the sun whole, whatever the horizon cuts."""
    albedo, values = np.array(ALBEDO), sky(theta, tau)
    black = project(values, ABOVE, SOLID)
    fallen, whole = (values * (SOLID * ABOVE[:, 2])[:, np.newaxis]).sum(axis=0), black.copy()
    if shines:
        where, solid = disc(theta)
        colour = sun_disc.radiance(theta, tau)
        whole += np.multiply.outer(colour, solid @ basis(where, BANDS))
        fallen = fallen + colour * float(np.maximum(where[:, 2], 0) @ solid)
    ground = project(np.broadcast_to(albedo * fallen / math.pi, (len(BELOW), 3)), BELOW, SOLID)
    scene = replace(SCENE, sun=SUN if shines else None)
    for one, expected in (
        (scene, whole),
        (replace(scene, ground=ALBEDO), whole + ground),
        (replace(scene, ground="mirror"), whole * (1 + (-1.0) ** (L + M))),
        (replace(scene, quantity="irradiance"), whole * lobe(BANDS)[L]),
    ):
        got = fold(one, black, np.array([theta, tau]))
        assert np.abs(got - expected[:, M >= 0]).max() < 3e-6 * np.abs(expected).max()


@pytest.mark.parametrize("sunk", [0.0, 0.1, 0.2665, 1.0])
def test_a_sun_that_is_setting_lights_the_ground_by_what_is_up(sunk: float) -> None:
    """A black sky and a disc ``sunk`` degrees above the horizon: weights whole, irradiance that of the part above."""
    theta, tau = math.pi / 2 - math.radians(sunk), 2.5
    where, solid = disc(theta)
    colour = sun_disc.radiance(theta, tau)
    fallen = colour * float(np.maximum(where[:, 2], 0) @ solid)
    whole = np.multiply.outer(colour, solid @ basis(where, BANDS))
    ground = project(np.broadcast_to(np.array(ALBEDO) * fallen / math.pi, (len(BELOW), 3)), BELOW, SOLID)
    got = fold(replace(SCENE, sun=SUN, ground=ALBEDO), np.zeros((3, BANDS**2)), np.array([theta, tau]))
    alone = fold(replace(SCENE, sun=SUN), np.zeros((3, BANDS**2)), np.array([theta, tau]))
    assert alone == pytest.approx(whole[:, M >= 0], abs=1e-6 * np.abs(whole).max())
    assert np.abs(got - alone - ground[:, M >= 0]).max() < 2e-3 * np.abs(ground).max()


def test_the_mirror_is_an_image() -> None:
    values = sky(0.6, 3.0)
    black = project(values, ABOVE, SOLID)
    image = black + project(values, ABOVE * [1, 1, -1], SOLID)
    got = fold(replace(SCENE, ground="mirror"), black, np.array([0.6, 3.0]))
    assert got == pytest.approx(image[:, M >= 0], abs=1e-7 * image.max())


def test_a_sun_in_one_channel_is_its_luminance() -> None:
    theta, tau = 0.6, 3.0
    where, solid = disc(theta)
    luminance = float(sun_disc.radiance(theta, tau) @ np.linalg.inv(MATRIX)[1])
    scene = from_config.scene_of(scene_config('channels = "luminance"\nsun_disc = true'))
    got = fold(scene, np.zeros((1, BANDS**2)), np.array([theta, tau]))
    assert got[0] == pytest.approx((luminance * solid @ basis(where, BANDS))[M >= 0], rel=1e-5, abs=1e-7 * luminance)


def test_fixed_weather_takes_its_value() -> None:
    one = fold(replace(SCENE, sun=SUN), np.zeros((3, BANDS**2)), np.array([0.6, 3.4]))
    text = "sun_disc = true\nfixed = { turbidity = 3.4 }"
    scene = from_config.scene_of(scene_config(text, TEXT_WITHOUT_TURBIDITY))
    assert fold(scene, np.zeros((3, BANDS**2)), np.array([0.6])) == pytest.approx(one, rel=1e-12)


def test_what_hides_the_sky_takes_its_ground() -> None:
    """Below a skyline the ground reflects what the skyline leaves: it is no part of what is folded in."""
    text = "ground = [0.1, 0.25, 0.6]"
    scenes = [from_config.scene_of(scene_config(f"{text}\n{rest}")) for rest in ("", "horizon = [0.1, 0.2]")]
    assert [scene.ground for scene in scenes] == [ALBEDO, "black"]


def test_errors_of_irradiance_are_shares_of_pi() -> None:
    """E_mean divides by L_min; an even sky of it gives pi L_min on the horizontal, so irradiance is divided by that."""
    even = float((SOLID * ABOVE[:, 2]).sum())
    assert luminance_scale("irradiance") == pytest.approx(even, rel=1e-12)
    assert even == pytest.approx(math.pi, rel=1e-12)
    assert luminance_scale("radiance") == 1.0


@pytest.mark.parametrize("quantity", ["radiance", "irradiance"])
def test_what_errors_are_divided_by(quantity: str) -> None:
    """A grid of two suns and one random set, whose least luminances are 3, 4 and 5, mean ones 30, 40 and 50."""
    kept = M >= 0
    weights = np.random.default_rng(41).normal(size=(3, 3, int(kept.sum())))
    row = np.linalg.inv(MATRIX)[1]
    mean = np.array([30.0, 40.0, 50.0])
    # c_00 of an even hemisphere of luminance Y: Y sqrt(pi).
    weights[:, :, 0] = (mean * math.sqrt(math.pi))[:, np.newaxis]

    def dataset(part: slice, grid: bool) -> Dataset:
        shape = (2, 1) if grid else (1,)
        axes = {"sun_zenith": np.array([0.2, 0.9]), "turbidity": np.array([3.0])} if grid else {}
        axes = axes or {"set": np.arange(1), "sun_zenith": np.array([1.2]), "turbidity": np.array([4.0])}
        found = {name: Variable((name,), v) for name, v in axes.items()}
        dims = ("sun_zenith", "turbidity") if grid else ("set",)
        found["weights"] = Variable((*dims, "channel", "weight"), weights[part].reshape(*shape, 3, -1))
        found["least_luminance"] = Variable(dims, np.array([3.0, 4.0, 5.0])[part].reshape(shape))
        found["degree"] = Variable(("weight",), L[kept])
        return Dataset(found, {"mirrored": True})

    config = scene_config(f'quantity = "{quantity}"')
    inputs = {"truth/verification": dataset(slice(0, 2), True), "truth/random": dataset(slice(2, 3), False)}
    reference = from_config.reference_of(config, inputs, ("truth/verification", "truth/random"))
    scale, kernel = (math.pi, lobe(BANDS)) if quantity == "irradiance" else (1.0, np.ones(BANDS))
    assert reference.least == pytest.approx(scale * np.array([3.0, 4.0, 5.0]), rel=1e-14)
    assert reference.mean == pytest.approx(scale * mean * row.sum(), rel=1e-9)
    assert reference.weights == pytest.approx(weights * kernel[L[kept]], abs=1e-12)
    assert reference.parameters.tolist() == [[0.2, 3.0], [0.9, 3.0], [1.2, 4.0]]


def test_the_window_is_eq_5() -> None:
    factors = window(from_config.scene_of(scene_config("window = true")), sphere.Harmonics(BANDS))
    assert factors == pytest.approx(np.where(M == 0, sinc(math.pi * L / BANDS), 1.0), rel=1e-13)
    assert window(SCENE, sphere.Harmonics(BANDS)).tolist() == [1.0] * BANDS**2


def test_ground_below_a_skyline() -> None:
    """A sky of four bands seen above a level skyline; the ground below the horizon reflects what then falls."""
    rng, albedo, elevation = np.random.default_rng(42), np.array([0.2, 0.9, 0.5]), 0.3
    weights = rng.normal(size=(3, BANDS**2))
    z, w = gauss(math.sin(elevation), 1.0, 24)
    phi = (np.arange(40) + 0.5) * math.pi / 20
    flat = np.sqrt(1 - z * z)[:, np.newaxis]
    where = np.stack(np.broadcast_arrays(flat * np.cos(phi), flat * np.sin(phi), z[:, np.newaxis]), axis=-1).reshape(-1, 3)
    solid = np.repeat(w * math.pi / 20, phi.size)
    seen = basis(where, BANDS) @ weights.T
    fallen = (seen * (solid * where[:, 2])[:, np.newaxis]).sum(axis=0)
    z, w = gauss(-1.0, math.sin(elevation), 24)
    flat = np.sqrt(1 - z * z)[:, np.newaxis]
    low = np.stack(np.broadcast_arrays(flat * np.cos(phi), flat * np.sin(phi), z[:, np.newaxis]), axis=-1).reshape(-1, 3)
    under = np.repeat(w * math.pi / 20, phi.size) @ basis(low, BANDS)
    expected = project(seen, where, solid) + np.multiply.outer(albedo * fallen / math.pi, under)
    got = build(BANDS, skyline=(elevation,), albedo=albedo.tolist()).apply(weights, BANDS)
    assert got == pytest.approx(expected, abs=1e-10)


TEXT_WITHOUT_TURBIDITY = """
name = "fixed"
light = { model = "preetham" }
axes = [{ name = "sun_zenith", range = [0.0, 1.5], nodes = 8, verification = 20, degrees = [3, 4] }]
truth = { bands = 4 }
winners = [{ bands = 4, budgets = [0.1] }]
export = { recommended = "4-bands-10pct" }
"""
