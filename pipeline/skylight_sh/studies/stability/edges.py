"""The edges of the parameter space, one ulp either side, outside, and next to the pole."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.config import ConfigError, parse
from skylight_sh.config.schema import Config
from skylight_sh.quadrature import sampling
from skylight_sh.run.provenance import settings
from skylight_sh.runtime import Runtime, Table
from skylight_sh.studies import single_fit
from skylight_sh.studies.grid_samples import Samples, light_alone, sample
from skylight_sh.studies.page import Row, Section
from skylight_sh.table.errors import headline

Array = NDArray[np.float64]

_NODES = 64
_SMALLEST_BUDGET = 5e-5
TEXT = (
    "What was tried, how far off the result is (the bound beside it is what rounding alone may do, or what the table "
    "promises), and what the pipeline does about it."
)


def section(samples: Samples, table: Table) -> Section:
    """Try every edge of the config's axes."""
    config = samples.config
    rows: list[Row] = [
        *_truth_edges(config),
        *_sun_at_zenith(config),
        *_outside(config, table),
        *_refusals(config),
        *_near_the_pole(config),
    ]
    return Section("edges", "Edges, outside, and next to the pole", TEXT, rows)


def _row(what: str, error: float, bound: float, answer: str, otherwise: str = "does not hold") -> Row:
    """Return a row with the answer that its figures give, ``otherwise`` where they are out of bounds."""
    holds = error <= bound
    answer = answer if holds else otherwise
    return {"what": what, "error": error, "bound": bound, "holds": "yes" if holds else "no", "answer": answer}


def _truth_edges(config: Config) -> Iterator[Row]:
    """Truth one ulp inside each end of each axis against the end itself."""
    middle = {a.name: (a.range[0] + a.range[1]) / 2 for a in config.axes}
    for axis in config.axes:
        for end, other in (axis.range, axis.range[::-1]):
            there, inside = (
                _truth(config, {**middle, axis.name: value}) for value in (end, float(np.nextafter(end, other)))
            )
            error = float(np.abs(there - inside).max() / np.abs(there).max())
            yield _row(f"truth at {axis.name} = {end:.6g} against one ulp inside", error, 1e-13, "holds: no special case")


def _sun_at_zenith(config: Config) -> Iterator[Row]:
    """Put the peak at the zenith: the sky is zonal there, and every order m > 0 must vanish."""
    peak = config.source.hints.peak_axis
    if peak is None or not any(a.name == peak and a.range[0] == 0.0 for a in config.axes):
        return
    middle = {a.name: (a.range[0] + a.range[1]) / 2 for a in config.axes}
    weights = _truth(config, {**middle, peak: 0.0})
    error = float(np.abs(weights[..., _held(config).orders != 0]).max() / np.abs(weights).max())
    yield _row("sun at the zenith: weights of orders m > 0", error, 1e-14, "holds: they vanish")


def _outside(config: Config, table: Table) -> Iterator[Row]:
    """Ask the runtime beyond the ranges, at NaN and at infinities."""
    runtime = Runtime(table)
    middle = {a.name: (a.range[0] + a.range[1]) / 2 for a in config.axes} | {"sun_azimuth": 0.3}

    def at(changed: dict[str, float]) -> list[float]:
        return [(middle | changed)[name] for name in runtime.inputs]

    scale = float(np.abs(runtime.weights(*at({}))).max())
    for axis, (low, high) in zip(config.axes, table.ranges, strict=True):
        for value, edge, label in (
            (high + 1.0, high, "1 above its range"),
            (low - 1.0, low, "1 below its range"),
            (math.inf, high, "infinite"),
            (float(np.nextafter(np.float32(high), np.float32(np.inf))), high, "one float32 ulp above its range"),
        ):
            got, status = runtime.weights_and_status(*at({axis.name: value}))
            at_edge = runtime.weights(*at({axis.name: edge}))
            error = float(np.abs(got - at_edge).max()) / scale
            told = {0: "takes it as inside (a millionth counts as inside)", 1: "clamps, and returns 1"}[int(status)]
            yield _row(f"{axis.name} {label}", error, 1e-6, told)
        got, status = runtime.weights_and_status(*at({axis.name: math.nan}))
        yield _row(f"{axis.name} is NaN", float(np.abs(got).max()), 0.0, f"zeroes the weights, and returns {int(status)}")


def _refusals(config: Config) -> Iterator[Row]:
    """Configs that reach beyond the light's domain."""
    domains = config.source.domains
    for i, axis in enumerate(config.axes):
        domain = domains[axis.name]
        for value, end in ((domain.low - 0.1, 0), (domain.high + 0.1, 1)):
            raw = light_alone(settings(config))
            raw["axes"][i]["range"][end] = value
            try:
                parse(raw, "a config")
            except ConfigError as error:
                told = [line.strip() for line in str(error).splitlines() if f"$.axes[{i}]" in line]
                answer = f"refuses: {told[0]}" if told else ""
                yield _row(f"a config asks for {axis.name} = {value:.4g}", 0.0 if told else math.inf, 0.0, answer)
            else:
                yield _row(
                    f"a config asks for {axis.name} = {value:.4g}", math.inf, 0.0, "", "runs, though the light ends before"
                )


def _near_the_pole(config: Config) -> Iterator[Row]:
    """Fit over ranges that end next to the light's pole."""
    if config.light.model != "preetham":
        return
    for low in (2.5, 2.0, 1.8, 1.7):
        axes = tuple(a.model_copy(update={"range": (low, a.range[1])}) if a.name == "turbidity" else a for a in config.axes)
        near = sample(config.model_copy(update={"axes": axes}), bands=4, random=200)
        error = _whole_error(near)
        what = f"all degrees of the config, 4 bands, turbidity from {low:g} (the pole is at 1.643)"
        yield _row(what, error, _SMALLEST_BUDGET, "fits", "the selection refuses the budget and names the error reached")


def _whole_error(samples: Samples) -> float:
    config = samples.config
    made = single_fit.fit(samples, samples.half, [a.degrees[1] for a in config.axes], "chebyshev", "svd", single_fit.OWN)
    return headline(single_fit.table_of(samples, made, "float64"), samples.reference)


def _held(config: Config) -> sphere.Harmonics:
    return sphere.Harmonics(config.truth.bands, config.source.hints.mirrored)


def _truth(config: Config, values: dict[str, float]) -> Array:
    names = tuple(a.name for a in config.axes)
    block = np.array([[[values[name] for name in names]]])
    job = sampling.Job(config.source, names, block, _NODES, _held(config))
    return sampling.project_block(job).weights
