"""Whether a light's weights have the parity and the classes that it tells of: looked at by sampling before they are used."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from skylight_sh.fit.least_squares import fit_tensor
from skylight_sh.formula.bases import BASES
from skylight_sh.light.protocol import Light, LightError
from skylight_sh.quadrature import sampling
from skylight_sh.quadrature.registry import suited
from skylight_sh.runtime import Scale
from skylight_sh.sphere import Harmonics
from skylight_sh.table.grid_fit import factor_at

Array = NDArray[np.float64]

# Peaks no farther from the zenith, where weights are analytic; even terms for them; what may be left of the largest sum.
_FARTHEST, _SUNS, _TERMS, _LEFT = 1.0, 20, 12, 2e-5
_BANDS, _NODES = 4, 40


def residual(light: Light, axes: Sequence[str], middle: Sequence[float], peak: str, scale: Scale | None) -> float:
    """Return what sin^m times even terms of the axis ``peak`` leave of the classes' sums, relative to the largest.

    The other ``axes`` have their ``middle`` values; ``scale`` is the factor of the weights, or the classes' matrix.
    """
    theta = np.linspace(0.0, _FARTHEST, _SUNS)
    sets = np.tile(np.asarray(middle, dtype=np.float64), (_SUNS, 1))
    sets[:, list(axes).index(peak)] = theta
    harmonics = Harmonics.even(_BANDS) if light.hints.mirrored else Harmonics(_BANDS)
    job = sampling.Job(light, tuple(axes), sets[:, np.newaxis], _NODES, harmonics, suited(light, _BANDS))
    weights = sampling.project_block(job).weights[:, 0]
    sums = np.linalg.pinv(factor_at(scale, sets, len(light.channels))) @ weights
    even = BASES["chebyshev"].vander(2.0 * (theta / _FARTHEST) ** 2 - 1.0, _TERMS - 1)
    left = 0.0
    for m in range(_BANDS):
        own = sums[..., np.abs(harmonics.orders) == m].reshape(_SUNS, -1)
        basis = np.sin(theta)[:, np.newaxis] ** m * even
        left = max(left, float(np.abs(basis @ fit_tensor(own, [basis]).T - own).max()))
    return left / float(np.abs(sums).max())


def check(light: Light, axes: Sequence[str], middle: Sequence[float], peak: str, scale: Scale | None) -> None:
    """Raise LightError where the weights have no such parity; arguments as ``residual``."""
    found = residual(light, axes, middle, peak, scale)
    if not found <= _LEFT:
        raise LightError(
            f"The light {light.title!r} tells of parity, but sin^m times even functions of {peak} leave {found:.2g} of its "
            f"weights' sums, more than {_LEFT:g}. Mend its hints parity and classes, or give {peak} another map than even."
        )
