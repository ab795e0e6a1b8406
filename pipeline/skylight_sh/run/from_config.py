"""A config and the steps' results as the plain objects that the numerics take: scene, factor, specification, errors."""

from __future__ import annotations

import io
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from skylight_sh import runtime
from skylight_sh.config.schema import Config
from skylight_sh.fit.errors import Reference, mean_luminance, published
from skylight_sh.light.preetham import Preetham
from skylight_sh.quadrature import parameter_points
from skylight_sh.run.config_axes import axes_of, harmonics_of
from skylight_sh.run.plan import Inputs
from skylight_sh.run.steps import SURROUNDINGS, VARIABLES
from skylight_sh.runtime import Scale, Specification, Surroundings, Table
from skylight_sh.scene.fold import Scene, Sun, fold, luminance_scale
from skylight_sh.sphere import Harmonics
from skylight_sh.store.dataset import Dataset
from skylight_sh.table.grid_fit import GridFit
from skylight_sh.table.prefactor import closed_form, reciprocal
from skylight_sh.table.surroundings import PARTS
from skylight_sh.table.table import specification
from skylight_sh.table.twilight import TWILIGHT

Array = NDArray[np.float64]


def scene_of(config: Config) -> Scene:
    """Return what of the config's scene is folded into the weights; what hides the sky takes the ground with it."""
    scene = config.scene
    return Scene(
        axes=tuple(axis.name for axis in config.axes),
        fixed=scene.fixed,
        quantity=scene.quantity,
        ground="black" if scene.masked and scene.ground != "mirror" else scene.ground,
        sun=_sun(config) if scene.sun_disc else None,
        windowed=scene.window,
    )


def _sun(config: Config) -> Sun | None:
    light = config.light
    peak = light.hints.peak_axis
    if not isinstance(light, Preetham) or peak is None:
        return None
    return Sun(peak, "turbidity", light.colour_space, light.luminance_row if config.scene.channels == "luminance" else None)


def scale_of(config: Config, inputs: Inputs) -> Scale | None:
    """Return what the fit divides by: the light's closed form, a polynomial's reciprocal found in samples, or nothing."""
    axes = tuple(axis.specified for axis in axes_of(config, inputs))
    if config.fit.prefactor == "auto":
        return reciprocal(inputs[VARIABLES]["denominator"], axes)
    hints = config.source.hints
    hint = hints.classes if hints.classes and parity_of(config) else hints.prefactor
    if not (config.fit.prefactor and hint):
        return None
    return closed_form(hint, axes, config.scene.fixed)


def parity_of(config: Config) -> str:
    """Return the axis about which the fit uses the weights' parity, or nothing: that of the peak, if its map is even.

    It needs the light's factors, and a scene that leaves its classes what they are: the sun's disc has other colours, and an
    uneven ground mixes each channel otherwise.
    """
    hints, scene = config.source.hints, config.scene
    even = [axis.name for axis in config.axes if axis.map == "even"]
    ground = scene_of(config).ground
    albedos = set() if isinstance(ground, str) else set(ground)
    mixes = scene.sun_disc or (hints.classes is not None and len(albedos) > 1)
    used = hints.parity and hints.peak_axis in even and config.fit.prefactor is True and not mixes
    return str(hints.peak_axis) if used else ""


def surroundings_of(inputs: Inputs) -> dict[int, Surroundings]:
    """Return the surroundings by the number of bands; none where there are none."""
    if SURROUNDINGS not in inputs:
        return {}
    made = inputs[SURROUNDINGS]
    bands = sorted({int(name.split("/")[1]) for name in made.variables})
    return {n: Surroundings(*(made[f"{part}/{n}"] for part in PARTS)) for n in bands}


def specification_of(config: Config, inputs: Inputs, harmonics: Harmonics) -> Specification:
    """Return what all tables of a run's fit have in common: axes, channels, factor, and what the scene folds in."""
    # What a table's inputs mean is no secret, even where a fit is to know nothing of its light.
    scene, peak = config.scene, config.light.hints.peak_axis
    return specification(
        axes_of(config, inputs),
        config.source.channels,
        harmonics.mirrored,
        config.fit.basis,
        scale_of(config, inputs),
        quantity=scene.quantity,
        windowed=scene.window,
        azimuth=scene.azimuth,
        ground=scene.ground,
        sun_disc=scene.sun_disc,
        peak_axis=peak if peak in [axis.name for axis in config.axes] else None,
        twilight=TWILIGHT if scene.twilight else None,
        parity=bool(parity_of(config)),
    )


def degree_ranges(config: Config) -> list[range]:
    """Return the degrees that the fit is swept over, an axis."""
    return [range(axis.degrees[0], axis.degrees[1] + 1) for axis in config.axes]


def fit_of(config: Config, inputs: Inputs) -> GridFit:
    """Return what the step ``fit`` has fitted."""
    made = inputs["fit"]
    axes, scale = axes_of(config, inputs), scale_of(config, inputs)
    orders = harmonics_of(config, made).orders
    return GridFit(made["coefficients"], axes, config.fit.basis, scale, float(made["condition"]), orders, parity_of(config))


def reference_of(config: Config, inputs: Inputs, truths: Sequence[str]) -> Reference:
    """Gather the steps ``truths``, grids or lists of sets, into what errors are measured against."""
    parts = [inputs[name] for name in truths]
    names = [axis.name for axis in config.axes]
    parameters = []
    for part in parts:
        columns = [part[name] for name in names]
        parameters.append(np.stack(columns, axis=-1) if "set" in part.variables else parameter_points.grid(columns))
    weights = np.concatenate([p["weights"].reshape(-1, *p["weights"].shape[-2:]) for p in parts])
    least = np.concatenate([p["least_luminance"].ravel() for p in parts])
    return reference(config, np.concatenate(parameters), weights, parts[0]["degree"], least)


def reference(config: Config, sets: Array, radiance: Array, degrees: NDArray[np.int64], least: Array) -> Reference:
    """Return what errors of the config's scene are measured against at ``sets`` ``(n, axes)``.

    Of the light alone: weights ``radiance`` ``(n, channels, count)`` of ``degrees`` ``(count,)``, least luminances ``(n,)``.
    """
    scale = luminance_scale(config.scene.quantity)
    return Reference(
        parameters=sets,
        weights=fold(scene_of(config), radiance, degrees, sets),
        degrees=degrees,
        least=scale * least,
        mean=scale * mean_luminance(radiance[:, :, 0], config.source.luminance_row),
    )


def headline_of(measured: Dataset, name: str) -> tuple[float, float]:
    """Return E_mean and E_max of a table as they are published, over all bands and channels, first convention."""
    e_mean, e_max = (published(measured[f"{name}/{key}"][0, :, -1].max()) for key in ("e_mean", "e_max"))
    return e_mean, e_max


def read_table(artifact: Dataset, name: str) -> Table:
    """Return a table that ``fit`` or ``select`` made; ``name`` starts with references/ or tables/."""
    return runtime.read(io.BytesIO(artifact[f"{name}/npz"].tobytes()))
