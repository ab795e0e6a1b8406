"""The sky of Mitsuba 3's ``sunsky`` emitter (Hosek and Wilkie 2012), sun left out, over turbidity and ground albedo.

Mitsuba is a third-party renderer and an optional extra. Two ways lead to its sky:

- ``tables`` (default) reads the renderer's own coefficient tables, 3,600 doubles in its package's ``sunsky_datasets.bin``,
  and evaluates eqs. 8 and 9 of the 2012 paper for whole arrays in double precision. Mitsuba itself is not imported.
- ``renderer`` asks the emitter, one direction after another. It is a true black box, 100 times slower, and single
  precision, so ``truth.tolerance`` cannot go below about 1e-5.

Both agree to the rounding of the second, which a test holds.

Conventions, found by measurement on version 3.7.1: z is up, ``sun_direction`` points to the sun, and ``emitter.eval``
wants ``wi`` = minus the direction looked at. The emitter returns linear sRGB: the integrals of spectral radiance against
the colour matching functions, divided by the integral of ybar (its ``MI_CIE_Y_NORMALIZATION``). Undoing that and
multiplying by 683.002 lm/W gives luminance-scaled RGB in cd/m2; integrating the emitter's own spectral variant agrees in
Y within 2 %, the difference of the authors' RGB and spectral tables.
"""

from __future__ import annotations

import hashlib
import struct
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from importlib import metadata
from importlib.machinery import PathFinder
from math import comb
from pathlib import Path
from typing import Any, ClassVar, Literal

import numpy as np

from skylight_sh import MissingExtraError
from skylight_sh.light import colour
from skylight_sh.light.protocol import OPTIONS, Array, Domain, Hints, Parameters, sun_angle

# Mitsuba divides RGB radiance by the integral of ybar in nm (``MI_CIE_Y_NORMALIZATION``); photometry counts lm/W.
_YBAR = 106.7502593994140625
_LUMENS = 683.002
_CANDELAS = _LUMENS * _YBAR
# Keeps ``exp(B / cos z)`` finite on the horizon (Hosek and Wilkie 2012, eq. 8).
_HORIZON = 0.01

_FIELDS = {"sky_params_rgb": (10, 2, 6, 3, 9), "sky_rad_rgb": (10, 2, 6, 3)}
# SHA-256 of both tables, so that results kept in the store cannot mix those of two Mitsubas.
_DIGEST = "aff5b6e3890d141bb0ca81ab977007b37393baabcf1443acd2f2ce1b40b39901"
_REMEDY = "Install the extra: pip install 'skylight-sh[mitsuba]'."

_DOMAINS: Mapping[str, Domain] = {
    "sun_zenith": Domain(0.0, float(np.pi / 2), "rad", "the model describes a sun above the horizon"),
    "turbidity": Domain(1.0, 10.0, "1", "the model's data stands at turbidities 1, 2, .. 10 and is not extrapolated"),
    "albedo": Domain(0.0, 1.0, "1", "the ground reflects between none and all of the light"),
}


@dataclass(frozen=True)
class MitsubaSunsky:
    """The sky over ``sun_zenith`` (radians), ``turbidity`` and grey ground ``albedo``; radiance in cd/m2.

    The model's coefficients are linear in turbidity between the whole numbers, so radiance and weights have kinks
    at 2, 3, .. 9: over [1, 10] a polynomial of degree 11 leaves an E_mean of 11 % of the mean luminance even with the sun
    above 10 degrees, while a cell such as [2, 3] is smooth. In ``sun_zenith`` they are quintics of the cube root of the
    sun's elevation, whose slope is infinite at the horizon. Luminance dips below 0 near the horizon with the sun lower
    than about 0.4 degrees, and earlier at high turbidity (from 9 on below 2, at 10 below 10 degrees). It is left so: a
    clamp would break smoothness.
    """

    __pydantic_config__: ClassVar[Mapping[str, object]] = OPTIONS

    model: Literal["mitsuba_sunsky"] = "mitsuba_sunsky"
    """The Hosek-Wilkie sky of Mitsuba 3."""
    evaluation: Literal["tables", "renderer"] = "tables"
    """tables (the renderer's own, here) or renderer (asked for every direction)"""

    @property
    def title(self) -> str:
        """Name for people."""
        return f"Hosek-Wilkie sky (Mitsuba 3 sunsky by its {self.evaluation}, srgb)"

    @property
    def version(self) -> str:
        """The tables by their digest, or the renderer by its version."""
        if self.evaluation == "tables":
            return f"tables {_DIGEST[:12]}"
        try:
            return f"mitsuba {metadata.version('mitsuba')}"
        except metadata.PackageNotFoundError:
            return ""

    @property
    def channels(self) -> tuple[str, ...]:
        """Linear red, green and blue."""
        return ("red", "green", "blue")

    @property
    def luminance_row(self) -> Array:
        """The Y row of sRGB, the only space of the model's RGB data."""
        return colour.luminance_row("srgb")

    @property
    def domains(self) -> Mapping[str, Domain]:
        """Sun zenith, turbidity and ground albedo."""
        return _DOMAINS

    @property
    def hints(self) -> Hints:
        """Mirror-symmetric with a cusp at the sun."""
        return Hints(mirrored=True, peak_axis="sun_zenith")

    def radiance(self, directions: Array, parameters: Parameters) -> Array:
        """Return linear sRGB of shape ``(..., 3)``; see ``Light.radiance``. About 60 ns a direction and parameter set.

        Raises MissingExtraError where Mitsuba, or the version with the known tables, is not installed.
        """
        if self.evaluation == "renderer":
            return _CANDELAS * rendered(directions, parameters)
        theta = parameters["sun_zenith"]
        coefficients = _coefficients(theta, parameters["turbidity"], parameters["albedo"])
        gamma, cos_gamma = sun_angle(directions, theta)
        upward = np.maximum(directions[..., 2], 0.0)
        seen = (gamma, cos_gamma, 1.0 + cos_gamma**2, 1.0 / (upward + _HORIZON), np.sqrt(upward))
        out = np.empty((*np.broadcast_shapes(upward.shape, coefficients.shape[2:]), 3))
        for channel in range(3):
            out[..., channel] = _sky(coefficients[channel], *seen)
        return out


def _sky(k: Array, gamma: Array, cos_gamma: Array, phase: Array, secant: Array, root: Array) -> Array:
    """Gradation times indicatrix times mean radiance for one channel's ten coefficients A..I and mean (eqs. 8 and 9).

    ``phase`` is 1 + cos^2 gamma, ``secant`` 1 / (cos z + 0.01) and ``root`` sqrt(cos z).
    """
    a, b, c, d, e, f, g, i, h, mean = k
    reach = 1.0 + h**2 - 2.0 * h * cos_gamma
    indicatrix = c + d * np.exp(e * gamma) + f * (phase - 1.0) + g * phase / (reach * np.sqrt(reach)) + i * root
    return np.asarray((mean + (mean * a) * np.exp(b * secant)) * indicatrix)


def _coefficients(theta: Array, turbidity: Array, albedo: Array) -> Array:
    """Interpolate the tables: ``(3, 10, ...)``, channel before coefficient, over the parameters' common shape.

    Linear in turbidity and albedo, a quintic Bezier curve in the cube root of the sun's elevation.
    """
    table = _table()
    theta, turbidity, albedo = np.broadcast_arrays(theta, turbidity, albedo)
    # Rounding must not carry a sun on the horizon below it.
    x = np.cbrt(np.maximum(1.0 - theta * (2.0 / np.pi), 0.0))
    curve = np.stack([comb(5, n) * x**n * (1.0 - x) ** (5 - n) for n in range(6)])
    hats = np.maximum(1.0 - np.abs(turbidity - np.arange(1.0, 11.0).reshape(10, *(1,) * theta.ndim)), 0.0)
    ground = np.stack([1.0 - albedo, albedo])
    shares = hats[:, np.newaxis, np.newaxis] * ground[:, np.newaxis] * curve
    found = shares.reshape(len(table), -1).T @ table
    return np.ascontiguousarray(np.moveaxis(found.reshape(*theta.shape, 3, 10), (-2, -1), (0, 1)))


@lru_cache(maxsize=1)
def _table() -> Array:
    """Return Mitsuba's RGB tables in cd/m2: ``(120, 30)``, turbidity x albedo x control point, channel x coefficient."""
    # Not importlib.util.find_spec: once imported, Mitsuba stands in sys.modules as a proxy that knows no folder.
    found = PathFinder.find_spec("mitsuba")
    if found is None or not found.submodule_search_locations:
        raise MissingExtraError(f"The light mitsuba_sunsky needs Mitsuba 3, which is not installed. {_REMEDY}")
    path = Path(found.submodule_search_locations[0]) / "data" / "sunsky" / "sunsky_datasets.bin"
    try:
        fields = _read(path)
    except (OSError, KeyError, ValueError, struct.error) as error:
        raise MissingExtraError(f"{path} does not hold the sky tables of Mitsuba 3.7.1 ({error!r}). {_REMEDY}") from error
    digest = hashlib.sha256(b"".join(fields[name].tobytes() for name in _FIELDS)).hexdigest()
    if digest != _DIGEST:
        raise MissingExtraError(f"{path} holds other sky tables than Mitsuba 3.7.1 (SHA-256 {digest[:12]}..). {_REMEDY}")
    shapes, means = fields["sky_params_rgb"], fields["sky_rad_rgb"] * _LUMENS
    return np.concatenate([shapes, means[..., np.newaxis]], axis=-1).reshape(120, 30)


def _read(path: Path) -> dict[str, Array]:
    """Read the wanted fields of a Mitsuba tensor file.

    Little-endian: 12 bytes of magic, two of version, uint32 fields; for each a uint16-counted name, uint16 rank, a byte
    of type, uint64 offset of its data, and rank uint64 sizes.
    """
    data = path.read_bytes()
    magic, _, _, count = struct.unpack_from("<12sBBI", data)
    if magic != b"tensor_file\0":
        raise ValueError("no tensor file")
    at, fields = 18, {}
    for _ in range(count):
        (length,) = struct.unpack_from("<H", data, at)
        name = data[at + 2 : at + 2 + length].decode()
        rank, _, offset = struct.unpack_from("<HBQ", data, at + 2 + length)
        at += 2 + length + 11
        shape = struct.unpack_from(f"<{rank}Q", data, at)
        at += 8 * rank
        if name in _FIELDS:
            if shape != _FIELDS[name]:
                raise ValueError(f"{name} has shape {shape}, not {_FIELDS[name]}")
            fields[name] = np.frombuffer(data, "<f8", int(np.prod(shape)), offset).reshape(shape)
    return {name: fields[name] for name in _FIELDS}


def rendered(directions: Array, parameters: Parameters) -> Array:
    """Return what Mitsuba's emitter itself evaluates, ``(..., 3)``, in its own unit and single precision.

    About 6 us a direction and 140 us a parameter set in ``scalar_rgb``, which needs no LLVM. On the horizon itself, pi/2,
    single precision rounds the sun below it and Mitsuba's sky is black; such a sun is lifted by a ten-thousandth
    of a degree.
    Raises MissingExtraError where Mitsuba is not installed.
    """
    mitsuba = _scalar_mitsuba()
    names = tuple(_DOMAINS)
    shape = np.broadcast_shapes(directions.shape[:-1], *(parameters[name].shape for name in names))
    views = np.broadcast_to(directions, (*shape, 3)).reshape(-1, 3)
    values = np.stack([np.broadcast_to(parameters[name], shape).ravel() for name in names], axis=-1)
    sets, which = np.unique(values, axis=0, return_inverse=True)
    order = np.argsort(which, kind="stable")
    blocks = np.split(order, np.flatnonzero(np.diff(which[order])) + 1)
    out = np.empty((len(views), 3))
    looked = mitsuba.SurfaceInteraction3f()
    for (theta, turbidity, albedo), rows in zip(sets, blocks, strict=True):
        sun = [float(np.sin(theta)), 0.0, max(float(np.cos(theta)), 3e-7)]
        emitter = mitsuba.load_dict(
            {"type": "sunsky", "sun_scale": 0.0, "turbidity": turbidity, "albedo": albedo, "sun_direction": sun}
        )
        for row, (x, y, z) in zip(rows, views[rows].tolist(), strict=True):
            looked.wi = mitsuba.Vector3f(-x, -y, -max(z, 0.0))
            out[row] = emitter.eval(looked)
    return out.reshape(*shape, 3)


def _scalar_mitsuba() -> Any:
    """Import Mitsuba in its one variant that needs nothing beyond the package; a variant is global to the process."""
    try:
        import mitsuba
    except ImportError as error:
        raise MissingExtraError(f"The light mitsuba_sunsky needs Mitsuba 3, which is not installed. {_REMEDY}") from error
    if mitsuba.variant() != "scalar_rgb":
        mitsuba.set_variant("scalar_rgb")
    return mitsuba
