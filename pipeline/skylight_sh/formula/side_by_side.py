"""Programs whose equal formulas of different numbers become one formula of vectors, which a processor computes at once.

A program of this kind has two operations more: ``pack`` makes a vector of numbers, ``lane0`` to ``lane3`` take one out.
Sums and products of a number and a vector are those of each place. Nothing is rearranged: each place has the value that
the plain program gives it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from skylight_sh.runtime import Program

Step = tuple[str | int | float, ...]
Lanes = tuple[int, ...]

PACK = "pack"
_WIDTH = 4
_LANES = tuple(f"lane{k}" for k in range(_WIDTH))
_NUMBERS = ("number", "constant")
_LEAVES = (*_NUMBERS, "input")


def is_lane(operation: str | float) -> bool:
    """Say whether an operation takes a number out of a vector."""
    return operation in _LANES


def side_by_side(whole: Program, outputs: Sequence[Sequence[int]] = ()) -> Program:
    """Return ``whole`` with vectors where they save more operations than packing them costs.

    ``outputs`` are places in ``whole.outputs`` whose values become one vector; without them the outputs stay numbers.

    >>> from skylight_sh.formula.expression import trace
    >>> pair = trace(lambda x: [(2 * x + 3) * x, (4 * x + 5) * x], ["x"])
    >>> side_by_side(pair, [[0, 1]]).steps[:3]
    (('number', 2.0), ('number', 4.0), ('pack', 0, 1))
    """
    work = _Work(whole, _shapes(whole))
    asked = [tuple(whole.outputs[k] for k in group) for group in outputs]
    for lanes in asked:
        _mark(work, lanes)
    below = _below(whole)
    for lanes in _worthwhile(work.shapes, below):
        if not any(work.members.keys() & below[place] for place in lanes):
            _mark(work, lanes)
    found = [_wide(work, lanes) for lanes in asked] if asked else [_narrow(work, place) for place in whole.outputs]
    return Program(whole.inputs, whole.constants, tuple(work.steps), tuple(found), tuple(work.labels))


@dataclass
class _Work:
    """What is written: the new steps, and where numbers and vectors of the old ones stand among them."""

    whole: Program
    shapes: list[int]
    steps: list[Step] = field(default_factory=list)
    labels: list[tuple[int, str]] = field(default_factory=list)
    narrow: dict[int, int] = field(default_factory=dict)
    wide: dict[Lanes, int] = field(default_factory=dict)
    # Of each old step that is in a vector: which, and where in it.
    members: dict[int, tuple[Lanes, int]] = field(default_factory=dict)


def _shapes(whole: Program) -> list[int]:
    """Return a number for each step, the same for formulas that differ by their numbers alone."""
    known: dict[Step, int] = {}
    found: list[int] = []
    for operation, *arguments in whole.steps:
        if operation in _NUMBERS:
            shape: Step = ("number",)
        elif operation == "input":
            shape = (operation, *arguments)
        else:
            shape = (operation, *(found[int(a)] for a in arguments))
        found.append(known.setdefault(shape, len(known)))
    return found


def _below(whole: Program) -> list[frozenset[int]]:
    """Return of each step the operations that it needs, itself among them."""
    found: list[frozenset[int]] = []
    for place, (operation, *arguments) in enumerate(whole.steps):
        leaf = operation in _LEAVES
        found.append(frozenset() if leaf else frozenset({place}).union(*(found[int(a)] for a in arguments)))
    return found


def _worthwhile(shapes: Sequence[int], below: Sequence[frozenset[int]]) -> list[Lanes]:
    """Return the groups of equal formulas, those first that save most."""
    groups: dict[int, list[int]] = {}
    for place, shape in enumerate(shapes):
        groups.setdefault(shape, []).append(place)
    found = []
    for places in groups.values():
        for start in range(0, len(places), _WIDTH):
            lanes = tuple(places[start : start + _WIDTH])
            shared = frozenset.intersection(*(below[place] for place in lanes))
            saved = (len(lanes) - 1) * min(len(below[place] - shared) for place in lanes)
            # Each number that is taken out again costs about two operations.
            if saved > 2 * len(lanes):
                found.append((saved, lanes))
    return [lanes for _, lanes in sorted(found, key=lambda one: (-one[0], one[1]))]


def _mark(work: _Work, lanes: Lanes) -> None:
    for k, place in enumerate(lanes):
        work.members.setdefault(place, (lanes, k))
    for arguments in _arguments(work, lanes):
        if len(set(arguments)) > 1 and work.whole.steps[arguments[0]][0] not in _LEAVES:
            _mark(work, arguments)


def _arguments(work: _Work, lanes: Lanes) -> list[Lanes]:
    """Return the arguments of a vector's steps: vectors in turn."""
    steps = [work.whole.steps[place] for place in lanes]
    return [tuple(int(step[k]) for step in steps) for k in range(1, len(steps[0]))]


def _add(work: _Work, step: Step, label: str = "") -> int:
    work.steps.append(step)
    if label:
        work.labels.append((len(work.steps) - 1, label))
    return len(work.steps) - 1


def _narrow(work: _Work, place: int) -> int:
    """Return where the number of an old step stands."""
    if place not in work.narrow:
        operation, *arguments = work.whole.steps[place]
        if place in work.members:
            lanes, k = work.members[place]
            step: Step = (_LANES[k], _wide(work, lanes))
        elif operation in _LEAVES:
            step = (operation, *arguments)
        else:
            step = (operation, *(_narrow(work, int(a)) for a in arguments))
        label = "" if place in work.members else dict(work.whole.labels).get(place, "")
        work.narrow[place] = _add(work, step, label)
    return work.narrow[place]


def _wide(work: _Work, lanes: Lanes) -> int:
    """Return where the vector of old steps stands, or their number where they are one."""
    steps = [work.whole.steps[place] for place in lanes]
    operation = steps[0][0]
    if len(set(lanes)) == 1 or (operation in _LEAVES and len(set(steps)) == 1):
        return _narrow(work, lanes[0])
    if lanes not in work.wide:
        if operation in _LEAVES:
            step: Step = (PACK, *(_narrow(work, place) for place in lanes))
        else:
            step = (operation, *(_wide(work, arguments) for arguments in _arguments(work, lanes)))
        work.wide[lanes] = _add(work, step, dict(work.whole.labels).get(lanes[0], ""))
    return work.wide[lanes]
