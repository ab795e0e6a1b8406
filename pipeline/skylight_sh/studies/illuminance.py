"""How bright is a clear day? Lux on the horizontal from sky and sun, each beside published values."""

from __future__ import annotations

import numpy as np

from skylight_sh.scene import clear_day
from skylight_sh.studies import outcomes
from skylight_sh.studies.page import Row, Section

TEXT = (
    "Illuminance in lux on the horizontal: the Preetham sky, its sun's disc, and both, beside IES RP-21 (1984) for a clear "
    "day, a regression over measurements without turbidity. Where sky and sun differ and their sum does not, two errors "
    f"cancel. Above the atmosphere the sun gives {clear_day.SOLAR:,.0f} lx."
)
_HEIGHTS = (0, 5, 15, 30, 50, 70, 90)
_TURBIDITIES = (2.0, 2.5, 3.0, 4.0)


def section() -> Section:
    """Compute a clear day for some heights of the sun and turbidities."""
    theta = np.radians(90.0 - np.array(_HEIGHTS))
    diffuse, beam = clear_day.published(theta)
    rows: list[Row] = [_row(height, "IES RP-21", *parts) for height, *parts in zip(_HEIGHTS, diffuse, beam, strict=True)]
    for tau in _TURBIDITIES:
        found = clear_day.clear_day(theta, tau)
        rows += [_row(height, f"{tau:g}", *parts) for height, *parts in zip(_HEIGHTS, *found, strict=True)]
    rows = sorted(rows, key=lambda row: int(str(row["sun's height"])))
    return Section("daylight", "A clear day in lux", TEXT, rows, told=outcomes.daylight(rows))


def _row(height: int, turbidity: str, sky: float, disc: float) -> Row:
    lux = {"sky": sky, "sun": disc, "both": sky + disc}
    return {"sun's height": height, "turbidity": turbidity, **{key: round(float(value)) for key, value in lux.items()}}
