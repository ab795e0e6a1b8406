"""Pictures on a mesh's surfaces: colours and relief, read where a file has them."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from skylight_sh import MissingExtraError, UserError
from skylight_sh.mesh.findings import Finding

Array = NDArray[np.float64]


@dataclass
class Shelf:
    """The pictures of one file's surfaces, each read once, and ``findings`` of those that are missing.

    A picture is a file, or its bytes where the mesh's own file holds it.
    """

    findings: list[Finding] = field(default_factory=list)
    _held: dict[object, Array] = field(default_factory=dict)

    def colours(self, part: str, source: Path | bytes) -> Array | None:
        """Return what ``colours`` does, None where there is no such file."""
        return self._one(part, source, "colours", colours)

    def relief(self, part: str, source: Path | bytes, strength: float = 1.0) -> Array | None:
        """Return what ``relief`` does, None where there is no such file."""
        return self._one(part, source, ("relief", strength), lambda path: relief(path, strength))

    def _one(self, part: str, source: Path | bytes, kind: object, read: Callable[[Path], Array]) -> Array | None:
        if isinstance(source, Path) and not source.is_file():
            sentence = f"Part {part!r}: no picture {source.name!r} beside the mesh; it goes without. Copy it there."
            self.findings.append(Finding(part, "no picture", 1, False, sentence))
            return None
        key = (kind, source)
        if key not in self._held:
            self._held[key] = read(source) if isinstance(source, Path) else _from_bytes(source, read)
        return self._held[key]


def decoded(encoded: Array) -> Array:
    """Return linear values of sRGB ones, any shape; what is no number of 0 to 1 is left as it is, to be told later."""
    from skylight_sh.probe import files

    inside = (encoded >= 0.0) & (encoded <= 1.0)
    linear = files.from_srgb(np.where(inside, encoded, 0.0).astype(np.float32))
    return np.where(inside, linear.astype(np.float64), encoded)


def colours(path: Path) -> Array:
    """Return a picture's linear RGB ``(rows, columns, 3)``, decoded from sRGB where it is of whole numbers."""
    return _read(path, linear=False)


def relief(path: Path, strength: float = 1.0) -> Array:
    """Return a normal map's unit normals ``(rows, columns, 3)``: x along u, y along v, z outward, 0.5 for zero.

    ``strength`` scales x and y. Texels that hold no direction are taken as flat.
    """
    normals = 2.0 * _read(path, linear=True) - 1.0
    normals[..., :2] *= strength
    length = np.linalg.norm(normals, axis=-1, keepdims=True)
    flat = np.array([0.0, 0.0, 1.0])
    return np.where(length > 0.1, np.divide(normals, length, out=np.zeros_like(normals), where=length > 0.0), flat)


def _from_bytes(data: bytes, read: Callable[[Path], Array]) -> Array:
    """Read a picture that a mesh's file holds through a file of its own, for its reader takes files."""
    with tempfile.TemporaryDirectory() as folder:
        # The reader goes by what is in a file; the ending is its first guess.
        path = Path(folder) / ("picture.jpg" if data.startswith(b"\xff\xd8") else "picture.png")
        path.write_bytes(data)
        return read(path)


def _read(path: Path, *, linear: bool) -> Array:
    # Its library is asked for by the few meshes that have pictures.
    from skylight_sh.probe import files

    try:
        pixels = files.read(path, linear=linear).pixels.astype(np.float64)
    except MissingExtraError:
        raise
    except (ValueError, FileNotFoundError) as error:
        raise UserError(str(error)) from error
    if not np.isfinite(pixels).all():
        raise UserError(f"{path}: {int((~np.isfinite(pixels)).sum())} texels are no numbers. Mend it in an image editor.")
    return np.ascontiguousarray(np.broadcast_to(pixels, (*pixels.shape[:2], 3)))
