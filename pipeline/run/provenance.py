"""What an artifact says about where it comes from: config, versions, CPU. No dates, no places."""

from __future__ import annotations

import platform
from functools import lru_cache
from importlib.metadata import version
from typing import Any

import numpy as np

from pipeline import __version__
from pipeline.config.schema import Config

_LIBRARIES = ("numpy", "scipy", "h5py", "dask")
# Those whose versions can change a result; drawing libraries change the report alone.
_DRAWING = ("matplotlib", "pandas", "jinja2")


@lru_cache(maxsize=1)
def environment() -> dict[str, Any]:
    """Return versions of everything that computes, and the CPU features NumPy found: they decide the last bits."""
    found = np.show_config(mode="dicts") or {}
    features = found.get("SIMD Extensions", {})
    return {
        "skylight_sh": __version__,
        "python": platform.python_version(),
        "machine": platform.machine(),
        "cpu_features": sorted(set(features.get("baseline", [])) | set(features.get("found", []))),
        **{name: version(name) for name in _LIBRARIES},
    }


@lru_cache(maxsize=1)
def libraries() -> dict[str, str]:
    """Return the versions that decide what a step computes."""
    return {name: version(name) for name in ("numpy", "scipy")}


@lru_cache(maxsize=1)
def drawing() -> dict[str, str]:
    """Return the versions that decide what a report looks like."""
    return {name: version(name) for name in _DRAWING}


def settings(config: Config) -> dict[str, Any]:
    """Return the config as JSON-like data, without what changes no result: where work is done, files, what it extends."""
    return config.model_dump(mode="json", exclude={"extends": True, "run": True, "export": {"targets"}})
