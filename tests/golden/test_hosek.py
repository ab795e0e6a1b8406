"""The Hosek-Wilkie sky: Mitsuba's own emitter, its normalisation and the photometric constant."""

from __future__ import annotations

import math

import colour as colour_science
import mitsuba
import numpy as np
import pytest
from skylight_sh.light.mitsuba_sunsky import MitsubaSunsky

from golden.oracles import towards, upper

# lm/W at the peak of V(lambda): 683 at 540 THz, 555.016 nm in air (CIE 15:2004); colour-science: 683 for the frequency.
PEAK = 683.002


def emitter(theta: float, turbidity: float, albedo: float, where: np.ndarray) -> np.ndarray:
    before = mitsuba.variant()
    mitsuba.set_variant("scalar_rgb")
    try:
        made = mitsuba.load_dict(
            {
                "type": "sunsky",
                "sun_scale": 0.0,
                "turbidity": turbidity,
                "albedo": albedo,
                "sun_direction": towards(theta).tolist(),
            }
        )
        looked = mitsuba.SurfaceInteraction3f()
        out = []
        for direction in where:
            looked.wi = (-direction).tolist()
            out.append(np.array(made.eval(looked)).ravel())
    finally:
        if before not in (None, "scalar_rgb"):
            mitsuba.set_variant(before)
    return np.array(out) / mitsuba.MI_CIE_Y_NORMALIZATION * PEAK


@pytest.mark.parametrize(
    ("theta", "turbidity", "albedo"), [(0.0, 1.0, 0.0), (0.5, 3.0, 0.3), (1.1, 4.6, 1.0), (1.4, 9.3, 0.7)]
)
def test_the_emitter_in_candelas(theta: float, turbidity: float, albedo: float) -> None:
    where = np.concatenate([upper(25, seed=9), [[0.0, 0.0, 1.0], [math.sqrt(1 - 1e-6), 0.0, 1e-3]]])
    at = {"sun_zenith": np.array(theta), "turbidity": np.array(turbidity), "albedo": np.array(albedo)}
    got, expected = MitsubaSunsky().radiance(where, at), emitter(theta, turbidity, albedo, where)
    assert np.abs(got - expected).max() < 1e-5 * np.abs(expected).max()
    assert got == pytest.approx(expected, rel=1e-4)


def test_constants_by_other_hands() -> None:
    """The integral of ybar over Mitsuba's range; CIE 1931 by colour-science, every nanometre from 360 to 830."""
    ybar = colour_science.MSDS_CMFS["CIE 1931 2 Degree Standard Observer"]
    total = sum(float(ybar[float(nm)][1]) for nm in range(360, 831))
    mitsuba.set_variant("scalar_rgb")
    assert pytest.approx(total, rel=1.1e-3) == 1 / mitsuba.MI_CIE_Y_NORMALIZATION
    assert pytest.approx(PEAK, rel=1e-5) == colour_science.constants.CONSTANT_K_M


def test_a_clear_zenith_is_as_bright_as_measured() -> None:
    """Hosek and Wilkie 2012: clear skies of turbidity 2 to 4 have a zenith of 2 to 7 kcd/m2 with the sun 45 degrees high."""
    at = {"sun_zenith": np.array(math.pi / 4), "turbidity": np.array(3.0), "albedo": np.array(0.2)}
    light = MitsubaSunsky()
    assert 2_000 < float(light.radiance(np.array([0.0, 0.0, 1.0]), at) @ light.luminance_row) < 7_000


def test_its_domains_are_its_datas() -> None:
    """Ten turbidities from 1 to 10, two albedos, elevations 0 to 90 degrees (Hosek and Wilkie 2012, section 5)."""
    domains = MitsubaSunsky().domains
    assert {name: (d.low, d.high) for name, d in domains.items()} == {
        "sun_zenith": (0.0, math.pi / 2),
        "turbidity": (1.0, 10.0),
        "albedo": (0.0, 1.0),
    }
