"""Engines: a mesh's transfer compressed for the skies of the recommended table, as files that engines read."""

from __future__ import annotations

import numpy as np

from skylight_sh.config.schema import Config
from skylight_sh.export import transfer_files
from skylight_sh.run.executors import Advance
from skylight_sh.run.files import to_dataset
from skylight_sh.run.from_config import read_table
from skylight_sh.run.mesh_source import MeshSource
from skylight_sh.run.plan import Inputs
from skylight_sh.runtime import Runtime
from skylight_sh.store.dataset import Dataset
from skylight_sh.transfer.random_suns import CLEAR


def make(config: Config, source: MeshSource, inputs: Inputs, _: Advance) -> Dataset:
    """Compress the transfer and write its files; attributes tell what is lost."""
    transfer = inputs["transfer"]
    written = transfer_files.write(
        source.mesh(),
        np.asarray(transfer["direct"], dtype=np.float64),
        np.asarray(transfer["transfer"], dtype=np.float64),
        Runtime(read_table(inputs["select"], f"tables/{config.export.recommended}")),
        colour_space=getattr(config.light, "colour_space", "srgb"),
        turbidity=config.scene.fixed.get("turbidity", CLEAR),
    )
    return Dataset(to_dataset(written.files).variables, dict(written.lost))
