"""Surroundings: what stands in the scene beside its sky, as maps of the weights, one for each winner's number of bands."""

from __future__ import annotations

from skylight_sh.config.schema import Config
from skylight_sh.run import scene_problems
from skylight_sh.run.config_surroundings import build_all
from skylight_sh.run.executors import Advance
from skylight_sh.run.plan import Inputs
from skylight_sh.run.steps import surroundings_bands
from skylight_sh.store.dataset import Dataset, Variable
from skylight_sh.table.surroundings import PARTS


def make(config: Config, _: Inputs, advance: Advance) -> Dataset:
    """Build the maps, one for each number of bands."""
    scene_problems.check(config)
    found, asked = dict[str, Variable](), surroundings_bands(config)
    for done, (bands, built) in enumerate(zip(asked, build_all(config, asked), strict=True)):
        advance(done, len(asked))
        for part in PARTS:
            array = getattr(built, part)
            dims = tuple(f"{part}_{bands}_{axis}" for axis in range(array.ndim))
            found[f"{part}/{bands}"] = Variable(dims, array)
    return Dataset(found, {})
