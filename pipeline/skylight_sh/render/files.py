"""Pictures written: PNG for screens, OpenEXR for linear light. The same picture gives the same bytes."""

from __future__ import annotations

import struct
import zlib
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from skylight_sh import UserError

_SIGNATURE = b"\x89PNG\r\n\x1a\n"
_TRUECOLOUR = 2
_PERCEPTUAL = b"\0"
_MAGIC = b"v/1\x01\x02\0\0\0"
_ZIP, _ROWS, _FLOAT = b"\x03", 16, 2


def png(srgb: NDArray[np.floating]) -> bytes:
    """Return a picture ``(rows, columns, 3)`` of sRGB values in [0, 1] as a PNG file of 24 bits (ISO/IEC 15948).

    Each row is written as differences from what stands left or above, whichever filter leaves the smaller ones.
    """
    if srgb.ndim != 3 or srgb.shape[2] != 3 or not srgb.size:
        raise ValueError(f"Invalid shape {srgb.shape} of a picture. Should be (rows, columns, 3).")
    pixels = np.clip(np.rint(np.asarray(srgb) * 255.0), 0, 255).astype(np.int16)
    rows, columns, _ = pixels.shape
    left, above = np.zeros_like(pixels), np.zeros_like(pixels)
    left[:, 1:], above[1:] = pixels[:, :-1], pixels[:-1]
    corner = np.zeros_like(pixels)
    corner[1:, 1:] = pixels[:-1, :-1]
    guesses = (np.zeros_like(pixels), left, above, (left + above) // 2, _paeth(left, above, corner))
    filtered = np.stack([((pixels - guess) & 255).astype(np.uint8).reshape(rows, -1) for guess in guesses])
    best = np.abs(filtered.view(np.int8).astype(np.int64)).sum(axis=-1).argmin(axis=0)
    lines = np.concatenate([best[:, np.newaxis].astype(np.uint8), filtered[best, np.arange(rows)]], axis=1)
    header = struct.pack(">IIBBBBB", columns, rows, 8, _TRUECOLOUR, 0, 0, 0)
    chunks = [(b"IHDR", header), (b"sRGB", _PERCEPTUAL), (b"IDAT", zlib.compress(lines.tobytes(), 9)), (b"IEND", b"")]
    return _SIGNATURE + b"".join(_chunk(kind, data) for kind, data in chunks)


def exr(radiance: NDArray[np.floating]) -> bytes:
    """Return linear RGB ``(rows, columns, 3)`` as an OpenEXR file of 32-bit floats, its rows compressed by ZIP.

    The layout is that of OpenEXR's file format, version 2: a header, a table of offsets, and blocks of sixteen rows, whose
    channels follow each other by name, low and high bytes apart and as differences.
    """
    if radiance.ndim != 3 or radiance.shape[2] != 3 or not radiance.size:
        raise ValueError(f"Invalid shape {radiance.shape} of a picture. Should be (rows, columns, 3).")
    rows, columns, _ = radiance.shape
    # B, G, R: in the names' order.
    planes = np.asarray(radiance, dtype="<f4").transpose(0, 2, 1)[:, ::-1]
    window = struct.pack("<4i", 0, 0, columns - 1, rows - 1)
    channels = b"".join(name + b"\0" + struct.pack("<iiii", _FLOAT, 0, 1, 1) for name in (b"B", b"G", b"R")) + b"\0"
    header = _MAGIC + b"".join(
        name + b"\0" + kind + b"\0" + struct.pack("<i", len(value)) + value
        for name, kind, value in (
            (b"channels", b"chlist", channels),
            (b"compression", b"compression", _ZIP),
            (b"dataWindow", b"box2i", window),
            (b"displayWindow", b"box2i", window),
            (b"lineOrder", b"lineOrder", b"\0"),
            (b"pixelAspectRatio", b"float", struct.pack("<f", 1.0)),
            (b"screenWindowCenter", b"v2f", struct.pack("<2f", 0.0, 0.0)),
            (b"screenWindowWidth", b"float", struct.pack("<f", 1.0)),
        )
    )
    blocks = []
    for first in range(0, rows, _ROWS):
        packed = _zipped(planes[first : first + _ROWS].tobytes())
        blocks.append(struct.pack("<ii", first, len(packed)) + packed)
    start = len(header) + 1 + 8 * len(blocks)
    offsets = start + np.cumsum([0, *(len(block) for block in blocks[:-1])])
    return header + b"\0" + offsets.astype("<u8").tobytes() + b"".join(blocks)


def encoded(path: Path, radiance: NDArray[np.floating], srgb: NDArray[np.floating]) -> bytes:
    """Return the file that the ending of ``path`` asks for: ``.exr`` of ``radiance``, or ``.png`` of ``srgb``."""
    check(path)
    return exr(radiance) if path.suffix.lower() == ".exr" else png(srgb)


def check(path: Path) -> None:
    """Raise UserError for a file name whose ending is neither .png nor .exr."""
    if path.suffix.lower() not in (".png", ".exr"):
        raise UserError(f"{path} ends in {path.suffix or 'nothing'}. Give it .png (for screens) or .exr (linear light).")


def _paeth(left: NDArray[np.int16], above: NDArray[np.int16], corner: NDArray[np.int16]) -> NDArray[np.int16]:
    """Return whichever of three neighbours is nearest to left + above - corner."""
    to_left, to_above = np.abs(above - corner), np.abs(left - corner)
    to_corner = np.abs(left + above - 2 * corner)
    second = np.where(to_above <= to_corner, above, corner)
    return np.where((to_left <= to_above) & (to_left <= to_corner), left, second)


def _zipped(raw: bytes) -> bytes:
    """Return bytes as OpenEXR's ZIP has them, or as they are where that is no shorter."""
    data = np.frombuffer(raw, dtype=np.uint8)
    apart = np.concatenate([data[0::2], data[1::2]]).astype(np.int16)
    apart[1:] = (apart[1:] - apart[:-1] + 128) & 255
    packed = zlib.compress(apart.astype(np.uint8).tobytes(), 6)
    return packed if len(packed) < len(raw) else raw


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
