"""Packed tables: the layout's round trip, its prefix, its cost, and rounding in a metric."""

from __future__ import annotations

import numpy as np
import pytest
from sampled import plain
from skylight_sh import sphere
from skylight_sh.fit.axis import Axis
from skylight_sh.fit.minimax import even, metric
from skylight_sh.fit.nearest_plane import lengths_above, round_kept
from skylight_sh.fit.quantisation import smallest
from skylight_sh.fit.sampled import Sampled
from skylight_sh.fit.variable_search import search
from skylight_sh.runtime import BitReader, flat_places, unpack
from skylight_sh.table import packed, prefactor
from skylight_sh.table.bits import Writer

BANDS = 4
DEGREES, ORDERS = sphere.Harmonics.even(BANDS).degrees, sphere.Harmonics.even(BANDS).orders
PLACES = flat_places(BANDS, mirrored=True)


def _numbers(seed: int = 1) -> np.ndarray:
    rng = np.random.default_rng(seed)
    size = 3000.0 * 0.3 ** np.arange(7)[:, np.newaxis] * 0.15 ** np.arange(4)
    return np.rint(rng.normal(size=(DEGREES.size, 2, 7, 4)) * size).astype(np.int64)


def test_bits_come_back() -> None:
    writer = Writer()
    values = [0, -1, 1, 17, -4096, 5]
    for value in values:
        writer.rice(value, 3)
    writer.fixed(21, 5)
    reader = BitReader(writer.bytes())
    assert [reader.rice(3) for _ in values] == values
    assert reader.fixed(5) == 21
    with pytest.raises(IndexError):
        reader.fixed(32)


def test_packed_numbers_come_back_and_cost_what_was_said() -> None:
    numbers = _numbers()
    out = packed.pack(numbers, DEGREES)
    back = unpack(out, PLACES)
    assert np.array_equal(back, numbers[:, :, : back.shape[2], : back.shape[3]])
    assert not numbers[:, :, back.shape[2] :].any()
    assert not numbers[..., back.shape[3] :].any()
    assert len(out.stream) + out.rest_profile.size + out.channel_profile.size == packed.cost(numbers, DEGREES)


@pytest.mark.parametrize("bands", range(1, BANDS))
def test_a_prefix_of_the_stream_serves_fewer_bands(bands: int) -> None:
    out = packed.pack(_numbers(), DEGREES)
    fewer = flat_places(bands, mirrored=True)
    assert fewer.size == sphere.Harmonics.even(bands).count
    assert np.array_equal(unpack(out, fewer), unpack(out, PLACES)[: fewer.size])


def test_empty_tables_pack() -> None:
    numbers = np.zeros((DEGREES.size, 3, 5, 2), dtype=np.int64)
    assert not unpack(packed.pack(numbers, DEGREES), PLACES).any()


def _sampled(count: int) -> Sampled:
    u = -np.cos(np.pi * (np.arange(count) + 0.5) / count)
    truth = np.stack([np.exp(u), np.sin(3 * u), 1 / (1.4 - u)], axis=-1)[:, np.newaxis] * np.array([[1.0], [0.7]])
    return plain(np.polynomial.chebyshev.chebvander(u, 9), truth)


def test_a_number_beyond_what_the_header_reads_is_refused() -> None:
    with pytest.raises(ValueError, match="whole numbers up to 1073741823, not 1073741824"):
        packed.pack(np.full((1, 1, 1, 1), 1 << 30), np.zeros(1, dtype=np.int64))


def test_rounding_in_the_metric_beats_plain_rounding() -> None:
    plainly = _sampled(40)
    # Sets that count differently: the metric is no longer that of the basis.
    bright = np.exp(np.linspace(-2.0, 2.0, 40))
    sampled = plain(plainly.basis * bright[:, np.newaxis], plainly.truth * bright[:, np.newaxis, np.newaxis])
    normal = metric(sampled, even(sampled))
    best = normal.best.reshape(2, 3, 10, 1)
    step = 0.02
    numbers = round_kept(normal, lengths_above(best, 0.0), 10, step)
    one_by_one = np.rint(best / step)

    def spread(values: np.ndarray) -> float:
        return float(np.mean(sampled.errors(values.reshape(2, 3, 10) * step) ** 2))

    assert spread(numbers.astype(np.float64)) < 0.8 * spread(one_by_one)


def test_the_smallest_table_keeps_its_budget() -> None:
    grid, checked = _sampled(40), _sampled(67)

    def cost(numbers: np.ndarray) -> int:
        return packed.cost(numbers.swapaxes(0, 1), np.arange(3))

    found, tried = smallest(grid, checked, (40,), 10, 0.01, cost)
    assert found is not None
    assert found.error <= 0.01
    assert found.cost == min(t.cost for t in tried if t.error <= 0.01)
    assert found.error == pytest.approx(checked.errors(found.numbers.reshape(2, 3, 10) * found.step).max())
    assert smallest(grid, checked, (40,), 2, 1e-6, cost)[0] is None


def test_the_search_finds_a_pole() -> None:
    axes = (Axis("a", 0.0, 1.0), Axis("b", 2.0, 5.0))
    nodes = [axis.fit_nodes(count, "chebyshev") for axis, count in zip(axes, (24, 21), strict=True)]
    a, b = np.meshgrid(*nodes, indexing="ij")
    bright = 1 / ((b - 1.7) * (1.2 - a))
    samples = bright[..., np.newaxis, np.newaxis] * np.stack([1 + a, a * b, np.ones_like(a)], axis=-1)[..., np.newaxis, :]
    found = search(axes, nodes, samples, bright, 1e-3, free=(True, True), factor=True)
    flat = np.stack([a.ravel(), b.ravel()], axis=-1)
    scale = prefactor.reciprocal(found.denominator, [axis.specified for axis in found.axes])
    product = bright.ravel() / prefactor.evaluate(scale, flat)[:, 0]
    assert np.ptp(product) / product.mean() < 0.6
    kept = search(axes, nodes, samples, np.ones_like(bright), 1e-3, free=(False, True), factor=False)
    assert kept.axes[0] == axes[0]
    assert kept.axes[1].map in ("log", "reciprocal")
    assert kept.denominator.tolist() == [[1.0]]
