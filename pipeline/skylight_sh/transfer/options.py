"""How transfer is computed."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Options:
    """How transfer is computed: ``bands`` of the light, ``rays`` and ``gather_rays`` a vertex, and ``bounces``."""

    bands: int = 5
    rays: int = 1024
    gather_rays: int = 256
    bounces: int = 3
    seed: int = 0
