"""How pictures look: colours that colour-blind readers can tell apart, sizes, and bytes without dates."""

from __future__ import annotations

import io

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter

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
DPI = 110


def figure(width: float, height: float) -> Figure:
    """Return an empty figure of that size in inches, laid out so that labels do not collide."""
    return Figure(figsize=(width, height), dpi=DPI, layout="constrained")


def legible(width: float) -> float:
    """Return the least size of letters, in points, that a figure ``width`` inches wide has: 11 pixels when 360 are shown.

    >>> legible(10.0)
    22.0
    """
    return 11.0 * width * 72.0 / 360.0


def png(drawn: Figure) -> bytes:
    """Return a figure's bytes; equal figures give equal bytes."""
    out = io.BytesIO()
    drawn.savefig(out, format="png", metadata={"Software": None})
    return out.getvalue()


def percent_ticks() -> FuncFormatter:
    """Return a formatter for axes of fractions, labelled in per cent."""
    return FuncFormatter(lambda value, _: percent(float(value)))


def percent(value: float) -> str:
    """Return a fraction as per cent to three digits, never in exponents."""
    shown = f"{100 * value:.3g}"
    return f"{shown if 'e' not in shown else np.format_float_positional(float(shown), trim='-')} %"
