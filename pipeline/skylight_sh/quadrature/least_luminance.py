"""The least luminance of the upper hemisphere, L_min of the paper's eqs. 2 and 3."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from skylight_sh.light.protocol import Light, Parameters

Array = NDArray[np.float64]

_FIRST_STEP = 0.05
_LAST_STEP = 5e-4


def refine(light: Light, parameters: Parameters, directions: Array, least: Array) -> Array:
    """Sharpen the least luminance of each parameter set by a pattern search over the upper hemisphere.

    Parameters have shape ``(n,)``; ``directions`` ``(n, 3)`` and ``least`` ``(n,)`` are the darkest samples
    of the quadrature, which are dense enough to stand in the right valley. Returns ``(n,)``, right to about 1e-6
    of itself where the sky is smooth: the last step is 5e-4 rad and the minimum is quadratic, or on the horizon.

    >>> from skylight_sh.light.cie_traditional import CieTraditional
    >>> start, found = np.array([[0.995, 0.0, 0.1]]), np.array([0.4])
    >>> refine(CieTraditional(sky="overcast"), {"sun_zenith": np.array([0.4])}, start, found).round(4).tolist()
    [0.3333]
    """
    zenith = np.arctan2(np.hypot(directions[:, 0], directions[:, 1]), directions[:, 2])
    azimuth = np.arctan2(directions[:, 1], directions[:, 0])
    best = least.copy()
    offsets = np.array([(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1) if (i, j) != (0, 0)], dtype=np.float64)
    step = _FIRST_STEP
    while step >= _LAST_STEP:
        moving = np.arange(best.size)
        # Several moves a step, since a start can lie a few steps from its valley's floor; who stays would stay again.
        for _ in range(3):
            # A turn in azimuth covers little ground near the zenith, hence the larger angle there.
            around = step / np.maximum(np.sin(zenith[moving]), step)
            z = np.clip(zenith[moving, np.newaxis] + step * offsets[:, 0], 0.0, np.pi / 2)
            a = azimuth[moving, np.newaxis] + around[:, np.newaxis] * offsets[:, 1]
            tried = np.stack([np.sin(z) * np.cos(a), np.sin(z) * np.sin(a), np.maximum(np.cos(z), 0.0)], axis=-1)
            named = {name: values[moving, np.newaxis] for name, values in parameters.items()}
            luminance = light.radiance(tried, named) @ light.luminance_row
            choice = luminance.argmin(axis=1)[:, np.newaxis]
            lowest, z, a = (np.take_along_axis(values, choice, axis=1)[:, 0] for values in (luminance, z, a))
            better = lowest < best[moving]
            moving = moving[better]
            best[moving], zenith[moving], azimuth[moving] = lowest[better], z[better], a[better]
            if not moving.size:
                break
        step /= 3.0
    return best
