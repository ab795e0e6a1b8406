"""Lights that are none: each is refused with one message before anything is published; those that are lights pass."""

from __future__ import annotations

import re
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from conftest import run_quietly
from numpy.typing import NDArray
from skylight_sh import runtime
from skylight_sh.cli import main
from skylight_sh.config import load
from skylight_sh.fit.errors import Reference
from skylight_sh.light import BlackBox, Domain, Fixed, Hints, Light, LightError, Luminance, installed
from skylight_sh.light.cie_general import CieGeneral
from skylight_sh.light.cie_traditional import CieTraditional
from skylight_sh.light.mitsuba_sunsky import MitsubaSunsky
from skylight_sh.light.perez import Perez
from skylight_sh.light.plugin import Plugin
from skylight_sh.light.preetham import Preetham
from skylight_sh.quadrature.samples import Samples
from skylight_sh.quadrature.validation import check_samples, vet
from skylight_sh.run.runner import Result
from skylight_sh.table import validation
from skylight_sh.table.errors import measure

Array = NDArray[np.float64]

PACKAGE = '''
"""Lights that are none, by the name of what is wrong with them."""

import dataclasses

import numpy as np

from skylight_sh.formula.elementary import exp, label
from skylight_sh.light import Domain, Hints
from skylight_sh.light.preetham import Preetham

KNOWN = Preetham().hints.prefactor


def prefactor(**changes):
    return Hints(prefactor=dataclasses.replace(KNOWN, axes=("sun_zenith", "strength"), **changes))


HINTS = {
    "no such peak": Hints(peak_axis="elevation"),
    "peak in degrees": Hints(peak_axis="strength"),
    "peak below": Hints(peak_zenith=2.0),
    "no hints": None,
    "negative prefactor": prefactor(name="own", formula=lambda theta, strength, _: -1.0 - strength),
    "prefactor through 0": prefactor(name="own", formula=lambda theta, strength, _: strength - 2.5),
    "infinite prefactor": prefactor(name="own", formula=lambda theta, strength, _: 1e60 * strength * strength),
    "one prefactor for all": prefactor(name="own", formula=lambda theta, strength, _: np.ones(1)),
    "prefactor by NumPy": prefactor(name="own", formula=lambda theta, strength, _: np.exp(strength)),
    "prefactor that chooses": prefactor(name="own", formula=lambda theta, strength, _: max(strength, 1.0)),
    "prefactor of a power": prefactor(name="own", formula=lambda theta, strength, _: strength**2),
    "prefactor raises": prefactor(name="own", formula=lambda theta, strength, k: k[99]),
    "prefactor of one": prefactor(name="own", formula=lambda theta, _: theta),
    "prefactor of nan": prefactor(name="own", formula=lambda theta, strength, _: strength * float("nan")),
    "prefactor of nan constants": prefactor(
        name="own", constants=(float("nan"),), formula=lambda theta, strength, k: strength + k[0]
    ),
    "prefactor of nothing": Hints(prefactor=KNOWN),
    "own prefactor": prefactor(
        name="of_this_package",
        constants=(10.0, 0.75),
        formula=lambda theta, strength, k: label(k[0] + strength * exp(-theta * k[1]), "glow"),
    ),
    "another's name": prefactor(formula=lambda theta, strength, _: 2.25 - strength),
}
CHANNELS = {"no channels": (), "same channels": ("red", "red"), "a text of channels": "red", "unnamed": ("",), "three": 3}
ROWS = {
    "short row": np.ones(2), "row of nan": np.array([np.nan]), "black row": np.zeros(1), "row of texts": np.array(["1"])
}
DOMAINS = {"reversed": (4.0, 1.0), "nan domain": (np.nan, 4.0), "domain of texts": ("low", "high")}


class Nonsense:
    def __init__(self, kind):
        self.kind, self.title, self.version, self.calls, self.kept = kind, kind, "", 0, None
        self.channels = CHANNELS.get(kind, ("luminance",))
        self.luminance_row = ROWS.get(kind, np.ones(1))
        self.hints = HINTS.get(kind, Hints())

    @property
    def domains(self):
        strength = Domain(*DOMAINS.get(self.kind, (1.0, 4.0)), "1", "as strong as that")
        if self.kind == "no domains":
            raise LookupError("no table of domains")
        return {"sun_zenith": Domain(0.0, 1.5, "rad", "a sun above the horizon"), "strength": strength}

    def radiance(self, directions, parameters):
        theta, strength = parameters["sun_zenith"], parameters["strength"]
        x, z = directions[..., 0], directions[..., 2]
        sky = 1000.0 + 100.0 * strength * np.exp(x * np.sin(theta) + z * np.cos(theta) - 1.0)
        self.calls += 1
        return self.wrong(sky, directions, theta + 0.0 * sky, strength + 0.0 * sky)

    def wrong(self, sky, directions, theta, strength):
        kind, out = self.kind, sky[..., np.newaxis]
        # Of the fit grid alone.
        late = np.abs(strength - 2.0) < 1e-9
        if kind == "negative":
            return -out
        if kind == "zero":
            return 0.0 * out
        if kind == "black at an end":
            return np.where(strength == 1.0, 0.0, sky)[..., np.newaxis]
        if kind == "half negative":
            return (sky * directions[..., 0])[..., np.newaxis]
        if kind == "nan in a corner":
            return np.where((theta == 1.5) & (strength == 4.0), np.nan, sky)[..., np.newaxis]
        if kind == "nan at the zenith":
            return np.where(directions[..., 2] == 1.0, np.nan, sky)[..., np.newaxis]
        if kind == "inf on the horizon":
            return (sky / directions[..., 2])[..., np.newaxis]
        if kind == "random":
            return out * (1.0 + 1e-12 * np.random.default_rng().random(out.shape))
        if kind == "counts":
            return out * (1.0 + 1e-9 * self.calls)
        if kind == "flat":
            return sky
        if kind == "channels first":
            return sky[np.newaxis]
        if kind == "two channels":
            return np.stack([sky, sky], axis=-1)
        if kind == "of one set":
            return out.reshape(-1, *out.shape[-2:])[:1] if out.ndim == 3 and out.shape[0] > 1 else out
        if kind == "whole numbers":
            return out.astype(np.int64)
        if kind == "half floats":
            return out.astype(np.float16)
        if kind == "complex":
            return out.astype(np.complex128)
        if kind == "objects":
            return out.astype(object)
        if kind == "lists":
            return out.tolist()
        if kind == "none":
            return None
        if kind == "raises":
            raise ZeroDivisionError("a lookup of nothing")
        if kind == "raises at an end" and np.any(strength == 4.0):
            raise KeyError("no such strength")
        if kind == "moves directions":
            directions *= 0.5
        if kind == "keeps its array":
            if self.kept is None or self.kept.size < out.size:
                self.kept = np.empty(out.size)
            self.kept[: out.size] = out.ravel()
            return self.kept[: out.size].reshape(out.shape)
        if kind == "huge":
            return 1e300 * out
        if kind == "tiny":
            return 1e-323 * out
        if kind == "of the batch":
            return out * (1.0 + 1e-3 * np.mean(sky) / 1000.0)
        if kind == "of the order":
            return out * (1.0 + 1e-6 * np.arange(out.shape[-2])[:, np.newaxis])
        if kind == "late nan":
            return np.where(late, np.nan, sky)[..., np.newaxis]
        if kind == "late negative":
            return np.where(late, -sky, sky)[..., np.newaxis]
        if kind == "late raise" and late.any():
            raise OSError("the table of strengths ends")
        return out


def make(kind="sound"):
    if kind == "cannot be made":
        raise AssertionError("never")
    return Nonsense(kind)
'''

CONFIG = """
name = "nonsense"
[light]
model = "plugin"
entry = "nonsense"
options = { kind = "KIND" }
[[axes]]
name = "sun_zenith"
range = [0.0, 1.5]
nodes = 6
verification = 17
degrees = [4, 4]
[[axes]]
name = "strength"
range = [1.0, 4.0]
nodes = 4
spacing = "uniform"
verification = 17
degrees = [2, 2]
[truth]
bands = 2
tolerance = 1e-5
rule = "zenith"
random = 5
[fit]
prefactor = false
[[winners]]
bands = 2
degrees = [4, 2]
[export]
recommended = "2-bands-degrees-4-2"
[report]
figures = []
"""

# What is wrong, and what the message says of it.
NONSENSE = {
    "negative": r"mean luminance is not positive at sun_zenith = 0",
    "zero": r"it is black",
    "black at an end": r"it is black.* strength = 1 ",
    "half negative": r"mean luminance is not positive|luminance is negative",
    "nan in a corner": r"not finite at sun_zenith = 1\.5, strength = 4",
    "nan at the zenith": r"not finite",
    "inf on the horizon": r"not finite",
    "random": r"two calls with the same arguments give other bits",
    "counts": r"two calls with the same arguments give other bits",
    "flat": r"shape",
    "channels first": r"shape",
    "two channels": r"shape",
    "of one set": r"shape \(1, \d+, 1\), not",
    "whole numbers": r"int64",
    "half floats": r"array of float16, not an array of float64 or float32",
    "complex": r"complex128",
    "objects": r"object",
    "lists": r"is a list, not an array",
    "none": r"shape \(\) and object",
    "raises": r"raises ZeroDivisionError \(a lookup of nothing\) at sun_zenith = 0\.75, strength = 2\.5",
    "raises at an end": r"raises KeyError \('no such strength'\) at sun_zenith = 0 to 1\.5, strength = 1 to 4",
    "moves directions": r"changes its arguments",
    "keeps its array": r"a later call changes an earlier result|two calls",
    "huge": r"too bright for single precision",
    "tiny": r"too faint for single precision",
    "of the batch": r"is another when asked for",
    "of the order": r"is another when asked for in another order",
    "late nan": r"is not finite at sun_zenith = \S+ strength = 2\.",
    "late negative": r"no positive mean luminance at sun_zenith = \S+ strength = 2\.",
    "late raise": r"raises OSError \(the table of strengths ends\) at .*strength = ",
    "no such peak": r"peak_axis 'elevation' is none of its parameters sun_zenith, strength",
    "peak in degrees": r"peak_axis 'strength' reaches from 1 to 4",
    "peak below": r"peak_zenith 2\.0 must be radians",
    "negative prefactor": r"prefactor 'own' is -2 at sun_zenith = 0, strength = 1, but must be finite and positive",
    "prefactor through 0": r"prefactor 'own' is -1\.5 at sun_zenith = 0, strength = 1, but must",
    "infinite prefactor": r"prefactor 'own' is inf at",
    "one prefactor for all": r"prefactor 'own' is no formula of numbers \(",
    "prefactor by NumPy": r"prefactor 'own' is no formula of numbers \(TypeError.*functions of skylight_sh\.formula",
    "prefactor that chooses": r"prefactor 'own' is no formula of numbers \(TypeError",
    "prefactor of a power": r"prefactor 'own' is no formula of numbers \(TypeError",
    "prefactor raises": r"prefactor 'own' is no formula of numbers \(IndexError: tuple index out of range\); use \+ - \* /",
    "prefactor of one": r"prefactor 'own' is no formula of numbers \(TypeError",
    "prefactor of nan": r"prefactor 'own' is nan at sun_zenith = 0, strength = 1, but must",
    "prefactor of nan constants": r"prefactor 'own' is nan at sun_zenith = 0, strength = 1, but must",
    "prefactor of nothing": r"needs 'turbidity', which is none of its parameters",
    "another's name": r"prefactor 'preetham_zenith' is -0\.25 at sun_zenith = 0, strength = 2\.5, but must",
    "no channels": r"channels \(\) must be one name or more",
    "same channels": r"channels \('red', 'red'\) must be one name or more, each another",
    "a text of channels": r"channels 'red' must be a tuple of names",
    "unnamed": r"must be a tuple of names",
    "three": r"channels 3 must be a tuple",
    "short row": r"luminance_row must have one number for each of 1 channels, not shape \(2,\)",
    "row of nan": r"luminance_row \[nan\] must be finite",
    "black row": r"luminance_row \[0\.0\] must be finite numbers, not all 0",
    "row of texts": r"luminance_row must have one number",
    "reversed": r"domain of strength, \[4, 1\], must be numbers, low to high",
    "nan domain": r"domain of strength, \[nan, 4\], must be numbers",
    "domain of texts": r"domain of strength must be a Domain of numbers",
    "no domains": r"cannot tell what it is \(LookupError: no table of domains\)",
    "no hints": r"hints must be Hints, not NoneType",
    "cannot be made": r"cannot be made \(AssertionError: never\)",
}


@pytest.fixture(scope="module", autouse=True)
def package(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """The lights as an installed package."""
    folder = tmp_path_factory.mktemp("package")
    (folder / "nonsense_lights.py").write_text(PACKAGE, encoding="utf-8")
    told = folder / "nonsense_lights-1.0.dist-info"
    told.mkdir()
    (told / "METADATA").write_text("Name: nonsense-lights\nVersion: 1.0\n", encoding="utf-8")
    (told / "entry_points.txt").write_text("[skylight_sh.lights]\nnonsense = nonsense_lights:make\n", encoding="utf-8")
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(folder)
        yield folder


def write(folder: Path, kind: str, text: str = CONFIG) -> Path:
    path = folder / "nonsense.toml"
    path.write_text(text.replace("KIND", kind), encoding="utf-8")
    return path


def refused(folder: Path, path: Path, *options: str) -> str:
    """Run a config that must be refused; return the one message."""
    places = ["--store", str(folder / "s"), "--reports", str(folder / "r")]
    result = CliRunner().invoke(main, ["run", str(path), *places, *options])
    assert result.exit_code == 2, result.output
    assert isinstance(result.exception, SystemExit)
    assert "Traceback" not in result.output
    assert not result.stdout
    assert not (folder / "r").exists()
    (message,) = [line for line in result.stderr.splitlines() if line.startswith("Error: ")]
    assert result.stderr.startswith(message)
    return result.stderr


@pytest.mark.parametrize("kind", list(NONSENSE))
def test_nonsense_is_refused_with_one_message_and_nothing_is_published(tmp_path: Path, kind: str) -> None:
    message = refused(tmp_path, write(tmp_path, kind))
    match = re.search(NONSENSE[kind], message)
    assert match, message
    assert "nonsense" in message or kind in message
    assert "Mend" in message
    # Nothing but what came before the light was found out.
    kept = {p.parent.name for p in (tmp_path / "s").rglob("*.h5")}
    assert kept <= {"truth"}


def test_what_a_light_raises_in_another_process_is_one_message_too(tmp_path: Path) -> None:
    message = refused(tmp_path, write(tmp_path, "late raise"), "--executor", "processes", "--workers", "1")
    assert "raises OSError (the table of strengths ends)" in message
    assert "'nonsense'" in message
    assert len(message.splitlines()) == 1


def test_the_same_light_in_its_right_mind_goes_all_the_way(tmp_path: Path) -> None:
    result = run_quietly(load(write(tmp_path, "sound")), tmp_path)
    assert 0.0 < result.summary["tables"][0]["e_mean"] < 0.05


def test_a_package_s_own_prefactor_travels_with_its_tables(tmp_path: Path) -> None:
    """Under any name: in the archive as a program, in C as statements, each the formula to single precision."""
    text = CONFIG.replace("prefactor = false", "prefactor = true")
    result = run_quietly(load(write(tmp_path, "own prefactor", text)), tmp_path)
    assert 0.0 < result.summary["tables"][0]["e_mean"] < 0.05
    loaded = runtime.load(result.folder / "export" / "skylight_sh.npz")
    scale = loaded.table.spec.scale
    assert scale is not None
    assert (scale.kind, scale.name, scale.program.constants) == ("closed form", "of_this_package", (10.0, 0.75))
    theta, strength = np.array([0.0, 0.7, 1.5]), np.array([1.0, 2.5, 4.0])
    assert scale.program.run([theta, strength])[0] == pytest.approx(10.0 + strength * np.exp(-0.75 * theta), rel=1e-15)
    program = """#include <stdio.h>
#include "skylight_sh.h"
int main(void) { static float w[1][SKYLIGHT_SH_WEIGHTS]; int i; skylight_sh_weights(0.7f, 0.4f, 2.5f, w);
for (i = 0; i < SKYLIGHT_SH_WEIGHTS; ++i) printf("%.9g\\n", (double)w[0][i]); return 0; }
"""
    (tmp_path / "w.c").write_text(program, encoding="utf-8")
    command = [
        "cc",
        "-std=c99",
        "-I",
        str(result.folder / "export"),
        str(tmp_path / "w.c"),
        "-o",
        str(tmp_path / "w"),
        "-lm",
    ]
    subprocess.run(command, check=True)
    out = subprocess.run([str(tmp_path / "w")], capture_output=True, text=True, check=True).stdout
    expected = loaded.weights(0.7, 0.4, 2.5)[0]
    assert np.abs(np.array(out.split(), dtype=float) - expected).max() < 2e-6 * np.abs(expected).max()


def test_a_changed_package_changes_the_light_s_version(package: Path) -> None:
    before = Plugin("nonsense", {"kind": "sound"}).version
    assert before.startswith("nonsense-lights 1.0 code ")
    (package / "nonsense_lights.py").write_text(PACKAGE + "\n", encoding="utf-8")
    # As another process would see it.
    assert installed.identity.__wrapped__("nonsense") != before
    (package / "nonsense_lights.py").write_text(PACKAGE, encoding="utf-8")
    assert installed.identity.__wrapped__("nonsense") == before


SKIES: list[Light] = [
    Preetham(),
    Preetham(constants="smits"),
    *(Perez(category=category, quantity=quantity) for category in range(1, 9) for quantity in ("relative", "absolute")),
    *(CieGeneral(sky=sky) for sky in range(1, 16)),
    *(CieTraditional(sky=sky) for sky in ("overcast", "clear", "partly-cloudy", "intermediate")),
    Plugin("example_glow", {"width": 0.8}),
]


def whole(light: Light) -> dict[str, tuple[float, float]]:
    return {name: (domain.low, domain.high) for name, domain in light.domains.items()}


@pytest.mark.parametrize("light", SKIES, ids=lambda light: light.title)
def test_every_light_of_ours_is_believed_over_its_whole_domain(light: Light) -> None:
    first = next(iter(light.domains))
    for made in (light, BlackBox(light), Luminance(light), Luminance(BlackBox(light))):
        vet(made, whole(made))
    if len(light.domains) > 1:
        fixed = Fixed(light, ((first, 0.7),))
        vet(fixed, whole(fixed))


def test_mitsuba_s_sky_is_believed_though_it_dips_below_0() -> None:
    pytest.importorskip("mitsuba")
    light = MitsubaSunsky()
    for made in (light, Luminance(light), Fixed(light, (("albedo", 0.5),))):
        vet(made, whole(made))


class Plain:
    """A light of its own radiance over one parameter."""

    title, version, channels, luminance_row = "plain", "", ("value",), np.ones(1)

    def __init__(self, share: float) -> None:
        self.share, self.hints, self.domains = share, Hints(), {"level": Domain(0.0, 1.0, "1", "a share")}

    def radiance(self, directions: Array, parameters: dict[str, Array]) -> Array:
        return np.asarray(directions[..., 2] - self.share + 0.0 * parameters["level"])[..., np.newaxis]


def test_a_light_whose_least_radiance_is_0_is_believed_and_one_that_dips_far_below_is_not() -> None:
    vet(Plain(0.0), {"level": (0.0, 1.0)})
    vet(Plain(0.05), {"level": (0.0, 1.0)})
    with pytest.raises(LightError, match="negative"):
        vet(Plain(0.4), {"level": (0.0, 1.0)})


def test_preetham_is_looked_at_in_less_than_50_ms() -> None:
    light = Preetham()
    vet(light, whole(light))
    # Other work on the machine can only add.
    times = []
    for _ in range(5):
        start = time.perf_counter()
        vet(light, whole(light))
        times.append(time.perf_counter() - start)
    assert min(times) < 0.05


@pytest.mark.parametrize("value", [0.0, -3.0, np.nan, np.inf])
def test_errors_relative_to_no_light_are_refused(value: float) -> None:
    for convention, told in (("mean", "mean luminance"), ("per-set", "least luminance")):
        with pytest.raises(LightError, match=rf"relative to the {told}, which is .* at the parameters 0\.5, 2, but must"):
            validation.check_scales({convention: np.array([1.0, value])}, np.array([[0.1, 1.0], [0.5, 2.0]]))


@pytest.mark.parametrize("value", [-1e-9, np.nan, np.inf])
def test_an_error_that_is_none_is_refused(value: float) -> None:
    with pytest.raises(LightError, match="A table's E_mean is"):
        validation.check_errors({"E_max": np.zeros(2), "E_mean": np.array([[0.1, value]])})


@pytest.mark.parametrize(("least", "mean"), [(-1.0, -5.0), (0.0, 0.0), (0.0, np.nan)])
def test_a_table_of_no_light_is_not_measured(small_run: Result, least: float, mean: float) -> None:
    table = runtime.load(small_run.folder / "export" / "skylight_sh.npz").table
    degrees = np.array([0, 1, 1, 2, 2, 2, 3, 3, 3, 3])
    weights = np.ones((1, len(table.channels), degrees.size))
    reference = Reference(np.array([[0.5, 3.0]]), weights, degrees, np.array([least]), np.array([mean]))
    with pytest.raises(LightError, match="relative to the mean luminance"):
        measure(table, reference)


def test_samples_of_any_leading_shape_are_looked_at() -> None:
    light = Preetham()
    parameters = {"sun_zenith": np.array([0.1, 0.2, 0.3]), "turbidity": np.array([3.0, 4.0, 5.0])}
    weights = np.ones((3, 3, 4))
    for lead in ((3,), (3, 1), (1, 3), (1, 3, 1)):
        good = Samples(weights.reshape(*lead, 3, 4), np.ones(lead), np.zeros((*lead, 3)), np.zeros(lead))
        check_samples(light, parameters, good)
        black = weights.copy()
        black[1] = 0.0
        dark = Samples(black.reshape(*lead, 3, 4), np.ones(lead), np.zeros((*lead, 3)), np.zeros(lead))
        with pytest.raises(LightError, match=r"no positive mean luminance.*0\.2.*4"):
            check_samples(light, parameters, dark)
