"""What happens as the sun sinks: the sky of a sun on the horizon, faded out until the sun is 12 degrees below it.

With x the sun's depth below the horizon over 12 degrees, the weights are those of the horizon times (1 - x)^10 (1 + 10 x):
1 with slope 0 on the horizon, 0 with nine derivatives at the end of nautical twilight, and 0.6 % at that of civil twilight,
6 degrees, where the measured illuminance is 0.45 % of that at sunset (Seidelmann 1992). The errors of a table, as shares of
the same sky, are those on the horizon. The colours do not change: the model knows none of a sunken sun.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from skylight_sh.formula.expression import trace
from skylight_sh.runtime import Twilight

Floats = NDArray[np.floating]

BEGIN = float(np.pi / 2)
DEPTH = float(np.radians(12.0))
END = BEGIN + DEPTH
# float32 pi / 2 exceeds pi / 2: the rest of it.
REST = BEGIN - float(np.float32(BEGIN))
# The formula takes it as products: 4 + 4 + 2.
POWER = 10
FORMULA = f"(1 - x)^{POWER} (1 + {POWER} x), x = depth / {np.degrees(DEPTH):.3g} degrees"
# What an evaluation reads: begin and its rest, end, one over the depth.
NUMBERS = 4


def fade(x: Any) -> Any:
    """Return the factor of the horizon's weights at the depth ``x`` of the sun, 0 on the horizon to 1: generic numbers.

    >>> fade(0.0), round(fade(0.5), 4), fade(1.0)
    (1.0, 0.0059, 0.0)
    """
    two = (1.0 - x) * (1.0 - x)
    four = two * two
    return four * four * two * (1.0 + POWER * x)


TWILIGHT = Twilight(DEPTH, trace(lambda x: [fade(x)], ["x"]))
