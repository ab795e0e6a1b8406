"""Transfer in twenty small numbers a vertex: principal components of the vertices as suns light them.

A vertex lit by any light is a dot product of its transfer with the light's SH weights. Principal components of the transfer
itself (Sloan, Hall, Hart and Snyder 2003) serve weights that no sky has; here they are those of the lit vertices, over many
skies and the bounces of their suns, each divided by its RMS over the vertices. Components are orthogonal in that space, so
that errors of rounding add up without help for each other; but the last components need few of their steps, and lend the
first ones their low bits. What each light makes of the rounded components is solved for anew, by least squares over the
vertices, which is best for every light at once.

A vertex has the numbers of ``columns``: N*N of what it sees of the sky, and 3 N*N of what bounces, red, green and blue.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.reproducible import significant, to_grid

Array = NDArray[np.float64]

COMPONENTS = 20
STEPS = 127
"""A component runs from -1 to 1 in this many steps either way, like a normalised byte of glTF."""

# Transfer and directions are rounded to so many bits below their largest, so that sums of products are exact and hence the
# same in any order: 2 * 18 bits and 100,000 vertices fill the 53 of a double.
_BITS = 18
_DIRECTION_BITS = 12
# The noise of eigenvectors would grow from round to round: what rounds hand on has few bits.
_IMPORTANCE_BITS = 8
# What a frame's uniforms are made with needs no more bits than a float32 has.
_MATRIX_BITS = 24
# A component of less than this share of the first one's variance is noise.
_NOISE = 2.0**-30
# Lights count more, the more of theirs is lost: made least is the sum of these powers of what skies alone lose, and skies
# with the sun's bounces. The high power serves the worst suns, those where one sunlit wall's bounces are most of all light.
_POWERS = np.array([[2.5], [10.0]])
# Losses that weigh the same.
_BALANCE = np.array([[0.011], [0.0165]])
# In each round importance goes this share of the way.
_ROUNDS, _SHARE = 20, 0.25
# So many of the last components lend this share of their steps to the first ones.
_LENDERS = 4
_LENT = 4


@dataclass(frozen=True)
class Compressed:
    """Transfer in few numbers: ``components`` ``(v, k)``, int8, and ``matrix`` ``(1 + k, 4 N*N)``.

    A vertex's ``columns`` are ``matrix[0] + components / 127 @ matrix[1:]``.
    """

    components: NDArray[np.int8]
    matrix: Array

    @property
    def bands(self) -> int:
        """How many bands the light has."""
        return sphere.bands_of(np.empty(self.matrix.shape[1] // 4))


def columns(direct: Array, transfer: Array) -> Array:
    """Return a vertex's numbers ``(v, 4 N*N)``: ``direct`` ``(v, N*N)``, and the bounces of ``transfer`` ``(v, 3, N*N)``."""
    bounces = transfer - direct[:, np.newaxis]
    return np.concatenate([direct, bounces.reshape(len(direct), -1)], axis=1)


def uniforms(matrix: Array, sky: Array, sun: Array) -> Array:
    """Return what a frame's shader takes, ``(..., 1 + k, 3)``: red, green and blue of the mean and of each component.

    ``sky`` and ``sun`` ``(..., 3, N*N)`` are SH weights of radiance, the sun's of a disc that the engine adds itself, with
    its own shadows: it reaches the vertices by bounces alone. A vertex sums them, each times its component / 127, to
    irradiance / pi, before its own albedo.

    >>> uniforms(np.ones((2, 4)), np.ones((3, 1)), np.zeros((3, 1))).tolist()
    [[2.0, 2.0, 2.0], [2.0, 2.0, 2.0]]
    """
    return np.asarray(np.einsum("ki,...ci->...kc", matrix[:, : sky.shape[-1]], sky) + _bounced(matrix, sky + sun))


def lit(compressed: Compressed, sky: Array, sun: Array) -> Array:
    """Return irradiance / pi ``(v, 3)`` of the vertices under one light, as the shader sums it; see ``uniforms``."""
    made = uniforms(compressed.matrix, sky, sun)
    return np.asarray(made[0] + compressed.components / STEPS @ made[1:])


def compress(direct: Array, transfer: Array, sky: Array, sun: Array, count: int = COMPONENTS) -> Compressed:
    """Return ``count`` components of transfer for lights like those given.

    ``direct`` ``(v, N*N)`` is shadowed transfer, ``transfer`` ``(v, 3, N*N)`` the same with bounces; ``sky`` and ``sun``
    ``(s, 3, N*N)`` are SH weights of a thousand lights or more: of few, those in between are served badly. Raises ValueError
    where shapes do not fit or a number is not finite.
    """
    _check(direct, transfer, sky, sun)
    values = to_grid(columns(direct, transfer), _BITS)
    gram = values.T @ values
    mean = values.mean(axis=0)
    centred = gram - len(values) * np.outer(mean, mean)
    directions = _to_grid_each(_directions(gram, centred, _lights(sky, sun), count), _DIRECTION_BITS)
    real = (values - mean) @ directions
    components = _rounded(real)
    return Compressed(components, _matrix(components, values))


def errors(compressed: Compressed, direct: Array, transfer: Array, sky: Array, sun: Array) -> Array:
    """Return what each light loses by compression, ``(2, s)``: of the sky, and of the sky with the sun's bounces.

    That is the RMS of the difference over the RMS, over all vertices and channels; 0 where nothing is lit.
    """
    values = columns(direct, transfer)
    ones = np.ones((len(values), 1))
    off = values - np.concatenate([ones, compressed.components / STEPS], axis=1) @ compressed.matrix
    lost, whole = (_squares(part.T @ part, _lights(sky, sun)) for part in (off, values))
    return np.sqrt(np.divide(lost, whole, out=np.zeros_like(lost), where=whole > 0.0))


def _to_grid_each(vectors: Array, bits: int) -> Array:
    """Round each column of ``(n, k)`` to ``bits`` below its own largest."""
    return np.stack([to_grid(column, bits) for column in vectors.T], axis=-1) if vectors.size else vectors


def _bounced(matrix: Array, light: Array) -> Array:
    weights = light.shape[-1]
    bounce = matrix[:, weights:].reshape(len(matrix), 3, weights)
    return np.asarray(np.einsum("kci,...ci->...kc", bounce, light))


def _lights(sky: Array, sun: Array) -> Array:
    """Return what turns a vertex's columns into its colours under each light, ``(2, s, 3, 4 N*N)``: sky; sky and sun."""
    count, channels, weights = sky.shape
    out = np.zeros((2, count, channels, 1 + channels, weights))
    out[:, :, :, 0] = sky
    for channel in range(channels):
        out[0, :, channel, 1 + channel] = sky[:, channel]
        out[1, :, channel, 1 + channel] = sky[:, channel] + sun[:, channel]
    return out.reshape(2, count, channels, -1)


def _squares(gram: Array, lights: Array) -> Array:
    """Return the sum of squares ``(2, s)`` under each light of rows whose Gram matrix is ``gram``."""
    return np.asarray(np.einsum("psci,psci->ps", lights @ gram, lights))


def _directions(gram: Array, centred: Array, lights: Array, count: int) -> Array:
    """Return the columns' combinations ``(4 N*N, count)`` that are the components, those beyond the noise zero."""
    whole = _squares(gram, lights)
    scale = np.divide(1.0, np.sqrt(whole), out=np.zeros_like(whole), where=whole > 0.0)
    even = lights * scale[..., np.newaxis, np.newaxis]
    importance = np.ones_like(whole) / np.square(_BALANCE)
    found = _principal(centred, even, importance, count)
    for _ in range(_ROUNDS):
        lost = np.sqrt(np.maximum(_squares(_left(centred, found), even), 0.0)) / _BALANCE
        level = np.sqrt(np.square(lost).mean())
        # Rounding to steps will lose more.
        if not level > 0.01:
            break
        wanted = (lost / level) ** (_POWERS - 2.0) / np.square(_BALANCE)
        importance = importance ** (1.0 - _SHARE) * wanted**_SHARE
        importance = significant(importance / importance.max(), _IMPORTANCE_BITS)
        found = _principal(centred, even, importance, count)
    return found


def _principal(centred: Array, lights: Array, importance: Array, count: int) -> Array:
    flat = lights.reshape(-1, lights.shape[-1])
    heavy = flat * np.repeat(importance.ravel(), lights.shape[2])[:, np.newaxis]
    values, vectors = np.linalg.eigh(heavy.T @ flat)
    half = vectors * np.sqrt(np.maximum(values, 0.0))
    variance, turned = np.linalg.eigh(half.T @ centred @ half)
    variance, turned = variance[::-1][:count], turned[:, ::-1][:, :count]
    kept = variance > _NOISE * max(float(variance[0]), 0.0)
    out = np.zeros((len(centred), count))
    made = half @ turned[:, kept] / np.sqrt(variance[kept])
    # Of either sign, the one whose largest number is positive.
    rounded = _to_grid_each(made, _DIRECTION_BITS)
    largest = np.take_along_axis(rounded, np.abs(rounded).argmax(axis=0)[np.newaxis], axis=0)
    out[:, : made.shape[1]] = made * np.where(largest < 0.0, -1.0, 1.0)
    return out


def _left(centred: Array, directions: Array) -> Array:
    """Return the Gram matrix of what the vertices have beside their components."""
    seen = centred @ directions
    return np.asarray(centred - seen @ np.linalg.pinv(directions.T @ seen, rcond=1e-12, hermitian=True) @ seen.T)


def _rounded(real: Array) -> NDArray[np.int8]:
    """Return components ``(v, k)`` in steps; a first one counts in quarters, which stand in the low bits of a last one.

    A first component is its own steps plus a quarter of the last one's, all linear: the least-squares matrix finds that out.
    """
    count = real.shape[1]
    largest = np.abs(real).max(axis=0, initial=0.0)
    share = np.divide(real, largest, out=np.zeros_like(real), where=largest > 0.0)
    out = np.rint(STEPS * share)
    for first in range(min(_LENDERS, count // 4)):
        last = count - 1 - first
        # Room for what the other one adds, and for rounding.
        quarters = np.rint(_LENT * (STEPS - STEPS // _LENT - 1) * share[:, first])
        low = quarters % _LENT
        out[:, last] = low + _LENT * np.rint(((STEPS - _LENT) * share[:, last] - low) / _LENT)
        out[:, first] = (quarters - out[:, last]) / _LENT
    return np.asarray(out, dtype=np.int8)


def _matrix(components: NDArray[np.int8], values: Array) -> Array:
    """Return the least-squares matrix ``(1 + k, 4 N*N)`` that makes a vertex's columns of its components."""
    used = components.any(axis=0)
    whole = np.concatenate([np.ones((len(values), 1)), components[:, used]], axis=1)
    solved = np.linalg.lstsq(whole.T @ whole, whole.T @ values, rcond=1e-12)[0]
    out = np.zeros((1 + components.shape[1], values.shape[1]))
    out[0] = solved[0]
    out[1:][used] = STEPS * solved[1:]
    return np.asarray(significant(out, _MATRIX_BITS))


def _check(direct: Array, transfer: Array, sky: Array, sun: Array) -> None:
    vertices, weights = direct.shape
    lights = len(sky)
    for name, array, shape in (
        ("transfer", transfer, (vertices, 3, weights)),
        ("sky", sky, (lights, 3, weights)),
        ("sun", sun, (lights, 3, weights)),
    ):
        if array.shape != shape:
            raise ValueError(f"Invalid {name} of shape {array.shape}. Should be {shape}: three channels, {weights} weights.")
    for name, array in (("direct", direct), ("transfer", transfer), ("sky", sky), ("sun", sun)):
        if not np.isfinite(array).all():
            raise ValueError(f"Invalid {name}: it holds a number that is not finite.")
    if not (vertices and lights):
        raise ValueError(f"Invalid sizes: {vertices} vertices and {lights} lights. Should be at least one of each.")
