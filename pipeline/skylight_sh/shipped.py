"""What comes with the package beside its code: configs, their names and pictures, and the released benchmark's figures.

``configs/`` at the root of the source, and ``reports/reference/speed.json``, which a build puts into the package.
"""

from __future__ import annotations

import re
from pathlib import Path

from skylight_sh import UserError

_PACKAGE = Path(__file__).resolve().parent
_SUFFIX = ".toml"
_NAME = re.compile(r"[a-z0-9][a-z0-9_-]*")


def folder() -> Path:
    """Return the folder of the shipped configs: the package's own, or in a checkout of the source the one of its root."""
    own = _PACKAGE / "configs"
    return own if own.is_dir() else _PACKAGE.parents[1] / "configs"


def names() -> list[str]:
    """Return the names of the shipped configs, sorted.

    >>> "preetham" in names()
    True
    """
    return sorted(path.stem for path in folder().glob(f"*{_SUFFIX}"))


def summary(name: str) -> str:
    """Return what the shipped config ``name`` is: the first line of its file, a comment.

    >>> summary("cie-clear")
    'CIE standard clear sky (type 12): one parameter, one channel.'
    """
    with (folder() / f"{name}{_SUFFIX}").open(encoding="utf-8") as file:
        return file.readline().lstrip("#").strip()


def path(name: str) -> Path | None:
    """Return the file of the shipped config ``name``; None where none has that name, as no path has."""
    place = folder() / f"{name}{_SUFFIX}"
    return place if _NAME.fullmatch(name) and place.is_file() else None


def speed() -> Path | None:
    """Return the file of the released benchmark's figures: the package's own, or the checkout's; None where neither is.

    >>> speed().name
    'speed.json'
    """
    places = (_PACKAGE / "speed.json", _PACKAGE.parents[1] / "reports" / "reference" / "speed.json")
    return next((place for place in places if place.is_file()), None)


def find(text: str) -> Path:
    """Return the path of a config: the file at ``text``, or else the shipped config of that name.

    Raises UserError where ``text`` is neither.
    """
    given = Path(text)
    try:
        # A pipe is as good as a file.
        if given.exists() and not given.is_dir():
            return given
    except ValueError:
        # A path with a zero byte is none.
        pass
    found = path(text)
    if found is None:
        close = f" Did you mean {text.removesuffix(_SUFFIX)!r}?" if path(given.stem) else ""
        raise UserError(
            f"{text!r} is neither a file nor the name of a shipped config.{close} Give the path of a TOML file, or a name "
            "that `skylight-sh configs` lists."
        )
    return found
