"""A released table as sources of other languages, so that nobody must run anything to use it, and a picture to project."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

from skylight_sh import probe, runtime
from skylight_sh.export import targets
from skylight_sh.light.preetham import Preetham
from skylight_sh.render.files import exr
from skylight_sh.run.stages.export import told_of
from skylight_sh.run.verify import released_config

SKY = {"sun_zenith": 0.8, "turbidity": 3.0}
"""Of the panorama, its sun at azimuth 0."""

_ROWS = 64
TARGETS = ("glsl", "hlsl", "wgsl", "javascript", "csharp")


def of(folder: Path) -> dict[str, bytes]:
    """Return the recommended table of the released run in ``folder`` as files of every language but C, by name.

    They are what a run writes whose config asks for these targets. Raises ValueError where the folder holds no result.
    """
    config = released_config(folder)
    rows = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["tables"]
    row = next(row for row in rows if row["name"] == config.export.recommended)
    table = runtime.read(folder / row["path"] / "skylight_sh.npz")
    return targets.write(TARGETS, table, told_of(config, row), row["prefix"])


def panorama() -> bytes:
    """Return a Preetham sky as a panorama of floats, 128 pixels across, an OpenEXR file."""
    parameters = {name: np.array([value]) for name, value in SKY.items()}
    return exr(probe.render(Preetham(), parameters, "equirect", _ROWS, 2 * _ROWS))
