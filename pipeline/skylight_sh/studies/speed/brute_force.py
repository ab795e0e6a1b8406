"""The projection that engines do: the sky in a thousand directions, times the basis there, summed; no table of weights."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.formula.printers import C_SINGLE
from skylight_sh.light import colour
from skylight_sh.light.preetham import Preetham, constants_of
from skylight_sh.studies import compiled
from skylight_sh.studies.grid_samples import Samples
from skylight_sh.studies.speed import race
from skylight_sh.studies.speed.candidate import Candidate

Array = NDArray[np.float64]

RINGS, TURNS = 16, 64
"""1,024 directions: Gauss nodes in the cosine of the zenith angle, even turns about the zenith."""


def brute_force(samples: Samples) -> Candidate | None:
    """Return the projection of the Preetham sky in C, or None for another light, other inputs or a scene."""
    light, names = samples.config.source, [axis.name for axis in samples.config.axes]
    if not isinstance(light, Preetham) or names != ["sun_zenith", "turbidity"]:
        return None
    bands = samples.config.truth.bands
    text = header(light, bands)
    return Candidate(text, 4 * (RINGS * TURNS * bands**2 + 2 * (RINGS + TURNS) + 30 + 24 + 9), bands, "brute force")


def header(light: Preetham, bands: int) -> str:
    """Return C with the tables' API."""
    x, areas = sphere.gauss(RINGS)
    up, around = (1.0 + x) / 2, 2 * np.pi * (np.arange(TURNS) + 0.5) / TURNS
    out = np.sqrt(1.0 - up**2)
    where = np.stack(
        [np.outer(out, np.cos(around)), np.outer(out, np.sin(around)), np.broadcast_to(up[:, np.newaxis], (RINGS, TURNS))],
        axis=-1,
    )
    basis = sphere.basis(where.reshape(-1, 3), bands).reshape(RINGS, TURNS, -1)
    basis = basis * (areas / 2 * 2 * np.pi / TURNS)[:, np.newaxis, np.newaxis]
    perez, zenith = constants_of(light.constants)
    return race.template(
        "brute_force.h.j2",
        p=compiled.PREFIX,
        P=compiled.PREFIX.upper(),
        bands=bands,
        channels=len(light.channels),
        rings=RINGS,
        turns=TURNS,
        perez=_listed(perez),
        zenith=_listed(zenith),
        mix=_listed(colour.matrix(light.colour_space)),
        ring=_listed(np.stack([up, out], axis=-1)),
        turn=_listed(np.stack([np.cos(around), np.sin(around)], axis=-1)),
        basis=[C_SINGLE.number(value) for value in basis.ravel().tolist()],
    )


def _listed(numbers: Array) -> str:
    return ", ".join(C_SINGLE.number(value) for value in numbers.ravel().tolist())
