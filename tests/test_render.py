"""Pictures against closed forms: a closed room, a bowl, a ball in an even sky, the sun's penumbra, lamps; and each other."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy import sparse
from skylight_sh import sphere
from skylight_sh.light import sun_disc
from skylight_sh.light.cie_traditional import CieTraditional
from skylight_sh.light.preetham import Preetham
from skylight_sh.mesh import Mesh, Part
from skylight_sh.mesh.shapes import assembled, box, lathe
from skylight_sh.render import emitters, relief, shading, sky
from skylight_sh.render.brute_force import Paths, arriving
from skylight_sh.render.camera import Camera
from skylight_sh.render.picture import Picture, Sampling, take
from skylight_sh.render.sunlight import even, straight
from skylight_sh.render.surface import Points, Surface
from skylight_sh.scene import lamps
from skylight_sh.transfer import Options, precompute, unshadowed

Array = NDArray[np.float64]
UP = np.array([0.0, 0.0, 1.0])


def ones(along: Array) -> Array:
    return np.ones(along.shape)


def nothing(along: Array) -> Array:
    return np.zeros(along.shape)


def room(albedo: float) -> Mesh:
    """A cube of side 2 seen from inside."""
    made = assembled([(Part("room"), (albedo,) * 3, box((-1.0, -1.0, -1.0), (1.0, 1.0, 1.0), 0.5))])
    return Mesh(made.positions, -made.normals, made.albedo, made.triangles[:, ::-1], made.part, made.parts, made.uv)


def floor(half: float, height: float = 0.0, albedo: float = 0.5) -> Mesh:
    corners = np.array([[-half, -half, height], [half, -half, height], [half, half, height], [-half, half, height]])
    colours, part = np.full((4, 3), albedo), np.zeros(2, dtype=np.int64)
    return Mesh(
        corners, np.tile(UP, (4, 1)), colours, np.array([[0, 1, 2], [0, 2, 3]]), part, (Part("all"),), np.zeros((4, 2))
    )


def both(one: Mesh, other: Mesh) -> Mesh:
    joined = (np.concatenate([getattr(one, name), getattr(other, name)]) for name in ("positions", "normals", "albedo"))
    triangles = np.concatenate([one.triangles, other.triangles + len(one.positions)])
    uv = np.concatenate([one.uv, other.uv])
    return Mesh(*joined, triangles, np.zeros(len(triangles), dtype=np.int64), one.parts[:1], uv)


def ball(albedo: float, rows: int = 48) -> Mesh:
    polar = np.linspace(np.pi, 0.0, rows + 1)
    made = lathe(np.stack([np.sin(polar).round(12), np.cos(polar)], axis=-1), 2 * rows)
    return assembled([(Part("ball"), (albedo,) * 3, made)])


def below(surface: Surface, places: Array) -> Points:
    along = np.tile(-UP, (len(places), 1))
    return surface.met(surface.rays.nearest(places, along), along)[0]


def test_in_a_closed_room_each_bounce_sends_on_the_albedo() -> None:
    """A furnace: an even glow of the walls comes back times the albedo at each bounce, and no path leaves."""
    surface = Surface(room(0.6))
    points = below(surface, np.array([[0.3, -0.2, 0.0], [-0.9, 0.9, 0.5]]))
    assert not arriving(surface, points, ones, [], Paths(256, 3), 0).any()

    class Glow:
        """What lights every surface that rays meet by pi lux from before it."""

        def towards(self, places: Array, unit: Array) -> emitters.Towards:
            inward = -places * (np.abs(places) == np.abs(places).max(axis=1, keepdims=True))
            along = np.repeat((inward / np.linalg.norm(inward, axis=1, keepdims=True))[:, np.newaxis], unit.shape[1], axis=1)
            return emitters.Towards(along, np.zeros(unit.shape[:2]), np.full((*unit.shape[:2], 3), np.pi))

        def seen(self, eye: Array, along: Array) -> tuple[Array, Array]:
            return np.full(len(along), np.nan), eye

    for bounces, expected in ((1, 0.6), (2, 0.6 + 0.36), (3, 0.6 + 0.36 + 0.216)):
        found = arriving(surface, points, nothing, [Glow()], Paths(256, bounces), 0)
        assert np.abs(found - expected).max() < 1e-6
    # The same through transfer.
    mesh = surface.mesh
    made = precompute(mesh, Options(bands=2, rays=64, gather_rays=64, bounces=3))
    sent = shading.sent_on(np.ones((len(mesh.positions), 3)), mesh.albedo, made.matrix, 3)
    assert np.abs(sent - (0.6 + 0.36 + 0.216)).max() < 1e-5


def test_a_white_ball_in_an_even_sky_is_as_bright() -> None:
    surface = Surface(ball(1.0))
    camera = Camera((0.0, -5.0, 0.0), (0.0, 0.0, 0.0), 30.0, 24, 24)
    made = take(camera, surface, lambda p, k: arriving(surface, p, ones, [], Paths(32, 1), k), ones, [], Sampling(4, 1))
    assert np.abs(made.radiance - 1.0).max() < 0.01
    assert 0.3 < made.share.mean() < 0.7


def test_bounces_in_a_bowl() -> None:
    """Light after b bounces is 1/2 (albedo / 2)^b everywhere below an even sky."""
    polar = np.linspace(np.pi, np.pi / 2, 41)
    made = assembled([(Part("bowl"), (0.8,) * 3, lathe(np.stack([np.sin(polar).round(12), np.cos(polar)], -1), 96))])
    bowl = Mesh(made.positions, -made.positions, made.albedo, made.triangles[:, ::-1], made.part, made.parts, made.uv)
    surface = Surface(bowl)
    points = below(surface, np.array([[0.1, 0.0, 0.0], [0.6, 0.3, 0.0], [-0.2, -0.8, 0.0]]))
    before = np.zeros((3, 3))
    for bounces in range(4):
        found = arriving(surface, points, ones, [], Paths(8192, bounces), 0)
        assert np.abs(found - before - 0.5 * 0.4**bounces).max() < 8e-3
        before = found


def test_the_sun_on_a_floor_and_its_penumbra() -> None:
    """Behind a screen's edge the share of the disc that shows is a circle's segment."""
    theta, height = 0.6, 3.0
    towards = np.array([np.sin(theta), 0.0, np.cos(theta)])
    sun = emitters.Disc(towards, 0.03, np.array([4.0, 2.0, 1.0]))
    surface = Surface(both(floor(50.0), floor(1.0, height)))
    # The screen's shadow ends at 1 - height tan(theta); across it the disc is cut at a line.
    x = 1.0 - height * np.tan(theta + np.array([-0.5, -0.028, -0.01, 0.0, 0.015, 0.04]))
    points = below(surface, np.stack([x, np.zeros(6), np.full(6, 1.0)], axis=-1))
    found = straight(surface, points, [sun], even(4096, np.full((6, 2), 0.3)))
    whole = np.cos(theta) * np.sin(0.03) ** 2 * sun.radiance
    assert found[0] == pytest.approx(whole, rel=1e-5)
    cut = np.clip(np.array([1.0, 0.028, 0.01, 0.0, -0.015, -0.04]) / 0.03, -1.0, 1.0)
    segment = 1.0 - (np.arccos(cut) - cut * np.sqrt(1.0 - cut * cut)) / np.pi
    assert np.abs(found / whole - segment[:, np.newaxis]).max() < 6e-3


def test_lamps_on_a_floor() -> None:
    """Closed forms: a ball (r / d)^2 cos, a point and a spot I cos / d^2, parallel light E cos, a far disc L sin^2 cos."""
    surface = Surface(floor(20.0))
    points = below(surface, np.array([[3.0, 0.0, 1.0]]))
    unit = even(2048, np.zeros((1, 2)))
    grey, high = (7.0, 7.0, 7.0), (0.0, 0.0, 4.0)
    asked = {
        lamps.Sphere(centre=high, radius=1.0, radiance=grey): 7.0 * (1.0 / 25.0) * 0.8,
        lamps.Point(centre=high, intensity=grey): 7.0 / 25.0 * 0.8 / np.pi,
        lamps.Spot(centre=high, axis=(3.0, 0.0, -4.0), inner=0.1, outer=0.2, intensity=grey): 7.0 / 25 * 0.8 / np.pi,
        lamps.Spot(centre=high, axis=(0.0, 0.0, -1.0), inner=0.1, outer=0.2, intensity=grey): 0.0,
        lamps.Directional(direction=(0.0, 3.0, 4.0), illuminance=grey): 7.0 * 0.8 / np.pi,
        lamps.Disc(direction=(0.0, 3.0, 4.0), half_angle=0.2, radiance=grey): 7.0 * np.sin(0.2) ** 2 * 0.8,
    }
    for lamp, expected in asked.items():
        made = emitters.of_lamp(lamp)
        assert made is not None
        assert straight(surface, points, [made], unit)[0] == pytest.approx(expected, rel=2e-3, abs=1e-12), lamp
    assert emitters.of_lamp(lamps.Probe(image="a.exr", layout="equirect")) is None


def test_what_stands_behind_a_lamp_does_not_shade() -> None:
    surface = Surface(both(floor(20.0), floor(20.0, 6.0)))
    points = below(surface, np.array([[0.0, 0.0, 1.0]]))
    lit = [
        straight(surface, points, [emitters.Ball(np.array([0.0, 0.0, height]), 0.5, np.ones(3))], even(64, np.zeros((1, 2))))
        for height in (4.0, 8.0)
    ]
    assert lit[0] == pytest.approx(1.0 / 64.0, rel=1e-2)
    assert not lit[1].any()


def test_a_lamp_shows_itself() -> None:
    surface = Surface(floor(1.0))
    lamp = emitters.Ball(np.array([0.0, 0.0, 1.0]), 0.5, np.array([9.0, 8.0, 7.0]))
    made = take(
        Camera((0.0, -6.0, 1.0), (0.0, 0.0, 1.0), 40.0, 33, 33),
        surface,
        lambda p, _: p.albedo * 0.0,
        nothing,
        [lamp],
        Sampling(9),
    )
    assert made.radiance[16, 16] == pytest.approx([9.0, 8.0, 7.0])
    # The ball's tangent cone over what the picture shows.
    radius = 0.5 / np.sqrt(36.0 - 0.25) / np.tan(np.radians(20.0)) / 2.0
    shown = (made.radiance[..., 0] / 9.0)[made.share == 0.0].sum() / 33**2
    assert shown == pytest.approx(np.pi * radius**2, rel=0.03)


def test_the_sky_turns_and_ends_where_it_should() -> None:
    light = CieTraditional(sky="clear")
    turned = sky.Sky(light, {"sun_zenith": 0.9}, azimuth=2.0)
    towards = np.array([[np.sin(0.9) * np.cos(2.0), np.sin(0.9) * np.sin(2.0), np.cos(0.9)]])
    own = np.array([[np.sin(0.9), 0.0, np.cos(0.9)]])
    assert turned.radiance(towards)[0, 0] == pytest.approx(light.radiance(own, {"sun_zenith": np.array([0.9])})[0, 0])
    overcast = sky.Sky(CieTraditional(sky="overcast"), {"sun_zenith": 0.4})
    # Of (1 + 2 cos) / 3: 7 pi / 9.
    assert overcast.falling() == pytest.approx(7.0 * np.pi / 9.0, rel=1e-4)
    ground = overcast.on_ground((0.5,), np.array([1.0, 2.0, 3.0]))
    expected = 0.5 * (7.0 * np.pi / 9.0 + np.array([1.0, 2.0, 3.0])) / np.pi
    assert ground.radiance(-towards)[0] == pytest.approx(expected, rel=1e-4)
    assert sky.Sky(overcast.light, overcast.parameters, below="mirror").radiance(-UP[np.newaxis])[0, 0] == pytest.approx(1.0)


def test_what_hides_the_sky() -> None:
    light, known = CieTraditional(sky="overcast"), {"sun_zenith": 0.4}
    along = np.array([[1.0, 0.0, 1.0], [0.0, 1.0, 1.0], [-1.0, 0.0, 1.0]]) / np.sqrt(2.0)
    # 60 degrees high in the east, none elsewhere: eight azimuths.
    hilly = sky.Sky(light, known, skyline=(np.pi / 3, 0, 0, 0, 0, 0, 0, 0), below=(0.25, 0.25, 0.25))
    assert hilly.radiance(along)[:, 0] == pytest.approx([0.25, *[(1 + np.sqrt(2.0)) / 3] * 2])
    cloudy = sky.Sky(light, known, opacity=lambda along: np.full(len(along), 0.25), cloud=(4.0, 4.0, 4.0))
    assert cloudy.radiance(along)[0] == pytest.approx(0.75 * (1 + np.sqrt(2.0)) / 3 + 1.0)
    hidden = sky.Sky(light, known, occluders=(np.array([0.1]), along[:1]))
    assert hidden.radiance(along)[:, 0] == pytest.approx([0.0, *[(1 + np.sqrt(2.0)) / 3] * 2])


def test_pictures_of_all_directions() -> None:
    from skylight_sh.probe.rendering import render

    light, at = Preetham(), {"sun_zenith": np.array([0.8]), "turbidity": np.array([4.0])}
    along = sphere.spiral(400)
    along = along[along[:, 2] > 0.1]
    for layout, size in {"equirect": (128, 256), "angular": (256, 256), "cube-strip": (64, 384)}.items():
        found = sky.texels(render(light, at, layout, *size), layout)(along)
        assert np.abs(found / light.radiance(along, at) - 1.0).max() < 0.2
        assert np.abs(found / light.radiance(along, at) - 1.0).mean() < 0.02
    grey = sky.together([lambda some: np.ones((len(some), 1)), ones])
    assert (grey(along) == 2.0).all()


def test_through_transfer_is_what_paths_find() -> None:
    """A ball on a floor in a smooth sky, whole pictures, sun's bounces by vertices included."""
    down = assembled([(Part("floor"), (0.6, 0.4, 0.3), box((-3.0, -3.0, -0.1), (3.0, 3.0, 0.0), 0.25, without="-z"))])
    up = ball(0.7, 24)
    raised = Mesh(up.positions + 1.02 * UP, up.normals, up.albedo, up.triangles, up.part, up.parts, up.uv)
    mesh = both(down, raised)
    surface = Surface(mesh)
    light = sky.Sky(CieTraditional(sky="overcast"), {"sun_zenith": 0.4})
    towards = np.array([0.6, 0.0, 0.8])
    sun = emitters.Disc(towards, sun_disc.HALF_ANGLE, np.array([1.0, 0.9, 0.8]) * 4e4)
    weights = np.zeros((3, 25))
    harmonics = sphere.Harmonics.even(5)
    from skylight_sh.quadrature import zenith_gauss

    known = {"sun_zenith": np.array([[0.4]])}
    weights[:, harmonics.flat] = zenith_gauss.project(light.light, known, nodes=32, harmonics=harmonics).weights[0, 0, 0]
    made = precompute(mesh, Options(5, 1024, 256, 2))
    corner = np.repeat(np.arange(len(mesh.positions))[:, np.newaxis], 3, axis=1)
    vertices = Points(
        made.start.points, mesh.normals, mesh.normals, mesh.albedo, corner, np.tile([1.0, 0.0, 0.0], (len(corner), 1))
    )
    first = straight(surface, vertices, [sun], even(32, np.zeros((len(corner), 2))))
    values = shading.lit(made.transfer, weights) + shading.sent_on(first, mesh.albedo, made.matrix, 2)
    camera = Camera((2.0, -6.0, 2.5), (0.0, 0.0, 0.8), 40.0, 48, 27)
    through = take(camera, surface, lambda p, _: p.interpolate(values), light.radiance, [sun], Sampling(4, 4))
    forced = take(
        camera,
        surface,
        lambda p, first: arriving(surface, p, light.radiance, [sun], Paths(128, 2), first),
        light.radiance,
        [sun],
        Sampling(4, 4),
    )
    assert (through.share == forced.share).all()
    assert _error(through, forced) < 0.03
    bare = shading.lit(made.direct, weights)
    without = take(camera, surface, lambda p, _: p.interpolate(bare), light.radiance, [sun], Sampling(4, 4))
    assert _error(without, forced) > 1.5 * _error(through, forced)


def test_sent_on_by_a_matrix() -> None:
    """Two surfaces that see only each other: a geometric series."""
    matrix = sparse.csr_array(np.array([[0.0, 1.0], [1.0, 0.0]]))
    found = shading.sent_on(np.array([[1.0], [0.0]]), np.array([[0.5], [0.25]]), matrix, 3)
    assert found[:, 0] == pytest.approx([0.125, 0.5 + 0.0625])


def _error(one: Picture, other: Picture) -> float:
    shown = other.share == 1.0
    return float(np.linalg.norm((one.radiance - other.radiance)[shown]) / np.linalg.norm(other.radiance[shown]))


def test_a_relief_turns_normals_and_light() -> None:
    """Under an even slope of the relief a floor is lit like a slope, whichever way its chart lies."""
    bent = np.array([0.6, 0.0, 0.8])
    for uv, along in (
        (np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]), np.array([0.6, 0.0, 0.8])),
        # Turned by a quarter: u runs north; mirrored: u runs west.
        (np.array([[0.0, 1.0], [0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]), np.array([0.0, 0.6, 0.8])),
        (np.array([[1.0, 0.0], [0.0, 0.0], [0.0, 1.0], [1.0, 1.0]]), np.array([-0.6, 0.0, 0.8])),
    ):
        plain = floor(5.0)
        part = Part("floor", relief=np.broadcast_to(bent, (4, 4, 3)))
        mesh = Mesh(plain.positions, plain.normals, plain.albedo, plain.triangles, plain.part, (part,), uv)
        surface = Surface(mesh)
        points = below(surface, np.array([[0.3, -0.2, 1.0], [-2.0, 1.0, 1.0]]))
        carved = relief.carved(mesh, points, np.array([0, 0]))
        assert np.abs(carved.normals - along).max() < 1e-12
        weights = np.array([[3.0, 0.4, 1.0, -0.7]] * 3)
        flat, slope = (shading.lit(unshadowed(normals[np.newaxis], 2), weights) for normals in (UP, along))
        found = relief.brightened(mesh, carved, 0.5 * np.repeat(flat, 2, axis=0), weights)
        assert found == pytest.approx(0.5 * np.repeat(slope, 2, axis=0))
        assert relief.brightened(mesh, points, flat, weights) is flat
    # v alone, on the plain chart.
    part = Part("floor", relief=np.broadcast_to(np.array([0.0, -0.6, 0.8]), (1, 1, 3)))
    mesh = Mesh(plain.positions, plain.normals, plain.albedo, plain.triangles, plain.part, (part,), floor_uv())
    points = below(Surface(mesh), np.array([[0.3, -0.2, 1.0]]))
    assert relief.carved(mesh, points, np.array([0])).normals[0] == pytest.approx([0.0, -0.6, 0.8])


def floor_uv() -> Array:
    return np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
