"""The page over all runs, ``reports/index.html``: what each is, which table it recommends, and what that costs.

It is written by every run, a cached one too, so that it is made of plain text: nothing is imported for it.
"""

from __future__ import annotations

import html
import json
import re
from dataclasses import dataclass
from pathlib import Path

_TEMPLATES = Path(__file__).resolve().parent / "templates"
# The title stands among the first letters of a page.
_TITLE = re.compile(r"<title>(.*?)</title>", re.DOTALL)
_HEAD = 20_000
_LEAD = "Runs beside this page: what each is, the table it recommends, its bytes, and its largest error (E_mean)."


@dataclass(frozen=True)
class Run:
    """A published run: its ``folder``'s name, its page's title, and its recommended table's name, bytes and E_mean."""

    folder: str
    title: str
    table: str
    bytes: int
    error: float


def runs(reports: Path) -> list[Run]:
    """Return what lies in ``reports``, by name; folders without a whole summary and page are left out."""
    found = (_run(folder) for folder in sorted(reports.iterdir()) if folder.is_dir())
    return [run for run in found if run]


def _run(folder: Path) -> Run | None:
    try:
        summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        with (folder / "index.html").open(encoding="utf-8") as file:
            page = file.read(_HEAD)
        row = next(row for row in summary["tables"] if row["name"] == summary["recommended"])
        told = _TITLE.search(page)
        title = html.unescape(told[1]).strip() if told else folder.name
        return Run(folder.name, title, str(row["name"]), int(row["bytes"]), float(row["e_mean"]))
    except (OSError, ValueError, KeyError, TypeError, StopIteration):
        return None


def page(found: list[Run]) -> bytes:
    """Return the page of these runs."""
    style, script = ((_TEMPLATES / name).read_text(encoding="utf-8") for name in ("style.css.j2", "sorting.js.j2"))
    heads = "".join(f'<th scope="col" aria-sort="none">{head}</th>' for head in ("run", "bytes", "error"))
    for head in ("recommended table", "what it is"):
        heads += f'<th scope="col" aria-sort="none" class="text">{head}</th>'
    body = "\n".join(_row(run) for run in found)
    return f"""<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Skylight-SH: all runs</title>
<style>
{style}</style>
</head>
<body>
<h1>All runs</h1>
<p class="lead">{_LEAD}</p>
<div class="scroll" tabindex="0" role="region" aria-label="All runs">
<table class="sortable">
<thead><tr>{heads}</tr></thead>
<tbody>
{body}
</tbody>
</table>
</div>
<script>
{script}</script>
</body>
</html>
""".encode()


def _row(run: Run) -> str:
    name, title, table = (html.escape(text) for text in (run.folder, run.title, run.table))
    place = html.escape(f"{run.folder}/index.html")
    error = f"{100 * run.error:.3g}"
    error = f"{float(error):.10f}".rstrip("0").rstrip(".") if "e-" in error else error
    return (
        f'<tr><th scope="row"><a href="{place}">{name}</a></th><td data-key="{run.bytes}">{run.bytes:,}</td>'
        f'<td data-key="{run.error:.6g}">{error} %</td><td class="text">{table}</td><td class="text">{title}</td></tr>'
    )
