"""What was found in a mesh, counted by part, as a sentence for people."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike


@dataclass(frozen=True)
class Finding:
    """Something in a ``part`` of a mesh that its owner should know: ``count`` times, ``healed`` or left as it is.

    ``kind`` is a short name that does not change, such as ``"zero area"``; ``sentence`` tells the part, the count and what
    was done or may be done.
    """

    part: str
    kind: str
    count: int
    healed: bool
    sentence: str


def by_part(names: Sequence[str], which: ArrayLike, kind: str, noun: str, done: str, *, healed: bool) -> tuple[Finding, ...]:
    """Return a finding for each part among ``which`` ``(n,)``, the indices in ``names`` of the parts of what was found.

    >>> found = by_part(["floor", "wall"], [1, 1], "zero area", "triangle/triangles without area", "removed", healed=True)
    >>> found[0].sentence
    "Part 'wall': 2 triangles without area, removed."
    """
    counts = np.bincount(np.asarray(which, dtype=np.int64), minlength=len(names))
    return tuple(
        Finding(names[i], kind, int(counts[i]), healed, f"Part {names[i]!r}: {counted(int(counts[i]), noun)}, {done}.")
        for i in np.flatnonzero(counts).tolist()
    )


def told(findings: Iterable[Finding], most: int = 3) -> list[str]:
    """Return what was found as sentences for people, one for all parts where a kind is in more than ``most`` of them.

    >>> found = by_part("abcd", [0, 1, 1, 2, 3], "zero area", "triangle/triangles without area", "removed", healed=True)
    >>> told(found)
    ["Part 'b': 2 triangles without area, removed. Likewise in 3 other parts, 5 in all."]
    """
    kinds: dict[str, list[Finding]] = {}
    for finding in findings:
        kinds.setdefault(finding.kind, []).append(finding)
    sentences = []
    for found in kinds.values():
        if len(found) <= most:
            sentences += [finding.sentence for finding in found]
        else:
            largest, total = max(found, key=lambda finding: finding.count), sum(finding.count for finding in found)
            sentences.append(f"{largest.sentence} Likewise in {len(found) - 1} other parts, {total:,} in all.")
    return sentences


def counted(count: int, noun: str) -> str:
    """Return a number and what it counts; ``noun`` begins with its singular and plural, parted by a slash.

    >>> counted(1, "edge/edges without a neighbour"), counted(1200, "edge/edges without a neighbour")
    ('1 edge without a neighbour', '1,200 edges without a neighbour')
    """
    word, _, rest = noun.partition(" ")
    one, _, many = word.partition("/")
    return f"{count:,} {one if count == 1 or not many else many}{' ' * bool(rest)}{rest}"
