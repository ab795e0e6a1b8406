"""Ring quadrature of a light's SH weights about the zenith, for many bands.

On a ring of constant zenith angle the basis separates into Legendre factors of the ring and waves of the azimuth, so a
sample costs N multiplications and a ring N of them again for every order; no rotation follows. The peak's cusp stays in
the integrand, so both coordinates are graded at it:

- rings end at the peak's height and crowd there, since a ring's integral has a ``d**2 log d`` at distance d from it, and
  towards the horizon, where a sky's ``exp(B / cos z)`` is smooth but not analytic;
- azimuths are ``phi = k sinh(u)`` near the peak, k being the ring's distance from it over its own radius, which turns
  the angle to the peak into the entire ``cosh(u)``; further off they are even, as the basis' own waves ask.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from scipy import special

from skylight_sh import sphere
from skylight_sh.light.protocol import Light, Parameters
from skylight_sh.quadrature.ring_sums import accumulate
from skylight_sh.quadrature.rule import FINE, Rule, steps
from skylight_sh.quadrature.samples import Samples, keep_least

Array = NDArray[np.float64]

# Grading powers at the peak, seen from the zenith and from the horizon, and at the horizon: measured on the Preetham sky.
_INNER_POWER = 3
_OUTER_POWER = 2
_HORIZON_POWER = 3
# Within a thousandth of the peak's height a cusp left unresolved weighs less than the rounding of the weights.
_LEAST_WIDTH = 1e-3
# Floats held for one block of rings (64 MB), and those a light may hold for each sample on the way to its radiance.
_BLOCK = 8_000_000
_HELD = 24
_NEWTON_STEPS = 8


def project(light: Light, parameters: Parameters, *, nodes: int, harmonics: sphere.Harmonics) -> Samples:
    """Integrate radiance times ``y_lm`` over the upper hemisphere for ``g`` groups of ``k`` parameter sets.

    Every parameter has shape ``(g, k)``, the peak's zenith angle (``light.hints.peak_axis``, radians, 0 where there
    is none) ``(g, 1)``: one set of nodes serves a group. ``nodes`` is the number of azimuths on half a ring; rings
    follow from it. Where the ``harmonics`` are those even in y alone, half the sky is sampled. Beside its result and
    the parameters the rule holds 64 MB, whatever is asked of it. Of the set's largest weight the Preetham sky misses
    1e-9 with ``nodes >= max(60, bands + 12)``.

    The zonal weights of an overcast sky, (1 + 2 z) / 3:

    >>> from skylight_sh.light.cie_traditional import CieTraditional
    >>> sky, at = CieTraditional(sky="overcast"), {"sun_zenith": np.array([[0.4]])}
    >>> project(sky, at, nodes=24, harmonics=sphere.Harmonics.even(2)).weights[0, 0, 0, :2].round(4).tolist()
    [1.1816, 1.1939]
    """
    axis = light.hints.peak_axis
    groups, sets = np.broadcast_shapes(*(values.shape for values in parameters.values()))
    theta = parameters[axis][:, 0] if axis else np.full(groups, light.hints.peak_zenith or 0.0)
    step = max(1, _BLOCK // (_floats(nodes, harmonics, len(light.channels))[1]))
    shape = (groups, sets, len(light.channels), harmonics.count)
    samples = Samples(np.zeros(shape), np.full(shape[:2], np.inf), np.zeros((*shape[:2], 3)), np.full(shape[:2], np.nan))
    for group in range(groups):
        height, azimuth, share = _nodes(theta[group], nodes, harmonics.bands)
        for start in range(0, sets, step):
            part = slice(start, min(start + step, sets))
            named = {
                name: values[group, part if values.shape[1] > 1 else slice(None), np.newaxis, np.newaxis]
                for name, values in parameters.items()
            }
            _add(light, named, (height, azimuth, share), harmonics, into=_view(samples, group, part))
    return samples


def half_sky(theta: float, nodes: int, bands: int) -> tuple[Array, Array]:
    """Return directions ``(n, 3)`` and solid angles ``(n,)`` in sr for a peak ``theta`` radians from the zenith.

    They lie on one side of the peak's azimuth and stand for both: nodes for ``direction_sums.tabulate`` and a light even
    in y.

    >>> directions, solid_angles = half_sky(1.2, 32, 7)
    >>> float((solid_angles.sum() / (2 * np.pi)).round(6))
    1.0
    """
    height, azimuth, share = _nodes(theta, nodes, bands)
    column = height[:, np.newaxis]
    return _directions(np.sin(column), np.cos(column), azimuth).reshape(-1, 3), 2.0 * share.ravel()


def _add(
    light: Light, parameters: Parameters, nodes: tuple[Array, Array, Array], harmonics: sphere.Harmonics, into: Samples
) -> None:
    """Add a group's rings to ``into``, whose arrays are ``(sets, ...)``, block by block."""
    heights, azimuths, shares = nodes
    sets = into.least.size
    fixed, each = _floats(azimuths.shape[1], harmonics, len(light.channels))
    step = max(1, _BLOCK // (fixed + sets * each))
    for start in range(0, heights.size, step):
        block = slice(start, start + step)
        height, azimuth, share = heights[block], azimuths[block], shares[block, :, np.newaxis]
        flat, up = np.sin(height)[:, np.newaxis], np.cos(height)[:, np.newaxis]
        sides = []
        for side in harmonics.sides:
            directions = _directions(flat, up, side * azimuth)
            radiance = np.broadcast_to(light.radiance(directions, parameters), (sets, *share.shape[:2], len(light.channels)))
            luminance = (radiance @ light.luminance_row).reshape(sets, -1)
            keep_least(luminance, directions.reshape(-1, 3), into.least, into.least_direction)
            # (rings, sets, channels, azimuths) from (sets, rings, azimuths, channels).
            sides.append((radiance * share).transpose(1, 0, 3, 2).reshape(1, height.size, -1, azimuth.shape[1]))
        factors = sphere.legendre(up.T, flat.T, harmonics.bands)
        total = into.weights.reshape(1, sets * len(light.channels), -1)
        accumulate(total, sides, azimuth[np.newaxis], factors, harmonics)


def _nodes(theta: float, nodes: int, bands: int) -> tuple[Array, Array, Array]:
    """Zenith angles ``(rings,)``, azimuths over half of each ring and solid angles ``(rings, azimuths)``."""
    height, beyond, weight = _rings(theta, nodes)
    azimuth, share = _azimuths(theta, height, beyond, nodes, bands)
    return height, azimuth, share * (weight * np.sin(height))[:, np.newaxis]


def _directions(flat: Array, up: Array, azimuth: Array) -> Array:
    out = np.empty((*azimuth.shape, 3))
    out[..., 0] = flat * np.cos(azimuth)
    out[..., 1] = flat * np.sin(azimuth)
    # Rounding must not carry a node below the horizon.
    out[..., 2] = np.maximum(up, 0.0)
    return out


def _rings(theta: float, nodes: int) -> tuple[Array, Array, Array]:
    """Zenith angles of the rings, their distance beyond the peak's (exact where small) and their weights in radians."""
    parts = []
    # Counts follow a piece's length, which its waves ask for, plus what the cusp and the horizon ask for.
    if theta > 0.0:
        power = _INNER_POWER if theta < np.pi / 2 else max(_INNER_POWER, _HORIZON_POWER)
        t, rest, weight = _graded(max(8, round(nodes * (0.2 + 0.75 * theta / (np.pi / 2)))), 1, power)
        parts.append((theta * t, -theta * rest, theta * weight))
    reach = np.pi / 2 - theta
    if reach > 0.0:
        count = max(8, round(nodes * (0.3 + 0.75 * (reach / (np.pi / 2)) ** 0.75)))
        t, _, weight = _graded(count, _OUTER_POWER, _HORIZON_POWER)
        parts.append((theta + reach * t, reach * t, reach * weight))
    height, beyond, weight = (np.concatenate(column) for column in zip(*parts, strict=True))
    return height, beyond, weight


def _azimuths(theta: float, height: Array, beyond: Array, nodes: int, bands: int) -> tuple[Array, Array]:
    """Azimuths in [0, pi] on each ring and their weights, ``(rings, nodes)``.

    Gauss-Legendre in ``u = asinh(phi / k) + c phi``. The first term resolves the peak, the second the waves: c trades
    one for the other. k, exactly, is 2 sin(distance / 2) over the geometric mean of the rings' and the peak's radii.
    """
    evenly = max(2.0, bands / 4)
    radius = np.sqrt(np.sin(height) * np.sin(theta))
    width = 2.0 * np.abs(np.sin(beyond / 2)) / np.maximum(radius, 1e-9)
    width = np.clip(width, _LEAST_WIDTH, 1e9)[:, np.newaxis]
    t, w = sphere.gauss_unit(nodes)
    reach = np.arcsinh(np.pi / width) + evenly * np.pi
    u = reach * t
    # Newton in s = asinh(phi / k): convex, and both starting values lie beyond the root, so it falls monotonically.
    slope = evenly * width
    s = np.minimum(u, np.arcsinh(u / slope))
    for _ in range(_NEWTON_STEPS):
        step = (s + slope * np.sinh(s) - u) / (1.0 + slope * np.cosh(s))
        s = s - step
        if np.all(np.abs(step) <= 1e-15 * u):
            break
    azimuth = width * np.sinh(s)
    return azimuth, reach * w / (evenly + 1.0 / np.hypot(azimuth, width))


@lru_cache(maxsize=256)
def _graded(n: int, start: int, end: int) -> tuple[Array, Array, Array]:
    """Gauss-Legendre on [0, 1] in the incomplete beta function: nodes, one minus them without cancellation, weights.

    Powers above 1 crowd the nodes towards 0 (``start``) or 1 (``end``).
    """
    t, w = sphere.gauss_unit(n)
    rest = t[::-1].copy()
    weight = w * t ** (start - 1) * rest ** (end - 1) / special.beta(start, end)
    return special.betainc(start, end, t), special.betainc(end, start, rest), weight


def _floats(nodes: int, harmonics: sphere.Harmonics, channels: int) -> tuple[int, int]:
    """Return how many floats a ring holds at once for all sets together, and for each set."""
    bands, sides = harmonics.bands, len(harmonics.sides)
    waves = nodes * ((2 + 2 * sides) * bands + 8) + bands * bands
    return waves, nodes * (_HELD + channels * (1 + sides)) + 2 * channels * bands


def _view(samples: Samples, group: int, part: slice) -> Samples:
    """Return one group's sets ``part`` of ``samples``, sharing memory."""
    return Samples(
        samples.weights[group, part],
        samples.least[group, part],
        samples.least_direction[group, part],
        samples.estimate[group, part],
    )


RULE = Rule("graded rings about the zenith", project, steps(*FINE, beyond=8))
