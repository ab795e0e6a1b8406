"""Sun-centred Gauss quadrature of a light's SH weights over the upper hemisphere.

Polar coordinates (g, psi) about the light's peak remove its cusp; psi = 0 points to the zenith. The full circles
g <= pi/2 - theta and the arcs behind them are two pieces, each Gauss-Legendre in graded variables, because a sky's
``exp(B / cos z)`` is smooth but not analytic on the horizon. In the peak's own frame the basis separates into Legendre
factors of g and waves of psi, so a sum costs N per sample instead of N*N; one rotation about y brings the weights back.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.light.protocol import Light, Parameters
from skylight_sh.quadrature.ring_sums import accumulate
from skylight_sh.quadrature.rule import FINE, Rule, steps
from skylight_sh.quadrature.samples import Samples, keep_least

Array = NDArray[np.float64]

# Grading powers towards the horizon, and nodes relative to the arcs' (the hardest piece): measured on the Preetham sky.
_RING_POWER = 3
WAVE_POWER = 2
_RING_SHARE = 0.75
_WAVE_SHARE = 0.8


@dataclass(frozen=True)
class Nodes:
    """Gauss nodes of the circles' g, of the arcs' u and of psi on either; ``power`` grades the circles to the horizon."""

    circles: int
    arcs: int
    waves: int
    power: int = _RING_POWER

    @classmethod
    def usual(cls, arcs: int) -> Nodes:
        """Return the rule's shares for so many nodes over the arcs.

        >>> Nodes.usual(32)
        Nodes(circles=24, arcs=32, waves=26, power=3)
        """
        return cls(max(8, round(_RING_SHARE * arcs)), arcs, max(8, round(_WAVE_SHARE * arcs)))


def project(light: Light, parameters: Parameters, *, nodes: int | Nodes, harmonics: sphere.Harmonics) -> Samples:
    """Integrate radiance times ``y_lm`` over the upper hemisphere for ``g`` groups of ``k`` parameter sets.

    Every parameter has shape ``(g, k)``, the peak's zenith angle (``light.hints.peak_axis``, radians, 0 where there
    is none) ``(g, 1)``: one set of nodes serves a group. ``nodes`` is the number of Gauss nodes over the arcs, or
    those of everything.
    Where the ``harmonics`` are those even in y alone, half the sky is sampled. The README's conventions hold.

    The zonal weights of an overcast sky, (1 + 2 z) / 3:

    >>> from skylight_sh.light.cie_traditional import CieTraditional
    >>> sky, at = CieTraditional(sky="overcast"), {"sun_zenith": np.array([[0.4]])}
    >>> project(sky, at, nodes=24, harmonics=sphere.Harmonics.even(2)).weights[0, 0, 0, :2].round(4).tolist()
    [1.1816, 1.1939]
    """
    axis = light.hints.peak_axis
    groups = next(iter(parameters.values())).shape[0]
    theta = parameters[axis][:, 0] if axis else np.full(groups, light.hints.peak_zenith or 0.0)
    sets = np.broadcast_shapes(*(values.shape for values in parameters.values()))
    shaped = {name: values[..., np.newaxis] for name, values in parameters.items()}
    least, least_direction = np.full(sets, np.inf), np.zeros((*sets, 3))
    total = np.zeros((theta.size, sets[1] * len(light.channels), harmonics.count))
    for g, psi, weight in _pieces(theta, Nodes.usual(nodes) if isinstance(nodes, int) else nodes):
        sides = []
        for side in harmonics.sides:
            directions = _directions(theta, g, side * psi).reshape(theta.size, 1, -1, 3)
            radiance = light.radiance(directions, shaped)
            keep_least(radiance @ light.luminance_row, directions, least, least_direction)
            # (groups, rings, sets, channels, waves) from (groups, sets, rings times waves, channels).
            parts = radiance.reshape(*sets, *weight.shape[1:], -1) * weight[:, np.newaxis, :, :, np.newaxis]
            sides.append(parts.transpose(0, 2, 1, 4, 3).reshape(*g.shape, -1, psi.shape[2]))
        accumulate(total, sides, psi, sphere.legendre(np.cos(g), np.sin(g), harmonics.bands), harmonics)
    # The frame's x axis points up the sky, half a turn about the peak from the turned +x.
    total *= (-1.0) ** harmonics.orders
    weights = sphere.rotate_y(total, theta, harmonics).reshape(*sets, len(light.channels), -1)
    return Samples(weights, least, least_direction, np.full(sets, np.nan))


def half_sky(theta: float, nodes: int) -> tuple[Array, Array]:
    """Return directions ``(n, 3)`` and solid angles ``(n,)`` in sr for a peak ``theta`` radians from the zenith.

    They lie on one side of the peak's azimuth and stand for both: nodes for ``direction_sums.tabulate`` and a light even
    in y.

    >>> directions, solid_angles = half_sky(1.2, 32)
    >>> float((solid_angles.sum() / (2 * np.pi)).round(6))
    1.0
    """
    peak = np.full(1, theta)
    pieces = _pieces(peak, Nodes.usual(nodes))
    directions = [_directions(peak, g, psi).reshape(-1, 3) for g, psi, _ in pieces]
    return np.concatenate(directions), 2.0 * np.concatenate([weight.ravel() for *_, weight in pieces])


def _pieces(theta: Array, nodes: Nodes) -> list[tuple[Array, Array, Array]]:
    """Nodes g ``(groups, i)``, psi and weights ``(groups, i, j)`` over psi >= 0 of the full circles, and of the arcs.

    The circles' psi are the same ones for all, ``(1, 1, j)``.
    """
    waves, wave_weights = graded(nodes.waves, WAVE_POWER)
    rings, ring_weights = graded(nodes.circles, nodes.power)
    reach = (np.pi / 2 - theta)[:, np.newaxis]
    g = reach * rings
    psi = np.pi * waves[np.newaxis, np.newaxis]
    weight = (reach * ring_weights * np.sin(g))[..., np.newaxis] * (np.pi * wave_weights)

    x, v = sphere.gauss(nodes.arcs)
    u = np.pi / 2 * x
    h = theta[:, np.newaxis] * np.sin(u)
    with np.errstate(invalid="ignore"):
        cosine = np.where(h == 0.0, np.sin(u), np.tan(h) / np.tan(theta)[:, np.newaxis])
    psi_max = np.arccos(np.clip(cosine, -1.0, 1.0))[..., np.newaxis]
    arc = np.pi / 2 * v * theta[:, np.newaxis] * np.cos(u) * np.cos(h)
    return [(g, psi, weight), (np.pi / 2 + h, psi_max * waves, arc[..., np.newaxis] * psi_max * wave_weights)]


def graded(n: int, power: int) -> tuple[Array, Array]:
    """Return ``n`` Gauss-Legendre nodes on [0, 1] in ``1 - (1 - t)**power``, dense towards 1, and their weights.

    >>> nodes, weights = graded(8, 2)
    >>> float((weights @ nodes).round(12))
    0.5
    """
    t, w = sphere.gauss_unit(n)
    rest = t[::-1].copy()
    return 1.0 - rest**power, w * power * rest ** (power - 1)


def _directions(theta: Array, g: Array, psi: Array) -> Array:
    sin_theta, cos_theta = np.sin(theta)[:, np.newaxis, np.newaxis], np.cos(theta)[:, np.newaxis, np.newaxis]
    sin_g, cos_g = np.sin(g)[..., np.newaxis], np.cos(g)[..., np.newaxis]
    up = sin_g * np.cos(psi)
    out = np.empty((*up.shape, 3))
    out[..., 0] = sin_theta * cos_g - cos_theta * up
    out[..., 1] = -sin_g * np.sin(psi)
    # Rounding must not carry a node below the horizon.
    out[..., 2] = np.maximum(cos_theta * cos_g + sin_theta * up, 0.0)
    return out


RULE = Rule("sun-centred Gauss", project, steps(*FINE, beyond=12))
