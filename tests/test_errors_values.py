"""``errors.csv`` and ``summary.json`` of a run, measured anew: truth of another rule, the exported tables, eqs. 2 and 3."""

from __future__ import annotations

import itertools

import numpy as np
import pandas as pd
import pytest
from numpy.typing import NDArray
from skylight_sh import runtime, sphere
from skylight_sh.light.preetham import Preetham
from skylight_sh.quadrature import rings
from skylight_sh.run.runner import Result

Array = NDArray[np.float64]
BANDS = 4
LIGHT = Preetham()
# In the order of the config: tests/small.toml verifies on 37 x 25 sets and 40 random ones.
ZENITHS = (np.pi / 2 - np.pi / 2 * np.cos(np.pi * np.arange(37) / 36)) / 2
TURBIDITIES = 4.25 - 1.75 * np.cos(np.pi * np.arange(25) / 24)


@pytest.fixture(scope="module")
def errors(small_run: Result) -> pd.DataFrame:
    return pd.read_csv(small_run.folder / "errors.csv")


def truth(sets: Array) -> tuple[Array, Array]:
    """All weights ``(n, channels, 16)`` at azimuth 0, and the least luminance on a fine grid of directions."""
    parameters = {"sun_zenith": sets[:, :1], "turbidity": sets[:, 1:]}
    weights = rings.project(LIGHT, parameters, nodes=72, harmonics=sphere.Harmonics.even(BANDS)).weights[:, 0]
    zenith, azimuth = np.meshgrid(np.linspace(0, np.pi / 2, 181), np.linspace(0, np.pi, 91), indexing="ij")
    flat = np.sin(zenith)
    directions = np.stack([flat * np.cos(azimuth), flat * np.sin(azimuth), np.maximum(np.cos(zenith), 0.0)], axis=-1)
    least = [
        (LIGHT.radiance(directions, {"sun_zenith": np.array(a), "turbidity": np.array(b)}) @ LIGHT.luminance_row).min()
        for a, b in sets
    ]
    return sphere.Harmonics.even(BANDS).unmirror(weights), np.array(least)


def measured(residual: Array, bands: int) -> tuple[Array, Array]:
    """The sum of the magnitudes and the root of the summed squares over the first bands, before division by L_min."""
    part = residual[..., : bands * bands]
    return np.abs(part).sum(axis=-1), np.sqrt((part**2).sum(axis=-1))


def test_the_worst_errors_are_those_of_the_exported_tables(small_run: Result, errors: pd.DataFrame) -> None:
    for row in small_run.summary["tables"]:
        loaded = runtime.load(small_run.folder / row["path"] / "skylight_sh.npz")
        mine = errors[(errors["table"] == row["name"]) & (errors["l_min"] == "per-set")]
        assert len(mine) == 3 * row["bands"]
        sets = mine[["sun_zenith_at_worst", "turbidity_at_worst"]].to_numpy()
        weights, least = truth(sets)
        got = loaded.weights(sets[:, 0], 0.0, sets[:, 1]).astype(np.float64)
        for k, one in enumerate(mine.to_dict("records")):
            channel = LIGHT.channels.index(one["channel"])
            residual = got[k, channel] - weights[k, channel, : row["bands"] ** 2]
            assert one["e_mean"] == pytest.approx(measured(residual, one["bands"])[1] / least[k], rel=3e-3)
        assert set(mine["coefficients"]) == {row["coefficients"]}
        assert set(mine["bytes"]) == {row["bytes"]}
        assert set(mine["dtype"]) == {row["dtype"]}
        assert (mine["degree_sun_zenith"].iloc[0], mine["degree_turbidity"].iloc[0]) == loaded.table.degrees
        last = mine[mine["bands"] == row["bands"]]
        assert last["e_mean"].max() == pytest.approx(row["e_mean"], rel=1e-3)
        assert last["e_max"].max() == pytest.approx(row["e_max"], rel=1e-3)


def test_no_set_of_the_grid_errs_more(small_run: Result, errors: pd.DataFrame) -> None:
    """Every eighth set of the verification grid, edges among them; and the largest of all is reached near the one named."""
    sets = np.array(list(itertools.product(ZENITHS[::4], TURBIDITIES[::4])))
    weights, least = truth(sets)
    for row in small_run.summary["tables"]:
        loaded = runtime.load(small_run.folder / row["path"] / "skylight_sh.npz")
        got = loaded.weights(sets[:, 0], 0.0, sets[:, 1]).astype(np.float64)
        residual = got - weights[..., : row["bands"] ** 2]
        for one in errors[errors["table"] == row["name"]].to_dict("records"):
            channel = LIGHT.channels.index(one["channel"])
            scale = least if one["l_min"] == "per-set" else np.full(len(least), least.min())
            e_max, e_mean = (part / scale for part in measured(residual[:, channel], one["bands"]))
            size = measured(weights[:, channel], one["bands"])[1]
            rel_l2 = measured(residual[:, channel], one["bands"])[1] / size
            # On a quarter of the nodes an axis the largest is somewhat less than on all.
            for name, values in (("e_max", e_max), ("e_mean", e_mean), ("rel_l2", rel_l2)):
                assert 0.5 * one[name] < values.max() < 1.01 * one[name], (row["name"], name, one)


def test_the_sweep_counts_its_coefficients(errors: pd.DataFrame) -> None:
    sweep = errors[errors["table"] == "sweep"]
    assert len(sweep) == 7 * 6 * 3 * BANDS * 2
    terms = (sweep["degree_sun_zenith"] + 1) * (sweep["degree_turbidity"] + 1)
    outputs = sweep["bands"] * (sweep["bands"] + 1) // 2
    assert sweep["coefficients"].tolist() == (3 * terms * outputs).tolist()
    assert sweep["bytes"].tolist() == (8 * sweep["coefficients"]).tolist()
    assert set(zip(sweep["degree_sun_zenith"], sweep["degree_turbidity"], strict=True)) == set(
        itertools.product(range(3, 10), range(1, 7))
    )
    # All terms are those of the fit in double precision: its worst case, evaluated here by numpy alone.
    best = sweep[(sweep["degree_sun_zenith"] == 9) & (sweep["degree_turbidity"] == 6)]
    few = sweep[(sweep["degree_sun_zenith"] == 3) & (sweep["degree_turbidity"] == 1)]
    assert best["e_mean"].max() < 0.002
    assert few["e_mean"].max() > 0.2
    per_set, overall = (best[best["l_min"] == name]["e_mean"].to_numpy() for name in ("per-set", "global"))
    assert np.all(per_set <= overall * 1.0001)


def test_the_sweep_is_a_fit_of_chebyshev_polynomials(errors: pd.DataFrame) -> None:
    """Each combination of degrees fitted here to samples at Chebyshev nodes, and measured at the set named as worst."""
    prefactor = LIGHT.hints.prefactor
    assert prefactor is not None

    def scaled(sets: Array) -> tuple[Array, Array]:
        u = (1 / (5 - sets[:, 0]) - 1 / 5) / (1 / (5 - np.pi / 2) - 1 / 5) * 2 - 1
        v = np.log((sets[:, 1] - 0.5) / 2) / np.log(5.5 / 2) * 2 - 1
        return u, v

    def shared(sets: Array) -> Array:
        return np.asarray(prefactor.formula(sets[:, 0], sets[:, 1], prefactor.constants))

    x = -np.cos(np.pi * (np.arange(12) + 0.5) / 12)
    y = -np.cos(np.pi * (np.arange(8) + 0.5) / 8)
    theta = 5 - 1 / (1 / 5 + (x + 1) / 2 * (1 / (5 - np.pi / 2) - 1 / 5))
    tau = 0.5 + 2 * (5.5 / 2) ** ((y + 1) / 2)
    nodes = np.array(list(itertools.product(theta, tau)))
    samples = truth(nodes)[0] / shared(nodes)[:, np.newaxis, np.newaxis]
    first, second = np.polynomial.chebyshev.chebvander(x, 9), np.polynomial.chebyshev.chebvander(y, 6)
    grid = samples.reshape(12, 8, *samples.shape[1:])
    coefficients = np.einsum("ia,jb,ijcw->abcw", np.linalg.pinv(first).T, np.linalg.pinv(second).T, grid)

    sweep = errors[(errors["table"] == "sweep") & (errors["l_min"] == "per-set")]
    some = sweep[(sweep["degree_sun_zenith"] % 3 == 0) & (sweep["degree_turbidity"] % 2 == 0)]
    sets = some[["sun_zenith_at_worst", "turbidity_at_worst"]].to_numpy()
    places, index = np.unique(sets, axis=0, return_inverse=True)
    weights, least = truth(places)
    u, v = scaled(places)
    outer = (
        np.polynomial.chebyshev.chebvander(u, 9)[:, :, np.newaxis] * np.polynomial.chebyshev.chebvander(v, 6)[:, np.newaxis]
    )
    for k, one in zip(index.ravel(), some.to_dict("records"), strict=True):
        a, b = one["degree_sun_zenith"] + 1, one["degree_turbidity"] + 1
        made = np.einsum("ab,abcw->cw", outer[k, :a, :b], coefficients[:a, :b]) * shared(places[k : k + 1])
        channel = LIGHT.channels.index(one["channel"])
        residual = made[channel] - weights[k, channel]
        assert one["e_mean"] == pytest.approx(measured(residual, one["bands"])[1] / least[k], rel=3e-3, abs=2e-6)
