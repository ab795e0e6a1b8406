"""Verify: run a released result's config again, and say file by file what is the same and what differs by how much."""

from __future__ import annotations

import io
import json
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from skylight_sh.config.loading import parse
from skylight_sh.config.schema import Config
from skylight_sh.run.runner import SUMS, run
from skylight_sh.store.store import Store

_NUMBER = re.compile(r"[-+]?(?:\d+\.\d*|\.?\d+)(?:[eE][-+]?\d+)?")
_LINE = re.compile(r"([0-9a-f]{64})  (.+)")


@dataclass(frozen=True)
class Verdict:
    """What became of one file: the same bytes, or in words what differs."""

    path: str
    same: bool
    difference: str = ""


def released_config(folder: Path) -> Config:
    """Return the config of a released result, as its ``summary.json`` tells it.

    Raises ValueError where the folder holds no result.
    """
    try:
        told = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["config"]
    except (OSError, ValueError, KeyError, TypeError) as error:
        why = f"its summary.json has no {error}" if isinstance(error, KeyError) else str(error)
        raise ValueError(
            f"{folder} holds no released result ({why}). Give a folder with summary.json and {SUMS}."
        ) from error
    return parse(_without_nulls(told), str(folder / "summary.json"), folder)


def _without_nulls(value: Any) -> Any:
    """Leave out what is not set, as a config file does."""
    if isinstance(value, dict):
        return {key: _without_nulls(item) for key, item in value.items() if item is not None}
    return [_without_nulls(item) for item in value] if isinstance(value, list) else value


def verify(folder: Path, config: Config | None, store: Store | None, warn: Callable[[str], None]) -> Iterator[Verdict]:
    """Run the config of the released result in ``folder`` again and yield a verdict for each file of its SHA256SUMS.

    ``config`` stands for the result's own, ``store`` for one of its own that is empty, so that all is computed. Yields
    also what the fresh run has and the release lacks, and released files that have been changed since. Raises ValueError
    where the folder holds no result, and what a run raises.
    """
    config = config or released_config(folder)
    expected = _sums(folder)
    with TemporaryDirectory() as place:
        result = run(config, store or Store(Path(place) / "artifacts"), Path(place) / "reports", warn)
        fresh = {path: (result.folder / path).read_bytes() for path in _sums(result.folder)}
    for path in sorted(set(expected) | set(fresh)):
        yield _verdict(folder, path, expected.get(path), fresh.get(path))


def _sums(folder: Path) -> dict[str, str]:
    try:
        lines = (folder / SUMS).read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise ValueError(
            f"{folder} holds no {SUMS} that can be read ({error}). Give the folder of a released result."
        ) from error
    matches = [_LINE.fullmatch(line) for line in lines]
    if not matches or not all(matches):
        raise ValueError(f"{folder / SUMS} has a line that is no SHA-256 and a path. Take it from the release again.")
    return {match[2]: match[1] for match in matches if match}


def _verdict(folder: Path, path: str, expected: str | None, fresh: bytes | None) -> Verdict:
    if expected is None:
        return Verdict(path, same=False, difference="the fresh run has it, the release does not")
    if fresh is None:
        return Verdict(path, same=False, difference="the release has it, the fresh run does not")
    same = sha256(fresh).hexdigest() == expected
    place = folder / path
    if not place.resolve().is_relative_to(folder.resolve()):
        return Verdict(path, same=False, difference="its path leads out of the folder")
    if not place.is_file():
        return Verdict(
            path, same=same, difference="" if same else "another sum, and the released file is not there to compare"
        )
    released = place.read_bytes()
    if sha256(released).hexdigest() != expected:
        told = "the released file is not the one of its sum"
        return Verdict(
            path, same=False, difference=told + ("" if same else f", and the fresh one {differences(released, fresh)}")
        )
    return Verdict(path, same=same, difference="" if same else differences(released, fresh))


def differences(released: bytes, fresh: bytes) -> str:
    """Say in words how two versions of a file differ, numbers compared as numbers."""
    if released[:2] == b"PK" and fresh[:2] == b"PK":
        return _arrays(released, fresh)
    try:
        one, other = released.decode(), fresh.decode()
    except UnicodeDecodeError:
        return f"differs in content ({len(released)} bytes, now {len(fresh)})"
    lines = one.splitlines(), other.splitlines()
    if len(lines[0]) != len(lines[1]):
        return f"differs in length: {len(lines[0])} lines, now {len(lines[1])}"
    changed = [(i, a, b) for i, (a, b) in enumerate(zip(*lines, strict=True), start=1) if a != b]
    if any(_NUMBER.sub("#", a) != _NUMBER.sub("#", b) for _, a, b in changed):
        i, a, b = next((i, a, b) for i, a, b in changed if _NUMBER.sub("#", a) != _NUMBER.sub("#", b))
        return f"differs in words: line {i} was {a.strip()[:60]!r}, now {b.strip()[:60]!r}"
    numbers = [
        (float(x), float(y)) for _, a, b in changed for x, y in zip(_NUMBER.findall(a), _NUMBER.findall(b), strict=True)
    ]
    unequal = [(x, y) for x, y in numbers if x != y]
    return (
        f"differs in {len(unequal)} numbers of {len(changed)} lines, the first at line {changed[0][0]}: {_largest(unequal)}"
    )


def _arrays(released: bytes, fresh: bytes) -> str:
    one, other = (dict(_members(data)) for data in (released, fresh))
    told = []
    for name in sorted(set(one) | set(other)):
        a, b = one.get(name), other.get(name)
        if a is None or b is None:
            told.append(f"{name} is in one of them alone")
        elif a.shape != b.shape or a.dtype != b.dtype:
            told.append(f"{name} was {a.dtype} {a.shape}, now {b.dtype} {b.shape}")
        elif a.dtype.kind in "iuf" and not np.array_equal(a, b):
            pairs = np.stack([a.ravel(), b.ravel()], axis=1).astype(np.float64)
            pairs = pairs[pairs[:, 0] != pairs[:, 1]]
            told.append(f"{name}: {len(pairs)} of {a.size} numbers, {_largest(pairs.tolist())}")
        elif a.dtype.kind not in "iuf" and not np.array_equal(a, b):
            told.append(f"{name} in words")
    return "differs: " + ("; ".join(told) or "in the archive alone")


def _members(data: bytes) -> Iterator[tuple[str, Any]]:
    with np.load(io.BytesIO(data), allow_pickle=False) as archive:
        for name in archive.files:
            yield name, archive[name]


def _largest(pairs: Any) -> str:
    """Say the largest change among pairs of numbers, absolutely and as a share of the larger one."""
    if not pairs:
        return "none in value"
    before, after = max(pairs, key=lambda pair: abs(pair[1] - pair[0]))
    share = max(abs(y - x) / max(abs(x), abs(y)) for x, y in pairs)
    return f"largest change {before:.6g} to {after:.6g}, at most {share:.2g} of a number"
