"""Every measured error as one tidy table, ``errors.csv``; ``references.csv`` has those that are their machine's."""

from __future__ import annotations

import csv as csv_files
import io
from collections.abc import Iterator, Mapping, Sequence
from itertools import chain
from typing import SupportsFloat

import numpy as np

from skylight_sh.report.report_data import Entry, ReportData
from skylight_sh.table.size import bytes_of, coefficients_of

Row = Mapping[str, str | int]

# A hundredth of the tightest budget that is asked for. Finer figures would hang on the last bits of who computed them.
_FINEST = 5e-7
_NOTE = "of the machine that fitted it: ill-conditioned, another one's last bits give other figures"


def rows(data: ReportData, entries: Sequence[Entry], *, sweep: bool) -> Iterator[Row]:
    """Yield one row a combination of table, bands, channel and L_min convention. Errors are fractions, angles radians.

    ``entries`` are named tables; ``sweep`` says whether the fit's own sweep over degrees comes before them.

    ``table`` is ``sweep`` for a fit with every coefficient kept, else a reference's or winner's name; ``dtype`` is the
    number type of coefficients and arithmetic, ``coefficients`` and ``bytes`` count those of the first ``bands`` bands of a
    sweep's fit, and all of a named table. Errors have four significant digits and none finer than 5e-7, places seven.
    """
    yield from chain(_sweep(data) if sweep else (), *(_entry(data, e) for e in entries))


def csv(data: ReportData) -> bytes:
    """Return the errors of the sweep and of every winner as CSV; they are the same bytes on every machine."""
    return _csv(rows(data, data.winners, sweep=True))


def references_csv(data: ReportData) -> bytes:
    """Return the errors of the fits shown for comparison as CSV.

    Raw monomials are so ill-conditioned that these hang on the last bits of the machine that fitted them.
    """
    return _csv({**row, "note": _NOTE} for row in rows(data, data.references, sweep=False))


def _csv(made: Iterator[Row]) -> bytes:
    first = next(made)
    out = io.StringIO()
    writer = csv_files.DictWriter(out, list(first), lineterminator="\n")
    writer.writeheader()
    writer.writerows(chain([first], made))
    return out.getvalue().encode()


def _sweep(data: ReportData) -> Iterator[Row]:
    sweep = data.sweep
    terms = np.prod(sweep.degrees + 1, axis=1).tolist()
    outputs = [data.harmonics.first(n).count for n in range(1, data.harmonics.bands + 1)]
    for c in range(len(data.conventions)):
        for i, kept in enumerate(terms):
            for channel, bands in np.ndindex(sweep.rel_l2.shape[1:]):
                coefficients = kept * outputs[bands] * len(data.light.channels)
                named = _named(data, "sweep", data.basis, sweep.degrees[i].tolist(), "float64", (c, channel, bands))
                at = (c, i, channel, bands)
                errors = _errors(data, (sweep.e_max[at], sweep.e_mean[at], sweep.rel_l2[at[1:]]), sweep.at[at].tolist())
                yield {**named, **errors, "coefficients": coefficients, "bytes": 8 * coefficients}


def _entry(data: ReportData, entry: Entry) -> Iterator[Row]:
    table = entry.table
    size = {"coefficients": coefficients_of(table), "bytes": bytes_of(table)}
    for at in np.ndindex(entry.e_mean.shape):
        named = _named(data, entry.name, table.spec.basis, table.degrees, str(table.dtype), at)
        errors = _errors(data, (entry.e_max[at], entry.e_mean[at], entry.rel_l2[at[1:]]), entry.at[at].tolist())
        yield {**named, **errors, **size}


def _named(
    data: ReportData, table: str, basis: str, degrees: Sequence[int], dtype: str, at: tuple[int, ...]
) -> dict[str, str | int]:
    """Return what a row is about; ``at`` are the places of its convention, channel and number of bands."""
    convention, channel, bands = at
    return {
        "table": table,
        "basis": basis,
        **{f"degree_{axis.name}": degree for axis, degree in zip(data.axes, degrees, strict=True)},
        "dtype": dtype,
        "bands": bands + 1,
        "channel": data.light.channels[channel],
        "l_min": data.conventions[convention],
    }


def _errors(data: ReportData, errors: Sequence[SupportsFloat], worst: Sequence[float]) -> dict[str, str]:
    """Return a row's ``errors``, E_max, E_mean and relative L2, and the values of the axes at the worst set."""
    return {
        name: f"{round(float(error) / _FINEST) * _FINEST:.4g}"
        for name, error in zip(("e_max", "e_mean", "rel_l2"), errors, strict=True)
    } | {f"{axis.name}_at_worst": f"{place:.7g}" for axis, place in zip(data.axes, worst, strict=True)}
