"""What a table's surroundings do to its errors; ``scene.surroundings`` makes them, ``runtime`` applies them."""

from __future__ import annotations

import numpy as np

from skylight_sh.runtime import Surroundings

PARTS = ("transfer", "own", "below")


def gain(surroundings: Surroundings) -> float:
    """Return how much E_mean may grow: the largest singular value of the linear part, ground included, of any channel.

    >>> gain(Surroundings(transfer=np.diag([0.5, 0.25, 0.25, 0.25])))
    0.5
    """
    if not surroundings.transfer.size:
        return 1.0
    linear = surroundings.transfer[np.newaxis]
    if surroundings.below.size:
        linear = linear + surroundings.below[:, :, np.newaxis] * surroundings.transfer[2]
    return float(np.linalg.norm(linear, 2, axis=(1, 2)).max())
