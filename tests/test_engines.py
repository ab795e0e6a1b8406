"""Engines: each one's own formula, written out here as its shaders have it, gives our irradiance / pi from our export."""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT
from numpy.typing import NDArray
from scipy.special import sph_harm_y
from skylight_sh import runtime, sphere
from skylight_sh.export import engines
from test_cli import invoke

Array = NDArray[np.float64]
TABLE = ROOT / "reports" / "reference" / "export" / "skylight_sh.npz"
THREE = "three@0.187.0"
FACES = np.array([[1.0, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]])
LOBE = np.array([np.pi, *[2 * np.pi / 3] * 3, *[np.pi / 4] * 5])


def skies() -> NDArray[np.floating]:
    """Twenty skies (20, 3, 49), suns all round, one of them in the east."""
    rng = np.random.default_rng(11)
    azimuth = rng.uniform(0, 2 * np.pi, 20)
    azimuth[0] = 0.0
    return runtime.load(TABLE).weights(rng.uniform(0, np.pi / 2, 20), azimuth, rng.uniform(2.5, 6, 20))


def normals() -> Array:
    drawn = np.random.default_rng(12).normal(size=(20, 3))
    return np.asarray(drawn / np.linalg.norm(drawn, axis=1, keepdims=True))


def y_up_right(n: Array) -> Array:
    """East stays +x, up becomes +y, and north -z, away from the viewer."""
    return np.stack([n[:, 0], n[:, 2], -n[:, 1]], axis=1)


def y_up_left(n: Array) -> Array:
    """East stays +x, up becomes +y, and north +z, away from the viewer."""
    return np.stack([n[:, 0], n[:, 2], n[:, 1]], axis=1)


def z_up_left(n: Array) -> Array:
    """East stays +x, up +z, and south becomes +y."""
    return np.stack([n[:, 0], -n[:, 1], n[:, 2]], axis=1)


def terms(n: Array) -> Array:
    """The nine polynomials that shaders sum: (n, 9)."""
    x, y, z = n.T
    return np.stack([np.ones_like(x), y, z, x, x * y, y * z, 3 * z * z - 1, x * z, x * x - y * y], axis=1)


# The functions below take what the engine's JSON or text holds, and normals in the engine's axes, and return what a
# white Lambertian surface reflects, (n, 3). Constants with few digits are the engines' own.


def filament(sh: list[list[float]], n: Array) -> Array:
    return terms(n) @ np.array(sh)


def filament_radiance(sh: list[list[float]], n: Array) -> Array:
    a = [0.282095, -0.325735, 0.325735, -0.325735, 0.273137, -0.273137, 0.078848, -0.273137, 0.136569]
    return (terms(n) * a) @ np.array(sh)


def unity(sh: list[list[float]], n: Array) -> Array:
    """The shader's vectors SHA, SHB and SHC, filled as the engine fills them."""
    x, y, z = n.T
    out = []
    for c in sh:
        sha, shb = (c[3], c[1], c[2], c[0] - c[6]), (c[4], c[5], 3 * c[6], c[7])
        out.append(sha[0] * x + sha[1] * y + sha[2] * z + sha[3])
        out[-1] += shb[0] * x * y + shb[1] * y * z + shb[2] * z * z + shb[3] * z * x + c[8] * (x * x - y * y)
    return np.stack(out, axis=1)


def unreal(sh: dict[str, list[float]], n: Array) -> Array:
    basis = terms(n) * [0.282095, -0.488603, 0.488603, -0.488603, 1.092548, -1.092548, 0.315392, -1.092548, 0.546274]
    return np.stack([(basis * LOBE) @ sh[c] / np.pi for c in "RGB"], axis=1)


def godot(sh: list[list[float]], n: Array) -> Array:
    c1, c2, c3, c4, c5 = 0.429043, 0.511664, 0.743125, 0.886227, 0.247708
    x, y, z = n.T[..., np.newaxis]
    s = np.array(sh)
    return np.asarray(
        c1 * s[8] * (x * x - y * y)
        + c3 * s[6] * z * z
        + c4 * s[0]
        - c5 * s[6]
        + 2 * c1 * (s[4] * x * y + s[7] * x * z + s[5] * y * z)
        + 2 * c2 * (s[3] * x + s[1] * y + s[2] * z)
    )


def threejs(sh: dict[str, dict[str, list[float]]], n: Array) -> Array:
    return godot(np.reshape(sh["object"]["sh"], (9, 3)).tolist(), n) / np.pi


def directxmath(sh: dict[str, list[float]], n: Array) -> Array:
    """Six bands, of which those beyond the third add to irradiance in the fifth alone."""
    lobe = [np.pi, 2 * np.pi / 3, np.pi / 4, 0.0, -np.pi / 24, 0.0]
    theta, phi = np.arccos(n[:, 2]), np.arctan2(n[:, 1], n[:, 0])
    total = np.zeros((len(n), 3))
    every = sphere.Harmonics(6)
    for i, (l, m) in enumerate(zip(every.degrees.tolist(), every.orders.tolist(), strict=True)):
        wave = sph_harm_y(l, abs(m), theta, phi)  # with the sign, as XMSHEvalDirection
        y = wave.real if m == 0 else np.sqrt(2) * (wave.real if m > 0 else wave.imag)
        total += np.outer(lobe[l] / np.pi * y, [sh[c][i] for c in ("red", "green", "blue")])
    return total


def babylonjs(sh: list[list[float]], n: Array) -> Array:
    """As preScaleForRendering and the shader do."""
    k = np.sqrt(np.array([1, 3, 3, 3, 15, 15, 5 / 4, 15, 15 / 4]) / (4 * np.pi)) * [1, -1, 1, -1, 1, -1, 1, -1, 1]
    return (terms(n) * k) @ np.array(sh)


def gltf(light: dict[str, list[list[float]]], n: Array) -> Array:
    """As the reader in Babylon.js: by convertIrradianceToLambertianRadiance to its own form."""
    return babylonjs((np.array(light["irradianceCoefficients"]) / np.pi).tolist(), n)


READERS: dict[str, tuple[Callable[..., Array], Callable[[Array], Array]]] = {
    "filament": (filament, y_up_right),
    "filament-radiance": (filament_radiance, y_up_right),
    "unity": (unity, y_up_left),
    "unreal": (unreal, z_up_left),
    "godot": (godot, y_up_right),
    "threejs": (threejs, y_up_right),
    "directxmath": (directxmath, lambda n: n),
    "babylonjs": (babylonjs, y_up_left),
    "gltf": (gltf, y_up_right),
}


def expected(weights: NDArray[np.floating], n: Array, bands: int) -> Array:
    """Our irradiance / pi, (n, 3), straight from our weights."""
    lobe = np.array([np.pi, 2 * np.pi / 3, np.pi / 4, 0.0, -np.pi / 24, 0.0])
    degrees = sphere.Harmonics(bands).degrees
    return sphere.evaluate(weights[:, : bands * bands].astype(np.float64) * lobe[degrees] / np.pi, n).T


def error(got: Array, true: Array) -> float:
    """Largest error relative to the channel's largest value."""
    return float((np.abs(got - true).max(axis=0) / np.abs(true).max(axis=0)).max())


def test_every_profile_is_read_here() -> None:
    assert set(READERS) == set(engines.PROFILES)


@pytest.mark.parametrize("name", READERS)
def test_an_engines_own_formula_gives_our_irradiance(name: str) -> None:
    profile = engines.PROFILES[name]
    reader, axes = READERS[name]
    bands = profile.bands[1]
    for weights in skies():
        numbers = engines.convert(weights[:, : bands * bands], profile)
        got = reader(json.loads(json.dumps(engines.structure(numbers, profile))), axes(normals()))
        assert error(got, expected(weights, normals(), bands)) < 1e-6


@pytest.mark.parametrize("name", READERS)
def test_an_eastern_sun_lights_eastern_faces(name: str) -> None:
    profile = engines.PROFILES[name]
    reader, axes = READERS[name]
    weights = runtime.load(TABLE).weights(1.2, 0.0, 3.0, bands=profile.bands[1])
    made = engines.structure(engines.convert(weights, profile), profile)
    east, west, north, south, up, down = reader(made, axes(FACES))
    assert np.all(east > 1.5 * west)
    assert north == pytest.approx(south)
    assert np.all(up > down)


PROBE = """
import { readFileSync } from 'node:fs';
import { ObjectLoader, Vector3 } from 'three';
const { skies, normals } = JSON.parse(readFileSync(process.argv[2], 'utf8'));
const out = skies.map((sky) => {
  const probe = new ObjectLoader().parse(sky);
  return normals.map((n) => probe.sh.getIrradianceAt(new Vector3(...n), new Vector3()).toArray());
});
console.log(JSON.stringify(out));
"""


@pytest.mark.tools
def test_three_js_itself_reads_our_export(tmp_path: Path) -> None:
    subprocess.run(
        ["npm", "install", "--prefix", str(tmp_path), "--ignore-scripts", "--no-audit", "--no-fund", "--silent", THREE],
        check=True,
    )
    made = []
    for place in (("--sun-zenith", "1.2", "--sun-azimuth", str(a)) for a in range(20)):
        code, out, _ = invoke("evaluate", str(TABLE), *place, "--turbidity", "3", "--format", "threejs")
        assert code == 0
        made.append(json.loads(out))
    (tmp_path / "probe.mjs").write_text(PROBE, encoding="utf-8")
    given = {"skies": made, "normals": y_up_right(normals()).tolist()}
    (tmp_path / "given.json").write_text(json.dumps(given), encoding="utf-8")
    command = ["node", str(tmp_path / "probe.mjs"), str(tmp_path / "given.json")]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    weights = runtime.load(TABLE).weights(1.2, np.arange(20), 3.0)
    for got, sky in zip(json.loads(done.stdout), weights, strict=True):
        assert error(np.array(got) / np.pi, expected(sky, normals(), 3)) < 1e-6


def test_filaments_text_is_that_of_cmgen() -> None:
    code, out, _ = invoke("evaluate", str(TABLE), "--sun-zenith", "0.8", "--turbidity", "3", "--format", "filament")
    assert code == 0
    line = re.compile(r"\(( *[-+.e\d]+),( *[-+.e\d]+),( *[-+.e\d]+)\); // (L-?\d+-?\d*), irradiance, pre-scaled base")
    found = [line.fullmatch(text) for text in out.splitlines()]
    assert [m[4] for m in found if m] == ["L00", "L1-1", "L10", "L11", "L2-2", "L2-1", "L20", "L21", "L22"]
    numbers = [[float(m[i]) for i in (1, 2, 3)] for m in found if m]
    weights = runtime.load(TABLE).weights(0.8, 0.0, 3.0)
    assert error(filament(numbers, y_up_right(normals())), expected(weights, normals(), 3)) < 1e-6


def test_axes_exposure_window_and_one_channel() -> None:
    godot = engines.PROFILES["godot"]
    loaded = runtime.load(TABLE)
    weights = loaded.weights(0.8, 0.3, 3.0, bands=3)
    ours = engines.convert(weights, godot, axes="x=+x,y=+y,z=+z", exposure=0.5)
    assert ours == pytest.approx(0.5 / np.pi * weights)
    grey = engines.convert(weights[1:2], godot)
    assert grey == pytest.approx(np.repeat(engines.convert(weights, godot)[1:2], 3, axis=0), rel=1e-12)
    command = ("evaluate", str(TABLE), "--sun-zenith", "0.8", "--sun-azimuth", "0.3", "--turbidity", "3", "--window")
    code, out, _ = invoke(*command, "--format", "godot", "--axes", "z=z, x=x, y=y", "--exposure", "2")
    assert code == 0
    windowed = loaded.weights(0.8, 0.3, 3.0, bands=3, window=True)
    assert pytest.approx(2 / np.pi * windowed.astype(np.float64), rel=1e-8) == np.array(json.loads(out)).T
    assert engines.describe(godot.axes) == "east is +x, north is -z, up is +y; right-handed"
    assert engines.describe(engines.PROFILES["unity"].axes).endswith("left-handed")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--format", "cryengine"), "directxmath"),
        (("--format", "unity", "--bands", "4"), "Invalid bands 4. Unity takes 3"),
        (("--format", "directxmath", "--bands", "7"), "takes 2 to 6"),
        (("--format", "unity", "--axes", "x=x,y=x,z=z"), 'like "x=+x,y=-z,z=+y"'),
        (("--format", "unity", "--axes", "x=x,y=y"), "Invalid axes"),
        (("--format", "unity", "--exposure", "0"), "Invalid exposure 0.0"),
        (("--format", "unity", "--exposure", "nan"), "Invalid exposure nan"),
        (("--exposure", "2"), "Add --format"),
    ],
)
def test_bad_input_is_refused(arguments: tuple[str, ...], message: str) -> None:
    code, out, err = invoke("evaluate", str(TABLE), "--sun-zenith", "0.8", "--turbidity", "3", *arguments)
    assert (code, out) == (2, "")
    assert message in err


def test_numbers_beyond_half_floats_are_told() -> None:
    command = ("evaluate", str(TABLE), "--sun-zenith", "0.8", "--turbidity", "3", "--format", "gltf")
    code, _, err = invoke(*command)
    assert code == 0
    assert "beyond half floats" in err
    assert invoke(*command, "--exposure", "0.5")[2] == ""


def test_too_few_bands_or_other_channels_are_refused() -> None:
    with pytest.raises(ValueError, match="Unity needs 3 bands, but the table has 2"):
        engines.bands_for(engines.PROFILES["unity"], 2)
    with pytest.raises(ValueError, match="2 channels"):
        engines.convert(np.ones((2, 9)), engines.PROFILES["unity"])
