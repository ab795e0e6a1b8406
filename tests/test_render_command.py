"""The command `render`: pictures of a small scene through table, transfer and store; a day; what it refuses."""

from __future__ import annotations

import math
import re
import tomllib
from pathlib import Path

import numpy as np
import OpenImageIO
import pytest
from click.testing import CliRunner, Result
from conftest import ONE_LAYOUT
from numpy.typing import NDArray
from skylight_sh.cli import main
from skylight_sh.config import parse
from skylight_sh.config.loading import load
from skylight_sh.config.problem import ConfigError
from skylight_sh.config.views_schema import SkySunSection
from skylight_sh.light import sun_disc
from skylight_sh.mesh import read
from skylight_sh.render import lettering, tone
from skylight_sh.run import from_views
from skylight_sh.run.from_config import read_table
from skylight_sh.runtime import Runtime
from skylight_sh.scene import solar

Array = NDArray[np.float64]

# A block on a floor, and a wall behind it.
OBJ = """
v -4 -4 0
v 4 -4 0
v 4 4 0
v -4 4 0
v -1 -1 0.01
v 1 -1 0.01
v 1 1 0.01
v -1 1 0.01
v -1 -1 2
v 1 -1 2
v 1 1 2
v -1 1 2
o floor
f 1 2 3 4
o block
f 5 8 7 6
f 9 10 11 12
f 5 6 10 9
f 6 7 11 10
f 7 8 12 11
f 8 5 9 12
"""
SCENE = """
[scene]
ground = "mirror"
[scene.mesh]
file = "block.obj"
rays = 64
gather_rays = 32
bounces = 1
[[views]]
name = "one"
eye = [5.0, -7.0, 3.0]
target = [0.0, 0.0, 0.8]
width = 32
height = 18
samples = 4
sun = { height = 30.0, azimuth = -20.0 }
at = { turbidity = 3.0 }
[[views]]
name = "dated"
eye = [5.0, -7.0, 3.0]
target = [0.0, 0.0, 0.8]
width = 96
height = 54
samples = 1
sun = { time = "2026-06-21T12:00", latitude = 48.2, longitude = 16.4, timezone = "Europe/Vienna" }
at = { turbidity = 3.0 }
"""


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("render")
    (folder / "block.obj").write_text(OBJ)
    (folder / "block.toml").write_text(ONE_LAYOUT + SCENE)
    return folder


def rendered(place: Path, *arguments: str) -> Result:
    return CliRunner().invoke(main, ["render", str(place / "block.toml"), "--store", str(place / "store"), *arguments])


def picture(place: Path, name: str, *arguments: str) -> Array:
    done = rendered(place, "--output", str(place / name), *arguments)
    assert done.exit_code == 0, done.output
    assert name in done.output
    return np.asarray(OpenImageIO.ImageBuf(str(place / name)).get_pixels(OpenImageIO.FLOAT), dtype=np.float64)


def off(one: Array, other: Array) -> float:
    return float(np.linalg.norm(one - other) / np.linalg.norm(other))


def test_through_transfer_beside_brute_force(place: Path) -> None:
    through = picture(place, "through.exr")
    again = picture(place, "again.exr", "--workers", "1")
    assert (through == again).all()
    forced = picture(place, "forced.exr", "--brute-force", "--paths", "32")
    assert through.shape == forced.shape == (18, 32, 3)
    # Four bands, and a vertex a corner.
    assert off(through, forced) < 0.04
    assert off(picture(place, "open.exr", "--unshadowed"), forced) > 1.5 * off(through, forced)
    assert picture(place, "bare.exr", "--bounces", "0").sum() < through.sum()
    dull = picture(place, "dull.exr", "--no-sun")
    assert 0.2 < dull.sum() / through.sum() < 0.9


def test_png_shows_the_same_picture(place: Path) -> None:
    shown = picture(place, "one.png")
    first = (place / "one.png").read_bytes()
    linear = picture(place, "one.exr")
    assert picture(place, "one.png").shape == shown.shape
    assert (place / "one.png").read_bytes() == first
    # One exposure explains all pixels.
    told = rendered(place, "--output", str(place / "one.png")).output
    lux = float(re.findall(r"([0-9.]+) klx", told)[0])
    expected = tone.display(linear, tone.exposure(1000.0 * lux))
    assert np.abs(expected - shown).max() < 0.02
    brighter = picture(place, "bright.png", "--exposure", "1")
    assert brighter.mean() > shown.mean() + 0.03


def test_a_day_in_slices_and_frames(place: Path) -> None:
    made = picture(place, "day.png", "--view", "dated", "--slices", "4")
    assert made.shape == (54, 96, 3)
    # A white rule between any two strips, and none else over the whole height.
    whole = (made == 1.0).all(axis=(0, 2))
    assert np.flatnonzero(whole).tolist() == [24, 48, 72]
    done = rendered(place, "--view", "dated", "--frames", "2", "--size", "16x9", "--output", str(place / "day.png"))
    assert done.exit_code == 0, done.output
    assert (place / "day-0001.png").is_file()
    assert (place / "day-0002.png").is_file()


def test_days_begin_and_end_low() -> None:
    sun = SkySunSection(time="2026-06-21", latitude=48.2, longitude=16.4, timezone="Europe/Vienna")
    suns = from_views.day_of(sun, 5)
    heights = [90.0 - math.degrees(sun.zenith) for sun in suns]
    assert 1.9 < heights[0] < 3.0
    assert 1.9 < heights[-1] < 3.0
    assert max(heights) == heights[2] == pytest.approx(65.2, abs=0.3)
    assert suns[0].clock == "05:15"
    at = from_views.sun_of(SkySunSection(time="2026-06-21T12:00+02:00", latitude=48.2, longitude=16.4))
    assert (at.zenith, at.azimuth) == solar.position(
        solar.Place(48.2, 16.4), from_views.datetime(2026, 6, 21, 10, tzinfo=from_views.ZoneInfo("UTC"))
    )


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["--view", "none"], "one, dated"),
        (["--sun", "12"], "12,-15"),
        (["--sun", "12,0", "--time", "2026-06-21"], "Give one of them"),
        (["--sun", "95,0"], "height"),
        (["--sun=-5,0"], "twilight = true"),
        (["--time", "2026-06-21"], "latitude and longitude"),
        (["--time", "noon", "--place", "1,2"], "ISO 8601"),
        (["--size", "big"], "1200x675"),
        (["--turbidity", "9"], "[2.5, 6]"),
        (["--at", "haze=3"], "turbidity"),
        (["--table", "best"], "4-bands-1pct"),
        (["--bands", "9"], "1 to 4"),
        (["--output", "a.jpg"], ".png"),
        (["--output", "none/a.png"], "make it first"),
        (["--slices", "3"], "--place"),
        (["--slices", "3", "--frames", "3"], "Give one of them"),
        (["--brute-force", "--unshadowed"], "--unshadowed"),
    ],
)
def test_what_is_refused(place: Path, arguments: list[str], told: str) -> None:
    done = rendered(place, *arguments)
    assert done.exit_code == 2, done.output
    assert told in done.output


def test_all_that_is_wrong_with_views_at_once() -> None:
    wrong = SCENE.replace('"dated"', '"one"').replace("target = [0.0, 0.0, 0.8]", "target = [5.0, -7.0, 0.0]", 1)
    wrong = wrong.replace("height = 30.0, ", "", 1).replace("{ turbidity = 3.0 }", "{ turbidity = 30.0, haze = 1.0 }", 1)
    wrong = wrong.replace("Europe/Vienna", "Mars").replace("T12:00", "T99:00") + 'table = "none"\n'
    with pytest.raises(ConfigError) as caught:
        parse(tomllib.loads(ONE_LAYOUT + wrong), "it")
    text = str(caught.value)
    places = "[1].name [0].target [0].sun [0].at.turbidity [0].at.haze [1].sun.time [1].sun.timezone [1].table"
    for path in places.split():
        assert f"$.views{path}" in text
    with pytest.raises(ConfigError, match=r"scene\.mesh"):
        parse(tomllib.loads(ONE_LAYOUT + "[[views]]" + SCENE.split("[[views]]")[1]), "it")


def test_what_shines_by_shadow_rays_is_not_in_the_weights_as_well(tmp_path: Path) -> None:
    """Lamps and disc of a config are taken out of the table's weights, and the ground they light stays."""
    from skylight_sh.run import pictures
    from skylight_sh.store.store import Store

    (tmp_path / "block.obj").write_text(OBJ)
    lamp = '[[scene.lights]]\nkind = "disc"\ndirection = [1.0, 0.0, 1.0]\nhalf_angle = 0.2\nradiance = [9e4, 5e4, 1e4]\n'
    plain = SCENE.replace('ground = "mirror"', "ground = [0.3, 0.2, 0.1]")
    folded = plain.replace("[scene.mesh]", "sun_disc = true\n[scene.mesh]").replace("[[views]]", lamp + "[[views]]", 1)
    # A sun that hardly moves: what is folded in is fitted well.
    few = ONE_LAYOUT.replace("range = [0.0, 1.5707963267948966]", "range = [1.04, 1.06]").split("[[report.cases]]")[0]
    lit = {}
    for name, scene in {"plain": plain, "folded": folded}.items():
        path = tmp_path / f"{name}.toml"
        path.write_text(few + scene)
        config = load(path)
        chosen = pictures._obtained(pictures.steps(config), "select", Store(tmp_path / "store"), print)
        table = Runtime(read_table(chosen, "tables/4-bands-1pct"))
        sun = from_views.sun_of(config.views[0].sun)
        lit[name] = from_views.light_of(config, table, config.views[0], sun)
    without, with_all = lit["plain"].light, lit["folded"].light
    assert len(without.emitters) == 1
    assert len(with_all.emitters) == 2
    # All that is left between them is the sun on the ground.
    on_ground = np.array([0.3, 0.2, 0.1]) * sun_disc.radiance(sun.zenith, 3.0) * np.sin(sun_disc.HALF_ANGLE) ** 2
    left = with_all.weights - without.weights
    expected = (
        on_ground[:, np.newaxis]
        * np.array([math.sqrt(math.pi), 0.0, -0.5 * math.sqrt(3.0 * math.pi)])
        * math.cos(sun.zenith)
    )
    assert np.abs(left[:, [0, 1, 2]] - expected).max() < 0.02 * np.abs(without.weights).max()
    down = np.array([[0.0, 0.0, -1.0]])
    assert with_all.radiance(down) - without.radiance(down) == pytest.approx(
        on_ground[np.newaxis] * math.cos(sun.zenith), rel=1e-3
    )


def test_at_night_lamps_alone_shine(place: Path) -> None:
    """A point above the floor, far below the horizon's sun: its closed form where it is straight below, and no sky."""
    lamp = '[[scene.lights]]\nkind = "point"\ncentre = [3.0, 0.0, 2.0]\nintensity = [8.0, 4.0, 2.0]\n'
    night = SCENE.replace('ground = "mirror"', "twilight = true").replace("[[views]]", lamp + "[[views]]", 1)
    night = night.replace("target = [0.0, 0.0, 0.8]", "target = [3.0, 0.001, 0.0]").replace("bounces = 1", "bounces = 0")
    (place / "night.toml").write_text(ONE_LAYOUT + night)
    made = {}
    for name in ("dark.exr", "dark.png"):
        arguments = ["--store", str(place / "store"), "--sun=-13,0", "--size", "65x65", "--output", str(place / name)]
        done = CliRunner().invoke(main, ["render", str(place / "night.toml"), *arguments])
        assert done.exit_code == 0, done.output
        made[name] = np.asarray(OpenImageIO.ImageBuf(str(place / name)).get_pixels(OpenImageIO.FLOAT), dtype=np.float64)
    # Albedo is the reader's own where a file names none.
    albedo = read(place / "block.obj", None)[0].albedo[0, 0]
    middle = made["dark.exr"][32, 32]
    assert middle[:2] / middle[2] == pytest.approx([4.0, 2.0], rel=1e-5)
    assert middle[0] / (8.0 / 4.0 / math.pi) == pytest.approx(albedo, rel=0.01)
    assert not made["dark.exr"][0].any()
    # Exposed by itself, since there is no sky to expose it by.
    assert 0.05 < made["dark.png"].mean() < 0.6


def test_letters_and_rules() -> None:
    black = np.zeros((30, 60, 3))
    shown = lettering.written(black, "12:05", 10, 5, 1)
    assert shown.sum() / 3 == lettering.dots("12:05").sum()
    assert not black.any()
    assert (lettering.ruled(black, np.array([30]), 3)[:, 29:32] == 1.0).all()
    with pytest.raises(ValueError, match="digits"):
        lettering.dots("noon")
