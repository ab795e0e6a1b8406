"""The sun over the Preetham sky: a disc of half-angle 0.2665 degrees, dimmed by the atmosphere of the same turbidity.

Transmittance is the product of five attenuations (Preetham, Shirley and Smits 1999, appendix A.1, with the tables that it
takes from Iqbal 1983): Rayleigh scattering, Angstrom's aerosol, ozone, mixed gases and water vapour, over the relative
optical mass of Kasten 1965. Spectra are summed every 10 nm from 380 to 750 nm, where the solar table ends: the luminance is
within 0.06 % of a sum every nanometre up to a zenith angle of 80 degrees and 0.7 % on the horizon, the channels within
0.15 % and 5 % of the luminance there. The disc is uniform, without the limb's darkening, at the mean distance: the year
moves its illuminance by 3.4 % either way. A circumsolar glow is part of the sky, not of the disc.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from skylight_sh import sphere
from skylight_sh.light import colour

Array = NDArray[np.float64]

HALF_ANGLE = float(np.radians(0.2665))

WAVELENGTHS: Array = np.arange(380.0, 751.0, 10.0)
"""Nanometres."""


def _numbers(text: str) -> Array:
    return np.array(text.split(), dtype=np.float64)


SPECTRUM = _numbers(
    "16559 16233.7 21127.5 25888.2 25829.1 24232.3 26760.5 29658.3 30545.4 30057.5 30663.7 28830.4 28712.1 27825 "
    "27100.6 27233.6 26361.3 25503.8 25060.2 25311.6 25355.9 25134.2 24631.5 24173.2 23685.3 23212.1 22827.7 22339.8 "
    "21970.2 21526.7 21097.9 20728.3 20240.4 19870.8 19427.2 19072.4 18628.9 18259.2"
)
"""Radiance of the disc above the atmosphere at WAVELENGTHS, W / (m2 nm sr)."""

OBSERVER = np.stack(
    [
        _numbers(
            ".001368 .004243 .01431 .04351 .13438 .2839 .34828 .3362 .2908 .19536 .09564 .03201 .0049 .0093 .06327 "
            ".1655 .2904 .43345 .5945 .7621 .9163 1.0263 1.0622 1.0026 .85445 .6424 .4479 .2835 .1649 .0874 .04677 "
            ".0227 .0113592 .00579035 .00289933 .00143997 .000690079 .000332301"
        ),
        _numbers(
            ".000039 .00012 .000396 .00121 .004 .0116 .023 .038 .06 .09098 .13902 .20802 .323 .503 .71 .862 .954 "
            ".99495 .995 .952 .87 .757 .631 .503 .381 .265 .175 .107 .061 .032 .017 .00821 .004102 .002091 .001047 "
            ".00052 .0002492 .00012"
        ),
        _numbers(
            ".00645 .02005 .06785 .2074 .6456 1.3856 1.74706 1.77211 1.6692 1.28764 .81295 .46518 .272 .1582 .07825 "
            ".04216 .0203 .00875 .0039 .0021 .00165 .0011 .0008 .00034 .00019 .00005 .00002 0 0 0 0 0 0 0 0 0 0 0"
        ),
    ]
)
"""Colour-matching functions x, y and z of the CIE 1931 2 degree observer at WAVELENGTHS, ``(3, 38)``."""

_EFFICACY = 683.0  # lm/W

# Absorption: nanometres, and 1/cm of ozone, of mixed gases (no unit), of water vapour (1/cm).
_OZONE = (
    np.r_[300:360:5, 445:610:5, 610:800:10],
    _numbers(
        "10 4.8 2.7 1.35 .8 .38 .16 .075 .04 .019 .007 0 .003 .003 .004 .006 .008 .009 .012 .014 .017 .021 .025 .03 "
        ".035 .04 .045 .048 .057 .063 .07 .075 .08 .085 .095 .103 .11 .12 .122 .12 .118 .115 .12 .125 .13 .12 .105 "
        ".09 .079 .067 .057 .048 .036 .028 .023 .018 .014 .011 .01 .009 .007 .004 0 0"
    ),
)
_GASES = (np.array([759, 760, 770, 771]), _numbers("0 3 .21 0"))
_VAPOUR = (
    np.r_[689, 690:810:10],
    _numbers("0 .016 .024 .0125 1 .87 .061 .001 .00001 .00001 .0006 .0175 .036"),
)
_OZONE_CM, _VAPOUR_CM = 0.35, 2.0


def optical_mass(theta: ArrayLike) -> Array:
    """Return the air's mass towards zenith angle ``theta`` (radians) over that towards the zenith (Kasten 1965).

    >>> optical_mass([0.0, np.pi / 3]).round(2).tolist()
    [1.0, 1.99]
    """
    angle = np.asarray(theta, dtype=np.float64)
    return np.asarray(1.0 / (np.cos(angle) + 0.15 * (93.885 - np.degrees(angle)) ** -1.253))


def spectral_transmittance(theta: ArrayLike, tau: ArrayLike, wavelengths: Array = WAVELENGTHS) -> Array:
    """Return how much of a spectrum reaches the ground, ``(..., wavelengths)``, for 300 to 800 nm.

    ``theta`` (radians, 0 to pi / 2) and the turbidity ``tau`` (1 to 10, 1 being air without aerosol) broadcast to
    ``(...)``. Raises ValueError outside these ranges and for NaN.
    """
    zenith, turbidity = np.asarray(theta, dtype=np.float64), np.asarray(tau, dtype=np.float64)
    _within("sun zenith", zenith, 0.0, np.pi / 2, "radians from 0 to pi / 2: a sun above the horizon")
    _within("turbidity", turbidity, 1.0, 10.0, "from 1 (air without aerosol) to 10")
    mass = optical_mass(zenith)[..., np.newaxis]
    micro = wavelengths / 1000.0
    beta = np.maximum(0.04608 * turbidity - 0.04586, 0.0)[..., np.newaxis]
    still, gases, vapour = absorption(wavelengths)
    depth = still + beta * micro**-1.3
    lines = 1.41 * gases * mass / (1.0 + 118.93 * gases * mass) ** 0.45
    wet = vapour * mass
    return np.asarray(np.exp(-mass * depth - lines - 0.2385 * wet / (1.0 + 20.07 * wet) ** 0.45))


def absorption(wavelengths: Array = WAVELENGTHS) -> tuple[Array, Array, Array]:
    """Return what turbidity does not change, each ``(wavelengths,)``: the depth of air and ozone, gases and water vapour.

    >>> [float(values[7].round(4)) for values in absorption()]
    [0.2281, 0.0, 0.0]
    """
    ozone, gases, vapour = (np.interp(wavelengths, at, size, left=0.0, right=0.0) for at, size in (_OZONE, _GASES, _VAPOUR))
    return 0.008735 * (wavelengths / 1000.0) ** -4.08 + _OZONE_CM * ozone, gases, _VAPOUR_CM * vapour


def radiance(theta: ArrayLike, tau: ArrayLike, colour_space: str = "srgb") -> Array:
    """Return the disc's linear RGB ``(..., 3)``, luminance-scaled in cd/m2 like the sky's.

    The blue of a low sun lies outside sRGB and is left below 0, as the sky's is.
    """
    return np.asarray(spectral_transmittance(theta, tau) @ spectrum_rgb(colour_space))


def spectrum_rgb(colour_space: str = "srgb") -> Array:
    """Return what each of WAVELENGTHS adds to the disc's linear RGB above the atmosphere, ``(wavelengths, 3)`` in cd/m2."""
    step = WAVELENGTHS[1] - WAVELENGTHS[0]
    return np.asarray((SPECTRUM * OBSERVER).T @ colour.matrix(colour_space).T * (_EFFICACY * step))


def normal_illuminance(theta: ArrayLike, tau: ArrayLike) -> Array:
    """Return the illuminance in lux, ``(...)``, of a surface that faces the sun, from the disc alone.

    The disc's cosines cancel to 2e-5: it is its luminance times pi sin(half-angle) squared.
    """
    luminance = radiance(theta, tau) @ colour.luminance_row("srgb")
    return np.asarray(luminance * np.pi * np.sin(HALF_ANGLE) ** 2)


def weights(theta: ArrayLike, phi: ArrayLike, tau: ArrayLike, bands: int, colour_space: str = "srgb") -> Array:
    """Return the sun's SH weights, ``(..., 3, N*N)`` in cd/m2, to add to a Preetham sky's of the same angles and turbidity.

    ``theta`` and ``phi`` are the sun's zenith angle and azimuth in radians. The disc is whole: near the horizon nothing
    is cut off it.
    """
    return np.asarray(radiance(theta, tau, colour_space)[..., np.newaxis] * disc(theta, phi, bands)[..., np.newaxis, :])


def disc(theta: ArrayLike, phi: ArrayLike, bands: int) -> Array:
    """Return the SH weights of the disc for radiance 1, ``(..., N*N)``; angles as in ``weights``."""
    zenith, azimuth = np.broadcast_arrays(np.asarray(theta, dtype=np.float64), np.asarray(phi, dtype=np.float64))
    axis = np.stack([np.sin(zenith) * np.cos(azimuth), np.sin(zenith) * np.sin(azimuth), np.cos(zenith)], axis=-1)
    return sphere.aim(sphere.cap(HALF_ANGLE, bands), axis)


def from_below(theta: ArrayLike) -> Array:
    """Return the integral of -z over the part of the disc below the horizon, ``(...)`` in sr, for radiance 1.

    ``theta`` is the zenith angle of the disc's centre in radians, up to pi / 2. The disc counts as flat, which errs by the
    square of its half-angle, 2e-5 of this.

    >>> from_below(1.0).tolist()
    0.0
    """
    height = np.clip((np.pi / 2 - np.asarray(theta, dtype=np.float64)) / HALF_ANGLE, 0.0, 1.0)
    chord = np.sqrt((1.0 - height) * (1.0 + height))
    return np.asarray(HALF_ANGLE**3 * (2.0 / 3.0 * chord**3 - height * (np.arccos(height) - height * chord)))


def _within(what: str, values: Array, low: float, high: float, allowed: str) -> None:
    wrong = ~((values >= low) & (values <= high))
    if wrong.any():
        raise ValueError(f"Invalid {what} {float(values[wrong].flat[0])!r}. Should be {allowed}.")
