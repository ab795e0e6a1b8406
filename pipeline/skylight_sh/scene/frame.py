"""What all tables of a run's fit have in common: axes, channels, factor, and what the scene folds in."""

from __future__ import annotations

from skylight_sh.config.schema import Config
from skylight_sh.run.plan import Inputs
from skylight_sh.scene.axes import VARIABLES, axes_of
from skylight_sh.table.prefactor import ClosedForm, Factor, Reciprocal
from skylight_sh.table.surroundings import PARTS, Surroundings
from skylight_sh.table.table import Frame

SURROUNDINGS = "truth/surroundings"


def factor_of(config: Config, inputs: Inputs) -> Factor | None:
    """Return what the fit divides by: the light's closed form, a polynomial's reciprocal found in samples, or nothing."""
    if config.fit.prefactor == "auto":
        return Reciprocal(inputs[VARIABLES]["denominator"])
    hint = config.source.hints.prefactor
    if not (config.fit.prefactor and hint):
        return None
    fixed = {name: value for name, value in config.scene.fixed.items() if name in hint.axes}
    return ClosedForm(hint.name, hint.constants, tuple(sorted(fixed.items())))


def surrounded(config: Config) -> tuple[str, ...]:
    """Return the name of the step that made the surroundings among a step's inputs, if there are any."""
    return (SURROUNDINGS,) if config.scene.surrounded else ()


def surroundings_of(inputs: Inputs) -> dict[int, Surroundings]:
    """Return the surroundings by the number of bands; none where there are none."""
    if SURROUNDINGS not in inputs:
        return {}
    made = inputs[SURROUNDINGS]
    bands = sorted({int(name.split("/")[1]) for name in made.variables})
    return {n: Surroundings(*(made[f"{part}/{n}"] for part in PARTS)) for n in bands}


def frame_of(config: Config, inputs: Inputs, *, mirrored: bool) -> Frame:
    """Return what all tables of a run's fit have in common."""
    scene = config.scene
    return Frame(
        axes_of(config, inputs),
        config.source.channels,
        mirrored,
        config.fit.basis,
        factor_of(config, inputs),
        quantity=scene.quantity,
        windowed=scene.window,
        azimuth=scene.azimuth,
        ground=scene.ground if isinstance(scene.ground, str) else f"albedo {', '.join(f'{a:g}' for a in scene.ground)}",
        sun_disc=scene.sun_disc,
        twilight=scene.twilight,
        surroundings=surroundings_of(inputs),
    )
