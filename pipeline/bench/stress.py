"""Stress of the numerics: what breaks, where, and what the pipeline does about it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from threadpoolctl import threadpool_limits

from pipeline import sphere
from pipeline.bench import tabular
from pipeline.bench.samples import Samples, sample
from pipeline.config.schema import Config
from pipeline.fit import solve
from pipeline.fit.axes import Axis
from pipeline.fit.bases import BASES
from pipeline.run.stages.axes import axes_of
from pipeline.run.stages.fit import prefactor_at, prefactor_of, whole_table
from pipeline.table.measure import headline
from pipeline.truth import sampling

Rows = list[dict[str, object]]


def run(config: Config, reports: Path) -> str:
    """Run every stress, write ``bases.csv`` and ``edges.csv`` under the run's stability folder, and return them as text."""
    with threadpool_limits(1):
        samples = sample(config, bands=7)
        fits, edges = bases(samples), [*basis_errors(), *range_edges(config)]
    folder = reports / config.name / "stability"
    tabular.save(folder / "bases.csv", fits)
    tabular.save(folder / "edges.csv", edges)
    return "\n".join(
        [
            "Fits of 7 bands by degree: largest per-set E_mean (a fraction) of the table kept and evaluated in each type.",
            tabular.text(fits),
            "",
            "Edges: each row states what was tried and how far off it is.",
            tabular.text(edges),
            "",
            f"Rows: {folder}",
        ]
    )


def bases(samples: Samples) -> Rows:
    """Condition number and error against degree, for raw, scaled and Chebyshev bases."""
    config = samples.config
    rows: Rows = []
    plain = {kind: tuple(Axis(a.name, *a.range, map=kind) for a in config.axes) for kind in ("raw", "identity")}
    tried = (
        ("monomial, raw, normal equations", "monomial", "normal", plain["raw"]),
        ("monomial, raw, SVD", "monomial", "svd", plain["raw"]),
        ("monomial, scaled, SVD", "monomial", "svd", plain["identity"]),
        ("Chebyshev, scaled, SVD", "chebyshev", "svd", plain["identity"]),
        ("Chebyshev, config's maps and prefactor", "chebyshev", "svd", axes_of(config)),
    )
    for label, basis, solver, axes in tried:
        own = axes is tried[-1][-1]
        flat = np.stack([c.ravel() for c in np.meshgrid(*samples.nodes, indexing="ij")], axis=-1)
        shape = tuple(n.size for n in samples.nodes)
        factor = prefactor_at(config, flat).reshape(*shape, 1, 1) if own else 1.0
        right = (samples.half / factor).reshape(*shape, -1)
        for scale in (0.5, 1.0, 1.5):
            degrees = tuple(min(round(scale * d), n.size - 1) for d, n in zip((13, 7, 7, 7), samples.nodes, strict=False))
            vander = BASES[basis].vander
            matrices = [vander(a.scaled(n), d) for a, n, d in zip(axes, samples.nodes, degrees, strict=True)]
            solution = solve.fit_full(right, matrices, solver)
            dense = solution.reshape(*samples.half.shape[-2:], *solution.shape[1:])
            row: dict[str, object] = {
                "fit": label,
                "degrees": " x ".join(map(str, degrees)),
                "condition": solve.condition(matrices),
            }
            prefactor = prefactor_of(config) if own else None
            for dtype in ("float64", "float32"):
                table = whole_table(config, dense, axes, basis, dtype, prefactor, config.truth.bands, mirrored=True)
                row[dtype] = headline(table, samples.reference)
            rows.append(row)
    return rows


def basis_errors() -> Rows:
    """Orthonormality of the SH basis by exact quadrature."""
    rows: Rows = []
    for bands in (10, 32, 64):
        x, w = np.polynomial.legendre.leggauss(bands)
        rings = sphere.legendre(x, np.sqrt((1 - x) * (1 + x)), bands)
        degrees, orders = sphere.degrees_orders(bands, mirrored=True)
        off = 0.0
        for m in range(bands):
            rows_m = rings[orders == m]
            gram = (rows_m * w) @ rows_m.T * (2 * np.pi if m == 0 else np.pi)
            off = max(off, float(np.abs(gram - np.eye(len(gram))).max()))
        rows.append({"what": f"SH basis orthonormal to l = {int(degrees[-1])}", "error": off})
    return rows


def range_edges(config: Config) -> Rows:
    """Compare the truth at each end of each axis with one ulp inside: the difference must be rounding."""
    rows: Rows = []
    samples_at = {}
    middle = {a.name: (a.range[0] + a.range[1]) / 2 for a in config.axes}
    for axis in config.axes:
        for end, other in (axis.range, axis.range[::-1]):
            for label, value in (("edge", end), ("inside", float(np.nextafter(end, other)))):
                samples_at[label] = _truth(config, {**middle, axis.name: value})
            scale = np.abs(samples_at["edge"]).max()
            change = float(np.abs(samples_at["edge"] - samples_at["inside"]).max() / scale)
            rows.append({"what": f"truth at {axis.name} = {end:.6g} against one ulp inside", "error": change})
    return rows


def _truth(config: Config, values: dict[str, float]) -> np.ndarray:
    names = tuple(values)
    job = sampling.Job(config.light, names, np.array([[list(values.values())]]), 56, 7, config.light.hints.mirrored)
    return sampling.project_block(job).weights
