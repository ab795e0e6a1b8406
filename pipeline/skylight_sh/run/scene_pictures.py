"""Pictures as a stage keeps them: in sRGB, with how far each is off the one that it is held to."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from skylight_sh.render import metrics, tone
from skylight_sh.store.dataset import Variable

Array = NDArray[np.float64]


def compared_with(
    name: str,
    radiance: Mapping[str, Array],
    reference: str,
    halves: tuple[Array, Array],
    shown: NDArray[np.bool_],
    exposure: float,
) -> dict[str, Variable]:
    """Return pictures of ``radiance`` ``(rows, columns, 3)`` by their number of bands, and the reference, in bytes of sRGB.

    ``NAME/bands``, ``NAME/error`` and ``NAME/flip`` list the others' relative RMSE over the pixels ``shown``, against two
    ``halves`` of the reference so that its noise is left out, and their FLIP.
    """
    pictures = {key: tone.display(picture, exposure) for key, picture in radiance.items()}
    others = [key for key in radiance if key != reference]
    one, other = (half[shown] for half in halves)
    errors = [metrics.relative_rmse_of_halves(radiance[key][shown], one, other) for key in others]
    flips = [metrics.flip(pictures[key], pictures[reference]) for key in others]
    rows, columns = shown.shape
    dims, listed = (f"row_{rows}", f"column_{columns}", "channel"), (f"bands_{name}",)
    return {
        **{f"{name}/{key}": Variable(dims, np.round(255 * picture).astype(np.uint8)) for key, picture in pictures.items()},
        f"{name}/bands": Variable(listed, np.array([int(key) for key in others])),
        f"{name}/error": Variable(listed, np.array(errors)),
        f"{name}/flip": Variable(listed, np.array(flips)),
    }
