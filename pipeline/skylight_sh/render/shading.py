"""A lit scene through precomputed transfer: a dot product a vertex, interpolated, times the albedo of the point."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from skylight_sh.transfer import bounced

Array = NDArray[np.float64]


def lit(transfer: NDArray[np.floating], weights: NDArray[np.floating]) -> Array:
    """Return irradiance / pi ``(v, 3)`` of vertices under a light (Sloan, Kautz and Snyder 2002; Green 2003).

    ``transfer`` is ``(v, 3, N*N)``, or ``(v, N*N)`` for one that is alike in all channels; ``weights`` ``(3, M*M)`` are the
    light's. Bands that one of them lacks count as zero.

    >>> lit(np.array([[[0.25, 0.0, 0.3, 0.0]] * 3]), np.array([[4.0], [8.0], [0.0]])).tolist()
    [[1.0, 2.0, 0.0]]
    """
    known = min(transfer.shape[-1], weights.shape[-1])
    if transfer.ndim == 2:
        return np.asarray(transfer[:, :known] @ weights[:, :known].T, dtype=np.float64)
    return np.asarray(np.einsum("vck,ck->vc", transfer[..., :known], weights[:, :known]))


def sent_on(straight: Array, albedo: Array, matrix: sparse.csr_array, bounces: int) -> Array:
    """Return irradiance / pi ``(v, 3)`` that light on vertices, ``straight`` ``(v, 3)``, makes at others by its bounces.

    ``matrix`` is what transfer itself gathers with, ``albedo`` ``(v, 3)``; what was straight is not in it.
    """
    channels = range(straight.shape[1])
    each = (bounced(straight[:, c, np.newaxis], albedo[:, c, np.newaxis], matrix, bounces)[:, 0] for c in channels)
    return np.asarray(np.concatenate(list(each), axis=1) - straight)
