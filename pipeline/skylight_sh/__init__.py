"""Skylight-SH: parametric lights on the sphere as tiny tables of spherical-harmonics weights.

``load(path)`` reads an exported table and needs NumPy alone; ``skylight-sh --help`` lists what else there is.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from skylight_sh.runtime import load

__version__ = "0.1.0"
__all__ = ["MissingExtraError", "UserError", "__version__", "load"]


class UserError(Exception):
    """An error whose text tells what is wrong and the remedy; the command line prints it and exits with ``code``."""

    code = 2


class MissingExtraError(UserError, RuntimeError):
    """A package is needed that is not installed, or not in the version that is known; the text says how to get it."""


def __getattr__(name: str) -> object:
    # Late, so that the command line's --help goes without NumPy.
    if name == "load":
        from skylight_sh.runtime import load

        return load
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
