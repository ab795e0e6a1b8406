"""Meshes read from files, healed where that can be done without a doubt, and refused where light would be wrong."""

from __future__ import annotations

from pathlib import Path
from typing import get_args

from skylight_sh import UserError
from skylight_sh.mesh import checking, healing
from skylight_sh.mesh._mesh import Mesh
from skylight_sh.mesh.assembly import assemble
from skylight_sh.mesh.findings import Finding
from skylight_sh.mesh.formats import FORMATS
from skylight_sh.mesh.formats.protocol import Up

# More than any mesh that is read takes, with its pictures.
_MOST_BYTES = 1 << 31


def files(path: Path) -> tuple[Path, ...]:
    """Return all files that ``read(path)`` draws on and that are there: its own first, then materials, data, pictures.

    A file that cannot be made out is there alone: reading it tells why.
    """
    ending = path.suffix.lower().removeprefix(".")
    try:
        others = FORMATS[ending].beside(path) if ending in FORMATS else ()
        return tuple(dict.fromkeys(file for file in (path, *others) if file.is_file()))
    except (UserError, OSError):
        return (path,)


def read(path: Path, up: str | None = None) -> tuple[Mesh, tuple[Finding, ...]]:
    """Return the mesh of a file, and what was found in it, healed or not.

    The ending of the file's name says its format, one of ``FORMATS``. ``up`` is the file's axis that points up, ``"y"`` or
    ``"z"``; by default that of the format: y for glTF, z for OBJ and PLY, which say nothing. The mesh has z up.

    Raises UserError where the file cannot be read whole, or holds what would silently give wrong light: indices out of
    range, positions that are no numbers, no triangle with an area. ``healing.heal`` says what is healed, ``checking.check``
    what is told and left.
    """
    ending = path.suffix.lower().removeprefix(".")
    if ending not in FORMATS:
        known = ", ".join(f".{name}" for name in FORMATS)
        raise UserError(f"{path} has the ending {path.suffix!r}. Should be one of {known}. Export the mesh as one of these.")
    if not path.is_file():
        raise UserError(f"{path}: {'a folder' if path.is_dir() else 'no such file'}. Give the path of a mesh.")
    if (size := path.stat().st_size) > _MOST_BYTES:
        raise UserError(
            f"{path} has {size:,} bytes. Should have at most {_MOST_BYTES:,}. Simplify the mesh, or its pictures."
        )
    if up not in (None, *get_args(Up)):
        raise UserError(f"Invalid up axis {up!r}. Should be y or z.")
    chosen = FORMATS[ending]
    try:
        content = chosen.read(path)
        mesh, made_up = assemble(content.surfaces, "y" if (up or chosen.up) == "y" else "z")
        mesh, healed = healing.heal(mesh)
    except OSError as error:
        raise UserError(f"{path} cannot be read: {error.strerror or error}. Give a file that may be read.") from error
    except UserError as error:
        raise type(error)(f"{path}: {error}") from error
    hint = checking.up_hint(mesh) if up is None and chosen.up == "z" else ()
    return mesh, (*content.findings, *made_up, *healed, *checking.check(mesh), *hint)
