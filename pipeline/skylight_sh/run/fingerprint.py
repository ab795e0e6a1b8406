"""What decides what a process computes: this package's code, Python, libraries, and the lights of other packages.

Two processes may share work only where these agree: a worker with other code gives other numbers, which a store would then
serve for ever.
"""

from __future__ import annotations

import platform
import sys
from collections.abc import Mapping
from functools import lru_cache
from importlib.metadata import PackageNotFoundError, version

from skylight_sh.light import installed
from skylight_sh.run.code import whole_version

Fingerprint = Mapping[str, str]
# Libraries that decide a light, by the module that is loaded where one is in use.
_OPTIONAL = {"colour": "colour-science", "mitsuba": "mitsuba"}
_SHOWN = 12


def in_use() -> tuple[str, ...]:
    """Return what decides this process's results beside the package and Python: libraries, and ``light ENTRY``."""
    # Imported here: it loads the config's schema, which a worker can do without.
    from skylight_sh.run.provenance import libraries

    loaded = [name for module, name in _OPTIONAL.items() if module in sys.modules]
    lights = {f"light {name}" for name, point in installed.points().items() if point.module in sys.modules}
    return (*libraries(), *loaded, *sorted(lights))


@lru_cache(maxsize=8)
def fingerprint(used: tuple[str, ...]) -> Fingerprint:
    """Return what decides this process's results, by name; ``used`` is ``in_use`` of whoever asks.

    The first answer stands for the process's whole life, as the modules it has loaded do: one whose files changed since
    then goes on with its old code, and says so.
    """
    found = {
        "the code of skylight-sh": whole_version()[:_SHOWN],
        "Python": ".".join(platform.python_version_tuple()[:2]),
    }
    return found | {name: _part(name) for name in used}


def differences(found: Fingerprint, expected: Fingerprint) -> str:
    """Say where ``found``, a worker's, differs from ``expected``, one's own: an empty text where it does not."""
    names = [name for name in {**expected, **found} if found.get(name) != expected.get(name)]
    return "; ".join(
        f"{name} is {found.get(name, 'missing')} there and {expected.get(name, 'missing')} here" for name in names
    )


def _part(name: str) -> str:
    if name.startswith("light "):
        return installed.identity(name.removeprefix("light "))
    try:
        return version(name)
    except PackageNotFoundError:
        return "missing"
