"""Scene profiles: what is folded in equals what would have been done at run time, and what is excluded is not computed."""

from __future__ import annotations

import math
import re
import subprocess
import tomllib
from pathlib import Path

import numpy as np
import pytest
from conftest import ONE_LAYOUT, ROOT, run_quietly, scene_config
from numpy.typing import NDArray
from skylight_sh import runtime, sphere
from skylight_sh.config import Config, ConfigError, load, parse
from skylight_sh.run.runner import Result
from skylight_sh.run.steps import shows_origins
from skylight_sh.scene.solar import zenith_range
from skylight_sh.store.store import Store
from skylight_sh.studies.grid_samples import sample
from skylight_sh.studies.published import exported
from skylight_sh.studies.stability import edges
from skylight_sh.table.errors import headline
from test_export import STRICT

Array = NDArray[np.float64]
TEXT = ONE_LAYOUT.replace("[0.05, 0.01]", "[0.01]")
SUNS = np.array([[0.1, 0.3, 2.6], [0.9, -2.0, 4.0], [1.5, 5.0, 5.9]])


def config_of(folder: Path, scene: str, *edits: tuple[str, str]) -> Config:
    text = TEXT
    for old, new in edits:
        assert old in text
        text = text.replace(old, new)
    return scene_config(scene, text, folder)


def loaded(result: Result) -> runtime.Runtime:
    return runtime.load(result.folder / "export" / "skylight_sh.npz")


def close(got: Array, expected: Array, share: float = 0.002) -> None:
    assert np.abs(got - expected).max() < share * np.abs(expected).max()


@pytest.fixture(scope="module")
def plain(tmp_path_factory: pytest.TempPathFactory) -> runtime.Runtime:
    place = tmp_path_factory.mktemp("plain")
    (place / "plain.toml").write_text(TEXT, encoding="utf-8")
    return loaded(run_quietly(load(place / "plain.toml"), place))


@pytest.mark.parametrize("bands", [4, 2])
def test_irradiance_is_the_clamped_cosine_of_radiance(tmp_path: Path, plain: runtime.Runtime, bands: int) -> None:
    folded = loaded(run_quietly(config_of(tmp_path, 'quantity = "irradiance"'), tmp_path))
    degrees = sphere.Harmonics(bands).degrees
    got, radiance = folded.weights(*SUNS.T, bands=bands), plain.weights(*SUNS.T, bands=bands)
    close(got, radiance * sphere.clamped_cosine(bands)[degrees])
    # l = 3 carries nothing and has no columns.
    assert not got[..., degrees == 3].any()
    kept = folded.table.body.columns >= 0
    assert set(sphere.Harmonics.even(folded.table.bands).degrees[kept].tolist()) == {0, 1, 2}


def test_window_is_folded_and_follows_the_bands(tmp_path: Path, plain: runtime.Runtime) -> None:
    result = run_quietly(config_of(tmp_path, "window = true"), tmp_path)
    folded = loaded(result)
    for bands in (4, 3):
        close(folded.weights(*SUNS.T, bands=bands), plain.weights(*SUNS.T, bands=bands, window=True))
    with pytest.raises(ValueError, match="already"):
        folded.weights(*SUNS.T, window=True)
    assert "_window(int bands" not in (result.folder / "export" / "skylight_sh.h").read_text(encoding="utf-8")


def test_a_fixed_azimuth_is_no_input(tmp_path: Path, plain: runtime.Runtime) -> None:
    folded = loaded(run_quietly(config_of(tmp_path, "azimuth = 0.7"), tmp_path))
    assert folded.inputs == ("sun_zenith", "turbidity")
    close(folded.weights(SUNS[:, 0], SUNS[:, 2]), plain.weights(SUNS[:, 0], 0.7, SUNS[:, 2]))


def test_luminance_is_the_colours_luminance(tmp_path: Path, plain: runtime.Runtime) -> None:
    config = config_of(tmp_path, 'channels = "luminance"')
    result = run_quietly(config, tmp_path)
    row = config.light.luminance_row
    close(loaded(result).weights(*SUNS.T)[:, 0], np.einsum("c,ncw->nw", row, plain.weights(*SUNS.T)))
    store = Store(tmp_path / "artifacts")
    shapes = {
        store.get(e.stage, e.key)["weights"].shape[-2] for e in store.entries() if e.stage == "truth" and e.size > 9000
    }
    assert shapes == {1}


WITHOUT_TURBIDITY = (
    TEXT[TEXT.index('[[axes]]\nname = "turbidity"') : TEXT.index("[truth]")],
    "",
)
ONE_DEGREE = [
    ("degrees = [5, 3]", "degrees = [5]"),
    ("degrees = [6, 4]", "degrees = [6]"),
    ("at = { sun_zenith = 1.5, turbidity = 6.0 }", "at = { sun_zenith = 1.5 }"),
]


def test_fixed_weather_leaves_a_polynomial_in_the_sun_alone(tmp_path: Path, plain: runtime.Runtime) -> None:
    config = config_of(tmp_path, "fixed = { turbidity = 4.0 }", WITHOUT_TURBIDITY, *ONE_DEGREE)
    folded = loaded(run_quietly(config, tmp_path))
    assert folded.inputs == ("sun_zenith", "sun_azimuth")
    close(folded.weights(SUNS[:, 0], SUNS[:, 1]), plain.weights(SUNS[:, 0], SUNS[:, 1], 4.0))


def test_a_sun_that_never_moves_is_a_constant_table(tmp_path: Path, plain: runtime.Runtime) -> None:
    still = [
        ("range = [0.0, 1.5707963267948966]", "range = [0.8, 0.8]"),
        (
            'map = "reciprocal"\npoint = 5.0\nnodes = 12\nverification = 37\ndegrees = [3, 9]',
            "nodes = 1\nverification = 1\ndegrees = [0, 0]",
        ),
        ("degrees = [5, 3]", "degrees = [0]"),
        ("degrees = [6, 4]", "degrees = [0]"),
        ("at = { sun_zenith = 1.5, turbidity = 6.0 }", "at = { sun_zenith = 0.8 }"),
    ]
    config = config_of(tmp_path, "fixed = { turbidity = 4.0 }", WITHOUT_TURBIDITY, *still)
    folded = loaded(run_quietly(config, tmp_path))
    assert folded.table.degrees == (0,)
    weights, status = folded.weights_and_status(0.8, 0.3)
    assert status == 0
    close(weights, plain.weights(0.8, 0.3, 4.0))


def test_sizes_ask_for_the_least_error_within_bytes(tmp_path: Path) -> None:
    edits = [("budgets = [0.01]", 'sizes = [700]\nlayouts = ["packed"]'), ("4-bands-1pct", "4-bands-700-bytes-packed")]
    result = run_quietly(config_of(tmp_path, "", *edits), tmp_path)
    row = next(r for r in result.summary["tables"] if r["name"] == "4-bands-700-bytes-packed")
    assert 500 < row["bytes"] <= 700
    assert row["e_mean"] < 0.05


def test_the_sun_of_a_place_and_time() -> None:
    # Oslo at the winter solstice: 90 - (90 - 59.9) + 23.44 degrees at noon; the equinox sun reaches the equator's zenith.
    low, high = zenith_range(59.9, "2026-12-21", "2026-12-21")
    assert math.degrees(low) == pytest.approx(59.9 + 23.44 - 0.6, abs=0.1)
    assert high == math.pi / 2
    assert zenith_range(0.0, "2027-03-18", "2027-03-23")[0] == 0.0
    # Beyond the polar circle in June the sun stays up.
    assert zenith_range(80.0, "2027-06-21", "2027-06-21")[1] < math.pi / 2


@pytest.mark.parametrize(
    ("scene", "message"),
    [
        ("fixed = { haze = 3.0 }", r"\$\.scene\.fixed\.haze = 3\.0.*no such parameter"),
        ("fixed = { turbidity = 30.0 }", r"\$\.scene\.fixed\.turbidity = 30\.0.*Stay within"),
        ("fixed = { turbidity = 3.0 }", r"\$\.scene\.fixed\.turbidity = 3\.0.*no axis"),
        ('sun = { latitude = 95.0, dates = ["2026-12-01", "2026-12-02"] }', r"latitude = 95"),
        ('sun = { latitude = 60.0, dates = ["2026-12-09", "2026-12-02"] }', r"\$\.scene\.sun.*first not after the second"),
        ('sun = { latitude = 85.0, dates = ["2026-12-01", "2026-12-02"] }', r"does not rise"),
        ('sun = { latitude = 60.0, dates = ["December", "2026-12-02"] }', r"\$\.scene\.sun"),
        ('quantity = "illuminance"', r"\$\.scene\.quantity = 'illuminance'"),
    ],
)
def test_a_scene_that_cannot_be_is_refused(tmp_path: Path, scene: str, message: str) -> None:
    with pytest.raises(ConfigError, match=message):
        config_of(tmp_path, scene)


@pytest.mark.parametrize("held", [sphere.Harmonics.even(9), sphere.Harmonics(9)], ids=["m >= 0", "all orders"])
def test_ground_equals_its_integral(held: sphere.Harmonics) -> None:
    x, w = np.polynomial.legendre.leggauss(60)
    z, solid = np.concatenate([(x - 1) / 2, (x + 1) / 2]), np.tile(w / 2, 2)
    phi = (np.arange(64) + 0.5) * np.pi / 32
    flat = np.sqrt((1 - z) * (1 + z))[:, np.newaxis]
    where = np.stack([flat * np.cos(phi), flat * np.sin(phi), z[:, np.newaxis] + 0 * phi], axis=-1).reshape(-1, 3)
    weight = np.repeat(solid, phi.size) * np.pi / 32
    basis = sphere.basis(where, held)
    sky = np.where(where[:, 2] > 0, 1 + 0.5 * where[:, 0] + np.exp(where[:, 2]), 0.0)
    black = (sky * weight) @ basis
    irradiance = float(np.sum(sky * weight * np.maximum(where[:, 2], 0.0)))
    lit = np.where(where[:, 2] > 0, sky, 0.3 * irradiance / np.pi)
    got = sphere.add_ground(black[np.newaxis], [0.3], held)[0]
    assert np.abs(got - (lit * weight) @ basis).max() < 1e-12
    image = np.where(where[:, 2] > 0, sky, 1 + 0.5 * where[:, 0] + np.exp(-where[:, 2]))
    assert np.abs(sphere.mirror_ground(black, held) - (image * weight) @ basis).max() < 1e-12
    with pytest.raises(ValueError, match="two bands"):
        sphere.add_ground(np.ones(1), 0.3, 1)


@pytest.mark.parametrize("ground", ['"mirror"', "[0.1, 0.2, 0.3]"])
def test_ground_is_folded_and_lessens_ringing(tmp_path: Path, plain: runtime.Runtime, ground: str) -> None:
    result = run_quietly(config_of(tmp_path, f"ground = {ground}"), tmp_path)
    radiance = plain.weights(*SUNS.T).astype(np.float64)
    expected = sphere.mirror_ground(radiance, 4) if "mirror" in ground else sphere.add_ground(radiance, [0.1, 0.2, 0.3], 4)
    close(loaded(result).weights(*SUNS.T), expected)
    least = next(row["least"] for row in result.summary["tables"] if row["path"] == "export")
    assert least > -0.12
    header = (result.folder / "export" / "skylight_sh.h").read_text(encoding="utf-8")
    # The comment may break its lines anywhere.
    words = " ".join(header.replace("\n *", " ").split())
    assert ("mirror image" if "mirror" in ground else "albedo 0.1, 0.2, 0.3") in words


@pytest.mark.parametrize("scene", ["ground = [0.1, 0.2, 0.3]", 'quantity = "irradiance"', "twilight = true"])
def test_benchmarks_and_stresses_measure_the_scene(tmp_path: Path, scene: str) -> None:
    config = config_of(tmp_path, scene)
    result = run_quietly(config, tmp_path)
    tables, published = exported(result.folder)
    name = config.export.recommended
    samples = sample(config, 4, random=100, like=tables[name])
    assert 0.5 * published[name] < headline(tables[name], samples.reference) < 1.1 * published[name]
    assert all(row["holds"] == "yes" for row in edges._outside(config, tables[name]))  # the whole section takes long


PROGRAM = """
#include <stdio.h>
#include "{folder}/skylight_sh.h"
#define SUNS 64
int main(void)
{{
    static float w[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS];
    static float g[SKYLIGHT_SH_AXES][SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS];
    static float batch[SUNS][SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS], zenith[SUNS], azimuth[SUNS], turbidity[SUNS];
    static const float albedo[3] = {{ 0.1f, 0.2f, 0.3f }};
    float direction[3];
    int i, c, k;
    double worst = 0.0, largest = 0.0;
    skylight_sh_weights_gradient(0.9f, 0.4f, 3.3f, w, g);
    for (i = 0; i < SKYLIGHT_SH_AXES; ++i)
        for (c = 0; c < SKYLIGHT_SH_CHANNELS; ++c)
            for (k = 0; k < SKYLIGHT_SH_WEIGHTS; ++k) printf("%.9g\\n", (double)g[i][c][k]);
    for (i = 0; i < SUNS; ++i) {{
        zenith[i] = 0.02f * (float)i;
        azimuth[i] = 0.1f * (float)i;
        turbidity[i] = i < 40 ? 3.0f : 3.0f + 0.01f * (float)i;
    }}
    skylight_sh_weights_batch(SUNS, zenith, azimuth, turbidity, batch);
    for (i = 0; i < SUNS; ++i) {{
        skylight_sh_weights(zenith[i], azimuth[i], turbidity[i], w);
        for (c = 0; c < SKYLIGHT_SH_CHANNELS; ++c)
            for (k = 0; k < SKYLIGHT_SH_WEIGHTS; ++k) {{
                const double d = fabs((double)w[c][k] - (double)batch[i][c][k]), v = fabs((double)w[c][k]);
                worst = d > worst ? d : worst;
                largest = v > largest ? v : largest;
            }}
    }}
    printf("%.9g\\n", worst / largest);
    skylight_sh_weights(0.9f, 0.4f, 3.3f, w);
    skylight_sh_dominant(w, direction);
    skylight_sh_ground(albedo, w);
    for (i = 0; i < SKYLIGHT_SH_BANDS; ++i) printf("%.9g\\n", (double)w[2][i * (i + 1)]);
    for (i = 0; i < 3; ++i) printf("%.9g\\n", (double)direction[i]);
    return 0;
}}
"""


@pytest.mark.parametrize("name", ["4-bands-1pct", "4-bands-1pct-packed", "3-bands-degrees-6-4-float64"])
def test_gradient_batch_and_dominant_direction(small_run: Result, tmp_path: Path, name: str) -> None:
    row = next(row for row in small_run.summary["tables"] if row["name"] == name)
    folder, prefix = small_run.folder / row["path"], row["prefix"]
    table = runtime.load(folder / "skylight_sh.npz")
    program = re.sub(r"\bskylight_sh_", f"{prefix}_", re.sub(r"\bSKYLIGHT_SH_", f"{prefix.upper()}_", PROGRAM))
    (tmp_path / "g.c").write_text(program.format(folder=folder), encoding="utf-8")
    subprocess.run(["gcc", "-std=c99", *STRICT, str(tmp_path / "g.c"), "-o", str(tmp_path / "g"), "-lm"], check=True)
    out = subprocess.run([str(tmp_path / "g")], capture_output=True, text=True, check=True).stdout
    *gradient, x, y, z = [float(v) for v in out.split()]
    ground = gradient[-table.table.bands :]
    bands = table.table.bands
    *gradient, batch = gradient[: 2 * 3 * bands * bands + 1]
    assert batch < 2e-6
    grounded = sphere.add_ground(table.weights(0.9, 0.4, 3.3).astype(np.float64), [0.1, 0.2, 0.3], bands)[2]
    zonal = [l * (l + 1) for l in range(bands)]
    assert ground == pytest.approx(grounded[zonal].tolist(), rel=1e-5, abs=1e-5 * float(np.abs(grounded).max()))
    at = np.array([0.9, 0.4, 3.3])
    # Central differences of a table in single precision are rough: wide steps, and their next term taken away.
    expected = []
    for i in (0, 2):
        step = np.zeros(3)
        step[i] = 0.04
        one, two = (
            (table.weights(*(at + k * step)).astype(np.float64) - table.weights(*(at - k * step))) / (0.08 * k)
            for k in (1, 2)
        )
        expected.append((4 * one - two) / 3)
    found = np.array(gradient).reshape(2, *expected[0].shape)
    for got, wanted in zip(found, expected, strict=True):
        assert np.abs(got - wanted).max() < 2e-3 * np.abs(wanted).max()
    # The sun's side of the sky is the bright one.
    assert math.atan2(y, x) == pytest.approx(0.4, abs=1e-5)
    assert math.hypot(x, y, z) == pytest.approx(1.0, abs=1e-6)
    assert z > 0.3


def test_the_paper_is_explained_by_radiance_alone() -> None:
    """Its scheme fitted radiance above a black ground: no other scene computes it, nor mixes the two."""
    text = (ROOT / "configs" / "preetham.toml").read_text(encoding="utf-8")
    scenes = ("", '[scene]\nground = "mirror"\n', '[scene]\nquantity = "irradiance"\nwindow = false\n')
    wanted = [shows_origins(parse(tomllib.loads(f"{text}\n{scene}"), "a config")) for scene in scenes]
    assert wanted == [True, False, False]
