"""Pages of measurements: sections of rows, each a table, a CSV and a picture."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from jinja2 import ChoiceLoader, Environment, PackageLoader, StrictUndefined
from markupsafe import Markup, escape

from skylight_sh.store import atomic
from skylight_sh.studies import tabular

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from skylight_sh.report.cells import Cell

Row = Mapping[str, object]
# More rows than this are folded where a picture shows them.
_FOLDED = 16
# Fractions from here on are shown without exponents.
_PLAIN = 1e-3


@dataclass(frozen=True)
class Section:
    """One measurement: ``name`` is its files' stem, ``text`` says what was tried and how to read it.

    ``told`` says in a sentence or two what came out, of the rows' own figures.
    """

    name: str
    title: str
    text: str
    rows: Sequence[Row]
    draw: Callable[[Sequence[Row]], Figure] | None = None
    told: str = ""


def publish(
    folder: Path,
    title: str,
    lead: str,
    sections: Sequence[Callable[[], Section | Sequence[Section]]],
    advance: Callable[[int, int], None],
) -> str:
    """Measure on one thread, then write ``index.html``, a CSV a section and its picture; return all sections as text."""
    from skylight_sh.run.blas import one_thread

    measured: list[Section] = []
    with one_thread():
        for done, measure in enumerate(sections):
            advance(done, len(sections))
            found = measure()
            measured += [found] if isinstance(found, Section) else found
    advance(len(sections), len(sections))
    # A section that measures nothing of this config has no rows.
    measured = [section for section in measured if section.rows]
    write(folder, title, lead, measured)
    parts = [f"{s.title}\n{tabular.text(s.rows)}\n" for s in measured]
    return "\n".join([*parts, f"page  {folder / 'index.html'}"])


def write(folder: Path, title: str, lead: str, sections: Sequence[Section]) -> None:
    """Write ``index.html``, a CSV a section and its picture; every section has rows."""
    from skylight_sh.report import style

    folder.mkdir(parents=True, exist_ok=True)
    shown = []
    for section in sections:
        tabular.save(folder / f"{section.name}.csv", section.rows)
        size = None
        if section.draw:
            figure = section.draw(section.rows)
            atomic.write(folder / f"{section.name}.png", style.png(figure))
            size = style.shown(figure)
        columns = list(section.rows[0])
        rows = [[shown_cell(row[column]) for column in columns] for row in section.rows]
        words = [not any(row[place].sort for row in rows) for place in range(len(columns))]
        told = " ".join(part for part in (section.told, verdict(section.rows)) if part)
        folded = size is not None and len(rows) > _FOLDED
        shown.append(
            {
                "section": section,
                "text": marked(section.text),
                "columns": list(zip(columns, words, strict=True)),
                "rows": rows,
                "size": size,
                "told": told,
                "folded": folded,
            }
        )
    page = _TEMPLATES.get_template("measurements.html.j2").render(title=title, lead=lead, sections=shown)
    atomic.write(folder / "index.html", page.encode())


def verdict(rows: Sequence[Row]) -> str:
    """Return in words how many rows hold and how many are noisy, where rows tell; nothing where they do not.

    >>> verdict([{"holds": "yes"}, {"holds": "no"}])
    '1 of 2 rows do not hold.'
    >>> verdict([{"noisy": ""}, {"noisy": ""}])
    'None of 2 rows is noisy.'
    """
    found = []
    if "holds" in rows[0]:
        broken = sum(row["holds"] != "yes" for row in rows)
        what = ", and the answer to each stands beside it" if "answer" in rows[0] else ""
        found.append(f"{broken} of {len(rows)} rows do not hold{what}." if broken else f"All {len(rows)} rows hold.")
    if "noisy" in rows[0]:
        noisy = sum(bool(row["noisy"]) for row in rows)
        found.append(f"{noisy or 'None'} of {len(rows)} rows {'is' if noisy < 2 else 'are'} noisy.")
    return " ".join(found)


def marked(text: str) -> Markup:
    """Return a text as HTML, what stands between backticks as code.

    >>> str(marked("`a < b` holds"))
    '<code>a &lt; b</code> holds'
    """
    parts = enumerate(text.split("`"))
    return Markup("").join(Markup("<code>{}</code>").format(part) if place % 2 else escape(part) for place, part in parts)


def shown_cell(value: object) -> Cell:
    """Return a row's value as the page shows and sorts it: numbers to three digits, a dash where there is none.

    >>> [shown_cell(value).text for value in (12345, 0.0123, 1.5e-16, None, "", "yes", float("inf"))]
    ['12,345', '0.0123', '1.5e-16', '-', '-', 'yes', 'overflow']
    """
    from skylight_sh.report.amounts import plain
    from skylight_sh.report.cells import Cell, number

    if isinstance(value, bool) or not isinstance(value, int | float):
        return Cell("-" if value is None or value == "" else str(value))
    if not math.isfinite(value):
        return Cell("overflow")
    if isinstance(value, int):
        return number(value)
    if value == 0 or _PLAIN <= abs(value) < 1e6:
        return Cell(plain(value), value)
    return Cell(f"{value:.3g}".replace("e+", "e").replace("e-0", "e-").replace("e0", "e"), value)


_TEMPLATES = Environment(
    loader=ChoiceLoader([PackageLoader("skylight_sh.studies"), PackageLoader("skylight_sh.report")]),
    undefined=StrictUndefined,
    autoescape=True,
    trim_blocks=True,
    lstrip_blocks=True,
)
