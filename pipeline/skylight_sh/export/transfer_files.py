"""Transfer for engines: a GLB whose vertices carry it compressed, the shader that lights them, what makes its uniforms."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from importlib.resources import files
from typing import Any

import numpy as np
from numpy.typing import NDArray

from skylight_sh import __version__, sphere
from skylight_sh.export import gltf, transfer_shader
from skylight_sh.export.engines import describe
from skylight_sh.export.shader_dialects import DIALECTS
from skylight_sh.mesh import Mesh
from skylight_sh.runtime import Runtime
from skylight_sh.transfer import compression
from skylight_sh.transfer.compression import STEPS, Compressed
from skylight_sh.transfer.random_suns import CLEAR, random_suns

Array = NDArray[np.float64]

FORMAT = 1
ROUTINE = "transfer_uniforms.mjs"

# Components are made for the first suns, and their error is measured under the others.
_SUNS, _UNSEEN = 2000, 60
_SEED, _UNSEEN_SEED = 0, 1
_LIT = "matrix[0] + sum of components / 127 times the rows below: N*N of the sky seen, then N*N of bounces a channel"
_FRAME = (
    "uniform[k][channel] = sum over i of matrix[k][i] * sky[channel][i] "
    "+ matrix[k][(1 + channel) * N*N + i] * (sky[channel][i] + sun[channel][i])"
)
_WEIGHTS = "radiance, real orthonormal without the Condon-Shortley sign, index l*(l+1)+m, +x east, +y north, +z up"


@dataclass(frozen=True)
class Written:
    """Files by name, and what compression ``lost``, as they tell it."""

    files: dict[str, bytes]
    lost: dict[str, float]


def write(
    mesh: Mesh,
    direct: Array,
    transfer: Array,
    table: Runtime,
    *,
    stem: str = "transfer",
    colour_space: str = "srgb",
    turbidity: float = CLEAR,
) -> Written:
    """Return the transfer of ``mesh`` compressed for the skies of ``table``, and what reads it.

    ``direct`` ``(v, N*N)`` is shadowed transfer, ``transfer`` ``(v, 3, N*N)`` the same with bounces; files' names begin with
    ``stem``. Raises UserError for a table that cannot light them, see ``random_suns``.
    """
    bands = sphere.bands_of(direct)
    suns = partial(random_suns, table, bands, colour_space=colour_space, turbidity=turbidity)
    made = compression.compress(direct, transfer, *suns(count=_SUNS, seed=_SEED))
    unseen = suns(count=_UNSEEN, seed=_UNSEEN_SEED)
    lost = losses(compression.errors(made, direct, transfer, *unseen))
    return Written(pack(mesh, made, lost, stem), lost)


def losses(errors: Array) -> dict[str, float]:
    """Return what compression loses, as it is told: the worst and the median sun's share, of four digits.

    >>> losses(np.array([[0.01, 0.02, 0.012], [0.02, 0.025, 0.01]]))["sky_median"]
    0.012
    """
    named = zip(("sky", "sky_and_sun_bounces"), errors, strict=True)
    found = {f"{name}_{word}": take(row) for name, row in named for word, take in (("worst", np.max), ("median", np.median))}
    return {"suns": errors.shape[1], **{name: float(f"{value:.4g}") for name, value in found.items()}}


def told(lost: Mapping[str, float]) -> str:
    """Return what ``losses`` says as a sentence's end.

    >>> told(losses(np.array([[0.01, 0.02], [0.02, 0.025]])))
    'of 2 unseen suns compression loses 2 % at worst and 1.5 % as a rule, with bounces of suns 2.5 % and 2.25 %'
    """
    sky, both = (
        [f"{100 * lost[f'{name}_{word}']:.3g} %" for word in ("worst", "median")] for name in ("sky", "sky_and_sun_bounces")
    )
    return (
        f"of {lost['suns']:.0f} unseen suns compression loses {sky[0]} at worst and {sky[1]} as a rule, "
        f"with bounces of suns {both[0]} and {both[1]}"
    )


def pack(mesh: Mesh, made: Compressed, lost: dict[str, float], stem: str = "transfer") -> dict[str, bytes]:
    """Return the files of compressed transfer by name, which begins with ``stem``; ``lost`` is what ``losses`` says."""
    count = made.components.shape[1]
    names = transfer_shader.attributes(count)
    whole = np.zeros((len(made.components), 4 * len(names)), dtype=np.int8)
    whole[:, :count] = made.components
    fours = {name: whole[:, 4 * i : 4 * i + 4] for i, name in enumerate(names)}
    shared: dict[str, Any] = {"bands": made.bands, "components": count, "error": lost}
    extras = {
        "skylight_sh_transfer": {
            "format": FORMAT,
            **shared,
            "attributes": names,
            "uniforms": f"{stem}_uniforms.json",
            "axes": f"{describe(gltf.AXES)}; SH weights stay in axes with z up, since vertices hold no directions of them",
        }
    }
    told = {
        "format": FORMAT,
        "generator": f"skylight-sh {__version__}",
        **shared,
        "steps": STEPS,
        "vertex": _LIT,
        "frame": _FRAME,
        "weights": _WEIGHTS,
        "matrix": [[float(f"{value:.8g}") for value in row] for row in made.matrix.tolist()],
    }
    return {
        f"{stem}.glb": gltf.write(mesh, fours, extras),
        f"{stem}_uniforms.json": _json(told),
        f"{stem}_uniforms.mjs": files(__package__).joinpath(f"templates/{ROUTINE}").read_bytes(),
        **{f"{stem}_shader.{DIALECTS[name].extension}": transfer_shader.write(name, count).encode() for name in DIALECTS},
    }


def _json(told: dict[str, Any]) -> bytes:
    """Return JSON with a row of the matrix a line."""
    rows = ",\n    ".join(json.dumps(row) for row in told["matrix"])
    head = json.dumps({**told, "matrix": None}, indent=2)
    return (head.replace('"matrix": null', f'"matrix": [\n    {rows}\n  ]') + "\n").encode()
