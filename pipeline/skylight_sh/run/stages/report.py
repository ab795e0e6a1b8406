"""Report: the page, its pictures and the table of errors."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from skylight_sh.config.schema import Config
from skylight_sh.config.wanted import table_names
from skylight_sh.quadrature import sampling
from skylight_sh.report import errors_csv, page, style, timings
from skylight_sh.report.figures import PICTURES
from skylight_sh.report.report_data import Entry, ReportData, Sweep
from skylight_sh.run.config_axes import axes_of, harmonics_of
from skylight_sh.run.executors import Advance
from skylight_sh.run.files import to_dataset
from skylight_sh.run.from_config import read_table, scene_of, surroundings_of
from skylight_sh.run.plan import Inputs
from skylight_sh.run.provenance import settings
from skylight_sh.run.steps import LIGHTING, ORIGINS, RULE, VERIFICATION, shown_scenes
from skylight_sh.scene.fold import fold
from skylight_sh.store.dataset import Dataset

Array = NDArray[np.float64]


def make(config: Config, inputs: Inputs, advance: Advance) -> Dataset:
    """Draw the pictures and write the page."""
    data = _report_data(config, inputs)
    wanted = [name for name in PICTURES if name in config.report.figures]
    files = {"errors.csv": errors_csv.csv(data)}
    files |= {"references.csv": errors_csv.references_csv(data)} if data.references else {}
    shown = {}
    for done, name in enumerate(wanted):
        advance(done, len(wanted))
        picture = PICTURES[name]
        figure = picture.draw(data)
        files |= picture.files(data)
        if figure is not None:
            files[f"figures/{name}.png"] = style.png(figure)
            shown[name] = style.shown(figure)
    files["index.html"] = page.html(data, shown, timings.released())
    return to_dataset(files)


def _report_data(config: Config, inputs: Inputs) -> ReportData:
    fit, select, measured, grid, rule = (inputs[name] for name in ("fit", "select", "measure", VERIFICATION, RULE))
    names, harmonics = tuple(axis.name for axis in config.axes), harmonics_of(config, rule)

    def sample(values: Array) -> Array:
        nodes, rule_, tolerance = int(rule.attrs["nodes"]), str(rule.attrs["rule"]), float(rule.attrs["tolerance"])
        job = sampling.Job(config.source, names, values.reshape(1, 1, -1), nodes, harmonics, rule_, tolerance)
        weights = np.asarray(sampling.project_block(job).weights[0, 0])
        return fold(scene_of(config), weights, grid["degree"], values)

    return ReportData(
        name=config.name,
        basis=config.fit.basis,
        light=config.source,
        axes=axes_of(config, inputs),
        conventions=tuple(str(measured.attrs["conventions"]).split(",")),
        fronts={
            (int(bands), layout): select[f"fronts/{bands}-{layout}"]
            for bands, layout in (n.removeprefix("fronts/").split("-") for n in select.variables if n.startswith("fronts/"))
        },
        origins=_arrays(inputs[ORIGINS]) if ORIGINS in inputs else None,
        winners=tuple(_entry(select, measured, f"tables/{name}", name) for name in table_names(config)),
        references=tuple(_entry(fit, measured, f"references/{r.name}", r.name) for r in config.fit.references),
        recommended=config.export.recommended,
        sweep=Sweep(**{key: measured[f"sweep/{key}"] for key in ("degrees", "e_max", "e_mean", "rel_l2", "at")}),
        grid=tuple(grid[name] for name in names),
        least=grid["least_luminance"],
        held_out=int(measured.attrs["held_out"]),
        harmonics=harmonics,
        condition=float(fit["condition"]),
        cases={case.title: np.array([case.at[name] for name in names]) for case in config.report.cases},
        sample=sample,
        settings=settings(config),
        rule=rule.attrs,
        surroundings=surroundings_of(inputs),
        lighting=_arrays(inputs[LIGHTING]) if LIGHTING in inputs else None,
        pictures={name.partition("/")[2]: _arrays(inputs[name]) for name in shown_scenes(config)},
    )


def _arrays(artifact: Dataset) -> dict[str, NDArray[Any]]:
    return {name: variable.data for name, variable in artifact.variables.items()}


def _entry(artifact: Dataset, measured: Dataset, start: str, name: str) -> Entry:
    known = artifact.variables
    return Entry(
        name=name,
        table=read_table(artifact, start),
        **{key: measured[f"{start}/{key}"] for key in ("e_max", "e_mean", "rel_l2", "at")},
        per_set=measured[f"{start}/per_set"] if f"{start}/per_set" in measured.variables else None,
        condition=float(artifact[f"{start}/condition"]) if f"{start}/condition" in known else None,
    )
