"""Reflectance models against their closed forms, their tables in SH against quadrature, and files of measurements."""

from __future__ import annotations

import struct
from collections.abc import Callable
from pathlib import Path

import mpmath as mp
import numpy as np
import pytest
from numpy.typing import NDArray
from skylight_sh import UserError, sphere
from skylight_sh.light.preetham import Preetham
from skylight_sh.quadrature import sun_centred
from skylight_sh.quadrature.samples import NotConvergedError
from skylight_sh.reflectance import MODELS, brute_force, files, tables, tabulated
from skylight_sh.reflectance._as_light import Reflection
from skylight_sh.reflectance.measured import Measured, half_and_difference, reciprocity, zeniths_and_azimuth
from skylight_sh.reflectance.models.ggx import Ggx
from skylight_sh.reflectance.models.lambert import Lambert
from skylight_sh.reflectance.models.oren_nayar import OrenNayar
from skylight_sh.reflectance.models.protocol import Model

Array = NDArray[np.float64]

WHITE = (1.0,)
ALL = [
    Lambert((0.3, 0.6)),
    OrenNayar((0.9,), 0.5),
    Ggx(0.3, WHITE),
    Ggx(0.08, (0.04, 0.5, 1.0), (0.2, 0.1, 0.0)),
    Ggx(0.4, WHITE, alpha_y=0.15),
]


def hemisphere(n: int) -> tuple[Array, Array]:
    """Gauss in the cosine, denser towards zenith and horizon, even in azimuth: ``(2nn, 3)`` and solid angles."""
    t, w = sphere.gauss_unit(n)
    z, area = t**2 * (3 - 2 * t), 6 * t * (1 - t) * w
    phi = (np.arange(2 * n) + 0.5) * np.pi / n
    flat = np.sqrt((1 - z) * (1 + z))[:, np.newaxis]
    where = np.stack(np.broadcast_arrays(flat * np.cos(phi), flat * np.sin(phi), z[:, np.newaxis]), axis=-1)
    return where.reshape(-1, 3), np.repeat(area * np.pi / n, 2 * n)


def towards(zenith: float, azimuth: float = 0.0) -> Array:
    return np.array([np.sin(zenith) * np.cos(azimuth), np.sin(zenith) * np.sin(azimuth), np.cos(zenith)])


def test_the_registry_has_each_model_by_its_name() -> None:
    assert list(MODELS) == ["lambert", "oren-nayar", "ggx"]
    assert [MODELS[name]().channels for name in MODELS] == [3, 3, 3]
    assert all(10 < len(MODELS.about(name)) < 125 for name in MODELS)


@pytest.mark.parametrize("model", ALL, ids=lambda model: model.title)
def test_models_are_reciprocal_not_negative_and_as_symmetric_as_they_say(model: Model) -> None:
    rng = np.random.default_rng(3)
    one, other = (d * np.sign(d[..., 2:]) for d in sphere.spiral(400).reshape(2, 200, 3))
    other = other[rng.permutation(200)]
    values = model.values(one, other)
    assert values.shape == (200, model.channels)
    assert np.all(values >= 0)
    assert np.abs(model.values(other, one) - values).max() <= 1e-13 * values.max()
    assert reciprocity(model) < 1e-14
    mirror = np.array([1.0, -1.0, 1.0])
    assert np.abs(model.values(one * mirror, other * mirror) - values).max() <= 1e-13 * values.max()
    c, s = 0.6, 0.8
    turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    turned = np.abs(model.values(one @ turn.T, other @ turn.T) - values).max() <= 1e-12 * values.max()
    assert turned == model.isotropic


@pytest.mark.parametrize("slopes", [(1.0, 1.0), (0.3, 0.3), (0.5, 0.2)])
def test_facets_cover_the_surface_once(slopes: tuple[float, float]) -> None:
    """The integral of D times the cosine is 1, and D's formula is that of Walter and others in angles."""
    model = Ggx(slopes[0], WHITE, alpha_y=slopes[1])
    where, areas = hemisphere(160)
    assert areas @ (model.facets(where) * where[:, 2]) == pytest.approx(1.0, abs=1e-9)
    if model.isotropic:
        theta, a = 0.7, slopes[0]
        exact = a**2 / (np.pi * np.cos(theta) ** 4 * (a**2 + np.tan(theta) ** 2) ** 2)
        assert model.facets(towards(theta, 1.1)) == pytest.approx(exact, rel=1e-13)


def test_ggx_is_the_textbooks_product() -> None:
    """D F G / (4 cos cos) with G by Smith's Lambda, from angles."""
    model = Ggx(0.35, (0.2,))
    for a, b, phi in ((0.3, 0.9, 2.0), (1.2, 0.1, 0.4), (1.5, 1.4, 3.1)):
        one, other = towards(a), towards(b, phi)
        half = (one + other) / np.linalg.norm(one + other)
        hidden = [(np.sqrt(1 + 0.35**2 * np.tan(t) ** 2) - 1) / 2 for t in (a, b)]
        fresnel = 0.2 + 0.8 * (1 - one @ half) ** 5
        exact = model.facets(half) * fresnel / (1 + sum(hidden)) / (4 * np.cos(a) * np.cos(b))
        assert model.values(one, other)[0] == pytest.approx(exact, rel=1e-12)


def test_the_white_furnace() -> None:
    """A white mirror's facets lose what they would reflect twice, and never make light; a smooth one loses nothing."""
    lost = {}
    for alpha in (0.05, 0.2, 0.5, 1.0):
        share = tabulated.tabulate(Ggx(alpha, WHITE), 1, zeniths=31).albedo[:, 0, 0]
        assert share.max() <= 1 + 1e-6
        lost[alpha] = 1 - share.min()
    assert lost[0.05] < lost[0.2] < lost[0.5] < lost[1.0] < 0.7


def test_the_roughest_facets_reflect_what_mathematics_says() -> None:
    """Alpha 1 towards the normal: 1/2 times the integral of (1 + cos)**-1 times the cosine and its Jacobian."""
    found = tabulated.tabulate(Ggx(1.0, WHITE), 1, zeniths=2).albedo[0, 0, 0]
    # D is 1/pi, G / (4 cos cos) 1 / (2 (1 + cos)): the integral of cos / (1 + cos) over the cosine is 1 - log 2.
    assert found == pytest.approx(1 - np.log(2), abs=1e-9)


@pytest.mark.parametrize("sigma", [0.0, 0.3, 1.2])
def test_oren_and_nayar_towards_the_normal(sigma: float) -> None:
    """Seen from above it is Lambert's times A."""
    square = sigma**2
    up = np.array([0.0, 0.0, 1.0])
    found = OrenNayar((0.8,), sigma).values(towards(1.1, 0.3), up)[0]
    assert found == pytest.approx(0.8 / np.pi * (1 - square / (2 * square + 0.66)), rel=1e-14)
    # And at equal angles on one side, A + B sin(a) tan(a).
    at = towards(0.8, 0.3)
    b = 0.45 * square / (square + 0.09)
    exact = 0.8 / np.pi * (1 - square / (2 * square + 0.66) + b * np.sin(0.8) * np.tan(0.8))
    assert OrenNayar((0.8,), sigma).values(at, at)[0] == pytest.approx(exact, rel=1e-13)


def test_lamberts_table_is_a_clamped_cosine() -> None:
    table = tabulated.tabulate(Lambert((0.25, 1.0)), 8, zeniths=5)
    zonal = sphere.clamped_cosine(8) * np.sqrt((2 * np.arange(8) + 1) / (4 * np.pi)) / np.pi
    exact = sphere.aim(zonal, np.array([0.0, 0.0, 1.0]))
    assert np.abs(table.weights - exact * np.array([0.25, 1.0])[:, np.newaxis]).max() < 1e-9
    assert np.abs(table.albedo - np.array([0.25, 1.0])).max() < 1e-9
    assert (table.bands, table.weights.shape) == (8, (5, 1, 2, 64))


@pytest.mark.parametrize(
    "model", [Ggx(0.3, (0.1, 1.0)), Ggx(0.5, WHITE, (0.3,), 0.2), OrenNayar(WHITE, 0.6)], ids=lambda m: m.title
)
def test_a_views_weights_by_another_rule(model: Model) -> None:
    """Rings about the normal instead of the mirror direction.

    Of a view along the surface f jumps in the mirror direction: they miss that by a cell, with twice the nodes a quarter.
    """
    table = tabulated.tabulate(model, 6, zeniths=7, azimuths=5)

    def off(i: int, k: int, nodes: int) -> float:
        where, areas = hemisphere(nodes)
        turn = 2 * np.pi * k / 5
        # In the surface's own frame, and then turned so that the mirror direction has azimuth 0.
        values = model.values(where, towards(np.pi / 2 * i / 6, turn + np.pi)) * (areas * where[:, 2])[:, np.newaxis]
        exact = sphere.rotate_azimuth(values.T @ sphere.basis(where, 6), np.array(-turn))
        return float(np.abs(table.weights[i, k] - exact).max() / np.abs(exact).max())

    for i, k in ((0, 0), (4, 0), (5, 0), (4, 3)):
        if k < table.weights.shape[1]:
            assert off(i, k, 160) < 1e-4, (i, k)
    coarse, fine = off(6, 0, 80), off(6, 0, 160)
    assert fine < 4e-3
    assert fine < max(1e-4, coarse / 3)


def test_an_even_light_is_reflected_by_the_albedo_from_anywhere() -> None:
    table = tabulated.tabulate(Ggx(0.4, (0.5,), (0.3,)), 4, zeniths=91)
    even = np.zeros((1, 16))
    even[0, 0] = 2 * np.sqrt(4 * np.pi)
    normals = sphere.spiral(40)
    views = sphere.spiral(41)[1:]
    views = views * np.sign(np.sum(views * normals, axis=-1, keepdims=True))
    found = tabulated.shade(table, even, normals, views)[:, 0]
    angle = np.arccos(np.sum(views * normals, axis=-1))
    assert np.abs(found - 2 * np.interp(angle, np.linspace(0, np.pi / 2, 91), table.albedo[:, 0, 0])).max() < 1e-9


def test_turning_everything_changes_nothing() -> None:
    """Light, normal, view and tangent turned alike; with a tangent, turning it alone does change."""
    rng = np.random.default_rng(11)
    table = tabulated.tabulate(Ggx(0.5, (0.2, 0.9), alpha_y=0.2), 5, zeniths=13, azimuths=12)
    light = rng.normal(size=(2, 25))
    normals = sphere.spiral(9)
    tangents = np.cross(normals, [0.36, 0.48, 0.8])
    tangents /= np.linalg.norm(tangents, axis=-1, keepdims=True)
    views = normals + 0.7 * tangents + 0.4 * np.cross(normals, tangents)
    views /= np.linalg.norm(views, axis=-1, keepdims=True)
    q, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    q *= np.linalg.det(q)
    found = tabulated.shade(table, light, normals, views, tangents)
    again = tabulated.shade(table, sphere.rotate(light, q), normals @ q.T, views @ q.T, tangents @ q.T)
    assert np.abs(found - again).max() < 1e-11
    assert np.abs(found - tabulated.shade(table, light, normals, views, np.cross(normals, tangents))).max() > 1e-3


def test_views_along_the_normal_and_below_the_surface() -> None:
    table = tabulated.tabulate(Ggx(0.3, WHITE), 4, zeniths=31)
    light = np.random.default_rng(2).normal(size=(1, 16))
    corners = np.array([[i, j, k] for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1) if i or j or k])
    for normal in (*sphere.spiral(5), *(corners / np.linalg.norm(corners, axis=-1, keepdims=True))):
        side = np.cross(normal, [0.6, 0.0, 0.8])
        near = normal + 1e-7 * side
        frames, _ = tabulated.view_frames(normal, normal)
        assert np.abs(frames @ frames.T - np.eye(3)).max() < 1e-14
        assert np.linalg.det(frames) == pytest.approx(1.0)
        straight = tabulated.shade(table, light, normal, normal)
        assert np.abs(straight - tabulated.shade(table, light, normal, near / np.linalg.norm(near))).max() < 1e-5
    along = tabulated.shade(table, light, np.array([0.0, 0.0, 1.0]), np.array([-1.0, 0.0, 0.0]))
    below = tabulated.shade(table, light, np.array([0.0, 0.0, 1.0]), np.array([-0.8, 0.0, -0.6]))
    assert np.abs(along - below).max() < 1e-12


def test_each_point_may_have_its_own_light_and_fewer_bands() -> None:
    table = tabulated.tabulate(Ggx(0.3, WHITE), 6, zeniths=31)
    rng = np.random.default_rng(4)
    lights, normals = rng.normal(size=(7, 3, 16)), sphere.spiral(7)
    views = sphere.spiral(8)[1:]
    found = tabulated.shade(table, lights, normals, views)
    for k in range(7):
        padded = np.concatenate([lights[k], np.zeros((3, 20))], axis=-1)
        assert np.abs(found[k] - tabulated.shade(table, padded, normals[k], views[k])).max() < 1e-12


@pytest.mark.parametrize(
    ("call", "told"),
    [
        (lambda: Ggx(0.0), "alpha 0.0"),
        (lambda: Ggx(0.3, alpha_y=2.0), "alpha_y 2.0"),
        (lambda: Ggx(0.3, (0.1, float("nan"))), "specular"),
        (lambda: Ggx(0.3, (0.1,), (0.1, 0.2)), "Should have 1 numbers"),
        (lambda: Lambert(()), "albedo"),
        (lambda: OrenNayar(sigma=3.0), "sigma 3.0"),
        (lambda: tabulated.tabulate(Lambert(), 2, zeniths=1), "1 zeniths"),
        (lambda: tabulated.Table("x", np.zeros((2, 1, 4)), 0.0), r"shape \(2, 1, 4\)"),
        (
            lambda: tabulated.shade(
                tabulated.Table("brushed", np.zeros((2, 4, 1, 4)), 0.0), np.zeros((1, 4)), np.eye(3)[2], np.eye(3)[2]
            ),
            "Give tangents",
        ),
    ],
)
def test_what_makes_no_sense_is_told(call: Callable[[], object], told: str) -> None:
    with pytest.raises(ValueError, match=told):
        call()


def test_a_lobe_too_narrow_for_the_rule_is_told() -> None:
    with pytest.raises(NotConvergedError, match="Raise the tolerance"):
        tabulated.tabulate(Ggx(0.001, WHITE), 1, zeniths=2)


def sky(zenith: float, bands: int, albedo: float) -> tuple[Array, brute_force.Environment]:
    """The exact sky's weights above a ground, and the same without any expansion."""
    light, at = Preetham(), {"sun_zenith": np.radians(zenith), "turbidity": 3.0}
    spread = {name: np.array([[value]]) for name, value in at.items()}
    weights = sun_centred.project(light, spread, nodes=64, harmonics=sphere.Harmonics(bands)).weights[0, 0]
    return sphere.add_ground(weights, albedo, bands), brute_force.environment(light, at, albedo, nodes=48)


def test_brute_force_itself() -> None:
    """Lambert's surface by it is the irradiance of many bands over pi, and its nodes are the light's own weights."""
    weights, seen = sky(60.0, 24, 0.25)
    assert np.abs(seen.powers.T @ sphere.basis(seen.directions, 24) - weights).max() < 1e-5 * weights.max()
    normals = sphere.spiral(12)
    views = sphere.spiral(13)[1:]
    views = views * np.sign(np.sum(views * normals, axis=-1, keepdims=True))
    exact = sphere.evaluate(sphere.irradiance(weights), normals).T / np.pi
    found = brute_force.reflected(Lambert((1.0, 1.0, 1.0)), seen.radiance, normals, views, nodes=64)
    assert brute_force.relative_rms(found, exact) < 2e-3
    # As a lobe of exponent 1 about the normal.
    assert brute_force.relative_rms(brute_force.cosine_lobe(seen, 1.0, normals), exact) < 1e-4


def stored(path: Path, shape: tuple[int, int, int], model: Model) -> Array:
    """Write a file as the MERL database has them, cell by cell from directions made of its angles."""
    half, difference, azimuth = ((np.arange(n) + 0.5) / n for n in shape)
    h, d, p = np.meshgrid(np.pi / 2 * half**2, np.pi / 2 * difference, np.pi * azimuth, indexing="ij")
    x, y, z = np.sin(d) * np.cos(p), np.sin(d) * np.sin(p), np.cos(d)
    axes = np.stack([np.cos(h), np.zeros_like(h), -np.sin(h)], -1), np.array([0.0, 1.0, 0.0])
    up = np.stack([np.sin(h), np.zeros_like(h), np.cos(h)], -1)
    one = x[..., np.newaxis] * axes[0] + y[..., np.newaxis] * axes[1] + z[..., np.newaxis] * up
    other = 2 * z[..., np.newaxis] * up - one
    seen = (one[..., 2] > 0) & (other[..., 2] > 0)
    values = np.where(seen[..., np.newaxis], model.values(one, other), -1.0)
    raw = values / (np.array([1.0, 1.15, 1.66]) / 1500)
    path.write_bytes(struct.pack("<3i", *shape) + raw.transpose(3, 0, 1, 2).astype("<f8").tobytes())
    return np.asarray(raw)


def test_a_merl_file_gives_back_what_was_measured(tmp_path: Path) -> None:
    truth = Ggx(0.4, (0.1, 0.4, 0.9), (0.2, 0.1, 0.05))
    stored(tmp_path / "paint.binary", (45, 45, 60), truth)
    model, findings = tables.read_merl(tmp_path / "paint.binary")
    assert findings == ()
    assert (model.title, model.channels, model.isotropic, model.mirrored) == ("paint", 3, True, False)
    rng = np.random.default_rng(8)
    one, other = (
        np.stack([towards(z, p) for z, p in zip(rng.uniform(0, 1.2, 300), rng.uniform(0, 6.28, 300), strict=True)])
        for _ in range(2)
    )
    exact, found = truth.values(one, other), model.values(one, other)
    assert np.abs(found - exact).max() < 0.03 * exact.max()
    assert brute_force.relative_rms(found, exact) < 0.01
    assert reciprocity(model) < 1e-12


@pytest.mark.parametrize(
    ("spoil", "told"),
    [
        (lambda data: data[:8], r"first numbers are \(0, 0, 0\)"),
        (lambda data: data[:-8], "ask for"),
        (lambda data: data + b"x", "ask for"),
        (lambda data: struct.pack("<3i", -6, 6, 8) + data[12:], "first numbers"),
        (lambda data: struct.pack("<3i", 2**30, 6, 8) + data[12:], "first numbers"),
        (lambda data: data[:12] + struct.pack("<d", float("nan")) + data[20:], "1 of its values are NaN"),
        (lambda data: data[:12] + struct.pack("<d", float("inf")) + data[20:], "1 of its values are NaN"),
    ],
)
def test_a_bad_merl_file_is_refused(spoil: Callable[[bytes], bytes], told: str, tmp_path: Path) -> None:
    path = tmp_path / "bad.binary"
    stored(path, (6, 6, 8), Lambert())
    path.write_bytes(spoil(path.read_bytes()))
    with pytest.raises(tables.ReflectanceError, match=told):
        tables.read_merl(path)
    with pytest.raises(tables.ReflectanceError, match="cannot be read"):
        tables.read_merl(tmp_path / "none.binary")


def test_gaps_of_a_merl_file_are_told(tmp_path: Path) -> None:
    path = tmp_path / "gap.binary"
    stored(path, (6, 6, 8), Lambert())
    data = path.read_bytes()
    path.write_bytes(data[:12] + struct.pack("<d", -0.5) + data[20:])
    model, findings = tables.read_merl(path)
    assert "1 of " in findings[0]
    assert model.samples[0, 0, 0].tolist()[0] == 0.0
    # Below the surface nothing is measured, and nothing said of it.
    assert np.count_nonzero(model.samples == 0.0) > 3


def grid_of(model: Model, phi: Array) -> dict[str, Array]:
    incident, view = np.linspace(0, np.pi / 2, 19), np.linspace(0, np.pi / 2, 19)
    one = np.stack([towards(a) for a in incident])[:, np.newaxis, np.newaxis]
    other = np.stack([[towards(b, p) for p in phi] for b in view])
    return {"theta_incident": incident, "theta_view": view, "phi": phi, "values": model.values(one, other)}


@pytest.mark.parametrize("mirrored", [True, False])
def test_a_grid_gives_back_what_was_sampled(mirrored: bool, tmp_path: Path) -> None:
    truth = Ggx(0.7, (0.3, 0.9))
    phi = np.linspace(0, np.pi, 25) if mirrored else np.arange(48) * np.pi / 24
    np.savez(tmp_path / "cloth.npz", **grid_of(truth, phi))
    model, findings = tables.read_grid(tmp_path / "cloth.npz")
    assert findings == ()
    assert (model.mirrored, model.channels, model.title) == (mirrored, 2, "cloth")
    rng = np.random.default_rng(8)
    one, other = (
        np.stack([towards(z, p) for z, p in zip(rng.uniform(0, 1.3, 300), rng.uniform(0, 6.28, 300), strict=True)])
        for _ in range(2)
    )
    assert brute_force.relative_rms(model.values(one, other), truth.values(one, other)) < 0.02
    table = tabulated.tabulate(model, 4, zeniths=10, tolerance=3e-3)
    exact = tabulated.tabulate(truth, 4, zeniths=10)
    assert np.abs(table.weights - exact.weights)[:-1].max() < 0.02 * exact.weights.max()


@pytest.mark.parametrize(
    ("spoil", "told"),
    [
        ({"phi": None}, "no array 'phi'"),
        ({"values": np.zeros((2, 2))}, r"values of shape \(2, 2\)"),
        ({"theta_view": np.linspace(1, 0, 19)}, "theta_view of shape"),
        ({"theta_view": np.linspace(0, 90, 19)}, "theta_view goes from 0 to 90"),
        ({"theta_incident": np.linspace(0, 1.6, 19)}, r"theta_incident goes from 0 to 1\.6"),
        ({"theta_incident": np.linspace(-0.1, 1.5, 19)}, r"theta_incident goes from -0\.1 to 1\.5"),
        ({"phi": np.linspace(0, 6.4, 5)}, r"phi goes from 0 to 6\.4"),
        ({"values": -1.0}, "go down to -1"),
        ({"values": np.nan}, "1 of its values are NaN"),
    ],
)
def test_a_bad_grid_is_refused(spoil: dict[str, object], told: str, tmp_path: Path) -> None:
    good = grid_of(Lambert(), np.linspace(0, np.pi, 5))
    for name, value in spoil.items():
        if value is None:
            del good[name]
        elif isinstance(value, float):
            good[name][0, 0, 0, 0] = value
        else:
            good[name] = np.asarray(value)
    np.savez(tmp_path / "bad.npz", **good)
    with pytest.raises(tables.ReflectanceError, match=told):
        tables.read_grid(tmp_path / "bad.npz")
    (tmp_path / "text.npz").write_text("no archive")
    with pytest.raises(tables.ReflectanceError, match="is no NPZ"):
        tables.read_grid(tmp_path / "text.npz")


def test_what_a_grid_breaks_is_told(tmp_path: Path) -> None:
    grid = grid_of(Lambert(WHITE), np.linspace(0, np.pi, 5))
    grid["values"] *= 1 + grid["theta_incident"][:, np.newaxis, np.newaxis, np.newaxis]
    grid["theta_view"] *= 0.8
    np.savez(tmp_path / "odd.npz", **grid)
    _, findings = tables.read_grid(tmp_path / "odd.npz")
    assert "theta_view ends at 72 degrees" in findings[0]
    assert "not reciprocal" in findings[1]
    assert len(findings) == 2


def test_angles_of_pairs_of_directions() -> None:
    one, other = towards(0.5, 0.2), towards(0.5, 0.2 + np.pi)
    assert half_and_difference(one, other)[:2].tolist() == pytest.approx([0.0, 0.5], abs=1e-12)
    # Both the same: the half vector is that direction, and there is no difference.
    assert half_and_difference(one, one)[:2].tolist() == pytest.approx([0.5, 0.0], abs=1e-7)
    rng = np.random.default_rng(6)
    pairs = np.abs(rng.normal(size=(2, 50, 3)))
    pairs /= np.linalg.norm(pairs, axis=-1, keepdims=True)
    angles = half_and_difference(pairs[0], pairs[1])
    assert np.abs(2 * angles[:, 1] - np.arccos(np.sum(pairs[0] * pairs[1], axis=-1))).max() < 1e-7
    assert np.abs(np.exp(2j * angles) - np.exp(2j * half_and_difference(pairs[1], pairs[0])))[:, 2].max() < 1e-9
    assert zeniths_and_azimuth(one, other).tolist() == pytest.approx([0.5, 0.5, np.pi])


def test_samples_at_the_ends_are_joined_or_mirrored() -> None:
    nodes = (np.array([0.0, 1.0]), np.array([0.0, 1.0]), np.array([0.0, np.pi / 2, np.pi, 3 * np.pi / 2]))
    samples = np.broadcast_to(np.arange(4.0)[:, np.newaxis], (2, 2, 4, 1))
    joined = Measured("steps", nodes, samples, zeniths_and_azimuth, 2 * np.pi)
    assert joined.values(towards(0.5), towards(0.5, 7 * np.pi / 4))[0] == pytest.approx(1.5)
    mirrored = Measured("half", (*nodes[:2], np.array([0.0, np.pi])), samples[:, :, :2], zeniths_and_azimuth, 0.0)
    assert mirrored.values(towards(0.5), towards(0.5, -np.pi / 2))[0] == pytest.approx(0.5)
    assert mirrored.values(towards(0.5), towards(1.5, np.pi / 4))[0] == pytest.approx(0.25)


def test_mpmath_agrees_on_the_furnace_at_an_angle() -> None:
    """Alpha 0.5 seen 60 degrees off: an independent integral over the facets, at fifteen digits."""
    alpha, zenith = 0.5, np.pi / 3
    model = Ggx(alpha, WHITE)
    view = towards(zenith)

    def ring(cosine: float) -> float:
        t = mp.acos(cosine)
        return float(
            mp.quad(lambda p: float(model.values(towards(float(t), float(p)), view)[0]), [0, mp.pi / 4, mp.pi], maxdegree=4)
        )

    x, w = sphere.gauss_unit(40)
    exact = 2 * sum(wk * xk * ring(xk) for xk, wk in zip(x.tolist(), w.tolist(), strict=True))
    table = tabulated.tabulate(model, 1, zeniths=4)
    assert table.albedo[2, 0, 0] == pytest.approx(exact, rel=1e-5)


def test_narrow_lobes_converge_as_the_page_says() -> None:
    light = Reflection(Ggx(0.01, WHITE))
    views = {"view_zenith": np.radians([[0.0], [50.0], [85.0]])}
    coarse, fine = (
        sun_centred.project(light, views, nodes=n, harmonics=sphere.Harmonics.even(7)).weights for n in (240, 360)
    )
    assert np.abs(coarse - fine).max() < 1e-10 * np.abs(fine).max()


def test_a_file_gives_back_its_table(tmp_path: Path) -> None:
    table = tabulated.tabulate(Ggx(0.4, (0.2, 0.5), alpha_y=0.2), 4, zeniths=5, azimuths=3)
    data = files.write(table)
    assert data == files.write(table)
    (tmp_path / "steel.npz").write_bytes(data)
    again = files.read(tmp_path / "steel.npz")
    assert (again.title, again.estimate) == (table.title, table.estimate)
    assert np.abs(again.weights - table.weights).max() < 1e-6 * table.weights.max()


@pytest.mark.parametrize(
    ("edit", "told"),
    [
        ({"title": None}, "no array 'title'"),
        ({"format": np.array(3)}, "has format 3"),
        ({"weights": np.zeros((1, 1, 1, 4))}, "two zeniths"),
        ({"weights": np.full((2, 1, 1, 4), np.nan)}, "not finite"),
        ({"estimate": np.array("none")}, "is no reflectance table"),
    ],
)
def test_a_bad_table_file_is_refused(edit: dict[str, object], told: str, tmp_path: Path) -> None:
    good = {"format": np.array(1), "title": np.array("x"), "estimate": np.array(0.0), "weights": np.zeros((2, 1, 1, 4))}
    np.savez(tmp_path / "bad.npz", **{name: value for name, value in {**good, **edit}.items() if value is not None})
    with pytest.raises(UserError, match=told):
        files.read(tmp_path / "bad.npz")
    with pytest.raises(UserError, match="is no reflectance table"):
        files.read(tmp_path / "none.npz")


@pytest.mark.parametrize("kind", ["isotropic", "brushed", "measured"])
def test_shading_is_brute_force_under_a_light_of_as_few_bands(kind: str, tmp_path: Path) -> None:
    """Nothing is cut off then: what is left is the interpolation between views, and azimuths 10 degrees apart."""
    models: dict[str, Model] = {"isotropic": Ggx(0.4, (0.3, 0.9), (0.1, 0.0)), "brushed": Ggx(0.6, (0.3, 0.9), alpha_y=0.3)}
    if kind == "measured":
        stored(tmp_path / "paint.binary", (30, 30, 40), Ggx(0.5, (0.1, 0.4, 0.9), (0.2, 0.1, 0.05)))
        models[kind], _ = tables.read_merl(tmp_path / "paint.binary")
    model = models[kind]
    # Not smoother from one side than from another, and brighter than it is uneven.
    light = np.random.default_rng(4).normal(size=(1, 25)) + 6.0 * np.eye(25)[0]
    table = tabulated.tabulate(model, 5, zeniths=16 if kind == "measured" else 31, tolerance=5e-3)
    normals = sphere.spiral(12)
    tangents = np.cross(normals, [0.36, 0.48, 0.8])
    tangents /= np.linalg.norm(tangents, axis=-1, keepdims=True)
    turn, zenith = 2.4 * np.arange(12)[:, np.newaxis], np.linspace(0.05, 1.35, 12)[:, np.newaxis]
    side = np.cos(turn) * tangents + np.sin(turn) * np.cross(normals, tangents)
    views = np.cos(zenith) * normals + np.sin(zenith) * side
    exact = brute_force.reflected(
        model, lambda directions: sphere.evaluate(light, directions).T, normals, views, tangents, nodes=96
    )
    found = tabulated.shade(table, light, normals, views, tangents)
    assert found.shape == (12, model.channels)
    off = brute_force.relative_rms(found, exact)
    assert off < {"isotropic": 1e-3, "brushed": 3e-3, "measured": 5e-3}[kind]
    if kind == "brushed":
        # The other sense of the azimuth, or none, is another surface.
        assert (
            brute_force.relative_rms(tabulated.shade(table, light, normals, views, np.cross(normals, tangents)), exact)
            > 0.02
        )
