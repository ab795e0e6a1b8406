"""The study of ringing, on expansions whose figures are known."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from skylight_sh import sphere
from skylight_sh.report import panorama
from skylight_sh.report.ringing import ALBEDO, GROUNDS, LEAST, measure


def ones(sets: int) -> NDArray[np.float64]:
    """Skies of 1 above a black horizon."""
    view = panorama.directions()
    return np.broadcast_to((view[..., 2] > 0).astype(float), (sets, *view.shape[:2]))


def test_a_cosine_is_negative_on_half_the_sphere() -> None:
    weights = np.zeros((2, 9))
    weights[:, 0] = 1e-9
    weights[0, 2] = np.sqrt(4 * np.pi / 3)
    found = measure(weights, ones(2), (2, 3))
    black, mirrored = 0, list(GROUNDS).index("mirrored sky")
    assert found.undershoot[black, 0] == pytest.approx(1, abs=2e-3)
    assert found.area[black, 0] == pytest.approx(0.5, abs=1e-3)
    assert found.worst[black, 0].tolist() == [0, 0]
    # Eq. 5: sinc(pi / 2) at two bands, sinc(pi / 3) at three.
    sinc = found.windows.index("zonal sinc (eq. 5)")
    assert found.undershoot[black, sinc] == pytest.approx(np.sinc([1 / 2, 1 / 3]), abs=2e-3)
    assert found.undershoot[mirrored] == pytest.approx(0, abs=1e-9)


def test_windows_and_grounds_keep_their_promises() -> None:
    """A sky of the upper hemisphere: the least window leaves nothing negative, a ground halves what any other leaves."""
    bands = (3, 4, 7, 10)
    degrees, orders = sphere.Harmonics(10).degrees, sphere.Harmonics(10).orders
    sky = np.where(orders == 0, sphere.cap(np.array([np.pi / 2]), 10)[0][degrees], 0)[np.newaxis]
    found = measure(sky, ones(1), bands)
    assert found.windows[-2] == LEAST
    assert found.undershoot[:, -2].max() < 1e-12
    assert (found.undershoot[0, 0] > 0.03).all()
    # An even ground of albedo a takes the same share of the jump at the horizon, and adds light.
    lit = list(GROUNDS).index(f"ground of albedo {ALBEDO:g}")
    expected = np.maximum((1 - ALBEDO) * found.undershoot[0, 0] - ALBEDO, 0)
    assert found.undershoot[lit, 0] == pytest.approx(expected, abs=1e-12)
    assert found.peak[0, 0] == pytest.approx(found.undershoot[0, 0], abs=0.02)
