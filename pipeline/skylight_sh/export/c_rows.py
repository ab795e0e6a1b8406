"""The parts of a header that lay out a fast table: its rows, products of terms, and stores."""

from __future__ import annotations

from collections.abc import Callable

from skylight_sh.runtime import Rows, Table
from skylight_sh.table.row_layout import layout

Number = Callable[[float], str]

_FOUR = 4


def parts(table: Table, prefix: str, number: Number) -> dict[str, object]:
    """Return what the template ``rows_body`` needs of ``table``, whose body is ``Rows``."""
    body = table.body
    if not isinstance(body, Rows):
        raise TypeError(f"A table of layout {body.kind!r} has no rows.")
    terms, width = body.rows.shape
    padded = -(-terms // _FOUR) * _FOUR
    starts = [int(body.lengths[:r].sum()) for r in range(body.lengths.size)]
    stores = _stores(table, prefix)
    return {
        "numbers": [number(float(c)) for c in body.rows.ravel()] + [number(0.0)] * ((padded - terms) * width),
        "terms": terms,
        # A last group of four with rows of zeros.
        "padded": padded,
        "width": width,
        "widths": layout(table.spec, table.bands).widths,
        "products": [
            {"start": start, "length": int(n), "count": -(-int(n) // _FOUR) * _FOUR, "rest": r}
            for r, (start, n) in enumerate(zip(starts, body.lengths, strict=True))
            if n
        ],
        "stores": stores,
        "loops": any(line.startswith("for (i") for lines in stores for line in lines),
    }


def _stores(table: Table, prefix: str) -> list[list[str]]:
    """Return, for each band, the lines that store its columns: turned by the azimuth where m < 0 is not stored."""
    column = {place: k for k, place in enumerate(layout(table.spec, table.bands).places) if place}
    bands: list[list[str]] = []
    for l in range(table.bands):
        lines = []
        for c in range(len(table.channels)):
            middle = l * (l + 1)
            if (l, c, 0) not in column:
                lines.append(f"for (i = 0; i < {2 * l + 1}; ++i) weights[{c}][{middle - l} + i] = 0.0f;")
                continue
            if not table.spec.mirrored:
                start = column[l, c, -l]
                lines.append(f"for (i = 0; i < {2 * l + 1}; ++i) weights[{c}][{middle - l} + i] = (float)acc[{start} + i];")
                continue
            alone = (l + 1) % _FOUR
            for m in range(alone):
                k = column[l, c, m]
                if m:
                    lines.append(f"weights[{c}][{middle - m}] = (float)(acc[{k}] * wave_sin[{m}]);")
                turn = f"(acc[{k}] * wave_cos[{m}])" if m else f"acc[{k}]"
                lines.append(f"weights[{c}][{middle + m}] = (float){turn};")
            for m in range(alone, l + 1, _FOUR):
                k = column[l, c, m]
                to = f"weights[{c}] + {middle + m}, weights[{c}] + {middle - m - _FOUR + 1}"
                lines.append(f"{prefix}_four(acc + {k}, wave_cos + {m}, wave_sin + {m}, {to});")
        bands.append(lines)
    return bands
