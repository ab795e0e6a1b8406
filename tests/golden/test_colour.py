"""Colour spaces from their primaries and whites, and the luminance that follows."""

from __future__ import annotations

import numpy as np
import pytest
from skylight_sh.light import colour

from golden.oracles import REC709, WHITE, xyz_to_rgb

BRADFORD = np.array([[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]])  # Lam 1985


def test_srgb_is_its_primaries_to_seven_digits() -> None:
    assert colour.matrix("srgb").tolist() == np.round(xyz_to_rgb(REC709, WHITE), 7).tolist()
    # Rec. 709's printed luma factors, 0.2126, 0.7152, 0.0722.
    assert colour.luminance_row("srgb") == pytest.approx([0.2126, 0.7152, 0.0722], abs=1e-4)
    assert colour.luminance_row("srgb") == pytest.approx(np.linalg.inv(xyz_to_rgb(REC709, WHITE))[1], abs=1e-7)
    assert colour.matrix("srgb") @ WHITE == pytest.approx([1, 1, 1], abs=1e-6)


@pytest.mark.parametrize(
    ("space", "primaries", "white"),
    [
        ("ITU-R BT.2020", [[0.708, 0.292], [0.170, 0.797], [0.131, 0.046]], [0.3127, 0.3290]),  # ITU-R BT.2020-2
        ("Display P3", [[0.680, 0.320], [0.265, 0.690], [0.150, 0.060]], [0.3127, 0.3290]),  # SMPTE RP 431-2
        ("ACEScg", [[0.713, 0.293], [0.165, 0.830], [0.128, 0.044]], [0.32168, 0.33767]),  # S-2014-004, AP1
        ("Adobe RGB (1998)", [[0.64, 0.33], [0.21, 0.71], [0.15, 0.06]], [0.3127, 0.3290]),
    ],
)
def test_other_spaces_by_bradfords_adaptation(space: str, primaries: list[list[float]], white: list[float]) -> None:
    x, y = white
    target = np.array([x / y, 1.0, (1 - x - y) / y])
    own = np.array([0.3127 / 0.3290, 1.0, (1 - 0.3127 - 0.3290) / 0.3290])  # IEC 61966-2-1, of which colour-science starts
    adapt = np.linalg.inv(BRADFORD) @ np.diag(BRADFORD @ target / (BRADFORD @ own)) @ BRADFORD
    from_srgb = xyz_to_rgb(np.array(primaries), target) @ adapt @ np.linalg.inv(xyz_to_rgb(REC709, own))
    got = colour.matrix(space) @ np.linalg.inv(colour.matrix("srgb"))
    # colour-science rounds its published matrices to four digits or more.
    assert np.abs(got - from_srgb).max() < 3e-4
    assert got @ np.ones(3) == pytest.approx(np.ones(3), abs=4e-4)
    # The Y of D65's own white, whose share every space must keep (ACES stands under another white, adapted).
    assert float(colour.luminance_row(space).sum()) == pytest.approx(1.0, abs=4e-4)
