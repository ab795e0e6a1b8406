"""What a scene's profile leaves out, and what that saves."""

from __future__ import annotations

import numpy as np

from skylight_sh.report.report_data import ReportData
from skylight_sh.table.row_layout import widths


def rows(data: ReportData) -> list[tuple[str, str]]:
    """Return what was skipped and what it saved, in numbers of this run; nothing where nothing was."""
    scene, light = data.settings["scene"], data.light
    table = data.best.table
    channels, bands = len(light.channels), table.bands
    grid = int(np.prod([nodes.size for nodes in data.grid]))
    found = []
    harmonics = data.harmonics.first(bands)
    if harmonics.mirrored:
        half, full = harmonics.count, bands * bands
        found.append(("orders m < 0, which symmetry makes zero", f"{half} instead of {full} weights a channel"))
    found += [
        (f"{name}, fixed at {value:g}", f"an axis: {grid} verification sets instead of {grid} times its nodes")
        for name, value in scene["fixed"].items()
    ]
    if scene["channels"] == "luminance" and channels == 1:
        found.append(("colour", "1 channel instead of 3: a third of the radiance's colours, fits and outputs"))
    if scene["quantity"] == "irradiance":
        kept, all_ = (count * table.spec.classes for count in (widths(table.spec, bands)[-1], harmonics.count))
        if kept < all_:
            found.append(("bands l = 3, 5, .., which carry no irradiance", f"{kept} instead of {all_} columns"))
    if scene["azimuth"] is not None:
        found.append(("the sun's azimuth, fixed", "an input, a sine and a cosine a call"))
    if scene["window"]:
        found.append(("the window at run time, folded into the weights", f"{(bands - 1) * channels} products a call"))
    if scene["sun"] is not None:
        first = next((a for a in data.axes if a.name == table.spec.peak_axis), data.axes[0])
        low, high = np.degrees(first.low), np.degrees(first.high)
        found.append(("suns that do not occur there and then", f"zenith angles {low:.1f} to {high:.1f} of 0 to 90 degrees"))
    for degree, axis, swept in zip(table.degrees, data.axes, data.sweep.degrees.max(axis=0), strict=True):
        if degree < swept:
            found.append((f"powers of {axis.name} above {degree}", f"{degree + 1} instead of {swept + 1} terms"))
    return found
