"""What the pipeline asks of a light: a black box ``radiance(directions, parameters)`` and optional hints."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import Field, dataclass
from typing import Any, ClassVar, Protocol

import numpy as np
from numpy.typing import NDArray

from skylight_sh import UserError

Array = NDArray[np.float64]
Parameters = Mapping[str, Array]


# How a config reads a light's options.
OPTIONS: Mapping[str, object] = {"extra": "forbid", "strict": True}


@dataclass(frozen=True)
class Domain:
    """Where a parameter of a light is defined: ``low <= value <= high`` in ``unit``; ``why`` explains the limits."""

    low: float
    high: float
    unit: str
    why: str


@dataclass(frozen=True)
class Prefactor:
    """A closed form that the weights are divided by before the fit and multiplied by after evaluation.

    ``formula(*parameters, constants)`` takes generic numbers, parameters in the order of ``axes``, and returns one; or as
    ``Hints.classes`` a list of channels times classes, a channel after another.
    """

    name: str
    axes: tuple[str, ...]
    constants: tuple[float, ...]
    formula: Callable[..., Any]


@dataclass(frozen=True)
class Hints:
    """What a light may tell about itself; every one may be left out.

    ``mirrored``: radiance is even in y while the peak stands at phi = 0 (checked by sampling before use).
    ``peak_axis``: the parameter that is the zenith angle of the light's peak, in radians.
    ``peak_zenith``: that angle where it is no parameter.
    ``prefactor``: a closed form that carries most of the weights' change.
    ``parity``: weights of order m are the prefactor times sin^m of the peak's zenith angle times a smooth even function of
    it (checked by sampling before use).
    ``classes``: the matrix that turns the weights of a few functions of that kind, classes, into those of the channels,
    where no one prefactor does.
    ``luminance``: the prefactor of the light's luminance alone, where that is simpler.
    """

    mirrored: bool = False
    peak_axis: str | None = None
    peak_zenith: float | None = None
    prefactor: Prefactor | None = None
    parity: bool = False
    classes: Prefactor | None = None
    luminance: Prefactor | None = None


class LightError(UserError, ValueError):
    """A light's radiance, or what it tells about itself, makes no sense; the text says where."""


class RadianceError(LightError):
    """A light's radiance raised something; the text names light, parameters and remedy."""


class Light(Protocol):
    """A parametric light on the upper hemisphere; the lower one is black."""

    @property
    def title(self) -> str:
        """Name for people, options included."""

    @property
    def version(self) -> str:
        """What decides its values beside its options and this package's code: a library and its version, or nothing."""

    @property
    def channels(self) -> tuple[str, ...]:
        """Names of the channels of ``radiance``."""

    @property
    def luminance_row(self) -> Array:
        """Factors, shape ``(channels,)``, whose dot product with a radiance is its luminance in cd/m2."""

    @property
    def domains(self) -> Mapping[str, Domain]:
        """The parameters, in their customary order, each with its domain."""

    @property
    def hints(self) -> Hints:
        """What the light tells about itself."""

    def radiance(self, directions: Array, parameters: Parameters) -> Array:
        """Return the radiance of shape ``(..., channels)`` in cd/m2 (linear, luminance-scaled).

        ``directions`` are unit vectors ``(..., 3)``, z up, the peak's azimuth 0; each parameter broadcasts
        against ``directions.shape[:-1]``. Directions below the horizon are not asked for.
        """


class OptionsOfLight(Light, Protocol):
    """A light that a config makes: a frozen dataclass, whose fields are its options."""

    __dataclass_fields__: ClassVar[dict[str, Field[Any]]]

    @property
    def model(self) -> str:
        """Name in ``LIGHTS``."""


def sun_angle(directions: Array, theta: Array) -> tuple[Array, Array]:
    """Return the angle between ``directions`` ``(..., 3)`` and a sun at zenith angle ``theta``, azimuth 0, and its cosine.

    ``theta`` broadcasts against ``directions.shape[:-1]``. The arc tangent keeps full precision at a sky's cusp.

    >>> angle, cosine = sun_angle(np.array([0.0, 0.0, 1.0]), np.array(0.5))
    >>> round(float(angle), 12), round(float(cosine), 4)
    (0.5, 0.8776)
    """
    x, y, z = directions[..., 0], directions[..., 1], directions[..., 2]
    sin_theta, cos_theta = np.sin(theta), np.cos(theta)
    cos_gamma = x * sin_theta + z * cos_theta
    return np.arctan2(np.hypot(y, x * cos_theta - z * sin_theta), cos_gamma), cos_gamma
