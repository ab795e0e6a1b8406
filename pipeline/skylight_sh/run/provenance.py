"""Where results come from: config, versions, processor and library kernels. No dates, no places.

All of it travels with an artifact in the store and is published in ``run.json`` alone: results do not hang on it.
"""

from __future__ import annotations

import platform
from functools import lru_cache
from importlib import import_module
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from skylight_sh import __version__
from skylight_sh.config.schema import Config
from skylight_sh.store.keys import digest

_LIBRARIES = ("numpy", "scipy", "h5py", "dask")
# Those whose versions can change a result; drawing libraries change the report alone.
_DRAWING = ("matplotlib", "pandas", "jinja2")

_LATER = (("report", "scenes"), ("scene", "mesh"))


@lru_cache(maxsize=1)
def versions() -> dict[str, str]:
    """Return versions of everything that computes."""
    return {
        "skylight_sh": __version__,
        "python": platform.python_version(),
        **{name: version(name) for name in _LIBRARIES},
    }


@lru_cache(maxsize=1)
def environment() -> dict[str, Any]:
    """Return ``versions``, the machine, the CPU features NumPy found and the kernels BLAS chose; it loads all of SciPy's."""
    from threadpoolctl import threadpool_info

    # SciPy has a BLAS of its own, which is told once it is loaded.
    import_module("scipy.linalg")

    found = np.show_config(mode="dicts") or {}
    features = found.get("SIMD Extensions", {})
    return {
        **versions(),
        "machine": platform.machine(),
        "cpu_features": sorted(set(features.get("baseline", [])) | set(features.get("found", []))),
        "blas": sorted(
            " ".join((Path(found["filepath"]).parent.name, found["internal_api"], found["version"], found["architecture"]))
            for found in threadpool_info()
            if found["user_api"] == "blas"
        ),
    }


@lru_cache(maxsize=1)
def libraries() -> dict[str, str]:
    """Return the versions that decide what a step computes."""
    return {name: versions()[name] for name in ("numpy", "scipy")}


@lru_cache(maxsize=1)
def drawing() -> dict[str, str]:
    """Return the versions that decide what a report looks like."""
    return {name: version(name) for name in _DRAWING}


def settings(config: Config) -> dict[str, Any]:
    """Return the config as JSON-like data, without what changes no result: where work is done, files, what it extends."""
    found = whole_settings(config)
    del found["export"]["targets"]
    return found


def whole_settings(config: Config) -> dict[str, Any]:
    """Return ``settings`` and which files are exported: all that it takes to run the config again."""
    # Views are rendered of what a run publishes.
    found: dict[str, Any] = config.model_dump(mode="json", exclude={"extends", "run", "views"})
    # What came later leaves the settings of those who do not use it as they were, and their digests.
    for section, key in _LATER:
        if found[section][key] is None:
            del found[section][key]
    return found


def settings_digest(config: Config) -> str:
    """Return the SHA-256 of ``settings``, by which a header names its config."""
    return digest(settings(config))
