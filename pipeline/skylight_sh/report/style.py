"""How pictures look: colours that colour-blind readers can tell apart, sizes, and bytes without dates."""

from __future__ import annotations

import io
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, NullLocator
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
ERROR_MAP = "viridis"
SIGNED_MAP = "PuOr"
# Pictures have two by two pixels for each that a page shows.
DPI = 220


def figure(width: float, height: float) -> Figure:
    """Return an empty figure of that size in inches, laid out so that labels do not collide.

    To search for such a layout takes as long as to draw the figure; ``panels`` are placed by what is known of them.
    """
    return Figure(figsize=(width, height), dpi=DPI, layout="constrained")


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
    made = Figure(figsize=(width, height), dpi=DPI)
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


def legible(width: float) -> float:
    """Return the least size of letters, in points, that a figure ``width`` inches wide has: 11 pixels when 360 are shown.

    >>> legible(10.0)
    22.0
    """
    return 11.0 * width * 72.0 / 360.0


def png(drawn: Figure) -> bytes:
    """Return a figure's bytes; equal figures give equal bytes."""
    # Not by savefig, which goes through all of a figure twice.
    canvas: Any = FigureCanvasAgg(drawn)
    canvas.draw()
    out = io.BytesIO()
    opaque = np.ascontiguousarray(np.asarray(canvas.buffer_rgba())[..., :3])
    # A few per cent larger than at the usual level, in two thirds of its time.
    Image.fromarray(opaque).save(out, "png", dpi=(DPI, DPI), compress_level=4)
    return out.getvalue()


def shown(drawn: Figure) -> tuple[int, int]:
    """Return the width and height in pixels at which a page shows a figure: each has two by two of the picture's."""
    width, height = (round(float(inches) * drawn.dpi / 2) for inches in drawn.get_size_inches())
    return width, height


# Pictures label with it too.
percent = amounts.percent


def percent_ticks() -> FuncFormatter:
    """Return a formatter for axes of fractions, labelled in per cent."""
    return FuncFormatter(lambda value, _: percent(float(value)))
