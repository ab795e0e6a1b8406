"""The parts of a header that lay out a fast table: passes over its rows, products of terms, and stores."""

from __future__ import annotations

from collections.abc import Callable

from pipeline.table.rows import Rows
from pipeline.table.table import Table

Number = Callable[[float], str]

_PASS = 4


def parts(table: Table, prefix: str, number: Number) -> dict[str, object]:
    """Return what the templates ``rows_body`` and ``rows_spread`` need of ``table``, whose body is ``Rows``."""
    body = table.body
    if not isinstance(body, Rows):
        raise TypeError(f"A table of layout {body.kind!r} has no rows.")
    terms, width = body.rows.shape
    starts = [int(body.lengths[:r].sum()) for r in range(body.lengths.size)]
    return {
        "numbers": [number(float(c)) for c in body.rows.ravel()],
        "terms": terms,
        "width": width,
        "widths": table.layout.widths,
        "passes": _passes(terms, width),
        "products": [
            {"start": start, "count": -(-int(n) // _PASS) * _PASS, "rest": r}
            for r, (start, n) in enumerate(zip(starts, body.lengths, strict=True))
            if n
        ],
        "stores": _stores(table, prefix),
    }


def _passes(terms: int, width: int) -> list[dict[str, object]]:
    """Return groups of equal passes: the first assigns, the others add."""
    first = min(_PASS, terms)
    whole, left = divmod(terms - first, _PASS)
    groups = [(first, 1, "="), (_PASS, whole, "+="), (left, 1, "+=")]
    return [
        {"terms": size, "repeats": repeats, "op": op, "sum": _sum(size, width)}
        for size, repeats, op in groups
        if size and repeats
    ]


def _sum(size: int, width: int) -> str:
    items = [f"p{q} * row[k + {q * width}]" if q else "p0 * row[k]" for q in range(size)]
    while len(items) > 1:
        items = [f"({items[q]} + {items[q + 1]})" if q + 1 < len(items) else items[q] for q in range(0, len(items), 2)]
    return items[0].removeprefix("(").removesuffix(")") if size > 1 else items[0]


def _stores(table: Table, prefix: str) -> list[list[str]]:
    """Return, for each band, the lines that store its columns: turned by the azimuth where m < 0 is not stored."""
    column = {place: k for k, place in enumerate(table.layout.places) if place}
    bands: list[list[str]] = []
    for l in range(table.bands):
        lines = []
        for c in range(len(table.channels)):
            middle = l * (l + 1)
            if not table.mirrored:
                start = column[l, c, -l]
                lines.append(f"for (i = 0; i < {2 * l + 1}; ++i) weights[{c}][{middle - l} + i] = (float)acc[{start} + i];")
                continue
            alone = (l + 1) % _PASS
            for m in range(alone):
                k = column[l, c, m]
                if m:
                    lines.append(f"weights[{c}][{middle - m}] = (float)(acc[{k}] * wave_sin[{m}]);")
                turn = f"(acc[{k}] * wave_cos[{m}])" if m else f"acc[{k}]"
                lines.append(f"weights[{c}][{middle + m}] = (float){turn};")
            for m in range(alone, l + 1, _PASS):
                k = column[l, c, m]
                to = f"weights[{c}] + {middle + m}, weights[{c}] + {middle - m - _PASS + 1}"
                lines.append(f"{prefix}_four(acc + {k}, wave_cos + {m}, wave_sin + {m}, {to});")
        bands.append(lines)
    return bands
