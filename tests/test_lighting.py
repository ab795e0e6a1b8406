"""What light on surfaces really loses: against direct integration, closed forms, and the bound that E_mean gives."""

from __future__ import annotations

import csv
import tomllib
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from conftest import SMALL, run_quietly
from numpy.typing import NDArray
from skylight_sh import runtime, sphere
from skylight_sh.config import Config, parse
from skylight_sh.light.preetham import Preetham
from skylight_sh.mesh.courtyard import ENTRANCE, courtyard
from skylight_sh.quadrature import parameter_points
from skylight_sh.render.metrics import relative_rmse
from skylight_sh.render.surface import Surface
from skylight_sh.render.view import View
from skylight_sh.run.stages import lighting as stage
from skylight_sh.studies.lighting.__main__ import main
from skylight_sh.table import lighting
from skylight_sh.transfer import Options, precompute

Array = NDArray[np.float64]


def small(**scene: Any) -> Config:
    """tests/small.toml with few pictures and such a scene."""
    raw = tomllib.loads(SMALL.read_text(encoding="utf-8"))
    raw["report"] = {"figures": ["lighting_error"]}
    raw["scene"] = scene
    return parse(raw, "a config")


def quiet(_: int, __: int) -> None:
    """Tell nobody."""


def received(config: Config, values: Array, normal: Array) -> Array:
    """The irradiance ``(channels,)`` of the sky itself, by a midpoint rule over the upper hemisphere."""
    rows, columns = 400, 1600
    height = (np.arange(rows) + 0.5) / rows
    azimuth = 2 * np.pi * (np.arange(columns) + 0.5) / columns
    flat = np.sqrt(1 - height**2)[:, np.newaxis]
    up = np.broadcast_to(height[:, np.newaxis], (rows, columns))
    towards = np.stack([flat * np.cos(azimuth), flat * np.sin(azimuth), up], axis=-1)
    names = [axis.name for axis in config.axes]
    radiance = config.source.radiance(towards, {n: np.array([v]) for n, v in zip(names, values, strict=True)})
    facing = np.maximum(towards @ normal, 0.0)
    return np.einsum("rpc,rp->c", radiance, facing) * (2 * np.pi / (rows * columns))


def test_irradiance_of_32_bands_is_that_of_the_sky_itself(under: lighting.Surfaces) -> None:
    config, light = small(), under.light
    normals = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.6, 0.0, 0.8], [0.0, -0.8, 0.6]])
    found = lighting.irradiance(under.whole, normals)
    for at in (0, 200, 513, len(light.parameters) - 1):
        for n, normal in enumerate(normals):
            expected = received(config, light.parameters[at], normal)
            assert np.abs(found[at, :, n] / expected - 1).max() < 4e-4


def test_sets_are_new_ones(under: lighting.Surfaces) -> None:
    """Not those of the published errors."""
    light = under.light
    ranges = [axis.range for axis in small().axes]
    held_out = parameter_points.held_out(ranges, 2000, 128, 1959)
    inner = light.parameters[:512]
    assert len(inner) == len(np.unique(inner, axis=0)) == 512
    assert not {tuple(row) for row in inner.tolist()} & {tuple(row) for row in held_out.tolist()}


@pytest.fixture(scope="module")
def under() -> lighting.Surfaces:
    """Surfaces below the small config's sky."""
    return stage.surfaces_of(small(), quiet)


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Config]:
    """A run of the small config that shows what surfaces lose."""
    place = tmp_path_factory.mktemp("lit")
    config = small()
    run_quietly(config, place)
    return place, config


def test_no_surface_loses_more_than_its_error_allows(made: tuple[Path, Config], under: lighting.Surfaces) -> None:
    place, on = made[0], under
    for path in sorted((place / "reports" / "small" / "export").rglob("*.npz")):
        found = lighting.measure(runtime.read(path), on)
        assert found.bound is not None
        assert np.all(found.table.local <= found.bound * (1 + 1e-4))
        # It is no idle bound either.
        assert (found.table.local / found.bound).max() > 0.1
        assert np.all(found.table.of_largest <= found.table.of_least)


def test_the_bound_is_met_where_an_error_is_a_clamped_cosine() -> None:
    """Cauchy and Schwarz: an even sky, off by the cosine about a wall's normal, the wall that receives least."""
    bands, size, level = 7, 1e-3, 1.0
    wall = np.array([1.0, 0.0, 0.0])
    kernel = sphere.aim(sphere.clamped_cosine(bands) * np.sqrt((2 * np.arange(bands) + 1) / (4 * np.pi)), wall)
    off = size * kernel / np.linalg.norm(kernel)
    error = lighting.irradiance(off, wall[np.newaxis])[0]
    # A wall below an even sky of radiance 1 receives pi / 2.
    assert abs(error / (np.pi / 2) - lighting.promise(bands) * size / level) < 1e-12


def test_what_is_lost_of_a_known_error(made: tuple[Path, Config], under: lighting.Surfaces) -> None:
    """A table whose weights are all 1 % too large loses 1 % everywhere; more bands only change what bands lose."""
    (place, config), on = made, under
    table = runtime.read(place / "reports" / "small" / "export" / "skylight_sh.npz")
    assert isinstance(table.body, runtime.ClassRows)
    larger = replace(table, body=replace(table.body, rows=table.body.rows * table.body.rows.dtype.type(1.01)))
    plain, brighter = (lighting.measure(t, on) for t in (table, larger))
    towards = lighting.normals()
    whole = on.whole
    true = np.einsum("ncd,c->nd", lighting.irradiance(whole, towards), config.source.luminance_row)
    cut = np.einsum("ncd,c->nd", lighting.irradiance(whole[..., : table.bands**2], towards), config.source.luminance_row)
    up = towards[:, 2] >= 0
    expected = (0.01 * cut / true)[:, up].max(axis=1)
    assert np.abs(brighter.table.local - expected).max() < 1.05 * plain.table.local.max()
    assert np.array_equal(plain.bands.local, brighter.bands.local)
    assert np.allclose(plain.bands.local, (np.abs(cut - true) / true)[:, up].max(axis=1), rtol=1e-12)


def test_too_few_bands_of_light(made: tuple[Path, Config], under: lighting.Surfaces) -> None:
    place, config = made
    table = runtime.read(place / "reports" / "small" / "export" / "skylight_sh.npz")
    few = under.light.windowed(2, np.ones(3))
    with pytest.raises(ValueError, match="The light has 2 bands, the table 4"):
        lighting.measure(table, lighting.surfaces(few, config.source.luminance_row))


@pytest.mark.parametrize(
    "scene", [{"quantity": "irradiance", "window": True}, {"ground": [0.2, 0.3, 0.4], "sun_disc": True}]
)
def test_the_light_itself_loses_nothing(scene: dict[str, Any]) -> None:
    """Its own first bands are no error of a table, whatever a scene folds in."""
    config = small(**scene)
    on = stage.surfaces_of(config, quiet)
    window = sphere.zonal_sinc(3) if "window" in scene else np.ones(9)
    found = lighting.beside(on.whole[..., :9] * window, on, windowed="window" in scene)
    assert max(found.table.local.max(), found.channel.of_least.max()) < 1e-12
    assert found.bands.local.max() > 1e-3


def test_what_a_picture_loses_is_what_rendering_it_twice_tells(made: tuple[Path, Config], under: lighting.Surfaces) -> None:
    """A picture by the table and one by true weights, pixel by pixel, at a sun of the held-out sets."""
    place, _ = made
    table = runtime.read(place / "reports" / "small" / "export" / "skylight_sh.npz")
    surface = Surface(courtyard(0.25))
    transfer = precompute(surface.mesh, Options(4, 64, 16, 2)).transfer
    view = View(surface, ENTRANCE.eye, ENTRANCE.target, ENTRANCE.field, width=96, height=54, side=1)
    found = stage.of_picture(stage.picture_form(4), table, under)
    for at in (0, 300):
        errors = []
        for azimuth in np.radians([20.0, 110.0, 200.0, 290.0]):
            own = table.whole(table.evaluate(under.light.parameters[[at]]))[0].astype(np.float64)
            pictures = [
                view.points.albedo * view.points.interpolate(np.einsum("vcw,cw->vc", transfer, weights))
                for weights in (sphere.rotate_azimuth(part, azimuth) for part in (own, under.whole[at][:, :16]))
            ]
            errors.append(relative_rmse(*pictures))
        assert found[at] == pytest.approx(max(errors), rel=1e-6)


def test_pictures_of_one_channel_and_of_irradiance(made: tuple[Path, Config], under: lighting.Surfaces) -> None:
    """One channel lights the form's second; irradiance is taken back to radiance, but for what it has lost."""
    form = np.tile(np.eye(16), (3, 1, 1)) * np.array([1.0, 4.0, 9.0])[:, np.newaxis, np.newaxis]
    luminance = np.einsum("scw,c->sw", under.whole[..., :16], Preetham().luminance_row)[:, np.newaxis]
    off = 0.01 * luminance * np.arange(16)
    expected = np.linalg.norm(off[:, 0], axis=1) / np.linalg.norm(luminance[:, 0], axis=1)
    assert stage.in_picture(form, off, luminance) == pytest.approx(expected)
    table = runtime.read(made[0] / "reports" / "small" / "export" / "skylight_sh.npz")
    dark = replace(table, spec=replace(table.spec, quantity="irradiance"))
    # Degree 3 has no irradiance; the others are as before.
    keep = sphere.Harmonics(4).degrees != 3
    own = np.asarray(table.whole(table.evaluate(under.light.parameters)), dtype=np.float64)
    factors = sphere.clamped_cosine(4)[sphere.Harmonics(4).degrees]
    taken = np.where(keep, 1.0, 0.0) / np.where(keep, factors, 1.0)
    parts = (own - under.whole[..., :16]) * taken, under.whole[..., :16] * taken
    assert stage.of_picture(form, dark, under) == pytest.approx(stage.in_picture(form, *parts))


def test_the_report_shows_it(made: tuple[Path, Config]) -> None:
    place, _ = made
    folder = place / "reports" / "small"
    assert (folder / "figures" / "lighting_error.png").read_bytes().startswith(b"\x89PNG")
    assert "no better table mends" in (folder / "index.html").read_text(encoding="utf-8")


def test_the_study_writes_a_row_a_table(made: tuple[Path, Config], tmp_path: Path) -> None:
    place, config = made
    path = tmp_path / "small.toml"
    path.write_text(SMALL.read_text(encoding="utf-8").replace('figures = ["bands"]', "figures = []"), encoding="utf-8")
    arguments = [str(path), "--store", str(place / "artifacts"), "--reports", str(tmp_path / "reports")]
    shown = CliRunner().invoke(main, arguments, catch_exceptions=False)
    assert shown.exit_code == 0
    with (tmp_path / "reports" / "small" / "lighting" / "lighting.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    names = [f"{winner.bands}" for winner in config.winners]
    assert len(rows) == 5
    assert names
    for row in rows:
        # What is lost lies below what the published E_mean of other sets allows, a few per cent aside.
        assert float(row["half of the sets"]) <= float(row["irradiance"]) < 1.05 * float(row["E_mean allows"])
        assert float(row["of largest"]) < float(row["of least"])
        # A picture loses no more than the worst of its surfaces' light would, several times over.
        assert 0 < float(row["half of the sets, picture"]) <= float(row["picture"]) < float(row["E_mean"])
