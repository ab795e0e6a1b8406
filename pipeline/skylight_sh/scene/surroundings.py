"""What stands about a scene, as one linear map of its sky's weights: skyline, clouds, occluders, ground and lamps.

A skyline, clouds and occluders let a part of the sky through (a transfer matrix of triple products, Green 2003, eq. 8),
clouds and lamps shine themselves, and the ground below the skyline reflects what then falls onto the horizontal. The map is
``runtime.Surroundings``, which a table takes along.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from skylight_sh import sphere
from skylight_sh.formula.harmonics import HORIZONTAL
from skylight_sh.reproducible import to_grid

if TYPE_CHECKING:
    from skylight_sh.runtime import Surroundings

Array = NDArray[np.float64]

# Products of 2N - 1 bands with N take a few seconds and about 1 GB at 12 bands, half a minute and 3 GB at 16.
MOST_BANDS = 12
# Of the largest number of a part, as in single precision: finer ones would be the last bits of who computed them.
_GRID_BITS = 24
_NONE: Array = np.zeros(0)


@dataclass(frozen=True)
class Clouds:
    """Clouds before the sky: SH weights ``(N*N,)`` of their ``opacity``, 0 to 1, and their ``radiance`` ``(channels,)``."""

    opacity: Array
    radiance: ArrayLike

    def first(self, bands: int) -> Clouds:
        """Return the first ``bands`` bands."""
        return Clouds(self.opacity[: bands * bands], self.radiance)


def mask_bands(bands: int) -> int:
    """Return how many bands of a mask its product with ``bands`` bands needs, of which as many are kept: exactly these.

    >>> mask_bands(4)
    7
    """
    return 2 * bands - 1


def build(
    bands: int,
    skyline: Sequence[float] = (),
    clouds: Clouds | None = None,
    occluders: tuple[Array, Array] | None = None,
    albedo: Sequence[float] | None = None,
    lights: Array = _NONE,
) -> Surroundings:
    """Combine a scene's parts, nearest last: clouds before the sky, the skyline before them, occluders before all.

    Clouds end where the sky does: on the skyline, or on a level horizon where none is given.

    ``skyline`` as ``sphere.horizon`` takes it; ``occluders`` half-angles ``(n,)`` and directions ``(n, 3)`` of black
    spheres; ``albedo`` the ground's, one a channel, below the skyline; ``lights`` ``(channels, N*N)`` are hidden by nothing
    and do not light the ground. Masks are multiplied with 2N - 1 bands of each. Raises ValueError for a number out of its
    range.
    """
    from skylight_sh.runtime import Surroundings

    masked = bool(len(skyline) or clouds or occluders)
    if albedo is not None and masked and bands < 2:
        raise ValueError("One band does not tell the irradiance on the ground. Give at least two bands.")
    wide = mask_bands(bands)
    one = np.zeros(wide * wide)
    one[0] = np.sqrt(4 * np.pi)
    near = one
    for half_angle, direction in zip(*occluders, strict=True) if occluders else ():
        shade = one - sphere.aim(sphere.cap(half_angle, wide), direction)
        near = sphere.product(near, shade, wide)
    # The sky's own end, and what of it the skyline leaves.
    level = sphere.horizon(skyline if len(skyline) else 0.0, wide)
    above = level if len(skyline) else one
    seen = sphere.product(near, above, wide) if occluders else above
    through, own, below = seen, _NONE, _NONE
    if clouds:
        opaque = clouds.opacity if len(skyline) else sphere.product(level, clouds.opacity, wide)
        hidden = sphere.product(seen, opaque, wide)
        through, own = seen - hidden, np.multiply.outer(np.asarray(clouds.radiance), hidden[: bands * bands])
    if albedo is not None and masked:
        ground = one - level
        shape = sphere.product(near, ground, bands) if occluders else ground[: bands * bands]
        below = np.multiply.outer(np.array(albedo) * (HORIZONTAL / np.pi), shape)
    if lights.size:
        # What the ground will reflect of them is taken away beforehand: below * own[l = 1, m = 0].
        alone = lights - below * lights[:, 2:3] / (1.0 + below[:, 2:3]) if below.size else lights
        own = own + alone if own.size else alone
    return Surroundings(sphere.multiplication(through, bands) if masked else _NONE, own, below)


def rounded(around: Surroundings) -> Surroundings:
    """Return the surroundings on a grid that single precision holds, the same on every machine."""
    return type(around)(*(to_grid(part, _GRID_BITS) for part in (around.transfer, around.own, around.below)))
