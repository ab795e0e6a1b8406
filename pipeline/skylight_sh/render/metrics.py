"""How far a picture is from what it should be: in linear light, and to the eye."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from skylight_sh import MissingExtraError

Array = NDArray[np.float64]


def relative_rmse(picture: NDArray[np.floating], true: NDArray[np.floating]) -> float:
    """Return the RMSE of a picture's linear radiance over the RMS of the true one, all channels alike; any shape.

    >>> round(relative_rmse(np.array([1.1, 2.2]), np.array([1.0, 2.0])), 6)
    0.1
    """
    return float(np.sqrt(np.mean(np.square(picture - true)) / np.mean(np.square(true))))


def relative_rmse_of_halves(picture: NDArray[np.floating], one: NDArray[np.floating], other: NDArray[np.floating]) -> float:
    """Return the same against the mean of two independent noisy estimates of the truth, their noise left out.

    The mean of (picture - one) (picture - other) is that of the picture's own squared error; where it comes out below 0 the
    picture is as good as can be told.
    """
    square = np.mean((picture - one) * (picture - other))
    return float(np.sqrt(max(square, 0.0) / np.mean(one * other)))


def flip(picture: NDArray[np.floating], true: NDArray[np.floating], pixels_per_degree: float = 67.0) -> float:
    """Return the mean LDR-FLIP ``0`` (alike) to ``1`` of pictures ``(rows, columns, 3)`` in sRGB (Andersson et al. 2020).

    ``pixels_per_degree`` is how finely the eye sees the screen. Raises MissingExtraError without flip-evaluator.
    """
    try:
        import flip_evaluator
    except ImportError as error:
        raise MissingExtraError("FLIP needs flip-evaluator. Install it: pip install 'skylight-sh[transfer]'.") from error
    as_read = [np.ascontiguousarray(one, dtype=np.float32) for one in (true, picture)]
    _, mean, _ = flip_evaluator.evaluate(*as_read, "LDR", applyMagma=False, parameters={"ppd": pixels_per_degree})
    return float(mean)
