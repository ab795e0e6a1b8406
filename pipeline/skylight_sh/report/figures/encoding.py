"""Captured light: how 8-bit pictures ring, decoded from sRGB or not, beside floats and a Gaussian pre-filter."""

from __future__ import annotations

import textwrap

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from skylight_sh import probe
from skylight_sh.probe.files import from_srgb, to_srgb
from skylight_sh.report import panorama, style
from skylight_sh.report.figures.picture import Picture
from skylight_sh.report.report_data import ReportData

Array = NDArray[np.float64]

_ROWS = 128
_BANDS = tuple(range(2, 11))
_SHOWN = 5
_BLUR = 20.0
_LAMP = np.array([0.0, np.sqrt(0.5), np.sqrt(0.5)])
_LAMP_COSINE = np.cos(np.radians(3.0))
_LAMP_BRIGHTNESS = 100.0
SEE = "Red is negative light: the nearer a curve stays to zero, the less a captured sky rings."
CAPTION = (
    f"The sky at the middle of all ranges and a lamp of 6 degrees, {_LAMP_BRIGHTNESS:g} times as bright as what a fiftieth "
    f"of the sky exceeds, as a panorama of {2 * _ROWS} x {_ROWS} texels and back: floats; 8 bits of sRGB, decoded, exposed "
    "for that brightness; the same taken as linear, which lifts the darks and is no radiance any more; and the floats "
    f"behind a Gaussian of {_BLUR:g} degrees. Undershoot: the most negative luminance over the largest of the same "
    "expansion, since what is the picture's own brightest value depends on how it was stored. Pictures: "
    f"{_SHOWN} bands, azimuth across, altitude up."
)


def draw(data: ReportData) -> Figure:
    """Draw undershoot over bands, and the four expansions."""
    pictures = _pictures(data)
    row = data.light.luminance_row
    figure = style.figure(style.WIDTH, 8.6)
    curves, *panels = figure.subplot_mosaic(
        [["curves", "curves"], ["0", "1"], ["2", "3"]], height_ratios=(2.2, 1.0, 1.0)
    ).values()
    for k, (name, (pixels, sigma)) in enumerate(pictures.items()):
        weights = probe.blur(probe.project(pixels, "equirect", _BANDS[-1]), sigma)
        lows = []
        for bands in _BANDS:
            seen = panorama.expansion(weights[:, : bands * bands]) @ row
            lows.append(min(float(seen.min()), 0.0) / float(seen.max()))
            if bands == _SHOWN:
                white = panorama.white(seen[: len(seen) // 2])
                shown = panorama.display(panorama.expansion(weights[:, : bands * bands]), white)
                # What is negative is red, since black would hide it.
                shown[seen < 0.0] = (0.8, 0.1, 0.1)
                panels[k].imshow(shown, extent=panorama.EXTENT, aspect="auto", interpolation="nearest")
        curves.plot(_BANDS, lows, label=name, **style.look(k))
        panels[k].set_title("\n".join(textwrap.wrap(name, 22)), fontsize=11)
        panels[k].set_xticks([])
        panels[k].set_yticks([])
    curves.yaxis.set_major_formatter(style.percent_ticks())
    curves.axhline(0.0, color="grey", linewidth=0.6)
    curves.set_xlabel("bands")
    curves.set_title("undershoot, of the expansion's largest value", fontsize=11)
    curves.legend(fontsize=11, loc="upper center", bbox_to_anchor=(0.45, -0.18), frameon=False)
    return figure


def _pictures(data: ReportData) -> dict[str, tuple[Array, float]]:
    """Return the pictures by name, each with the pre-filter's standard deviation in radians."""
    light = data.light
    parameters = {axis.name: np.array([value]) for axis, value in zip(data.axes, data.middle, strict=True)}
    floats = probe.render(light, parameters, "equirect", _ROWS, 2 * _ROWS)
    white = panorama.white(floats[: _ROWS // 2] @ light.luminance_row)
    patch = probe.patches("equirect", _ROWS, 2 * _ROWS)[0]
    u, v = ((edges[1:] + edges[:-1]) / 2 for edges in patch.edges())
    floats[patch.chart.directions(u, v[:, np.newaxis]) @ _LAMP > _LAMP_COSINE] = _LAMP_BRIGHTNESS * white
    exposed = floats / white
    stored = np.rint(255.0 * to_srgb(np.clip(exposed, 0.0, 1.0))) / 255.0
    decoded = from_srgb(stored.astype(np.float32)).astype(np.float64)
    clipped = float((exposed >= 1.0).any(axis=-1).mean())
    return {
        "floats": (np.maximum(floats, 0.0), 0.0),
        f"8 bits, decoded ({style.percent(clipped)} clipped)": (decoded, 0.0),
        "8 bits, taken as linear": (stored, 0.0),
        f"floats, Gaussian of {_BLUR:g}°": (np.maximum(floats, 0.0), float(np.radians(_BLUR))),
    }


PICTURE = Picture("Ringing of captured light", CAPTION, draw, see=SEE)
