"""The report's pictures of scenes: each drawn from a tiny run, its values against independent computation."""

from __future__ import annotations

import csv
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import ROOT, run_quietly
from markupsafe import escape
from numpy.typing import NDArray
from skylight_sh import sphere
from skylight_sh.config import Config, ConfigError, load, parse
from skylight_sh.config.extending import read
from skylight_sh.light import spherical_lights
from skylight_sh.light.preetham import Preetham
from skylight_sh.mesh import Mesh, Part
from skylight_sh.render import compared
from skylight_sh.render.brute_force import Source
from skylight_sh.render.emitters import Disc
from skylight_sh.render.surface import Surface
from skylight_sh.render.view import View
from skylight_sh.report import panels, style
from skylight_sh.report.figures import PICTURES, SCENES, error_sources
from skylight_sh.run import plan
from skylight_sh.run import scene_suns as suns
from skylight_sh.run.stages import courtyard as courtyard_stage
from skylight_sh.run.stages import relief, ten_lights
from skylight_sh.run.steps import steps
from skylight_sh.store.store import Store
from skylight_sh.transfer import Options, precompute

Array = NDArray[np.float64]
CONFIG = ROOT / "configs" / "papers-scenes.toml"
FIGURES = sorted(SCENES)
UP = np.array([0.0, 0.0, 1.0])


def tiny(**scenes: int) -> Config:
    """The shipped config over tests/small.toml's few samples, with pictures of few pixels and rays."""
    raw = read(ROOT / "tests" / "small.toml")
    raw["name"], raw["truth"]["bands"] = "tiny", 7
    raw["winners"] = [{"bands": 7, "budgets": [0.02]}, {"bands": 3, "budgets": [0.1], "layouts": ["packed"]}]
    raw["export"] = {"recommended": "7-bands-2pct"}
    raw["fit"] = {}
    raw["report"] = {"figures": FIGURES, "scenes": {"width": 16, "paths": 512, "rays": 128, "bounces": 2, **scenes}}
    return parse(raw, "a config", ROOT)


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[Path, Config]]:
    """A tiny run with every picture, of a floor with a wall, as large as the courtyard and in its place."""
    place, config = tmp_path_factory.mktemp("scenes"), tiny()
    with pytest.MonkeyPatch.context() as patch:
        for stage in (courtyard_stage, ten_lights, relief):
            patch.setattr(stage, "courtyard", lambda: turned_to_the_west(box(), 4.0))
        run_quietly(config, place)
        yield place, config


def artifact(made: tuple[Path, Config], name: str) -> dict[str, NDArray[Any]]:
    place, config = made
    stage, _, _ = name.partition("/")
    found = Store(place / "artifacts").get(stage, plan.keys(steps(config))[name], name)
    return {key: variable.data for key, variable in found.variables.items()}


def rows(path: Path) -> list[dict[str, str]]:
    with path.open(encoding="utf-8") as file:
        return list(csv.DictReader(file))


def test_every_picture_is_drawn_with_its_numbers(made: tuple[Path, Config]) -> None:
    folder = made[0] / "reports" / "tiny"
    page = (folder / "index.html").read_text(encoding="utf-8")
    for name in FIGURES:
        assert (folder / "figures" / f"{name}.png").read_bytes().startswith(b"\x89PNG")
        assert str(escape(PICTURES[name].title)) in page
    for name, count in (("daylight_scene", 6), ("interreflection", 9), ("spherical_lights", 8), ("normal_map", 4)):
        found = rows(folder / f"{name}.csv")
        assert len(found) == count
        assert all(0 <= float(row["flip"]) < 1 and float(row["relative_rmse"]) >= 0 for row in found)


def test_workers_change_no_byte(made: tuple[Path, Config]) -> None:
    """One of them instead of as many as there are cores."""
    config = made[1].model_copy(update={"run": made[1].run.model_copy(update={"workers": 1})})
    place = Store(made[0] / "artifacts")
    names = plan.keys(steps(made[1]))
    select = {"select": place.get("select", names["select"], "select")}
    for step in steps(config):
        if step.stage == "pictures":
            inputs = {name: place.get(name.partition("/")[0], names[name], name) for name in step.inputs}
            again = step.make({**select, **inputs}, lambda *_: None)
            for name, values in artifact(made, step.name).items():
                assert np.array_equal(again[name], values), (step.name, name)


def test_errors_are_in_their_order(made: tuple[Path, Config]) -> None:
    """What must hold of any picture, however noisy: the table is the least of it, shadows are the most."""
    found = artifact(made, "pictures/courtyard")
    error = dict(zip(found["sources/source"].astype(str), found["sources/error"], strict=True))
    assert error["table"].max() < 0.1 * error["vertices"].min()
    assert error["table"].max() < 2e-3
    assert np.all(error["3 bands"] > error["smallest table"])
    assert np.all(error["no shadows"] > error["table"])
    assert found["sources/height"].tolist() == [52.0, 10.0, 2.0]


def test_errors_of_spherical_lights_fall_with_bands(made: tuple[Path, Config]) -> None:
    found = artifact(made, "pictures/ten_lights")
    for name in ("diffuse", "glossy"):
        assert found[f"{name}/bands"].tolist() == [3, 5, 7, 10]
        assert np.all(np.diff(found[f"{name}/error"]) < 0)
    assert np.all(found["glossy/error"] > found["diffuse/error"])


def test_a_report_without_them_computes_none_of_it() -> None:
    names = [step.name for step in steps(load(ROOT / "configs" / "preetham.toml"))]
    assert not [name for name in names if name.startswith("pictures/")]
    shown = [step.name for step in steps(load(CONFIG))]
    every = ["pictures/courtyard", "pictures/ten_lights", "pictures/relief"]
    assert [name for name in shown if name.startswith("pictures/")] == every


def test_settings_of_other_configs_are_as_they_were() -> None:
    from skylight_sh.run.provenance import settings

    assert "scenes" not in settings(load(ROOT / "configs" / "preetham.toml"))["report"]
    assert settings(load(CONFIG))["report"]["scenes"]["width"] == 256


def test_letters_are_legible_on_a_phone() -> None:
    """No letter is below 11 pixels where the whole figure is shown 360 wide, and none runs out of it."""
    picture = np.full((9, 16, 3), 0.5)
    told = "3, 5, 7 bands: 0.48, 0.18, 0.092 %; FLIP .164, .108, .088"
    drawn = [
        panels.draw([panels.Row((("10 bands 0.25 %, FLIP .011", picture), ("brute force", picture)), told)]),
        error_sources.bars(["smallest table", "no bounces"], {f"sun {k}°": np.array([3e-5, 0.5]) for k in (52, 10, 2)}),
    ]
    for figure in drawn:
        style.png(figure)
        scale = 360.0 / (figure.get_figwidth() * figure.dpi)
        texts = [text for text in figure.findobj(lambda a: hasattr(a, "get_fontsize")) if text.get_text()]
        assert texts
        for text in texts:
            assert text.get_fontsize() * figure.dpi / 72.0 * scale >= 11.0 - 1e-6, text.get_text()
            place = text.get_window_extent()
            assert place.x0 >= -1.0, text.get_text()
            assert place.x1 <= figure.bbox.x1 + 1.0, text.get_text()


def test_numbers_in_few_letters() -> None:
    assert panels.measured(0.0368, 0.0457) == "3.7 %, FLIP .046"
    found = {
        "x/bands": np.array([3, 5, 7]),
        "x/error": np.array([0.1234, 0.04, 0.00456]),
        "x/flip": np.array([0.1, 0.05, 0.004]),
    }
    assert panels.fewer(found, "x") == "3, 5, 7 bands: 12, 4, 0.46 %; FLIP .100, .050, .004"


def test_bars_are_as_long_as_their_errors() -> None:
    errors = {"sun 52°": np.array([1e-5, 0.4]), "sun 2°": np.array([3e-4, 0.5])}
    figure = error_sources.bars(["table", "no shadows"], errors)
    panel = figure.axes[0]
    ends = [patch.get_x() + patch.get_width() for patch in panel.patches]
    assert ends == pytest.approx([1e-5, 0.4, 3e-4, 0.5])
    assert panel.get_xscale() == "log"
    assert {text.get_text() for text in panel.texts} == {"0.001", "40", "0.03", "50"}


def test_weights_of_a_sun_are_those_of_its_sky() -> None:
    """Turned into its azimuth, against a sum over directions; the table's within its own error."""
    config = tiny()
    sun = suns.SUNS[1]
    sky = suns.sky_of(config, {}, sun, 4)
    rows_, columns = 300, 600
    height, azimuth = (np.arange(rows_) + 0.5) / rows_, 2 * np.pi * (np.arange(columns) + 0.5) / columns
    flat = np.sqrt(1 - height**2)[:, np.newaxis]
    up = np.broadcast_to(height[:, np.newaxis], (rows_, columns))
    along = np.stack([flat * np.cos(azimuth), flat * np.sin(azimuth), up], axis=-1).reshape(-1, 3)
    radiance = sky.source.radiance(along)
    expected = 2 * np.pi / len(along) * radiance.T @ sphere.basis(along, 4)
    assert np.abs(sky.true - expected).max() < 2e-3 * np.abs(expected).max()
    # The brightest direction is the sun's.
    brightest = along[(radiance @ Preetham().luminance_row).argmax()]
    towards = np.array([np.cos(np.radians(sun.azimuth)), np.sin(np.radians(sun.azimuth))])
    assert brightest[:2] @ towards > 0.99 * np.linalg.norm(brightest[:2])
    assert float(suns.falling(sky.true) @ Preetham().luminance_row) == pytest.approx(
        float(np.sum(along[:, 2] * (radiance @ Preetham().luminance_row)) * 2 * np.pi / len(along)), rel=1e-3
    )


def test_lux_of_a_disc() -> None:
    disc = suns.disc_of(tiny(), suns.SUNS[0])
    from skylight_sh.light import sun_disc

    expected = sun_disc.normal_illuminance(np.radians(38.0), 3.0) * np.cos(np.radians(38.0))
    assert float(suns.falling_from(disc) @ Preetham().luminance_row) == pytest.approx(float(expected), rel=1e-3)


def box() -> Mesh:
    """A floor of 4 x 4 and a low wall beside it, in quads of 0.25."""
    n = 17
    side = np.linspace(-2.0, 2.0, n)
    x, y = (grid.ravel() for grid in np.meshgrid(side, side, indexing="ij"))
    z = np.linspace(0.0, 1.0, n)
    wx, wz = (grid.ravel() for grid in np.meshgrid(side, z, indexing="ij"))
    positions = np.concatenate([np.stack([x, y, 0 * x], -1), np.stack([wx, np.full(wx.size, 2.001), wz], -1)])
    normals = np.concatenate([np.tile(UP, (x.size, 1)), np.tile([0.0, -1.0, 0.0], (wx.size, 1))])
    index = np.arange(n * n).reshape(n, n)
    a, b, c, d = (part.ravel() for part in (index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]))
    quads = np.concatenate([np.stack([a, b, c], -1), np.stack([a, c, d], -1)])
    triangles = np.concatenate([quads, quads + n * n])
    albedo = np.concatenate([np.tile([0.6, 0.5, 0.4], (x.size, 1)), np.tile([0.8, 0.2, 0.1], (wx.size, 1))])
    part = np.repeat([0, 1], len(quads))
    return Mesh(positions, normals, albedo, triangles, part, (Part("floor"), Part("wall")), np.zeros((len(positions), 2)))


def turned_to_the_west(mesh: Mesh, scale: float) -> Mesh:
    """The mesh, larger, its wall at x = -6 as the courtyard's."""
    turn = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    places = scale * mesh.positions @ turn.T
    shift = np.array([-6.0 - places[:, 0].min(), 0.0, 0.0])
    return replace(mesh, positions=places + shift, normals=mesh.normals @ turn.T)


def test_transfer_and_paths_agree_where_bands_are_no_limit() -> None:
    """Under a sky of two bands alone transfer loses nothing but its sampling: direct, bounced, and unshadowed."""
    weights = np.zeros((3, 49))
    weights[:, 0], weights[:, 2], weights[:, 3] = 2.0, (0.5, 0.7, 0.9), (0.8, 0.2, 0.1)

    def radiance(along: Array) -> Array:
        return np.asarray(sphere.evaluate(weights, along).T)

    surface = Surface(box())
    options = Options(7, 1024, 1024, 2, 3)
    on = compared.scene(surface, precompute(surface.mesh, options), options)
    view = View(surface, (0.3, -6.0, 3.0), (0.0, 0.0, 0.2), 35.0, width=16, height=9, side=1)
    # Nothing here looks below the horizon, where paths see black and the expansion does not.
    points = view.points.some(view.points.positions[:, 2] < 1e-6)
    sky = compared.Sky(Source(radiance), weights, {"table": 1.01 * weights[:, :25]})
    through = compared.through_transfer(on, points, [sky], (3, 5, 7), first=0)
    paths = compared.by_paths(on, points, [sky.source], count=4096, first=0)
    size = paths["interreflected"].max()
    for bands in (3, 7):
        assert rms(through[f"points {bands}"] - paths["interreflected"]) < 0.01 * size
        assert rms(through[f"interreflected {bands}"] / 1.01 - paths["interreflected"]) < 0.03 * size
        assert rms(through[f"shadowed {bands}"] / 1.01 - paths["shadowed"]) < 0.03 * size
    # The floor sees the upper half alone, which paths see too.
    assert rms(through["unshadowed 3"] / 1.01 - paths["unshadowed"]) < 0.005 * size
    assert np.abs(through["table"] - 0.01 * through["true"]).max() < 1e-12
    assert np.abs(through["sampling"]).max() < 0.02 * size


def rms(values: Array) -> float:
    return float(np.sqrt(np.mean(np.square(values))))


def test_the_suns_light_is_sent_on_alike() -> None:
    """By the matrix of transfer and by paths."""
    surface = Surface(box())
    options = Options(3, 64, 1024, 2, 3)
    on = compared.scene(surface, precompute(surface.mesh, options), options)
    towards = np.array([0.0, -0.6, 0.8])
    disc = Disc(towards, 0.005, np.full(3, 1e5))
    view = View(surface, (0.3, -6.0, 3.0), (0.0, 0.0, 0.2), 35.0, width=16, height=9, side=1)
    found = view.points.interpolate(compared.sent_on(on, [disc]))
    paths = compared.by_paths(on, view.points, [Source(np.zeros_like, [disc])], count=4096, first=0)["interreflected"][0]
    assert np.sqrt(np.mean((found - paths) ** 2) / np.mean(paths**2)) < 0.06


def test_a_view_averages_its_samples() -> None:
    surface = Surface(box())
    view = View(surface, (0.0, -6.0, 2.0), (0.0, 0.0, 0.5), 40.0, width=12, height=8, side=3)
    assert view.along.shape == (12 * 8 * 9, 3)
    picture = view.picture(np.ones((len(view.points.positions), 3)), np.full((int((~view.seen).sum()), 3), 3.0))
    share = view.seen.reshape(8, 3, 12, 3).mean(axis=(1, 3))
    assert picture == pytest.approx(np.repeat((share + 3 * (1 - share))[..., np.newaxis], 3, axis=2))
    assert np.array_equal(view.shown, share > 0)


def test_lights_are_seen_where_they_stand() -> None:
    """Against a ray's distance to a centre."""
    from skylight_sh.reflectance.spheres import Spheres

    surface = Surface(box())
    view = View(surface, (0.0, -6.0, 2.0), (0.0, 0.0, 0.5), 40.0, width=32, height=18)
    centres = np.array([[0.0, 0.0, 0.5], [0.5, 4.0, 0.4]])
    lights = Spheres(centres, np.array([0.3, 0.2]), np.array([[1.0, 2.0, 3.0], [4.0, 4.0, 4.0]]))
    seen, before = ten_lights.seen_lights(view, lights)
    apart = np.linalg.norm(np.cross(view.along, centres[0] - view.eye), axis=1)
    assert np.array_equal(before, apart < 0.3)
    assert np.array_equal(seen[before][0], [1.0, 2.0, 3.0])
    # The second stands behind the wall.
    assert not (seen == 4.0).any()


def test_no_light_of_the_ten_stands_in_the_masonry() -> None:
    from skylight_sh.mesh.courtyard import courtyard

    positions = courtyard().positions
    for centre, radius, _ in ten_lights._LIGHTS:
        assert np.linalg.norm(positions - np.array(centre), axis=1).min() > radius
        # Half-angles are those of spheres.
        angle, _ = spherical_lights.half_angles(np.array(centre), radius, positions)
        assert angle.max() < np.pi / 2


def test_bricks_are_unit_normals_that_look_outwards() -> None:
    normals, albedo = relief.bricks(128, 72)
    assert np.linalg.norm(normals, axis=-1) == pytest.approx(np.ones((72, 128)))
    assert normals[..., 2].min() > 0.3
    # They are no plane: most lean by degrees.
    assert np.degrees(np.arccos(normals[..., 2])).mean() > 3
    assert 0 < albedo.min() < albedo.max() < 1


def test_the_wall_is_the_courtyards() -> None:
    """Its texels lie on the mesh's western wall, seen upright, north on the right."""
    from skylight_sh.mesh.courtyard import courtyard

    texels = relief.wall(8, 4)
    assert texels.points[0, 0, 2] > texels.points[-1, 0, 2]
    assert texels.points[0, 0, 1] < texels.points[0, -1, 1]
    surface = Surface(courtyard())
    points = texels.points.reshape(-1, 3) + np.array([0.05, 0.0, 0.0])
    hits = surface.rays.nearest(points, np.broadcast_to([-1.0, 0.0, 0.0], points.shape))
    assert hits.distance == pytest.approx(np.full(len(points), 0.05), abs=1e-3)
    assert texels.frames[0, 0].tolist() == [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]]
    assert np.array_equal(relief.wall(8, 4, 2).points[0], texels.points[2])


@pytest.mark.parametrize(
    ("edit", "told"),
    [
        ({"scene": {"quantity": "irradiance"}}, "radiance above a black ground"),
        ({"scene": {"ground": "mirror"}}, "radiance above a black ground"),
        ({"scene": {"window": True}}, "radiance above a black ground"),
        ({"export": {"recommended": "3-bands-10pct-packed"}}, "7 bands"),
        ({"light": {"model": "cie-general", "sky": 12}}, "preetham"),
    ],
)
def test_what_a_scene_cannot_show_is_told(edit: dict[str, Any], told: str) -> None:
    raw = tiny().model_dump(mode="json")
    raw["scene"].pop("mesh")
    for section, keys in edit.items():
        raw[section] = keys if section == "light" else {**raw[section], **keys}
    with pytest.raises(ConfigError, match=told):
        parse(raw, "a config", ROOT)


def test_a_lower_sun_than_the_axis_has_is_told() -> None:
    raw = read(ROOT / "tests" / "small.toml")
    raw["report"] = {"figures": ["daylight_scene"]}
    raw["axes"][0]["range"] = [0.0, 1.2]
    raw["report"]["cases"] = []
    with pytest.raises(ConfigError, match="suns 38 to 88 degrees"):
        parse(raw, "a config", ROOT)
