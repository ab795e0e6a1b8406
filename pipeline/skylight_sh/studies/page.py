"""Pages of measurements: sections of rows, each a table, a CSV and a picture."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from jinja2 import Environment, PackageLoader, StrictUndefined

from skylight_sh.store import atomic
from skylight_sh.studies import tabular

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Row = Mapping[str, object]


@dataclass(frozen=True)
class Section:
    """One measurement: ``name`` is its files' stem, ``text`` says what was tried and how to read it."""

    name: str
    title: str
    text: str
    rows: Sequence[Row]
    draw: Callable[[Sequence[Row]], Figure] | None = None


def publish(
    folder: Path,
    title: str,
    lead: str,
    sections: Sequence[Callable[[], Section | Sequence[Section]]],
    advance: Callable[[int, int], None],
) -> str:
    """Measure on one thread, then write ``index.html``, a CSV a section and its picture; return all sections as text."""
    from skylight_sh.report import style
    from skylight_sh.run.blas import one_thread

    measured: list[Section] = []
    with one_thread():
        for done, measure in enumerate(sections):
            advance(done, len(sections))
            found = measure()
            measured += [found] if isinstance(found, Section) else found
    advance(len(sections), len(sections))
    folder.mkdir(parents=True, exist_ok=True)
    shown = []
    # A section that measures nothing of this config has no rows.
    measured = [section for section in measured if section.rows]
    for section in measured:
        tabular.save(folder / f"{section.name}.csv", section.rows)
        if section.draw:
            atomic.write(folder / f"{section.name}.png", style.png(section.draw(section.rows)))
        columns = list(section.rows[0])
        cells = [[tabular.cell(row[c]) for c in columns] for row in section.rows]
        shown.append({"section": section, "columns": columns, "rows": cells})
    page = _TEMPLATES.get_template("measurements.html.j2").render(title=title, lead=lead, sections=shown)
    atomic.write(folder / "index.html", page.encode())
    parts = [f"{s.title}\n{tabular.text(s.rows)}\n" for s in measured]
    return "\n".join([*parts, f"page  {folder / 'index.html'}"])


_TEMPLATES = Environment(
    loader=PackageLoader("skylight_sh.studies"),
    undefined=StrictUndefined,
    autoescape=True,
    trim_blocks=True,
    lstrip_blocks=True,
)
