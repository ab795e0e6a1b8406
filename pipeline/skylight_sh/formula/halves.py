"""A program in two, so that code which waits for the results of one part has something else to do before the other."""

from __future__ import annotations

from collections.abc import Mapping

from skylight_sh.runtime import Program

Step = tuple[str | int | float, ...]

_LEAVES = ("number", "constant", "input")
# How long a step's result takes, in those of a sum.
_WAITS: Mapping[str, int] = {"+": 1, "-": 1, "*": 1, "/": 4, "negative": 1}
_FUNCTION = 10


def halves(whole: Program) -> tuple[Program, Program]:
    """Return what is ready by half the time of ``whole``, and the rest of it over the inputs and the first's outputs.

    >>> from skylight_sh.formula.expression import trace
    >>> first, rest = halves(trace(lambda x: [(x * x + 1) * (x * x + 2) * x], ["x"]))
    >>> [float(value) for value in rest.run([3.0, *first.run([3.0])])]
    [330.0]
    """
    ready = _ready(whole)
    cut = max((ready[place] for place in whole.outputs), default=0) // 2
    early = [operation not in _LEAVES and ready[place] <= cut for place, (operation, *_) in enumerate(whole.steps)]
    used = {int(a) for place, step in enumerate(whole.steps) if _late(step, early[place]) for a in step[1:]}
    kept = [place for place, is_early in enumerate(early) if is_early and (place in used or place in whole.outputs)]
    labels = dict(whole.labels)
    first = Program(whole.inputs, whole.constants, whole.steps, tuple(kept), whole.labels)
    known: dict[int, int] = {}
    steps: list[Step] = []
    told: list[tuple[int, str]] = []
    for place, (operation, *arguments) in enumerate(whole.steps):
        if early[place] and place not in kept:
            continue
        if early[place]:
            steps.append(("input", len(whole.inputs) + kept.index(place)))
        elif operation in _LEAVES:
            steps.append((operation, *arguments))
        else:
            steps.append((operation, *(known[int(a)] for a in arguments)))
            told += [(len(steps) - 1, labels[place])] if place in labels else []
        known[place] = len(steps) - 1
    names = (*whole.inputs, *(f"early_{i}" for i in range(len(kept))))
    rest = Program(names, whole.constants, tuple(steps), tuple(known[place] for place in whole.outputs), tuple(told))
    return _needed(first), rest


def _late(step: Step, early: bool) -> bool:
    return step[0] not in _LEAVES and not early


def _ready(whole: Program) -> list[int]:
    """Return when each step's result is ready."""
    found: list[int] = []
    for operation, *arguments in whole.steps:
        if operation in _LEAVES:
            found.append(0)
        else:
            found.append(max(found[int(a)] for a in arguments) + _WAITS.get(str(operation), _FUNCTION))
    return found


def _needed(whole: Program) -> Program:
    """Return ``whole`` without the steps that no output needs."""
    needed = set(whole.outputs)
    for place in range(len(whole.steps) - 1, -1, -1):
        operation, *arguments = whole.steps[place]
        if place in needed and operation not in _LEAVES:
            needed |= {int(a) for a in arguments}
    known = {place: i for i, place in enumerate(sorted(needed))}
    steps = tuple(
        step if step[0] in _LEAVES else (step[0], *(known[int(a)] for a in step[1:]))
        for step in (whole.steps[place] for place in sorted(needed))
    )
    labels = tuple((known[place], word) for place, word in whole.labels if place in needed)
    return Program(whole.inputs, whole.constants, steps, tuple(known[place] for place in whole.outputs), labels)
