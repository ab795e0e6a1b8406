"""Whether a table's errors can be told at all: a proof is no better than what it divides by."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from skylight_sh.light import LightError

Array = NDArray[np.float64]


def check_scales(l_min: Mapping[str, Array], parameters: Array) -> None:
    """Raise LightError where what errors are relative to is not finite and positive.

    ``l_min`` holds the denominators ``(n,)`` by convention, of parameter sets ``(n, axes)``.
    """
    for convention, values in l_min.items():
        wrong = ~(np.isfinite(values) & (values > 0.0))
        if wrong.any():
            at = int(np.argmax(wrong))
            what = "mean luminance" if convention == "mean" else "least luminance"
            raise LightError(
                f"A table's errors are relative to the {what}, which is {values[at]:g} cd/m2 at the parameters "
                f"{', '.join(f'{v:.6g}' for v in parameters[at])}, but must be positive. Mend the light, or narrow the "
                "axes' ranges."
            )


def check_errors(errors: Mapping[str, Array]) -> None:
    """Raise LightError where an error, of arrays by name, is not finite and at least 0."""
    for name, found in errors.items():
        wrong = ~(np.isfinite(found) & (found >= 0.0))
        if wrong.any():
            raise LightError(
                f"A table's {name} is {found[wrong][0]:g}, but an error is finite and at least 0. Mend the light, narrow "
                "the axes' ranges, or lower the degrees."
            )
