"""The SH basis to l = 200: orthonormality, and its recurrence against mpmath and an independent library."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from skylight_sh import sphere
from skylight_sh.studies import outcomes
from skylight_sh.studies.page import Row, Section

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_DEGREES = (5, 10, 20, 50, 100, 150, 200)
_SPHERICART = 85
_ANGLES = (1e-9, 1e-3, 0.3, 1.0, 1.5, float(np.pi / 2), 3.0, float(np.pi) - 1e-9)
TEXT = (
    "Orthonormality: the largest entry of the Gram matrix minus one, by Gauss quadrature that is exact for these "
    "degrees. Against mpmath: closed-form sums in 250 digits at eight zenith angles, poles and horizon included, "
    "eleven orders a degree. Against SciPy and sphericart: 500 random directions, every order (sphericart itself "
    "overflows above l = 85). All relative to the largest value of the degree; the dotted line is how the error of a "
    "stable recurrence grows, and one that is lost leaves it for good."
)


def section() -> Section:
    """Measure every degree."""
    rows = [
        {
            "l": l,
            "orthonormal": _gram(l),
            "against mpmath": _exact(l),
            "against SciPy": _scipy(l),
            "against sphericart": _sphericart(l) if l <= _SPHERICART else None,
            "1e-16 l": 1e-16 * l,
        }
        for l in _DEGREES
    ]
    return Section("harmonics", "The SH basis to l = 200", TEXT, rows, _draw, outcomes.harmonics(rows))


def _gram(l: int) -> float:
    """Largest departure from orthonormality among all degrees up to ``l`` of equal order."""
    x, w = sphere.gauss(l + 1)
    rings = sphere.legendre(x, np.sqrt((1 - x) * (1 + x)), l + 1)
    orders = sphere.Harmonics.even(l + 1).orders
    worst = 0.0
    for m in range(0, l + 1, max(1, l // 20)):
        rows = rings[orders == m]
        gram = (rows * w) @ rows.T * (2 * np.pi if m == 0 else np.pi)
        worst = max(worst, float(np.abs(gram - np.eye(len(gram))).max()))
    return worst


def _exact(l: int) -> float:
    """Largest error of degree ``l`` against closed-form sums, relative to the degree's largest value at that angle."""
    import mpmath

    orders = sorted({round(l * k / 10) for k in range(11)})
    worst = 0.0
    for theta in _ANGLES:
        got = sphere.legendre(np.array(math.cos(theta)), np.array(math.sin(theta)), l + 1)
        start = l * (l + 1) // 2
        with mpmath.workdps(250):
            # The basis is given the rounded cosine and sine; so is the closed form.
            x, sine = mpmath.mpf(math.cos(theta)), mpmath.mpf(math.sin(theta))
            exact = [_closed_form(l, m, x, sine) for m in orders]
        scale = float(np.abs(got[start:]).max())
        worst = max(worst, *(abs(float(e) - float(got[start + m])) / scale for e, m in zip(exact, orders, strict=True)))
    return worst


def _closed_form(l: int, m: int, x: Any, sine: Any) -> Any:
    """Normalised associated Legendre factor by the derivative of Rodrigues' sum."""
    import mpmath

    two = 1 if m == 0 else 2
    norm = mpmath.sqrt(two * (2 * l + 1) / (4 * mpmath.pi) * mpmath.factorial(l - m) / mpmath.factorial(l + m))
    total = mpmath.fsum(
        (-1) ** k * math.comb(l, k) * math.comb(2 * l - 2 * k, l) * math.perm(l - 2 * k, m) * mpmath.power(x, l - 2 * k - m)
        for k in range((l - m) // 2 + 1)
    )
    return norm * mpmath.power(sine, m) * total / mpmath.mpf(2) ** l


def _directions() -> np.ndarray:
    where = np.random.default_rng(3).normal(size=(500, 3))
    return np.asarray(where / np.linalg.norm(where, axis=1, keepdims=True))


def _scipy(l: int) -> float:
    from scipy.special import sph_harm_y

    where = _directions()
    m = np.arange(l + 1)
    theta, phi = np.arctan2(np.hypot(where[:, 0], where[:, 1]), where[:, 2]), np.arctan2(where[:, 1], where[:, 0])
    # SciPy's are complex, with the Condon-Shortley sign.
    theirs = sph_harm_y(l, m, theta[:, np.newaxis], phi[:, np.newaxis]) * (-1.0) ** m * np.where(m == 0, 1.0, np.sqrt(2.0))
    ours = sphere.basis(where, l + 1)[:, l * l :]
    cosines, sines = ours[:, l + m], ours[:, l - m[1:]]
    worst = max(np.abs(theirs.real - cosines).max(), np.abs(theirs.imag[:, 1:] - sines).max())
    return float(worst / np.abs(ours).max())


def _sphericart(l: int) -> float:
    import sphericart

    where = _directions()
    theirs = sphericart.SphericalHarmonics(l).compute(where)[:, l * l :]
    ours = sphere.basis(where, l + 1)[:, l * l :]
    return float(np.abs(theirs - ours).max() / np.abs(theirs).max())


def _draw(rows: Sequence[Row]) -> Figure:
    from skylight_sh.report import style

    figure = style.figure(style.WIDTH, 5.2)
    axes = figure.subplots()
    degrees = [int(str(row["l"])) for row in rows]
    for i, key in enumerate(("orthonormal", "against mpmath", "against SciPy", "against sphericart")):
        known = [(row["l"], row[key]) for row in rows if row[key] is not None]
        axes.loglog(*zip(*known, strict=True), label=key, **style.look(i))
    axes.loglog(degrees, [row["1e-16 l"] for row in rows], ":", color=style.BLACK, label="1e-16 l")
    axes.set_xlabel("degree l")
    axes.set_ylabel("relative error")
    axes.set_xticks([5, 10, 20, 50, 100, 200], ["5", "10", "20", "50", "100", "200"])
    axes.set_xticks([], minor=True)
    style.decades(axes.yaxis)
    axes.grid(True, which="major", alpha=0.3)
    figure.legend(*axes.get_legend_handles_labels(), loc="outside lower center", ncols=2, fontsize=11, frameon=False)
    return figure
