"""The Hosek-Wilkie sky against Mitsuba's own emitter."""

from __future__ import annotations

import itertools

import mitsuba
import numpy as np
import pytest
from numpy.typing import NDArray
from skylight_sh import sphere
from skylight_sh.light import MissingExtraError, mitsuba_sunsky
from skylight_sh.light.mitsuba_sunsky import MitsubaSunsky
from skylight_sh.quadrature import convergence, sampling
from skylight_sh.quadrature import parameter_points as parameter_sets
from skylight_sh.run.executors import map_tasks

Array = NDArray[np.float64]
RANGES = {"sun_zenith": (0.0, 1.57), "turbidity": (1.0, 10.0), "albedo": (0.0, 1.0)}
NAMES = tuple(RANGES)


def upper(count: int) -> Array:
    drawn = np.random.default_rng(5).normal(size=(count, 3))
    drawn[:, 2] = np.abs(drawn[:, 2])
    return np.asarray(drawn / np.linalg.norm(drawn, axis=1, keepdims=True))


def named(values: Array) -> dict[str, Array]:
    return {name: values[:, i, np.newaxis] for i, name in enumerate(NAMES)}


CORNERS = np.array(list(itertools.product(*RANGES.values())))
SETS = np.concatenate([CORNERS, parameter_sets.random(list(RANGES.values()), 60, seed=6)])


def test_tables_evaluate_what_the_emitter_evaluates() -> None:
    # Single precision in the emitter; near the horizon the cube root of the sun's elevation enlarges it.
    where = np.concatenate([upper(40), [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]])
    tables, renderer = (MitsubaSunsky(evaluation=e).radiance(where[np.newaxis], named(SETS)) for e in ("tables", "renderer"))
    scale = np.abs(renderer).max(axis=(1, 2), keepdims=True)
    error = (np.abs(tables - renderer) / scale).max(axis=(1, 2))
    assert error[SETS[:, 0] < 1.5].max() < 1e-5
    assert error.max() < 1e-4


def test_unit_is_luminance_of_the_spectral_sky() -> None:
    """Integrate the emitter's spectral variant against ybar; the authors' RGB data agrees with it within 2 %."""
    where, set_ = np.array([0.6, 0.3, np.sqrt(0.55)]), np.array([[0.9, 3.0, 0.2]])
    wavelengths = np.arange(360.0, 720.0, 5.0)
    before = mitsuba.variant() or "scalar_rgb"
    mitsuba.set_variant("scalar_spectral")
    try:
        sun = [float(np.sin(0.9)), 0.0, float(np.cos(0.9))]
        emitter = mitsuba.load_dict(
            {"type": "sunsky", "sun_scale": 0.0, "turbidity": 3.0, "albedo": 0.2, "sun_direction": sun}
        )
        looked = mitsuba.SurfaceInteraction3f()
        looked.wi = (-where).tolist()
        total = 0.0
        for four in wavelengths.reshape(-1, 4).tolist():
            looked.wavelengths = four
            ybar = [float(mitsuba.cie1931_y(wavelength)) for wavelength in four]
            total += 5.0 * float(np.dot(np.array(emitter.eval(looked)).ravel(), ybar))
    finally:
        mitsuba.set_variant(before)
    light = MitsubaSunsky()
    got = light.radiance(where, named(set_)) @ light.luminance_row
    assert got[0, 0] == pytest.approx(683.002 * total, rel=0.02)


def test_a_sun_on_the_horizon_is_the_limit_and_not_black() -> None:
    light = MitsubaSunsky()
    at = [light.radiance(upper(20), named(np.array([[np.pi / 2 - gap, 4.0, 0.3]]))) for gap in (0.0, 1e-15, -1e-16)]
    assert np.all(np.isfinite(at[0]))
    assert at[1] == pytest.approx(at[0], rel=1e-3)
    assert at[2] == pytest.approx(at[0], rel=1e-12)


def test_it_is_mirrored_as_it_says() -> None:
    assert convergence.is_mirrored(MitsubaSunsky(), RANGES)
    assert convergence.is_mirrored(MitsubaSunsky(evaluation="renderer"), RANGES)


def test_the_sun_centred_rule_converges() -> None:
    nodes, estimate = convergence.choose_nodes(MitsubaSunsky(), RANGES, harmonics=sphere.Harmonics.even(7), tolerance=1e-10)
    assert nodes <= 64
    assert estimate <= 1e-10


def test_weights_have_kinks_at_whole_turbidities_only() -> None:
    def slopes(turbidity: float) -> float:
        steps = np.array([-1e-3, 0.0, 1e-3])
        values = np.stack([np.full(3, 0.8), turbidity + steps, np.full(3, 0.3)], axis=-1)[np.newaxis]
        weights = sampling.project_block(sampling.Job(MitsubaSunsky(), NAMES, values, 40, sphere.Harmonics.even(4))).weights[
            0
        ]
        left, right = np.diff(weights, axis=0) / 1e-3
        return float(np.abs(right - left).max() / np.abs(weights).max())

    assert min(slopes(float(whole)) for whole in range(2, 10)) > 10 * max(slopes(whole + 0.5) for whole in range(1, 10))


def test_it_travels_to_other_processes() -> None:
    job = sampling.Job(MitsubaSunsky(), NAMES, SETS[:1, np.newaxis], 24, sphere.Harmonics.even(3))
    there = map_tasks(sampling.project_block, [job], executor="processes", workers=1, advance=lambda *_: None)
    assert np.array_equal(there[0].weights, sampling.project_block(job).weights)


def test_a_missing_mitsuba_names_the_remedy(monkeypatch: pytest.MonkeyPatch) -> None:
    mitsuba_sunsky._table.cache_clear()
    monkeypatch.setattr(mitsuba_sunsky.PathFinder, "find_spec", lambda _: None)
    with pytest.raises(MissingExtraError, match=r"pip install 'skylight-sh\[mitsuba\]'"):
        MitsubaSunsky().radiance(upper(2), named(SETS[:1]))
    monkeypatch.undo()
    mitsuba_sunsky._table.cache_clear()
