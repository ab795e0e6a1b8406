"""How pictures look: colours that colour-blind readers can tell apart, sizes, and bytes without dates."""

from __future__ import annotations

import io
import zlib
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import QuadMesh
from matplotlib.figure import Figure
from matplotlib.image import AxesImage
from matplotlib.text import Text
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullLocator
from numpy.typing import NDArray
from PIL import Image

from skylight_sh.report import amounts

# Okabe and Ito's palette.
BLUE, ORANGE, GREEN, PURPLE, SKY, YELLOW, RED, BLACK = (
    "#0072B2",
    "#E69F00",
    "#009E73",
    "#CC79A7",
    "#56B4E9",
    "#F0E442",
    "#D55E00",
    "#000000",
)
SERIES = (BLUE, RED, GREEN, PURPLE, ORANGE, SKY, BLACK)
MARKERS = ("o", "s", "^", "D", "v", "P", "X")
# As long as a digit is wide.
_MINUS = "\N{MINUS SIGN}"
ERROR_MAP = "viridis"
SIGNED_MAP = "PuOr"
# Inches of a page's column, and pixels of a picture that wide: two by two for each that is shown.
WIDTH = 5.0
_PIXELS = 1100.0
# The least width in pixels at which letters are to be legible, and how high they then are.
_PHONE, _LETTERS = 360.0, 11.0


def figure(width: float, height: float) -> Figure:
    """Return an empty figure of that size in inches, laid out so that labels do not collide.

    To search for such a layout takes as long as to draw the figure; ``panels`` are placed by what is known of them.
    """
    return Figure(figsize=(width, height), dpi=_PIXELS / width, layout="constrained")


def look(place: int, *, fewer: bool = False) -> dict[str, Any]:
    """Return how the series at ``place`` is drawn: colour, marker, and beyond seven of them open marks and dashes.

    ``fewer`` leaves out most markers where points are many.

    >>> look(0)["color"] == look(7)["color"], look(0)["marker"] == look(7)["marker"]
    (True, False)
    """
    again = place // len(SERIES)
    return {
        "color": SERIES[place % len(SERIES)],
        "marker": MARKERS[(place + 3 * again) % len(MARKERS)],
        "markerfacecolor": "white" if again % 2 else None,
        "linestyle": "--" if again % 2 else "-",
        "markersize": 6,
        "markevery": 9 if fewer else 1,
    }


def panels(
    width: float,
    height: float,
    rows: int = 1,
    columns: int = 1,
    *,
    left: float = 0.8,
    right: float = 0.15,
    bottom: float = 0.55,
    top: float = 0.35,
    gap: tuple[float, float] = (0.8, 0.6),
    **options: Any,
) -> tuple[Figure, NDArray[np.object_]]:
    """Return a figure of that size with its axes ``(rows, columns)``, ``gap`` apart across and down.

    All lengths are in inches, and have to leave room for the labels; ``options`` are those of ``Figure.subplots``.

    >>> figure, axes = panels(4.0, 2.0, columns=2, left=0.5, right=0.5, bottom=0.5, top=0.5, gap=(1.0, 0.0))
    >>> [float(axis.get_position().x0) for axis in axes[0]]
    [0.125, 0.625]
    """
    made = Figure(figsize=(width, height), dpi=_PIXELS / width)
    across = (width - left - right - (columns - 1) * gap[0]) / columns
    down = (height - bottom - top - (rows - 1) * gap[1]) / rows
    edges = {"left": left / width, "right": 1.0 - right / width, "bottom": bottom / height, "top": 1.0 - top / height}
    room = {**edges, "wspace": gap[0] / across, "hspace": gap[1] / down}
    return made, made.subplots(rows, columns, squeeze=False, gridspec_kw=room, **options)


def bar(drawn: Figure, left: float, bottom: float, width: float, height: float) -> Axes:
    """Return axes for a colour bar at that place, in inches from the lower left corner."""
    across, up = drawn.get_size_inches()
    return drawn.add_axes((left / across, bottom / up, width / across, height / up))


def decades(axis: Axis) -> None:
    """Mark the decades of a logarithmic axis alone: each mark between them takes as long as a label."""
    axis.set_minor_locator(NullLocator())


def steps(axis: Axis) -> None:
    """Mark a logarithmic axis so that long labels do not collide: its decades, and between few of them 2 and 5 too."""
    low, high = sorted(axis.get_view_interval())
    decades = float(np.log10(high / low))
    if decades < 0.9:
        axis.set_major_locator(MaxNLocator(4))
        axis.set_minor_locator(NullLocator())
        return
    subs = (1.0, 2.0, 5.0) if decades < 1.6 else (1.0, 3.0) if decades < 2.2 else (1.0,)
    axis.set_major_locator(LogLocator(subs=subs, numticks=8))
    axis.set_minor_locator(NullLocator())


def legible(width: float) -> float:
    """Return the least size of letters, in points, that a figure ``width`` inches wide has: 11 pixels when 360 are shown.

    >>> legible(10.0)
    22.0
    """
    return _LETTERS * width * 72.0 / _PHONE


def png(drawn: Figure) -> bytes:
    """Return a figure's bytes, no letters of it smaller than legible; equal figures give equal bytes."""
    least = legible(float(drawn.get_size_inches()[0]))
    for text in drawn.findobj(Text):
        if float(text.get_fontsize()) < least:
            text.set_fontsize(least)
    # Not by savefig, which goes through all of a figure twice.
    canvas: Any = FigureCanvasAgg(drawn)
    canvas.draw()
    out = io.BytesIO()
    opaque = np.ascontiguousarray(np.asarray(canvas.buffer_rgba())[..., :3])
    image = Image.fromarray(opaque)
    # Gradients would show steps that are not there.
    if not any(drawn.findobj(kind) for kind in (AxesImage, QuadMesh)):
        image = _fewer_colours(image)
    image.save(out, "png", dpi=(drawn.dpi, drawn.dpi), compress_level=6, compress_type=zlib.Z_DEFAULT_STRATEGY)
    return out.getvalue()


def _fewer_colours(image: Image.Image) -> Image.Image:
    """Return lines and letters on white in 256 colours, which takes a third of the bytes."""
    palette = image.quantize(256, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
    # White stays white.
    place = int(np.asarray(palette)[0, 0])
    colours = palette.getpalette() or []
    colours[3 * place : 3 * place + 3] = [255] * 3
    palette.putpalette(colours)
    return palette


def shown(drawn: Figure) -> tuple[int, int]:
    """Return the width and height in pixels at which a page shows a figure: each has two by two of the picture's."""
    width, height = (round(float(inches) * drawn.dpi / 2) for inches in drawn.get_size_inches())
    return width, height


# Pictures label with it too.
percent, plain = amounts.percent, amounts.plain


def percent_ticks() -> FuncFormatter:
    """Return a formatter for axes of fractions, labelled in per cent."""
    return FuncFormatter(lambda value, _: percent(float(value)).replace("-", _MINUS))


def plain_ticks() -> FuncFormatter:
    """Return a formatter for axes of numbers, without exponents."""
    return FuncFormatter(lambda value, _: plain(float(value)).replace("-", _MINUS))
