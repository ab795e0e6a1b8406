"""What several golden tests share: directions, quadratures and a basis that owe nothing to the package."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray
from scipy import special

Array = NDArray[np.float64]


def upper(count: int, seed: int = 20) -> Array:
    """Unit vectors of the upper hemisphere, ``(count, 3)``."""
    drawn = np.random.default_rng(seed).normal(size=(count, 3))
    drawn[:, 2] = np.abs(drawn[:, 2]) + 0.02
    return np.asarray(drawn / np.linalg.norm(drawn, axis=1, keepdims=True))


def towards(zenith: float, azimuth: float = 0.0) -> Array:
    """The unit vector at a zenith angle and an azimuth, radians."""
    return np.array(
        [math.sin(zenith) * math.cos(azimuth), math.sin(zenith) * math.sin(azimuth), math.cos(zenith)],
    )


def angle(one: Array, other: Array) -> float:
    """The angle between two unit vectors by half chords (Kahan), radians."""
    return 2.0 * math.atan2(float(np.linalg.norm(one - other)), float(np.linalg.norm(one + other)))


def basis(directions: Array, bands: int) -> Array:
    """The real orthonormal basis without Condon and Shortley's sign, ``(n, N*N)``, from SciPy's complex one.

    SciPy 1.17, ``sph_harm_y``: with that sign; ``(Y_l^m + (-1)^m Y_l^-m) / sqrt 2`` and its sine are the real ones.
    """
    theta = np.arctan2(np.hypot(directions[:, 0], directions[:, 1]), directions[:, 2])
    phi = np.arctan2(directions[:, 1], directions[:, 0])
    columns = []
    for l in range(bands):
        for m in range(-l, l + 1):
            y = special.sph_harm_y(l, abs(m), theta, phi) * (-1.0) ** m
            columns.append(y.real if m == 0 else math.sqrt(2.0) * (y.real if m > 0 else y.imag))
    return np.stack(columns, axis=-1)


def degrees(bands: int) -> NDArray[np.int64]:
    """The degree of each weight, ``(N*N,)``."""
    return np.repeat(np.arange(bands), 2 * np.arange(bands) + 1)


def orders(bands: int) -> NDArray[np.int64]:
    """The order of each weight, ``(N*N,)``."""
    return np.concatenate([np.arange(-l, l + 1) for l in range(bands)])


def gauss(low: float, high: float, count: int) -> tuple[Array, Array]:
    """Gauss and Legendre's nodes and weights between two numbers."""
    x, w = special.roots_legendre(count)
    return low + (high - low) * (x + 1) / 2, w * (high - low) / 2


def hemisphere(count: int, *, lower: bool = False) -> tuple[Array, Array]:
    """Directions and solid angles of a hemisphere: Gauss in z**(1/2), dense at the horizon, even azimuths."""
    root, share = gauss(0.0, 1.0, count)
    z, solid = root**2, 2 * root * share
    phi = (np.arange(2 * count) + 0.5) * np.pi / count
    flat = np.sqrt(1 - z * z)[:, np.newaxis]
    sign = -1.0 if lower else 1.0
    where = np.stack(np.broadcast_arrays(flat * np.cos(phi), flat * np.sin(phi), sign * z[:, np.newaxis]), axis=-1)
    return where.reshape(-1, 3), np.repeat(solid * np.pi / count, 2 * count)


def lobe(bands: int) -> Array:
    """A clamped cosine's factors of each degree, by quadrature of ``2 pi max(z, 0) P_l(z)``."""
    z, w = gauss(0.0, 1.0, bands + 2)
    return np.array([2 * np.pi * float((w * z * special.eval_legendre(l, z)).sum()) for l in range(bands)])


def sinc(x: Array) -> Array:
    """``sin x / x``, 1 at 0, from SciPy's spherical Bessel function of order 0."""
    return np.asarray(special.spherical_jn(0, x))


# Rec. 709 primaries and the D65 white that the matrix's seven digits belong to: ITU-R BT.709, ASTM E308 white.
REC709 = np.array([[0.64, 0.33], [0.30, 0.60], [0.15, 0.06]])
WHITE = np.array([0.95047, 1.0, 1.08883])


def xyz_to_rgb(primaries: Array, white: Array) -> Array:
    """The matrix from XYZ to linear RGB of given primaries ``(3, 2)`` and white, as SMPTE RP 177 (1993) derives it."""
    x, y = primaries.T
    columns = np.stack([x / y, np.ones(3), (1 - x - y) / y])
    return np.linalg.inv(columns * np.linalg.solve(columns, white))


# Preetham, Shirley and Smits 1999, appendix A.2: slope and offset in turbidity of A..E, and zenith chromaticity (rows
# tau^2, tau, 1; columns theta^3 .. 1). `smits`: the five digits of the authors' released code.
PREETHAM = {
    "published": {
        "Y": ("A 0.1787 -1.4630", "B -0.3554 0.4275", "C -0.0227 5.3251", "D 0.1206 -2.5771", "E -0.0670 0.3703"),
        "x": ("A -0.0193 -0.2592", "B -0.0665 0.0008", "C -0.0004 0.2125", "D -0.0641 -0.8989", "E -0.0033 0.0452"),
        "y": ("A -0.0167 -0.2608", "B -0.0950 0.0092", "C -0.0079 0.2102", "D -0.0441 -1.6537", "E -0.0109 0.0529"),
    },
    "smits": {
        "Y": ("A 0.17872 -1.46303", "B -0.35540 0.42749", "C -0.02266 5.32505", "D 0.12064 -2.57705", "E -0.06696 0.37027"),
        "x": (
            "A -0.01925 -0.25922",
            "B -0.06651 0.00081",
            "C -0.00041 0.21247",
            "D -0.06409 -0.89887",
            "E -0.00325 0.04517",
        ),
        "y": (
            "A -0.01669 -0.26078",
            "B -0.09495 0.00921",
            "C -0.00792 0.21023",
            "D -0.04405 -1.65369",
            "E -0.01092 0.05291",
        ),
    },
}
PREETHAM_ZENITH = {
    "published": {
        "x": "166 -375 209 0 -2903 6377 -3202 394 11693 -21196 6052 25886",
        "y": "275 -610 317 0 -4214 8970 -4153 516 15346 -26756 6670 26688",
    },
    "smits": {
        "x": "165 -374 208 0 -2902 6377 -3202 394 11693 -21196 6052 25885",
        "y": "275 -610 316 0 -4214 8970 -4153 515 15346 -26756 6669 26688",
    },
}


def preetham_shape(constants: str, which: str, tau: float) -> tuple[float, ...]:
    """A..E of luminance or of a chromaticity at a turbidity."""
    rows = (row.split()[1:] for row in PREETHAM[constants][which])
    return tuple(float(slope) * tau + float(offset) for slope, offset in rows)


def preetham_zenith(constants: str, which: str, theta: float, tau: float) -> float:
    """Luminance of the zenith in cd/m2, or its chromaticity."""
    if which == "Y":
        chi = (4 / 9 - tau / 120) * (math.pi - 2 * theta)
        return 1000 * ((4.0453 * tau - 4.9710) * math.tan(chi) - 0.2155 * tau + 2.4192)
    rows = np.array(PREETHAM_ZENITH[constants][which].split(), dtype=float).reshape(3, 4) * 1e-5
    return float(np.polyval([np.polyval(row, theta) for row in rows], tau))


def perez_function(shape: tuple[float, ...], zenith: Array | float, gamma: Array | float) -> Array:
    """Perez's five-parameter function (1999 paper, eq. 3)."""
    a, b, c, d, e = shape
    with np.errstate(over="ignore"):
        return np.asarray((1 + a * np.exp(b / np.cos(zenith))) * (1 + c * np.exp(d * gamma) + e * np.cos(gamma) ** 2))


def preetham_xyz(constants: str, directions: Array, theta: float, tau: float) -> Array:
    """The Preetham sky's XYZ in cd/m2, ``(n, 3)``, sun at azimuth 0."""
    zenith = np.arctan2(np.hypot(directions[:, 0], directions[:, 1]), directions[:, 2])
    sun = towards(theta)
    gamma = 2 * np.arctan2(np.linalg.norm(directions - sun, axis=1), np.linalg.norm(directions + sun, axis=1))
    found = {}
    for which in "Yxy":
        shape = preetham_shape(constants, which, tau)
        found[which] = preetham_zenith(constants, which, theta, tau) * perez_function(shape, zenith, gamma)
        found[which] = found[which] / perez_function(shape, 0.0, theta)
    x, y, luminance = found["x"], found["y"], found["Y"]
    return np.stack([luminance * x / y, luminance, luminance * (1 - x - y) / y], axis=-1)
