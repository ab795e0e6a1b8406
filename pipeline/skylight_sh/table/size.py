"""How large a table is: every constant that its evaluation reads."""

from __future__ import annotations

import numpy as np

from skylight_sh.runtime import Packed, Table, unpack
from skylight_sh.table import packed, prefactor, twilight
from skylight_sh.table.row_layout import widths


def bytes_of(table: Table, bands: int | None = None) -> int:
    """Return the size of what the first ``bands`` bands read, or all: coefficients, lengths, axes, factor, numbers in code.

    A table of fewer bands is a prefix of this one; surroundings read all bands, whatever is asked for.

    >>> from skylight_sh.fit.axis import Axis
    >>> from skylight_sh.table import table as tables
    >>> spec = tables.specification([Axis("height", 0.0, 1.0)], ("luminance",), True, "chebyshev")
    >>> bytes_of(tables.whole(spec, np.ones((1, 1, 3)), 1, "float32"))  # 3 numbers, range and map, a length, a width
    30
    """
    spec, body, around = table.spec, table.body, table.surroundings
    bands = table.bands if around or bands is None else bands
    numbers = sum(2 + len(axis.variable.constants) for axis in spec.axes)
    numbers += twilight.NUMBERS if spec.twilight else 0
    numbers += around.transfer.size + around.own.size + around.below.size if around else 0
    factor = prefactor.bytes_of_factor(spec.scale, table.dtype.itemsize, packed=isinstance(body, Packed))
    if isinstance(body, Packed):
        degrees = np.sqrt(table.places[table.places < bands * bands]).astype(np.int64)
        part = body
        if bands < table.bands:
            part = packed.pack(unpack(body, table.places[: degrees.size]), degrees, body.step)
        # Beside stream and profiles, one byte a profile's entry, the step.
        stored = len(part.stream) + part.rest_profile.size + part.channel_profile.size
        return stored + factor + table.dtype.itemsize * (numbers + 1)
    columns = widths(spec, table.bands)
    read = len(body.rows) * columns[bands - 1] + numbers
    return read * table.dtype.itemsize + factor + body.lengths.nbytes + len(columns)


def coefficients_of(table: Table) -> int:
    """Return how many coefficients are kept, padding left out.

    >>> from skylight_sh.fit.axis import Axis
    >>> from skylight_sh.table import table as tables
    >>> spec = tables.specification([Axis("height", 0.0, 1.0)], ("luminance",), True, "chebyshev")
    >>> coefficients_of(tables.whole(spec, np.ones((1, 1, 3)), 1, "float32"))
    3
    """
    if isinstance(table.body, Packed):
        return int(np.count_nonzero(unpack(table.body, table.places)))
    return int(table.body.rows.size)
