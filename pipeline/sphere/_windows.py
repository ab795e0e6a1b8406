"""Windows against ringing."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pipeline.sphere._indexing import degrees_orders


def zonal_sinc(bands: int) -> NDArray[np.float64]:
    """Return the factors of the zonal window ``sinc(pi l / N)``, m = 0 alone (Habel et al. 2008, eq. 5).

    Shape ``(N*N,)`` in flat order; every order m != 0 keeps its weight. The paper's sinc is
    ``sin(x)/x``: a box filter in the zenith angle, which is where the sky jumps.
    """
    degrees, orders = degrees_orders(bands)
    return np.where(orders == 0, np.sinc(degrees / bands), 1.0)
