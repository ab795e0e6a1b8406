"""What a config's run consists of: every step, what it reads and what its result hangs on.

A step's function stands in a stage's file, ``run/stages/``, and is imported when the step is made: a run whose artifacts are
all in the store loads none of the numerics.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from skylight_sh import __version__, shipped
from skylight_sh.config.scenes_schema import ScenesSection
from skylight_sh.config.schema import Config
from skylight_sh.config.section import Section
from skylight_sh.config.wanted import wanted
from skylight_sh.report.figures import SCENES
from skylight_sh.run.code import Later
from skylight_sh.run.mesh_source import MADE, MeshSource
from skylight_sh.run.plan import Step
from skylight_sh.run.provenance import drawing, settings
from skylight_sh.scene.surroundings import MOST_BANDS
from skylight_sh.transfer.options import Options

RULE, GRID, VERIFICATION, RANDOM, HELD_OUT = (
    f"truth/{part}" for part in ("rule", "grid", "verification", "random", "held-out")
)
PROBE, VARIABLES, SURROUNDINGS = (f"truth/{part}" for part in ("probe", "variables", "surroundings"))
ORIGINS = "fit/origins"
TRANSFER, GATHER = "transfer", "transfer/gather"
ENGINES = "engines"
LIGHTING = "measure/lighting"
# The tightest budget of the default config.
_TIGHT = 5e-5
# The steps of pictures of scenes: what they read, and what makes them.
_PICTURES = {
    "pictures/courtyard": (("select",), "courtyard:make"),
    "pictures/ten_lights": ((), "ten_lights:make"),
    "pictures/relief": (("pictures/courtyard",), "relief:make"),
}


def steps(config: Config) -> list[Step]:
    """Return the whole plan of a config, each step after those that it reads.

    What the config's own pictures and lamps may still have wrong with them is told first.
    """
    stages = (
        _surroundings,
        _truth,
        _variables,
        _fit,
        _origins,
        _select,
        _measure,
        _lighting,
        _transfer,
        _engines,
        _scenes,
        _export,
        _report,
    )
    return [step for stage in stages for step in stage(config)]


def is_searched(config: Config) -> bool:
    """Say whether any change of variable or the prefactor is to be found from samples."""
    return config.fit.prefactor == "auto" or any(axis.map == "auto" for axis in config.axes)


def shows_origins(config: Config) -> bool:
    """Say whether the report shows the origins, which are those of radiance above a black ground, as in the paper."""
    scene = config.scene
    shown = "origins" in config.report.figures
    return shown and scene.quantity == "radiance" and scene.ground == "black" and not scene.sun_disc


def shows_lighting(config: Config) -> bool:
    """Say whether the report shows what lit surfaces lose."""
    return "lighting_error" in config.report.figures


def shown_scenes(config: Config) -> tuple[str, ...]:
    """Return the names of the steps that make the report's pictures of scenes."""
    shown = {step for name in config.report.figures for step in SCENES.get(name, ())}
    return tuple(step for step in _PICTURES if step in shown)


def selected_on(config: Config) -> tuple[str, ...]:
    """Return the names of the truth's steps that selection sees."""
    return (VERIFICATION, *((RANDOM,) if config.truth.random else ()))


def middle_budget(config: Config) -> float:
    """Return the error that the search for variables aims at: the middle one of all budgets asked for."""
    budgets = sorted(budget for winner in config.winners for budget in winner.budgets)
    return budgets[len(budgets) // 2] if budgets else 1e-3


def allowed_error(config: Config) -> float | None:
    """Return the E_mean that the truth itself may have, a fiftieth of the tightest budget; None where there is no budget.

    Loose budgets share the truth of ``_TIGHT``: to change one of them samples nothing anew, and errors of other tables and
    fits are published to a hundredth of it.
    """
    budgets = [budget for winner in config.winners for budget in winner.budgets]
    return min(_TIGHT, *budgets) / 50 if budgets else None


def surroundings_bands(config: Config) -> list[int]:
    """Return the winners' numbers of bands, and that of a wider sky to hold their products against."""
    asked = {winner.bands for winner in config.winners}
    return sorted(asked | {min(config.truth.bands, MOST_BANDS)} if config.scene.masked else asked)


def mesh_source(config: Config) -> MeshSource | None:
    """Return which mesh the scene has, and how its transfer is computed; None where it has none."""
    mesh = config.scene.mesh
    if mesh is None:
        return None
    bands = mesh.bands or next((table.bands for table in wanted(config) if table.name == config.export.recommended), 0)
    options = Options(bands, mesh.rays, mesh.gather_rays, mesh.bounces, mesh.seed)
    return MeshSource(Path(mesh.file) if mesh.file in MADE else config.file(mesh.file), options, mesh.up, mesh.unshadowed)


def transfer_step(source: MeshSource, executor: str = "threads", workers: int = 0) -> Step:
    """Return the step that computes the transfer of a mesh."""
    make = _later("transfer:make", source, executor, workers)
    return Step(TRANSFER, "", (), source.parameters(), make, in_blocks=True)


def gather_step(source: MeshSource, executor: str = "threads", workers: int = 0) -> Step:
    """Return the step that computes by what matrix light bounces between the vertices of a mesh; no run needs it."""
    stage, _, part = GATHER.partition("/")
    make = _later("gathering:make", source, executor, workers)
    return Step(stage, part, (), source.parameters(), make, in_blocks=True)


def _transfer(config: Config) -> Iterator[Step]:
    """Yield the step, if the scene has a mesh."""
    source = mesh_source(config)
    if source is not None:
        yield transfer_step(source, config.run.executor, config.run.workers)


def _engines(config: Config) -> Iterator[Step]:
    """Yield the step, if the scene has a mesh that the recommended table can light."""
    source = mesh_source(config)
    if source is None or not _lights(config, source.options.bands):
        return
    parameters = {
        "recommended": config.export.recommended,
        "fixed": config.scene.fixed,
        "colour_space": getattr(config.light, "colour_space", ""),
        "version": __version__,
    }
    make = _later("engines:make", config, source)
    yield Step(ENGINES, "", (TRANSFER, "select"), parameters, make)


def _lights(config: Config, bands: int) -> bool:
    """Say whether the recommended table lights a mesh of transfer of so many bands in red, green and blue, or in grey."""
    known = next((table.bands for table in wanted(config) if table.name == config.export.recommended), 0)
    return config.scene.quantity == "radiance" and len(config.source.channels) in (1, 3) and known >= bands


def _around(config: Config) -> dict[str, Any]:
    """Return what of the scene decides the weights of its light: all but the mesh that the light falls on."""
    return config.scene.model_dump(mode="json", exclude={"mesh"})


def _searched(config: Config) -> tuple[str, ...]:
    return (VARIABLES,) if is_searched(config) else ()


def _surrounded(config: Config) -> tuple[str, ...]:
    return (SURROUNDINGS,) if config.scene.surrounded else ()


def _step(name: str, inputs: tuple[str, ...], parameters: Any, make: str, config: Config) -> Step:
    stage, _, part = name.partition("/")
    return Step(stage, part, inputs, parameters, _later(make, config))


def _later(make: str, *arguments: Any) -> Later:
    return Later(f"skylight_sh.run.stages.{make}", arguments)


def _truth(config: Config) -> Iterator[Step]:
    truth = config.truth
    common = {
        "light": _light(config),
        "ranges": [(axis.name, axis.range) for axis in config.axes],
        "bands": truth.bands,
        "tolerance": truth.tolerance,
        "error": allowed_error(config) if truth.tolerance == "auto" else None,
        "orders": truth.orders,
        "rule": truth.rule,
        "hints": truth.hints,
        # Of the scene only what the light itself loses by it.
        "scene": {"fixed": config.scene.fixed, "channels": config.scene.channels},
    }
    yield _step(RULE, (), common, "truth:make_rule", config)
    needed, spacing = (RULE, *_searched(config)), _spacing(config)
    yield _step(GRID, needed, spacing, "truth:make_grid", config)
    checked = {"fit": spacing, "count": [(axis.name, axis.verification) for axis in config.axes]}
    yield _step(VERIFICATION, needed, checked, "truth:make_verification", config)
    if truth.random:
        yield _step(RANDOM, (RULE,), {"count": truth.random, "seed": truth.seed}, "truth:make_random", config)
    kept = {"count": truth.held_out, "edge": truth.held_out_edge, "seed": truth.held_out_seed}
    yield _step(HELD_OUT, (RULE,), kept, "truth:make_held_out", config)


def _variables(config: Config) -> Iterator[Step]:
    """Yield a grid in the parameters themselves and the search; nothing where nothing is searched."""
    if is_searched(config):
        spacing = _spacing(config)
        yield _step(PROBE, (RULE,), spacing, "truth:make_probe", config)
        searched = {"nodes": spacing, "prefactor": config.fit.prefactor, "budget": middle_budget(config)}
        yield _step(VARIABLES, (PROBE,), searched, "variables:make", config)


def _surroundings(config: Config) -> Iterator[Step]:
    """Yield the step; nothing where nothing surrounds the scene."""
    scene = config.scene
    if scene.surrounded:
        pictures = [lamp.image for lamp in scene.lights if lamp.image] + ([scene.clouds.image] if scene.clouds else [])
        parameters = {
            "scene": _around(config),
            "pictures": [_sum(config.file(image)) for image in pictures],
            "reader": _reader() if pictures else "",
            "bands": surroundings_bands(config),
            "channels": config.source.channels,
        }
        yield _step(SURROUNDINGS, (), parameters, "surroundings:make", config)


def _fit(config: Config) -> Iterator[Step]:
    """Yield one fit of the whole grid, with the fits shown beside it."""
    parameters = {
        "axes": _dump(config.axes),
        "fit": config.fit.model_dump(mode="json"),
        "light": _light(config),
        "scene": _around(config),
    }
    yield _step("fit", (GRID, *_searched(config), *_surrounded(config)), parameters, "fit:make", config)


def _origins(config: Config) -> Iterator[Step]:
    """Yield the step, if the report shows its picture."""
    if shows_origins(config):
        parameters = {"light": _light(config), "axes": _dump(config.axes), "scene": _around(config)}
        yield _step(ORIGINS, (GRID, *_searched(config), *selected_on(config)), parameters, "origins:make", config)


def _select(config: Config) -> Iterator[Step]:
    needed = ("fit", GRID, *_searched(config), *_surrounded(config), *selected_on(config))
    yield _step("select", needed, {"winners": _dump(config.winners)}, "select:make", config)


def _measure(config: Config) -> Iterator[Step]:
    needed = ("fit", "select", HELD_OUT, VERIFICATION, *_searched(config), *_surrounded(config))
    yield _step("measure", needed, {}, "measure:make", config)


def _lighting(config: Config) -> Iterator[Step]:
    """Yield the step, if the report shows its picture."""
    if shows_lighting(config):
        parameters = {
            "light": _light(config),
            "ranges": [(axis.name, axis.range) for axis in config.axes],
            "scene": _around(config),
            "tolerance": config.truth.stated_tolerance,
        }
        yield _step(LIGHTING, ("select",), parameters, "lighting:make", config)


def _scenes(config: Config) -> Iterator[Step]:
    """Yield the steps of the pictures that the report shows."""
    asked = (config.report.scenes or ScenesSection.model_construct()).model_dump(mode="json")
    parameters = {"light": _light(config), "axes": _dump(config.axes), "fixed": config.scene.fixed, "scenes": asked}
    for name in shown_scenes(config):
        needed, make = _PICTURES[name]
        yield _step(name, needed, parameters, make, config)


def _export(config: Config) -> Iterator[Step]:
    parameters = {"config": settings(config), "targets": config.export.targets, "version": __version__}
    yield _step("export", ("select", "measure"), parameters, "export:make", config)


def _report(config: Config) -> Iterator[Step]:
    speed = shipped.speed()
    parameters = {"config": settings(config), "drawing": drawing(), "speed": _sum(speed) if speed else ""}
    explained = ((ORIGINS,) if shows_origins(config) else ()) + ((LIGHTING,) if shows_lighting(config) else ())
    explained += shown_scenes(config)
    needed = (RULE, VERIFICATION, "fit", "select", "measure", *_searched(config), *_surrounded(config), *explained)
    yield _step("report", needed, parameters, "report:make", config)


def _spacing(config: Config) -> list[tuple[object, ...]]:
    """Return what decides the fit grid; a list, since the order of the axes is the order of the samples."""
    return [(axis.name, axis.nodes, axis.spacing, axis.map, axis.point) for axis in config.axes]


def _light(config: Config) -> dict[str, Any]:
    return {**asdict(config.light), "version": config.light.version}


def _dump(sections: Sequence[Section]) -> list[Any]:
    return [section.model_dump(mode="json") for section in sections]


def _reader() -> str:
    try:
        return version("OpenImageIO")
    except PackageNotFoundError:
        return ""


def _sum(file: Path) -> str:
    """Return the SHA-256 of a file, or nothing where it cannot be read: the step then tells why."""
    try:
        return hashlib.sha256(file.read_bytes()).hexdigest()
    except OSError:
        return ""
