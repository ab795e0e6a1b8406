"""What happens as the sun sinks: the sky of a sun on the horizon, faded out until the sun is 12 degrees below it.

With x the sun's depth below the horizon over 12 degrees, the weights are those of the horizon times (1 - x)^10 (1 + 10 x):
1 with slope 0 on the horizon, 0 with nine derivatives at the end of nautical twilight, and 0.6 % at that of civil twilight,
6 degrees, where the measured illuminance is 0.45 % of that at sunset (Seidelmann 1992). The errors of a table, as shares of
the same sky, are those on the horizon. The colours do not change: the model knows none of a sunken sun.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.floating]

BEGIN = float(np.pi / 2)
DEPTH = float(np.radians(12.0))
END = BEGIN + DEPTH
# float32 pi / 2 exceeds pi / 2: the rest of it.
REST = BEGIN - float(np.float32(BEGIN))
# Headers and shaders write the power as products: 4 + 4 + 2.
POWER = 10
FORMULA = f"(1 - x)^{POWER} (1 + {POWER} x), x = depth / {np.degrees(DEPTH):.3g} degrees"
# What an evaluation reads: begin and its rest, end, one over the depth.
NUMBERS = 4


def fade(theta: Floats) -> Floats:
    """Return the factor of the horizon's weights for sun zenith angles ``theta`` (radians, any shape); 1 above it."""
    x = np.clip((theta - BEGIN) / DEPTH, 0.0, 1.0)
    return np.asarray((1.0 - x) ** POWER * (1.0 + POWER * x))
