"""The frozen model of a config file. Every field says what it may hold; unknown keys are refused."""

from __future__ import annotations

from functools import cached_property
from pathlib import Path
from typing import Annotated, Literal

from pydantic import Field, PrivateAttr

from skylight_sh import shipped
from skylight_sh.config.choices import AnyOf, OneOf
from skylight_sh.config.mesh_schema import MeshSection
from skylight_sh.config.scenes_schema import ScenesSection
from skylight_sh.config.section import Section
from skylight_sh.config.surroundings_schema import CloudsSection, OccluderSection
from skylight_sh.config.views_schema import ViewSection
from skylight_sh.export.targets import ALWAYS, TARGETS
from skylight_sh.fit.least_squares import SOLVERS
from skylight_sh.formula.bases import BASES
from skylight_sh.formula.variables import VARIABLES
from skylight_sh.light import LIGHTS, BlackBox, Fixed, Light, Luminance, OptionsOfLight
from skylight_sh.quadrature.registry import RULES
from skylight_sh.report.figures import PICTURES
from skylight_sh.scene.fold import Quantity
from skylight_sh.scene.lamps import LAMPS, Lamp
from skylight_sh.table.request import LAYOUTS

Name = Annotated[str, Field(pattern=r"^[a-z0-9][a-z0-9_-]{0,39}$")]
Degree = Annotated[int, Field(ge=0, le=40)]
Fraction = Annotated[float, Field(gt=0.0, le=1.0)]
Bands = Annotated[int, Field(ge=1, le=32)]
Tolerance = Annotated[float, Field(ge=1e-14, le=1e-2)]
DType = Literal["float32", "float64"]
BasisName = Annotated[str, OneOf(BASES, "basis")]
PictureName = Annotated[str, OneOf(PICTURES, "picture")]
SolverName = Annotated[str, OneOf(SOLVERS, "solver")]
TargetName = Annotated[str, OneOf(TARGETS, "target")]


class AxisSection(Section):
    """One parameter of the light."""

    name: str = Field(description="a parameter of the light, e.g. sun_zenith (radians) or turbidity")
    range: tuple[float, float] = Field(description="[low, high] with low < high, inside the light's domain")
    map: Annotated[str, OneOf(VARIABLES, "change of variable about `point`", (("auto", "found in samples"),))] = "identity"
    point: float = Field(
        0.0,
        description="singular point of map = log (below the range), reciprocal (outside), cbrt (not below) or even (of the "
        "square, outside the squares)",
    )
    nodes: int = Field(ge=1, le=1000, description="fit nodes, more than the largest degree")
    spacing: Literal["chebyshev", "uniform"] = Field("chebyshev", description="spacing of the fit nodes")
    verification: int = Field(ge=1, le=2000, description="verification nodes, at least four times the largest degree")
    degrees: tuple[Degree, Degree] = Field(description="[least, largest] polynomial degree of the sweep, 0 to 40")


class TruthSection(Section):
    """How the ground truth is sampled."""

    bands: Bands = Field(description="SH bands of the truth, 1 to 32")
    tolerance: Tolerance | Literal["auto"] = Field(
        "auto",
        description="relative to the largest weight, 1e-14 to 1e-2; auto: an E_mean of a fiftieth of the tightest budget, "
        "or of 5e-5 where all are looser; 1e-10 where no table has a budget",
    )
    orders: Literal["auto", "all"] = Field(
        "auto", description="auto: m >= 0 alone where the light is symmetric; all: every m"
    )
    rule: Annotated[str, OneOf(RULES, "truth rule", (("auto", "by the light's hints"),))] = "auto"
    hints: bool = Field(True, description="false hides what the light tells about itself: a black box")
    random: int = Field(500, ge=0, le=100_000, description="further random sets that selection sees, 0 to 100000")
    seed: int = Field(2008, ge=0, description="seed of the random sets, 0 or more")
    held_out: int = Field(
        2000,
        ge=1,
        le=100_000,
        description="sets that only the measurement of errors reads: scrambled Sobol sets, 1 to 100000",
    )
    held_out_edge: int = Field(128, ge=1, le=10_000, description="more of them on each edge of the ranges, 1 to 10000")
    held_out_seed: int = Field(1959, ge=0, description="seed of the held-out sets, 0 or more")

    @property
    def stated_tolerance(self) -> float:
        """The tolerance, or 1e-10 where it is left to the budgets."""
        return 1e-10 if self.tolerance == "auto" else self.tolerance


class ReferenceSection(Section):
    """A fit for comparison, on the same samples."""

    name: Name = Field(description="lower-case letters, digits, - and _; at most 40")
    basis: BasisName = "monomial"
    solver: SolverName = "normal"
    scaled: bool = Field(False, description="whether parameters are scaled to [-1, 1] first")
    degrees: tuple[Degree, ...] = Field(description="one degree an axis, below the axis's nodes")
    dtype: DType = Field("float64", description="number type the table is kept and evaluated in")


class FitSection(Section):
    """The fit that is swept over degrees and bands."""

    basis: BasisName = "chebyshev"
    solver: SolverName = "svd"
    prefactor: bool | Literal["auto"] = Field(
        True,
        description="true: divide by the light's closed form if it has one; false: by nothing; auto: find one in samples",
    )
    references: tuple[ReferenceSection, ...] = Field((), description="fits to show beside this one")


class WinnerSection(Section):
    """Tables to select: the fewest bytes under each budget, or the degrees given."""

    bands: Bands = Field(description="SH bands of the table, at most truth.bands")
    budgets: tuple[Fraction, ...] = Field((), description="largest E_mean allowed, as fractions in (0, 1]")
    sizes: tuple[Annotated[int, Field(ge=64, le=10_000_000)], ...] = Field(
        (), description="largest bytes allowed instead of an error, 64 to 10000000: the least error within each"
    )
    degrees: tuple[Degree, ...] | None = Field(
        None, description="instead of budgets: one degree an axis, every coefficient kept"
    )
    dtype: DType = Field("float32", description="number type of the table")
    layouts: tuple[Annotated[str, OneOf(LAYOUTS, "layout")], ...] = Field(
        ("rows",), min_length=1, description="layouts of the numbers: a table each"
    )


class ExportSection(Section):
    """What renderers get."""

    prefix: str = Field(
        "skylight_sh", pattern=r"^[a-z][a-z0-9_]{0,31}$", description="prefix of every C symbol: lower-case C identifier"
    )
    recommended: str = Field(description="name of the table to recommend, e.g. 7-bands-0.1pct")
    targets: tuple[TargetName, ...] = Field(
        ALWAYS, description=f"what is written of each table: {' and '.join(ALWAYS)}, always, and others"
    )


class CaseSection(Section):
    """A parameter set to show as panoramas."""

    title: str = Field(min_length=1, max_length=80, description="heading of the pictures, at most 80 characters")
    at: dict[str, float] = Field(description="one value for each axis, inside its range")


class ReportSection(Section):
    """Which pictures to draw."""

    figures: tuple[PictureName, ...] = Field(
        ("bands", "maps", "panoramas", "ringing", "bytes", "degrees"),
        description="pictures of the report; origins (of the 2008 paper's error) costs a second of sampling, gibbs a few",
    )
    cases: tuple[CaseSection, ...] = Field((), description="parameter sets to show beside the worst one")
    scenes: ScenesSection | None = Field(None, description="how large and how exact pictures of scenes are")


class SunSection(Section):
    """Where and when a scene is: what the sun's zenith angle can be."""

    latitude: float = Field(ge=-90.0, le=90.0, description="degrees, north positive")
    dates: tuple[str, str] = Field(description='first and last day, like ["2026-12-01", "2027-01-31"]')


class SceneSection(Section):
    """What a scene needs: what it does not need is not computed."""

    channels: Literal["all", "luminance"] = Field("all", description="all of the light's channels, or luminance alone")
    quantity: Quantity = Field(
        "radiance", description="radiance (for precomputed transfer), or diffuse irradiance in lux, not divided by pi"
    )
    ground: Literal["black", "mirror"] | tuple[Annotated[float, Field(ge=0.0, le=1.0)], ...] = Field(
        "black",
        description="below the horizon: black (the paper), mirror (the sky again), or one albedo a channel, 0 to 1, of an "
        "even ground lit by sky and sun",
    )
    sun_disc: bool = Field(
        False,
        description="whether the sun's disc shines beside the Preetham sky, dimmed by the air of the same turbidity, and "
        "lights the ground",
    )
    twilight: bool = Field(
        False,
        description="whether a sun below the horizon fades the light of a sun on it out, down to 12 degrees; else the "
        "sun's zenith angle is clamped",
    )
    horizon: tuple[Annotated[float, Field(ge=-1.5707963267948966, le=1.5707963267948966)], ...] = Field(
        (),
        max_length=3600,
        description="the skyline's elevations in radians, -pi/2 to pi/2, at even azimuths from east (+x) towards north, "
        "joined by straight lines; what is below it is black, or the ground",
    )
    clouds: CloudsSection | None = Field(None, description="clouds before the sky")
    occluders: tuple[OccluderSection, ...] = Field((), description="black spheres before everything but the lights")
    lights: tuple[Annotated[Lamp, AnyOf(LAMPS, "kind", "a light that never moves")], ...] = Field(
        (), description=f"lights that never move: kind = {', '.join(LAMPS)}"
    )
    mesh: MeshSection | None = Field(None, description="surfaces that the light falls on, whose transfer is computed")
    window: bool = Field(False, description="fold the zonal window of eq. 5 into the weights")
    fixed: dict[str, float] = Field({}, description="parameters that never change, e.g. { turbidity = 3.0 }")
    azimuth: float | None = Field(None, description="the sun's azimuth in radians, if it never changes")
    sun: SunSection | None = Field(None, description="narrows the sun_zenith axis to what the sun reaches there and then")

    @property
    def masked(self) -> bool:
        """Whether anything hides a part of the sky."""
        return bool(self.horizon or self.clouds or self.occluders)

    @property
    def surrounded(self) -> bool:
        """Whether anything in the world stands still while the sun turns."""
        return self.masked or bool(self.lights)


class RunSection(Section):
    """Where the work is done; it changes no result."""

    executor: str = Field(
        "threads",
        pattern=r"^(threads|processes|(tcp|tls)://[A-Za-z0-9_.\[\]:-]+:\d+)$",
        description="threads, processes, or the address of a Dask scheduler such as tcp://127.0.0.1:8786",
    )
    workers: int = Field(0, ge=0, le=1024, description="threads or processes, 0 for one a core")


class Config(Section):
    """One run of the pipeline."""

    name: Name = Field(description="name of the run and of its folder under reports/: lower-case letters, digits, - and _")
    extends: str = Field(
        "",
        description="a config beside this one, or the name of a shipped one such as preetham, of which this one then says "
        "only what differs: tables are merged, axes and references by name",
    )
    light: Annotated[OptionsOfLight, AnyOf(LIGHTS, "model", "the light")]
    axes: tuple[AxisSection, ...] = Field(description="the light's parameters, one [[axes]] table each")
    truth: TruthSection = Field(description="a [truth] section: how the ground truth is sampled")
    fit: FitSection = FitSection.model_construct()
    winners: tuple[WinnerSection, ...] = Field(description="at least one [[winners]] table")
    export: ExportSection = Field(description="an [export] section: what renderers get")
    report: ReportSection = ReportSection.model_construct()
    scene: SceneSection = SceneSection.model_construct()
    views: tuple[ViewSection, ...] = Field((), description="pictures of the scene's mesh, one [[views]] table each")
    run: RunSection = RunSection.model_construct()
    _folder: Path = PrivateAttr(default_factory=Path)

    @property
    def folder(self) -> Path:
        """The folder of the config's file, which paths in it start from."""
        return self._folder

    def within(self, folder: Path) -> Config:
        """Return this config, read from a file in ``folder``."""
        placed = self.model_copy()
        placed._folder = folder
        return placed

    def file(self, name: str) -> Path:
        """Return where the file ``name`` of this config is: in its folder, or else with the shipped configs."""
        own, other = self._folder / name, shipped.folder() / name
        return own if own.is_file() or not other.is_file() else other

    @cached_property
    def source(self) -> Light:
        """The light as the stages see it: its hints shown or hidden, what the scene fixes fixed, its channels."""
        light: Light = self.light if self.truth.hints else BlackBox(self.light)
        if self.scene.fixed:
            light = Fixed(light, tuple(sorted(self.scene.fixed.items())))
        return Luminance(light) if self.scene.channels == "luminance" and len(light.channels) > 1 else light
