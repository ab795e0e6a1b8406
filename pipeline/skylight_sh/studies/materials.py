"""``python -m skylight_sh.studies.materials``: how far lobes and tables of reflectance are from brute force.

The exact Preetham sky at turbidity 3 stands above an even ground, and its exact weights light the surface, so that what is
measured is the number of bands alone. Errors are relative RMS over directions and channels.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.light.preetham import Preetham
from skylight_sh.quadrature import sun_centred
from skylight_sh.reflectance import brute_force, glossy, lobes, tabulated
from skylight_sh.reflectance.models.ggx import Ggx

Array = NDArray[np.float64]

SUNS = (38.0, 80.0, 88.0)
TURBIDITY = 3.0
GROUND = 0.25
_MOST_BANDS = 10
_DIRECTIONS = 400
_NORMALS = 24
_NODES = 128


@dataclass(frozen=True)
class Lobe:
    """One row: the exponent of the cosine (infinite for a mirror), the bands, the ground's albedo, and a window or none."""

    exponent: float
    bands: int
    ground: float
    window: str = ""

    @property
    def factors(self) -> Array:
        """What is left of each degree, window included."""
        known = lobes.cosine_power(self.exponent, self.bands) if np.isfinite(self.exponent) else np.ones(self.bands)
        return known * sphere.hann_window(self.bands) if self.window else known

    @property
    def cells(self) -> list[str]:
        """The row's first cells."""
        name = f"cos^{self.exponent:g}" if np.isfinite(self.exponent) else "mirror"
        return [f"{name}, {self.window}" if self.window else name, str(self.bands), f"{self.ground:g}"]


LOBES = (
    *(Lobe(n, 7, GROUND) for n in (8, 16, 32, 64, np.inf)),
    *(Lobe(n, 10, GROUND) for n in (16, 32, 64, np.inf)),
    *(Lobe(n, 7, 0.0) for n in (8, 16)),
    Lobe(16, 7, GROUND, "Hann"),
    Lobe(32, 7, GROUND, "Hann"),
)
ALPHAS = (0.5, 0.25, 0.1)
BANDS = (5, 7, 10)
VIEWS = (0.0, 30.0, 50.0, 60.0, 70.0, 80.0)


def environment(sun: float, ground: float = GROUND, nodes: int = _NODES) -> tuple[Array, brute_force.Environment]:
    """Return the exact weights ``(3, 100)`` of a sky, sun ``sun`` degrees from the zenith, above a ground, and its nodes."""
    at = {"sun_zenith": float(np.radians(sun)), "turbidity": TURBIDITY}
    spread = {name: np.array([[value]]) for name, value in at.items()}
    harmonics = sphere.Harmonics(_MOST_BANDS)
    weights = sun_centred.project(Preetham(), spread, nodes=_NODES, harmonics=harmonics).weights[0, 0]
    return sphere.add_ground(weights, ground, _MOST_BANDS), brute_force.environment(Preetham(), at, ground, nodes)


def glossy_error(lobe: Lobe, weights: Array, seen: brute_force.Environment) -> float:
    """Return a lobe's relative RMS over mirror directions all over the sphere."""
    reflected = sphere.spiral(_DIRECTIONS)
    sharp = not np.isfinite(lobe.exponent)
    exact = seen.radiance(reflected) if sharp else brute_force.cosine_lobe(seen, lobe.exponent, reflected)
    return brute_force.relative_rms(glossy.radiance(weights[:, : lobe.bands**2], lobe.factors, reflected), exact)


def views_at(zenith: float) -> tuple[Array, Array]:
    """Return normals all over the sphere, and a view of each ``zenith`` degrees from it, about it by the golden angle."""
    normals = sphere.spiral(_NORMALS)
    across = np.cross(normals, np.array([0.36, 0.48, 0.8]))
    across /= np.linalg.norm(across, axis=-1, keepdims=True)
    turn = np.pi * (1 + np.sqrt(5.0)) * np.arange(_NORMALS)[:, np.newaxis]
    along = np.cos(turn) * across + np.sin(turn) * np.cross(normals, across)
    return normals, np.cos(np.radians(zenith)) * normals + np.sin(np.radians(zenith)) * along


def view_errors(
    alpha: float, zenith: float, weights: Array, seen: brute_force.Environment, nodes: int = _NODES
) -> list[float]:
    """Return the relative RMS of a white GGX surface's tables of ``BANDS`` bands over normals all over the sphere."""
    model = Ggx(alpha, (1.0,))
    normals, views = views_at(zenith)
    exact = brute_force.reflected(model, seen.radiance, normals, views, nodes=nodes)
    tables = [tabulated.tabulate(model, bands) for bands in BANDS]
    found = [tabulated.shade(table, weights, normals, views) for table in tables]
    return [brute_force.relative_rms(one, exact) for one in found]


def per_cent(errors: Sequence[float]) -> list[str]:
    """Return cells."""
    return [f"{100 * error:.2g} %" for error in errors]


def main() -> None:
    """Print both tables' rows."""
    lit = {(sun, ground): environment(sun, ground) for sun in SUNS for ground in (GROUND, 0.0)}
    for lobe in LOBES:
        errors = [glossy_error(lobe, *lit[sun, lobe.ground]) for sun in SUNS]
        print("|", " | ".join([*lobe.cells, *per_cent(errors)]), "|")
    for alpha in ALPHAS:
        columns = [view_errors(alpha, zenith, *lit[SUNS[1], GROUND]) for zenith in VIEWS]
        for k, bands in enumerate(BANDS):
            print("|", " | ".join([f"{alpha:g}", str(bands), *per_cent([column[k] for column in columns])]), "|")


if __name__ == "__main__":
    main()
