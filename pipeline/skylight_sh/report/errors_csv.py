"""Every measured error as one tidy table, ``errors.csv``; ``references.csv`` has those that are their machine's."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
import pandas as pd

from skylight_sh.report.report_data import Entry, ReportData
from skylight_sh.table.size import bytes_of, coefficients_of

# A hundredth of the tightest budget that is asked for. Finer figures would hang on the last bits of who computed them.
_FINEST = 5e-7


def frame(data: ReportData, entries: Sequence[Entry], *, sweep: bool) -> pd.DataFrame:
    """Return one row a combination of table, bands, channel and L_min convention. Errors are fractions, angles radians.

    ``entries`` are named tables; ``sweep`` says whether the fit's own sweep over degrees comes before them.

    ``table`` is ``sweep`` for a fit with every coefficient kept, else a reference's or winner's name; ``dtype`` is the
    number type of coefficients and arithmetic, ``coefficients`` and ``bytes`` count those of the first ``bands`` bands of a
    sweep's fit, and all of a named table.
    """
    parts = [_sweep(data)] if sweep else []
    return pd.concat([*parts, *(_entry(data, e) for e in entries)], ignore_index=True)


def csv(data: ReportData) -> bytes:
    """Return the errors of the sweep and of every winner as CSV; they are the same bytes on every machine."""
    return _csv(frame(data, data.winners, sweep=True))


def references_csv(data: ReportData) -> bytes:
    """Return the errors of the fits shown for comparison as CSV.

    Raw monomials are so ill-conditioned that these hang on the last bits of the machine that fitted them.
    """
    made = frame(data, data.references, sweep=False)
    made["note"] = "of the machine that fitted it: ill-conditioned, another one's last bits give other figures"
    return _csv(made)


def _csv(made: pd.DataFrame) -> bytes:
    """Write errors to four significant digits and no finer than ``_FINEST``, places to seven digits."""
    places = [name for name in made.columns if name.endswith("_at_worst")]
    made[places] = made[places].map("{:.7g}".format)
    errors = ["e_max", "e_mean", "rel_l2"]
    made[errors] = made[errors].map(lambda error: f"{round(error / _FINEST) * _FINEST:.4g}")
    return made.to_csv(index=False, lineterminator="\n").encode()


def _sweep(data: ReportData) -> pd.DataFrame:
    sweep = data.sweep
    terms = np.prod(sweep.degrees + 1, axis=1)
    outputs = np.array([data.harmonics.first(n).count for n in range(1, data.harmonics.bands + 1)])
    rows = []
    for c, convention in enumerate(data.conventions):
        combination, channel, bands = (i.ravel() for i in np.indices(sweep.rel_l2.shape))
        coefficients = terms[combination] * outputs[bands] * len(data.light.channels)
        rows.append(
            pd.DataFrame(
                {
                    "table": "sweep",
                    "basis": data.basis,
                    **{f"degree_{a.name}": sweep.degrees[combination, i] for i, a in enumerate(data.axes)},
                    "dtype": "float64",
                    "bands": bands + 1,
                    "channel": np.array(data.light.channels)[channel],
                    "l_min": convention,
                    "e_max": sweep.e_max[c].ravel(),
                    "e_mean": sweep.e_mean[c].ravel(),
                    "rel_l2": sweep.rel_l2.ravel(),
                    **{f"{a.name}_at_worst": sweep.at[c].reshape(-1, len(data.axes))[:, i] for i, a in enumerate(data.axes)},
                    "coefficients": coefficients,
                    "bytes": 8 * coefficients,
                }
            )
        )
    return pd.concat(rows, ignore_index=True)


def _entry(data: ReportData, entry: Entry) -> pd.DataFrame:
    return pd.DataFrame(list(_rows(data, entry)))


def _rows(data: ReportData, entry: Entry) -> Iterator[dict[str, object]]:
    table = entry.table
    for c, channel, bands in np.ndindex(entry.e_mean.shape):
        yield {
            "table": entry.name,
            "basis": table.spec.basis,
            **{f"degree_{a.name}": d for a, d in zip(table.axes, table.degrees, strict=True)},
            "dtype": str(table.dtype),
            "bands": bands + 1,
            "channel": data.light.channels[channel],
            "l_min": data.conventions[c],
            "e_max": entry.e_max[c, channel, bands],
            "e_mean": entry.e_mean[c, channel, bands],
            "rel_l2": entry.rel_l2[channel, bands],
            **{f"{a.name}_at_worst": entry.at[c, channel, bands, i] for i, a in enumerate(data.axes)},
            "coefficients": coefficients_of(table),
            "bytes": bytes_of(table),
        }
