"""Do the exported bytes hang on the last bits? Everything after the truth, run again on truths with noise.

Two machines' truths differ by some 1e-15 of a set's largest weight; of their least luminances one in a hundred differs, by
up to 5e-9, which is 1e-11 in the mean. Noise of 1e-15, and of 1e-9 on every least luminance, must change no byte. A
thousand times a pair's noise changes some, and how many tells what to expect of a pair: a rounding flips with a
probability proportional to the noise.

    python -m skylight_sh.studies.stability.same_bytes configs/preetham.toml --seeds 30
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from tempfile import TemporaryDirectory

import click
import numpy as np

from skylight_sh.config.schema import Config
from skylight_sh.run import plan
from skylight_sh.run.blas import one_thread
from skylight_sh.run.files import from_dataset
from skylight_sh.run.runner import run
from skylight_sh.run.steps import steps
from skylight_sh.store.dataset import Dataset
from skylight_sh.store.store import Store

WEIGHTS, LEAST = 1e-15, 1e-9
# Of a pair of machines, measured between two kernels; and by how much more noise its flips are counted.
_PAIR = (1e-15, 1e-11)
_LOUDER = 1000.0


@dataclass(frozen=True)
class Noise:
    """Standard deviations of the relative noise on SH weights and on least luminances, and the seed that draws it."""

    seed: int
    weights: float = WEIGHTS
    least: float = LEAST


def outputs(config: Config, truths: Mapping[str, Dataset], noise: Noise | None = None) -> dict[str, bytes]:
    """Return what a run would export, and its errors.csv, of ``truths`` (by step) with ``noise`` on them.

    Raises what the stages raise.
    """
    by_name = {step.name: step for step in steps(config)}
    rng = np.random.default_rng(noise.seed) if noise else None
    done = {name: _noisy(data, noise, rng) if noise and rng else data for name, data in truths.items()}

    def obtain(name: str) -> Dataset:
        if name not in done:
            step = by_name[name]
            made = step.make({needed: obtain(needed) for needed in step.inputs}, lambda *_: None)
            done[name] = Dataset(made.variables, {**made.attrs, "step": name, "key": ""})
        return done[name]

    files = {**from_dataset(obtain("export")), **from_dataset(obtain("report"))}
    return {
        path: data for path, data in files.items() if path.startswith("export/") or path in ("errors.csv", "summary.json")
    }


def _noisy(data: Dataset, noise: Noise, rng: np.random.Generator) -> Dataset:
    found = dict(data.variables)
    for name, size in (("weights", noise.weights), ("least_luminance", noise.least)):
        if name in found:
            values = found[name].data
            found[name] = replace(found[name], data=values * (1.0 + size * rng.standard_normal(values.shape)))
    return Dataset(found, data.attrs)


def truths_of(config: Config, store: Store) -> dict[str, Dataset]:
    """Return the truth's artifacts by step. Raises CorruptArtifactError where one is not there."""
    keys = plan.keys(steps(config))
    return {name: store.get("truth", key) for name, key in keys.items() if name.startswith("truth/")}


def flips(quiet: Mapping[str, bytes], noisy: Mapping[str, bytes]) -> list[str]:
    """Return what differs: tables by their NPZ, and cells of errors.csv of tables that do not."""
    tables = [path for path in quiet if path.endswith(".npz") and noisy.get(path) != quiet[path]]
    names = {Path(path).parent.name for path in tables}
    rows = zip(*(data["errors.csv"].decode().splitlines() for data in (quiet, noisy)), strict=True)
    cells = [
        f"{a.split(',')[0]}: {x} {y}"
        for a, b in rows
        if a.split(",")[0] not in names
        for x, y in zip(a.split(","), b.split(","), strict=True)
        if x != y
    ]
    return tables + cells


def study(config: Config, store: Store, seeds: int) -> Iterator[str]:
    """Yield a line a seed and the sum of it all. Raises as ``outputs``."""
    bare = config.model_copy(update={"report": config.report.model_copy(update={"figures": ()})})
    truths = truths_of(config, store)
    with one_thread():
        quiet = outputs(bare, truths)
        changed, expected = 0, 0
        for seed in range(seeds):
            noisy = outputs(bare, truths, Noise(seed))
            different = sorted(path for path in quiet if noisy.get(path) != quiet[path])
            changed += bool(different)
            loud = flips(quiet, outputs(bare, truths, Noise(seed, *(_LOUDER * size for size in _PAIR))))
            expected += len(loud)
            told = ", ".join(different) or "the same bytes"
            yield f"seed {seed}: {told}; with a thousand times a pair's noise {len(loud)} flips {loud[:3]}"
    yield f"{seeds - changed} of {seeds} the same bytes with noise of {WEIGHTS:g} on the truth and {LEAST:g} on L_min."
    yield f"Expected flips of a pair of machines, by {_LOUDER:g} times their noise: {expected / seeds / _LOUDER:.2g} a run."
    if changed:
        sys.exit(1)


@click.command()
@click.argument("config", type=click.Path(path_type=Path))
@click.option("--seeds", type=click.IntRange(1), default=30, show_default=True)
@click.option("--store", type=click.Path(file_okay=False, path_type=Path), default=Path("artifacts"), show_default=True)
def main(config: Path, seeds: int, store: Path) -> None:
    """Run everything after the truth of CONFIG again and again on truths with noise; exit 1 where a byte changes."""
    from skylight_sh.config import load

    loaded = load(config)
    with TemporaryDirectory() as place:
        run(loaded, Store(store), Path(place), lambda text: click.echo(f"Warning: {text}", err=True))
    for line in study(loaded, Store(store), seeds):
        click.echo(line)


if __name__ == "__main__":
    main()
