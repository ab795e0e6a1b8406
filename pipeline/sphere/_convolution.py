"""Convolution with zonal kernels."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from pipeline.sphere._indexing import check_bands


def clamped_cosine(bands: int) -> NDArray[np.float64]:
    """Return the factors ``A_l`` by which a clamped cosine turns radiance weights into irradiance weights, ``(bands,)``.

    pi, 2 pi / 3, pi / 4, 0, -pi / 24, ..: for l = 0, 1 and even l; other odd l carry nothing (Ramamoorthi and Hanrahan
    2001, eq. 8). The irradiance towards n is the sum of ``A_l c_lm y_lm(n)``, not divided by pi.
    """
    check_bands(bands)
    out = np.zeros(bands)
    for l in range(bands):
        if l == 1:
            out[l] = 2 * math.pi / 3
        elif l % 2 == 0:
            sign = -1.0 if l % 4 == 0 else 1.0
            out[l] = sign * 2 * math.pi / ((l + 2) * (l - 1)) * math.comb(l, l // 2) / 2**l
    return out
