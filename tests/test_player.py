"""The player on the report's page, in headless Chromium: what it computes, shows, and does when it is touched."""

from __future__ import annotations

import math
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from browser import NO_WEBGL, Browser, browser
from conftest import ROOT, run_quietly, scene_config
from numpy.typing import NDArray
from skylight_sh import runtime, sphere
from skylight_sh.config import load
from skylight_sh.light import colour, sun_disc
from skylight_sh.light.preetham import Preetham
from skylight_sh.mesh.courtyard import MORNING
from skylight_sh.mesh.courtyard import courtyard as made_courtyard
from skylight_sh.quadrature import sun_centred
from skylight_sh.quadrature.least_luminance import refine
from skylight_sh.render import picture, tone
from skylight_sh.render.camera import Camera
from skylight_sh.render.sky import Sky
from skylight_sh.render.surface import Surface
from skylight_sh.report import courtyard
from skylight_sh.run.runner import Result
from skylight_sh.scene import solar
from skylight_sh.studies.courtyard import split
from skylight_sh.transfer import compression

WIDTHS = (320, 360, 768, 1280)
SMALL_CIE = ROOT / "tests" / "small-cie.toml"
TEXTS = """[...document.querySelectorAll('#player *')].filter((element) => element.checkVisibility()
  && [...element.childNodes].some((node) => node.nodeType === 3 && node.data.trim())
  && !/^(script|style|option)$/i.test(element.tagName))"""
# The least contrast of text against what is painted behind it (WCAG 2.2), and the least letters.
LEGIBLE = f"""(() => {{
  const parsed = (text) => text.match(/[\\d.]+/g).map(Number);
  const luminance = (rgb) => rgb.slice(0, 3).map((v) => v / 255)
    .map((v) => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)
    .reduce((sum, v, k) => sum + v * [0.2126, 0.7152, 0.0722][k], 0);
  function behind(element) {{
    for (let at = element; at; at = at.parentElement) {{
      const rgb = parsed(getComputedStyle(at).backgroundColor);
      if (rgb.length < 4 || rgb[3] > 0.5) return rgb;
    }}
    return [255, 255, 255];
  }}
  return {TEXTS}.map((element) => {{
    const style = getComputedStyle(element), [a, b] = [parsed(style.color), behind(element)].map(luminance);
    const size = parseFloat(style.fontSize);
    return [element.textContent.trim().slice(0, 30), (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05), size];
  }});
}})()"""


@pytest.fixture(scope="module")
def window(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Browser]:
    with browser(tmp_path_factory.mktemp("browser")) as running:
        running.size(1280, 800)
        yield running


@pytest.fixture
def page(window: Browser, small_run: Result) -> Browser:
    """The small run's page as it opens; it is opened anew where another test has left it."""
    place = small_run.folder / "index.html"
    window.size(1280, 800)
    window.media()
    if window.place != place or window.run("location.hash") != "":
        window.open(place)
    window.run("skylight.set({ ...(window.first ??= skylight.state()) }), scrollTo(0, 0)")
    return window


def _state(page: Browser) -> dict[str, Any]:
    found: dict[str, Any] = page.run("skylight.state()")
    return found


def _set(page: Browser, **changes: float | str) -> dict[str, Any]:
    found: dict[str, Any] = page.run(f"skylight.set({changes!r})")
    return found


@pytest.mark.tools
def test_it_opens_without_a_request_or_an_error(page: Browser) -> None:
    _set(page, table="3-bands-degrees-6-4-float64", view="open")
    page.frames()
    assert page.errors == []
    assert page.requests
    assert {url.partition(":")[0] for url in page.requests} <= {"file", "data", "blob"}
    assert [url for url in page.requests if url.startswith("file")] == page.requests[:1]
    assert page.run("document.getElementById('player-stage').classList.contains('drawn')")
    assert "…" not in page.run("document.querySelector('#player .readout').textContent")


@pytest.mark.tools
def test_weights_are_those_of_the_runtime(page: Browser, small_run: Result) -> None:
    random = np.random.default_rng(3)
    inputs = random.uniform([0.0, -9.0, 2.5], [np.pi / 2, 9.0, 6.0], (40, 3))
    names = page.run("skylight.tables")
    assert names == [row["name"] for row in small_run.summary["tables"]]
    for row in small_run.summary["tables"]:
        table = runtime.load(small_run.folder / row["path"] / "skylight_sh.npz")
        expected = table.weights(*inputs.T).reshape(len(inputs), -1)
        call = f"skylight.weights({row['name']!r}, ...inputs)"
        found = np.array(page.run(f"{inputs.tolist()}.map((inputs) => [...{call}])"))
        assert np.abs(found - expected).max() <= 2e-6 * np.abs(expected).max(), row["name"]


@pytest.mark.tools
def test_the_live_error_is_that_of_the_rule_that_the_run_believes(page: Browser, small_run: Result) -> None:
    name = small_run.summary["recommended"]
    table = runtime.load(small_run.folder / "export" / "skylight_sh.npz")
    for theta, tau in ((0.3, 2.6), (1.2, 4.0), (1.5, 3.1)):
        at = {"sun_zenith": np.array([[theta]]), "turbidity": np.array([[tau]])}
        found = sun_centred.project(Preetham(), at, nodes=64, harmonics=sphere.Harmonics(4))
        flat = {key: values.ravel() for key, values in at.items()}
        least = refine(Preetham(), flat, found.least_direction.reshape(-1, 3), found.least.ravel())[0]
        off = np.square(table.weights(theta, 0.0, tau) - found.weights[0, 0]).sum(axis=-1)
        _set(page, table=name, sun_zenith=theta, turbidity=tau, bands=4)
        shown = page.run("skylight.errors()")
        assert shown["e_mean"] == pytest.approx(float(np.sqrt(off.max()) / least), rel=2e-3)


@pytest.mark.tools
def test_sun_and_sky_have_the_light_that_the_pipeline_gives_them(page: Browser, small_run: Result) -> None:
    table = runtime.load(small_run.folder / "export" / "skylight_sh.npz")
    for theta, tau in ((0.2, 2.5), (1.1, 3.0), (1.55, 6.0)):
        _set(page, sun_zenith=theta, turbidity=tau)
        shown = page.run("skylight.errors()")
        assert shown["sun_lux"] == pytest.approx(float(sun_disc.normal_illuminance(theta, tau)) * math.cos(theta), rel=1e-6)
        sky = np.sqrt(4.0 * np.pi / 3.0) * table.weights(theta, 0.0, tau)[:, 2] @ colour.luminance_row("srgb")
        assert shown["sky_lux"] == pytest.approx(float(sky), rel=1e-5)


@pytest.mark.tools
def test_the_time_of_day_is_a_real_path(page: Browser) -> None:
    place = solar.Place(48.2, 16.4)
    for minutes in (480, 720, 1020):
        _set(page, latitude=48.2, longitude=16.4, date="2026-05-04", offset=2)
        found = _set(page, minutes=minutes)
        moment = datetime(2026, 5, 4, (minutes // 60) - 2, minutes % 60, tzinfo=UTC)
        zenith, azimuth = solar.position(place, moment)
        assert found["sun_zenith"] == pytest.approx(zenith, abs=math.radians(0.06))
        assert (found["sun_azimuth"] - azimuth + math.pi) % (2 * math.pi) - math.pi == pytest.approx(0.0, abs=3e-4)


@pytest.mark.tools
@pytest.mark.parametrize("name", ["minutes", "height", "sun_azimuth", "turbidity", "bands", "table", "ground", "window"])
@pytest.mark.tools
def test_every_control_moves_what_it_says(page: Browser, name: str) -> None:
    before, seen = _state(page), page.canvas("canvas")
    page.run(
        f"""(() => {{
          const control = document.querySelector('#player [data-key="{name}"]');
          if (control.tagName === 'SELECT') control.selectedIndex += 1;
          else control.value = (+control.min + +control.max) / 2.1;
          control.dispatchEvent(new Event('input', {{ bubbles: true }}));
        }})()"""
    )
    page.frames()
    after = _state(page)
    changed = {key for key in after if after[key] != before[key]}
    wanted = {"minutes": {"minutes", "sun_zenith", "sun_azimuth"}, "height": {"sun_zenith"}}.get(name, {name})
    assert changed == wanted
    assert (page.canvas("canvas") != seen).any() or name == "table"


@pytest.mark.tools
def test_views_differ_and_only_the_sun_casts_shadows(page: Browser) -> None:
    pictures = []
    for value in ("open", "shadowed", "bounces", "sun"):
        page.run(f"document.querySelector('#player [value=\"{value}\"]').click()")
        page.frames()
        assert _state(page)["view"] == value
        pictures.append(page.canvas("canvas").astype(int))
    # Each takes light away or adds it.
    means = [float(picture.mean()) for picture in pictures]
    assert means[0] > means[1] < means[2]
    assert np.abs(pictures[3] - pictures[2]).mean() > 5.0


@pytest.mark.tools
def test_keys_drags_and_buttons_move_the_sun(page: Browser) -> None:
    start = _state(page)
    page.run("document.getElementById('player-stage').focus()")
    page.key("ArrowUp")
    page.key("ArrowLeft", shift=True)
    moved = _state(page)
    assert math.degrees(start["sun_zenith"] - moved["sun_zenith"]) == pytest.approx(1.0)
    assert math.degrees(moved["sun_azimuth"] - start["sun_azimuth"]) == pytest.approx(5.0)
    page.key("2")
    assert _state(page)["bands"] == 2
    box = page.run(
        "(({x, y, width, height}) => [x, y, width, height])(document.getElementById('player-stage').getBoundingClientRect())"
    )
    middle = (box[0] + box[2] / 2, box[1] + box[3] / 2)
    page.drag(middle, (middle[0] + 60, middle[1] - 50))
    dragged = _state(page)
    assert math.degrees(moved["sun_zenith"] - dragged["sun_zenith"]) == pytest.approx(10.0, abs=0.5)
    assert dragged["sun_azimuth"] != moved["sun_azimuth"]
    page.run("document.querySelector('[data-preset*=noon]').click()")
    assert _state(page)["sun_zenith"] < math.radians(35)


@pytest.mark.tools
def test_a_link_restores_the_state(page: Browser, small_run: Result) -> None:
    wanted = _set(page, sun_zenith=0.7, sun_azimuth=2.0, turbidity=4.25, bands=3, view="bounces", window="sinc")
    fragment = page.run("location.hash.slice(1)")
    assert "sun_zenith=0.7" in fragment
    seen = page.canvas("canvas").astype(int)
    page.open(small_run.folder / "index.html", fragment)
    assert _state(page) == wanted
    assert np.abs(page.canvas("canvas").astype(int) - seen).max() <= 1


@pytest.mark.tools
def test_nothing_moves_by_itself(page: Browser) -> None:
    page.media(prefers_reduced_motion="reduce")
    before = page.picture()
    page.run("new Promise((done) => setTimeout(done, 300))")
    assert (page.picture() == before).all()


@pytest.mark.tools
@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.tools
def test_it_fits_every_width_and_is_legible(window: Browser, small_run: Result, scheme: str) -> None:
    window.media(prefers_color_scheme=scheme)
    window.open(small_run.folder / "index.html")
    window.run("document.querySelectorAll('#player details').forEach((one) => { one.open = true; })")
    for width in WIDTHS:
        window.size(width, 800, phone=width < 700)
        window.frames()
        assert window.run("document.scrollingElement.scrollWidth") <= width
        found = window.run(LEGIBLE)
        assert len(found) > 30
        assert [one for one in found if one[1] < 4.5 or one[2] < 11.0] == []
        if width < 700:
            sliders = window.run("[...document.querySelectorAll('#player [type=range]')].map((one) => one.offsetHeight)")
            assert min(sliders) >= 44


@pytest.mark.tools
def test_every_control_has_a_name(page: Browser) -> None:
    unnamed = "[...document.querySelectorAll('#player input, #player select')].filter((one) => !one.labels.length).length"
    assert page.run(unnamed) == 0


@pytest.mark.tools
def test_without_webgl_there_are_the_poster_and_the_weights(small_run: Result, tmp_path: Path) -> None:
    with browser(tmp_path, NO_WEBGL) as page:
        page.size(1280, 800)
        page.open(small_run.folder / "index.html")
        assert page.errors == []
        assert not page.run("document.getElementById('player-stage').classList.contains('drawn')")
        assert len(page.run("[...skylight.weights(skylight.tables[0], 1, 0, 3)]")) == 48
        before = page.canvas("sky")
        _set(page, sun_zenith=0.4)
        assert (page.canvas("sky") != before).any()
        # The poster: an orange wall on its left.
        left = page.picture()[300:600, 50:250].reshape(-1, 3).mean(axis=0)
        assert left[0] > 1.5 * left[2]


SCENES = {
    "one axis, one channel": lambda: load(SMALL_CIE),
    "irradiance": lambda: scene_config('quantity = "irradiance"'),
    "fixed azimuth": lambda: scene_config("azimuth = 0.5"),
    "fixed weather": lambda: scene_config("ground = 'mirror'"),
    "window": lambda: scene_config("window = true"),
    "skyline": lambda: scene_config("horizon = [0.1, 0.3, 0.2]"),
    "twilight": lambda: scene_config("twilight = true"),
}


@pytest.mark.tools
@pytest.mark.parametrize("name", SCENES)
@pytest.mark.tools
def test_other_scenes_have_a_page(window: Browser, tmp_path: Path, name: str) -> None:
    done = run_quietly(SCENES[name](), tmp_path)
    window.size(1280, 800)
    window.open(done.folder / "index.html")
    assert window.errors == []
    first = _state(window)
    assert np.isfinite(window.run("[...skylight.weights(skylight.tables[0], 1, 1, 3)]")).all()
    if "sun_zenith" in first:
        seen = window.canvas("sky")
        _set(window, sun_zenith=0.3)
        assert (window.canvas("sky") != seen).any()
    window.run("document.getElementById('player-engine').open = true")
    for format_ in ("c", "glsl", "json"):
        chosen = f"Object.assign(document.getElementById('player-format'), {{ value: '{format_}' }})"
        window.run(f"{chosen}.dispatchEvent(new Event('input'))")
        assert len(window.run("document.getElementById('player-code').textContent")) > 40
    assert window.errors == []


def test_the_courtyards_file_gives_back_what_was_packed() -> None:
    columns: dict[str, NDArray[np.int64]] = {
        "a": np.array([0, 127, -127, 5]),
        "b": np.array([30000, -30000, 2**20]),
        "c": np.zeros(0, int),
    }
    packed = courtyard.Packed(columns, {"p": b"\x00\xff"}, {"told": [1, 2]})
    found = courtyard.unpack(courtyard.pack(packed))
    assert {name: values.tolist() for name, values in found.columns.items()} == {n: v.tolist() for n, v in columns.items()}
    assert (found.blobs, found.facts) == (packed.blobs, packed.facts)


@pytest.mark.tools
@pytest.mark.parametrize("at", [(1.3788, 0.1745, 3.0), (0.6, -1.1, 4.5)], ids=["morning", "noon"])
def test_the_page_draws_what_the_offline_renderer_does(
    page: Browser, small_run: Result, at: tuple[float, float, float]
) -> None:
    zenith, azimuth, turbidity = at
    table = runtime.load(small_run.folder / "export" / "skylight_sh.npz")
    sky = np.asarray(table.weights(*at), dtype=np.float64)
    sun = float(sun_disc.normal_illuminance(zenith, turbidity)) * math.cos(zenith)
    lux = float(np.sqrt(4.0 * np.pi / 3.0) * sky[:, 2] @ tone.LUMINANCE) + sun
    found = courtyard.unpack(courtyard.shipped())
    bands, count = found.facts["bands"], found.facts["components"]
    components = np.stack([found.columns[f"component_{k}"] for k in range(count)], axis=-1)
    matrix = found.columns["matrix"].reshape(count + 1, -1) * np.array(found.facts["scales"])[:, np.newaxis]
    weights = np.zeros((3, bands**2))
    weights[:, : sky.shape[1]] = sphere.mirror_ground(sky, 4)
    lit = compression.lit(compression.Compressed(components.astype(np.int8), matrix), weights, np.zeros_like(weights))
    mesh = made_courtyard()
    seen, _ = split(mesh, MORNING)
    values = np.zeros((len(mesh.positions), 3))
    values[np.unique(mesh.triangles[seen])] = lit
    behind = Sky(Preetham(), {"sun_zenith": zenith, "turbidity": turbidity}, azimuth, below="mirror").radiance
    view = MORNING.view
    camera = Camera(view.eye, view.target, view.field, 640, 360)
    sampling = picture.Sampling(pixel=8)
    taken = picture.take(camera, Surface(mesh), lambda points, _: points.interpolate(values), behind, [], sampling)
    expected = 255.0 * tone.display(taken.radiance, tone.exposure(lux))
    _set(page, sun_zenith=zenith, sun_azimuth=azimuth, turbidity=turbidity, bands=4, view="bounces")
    drawn = page.canvas("canvas")
    assert drawn.shape == expected.shape
    off = np.abs(drawn - expected).max(axis=-1)
    assert np.median(off) <= 1.0
    assert np.percentile(off, 95.0) <= 4.0
