"""Numbers that engines publish: their constants, signs, axes and quantities, weight by weight."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.typing import NDArray
from skylight_sh.export.engines import HALF_MAX, PROFILES, convert, parse_axes

from golden.oracles import basis, degrees, lobe, orders

Array = NDArray[np.float64]

# Constants of the real basis of three bands: Sloan 2008, appendix A2; Filament's cmgen and Unity's
# SphericalHarmonicsL2 store weights times A_l / pi times these.
BASIS = np.array([0.282095, 0.488603, 0.488603, 0.488603, 1.092548, 1.092548, 0.315392, 1.092548, 0.546274])
COSINE = np.array([1.0, 2 / 3, 2 / 3, 2 / 3, 1 / 4, 1 / 4, 1 / 4, 1 / 4, 1 / 4])
# Products as cmgen's own source names them: 0.282095, 0.325735, 0.273137, 0.078848, 0.136569.
SCALED = np.array([0.282095, 0.325735, 0.325735, 0.325735, 0.273137, 0.273137, 0.078848, 0.273137, 0.136569])

# Where east, north and up go, and what is stored, as each engine documents it: y up and right-handed (Filament, Godot,
# three.js, glTF), y up and left-handed (Unity, Babylon.js), z up and left-handed (Unreal Engine).
Y_UP_RIGHT = np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]])
Y_UP_LEFT = np.array([[1, 0, 0], [0, 0, 1], [0, 1, 0]])
Z_UP_LEFT = np.diag([1, -1, 1])
CS = (-1.0) ** orders(3)
EXPECTED = {
    "filament": (Y_UP_RIGHT, SCALED),
    "filament-radiance": (Y_UP_RIGHT, CS),
    "unity": (Y_UP_LEFT, SCALED),
    "unreal": (Z_UP_LEFT, CS),
    "godot": (Y_UP_RIGHT, np.full(9, 1 / math.pi)),
    "threejs": (Y_UP_RIGHT, np.ones(9)),
    "directxmath": (np.eye(3), CS),
    "babylonjs": (Y_UP_LEFT, CS * COSINE),
    "gltf": (Y_UP_RIGHT, CS * COSINE * math.pi),
}


def test_constants_are_products() -> None:
    assert pytest.approx(SCALED, abs=2e-6) == BASIS * COSINE
    assert lobe(3)[degrees(3)] / math.pi == pytest.approx(COSINE, rel=1e-12)
    assert float(np.finfo(np.float16).max) == HALF_MAX
    assert set(PROFILES) == set(EXPECTED)


@pytest.mark.parametrize("name", EXPECTED)
def test_every_weight_of_an_engine(name: str) -> None:
    """A light of three bands, seen in the engine's axes by its own polynomials, times what it stores."""
    matrix, factors = EXPECTED[name]
    profile = PROFILES[name]
    assert parse_axes(profile.axes).tolist() == matrix.tolist()
    weights = np.random.default_rng(61).normal(size=(3, 9))
    # The same environment in the engine's axes, by least squares over directions.
    where = np.random.default_rng(62).normal(size=(60, 3))
    where /= np.linalg.norm(where, axis=1, keepdims=True)
    there = np.linalg.lstsq(basis(where @ matrix.T, 3), basis(where, 3) @ weights.T, rcond=None)[0].T
    got = convert(weights, profile, exposure=0.5)
    assert got == pytest.approx(0.5 * there * factors, abs=1e-5)
    # To many digits where the factor is no printed constant.
    exact = np.array([math.sqrt(v / (4 * math.pi)) for v in (1, 3, 3, 3, 15, 15, 5 / 4, 15, 15 / 4)]) * COSINE
    if factors is SCALED:
        assert got == pytest.approx(0.5 * there * exact, abs=1e-12)
    else:
        assert got == pytest.approx(0.5 * there * factors, abs=1e-12)


def test_bands_that_engines_take() -> None:
    """Nine weights everywhere; cmgen writes one to three bands, XMSH takes orders 2 to 6 (XMSH_MINORDER, XMSH_MAXORDER)."""
    found = {name: profile.bands for name, profile in PROFILES.items()}
    assert found["filament"] == found["filament-radiance"] == (1, 3)
    assert found["directxmath"] == (2, 6)
    assert {found[n] for n in ("unity", "unreal", "godot", "threejs", "babylonjs", "gltf")} == {(3, 3)}
