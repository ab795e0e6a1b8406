"""Which chart of the sphere each texel of a picture belongs to, by the name of its layout or by its proportions."""

from __future__ import annotations

from skylight_sh.probe.image_layouts import IMAGE_LAYOUTS
from skylight_sh.probe.image_layouts.protocol import Patch

_MOST_BANDS = 100


def patches(layout: str, height: int, width: int) -> list[Patch]:
    """Return the patches of a picture of ``height`` by ``width`` texels.

    Raises ValueError where ``layout`` is none of ``IMAGE_LAYOUTS``, or the picture's proportions are not the layout's.

    >>> [patch.rows for patch in patches("cube-strip", 8, 48)]
    [8, 8, 8, 8, 8, 8]
    """
    if layout not in IMAGE_LAYOUTS:
        raise ValueError(f"Invalid layout {layout!r}. Should be one of {', '.join(IMAGE_LAYOUTS)}.")
    if height < 1 or width < 1:
        raise ValueError(f"Invalid size {width}x{height} (width x height). Should be at least one texel each way.")
    found = IMAGE_LAYOUTS[layout].patches(height, width)
    if not found:
        raise ValueError(
            f"Invalid size {width}x{height} (width x height) for the layout {layout}. Should have the proportions "
            f"{IMAGE_LAYOUTS[layout].proportions}. Crop or resize the picture, or name its own layout."
        )
    return found


def layout_of(height: int, width: int) -> str:
    """Return the one layout that has a picture's proportions. Raises ValueError where none has.

    >>> layout_of(512, 1024)
    'equirect'
    """
    for name, layout in IMAGE_LAYOUTS.items():
        if height > 0 and width > 0 and layout.patches(height, width):
            return name
    known = "; ".join(f"{layout.proportions} {name}" for name, layout in IMAGE_LAYOUTS.items())
    raise ValueError(f"Invalid size {width}x{height} (width x height). Should have the proportions of a layout: {known}.")


def most_bands(layout: str, height: int, width: int) -> int:
    """Return the most bands that a picture's texels resolve: one a texel over half a turn, and 100 at most.

    Raises ValueError as ``patches`` does.
    """
    rows = patches(layout, height, width)[0].rows
    return max(1, min(_MOST_BANDS, int(rows / IMAGE_LAYOUTS[layout].half_turns)))
