"""Rows of figures as text for people and CSV for programs."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping, Sequence
from pathlib import Path

from skylight_sh.store import atomic


def text(rows: Sequence[Mapping[str, object]]) -> str:
    """Return aligned columns, the first row's keys as heading."""
    cells = [list(rows[0]), *([cell(value) for value in row.values()] for row in rows)]
    widths = [max(len(row[i]) for row in cells) for i in range(len(cells[0]))]
    return "\n".join("  ".join(c.ljust(width) for c, width in zip(row, widths, strict=True)).rstrip() for row in cells)


def save(path: Path, rows: Sequence[Mapping[str, object]]) -> None:
    """Write the rows as CSV. Raises ValueError where a row has other columns than the first."""
    path.parent.mkdir(parents=True, exist_ok=True)
    out = io.StringIO()
    writer = csv.DictWriter(out, list(rows[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    atomic.write(path, out.getvalue().encode())


def cell(value: object) -> str:
    """Return a value for people: three digits of a float, nothing for None."""
    if value is None:
        return ""
    return f"{value:.3g}" if isinstance(value, float) else str(value)
