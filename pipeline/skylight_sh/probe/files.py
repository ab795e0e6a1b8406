"""Picture files as linear radiance: OpenEXR, Radiance HDR, PNG, JPEG and TIFF, read by OpenImageIO."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from skylight_sh import MissingExtraError

if TYPE_CHECKING:
    import OpenImageIO

Array = NDArray[np.float64]

# 16,384 x 8,192: more than any camera's panorama, and 3 GB while it is read.
MOST_PIXELS = 1 << 27
_RGB = ("R", "G", "B")
_JPEG_END = b"\xff\xd9"


@dataclass(frozen=True)
class Picture:
    """Linear pixels ``(height, width, channels)`` as the file's radiance unit has them, and the channels' names.

    ``clipped`` is the share of pixels with a whole number at its largest: what was brighter is lost.
    """

    pixels: NDArray[np.float32]
    channels: tuple[str, ...]
    clipped: float = 0.0


def read(path: Path, *, linear: bool = False) -> Picture:
    """Return a picture file's colours, alpha left out, its stored orientation and display window applied.

    Files of floats (OpenEXR, Radiance HDR, float TIFF) are linear as they are. Whole numbers are decoded from sRGB (IEC
    61966-2-1), 1 for the largest, unless ``linear``: they then are the share of the largest. Red, green and blue are
    taken for the primaries of sRGB. A file of one colour channel is grey.

    Raises ValueError where the file is no picture, holds none of these channels or is too large, FileNotFoundError where it
    does not exist, and MissingExtraError where OpenImageIO is not installed.
    """
    try:
        import OpenImageIO
    except ImportError as error:
        raise MissingExtraError("Picture files need OpenImageIO: pip install 'skylight-sh[images]'.") from error
    if not path.is_file():
        raise FileNotFoundError(f"{path}: {'a folder' if path.is_dir() else 'no such file'}. Give the path of a picture.")
    hints = OpenImageIO.ImageSpec()
    # Alpha must not scale the colours beside it.
    hints.attribute("oiio:UnassociatedAlpha", 1)
    source = OpenImageIO.ImageInput.open(str(path), hints)
    if source is None:
        raise ValueError(_unreadable(path, OpenImageIO.geterror()))
    try:
        spec = source.spec()
        _check_size(path, spec)
        places, names = _colours(path, spec)
        stored = source.read_image(0, 0, 0, spec.nchannels, OpenImageIO.FLOAT)
        if stored is None:
            raise ValueError(_unreadable(path, source.geterror()))
        # The decoder fills what is missing of a JPEG with grey and calls that a success.
        if source.format_name() == "jpeg" and not path.read_bytes().rstrip(b"\0").endswith(_JPEG_END):
            raise ValueError(_unreadable(path, "it ends too early"))
    finally:
        source.close()
    pixels = np.asarray(stored, dtype=np.float32).reshape(spec.height, spec.width, spec.nchannels)[..., places]
    pixels = _oriented(_displayed(pixels, spec), spec.get_int_attribute("Orientation", 1))
    whole = spec.format.basetype not in (OpenImageIO.HALF, OpenImageIO.FLOAT, OpenImageIO.DOUBLE)
    clipped = float((pixels >= 1.0).any(axis=-1).mean()) if whole else 0.0
    return Picture(from_srgb(pixels) if whole and not linear else pixels, names, clipped)


def read_mask(path: Path) -> Array:
    """Return a picture file's opacity ``(height, width, 1)``: the mean of its colours, taken as linear, in [0, 1].

    Raises what ``read`` raises, and ValueError for a pixel that is no number of 0 to 1.
    """
    opacity: Array = read(path, linear=True).pixels.astype(np.float64).mean(axis=-1, keepdims=True)
    wrong = ~((opacity >= 0.0) & (opacity <= 1.0))
    if wrong.any():
        row, column, _ = np.argwhere(wrong)[0].tolist()
        raise ValueError(
            f"{path}: invalid opacity {opacity[row, column, 0]:g} at row {row}, column {column} (from 0, top left). Should "
            "be from 0 to 1. Mend it in an image editor."
        )
    return opacity


def from_srgb(encoded: NDArray[np.float32]) -> NDArray[np.float32]:
    """Decode sRGB values in [0, 1] to linear ones (IEC 61966-2-1); any shape."""
    low = encoded / np.float32(12.92)
    high = ((np.maximum(encoded, 0) + np.float32(0.055)) / np.float32(1.055)) ** np.float32(2.4)
    return np.where(encoded <= np.float32(0.04045), low, high)


def to_srgb(linear: Array) -> Array:
    """Encode linear values in [0, 1] as sRGB (IEC 61966-2-1); any shape."""
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)


def _check_size(path: Path, spec: OpenImageIO.ImageSpec) -> None:
    """Raise ValueError before anything is allocated for a size that no picture has."""
    for width, height in ((spec.width, spec.height), (spec.full_width, spec.full_height)):
        if width < 1 or height < 1:
            raise ValueError(
                f"{path}: invalid size {width}x{height} (width x height). Should be at least 1x1. Save it anew."
            )
        if width * height > MOST_PIXELS:
            raise ValueError(
                f"{path}: {width}x{height} (width x height) are {width * height} pixels. Should be at most {MOST_PIXELS}. "
                "Shrink it: a few hundred texels across are enough for most numbers of bands."
            )
    if spec.deep or spec.depth > 1:
        raise ValueError(f"{path} is a deep or volume image. Should be a flat one. Flatten it.")


def _colours(path: Path, spec: OpenImageIO.ImageSpec) -> tuple[list[int], tuple[str, ...]]:
    """Return the places of the colours among a file's channels, and their names for people."""
    found = [str(name) for name in spec.channelnames]
    # OpenEXR sorts channels by name, and may have others beside the colours.
    if all(name in found for name in _RGB):
        return [found.index(name) for name in _RGB], ("red", "green", "blue")
    grey = [i for i, name in enumerate(found) if name != "A"]
    if len(grey) == 1:
        return grey, ("grey",)
    raise ValueError(f"{path} holds the channels {', '.join(found)}. Should hold R, G and B, or one alone. Save it as RGB.")


def _displayed(pixels: NDArray[np.float32], spec: OpenImageIO.ImageSpec) -> NDArray[np.float32]:
    """Place an OpenEXR data window in its display window: what lies outside is cut, what is missing black."""
    if (spec.x, spec.y, spec.width, spec.height) == (spec.full_x, spec.full_y, spec.full_width, spec.full_height):
        return pixels
    out = np.zeros((spec.full_height, spec.full_width, pixels.shape[-1]), dtype=np.float32)
    top, left = spec.y - spec.full_y, spec.x - spec.full_x
    part = pixels[max(0, -top) : max(0, spec.full_height - top), max(0, -left) : max(0, spec.full_width - left)]
    out[max(0, top) : max(0, top) + part.shape[0], max(0, left) : max(0, left) + part.shape[1]] = part
    return out


def _oriented(pixels: NDArray[np.float32], orientation: int) -> NDArray[np.float32]:
    """Turn pixels as the Exif orientation 1 to 8 says, which Radiance files and phones use."""
    if orientation in (5, 6, 7, 8):
        pixels = pixels.swapaxes(0, 1)
    if orientation in (2, 3, 6, 7):
        pixels = pixels[:, ::-1]
    if orientation in (3, 4, 7, 8):
        pixels = pixels[::-1]
    return pixels


def _unreadable(path: Path, reason: str) -> str:
    text = " ".join(reason.split())
    return (
        f"{path} is no picture that can be read ({text}). Should be OpenEXR, Radiance HDR, PNG, JPEG or TIFF. Save it anew."
    )
