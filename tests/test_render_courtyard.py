"""The courtyard by transfer against the same picture by paths: what is left of the light, and what would be lost."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from skylight_sh import runtime, sphere
from skylight_sh.light import sun_disc
from skylight_sh.light.preetham import Preetham
from skylight_sh.mesh.courtyard import ENTRANCE, MORNING, courtyard
from skylight_sh.mesh.texels import averaged
from skylight_sh.quadrature import sampling
from skylight_sh.render import metrics, tone
from skylight_sh.render.brute_force import Paths
from skylight_sh.render.camera import Camera
from skylight_sh.render.emitters import Disc
from skylight_sh.render.picture import Picture, Sampling
from skylight_sh.render.scene import Light, Scene, Surroundings, by_paths, through_transfer, without_shadows
from skylight_sh.render.sky import Sky
from skylight_sh.render.surface import Surface
from skylight_sh.sphere import Harmonics
from skylight_sh.transfer import Options, precompute
from skylight_sh.transfer.start_points import healing

Array = NDArray[np.float64]

_BANDS, _BOUNCES = 5, 3
_TABLES = Path(__file__).parents[1] / "reports" / "reference" / "export"
_CAMERA = Camera(ENTRANCE.eye, ENTRANCE.target, ENTRANCE.field, 48, 27)
_FINE = Sampling(pixel=2, shadow=4)


@dataclass(frozen=True)
class Evening:
    """A low sun over the courtyard: true weights and a table's, black below the horizon, and the picture by paths, twice."""

    scene: Scene
    bare: Array
    sky: Sky
    true: Array
    table: Array
    small: Array
    disc: Disc
    paths: tuple[Picture, Picture]

    def light(self, weights: Array, *, mirrored: bool = True, sun: bool = True) -> Light:
        below = sphere.mirror_ground(weights, sphere.bands_of(weights)) if mirrored else weights
        return Light(below, self.sky.radiance, (self.disc,) if sun else (), np.zeros(3))

    def through(self, light: Light) -> Array:
        return through_transfer(self.scene, light, _CAMERA, _FINE).radiance

    def error(self, picture: Array) -> float:
        """Return the relative RMSE on surfaces, the paths' noise left out."""
        shown = self.paths[0].share == 1.0
        one, other = (found.radiance[shown] for found in self.paths)
        return metrics.relative_rmse_of_halves(picture[shown], one, other)


@pytest.fixture(scope="module")
def evening() -> Evening:
    theta, azimuth, tau = np.radians(90.0 - MORNING.height), np.radians(MORNING.azimuth), MORNING.turbidity
    mesh = courtyard()
    surface, found = Surface(mesh), precompute(mesh, Options(_BANDS, 96, 48, _BOUNCES))
    between = Surroundings(found.start.points, healing(mesh, found.start.buried), found.matrix, _BOUNCES)
    scene = Scene(surface, averaged(mesh).albedo, found.transfer, between)
    harmonics = Harmonics(_BANDS)
    job = sampling.Job(Preetham(), ("sun_zenith", "turbidity"), np.array([[[theta, tau]]]), 64, harmonics, "sun-centred")
    true = runtime.rotate_azimuth(sampling.project_block(job).weights[0, 0], np.array(azimuth))
    known = {"sun_zenith": theta, "sun_azimuth": azimuth, "turbidity": tau}
    tables = (runtime.load(_TABLES / f"{name}skylight_sh.npz") for name in ("", "4-bands-1.5pct-packed/"))
    table, small = (np.asarray(one.weights(**known), dtype=np.float64) for one in tables)
    towards = np.array([np.sin(theta) * np.cos(azimuth), np.sin(theta) * np.sin(azimuth), np.cos(theta)])
    disc = Disc(towards, sun_disc.HALF_ANGLE, sun_disc.radiance(theta, tau))
    sky = Sky(Preetham(), {"sun_zenith": theta, "turbidity": tau}, azimuth, below="mirror")
    light = Light(np.zeros((3, 1)), sky.radiance, (disc,), np.zeros(3))
    one, other = (by_paths(surface, light, _CAMERA, _FINE, Paths(32, _BOUNCES, seed)) for seed in (1, 2))
    return Evening(scene, found.direct, sky, true, table[:, : _BANDS**2], small, disc, (one, other))


def test_sky_and_sun_are_those_of_paths(evening: Evening) -> None:
    picture = evening.through(evening.light(evening.table))
    assert evening.error(picture) < 0.035
    # The paths' own noise counts here.
    true = 0.5 * (evening.paths[0].radiance + evening.paths[1].radiance)
    lux = float(evening.sky.falling() @ tone.LUMINANCE)
    shown = [tone.display(one, tone.exposure(lux)) for one in (picture, true)]
    assert metrics.flip(shown[0], shown[1]) < 0.06


def test_a_sky_without_an_edge_needs_fewer_bands(evening: Evening) -> None:
    """Below the horizon nothing shows but ground: a mirrored sky is the same light."""
    black, mirrored = (
        evening.error(evening.through(evening.light(evening.true, mirrored=mirrored))) for mirrored in (False, True)
    )
    assert mirrored < 0.6 * black


def test_the_tables_share_is_small(evening: Evening) -> None:
    for table, bands, most in ((evening.table, 5, 1e-4), (evening.small, 4, 1e-3)):
        true = evening.true[:, : bands * bands]
        by_truth, by_table = (evening.through(evening.light(w, sun=False)) for w in (true, table))
        assert 0.0 < metrics.relative_rmse(by_table, by_truth) < most


def test_what_shadows_and_bounces_are_worth(evening: Evening) -> None:
    light = evening.light(evening.table)
    bare = Scene(
        evening.scene.surface,
        evening.scene.albedo,
        np.repeat(evening.bare[:, np.newaxis], 3, axis=1),
        Surroundings(evening.scene.between.starts, evening.scene.between.heal, evening.scene.between.gather, 0),
    )
    assert evening.error(through_transfer(bare, light, _CAMERA, _FINE).radiance) > 0.15
    black = evening.light(evening.table, mirrored=False)
    assert evening.error(without_shadows(evening.scene.surface, black, _CAMERA, _FINE, None).radiance) > 0.40
