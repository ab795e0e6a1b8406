"""Skies that hang on the sun by the angle to it alone: their weights are sin^m times even functions of its zenith angle."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from skylight_sh.fit.axis import Axis
from skylight_sh.light.cie_general import CieGeneral
from skylight_sh.light.preetham import Preetham
from skylight_sh.light.protocol import Hints, LightError, Parameters
from skylight_sh.light.wrappers import Fixed, Luminance
from skylight_sh.table import parity
from skylight_sh.table.prefactor import closed_form
from skylight_sh.table.short_numbers import bytes_of_numbers, short

Array = NDArray[np.float64]

AXES = (Axis("sun_zenith", 0.0, np.pi / 2).specified, Axis("turbidity", 1.7, 10.0).specified)
NAMES = ("sun_zenith", "turbidity")


@pytest.mark.parametrize("turbidity", [1.8, 2.5, 6.0, 10.0])
def test_preetham_has_three_classes_of_even_functions(turbidity: float) -> None:
    for light in (Preetham(), Preetham(constants="smits"), Luminance(Preetham())):
        hint = light.hints.classes or light.hints.prefactor
        assert hint is not None
        assert parity.residual(light, NAMES, [0.7, turbidity], "sun_zenith", closed_form(hint, AXES)) < 2e-6


@pytest.mark.parametrize("sky", range(1, 16))
def test_cie_general_skies_are_even(sky: Any) -> None:
    light = CieGeneral(sky)
    hint = light.hints.prefactor
    scale = closed_form(hint, AXES[:1]) if hint else None
    assert parity.residual(light, NAMES[:1], [0.7], "sun_zenith", scale) < 2e-8


def test_one_factor_is_not_enough_for_the_colours_of_preetham() -> None:
    light = Preetham()
    assert light.hints.prefactor is not None
    scale = closed_form(light.hints.prefactor, AXES)
    assert parity.residual(light, NAMES, [0.7, 4.0], "sun_zenith", scale) > 1e-3
    with pytest.raises(LightError, match=r"tells of parity, but .* leave .* another map than even"):
        parity.check(light, NAMES, [0.7, 4.0], "sun_zenith", scale)


def test_a_light_that_claims_too_much_is_refused() -> None:
    """A sky whose zenith brightens in proportion to the sun's zenith angle, an odd function."""

    class Brightening(Fixed):
        @property
        def hints(self) -> Hints:
            return replace(super().hints, parity=True)

        def radiance(self, directions: Array, parameters: Parameters) -> Array:
            brighter = 1.5 + parameters["sun_zenith"] * directions[..., 2]
            return super().radiance(directions, parameters) * brighter[..., np.newaxis]

    light = Brightening(CieGeneral(sky=8), ())
    hint = light.hints.prefactor
    assert hint is not None
    with pytest.raises(LightError, match="Mend its hints"):
        parity.check(light, NAMES[:1], [0.7], "sun_zenith", closed_form(hint, AXES[:1]))


def test_numbers_of_few_digits_take_two_bytes() -> None:
    assert short(5.3251) == (53251, 4)
    assert short(6.5536) is None
    assert short(-65535.0) == (-65535, 0)
    assert bytes_of_numbers([5.3251, -0.1787, 0.26688, 1 / 3]) == 3 * 2 + 2 * 4 + 4
