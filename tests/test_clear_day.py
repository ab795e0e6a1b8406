"""Sky, sun and ground from one config: what the sun adds, what the ground reflects, and how bright a clear day is."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from conftest import ONE_LAYOUT, SMALL, run_quietly, scene_config
from numpy.typing import NDArray
from skylight_sh import runtime, sphere
from skylight_sh.config import ConfigError
from skylight_sh.light import sun_disc
from skylight_sh.light.preetham import Preetham
from skylight_sh.quadrature import sampling
from skylight_sh.scene.fold import Scene, Sun, fold

Array = NDArray[np.float64]
SUNLIT = Scene(("sun_zenith", "turbidity"), sun=Sun("sun_zenith", "turbidity"))


def brute_force(theta: float, tau: float) -> Array:
    """Irradiance on the horizontal in linear RGB: a million directions of the sky, and as many of the disc."""
    x, areas = np.polynomial.legendre.leggauss(700)
    phi = (np.arange(1400) + 0.5) * math.pi / 1400
    # Squared, for the sky's edge at the horizon.
    z, areas = ((x + 1) / 2) ** 2, (x + 1) / 2 * areas
    flat = np.sqrt(1 - z * z)[:, np.newaxis]
    where = np.stack(np.broadcast_arrays(flat * np.cos(phi), flat * np.sin(phi), z[:, np.newaxis]), axis=-1)
    sky = Preetham().radiance(where, {"sun_zenith": np.array(theta), "turbidity": np.array(tau)})
    diffuse = 2 * math.pi / 1400 * np.einsum("ijc,i,i->c", sky, z, areas)
    angle = (np.arange(1000) + 0.5) * sun_disc.HALF_ANGLE / 1000
    turn = (np.arange(1000) + 0.5) * 2 * math.pi / 1000
    height = math.cos(theta) * np.cos(angle)[:, np.newaxis] + math.sin(theta) * np.outer(np.sin(angle), np.cos(turn))
    beam = (
        float((np.maximum(height, 0.0) * np.sin(angle)[:, np.newaxis]).sum())
        * sun_disc.HALF_ANGLE
        / 1000
        * 2
        * math.pi
        / 1000
    )
    return np.asarray(diffuse + beam * sun_disc.radiance(theta, tau))


@pytest.mark.parametrize(
    ("theta", "tau"), [(0.0, 2.5), (0.7, 3.0), (1.3, 6.0), (math.radians(89.9), 2.5), (math.pi / 2, 2.5), (math.pi / 2, 6.0)]
)
def test_the_ground_reflects_what_sky_and_sun_send_down(theta: float, tau: float) -> None:
    """Albedo / pi times the irradiance by brute force, to a millionth."""
    albedo = (0.1, 0.2, 0.3)
    sets = np.array([[[theta, tau]]])
    job = sampling.Job(Preetham(), ("sun_zenith", "turbidity"), sets, 160, sphere.Harmonics.even(4), rule="sun-centred")
    sky, degrees = sampling.project_block(job).weights[0], sphere.Harmonics.even(4).degrees
    lit = fold(replace(SUNLIT, ground=albedo), sky, degrees, sets[0])[0]
    unlit = fold(SUNLIT, sky, degrees, sets[0])[0]
    radiance = (lit - unlit)[:, 0] / sphere.lower_hemisphere(1)[0]
    assert radiance == pytest.approx(np.array(albedo) / math.pi * brute_force(theta, tau), rel=1e-6)


def test_a_table_holds_sky_and_sun(tmp_path: Path) -> None:
    text = ONE_LAYOUT.replace("[0.05, 0.01]", "[0.05]").replace("4-bands-1pct", "4-bands-5pct")
    text = text.replace("degrees = [3, 9]", "degrees = [3, 20]")
    text = text.replace("nodes = 12\nverification = 37", "nodes = 24\nverification = 81")
    found = {}
    for disc in ("true", "false"):
        result = run_quietly(scene_config(f"sun_disc = {disc}", text.replace('"small"', f'"disc-{disc}"')), tmp_path)
        found[disc] = runtime.load(result.folder / "export" / "skylight_sh.npz")
        header = (result.folder / "export" / "skylight_sh.h").read_text(encoding="utf-8")
        assert ("0.2665 degrees" in header) == (disc == "true")
        assert found[disc].table.spec.sun_disc == (disc == "true")
    for theta, phi, tau in ((0.2, 0.5, 2.6), (0.9, 3.0, 5.9), (1.2, -2.0, 3.3)):
        added = found["true"].weights(theta, phi, tau).astype(np.float64) - found["false"].weights(theta, phi, tau)
        expected = sun_disc.weights(theta, phi, tau, 4)
        # Both tables err by up to 5 % of the sky's least luminance, some 100 cd/m2, in the sum of squares.
        assert np.abs(added - expected).max() < 200 < np.abs(expected).max() / 10


def test_one_channel_is_the_luminance_of_three() -> None:
    degrees, sets = sphere.Harmonics.even(4).degrees, np.array([[0.5, 3.0], [1.57, 5.0]])
    none = np.zeros((2, 3, degrees.size))
    luminance = replace(SUNLIT.sun, luminance_row=Preetham().luminance_row) if SUNLIT.sun else None
    one = fold(replace(SUNLIT, sun=luminance, ground=(0.3,)), none[:, :1], degrees, sets)
    three = fold(replace(SUNLIT, ground=(0.3, 0.3, 0.3)), none, degrees, sets)
    assert one[:, 0] == pytest.approx(np.einsum("ncw,c->nw", three, Preetham().luminance_row), rel=1e-12, abs=1e-6)


def test_only_the_preetham_sky_has_a_sun() -> None:
    text = (SMALL.parent / "small-cie.toml").read_text(encoding="utf-8")
    with pytest.raises(ConfigError, match=r"\$\.scene\.sun_disc = True.*preetham"):
        scene_config("sun_disc = true", text)
