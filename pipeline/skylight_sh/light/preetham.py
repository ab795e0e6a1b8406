"""The Preetham sky (Preetham, Shirley and Smits 1999), luminance and chromaticity, in linear RGB.

Two constant sets: ``published`` (the 1999 paper) and ``smits`` (the five-digit set of the authors' released code,
which the data of Habel et al. 2008 follows).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from skylight_sh import MissingExtraError
from skylight_sh.formula.elementary import label
from skylight_sh.light import colour
from skylight_sh.light.mixins import OwnCode
from skylight_sh.light.protocol import OPTIONS, Array, Domain, Hints, Parameters, Prefactor, sun_angle

Floats = NDArray[np.floating]

# Rows A..E of the Perez function; columns: slope and offset in turbidity for Y, x and y.
_PEREZ = {
    "published": (
        (0.1787, -1.4630, -0.0193, -0.2592, -0.0167, -0.2608),
        (-0.3554, 0.4275, -0.0665, 0.0008, -0.0950, 0.0092),
        (-0.0227, 5.3251, -0.0004, 0.2125, -0.0079, 0.2102),
        (0.1206, -2.5771, -0.0641, -0.8989, -0.0441, -1.6537),
        (-0.0670, 0.3703, -0.0033, 0.0452, -0.0109, 0.0529),
    ),
    "smits": (
        (0.17872, -1.46303, -0.01925, -0.25922, -0.01669, -0.26078),
        (-0.35540, 0.42749, -0.06651, 0.00081, -0.09495, 0.00921),
        (-0.02266, 5.32505, -0.00041, 0.21247, -0.00792, 0.21023),
        (0.12064, -2.57705, -0.06409, -0.89887, -0.04405, -1.65369),
        (-0.06696, 0.37027, -0.00325, 0.04517, -0.01092, 0.05291),
    ),
}

# Zenith chromaticity x and y: rows tau^2, tau, 1; columns theta^3, theta^2, theta, 1.
_ZENITH = {
    "published": (
        (
            (0.00166, -0.00375, 0.00209, 0.0),
            (-0.02903, 0.06377, -0.03202, 0.00394),
            (0.11693, -0.21196, 0.06052, 0.25886),
        ),
        (
            (0.00275, -0.00610, 0.00317, 0.0),
            (-0.04214, 0.08970, -0.04153, 0.00516),
            (0.15346, -0.26756, 0.06670, 0.26688),
        ),
    ),
    "smits": (
        (
            (0.00165, -0.00374, 0.00208, 0.0),
            (-0.02902, 0.06377, -0.03202, 0.00394),
            (0.11693, -0.21196, 0.06052, 0.25885),
        ),
        (
            (0.00275, -0.00610, 0.00316, 0.0),
            (-0.04214, 0.08970, -0.04153, 0.00515),
            (0.15346, -0.26756, 0.06669, 0.26688),
        ),
    ),
}

CONSTANT_SETS = tuple(_PEREZ)

DOMAINS: Mapping[str, Domain] = {
    "sun_zenith": Domain(0.0, float(np.pi / 2), "rad", "the model describes a sun above the horizon"),
    "turbidity": Domain(1.7, 10.0, "1", "the luminance normaliser 1 + A exp B passes 0 near turbidity 1.643"),
}


@dataclass(frozen=True)
class Preetham(OwnCode):
    """The sky as a black box over ``sun_zenith`` (radians) and ``turbidity``; radiance in cd/m2."""

    __pydantic_config__: ClassVar[Mapping[str, object]] = OPTIONS

    model: Literal["preetham"] = "preetham"
    """The Preetham sky."""
    constants: Literal["published", "smits"] = "published"
    """published (the 1999 paper's) or smits (five digits, of its authors' code, behind the 2008 data)"""
    colour_space: str = "srgb"
    """linear RGB by the name of its primaries: srgb, or any the colour library knows"""

    def __post_init__(self) -> None:
        # A colour space that is not there is told before anything runs.
        try:
            colour.matrix(self.colour_space)
        except MissingExtraError as error:
            raise ValueError(str(error)) from error

    @property
    def title(self) -> str:
        """Name for people."""
        return f"Preetham sky ({self.constants} constants, {self.colour_space})"

    @property
    def channels(self) -> tuple[str, ...]:
        """Linear red, green and blue."""
        return ("red", "green", "blue")

    @cached_property
    def luminance_row(self) -> Array:
        """The Y row of the colour space."""
        return colour.luminance_row(self.colour_space)

    @property
    def domains(self) -> Mapping[str, Domain]:
        """Sun zenith and turbidity."""
        return DOMAINS

    @cached_property
    def hints(self) -> Hints:
        """Mirror-symmetric, a cusp at the sun, the zenith luminance factor as prefactor; three classes with parity."""
        numbers = tuple(value for row in _PEREZ[self.constants] for value in row[:2])
        axes = ("sun_zenith", "turbidity")
        return Hints(
            mirrored=True,
            peak_axis="sun_zenith",
            prefactor=Prefactor("preetham_zenith", axes, numbers, zenith_factor),
            parity=True,
            classes=Prefactor("preetham_classes", axes, self._class_numbers, class_factors),
            luminance=Prefactor("preetham_luminance", axes, self._class_numbers[:_OF_LUMINANCE], luminance_factor),
        )

    @cached_property
    def _class_numbers(self) -> tuple[float, ...]:
        """What ``class_factors`` reads: of Y a to e, of x and y gradation, c, d, e, then chromaticities and the colours."""
        perez, zenith = np.array(_PEREZ[self.constants]), _ZENITH[self.constants]
        found = perez[:, :2].ravel().tolist()
        for column in (2, 4):
            slopes, offsets = perez[:2, column], perez[:2, column + 1]
            ends = [1.0 + (slopes[0] * tau + offsets[0]) * np.exp(slopes[1] * tau + offsets[1]) for tau in (2.5, 6.0)]
            slope = (ends[1] - ends[0]) / 3.5
            # Few digits, which a packed table keeps in two bytes.
            found += [round(slope, 5), round(ends[0] - 2.5 * slope, 4), *perez[2:, column : column + 2].ravel().tolist()]
        # Of each chromaticity, by rising powers of theta, the polynomials in turbidity; none for the constant's square.
        found += [zenith[i][j][3 - k] for i in range(2) for k in range(4) for j in range(3) if (j, k) != (0, 0)]
        a, b, c = colour.matrix(self.colour_space).T
        return (*found, *np.stack([a - c, b - c, c], axis=1).ravel().tolist())

    def radiance(self, directions: Array, parameters: Parameters) -> Array:
        """Return linear RGB of shape ``(..., 3)``; see ``Light.radiance``.

        The blue channel dips below 0 in at most 0.05 % of the sky, only with the sun on the horizon and turbidity
        below 3.2. It is left so: a clamp would break smoothness.
        """
        theta, tau = parameters["sun_zenith"], parameters["turbidity"]
        gamma, cos_gamma = sun_angle(directions, theta)
        # exp(B / cos z) is 0 on the horizon itself, where B < 0 divides by zero.
        secant = 1.0 / np.maximum(directions[..., 2], 1e-300)
        shape, zenith = self._of_parameters(theta, tau)
        luminance, x, y = (
            zenith[i] * _perez_sky([row[i] for row in shape], secant, gamma, cos_gamma) for i in range(len(zenith))
        )
        scale = luminance / y
        to_rgb = colour.matrix(self.colour_space)
        out = np.empty((*scale.shape, 3))
        blue_xyz = (1.0 - x - y) * scale
        red_xyz = x * scale
        for channel, (a, b, c) in enumerate(to_rgb.tolist()):
            out[..., channel] = a * red_xyz + b * luminance + c * blue_xyz
        return out

    def _of_parameters(self, theta: Array, tau: Array) -> tuple[Floats, Array]:
        """A..E ``(5, 3, ...)`` and the zenith's values over their shape's ``(3, ...)``, for Y, x and y.

        All at once, since a few samples of one sky cost less than these scalars do one by one.
        """
        perez, chromaticity = _tables(self.constants, max(theta.ndim, tau.ndim))
        shape = perez[:, :, 0] * tau + perez[:, :, 1]
        of_theta = ((chromaticity[0] * theta + chromaticity[1]) * theta + chromaticity[2]) * theta + chromaticity[3]
        chroma = (of_theta[0] * tau + of_theta[1]) * tau + of_theta[2]
        zenith = np.empty((3, *chroma.shape[1:]))
        zenith[0], zenith[1:] = zenith_luminance(theta, tau), chroma
        return shape, zenith / _perez_sky(shape, 1.0, theta, np.cos(theta))


@lru_cache(maxsize=8 * len(CONSTANT_SETS))
def _tables(constants: str, rank: int) -> tuple[Array, Array]:
    """Perez constants ``(A..E, Y x y, slope and offset)`` and zenith chromaticity ``(theta^3..1, tau^2..1, x y)``.

    Both are followed by ``rank`` axes of size 1, for the parameters' own.
    """
    ones = (1,) * rank
    zenith = np.array(_ZENITH[constants]).transpose(2, 1, 0)
    return np.array(_PEREZ[constants]).reshape(5, 3, 2, *ones), zenith.reshape(*zenith.shape, *ones)


def constants_of(constants: str) -> tuple[Array, Array]:
    """Return a constant set's Perez rows ``(A..E, Y x y, slope and offset)`` and its zenith chromaticity.

    The latter has shape ``(x y, tau^2..1, theta^3..1)``.

    >>> perez, zenith = constants_of("published")
    >>> perez[0, 0].tolist(), zenith[0, 2].tolist()
    ([0.1787, -1.463], [0.11693, -0.21196, 0.06052, 0.25886])
    """
    return np.array(_PEREZ[constants]).reshape(5, 3, 2), np.array(_ZENITH[constants])


def zenith_luminance(theta: Floats, tau: Floats) -> Floats:
    """Return the zenith luminance in cd/m2 (Preetham et al. 1999, appendix A.2; the whole sum is in kcd/m2)."""
    chi = (4.0 / 9.0 - tau / 120.0) * (np.pi - 2.0 * theta)
    return np.asarray(1000.0 * ((4.0453 * tau - 4.9710) * np.tan(chi) - 0.2155 * tau + 2.4192))


def zenith_factor(theta: Any, tau: Any, k: Sequence[Any]) -> Any:
    """Return ``Y_z / F_Y(0, theta)``, the zenith luminance without the shape of the sky, in cd/m2, but for a few per cent.

    A formula of generic numbers; ``k`` are slope and offset of A..E for Y. The tangent, exponentials and cosine are
    rational functions that cost a renderer a tenth of the library's; since a fit divides by exactly what a table
    multiplies by, that costs no accuracy.
    """
    a, b, c, d, e = (label(k[2 * i] * tau + k[2 * i + 1], name) for i, name in enumerate("abcde"))
    chi = label((4 / 9 - tau * (1 / 120)) * (np.pi - 2 * theta), "chi")
    square = label(chi * chi, "square")
    # tan chi = tan_above / tan_below (Pade), exp b = up ** 4, exp(d theta) = halo ** 8, cos theta by its series.
    tan_above, tan_below = label(chi * (105 - 10 * square), "tan_above"), label(105 - square * (45 - square), "tan_below")
    up = label(1 + b * (0.25 + b * (1 / 32)), "up")
    up = label(up * up, "up2")
    up = label(up * up, "up4")
    y = label(d * theta, "y")
    halo = label(1 + y * (0.125 + y * (1 / 128)), "halo")
    halo = label(halo * halo, "halo2")
    halo = label(halo * halo, "halo4")
    halo = label(halo * halo, "halo8")
    z = label(theta * theta, "z")
    cosine = label(1 - z * (0.5 - z * (1 / 24 - z * (1 / 720))), "cosine")
    zenith = label((4.0453 * tau - 4.9710) * tan_above + (2.4192 - 0.2155 * tau) * tan_below, "zenith")
    return 1000 * zenith / (tan_below * (1 + a * up) * (1 + c * halo + e * (cosine * cosine)))


def class_factors(theta: Any, tau: Any, k: Sequence[Any]) -> list[Any]:
    """Return what red, green and blue take of three classes, ``(3, 3)`` row by row, in cd/m2.

    With X, Y, Z = X, Y, S - X - Y, S = Y / y, the sky is three terms, each a factor of sun and turbidity times a shape that
    hangs on the sun by the angle to it alone: so the weights of X, Y and S are their factors times sin^m(theta) times even
    functions of theta (docs/mathematics.md). The classes are Y's and the small differences of X's and S's to it. ``k`` are
    ``Preetham``'s numbers. Exponentials and tangent are polynomials exact to 1e-6 where they are not even in theta; what
    hangs on turbidity alone may be coarser, since the fit divides by what a table multiplies by.
    """
    cosine2 = _squared_cosine(theta)
    shape_y, zenith, below = _luminance_shape(theta, tau, k, cosine2)
    # F_x and F_y, each gradation, c, d and e.
    shapes = []
    for name, start in (("shape_x", 10), ("shape_z", 18)):
        gradation, *others = (k[i] * tau + k[i + 1] for i in range(start, start + 8, 2))
        shapes.append(label(gradation * _indicatrix(theta, cosine2, others), name))
    shape_x, shape_z = shapes
    x, y = (label(_chromaticity(theta, tau, k[i : i + 11]), name) for i, name in ((26, "x_zenith"), (37, "y_zenith")))
    # X : Y : S are x F_y F_Y .. over one denominator.
    one = label(zenith / (below * shape_y * y * shape_x), "one")
    of_x, of_y, of_s = (
        label(one * x * shape_z, "of_x"),
        label(one * y * shape_x, "of_y"),
        label(one * shape_z * shape_x, "of_s"),
    )
    rows = []
    for channel in range(3):
        from_x, from_y, from_s = (k[48 + 3 * channel + i] * factor for i, factor in enumerate((of_x, of_y, of_s)))
        rows += [from_x + from_y + from_s, from_x, from_s]
    return rows


# exp on [-1, 0] through Chebyshev nodes, within 1.6e-8.
_EXP = (0.999999984, 0.999998454, 0.499975091, 0.166515167, 0.0412233177, 0.0076543251, 0.000849007871)
_OF_LUMINANCE = 10
"""How many of ``Preetham``'s numbers the factor of luminance reads."""


def luminance_factor(theta: Any, tau: Any, k: Sequence[Any]) -> Any:
    """Return ``Y_z / F_Y(0, theta)`` as ``class_factors`` has it, in cd/m2: exact enough for parity."""
    shape, zenith, below = _luminance_shape(theta, tau, k, _squared_cosine(theta))
    return zenith / (below * shape)


def _luminance_shape(theta: Any, tau: Any, k: Sequence[Any], cosine2: Any) -> tuple[Any, Any, Any]:
    """Return F_Y(0, theta), and numerator and denominator of the zenith's luminance in cd/m2."""
    a, b, *others = (k[2 * i] * tau + k[2 * i + 1] for i in range(5))
    up = label(1 + b * (0.25 + b * (1 / 32)), "up")
    up = label(up * up, "up2")
    shape = label((1 + a * (up * up)) * _indicatrix(theta, cosine2, others), "shape_y")
    chi = label((8 / 9 - tau * (1 / 60)) * (np.pi / 2 - theta), "chi")
    square = label(chi * chi, "square")
    # tan chi by the continued fraction.
    above, below = chi * (945 - square * (105 - square)), label(945 - square * (420 - 15 * square), "below")
    zenith = (4045.3 * tau - 4971.0) * above + (2419.2 - 215.5 * tau) * below
    return shape, label(zenith, "zenith"), below


def _squared_cosine(theta: Any) -> Any:
    """Return the square of cos theta but for 0.05, even in theta."""
    z = label(theta * theta, "z")
    cosine = label(1 - z * (0.5 - z * (1 / 32)), "cosine")
    return label(cosine * cosine, "cosine2")


def _indicatrix(theta: Any, cosine2: Any, k: Sequence[Any]) -> Any:
    """Return ``1 + c exp(d theta) + e cos^2`` by exp(y) = exp(y / 4)^4: few squares, which multiply roundings."""
    c, d, e = k
    y = label(d * theta * 0.25, "y")
    y2 = label(y * y, "y2")
    # By Estrin's scheme: in pairs, which do not wait for one another.
    halo: Any = _EXP[6]
    for i in (4, 2, 0):
        halo = _EXP[i] + _EXP[i + 1] * y + y2 * halo
    halo = label(halo, "halo")
    for power in (2, 4):
        halo = label(halo * halo, f"halo{power}")
    return 1 + c * halo + e * cosine2


def _chromaticity(theta: Any, tau: Any, k: Sequence[Any]) -> Any:
    """Return the zenith's x or y, a cubic in theta of quadratics in turbidity; the constant one is linear."""
    found = 0.0
    for i in (8, 5, 2):
        found = (found + ((k[i] * tau + k[i + 1]) * tau + k[i + 2])) * theta
    return found + (k[0] * tau + k[1])


def _perez_sky(shape: Sequence[Floats] | Floats, secant: Floats | float, gamma: Floats, cos_gamma: Floats) -> Floats:
    """Perez function ``(1 + A exp(B / cos z)) (1 + C exp(D g) + E cos^2 g)`` of A..E."""
    a, b, c, d, e = shape
    # In place: most of a truth's time is spent here, and on new memory.
    gradation = np.asarray(b * secant)
    np.exp(gradation, out=gradation)
    gradation *= a
    gradation += 1
    indicatrix = np.asarray(d * gamma)
    np.exp(indicatrix, out=indicatrix)
    indicatrix *= c
    indicatrix += 1
    indicatrix += e * cos_gamma**2
    return np.asarray(gradation * indicatrix)
