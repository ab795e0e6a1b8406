"""Whether a config's light can light the report's pictures of scenes."""

from __future__ import annotations

import math
from collections.abc import Iterator

from skylight_sh.config.problem import Problem
from skylight_sh.config.schema import Config
from skylight_sh.light.preetham import Preetham
from skylight_sh.report.figures import SCENES

_BANDS, _TURBIDITY = 7, 3.0
_SUNS = (38.0, 88.0)


def find(config: Config) -> Iterator[Problem]:
    """Yield what keeps a config's pictures of scenes from being made; nothing where it asks for none."""
    asked = [name for name in config.report.figures if name in SCENES]
    if not asked:
        return
    path, scene = "$.report.figures", config.scene
    if not isinstance(config.light, Preetham) or len(config.source.channels) != len(config.light.channels):
        yield Problem(
            path, asked, 'Scenes are lit by the sky in colour. Use model = "preetham" and all channels, or leave them out.'
        )
        return
    if scene.quantity != "radiance" or scene.ground != "black" or scene.sun_disc or scene.window or scene.surrounded:
        remedy = "Scenes bring ground and shadows themselves. Ask for radiance above a black ground, and no surroundings."
        yield Problem(path, asked, remedy)
    ranges = {axis.name: axis.range for axis in config.axes} | {k: (v, v) for k, v in scene.fixed.items()}
    low, high = ranges.get("sun_zenith", (0.0, 0.0))
    if not (low <= math.radians(_SUNS[0]) and high >= math.radians(_SUNS[1]) and "sun_zenith" not in scene.fixed):
        remedy = f"Scenes have suns {_SUNS[0]:g} to {_SUNS[1]:g} degrees from the zenith. Widen the axis sun_zenith."
        yield Problem(path, asked, remedy)
    low, high = ranges.get("turbidity", (_TURBIDITY, _TURBIDITY))
    if not low <= _TURBIDITY <= high:
        yield Problem(
            path, asked, f"Scenes have a turbidity of {_TURBIDITY:g}. Let the axis turbidity hold it, or fix it there."
        )
    bands = next((w.bands for w in config.winners if config.export.recommended.startswith(f"{w.bands}-bands")), _BANDS)
    if bands < _BANDS:
        yield Problem(path, asked, f"Scenes are shown in up to {_BANDS} bands. Recommend a table of {_BANDS} bands or more.")
