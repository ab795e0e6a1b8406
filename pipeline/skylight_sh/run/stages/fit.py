"""Fit: one fit of the whole grid, and the fits shown beside it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from functools import partial

import numpy as np
from numpy.typing import NDArray

from skylight_sh.config.schema import Config, ReferenceSection
from skylight_sh.export import npz
from skylight_sh.fit import least_squares
from skylight_sh.fit.axis import Axis
from skylight_sh.fit.bases import BASES
from skylight_sh.fit.errors import Reference, mean_luminance
from skylight_sh.fit.sweep import Worst, sweep
from skylight_sh.quadrature import parameter_points as parameter_sets
from skylight_sh.run.executors import Advance
from skylight_sh.run.plan import Inputs, Step
from skylight_sh.scene.axes import axes_of, fit_nodes, variables
from skylight_sh.scene.fold import folded, luminance_scale
from skylight_sh.scene.frame import factor_of, frame_of, surrounded
from skylight_sh.store.dataset import Dataset, Variable
from skylight_sh.table import prefactor as factors
from skylight_sh.table.table import Frame, Table, whole

Array = NDArray[np.float64]


def truth_inputs(config: Config) -> tuple[str, ...]:
    """Return the names of the truth steps that selection sees."""
    return ("truth/verification", *(("truth/random",) if config.truth.random else ()))


def steps(config: Config) -> list[Step]:
    """Return the fit's step."""
    parameters = {
        "axes": [axis.model_dump(mode="json") for axis in config.axes],
        "fit": config.fit.model_dump(mode="json"),
        "light": {**asdict(config.light), "version": config.light.version},
        "scene": config.scene.model_dump(mode="json"),
    }
    needed = ("truth/grid", *variables(config), *surrounded(config))
    return [Step("fit", "", needed, parameters, partial(_make, config))]


def reference_of(config: Config, inputs: Inputs, truths: Sequence[str]) -> Reference:
    """Gather the steps ``truths``, grids or lists of sets, into what errors are measured against."""
    parts = [inputs[name] for name in truths]
    names = [axis.name for axis in config.axes]
    parameters = []
    for part in parts:
        columns = [part[name] for name in names]
        parameters.append(np.stack(columns, axis=-1) if "set" in part.variables else parameter_sets.grid(columns))
    weights = np.concatenate([p["weights"].reshape(-1, *p["weights"].shape[-2:]) for p in parts])
    scale, sets = luminance_scale(config), np.concatenate(parameters)
    return Reference(
        parameters=sets,
        weights=folded(config, weights, parts[0]["degree"], sets),
        degrees=parts[0]["degree"],
        least=scale * np.concatenate([p["least_luminance"].ravel() for p in parts]),
        mean=scale * mean_luminance(weights[:, :, 0], config.source.luminance_row),
    )


def _make(config: Config, inputs: Inputs, advance: Advance) -> Dataset:
    grid = inputs["truth/grid"]
    mirrored = bool(grid.attrs["mirrored"])
    frame = frame_of(config, inputs, mirrored=mirrored)
    axes, nodes = frame.axes, fit_nodes(config, frame.axes)
    shape, outputs = grid["weights"].shape[:-2], grid["weights"].shape[-2:]
    flat = parameter_sets.grid(nodes)
    samples = folded(config, grid["weights"], grid["degree"], flat.reshape(*shape, -1))
    scaled = samples / factors.evaluate(frame.factor, axes, flat).reshape(*shape, 1, 1)
    basis = BASES[config.fit.basis]
    matrices = [basis.vander(a.scaled(n), s.degrees[1]) for a, n, s in zip(axes, nodes, config.axes, strict=True)]
    flattened = scaled.reshape(*shape, -1)
    if config.fit.solver == "svd":
        solution = least_squares.fit_tensor(flattened, matrices)
    else:
        solution = least_squares.fit_full(flattened, matrices, config.fit.solver)
    coefficients = solution.reshape(*outputs, *solution.shape[1:])

    powers = tuple(f"power_{axis.name}" for axis in axes)
    found = {
        "coefficients": Variable(("channel", "weight", *powers), coefficients),
        "condition": Variable((), np.array(least_squares.condition(matrices))),
    }
    for done, section in enumerate(config.fit.references):
        advance(done, len(config.fit.references))
        table, condition = fit_reference(config, section, samples, axes, nodes, mirrored)
        start = f"references/{section.name}"
        found[f"{start}/npz"] = Variable(("byte",), np.frombuffer(npz.write(table), dtype=np.uint8))
        found[f"{start}/condition"] = Variable((), np.array(condition))
    return Dataset(found, {"mirrored": mirrored})


def swept(config: Config, inputs: Inputs, reference: Reference, bands: int) -> Worst:
    """Measure every combination of the config's degrees for 1 to ``bands`` bands, truncations of the one fit."""
    axes, fit = axes_of(config, inputs), inputs["fit"]
    vander = BASES[config.fit.basis].vander
    vanders = [
        vander(axis.scaled(reference.parameters[:, i]), s.degrees[1])
        for i, (axis, s) in enumerate(zip(axes, config.axes, strict=True))
    ]
    degrees = [range(s.degrees[0], s.degrees[1] + 1) for s in config.axes]
    factor = np.asarray(factors.evaluate(factor_of(config, inputs), axes, reference.parameters), dtype=np.float64)
    return sweep(fit["coefficients"], vanders, factor, reference, degrees, bands)


def fit_reference(
    config: Config, section: ReferenceSection, samples: Array, axes: tuple[Axis, ...], nodes: list[Array], mirrored: bool
) -> tuple[Table, float]:
    """Fit a reference by its own basis, solver and variables; return its table and its system's condition number."""
    kind = "identity" if section.scaled else "raw"
    plain = tuple(Axis(a.name, a.low, a.high, a.unit, kind) for a in axes)
    vander = BASES[section.basis].vander
    matrices = [vander(a.scaled(n), d) for a, n, d in zip(plain, nodes, section.degrees, strict=True)]
    solution = least_squares.fit_full(samples.reshape(-1, samples.shape[-2] * samples.shape[-1]), matrices, section.solver)
    dense = solution.reshape(*samples.shape[-2:], *solution.shape[1:])
    frame = Frame(plain, config.source.channels, mirrored, section.basis, None)
    return whole(frame, dense, config.truth.bands, section.dtype), least_squares.condition(matrices)
