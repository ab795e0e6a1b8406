"""Rows of figures as text for people and CSV for programs."""

from __future__ import annotations

import csv
from collections.abc import Mapping, Sequence
from pathlib import Path


def text(rows: Sequence[Mapping[str, object]]) -> str:
    """Return aligned columns, the first row's keys as heading."""
    cells = [list(rows[0]), *([cell(value) for value in row.values()] for row in rows)]
    widths = [max(len(row[i]) for row in cells) for i in range(len(cells[0]))]
    return "\n".join("  ".join(c.ljust(width) for c, width in zip(row, widths, strict=True)).rstrip() for row in cells)


def save(path: Path, rows: Sequence[Mapping[str, object]]) -> None:
    """Write the rows as CSV. Raises ValueError where a row has other columns than the first."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def cell(value: object) -> str:
    """Return a value for people: three digits of a float, nothing for None."""
    if value is None:
        return ""
    return f"{value:.3g}" if isinstance(value, float) else str(value)
