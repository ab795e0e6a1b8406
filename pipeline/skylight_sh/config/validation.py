"""What the schema cannot see: whether a config's numbers fit its light and each other."""

from __future__ import annotations

import math
from collections.abc import Iterator

from skylight_sh.config import scenes_validation, surroundings_validation, views_validation
from skylight_sh.config.problem import Problem
from skylight_sh.config.schema import AxisSection, Config
from skylight_sh.config.wanted import table_names
from skylight_sh.export import reserved
from skylight_sh.export.targets import ALWAYS, TARGETS
from skylight_sh.formula.bases import BASES
from skylight_sh.light.preetham import Preetham

# A run's length has five bits.
_PACKED_DEGREE = 30
# So many parameter sets of one grid would not fit into memory.
_MOST_SETS = 300_000


def find(config: Config) -> list[Problem]:
    """Return every problem of a config that satisfies the schema."""
    return [
        *_scene(config),
        *surroundings_validation.find(config),
        *views_validation.find(config),
        *_axes(config),
        *_fit(config),
        *_winners(config),
        *_cases(config),
        *_names(config),
        *_export(config),
        *scenes_validation.find(config),
    ]


def _scene(config: Config) -> Iterator[Problem]:
    domains = config.light.domains
    for name, value in config.scene.fixed.items():
        path = f"$.scene.fixed.{name}"
        if name not in domains:
            yield Problem(path, value, f"The light has no such parameter. Use one of: {', '.join(domains)}.")
        elif not domains[name].low <= value <= domains[name].high:
            domain = domains[name]
            yield Problem(path, value, f"Stay within [{domain.low:.9g}, {domain.high:.9g}]: {domain.why}.")
        elif any(axis.name == name for axis in config.axes):
            yield Problem(path, value, f"A fixed parameter is no axis. Remove the [[axes]] table of {name}, or fix nothing.")

    if config.scene.sun_disc and not isinstance(config.light, Preetham):
        remedy = "The disc's dimming is Preetham's, by turbidity. Use model = \"preetham\", or leave the disc out."
        yield Problem("$.scene.sun_disc", True, remedy)
    peak = config.light.hints.peak_axis
    if config.scene.twilight and not any(axis.name == peak and axis.range[1] == math.pi / 2 for axis in config.axes):
        remedy = f"The fade begins on the horizon. Give {peak or 'the sun'} an axis whose range ends at 1.5707963267948966."
        yield Problem("$.scene.twilight", True, remedy)
    ground, channels = config.scene.ground, len(config.source.channels)
    if not isinstance(ground, str) and len(ground) != channels:
        yield Problem(
            "$.scene.ground",
            list(ground),
            f"Give one albedo for each channel ({', '.join(config.source.channels)}), or black or mirror.",
        )
    fewest = min((config.truth.bands, *(winner.bands for winner in config.winners if config.scene.masked)))
    if not isinstance(ground, str) and fewest < 2:
        yield Problem("$.scene.ground", list(ground), "A lit ground needs at least 2 bands.")


def _axes(config: Config) -> Iterator[Problem]:
    domains = {name: domain for name, domain in config.light.domains.items() if name not in config.scene.fixed}
    if not config.axes:
        remedy = "At least one axis is needed. For a sun that never moves give its axis range = [v, v], nodes = 1, "
        yield Problem("$.axes", [], f"{remedy}verification = 1 and degrees = [0, 0].")
        return
    given = [axis.name for axis in config.axes]
    missing = [name for name in domains if name not in given]
    if missing:
        yield Problem(
            "$.axes",
            given,
            f"The light has parameters {', '.join(domains)}; add an [[axes]] table for {', '.join(missing)}.",
        )
    for i, axis in enumerate(config.axes):
        path = f"$.axes[{i}]"
        if axis.name in domains and not reserved.usable(axis.name):
            remedy = "A parameter's name becomes a name in C and in files: lower-case letters, digits and _, not x0, not"
            yield Problem(f"{path}.name", axis.name, f"{remedy} {', '.join(sorted(reserved.NAMES))}.")
        if axis.name not in domains:
            yield Problem(f"{path}.name", axis.name, f"The light has no such parameter. Use one of: {', '.join(domains)}.")
        elif axis.name in given[:i]:
            yield Problem(f"{path}.name", axis.name, "This parameter stands twice. Remove one of its [[axes]] tables.")
        else:
            domain = domains[axis.name]
            low, high = axis.range
            if low > high or (low == high and axis.degrees != (0, 0)):
                remedy = "Give [low, high] with low < high, or degrees = [0, 0] for a value that never changes"
                yield Problem(f"{path}.range", list(axis.range), f"The range is empty. {remedy}.")
            elif low < domain.low or high > domain.high:
                allowed = f"[{domain.low:.9g}, {domain.high:.9g}] {domain.unit if domain.unit != '1' else ''}".rstrip()
                yield Problem(f"{path}.range", list(axis.range), f"Stay within {allowed}: {domain.why}.")
        yield from _axis_numbers(path, axis)
    for key in ("nodes", "verification"):
        sets = math.prod(getattr(axis, key) for axis in config.axes)
        if sets > _MOST_SETS:
            yield Problem(f"$.axes[*].{key}", sets, f"That many parameter sets; a grid may have {_MOST_SETS}. Lower {key}.")


def _axis_numbers(path: str, axis: AxisSection) -> Iterator[Problem]:
    low, high = axis.range
    least, largest = axis.degrees
    if axis.map == "log" and axis.point >= low:
        yield Problem(f"{path}.point", axis.point, f'map = "log" needs a point below the range: less than {low:.9g}.')
    if axis.map == "cbrt" and axis.point < high:
        yield Problem(f"{path}.point", axis.point, f'map = "cbrt" needs a point not below the range: at least {high:.9g}.')
    if axis.map == "reciprocal" and low <= axis.point <= high:
        yield Problem(f"{path}.point", axis.point, f'map = "reciprocal" needs a point outside [{low:.9g}, {high:.9g}].')
    if abs(axis.point) > 1e6:
        yield Problem(f"{path}.point", axis.point, "Stay within -1e6 and 1e6: farther away a map is the identity.")
    if least > largest:
        yield Problem(
            f"{path}.degrees", list(axis.degrees), "The range is empty. Give [least, largest] with least <= largest."
        )
    if axis.nodes <= largest:
        yield Problem(f"{path}.nodes", axis.nodes, f"Degree {largest} needs at least {largest + 1} nodes.")
    if axis.verification < 4 * largest:
        yield Problem(
            f"{path}.verification", axis.verification, f"Degree {largest} needs at least {4 * largest} verification nodes."
        )


def _fit(config: Config) -> Iterator[Problem]:
    fit = config.fit
    if fit.prefactor == "auto" and fit.basis != "chebyshev":
        yield Problem("$.fit.prefactor", fit.prefactor, 'The search needs basis = "chebyshev". Use true or false.')
    if fit.solver == "normal" and fit.basis == "chebyshev":
        yield Problem("$.fit.solver", fit.solver, 'Normal equations are for basis = "monomial". Use solver = "svd".')
    if any(axis.degrees[0] != axis.degrees[1] for axis in config.axes) and not BASES[fit.basis].nested:
        yield Problem(
            "$.fit.basis", fit.basis, 'Only nested bases are swept. Use "chebyshev", or degrees = [d, d] on every axis.'
        )
    names = [reference.name for reference in fit.references]
    for i, reference in enumerate(fit.references):
        path = f"$.fit.references[{i}]"
        if reference.name == "sweep" or reference.name in table_names(config):
            yield Problem(f"{path}.name", reference.name, "The sweep or a winner has this name. Choose another.")
        if reference.name in names[:i]:
            yield Problem(f"{path}.name", reference.name, "This name stands twice. Give every reference its own.")
        yield from _degrees(config, f"{path}.degrees", reference.degrees, [axis.nodes - 1 for axis in config.axes])


def _winners(config: Config) -> Iterator[Problem]:
    for i, winner in enumerate(config.winners):
        path = f"$.winners[{i}]"
        if winner.bands > config.truth.bands:
            yield Problem(
                f"{path}.bands", winner.bands, f"The truth has {config.truth.bands} bands. Use fewer, or raise truth.bands."
            )
        if (winner.degrees is None) == (not winner.budgets and not winner.sizes):
            given = {"budgets": list(winner.budgets), "sizes": list(winner.sizes)}
            yield Problem(path, given, "Give either budgets or sizes, or degrees.")
        if winner.degrees is not None:
            yield from _degrees(config, f"{path}.degrees", winner.degrees, [axis.degrees[1] for axis in config.axes])
        if "packed" in winner.layouts and config.axes and config.axes[0].degrees[1] > _PACKED_DEGREE:
            remedy = f"Packed tables hold degrees up to {_PACKED_DEGREE} of the first axis. Lower its degrees, or use rows"
            yield Problem(f"{path}.layouts", list(winner.layouts), f"{remedy}.")
        if "packed" in winner.layouts and (winner.degrees is not None or winner.dtype != "float32"):
            yield Problem(
                f"{path}.layouts", list(winner.layouts), 'Packed tables need budgets and dtype = "float32". Use ["rows"].'
            )
        if (winner.budgets or winner.sizes) and not BASES[config.fit.basis].nested:
            yield Problem(f"{path}.budgets", list(winner.budgets), 'Budgets need basis = "chebyshev"; give degrees instead.')


def _cases(config: Config) -> Iterator[Problem]:
    ranges = {axis.name: axis.range for axis in config.axes}
    titles = [case.title for case in config.report.cases]
    for i, case in enumerate(config.report.cases):
        if case.title in titles[:i]:
            yield Problem(f"$.report.cases[{i}].title", case.title, "This title stands twice. Give every case its own.")
        path = f"$.report.cases[{i}].at"
        if set(case.at) != set(ranges):
            yield Problem(path, case.at, f"Give one value for each axis: {', '.join(ranges)}.")
            continue
        for name, value in case.at.items():
            low, high = ranges[name]
            # A range that is none is told by itself.
            if low <= high and not low <= value <= high:
                yield Problem(f"{path}.{name}", value, f"Stay within the axis's range [{low:.9g}, {high:.9g}].")


def _degrees(config: Config, path: str, degrees: tuple[int, ...], largest: list[int]) -> Iterator[Problem]:
    if len(degrees) != len(config.axes):
        yield Problem(path, list(degrees), f"Give one degree for each of the {len(config.axes)} axes.")
    elif any(d > top for d, top in zip(degrees, largest, strict=True)):
        yield Problem(path, list(degrees), f"Stay within {largest}, one largest degree an axis.")


def _names(config: Config) -> Iterator[Problem]:
    if config.name == "reference":
        yield Problem("$.name", config.name, "reports/reference holds the released result. Choose another name.")
    names = table_names(config)
    if not names:
        yield Problem("$.winners", [], "Nothing to select. Add a [[winners]] table with bands and budgets, or degrees.")
        return
    for name in sorted({n for n in names if names.count(n) > 1}):
        yield Problem("$.winners", name, "Two winners get this name. Remove one of them.")
    if config.export.recommended not in names:
        yield Problem(
            "$.export.recommended", config.export.recommended, f"No winner has this name. Use one of: {', '.join(names)}."
        )


def _export(config: Config) -> Iterator[Problem]:
    export = config.export
    if not set(ALWAYS) <= set(export.targets):
        yield Problem("$.export.targets", list(export.targets), 'Every run ships the header and the NPZ. Add "c" and "npz".')
    scene = config.scene.model_dump(mode="json")
    for name in dict.fromkeys(export.targets):
        # What every run ships fits every light.
        why = None if name in ALWAYS else TARGETS[name].misfit(config.light, scene)
        if why:
            yield Problem("$.export.targets", list(export.targets), f'"{name}": {why}, or "{name}" out of export.targets.')
    if export.prefix.startswith(("gl_", "webgl_")) or "__" in export.prefix or export.prefix.endswith("_"):
        remedy = "C++ or shading languages reserve it: no gl_, webgl_, __ or _ at the end."
        yield Problem("$.export.prefix", export.prefix, remedy)
