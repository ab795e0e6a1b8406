"""Captured light: texels cover the sphere exactly, skies come back from every layout, and bad pictures are refused."""

from __future__ import annotations

import itertools
import json
import re
from pathlib import Path

import numpy as np
import OpenImageIO
import pytest
from click.testing import CliRunner
from numpy.typing import NDArray
from skylight_sh import probe, sphere
from skylight_sh.cli import main
from skylight_sh.light.preetham import Preetham
from skylight_sh.probe import files
from skylight_sh.probe.charts import Angular, Chart, Face, LatLong
from skylight_sh.quadrature import sun_centred

Array = NDArray[np.float64]

# Heights and widths in units of a face, or of 1.
SHAPES: list[tuple[str, int, int]] = [
    ("angular", 1, 1),
    ("cube-cross", 3, 4),
    ("cube-cross", 4, 3),
    ("cube-strip", 1, 6),
    ("cube-strip", 6, 1),
    ("equirect", 1, 2),
]
# A low sun over a clear sky is the hardest: nothing but horizon.
SKIES = [(0.8, 3.0), (1.5, 2.5), (0.0, 6.0)]


def sky(sun_zenith: float, turbidity: float, layout: str, height: int, width: int) -> Array:
    parameters = {"sun_zenith": np.array([sun_zenith]), "turbidity": np.array([turbidity])}
    return probe.render(Preetham(), parameters, layout, height, width)


def truth(sun_zenith: float, turbidity: float, bands: int) -> Array:
    parameters = {"sun_zenith": np.array([[sun_zenith]]), "turbidity": np.array([[turbidity]])}
    samples = sun_centred.project(Preetham(), parameters, nodes=64, harmonics=sphere.Harmonics.even(bands))
    return np.asarray(sphere.Harmonics.even(bands).unmirror(samples.weights[0, 0]))


def error(weights: Array, expected: Array) -> float:
    """The largest error relative to the largest weight of the same channel."""
    return float((np.abs(weights - expected).max(axis=1) / np.abs(expected).max(axis=1)).max())


@pytest.mark.parametrize(("layout", "height", "width"), SHAPES)
@pytest.mark.parametrize("size", [1, 2, 7, 64, 301])
def test_texels_cover_the_sphere(layout: str, height: int, width: int, size: int) -> None:
    found = probe.patches(layout, size * height, size * width)
    total = sum(patch.chart.solid_angles(*patch.edges()).sum() for patch in found)
    assert total == pytest.approx(4 * np.pi, rel=0, abs=1e-12)


@pytest.mark.parametrize("chart", [Angular(), LatLong(), Face((1, 0, 0), (0, -1, 0), (0, 0, -1))])
def test_solid_angles_are_integrals_of_the_density_and_density_is_the_jacobian(chart: Chart) -> None:
    x, w = np.polynomial.legendre.leggauss(12)
    u, v = np.array([0.05, 0.35]), np.array([-0.5, -0.1])
    points = 0.2 + 0.15 * x, -0.3 + 0.2 * x[:, np.newaxis]
    expected = (chart.density(*points) * np.outer(w, w)).sum() * 0.15 * 0.2
    assert chart.solid_angles(u, v)[0, 0] == pytest.approx(expected, rel=1e-13)
    at, step = np.array([0.2]), 1e-5
    across = (chart.directions(at + step, at) - chart.directions(at - step, at)) / (2 * step)
    down = (chart.directions(at, at + step) - chart.directions(at, at - step)) / (2 * step)
    assert np.linalg.norm(np.cross(across, down)) == pytest.approx(chart.density(at, at)[0], rel=1e-8)


def test_rim_texels_count_only_what_the_disc_covers() -> None:
    u, v = np.array([0.55, 0.75]), np.array([-0.8, -0.6])
    fine = (np.arange(2000) + 0.5) / 2000 * 0.2
    expected = Angular().density(0.55 + fine, (-0.8 + fine)[:, np.newaxis]).mean() * 0.04
    assert Angular().solid_angles(u, v)[0, 0] == pytest.approx(expected, rel=1e-6)
    assert abs(Angular().solid_angles(np.array([0.8, 0.9]), np.array([0.8, 0.9]))[0, 0]) < 1e-15


@pytest.mark.parametrize(
    ("layout", "shape", "ahead", "right", "up"),
    [
        ("angular", (129, 129), (64, 64), (64, 96), (32, 64)),
        ("equirect", (65, 130), (32, 65), (32, 97), (0, 65)),
        ("cube-cross", (63, 84), (31, 31), (31, 52), (10, 31)),
        ("cube-cross", (84, 63), (31, 31), (31, 52), (10, 31)),
        ("cube-strip", (21, 126), (10, 94), (10, 10), (10, 52)),
        ("cube-strip", (126, 21), (94, 10), (10, 10), (52, 10)),
    ],
)
def test_pictures_are_seen_from_inside(
    layout: str, shape: tuple[int, int], ahead: tuple[int, int], right: tuple[int, int], up: tuple[int, int]
) -> None:
    for place, direction in ((ahead, (1, 0, 0)), (right, (0, -1, 0)), (up, (0, 0, 1))):
        image = np.zeros((*shape, 1))
        image[place] = 1.0
        weights = probe.project(image, layout, 2)[0]
        found = np.array([weights[3], weights[1], weights[2]])
        assert found @ direction / np.linalg.norm(found) > 0.998


@pytest.mark.parametrize(("height", "width"), [(3, 4), (4, 3)])
def test_a_cross_folds(height: int, width: int) -> None:
    size = 16
    looks = np.full((size * height, size * width, 3), np.nan)
    for patch in probe.patches("cube-cross", *looks.shape[:2]):
        u, v = ((edges[1:] + edges[:-1]) / 2 for edges in patch.edges())
        part = patch.chart.directions(*np.meshgrid(u, v))
        looks[patch.row : patch.row + size, patch.column : patch.column + size] = part
    for axis in (0, 1):
        steps = np.linalg.norm(np.diff(looks, axis=axis), axis=-1)
        assert np.nanmax(steps) < 2.1 / size


@pytest.mark.parametrize(("layout", "height", "width"), [shape for shape in SHAPES if shape[1:] != (6, 1)])
def test_a_sky_comes_back_from_512_pixels(layout: str, height: int, width: int) -> None:
    size = 512 // width
    for sun_zenith, turbidity in SKIES:
        image = sky(sun_zenith, turbidity, layout, size * height, size * width)
        assert error(probe.project(image, layout, 5, signed=True), truth(sun_zenith, turbidity, 5)) < 2e-4


@pytest.mark.parametrize(
    ("layout", "height", "width"), [("angular", 2048, 2048), ("cube-cross", 1536, 2048), ("equirect", 1024, 2048)]
)
def test_a_sky_comes_back_from_2048_pixels(layout: str, height: int, width: int) -> None:
    assert error(probe.project(sky(0.8, 3.0, layout, height, width), layout, 5), truth(0.8, 3.0, 5)) < 1e-5


@pytest.mark.parametrize(("layout", "height", "width"), [("angular", 75, 75), ("cube-cross", 57, 76), ("equirect", 37, 74)])
def test_a_horizon_inside_a_row_is_split(layout: str, height: int, width: int) -> None:
    assert error(probe.project(sky(0.8, 3.0, layout, height, width), layout, 5), truth(0.8, 3.0, 5)) < 6e-3
    row = sky(0.8, 3.0, layout, height, width)[height // 2, width // 2 if layout != "cube-cross" else 28]
    above = sky(0.8, 3.0, layout, height, width)[height // 2 - 1, width // 2 if layout != "cube-cross" else 28]
    assert row == pytest.approx(above / 2, rel=0.2)


def test_smooth_light_loses_no_sharpness_to_texels() -> None:
    weights = np.random.default_rng(3).normal(size=36)
    for layout, height, width in (("angular", 128, 128), ("equirect", 64, 128), ("cube-cross", 96, 128)):
        image = np.zeros((height, width, 1))
        for patch in probe.patches(layout, height, width):
            u, v = patch.edges()
            x, w = np.polynomial.legendre.leggauss(3)
            points = np.meshgrid(
                ((u[1:] + u[:-1])[:, np.newaxis] + np.diff(u)[:, np.newaxis] * x).ravel() / 2,
                ((v[1:] + v[:-1])[:, np.newaxis] + np.diff(v)[:, np.newaxis] * x).ravel() / 2,
            )
            shape = (patch.rows, 3, patch.columns, 3)
            share = (patch.chart.density(*points) + 1e-30).reshape(shape) * w[:, np.newaxis, np.newaxis] * w
            values = sphere.evaluate(weights, patch.chart.directions(*points).reshape(-1, 3)).reshape(shape)
            place = np.s_[patch.row : patch.row + patch.rows, patch.column : patch.column + patch.columns, 0]
            image[place] = (values * share).sum(axis=(1, 3)) / share.sum(axis=(1, 3))
        # Texels taken at their centres lose 2e-3 to 3e-3 here.
        assert error(probe.project(image, layout, 6, signed=True), weights[np.newaxis]) < 3e-4


def test_a_blur_is_gaussian_and_keeps_the_total() -> None:
    sigma = np.radians(8.0)
    delta = sphere.basis(np.array([0.0, 0.0, 1.0]), 60)
    kernel = probe.blur(delta, sigma)
    assert kernel[0] == delta[0]
    angles = np.array([0.0, 0.05, 0.2, 0.5])
    looks = np.stack([np.sin(angles), 0 * angles, np.cos(angles)], axis=-1)
    # The plane's Gaussian, with the sphere's first correction.
    expected = np.exp(-(angles**2) / (2 * sigma**2)) * np.sqrt(np.sinc(angles / np.pi) ** -1) / (2 * np.pi * sigma**2)
    assert sphere.evaluate(kernel, looks) == pytest.approx(expected, rel=0.01)
    with pytest.raises(ValueError, match=r"Invalid blur of nan radians.*at least 0"):
        probe.blur(delta, float("nan"))


def test_eight_bits_hide_ringing_by_losing_the_sun() -> None:
    """Negative light in 5 bands of sky, sun and dim ground: 38 % of all as HDR, 2.4 % as sRGB, 0 left undecoded (004)."""
    image = sky(0.8, 3.0, "equirect", 128, 256)
    image[64:] = 0.03 * image[:64].mean(axis=(0, 1))
    # The sun, 80,000 lux, in the texel about its centre.
    row = int(0.8 / np.pi * 128)
    image[row, 128] += 8e4 / LatLong().solid_angles(*probe.patches("equirect", 128, 256)[0].edges())[row, 128]
    exposed = image / (2 * np.median(image[:64]))
    low = np.minimum(exposed, 1.0)
    encoded = np.round(255 * np.where(low <= 0.0031308, 12.92 * low, 1.055 * low ** (1 / 2.4) - 0.055)) / 255
    looks = np.random.default_rng(1).normal(size=(20_000, 3))
    looks /= np.linalg.norm(looks, axis=1, keepdims=True)

    def ringing(picture: Array) -> float:
        values = sphere.evaluate(probe.project(picture, "equirect", 5), looks)
        return float(-np.minimum(values, 0.0).sum() / values.sum())

    assert ringing(exposed) == pytest.approx(0.38, abs=0.03)
    assert ringing(files.from_srgb(encoded.astype(np.float32))) == pytest.approx(0.024, abs=0.003)
    assert ringing(encoded) == 0.0


def write(path: Path, pixels: Array, form: str) -> Path:
    output = OpenImageIO.ImageOutput.create(str(path))
    output.open(str(path), OpenImageIO.ImageSpec(pixels.shape[1], pixels.shape[0], pixels.shape[2], form))
    output.write_image(pixels.astype(np.float32))
    output.close()
    return path


def invoke(*arguments: str) -> tuple[int, str, str]:
    result = CliRunner().invoke(main, ["project", *arguments])
    assert result.exception is None or isinstance(result.exception, SystemExit), result.exception
    return result.exit_code, result.stdout, result.stderr


@pytest.mark.parametrize(
    ("name", "form", "tolerance"),
    [
        ("a.exr", "half", 1e-3),
        ("a.hdr", "float", 8e-3),
        ("a.png", "uint8", 4e-3),
        ("b.png", "uint16", 1e-4),
        ("a.tif", "float", 0),
    ],
)
def test_files_hold_what_was_written(tmp_path: Path, name: str, form: str, tolerance: float) -> None:
    pixels = np.random.default_rng(2).random((8, 16, 3))
    path = write(tmp_path / name, pixels, form)
    assert np.abs(files.read(path, linear=True).pixels - pixels.astype(np.float32)).max() <= tolerance
    decoded = ((pixels + 0.055) / 1.055) ** 2.4
    expected = decoded if form.startswith("uint") else pixels
    high = pixels > 0.05
    assert np.abs(files.read(path).pixels - expected)[high].max() <= 3 * tolerance + 1e-6


def test_the_command_prints_the_weights_of_a_file(tmp_path: Path) -> None:
    image = sky(0.8, 3.0, "angular", 64, 64)
    path = str(write(tmp_path / "sky.exr", image, "float"))
    code, out, _ = invoke(path, "--layout", "angular", "--bands", "3", "--blur", "10", "--json")
    assert code == 0
    expected = probe.blur(probe.project(image.astype(np.float32), "angular", 3), np.radians(10.0))
    assert np.array(list(json.loads(out).values())) == pytest.approx(expected, rel=1e-12)
    code, out, _ = invoke(path, "--layout", "angular", "--bands", "2")
    assert code == 0
    assert out.splitlines()[0].split() == ["l", "m", "red", "green", "blue"]
    assert len(out.splitlines()) == 5


@pytest.mark.parametrize("value", [np.nan, np.inf, -0.5])
def test_bad_pixels_are_told_with_their_place(tmp_path: Path, value: float) -> None:
    image = np.ones((16, 16, 3))
    image[0, 0] = value
    path = write(tmp_path / "bad.exr", image, "float")
    # The corner lies outside the disc.
    assert invoke(str(path), "--layout", "angular", "--bands", "2")[0] == 0
    image[5, 7, 1] = value
    code, _, told = invoke(str(write(path, image, "float")), "--layout", "angular", "--bands", "2")
    assert code == 2
    assert "bad.exr: Invalid pixel at row 5, column 7 (from 0, top left), channel 1" in told
    assert f"{value}. Should be a finite radiance of at least 0. Mend it" in told


def test_clipped_pixels_are_told(tmp_path: Path) -> None:
    image = np.full((16, 32, 3), 0.5)
    image[2, :, 1] = 1.0
    code, _, told = invoke(str(write(tmp_path / "p.png", image, "uint8")), "--bands", "2")
    assert code == 0
    assert "6.2 % of the pixels are clipped" in told
    assert invoke(str(write(tmp_path / "p.exr", 2 * image, "float")), "--bands", "2")[2] == ""


def test_the_layout_follows_from_the_proportions(tmp_path: Path) -> None:
    for layout, shape in (("angular", (16, 16)), ("equirect", (16, 32)), ("cube-cross", (24, 32)), ("cube-strip", (8, 48))):
        path = write(tmp_path / "p.exr", np.random.default_rng(4).random((*shape, 3)), "float")
        told = invoke(str(path), "--layout", layout, "--bands", "3")
        assert invoke(str(path), "--bands", "3") == told
        assert told[0] == 0
    code, _, refused = invoke(str(write(tmp_path / "p.exr", np.ones((16, 20, 3)), "float")), "--bands", "3")
    assert code == 2
    assert "Invalid size 20x16" in refused
    assert "2:1 equirect" in refused


def test_bad_pictures_and_options_exit_2_with_a_remedy(tmp_path: Path) -> None:
    noise = np.random.default_rng(4).random((16, 32, 3))
    good = write(tmp_path / "good.exr", noise, "float")
    two = write(tmp_path / "two.exr", np.ones((16, 32, 2)), "float")
    contents = {
        "empty.exr": b"",
        "text.png": b"no picture",
        "zero.hdr": b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 0 +X 0\n",
        "cut.exr": good.read_bytes()[:-100],
        "cut.jpg": write(tmp_path / "cut.jpg", noise, "uint8").read_bytes()[:-100],
    }
    for name, content in contents.items():
        (tmp_path / name).write_bytes(content)
        code, _, told = invoke(str(tmp_path / name), "--layout", "equirect", "--bands", "2")
        assert code == 2, name
        assert f"{name} is no picture that can be read" in told
    cases = [
        ((str(good), "--layout", "angular", "--bands", "2"), "Invalid size 32x16 .* proportions 1:1. Crop or resize"),
        ((str(good), "--layout", "equirect", "--bands", "17"), "Invalid number of bands 17. Should be from 1 to 16"),
        ((str(good), "--layout", "equirect", "--bands", "0"), "Invalid number of bands 0. Should be from 1 to 16"),
        (
            (str(good), "--layout", "equirect", "--bands", "2", "--blur", "-1"),
            "Invalid --blur -1.0. Should be from 0 to 180",
        ),
        ((str(two), "--layout", "equirect", "--bands", "2"), "Should hold R, G and B, or one alone. Save it as RGB"),
        ((str(tmp_path / "none.exr"), "--layout", "equirect", "--bands", "2"), "none.exr: no such file"),
        ((str(tmp_path), "--layout", "equirect", "--bands", "2"), "a folder. Give the path"),
    ]
    for arguments, expected in cases:
        code, _, told = invoke(*arguments)
        assert code == 2, arguments
        assert re.search(expected, told), told
    for layout, (height, width) in itertools.product(probe.IMAGE_LAYOUTS, [(0, 0), (5, 9)]):
        with pytest.raises(ValueError, match=r"Invalid size"):
            probe.patches(layout, height, width)
