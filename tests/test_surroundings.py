"""Skyline, clouds, occluders, ground and lights of a scene: closed forms, whole runs, and what is refused."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import OpenImageIO
import pytest
from click.testing import CliRunner
from conftest import ONE_LAYOUT, run_quietly, scene_config
from numpy.typing import NDArray
from skylight_sh import runtime, sphere
from skylight_sh.cli import main
from skylight_sh.config import Config, ConfigError, load
from skylight_sh.light import spherical_lights
from skylight_sh.probe.layouts import patches
from skylight_sh.run import plan, scene_problems
from skylight_sh.run.steps import steps
from skylight_sh.runtime import Surroundings
from skylight_sh.scene.surroundings import Clouds, build, mask_bands
from skylight_sh.table.size import bytes_of
from skylight_sh.table.surroundings import gain

Array = NDArray[np.float64]
TEXT = ONE_LAYOUT.replace("[0.05, 0.01]", "[0.01]").replace('["bands"]', '["surroundings"]')
BANDS = 4
WIDE = mask_bands(BANDS)
RNG = np.random.default_rng(3)
SKY = RNG.normal(size=(3, BANDS * BANDS))


def constant(value: float, bands: int = BANDS) -> Array:
    out = np.zeros(bands * bands)
    out[0] = value * np.sqrt(4 * np.pi)
    return out


def picture(path: Path, pixels: Array) -> None:
    """Write ``(height, width)`` in [0, 1] as bytes, or as floats for OpenEXR."""
    floats = path.suffix == ".exr"
    out = OpenImageIO.ImageOutput.create(str(path))
    out.open(str(path), OpenImageIO.ImageSpec(pixels.shape[1], pixels.shape[0], 1, "float" if floats else "uint8"))
    out.write_image(
        pixels[..., np.newaxis].astype(np.float32) if floats else np.rint(255 * pixels[..., np.newaxis]).astype(np.uint8)
    )
    out.close()


def config_of(folder: Path, scene: str) -> Config:
    return scene_config(scene, TEXT, folder)


# Closed forms


def test_nothing_changes_nothing() -> None:
    assert np.array_equal(build(BANDS).apply(SKY, BANDS), SKY)
    clear = build(BANDS, clouds=Clouds(np.zeros(WIDE * WIDE), np.ones(3)))
    assert np.abs(clear.apply(SKY, BANDS) - SKY).max() < 1e-13
    assert gain(clear) == pytest.approx(1.0, abs=1e-13)


def test_a_shadow_is_everything_but_a_cap() -> None:
    angle, direction = spherical_lights.half_angles([[1.0, -2.0, 2.0]], [1.0])
    around = build(BANDS, occluders=(angle, direction))
    shade = constant(1.0) - sphere.aim(sphere.cap(angle[0], BANDS), direction[0])
    assert np.abs(around.apply(constant(1.0)[np.newaxis], BANDS)[0] - shade).max() < 1e-13
    # Two apart hide as much as each does.
    both = build(BANDS, occluders=(np.r_[angle, angle], np.r_[direction, -direction]))
    lost = 1 - both.apply(constant(1.0)[np.newaxis], BANDS)[0, 0] / np.sqrt(4 * np.pi)
    assert lost == pytest.approx(2 * (1 - shade[0] / np.sqrt(4 * np.pi)), rel=0.02)


def test_a_skyline_hides_what_its_integral_says() -> None:
    """The weights of mask times sky by Gauss and trapezoid above a level skyline, exactly: the sky has few bands."""
    elevation = 0.3
    around = build(BANDS, skyline=(elevation,))
    x, areas = np.polynomial.legendre.leggauss(40)
    low = np.sin(elevation)
    z, areas = (1 + low + (1 - low) * x) / 2, areas * (1 - low) / 2
    phi = np.arange(32) * np.pi / 16
    flat = np.sqrt(1 - z * z)[:, np.newaxis]
    where = np.stack(np.broadcast_arrays(flat * np.cos(phi), flat * np.sin(phi), z[:, np.newaxis]), axis=-1)
    basis = sphere.basis(where, BANDS)
    seen = np.einsum("ijk,ck->cij", basis, SKY)
    expected = np.einsum("cij,ijk,i->ck", seen, basis, areas * np.pi / 16)
    assert np.abs(around.apply(SKY, BANDS) - expected).max() < 1e-12


def test_opaque_clouds_and_the_ground_below() -> None:
    colour, albedo = np.array([3.0, 2.0, 1.0]), [0.1, 0.2, 0.3]
    upper = np.where(sphere.Harmonics(BANDS).orders == 0, sphere.cap(np.pi / 2, BANDS)[sphere.Harmonics(BANDS).degrees], 0)
    # Clouds end on the horizon, whatever the picture shows below it.
    assert (
        np.abs(build(BANDS, clouds=Clouds(constant(1.0, WIDE), colour)).own - np.multiply.outer(colour, upper)).max() < 1e-12
    )
    # Through clouds that are not there, the ground is that of ``add_ground``.
    lit = build(BANDS, clouds=Clouds(np.zeros(WIDE * WIDE), colour), albedo=albedo).apply(SKY, BANDS)
    assert np.abs(lit - sphere.add_ground(SKY, albedo, BANDS)).max() < 1e-13
    # Under an even sky, irradiance pi, a skyline at the horizon and nothing else, the ground's radiance is the albedo.
    even = np.zeros((3, BANDS * BANDS))
    l = np.arange(BANDS)
    even[:, l * (l + 1)] = sphere.cap(np.pi / 2, BANDS)
    ground = build(BANDS, skyline=(0.0,), albedo=albedo)
    assert (
        np.abs(
            ground.below[:, l * (l + 1)] * np.sqrt(3 * np.pi / 4) - np.multiply.outer(albedo, sphere.lower_hemisphere(BANDS))
        ).max()
        < 1e-13
    )
    with pytest.raises(ValueError, match="two bands"):
        build(1, skyline=(0.1,), albedo=albedo)


@pytest.mark.parametrize("height", [4.0, -4.0])
def test_lamps_do_not_light_the_ground(height: float) -> None:
    """With a speck that hides nothing and without: the sky's ground, and the lamp."""
    lamp = np.multiply.outer([7.0, 8.0, 9.0], spherical_lights.spheres([0.0, 1.0, height], 0.5, BANDS))
    speck = spherical_lights.half_angles([[0.0, 0.0, 9e6]], [1e-3])
    masked = build(BANDS, occluders=speck, albedo=[0.5] * 3, lights=lamp).apply(SKY, BANDS)
    assert np.abs(masked - (sphere.add_ground(SKY, [0.5] * 3, BANDS) + lamp)).max() < 1e-12


def test_the_gain_bounds_how_errors_grow() -> None:
    around = build(BANDS, skyline=(0.3, 0.1, 0.2), albedo=[0.2, 0.9, 0.5], lights=np.ones((3, 16)))
    errors = RNG.normal(size=(2000, 3, 16))
    grown = around.apply(errors, BANDS) - around.apply(np.zeros((3, 16)), BANDS)
    ratio = np.linalg.norm(grown, axis=-1) / np.linalg.norm(errors, axis=-1)
    assert ratio.max() < gain(around)
    bright = around.transfer + np.outer(around.below[1], around.transfer[2])
    assert gain(around) == pytest.approx(np.linalg.svd(bright)[1][0])


def test_fewer_bands_are_the_first_ones() -> None:
    around = Surroundings(*(RNG.normal(size=shape) for shape in ((16, 16), (3, 16), (3, 16))))
    assert np.array_equal(around.apply(SKY, 2), around.apply(SKY, BANDS)[:, :4])


# Whole runs


def test_a_run_hides_shines_and_turns(tmp_path: Path) -> None:
    """Clouds to the west and a lamp stay where they are while the sun turns; without them the sky is the plain one."""
    rows, columns = 32, 64
    patch = patches("equirect", rows, columns)[0]
    u, v = (edges[1:] / 2 + edges[:-1] / 2 for edges in patch.edges())
    opacity = 0.5 * (1 - patch.chart.directions(u[np.newaxis], v[:, np.newaxis])[..., 0])
    picture(tmp_path / "clouds.exr", opacity)
    clouds = 'clouds = { image = "clouds.exr", layout = "equirect", colour = [4000.0, 5000.0, 6000.0], opacity = 0.5 }'
    lamp = 'lights = [{ kind = "sphere", centre = [0.0, 3.0, 4.0], radius = 1.0, radiance = [9000.0, 8000.0, 7000.0] }]'
    result = run_quietly(config_of(tmp_path, f"{clouds}\n{lamp}"), tmp_path)
    assert (result.folder / "figures" / "surroundings.png").stat().st_size > 20_000
    around = runtime.load(result.folder / "export" / "skylight_sh.npz")
    # A table of given degrees, of fewer bands, has its own.
    given = runtime.load(result.folder / "export" / "3-bands-degrees-6-4-float64" / "skylight_sh.npz").table.surroundings
    assert given is not None
    assert given.transfer.shape == (9, 9)
    plain = runtime.load(run_quietly(config_of(tmp_path, ""), tmp_path).folder / "export" / "skylight_sh.npz")
    assert bytes_of(around.table) == bytes_of(plain.table) + 4 * (256 + 3 * 16)
    # 0.5 (1 - x) times 0.5, and x is a multiple of y_11.
    weights = constant(0.25, 2)
    weights[3] = -0.25 * np.sqrt(4 * np.pi / 3)
    weights = sphere.product(sphere.horizon(0.0, WIDE), weights, WIDE)
    shone = np.multiply.outer([9000.0, 8000.0, 7000.0], spherical_lights.spheres([0.0, 3.0, 4.0], 1.0, BANDS))
    for azimuth in (0.3, 2.0, -1.0):
        sky = plain.weights(0.8, azimuth, 3.3).astype(np.float64)
        expected = sphere.cover(sky, weights, np.array([4000.0, 5000.0, 6000.0]), BANDS) + shone
        assert np.abs(around.weights(0.8, azimuth, 3.3) - expected).max() < 2e-4 * np.abs(sky).max()


def test_lamps_light_diffusely(tmp_path: Path) -> None:
    lights = """
lights = [
  { kind = "directional", direction = [0.0, 0.0, 2.0], illuminance = [5e4, 5e4, 5e4] },
  { kind = "point", centre = [0.0, 0.0, -2.0], intensity = [4e4, 0.0, 0.0] },
  { kind = "spot", centre = [3.0, 0.0, 0.0], axis = [1.0, 0.0, 0.0], inner = 0.1, outer = 0.2, intensity = [9e9, 0.0, 0.0] },
  { kind = "disc", direction = [0.0, 1.0, 0.0], half_angle = 0.01, radiance = [0.0, 0.0, 1e8] },
]"""
    scene = f'quantity = "irradiance"\n{lights}'
    lit = runtime.load(run_quietly(config_of(tmp_path, scene), tmp_path).folder / "export" / "skylight_sh.npz")
    plain = runtime.load(
        run_quietly(config_of(tmp_path, 'quantity = "irradiance"'), tmp_path).folder / "export" / "skylight_sh.npz"
    )
    added = lit.weights(0.8, 0.0, 3.3).astype(np.float64) - plain.weights(0.8, 0.0, 3.3)
    up, down, east, north = np.eye(3)[2], -np.eye(3)[2], np.eye(3)[0], np.eye(3)[1]
    whole = sphere.clamped_cosine(BANDS) @ ((2 * np.arange(BANDS) + 1) / (4 * np.pi))
    found = {n: sphere.evaluate(added, d) for n, d in (("up", up), ("down", down), ("east", east), ("north", north))}
    # Four bands of a clamped cosine towards a pulse.
    assert found["up"] == pytest.approx(np.full(3, 5e4 * whole), rel=0.2)
    assert found["down"][0] - found["down"][1] == pytest.approx(1e4 * whole, rel=0.01)
    assert found["north"][2] - found["north"][1] == pytest.approx(1e8 * np.pi * np.sin(0.01) ** 2 * whole, rel=0.01)
    # The spot shines away from the receiver.
    assert found["east"][1] == pytest.approx(found["east"][0], abs=0.1 * 1e4)


def test_captured_light_is_added(tmp_path: Path) -> None:
    """A picture that is 1 + x everywhere, as the sky of a dark one would be."""
    patch = patches("angular", 64, 64)[0]
    u, v = (edges[1:] / 2 + edges[:-1] / 2 for edges in patch.edges())
    picture(tmp_path / "p.exr", 1 + patch.chart.directions(*np.meshgrid(u, v))[..., 0])
    scene = 'lights = [{ kind = "probe", image = "p.exr", layout = "angular", brightness = 3000.0, blur = 0.5 }]'
    lit = runtime.load(run_quietly(config_of(tmp_path, scene), tmp_path).folder / "export" / "skylight_sh.npz")
    plain = runtime.load(run_quietly(config_of(tmp_path, ""), tmp_path).folder / "export" / "skylight_sh.npz")
    expected = constant(3000.0)
    expected[3] = 3000.0 * np.sqrt(4 * np.pi / 3) * np.exp(-(0.5**2))
    for azimuth in (0.0, 2.0):
        added = lit.weights(0.8, azimuth, 3.3).astype(np.float64) - plain.weights(0.8, azimuth, 3.3)
        assert np.abs(added - expected).max() < 2e-3 * 3000


def test_the_picture_decides_the_key(tmp_path: Path) -> None:
    clouds = 'clouds = { image = "c.png", layout = "angular", colour = [1.0, 1.0, 1.0] }'
    keys = []
    for value in (0.2, 0.4, 0.2):
        picture(tmp_path / "c.png", np.full((32, 32), value))
        keys.append(plan.keys(steps(config_of(tmp_path, clouds))))
    assert keys[0] == keys[2]
    changed = {name for name, key in keys[0].items() if keys[1][name] != key}
    assert "truth/surroundings" in changed
    assert "select" in changed
    assert not changed & {"truth/rule", "truth/grid"}


# Refused


@pytest.mark.parametrize(
    ("scene", "message"),
    [
        ("horizon = [0.1, 1.6]", r"\$\.scene\.horizon\[1\] = 1\.6"),
        ('horizon = [0.1]\nground = "mirror"', r"\$\.scene\.ground = 'mirror'.*without what hides it"),
        (
            'twilight = true\nclouds = { image = "c.png", layout = "angular", colour = [1.0, 1.0, 1.0] }',
            r"\$\.scene\.twilight = True.*Clouds shine alike",
        ),
        (
            'lights = [{ kind = "point", centre = [0.0, 0.0, 1e-16], intensity = [1e12, 0.0, 0.0] }]',
            r"\$\.scene\.lights\[0\] = 'point': Its weights reach",
        ),
        (
            'lights = [{ kind = "sphere", centre = [0.0, 0.0, 9.0], radius = -1.0, radiance = [1.0, 1.0, 1.0] }]',
            r"\$\.scene\.lights\[0\]\.radius = -1\.0.*Allowed: above 0",
        ),
        (
            'lights = [{ kind = "point", centre = [0.0, 0.0, 1.0], colour = 3, intensity = [1.0, 1.0, 1.0] }]',
            r"\$\.scene\.lights\[0\]\.colour = 3: Unknown key.*Known here: centre, intensity, kind",
        ),
        (r'clouds = { image = "\u0000", layout = "angular", colour = [1.0, 1.0, 1.0] }', r"clouds\.image.*Leaves"),
        ('horizon = [0.1]\nquantity = "irradiance"', r"\$\.scene\.quantity = 'irradiance'.*radiance"),
        ("horizon = [0.1]\nwindow = true", r"\$\.scene\.window = True"),
        ("occluders = [{ centre = [1.0, 0.0, 0.0], radius = 2.0 }]", r"\$\.scene\.occluders\[0\].*inside"),
        ("occluders = [{ centre = [1.0, 0.0, 0.0], radius = -2.0 }]", r"\$\.scene\.occluders\[0\]\.radius = -2\.0"),
        (
            'lights = [{ kind = "sphere", centre = [0.0, 0.0, 1.0], radius = 2.0, radiance = [1.0, 1.0, 1.0] }]',
            r"\$\.scene\.lights\[0\].*inside",
        ),
        (
            'lights = [{ kind = "disc", direction = [0.0, 0.0, 0.0], half_angle = 0.1, radiance = [1.0, 1.0, 1.0] }]',
            r"\$\.scene\.lights\[0\].*direction",
        ),
        (
            'lights = [{ kind = "spot", centre = [0.0, 0.0, 1.0], axis = [0.0, 0.0, -1.0], inner = 0.3, outer = 0.2, '
            "intensity = [1.0, 1.0, 1.0] }]",
            r"\$\.scene\.lights\[0\].*inner < outer",
        ),
        (
            'lights = [{ kind = "point", centre = [0.0, 0.0, 1.0], intensity = [1.0] }]',
            r"\$\.scene\.lights\[0\].*red, green",
        ),
        ('lights = [{ kind = "torch", centre = [0.0, 0.0, 1.0] }]', r"\$\.scene\.lights\[0\].*sphere"),
        ('clouds = { image = "../c.png", layout = "angular", colour = [1.0, 1.0, 1.0] }', r"clouds\.image.*Leaves"),
        ('clouds = { image = "/etc/c.png", layout = "angular", colour = [1.0, 1.0, 1.0] }', r"clouds\.image.*Leaves"),
        ('clouds = { image = "none.png", layout = "angular", colour = [1.0, 1.0, 1.0] }', r"clouds\.image.*no such file"),
        ('clouds = { image = "c.txt", layout = "angular", colour = [1.0, 1.0, 1.0] }', r"clouds\.image.*no picture"),
        ('clouds = { image = "nan.exr", layout = "angular", colour = [1.0, 1.0, 1.0] }', r"clouds\.image.*nan at row 3"),
        ('clouds = { image = "c.png", layout = "equirect", colour = [1.0, 1.0, 1.0] }', r"clouds\.image.*2:1"),
        ('clouds = { image = "tiny.png", layout = "angular", colour = [1.0, 1.0, 1.0] }', r"clouds\.image.*larger picture"),
        (
            'lights = [{ kind = "probe", image = "nan.exr", layout = "angular" }]',
            r"lights\[0\]\.image.*Invalid pixel at row 3",
        ),
        ('lights = [{ kind = "probe", image = "c.png", layout = "cube-strip" }]', r"lights\[0\]\.image.*6:1"),
        ('clouds = { image = "c.png", layout = "angular", colour = [1.0] }', r"clouds\.colour.*red, green, blue"),
    ],
)
def test_surroundings_that_cannot_be_are_refused(tmp_path: Path, scene: str, message: str) -> None:
    folder = tmp_path / "configs"
    folder.mkdir()
    for place, size in ((folder / "c.png", 32), (folder / "tiny.png", 8), (tmp_path / "c.png", 32)):
        picture(place, np.full((size, size), 0.5))
    bad = np.full((32, 32), 0.5)
    bad[3, 16] = np.nan
    picture(folder / "nan.exr", bad)
    (folder / "c.txt").write_text("clouds", encoding="utf-8")
    with pytest.raises(ConfigError, match=message):
        scene_problems.check(config_of(folder, scene))


def test_pictures_are_told_at_once_by_the_first_step_and_nothing_is_written(tmp_path: Path) -> None:
    path = tmp_path / "small.toml"
    picture(tmp_path / "tiny.png", np.full((2, 2), 0.5))
    scene = """
[scene]
clouds = { image = "none.png", layout = "angular", colour = [1.0, 1.0, 1.0] }
lights = [
    { kind = "probe", image = "tiny.png", layout = "angular" },
    { kind = "point", centre = [0.0, 0.0, 0.0], intensity = [1.0, 1.0, 1.0] },
]
"""
    path.write_text(TEXT + scene, encoding="utf-8")
    load(path)
    options = ["--store", str(tmp_path / "store"), "--reports", str(tmp_path / "reports")]
    for arguments in (["run", str(path), *options], ["config", "check", str(path)]):
        result = CliRunner().invoke(main, arguments)
        assert result.exit_code == 2, result.output
        assert re.search(
            r"The scene of small has 3 problems:\n"
            r"  \$\.scene\.clouds\.image = 'none\.png': .*no such file.*\n"
            r"  \$\.scene\.lights\[0\]\.image = 'tiny\.png': Resolves 1 bands; the winners need 4.*\n"
            r"  \$\.scene\.lights\[1\] = 'point': A point light stands at its receiver",
            result.stderr,
        ), result.stderr
    assert not [p for p in tmp_path.rglob("*") if p.is_file() and p.name not in ("small.toml", "tiny.png")]
