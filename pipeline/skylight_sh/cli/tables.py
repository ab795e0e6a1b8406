"""The command ``tables``: the tables of all runs side by side, two of them compared, and advice on which to take."""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from skylight_sh import UserError
from skylight_sh.cli import limits as amounts_given
from skylight_sh.cli import options, warn

if TYPE_CHECKING:
    from skylight_sh.report.advice import Advice, Limits
    from skylight_sh.report.published_tables import PublishedTable

KEYS = ("run", "table", "bands", "layout", "bytes", "ns", "e_mean", "e_max", "quantity", "path")
_NUMBERS = ("bands", "bytes", "ns", "e_mean", "e_max")


@click.command(
    epilog="""\b
Examples:
  skylight-sh tables                          every table of every run, the smallest first
  skylight-sh tables preetham --sort e_mean   of one run, the most exact first
  skylight-sh tables --compare preetham/7-bands-0.1pct preetham/7-bands-0.1pct-packed
  skylight-sh tables --max-bytes 2KB --max-error 0.1% --bands 5
  skylight-sh tables preetham --max-ns 200 --max-error 0.1%

Exit code of advice: 0 where a table keeps to the limits, 1 where none does; what comes nearest is told."""
)
@click.argument("runs", nargs=-1, metavar="[RUN ...]")
@options.reports
@click.option(
    "--sort", type=click.Choice(KEYS), default="bytes", show_default=True, help="Column that the list is sorted by."
)
@click.option(
    "--compare",
    nargs=2,
    metavar="A B",
    help="Compare two tables, each RUN/TABLE, RUN for its recommended one, or TABLE where one run has it.",
)
@click.option(
    "--max-bytes",
    callback=amounts_given.callback(
        amounts_given.size, "a size from 1 byte to 1,000,000,000, whole; give for example 2000 or 2KB (KB are 1,000 bytes)"
    ),
    metavar="SIZE",
    help="Advise: at most so many bytes, such as 2000 or 2KB.",
)
@click.option(
    "--max-ns",
    callback=amounts_given.callback(
        amounts_given.time, "a time from 1 to 1,000,000,000 nanoseconds; give for example 200 or 0.2us"
    ),
    metavar="TIME",
    help="Advise: at most so many nanoseconds a call, by a benchmark; a table not timed keeps to none.",
)
@click.option(
    "--max-error",
    callback=amounts_given.callback(
        amounts_given.error, "an error above 0 % and at most 100 %; give for example 0.1%, or the fraction 0.001"
    ),
    metavar="ERROR",
    help="Advise: an E_mean of at most so much, such as 0.1%; without % it is a fraction.",
)
@click.option(
    "--bands",
    type=click.IntRange(1, 64),
    metavar="N",
    help="Advise: evaluate so many bands, 1 to 64; without it, as many as the limits allow.",
)
@click.option("--quantity", type=click.Choice(("radiance", "irradiance")), help="Advise: weights of this alone.")
@click.option("--json", "as_json", is_flag=True, help="Print JSON instead of words.")
def tables(
    runs: tuple[str, ...],
    reports: Path,
    sort: str,
    compare: tuple[str, str] | None,
    max_bytes: int | None,
    max_ns: float | None,
    max_error: float | None,
    bands: int | None,
    quantity: str | None,
    as_json: bool,
) -> None:
    """List the tables of finished runs, compare two of them, or advise which to take.

    RUN is the name of a folder under reports/ that has a summary.json; all of them where none is named.

    Limits ask for advice: which table keeps to them, and how many of its bands to evaluate. Errors are over these bands,
    bytes the whole table's. Of the tables that keep to all limits that of the fewest bytes is taken; where the error has no
    limit, that of the least error. Bands or quantity alone ask for an E_mean of 0.1 %. Only tables of one sky over the same
    ranges can stand in for one another, so that each sky gets advice of its own.
    """
    from skylight_sh.report.advice import Limits

    wanted = any(given is not None for given in (max_bytes, max_ns, max_error, bands, quantity))
    if compare and (wanted or runs):
        raise UserError("--compare names its two tables itself. Leave out RUN and the limits, or --compare.")
    found = _read(_folders(reports, runs))
    if compare:
        _show_comparison([_pick(found, name) for name in compare], as_json)
    elif wanted:
        chosen = [table for table in found if quantity in (None, table.quantity)]
        if not chosen:
            raise click.ClickException(f"None of the {len(found)} tables is of {quantity}. Leave out --quantity.")
        _show_advice(chosen, Limits(max_bytes, max_ns, max_error, bands), as_json)
    else:
        _show_list(found, sort, as_json)


def _folders(reports: Path, runs: tuple[str, ...]) -> list[Path]:
    from skylight_sh.report import published_tables

    there = published_tables.folders(reports)
    if not there:
        raise UserError(f"{reports} holds no run. Make one, skylight-sh run preetham, or give --reports FOLDER.")
    known = {folder.name: folder for folder in there}
    missing = [run for run in runs if run not in known]
    if missing:
        raise UserError(f"{reports} holds no run {missing[0]!r}. Its runs are {', '.join(known)}.")
    return [known[run] for run in dict.fromkeys(runs)] if runs else there


def _read(folders: Sequence[Path]) -> list[PublishedTable]:
    """Return the tables of all runs that can be read; of the others their errors are told."""
    from skylight_sh.report import published_tables, timings

    released = timings.released()
    found = []
    for folder in folders:
        try:
            found += published_tables.read(folder, released)
        except UserError as error:
            warn(str(error))
    if not found:
        raise click.ClickException("No table is left to tell of.")
    return found


def _pick(found: Sequence[PublishedTable], name: str) -> PublishedTable:
    """Return the table that a name of the command line means."""
    fitting = [t for t in found if name in (t.title, t.name) or (t.recommended and name == t.run)]
    if len(fitting) != 1:
        told = "Several runs have" if fitting else "No run has"
        which = fitting or found
        raise UserError(f"{told} a table {name!r}. Give RUN/TABLE, one of: {', '.join(t.title for t in which)}.")
    return fitting[0]


def _record(table: PublishedTable) -> dict[str, Any]:
    """Return a table's row of the list, numbers as they are."""
    return {
        "run": table.run,
        "table": table.name,
        "bands": table.bands,
        "layout": table.layout,
        "bytes": table.bytes,
        "ns": table.ns,
        "e_mean": table.e_mean,
        "e_max": table.e_max,
        "quantity": table.unit,
        "path": table.folder.as_posix(),
    }


def _record_told(table: PublishedTable) -> dict[str, Any]:
    """Return a table's row for scripts: also what makes its run recommend it, its header's prefix, and who timed it."""
    more = {"recommended": table.recommended, "prefix": table.prefix, "machine": table.machine or None}
    return {**_record(table), **more, "untimed": table.untimed or None}


def _cells(table: PublishedTable) -> dict[str, str]:
    """Return a table's row of the list as it is shown."""
    from skylight_sh.report.amounts import count, percent

    shown = {key: str(value) for key, value in _record(table).items()}
    ns = count(table.ns) if table.ns is not None else f"- {table.untimed}"
    return {**shown, "bytes": count(table.bytes), "ns": ns, "e_mean": percent(table.e_mean), "e_max": percent(table.e_max)}


def _show_list(found: Sequence[PublishedTable], sort: str, as_json: bool) -> None:
    def place(table: PublishedTable) -> tuple[Any, ...]:
        value = _record(table)[sort]
        return (value is None, 0 if value is None else value, table.bytes, table.run, table.name)

    ordered = sorted(found, key=place)
    if as_json:
        click.echo(json.dumps({"tables": [_record_told(table) for table in ordered]}, indent=2))
        return
    for line in _aligned([{key: key for key in KEYS}, *map(_cells, ordered)]):
        click.echo(line)
    _show_machines(ordered)


def _aligned(rows: Sequence[Mapping[str, str]]) -> list[str]:
    """Return rows as lines of columns: numbers to the right, words to the left."""
    widths = {key: max(len(row[key]) for row in rows) for key in rows[0]}
    lines = []
    for row in rows:
        cells = (row[key].rjust(widths[key]) if key in _NUMBERS else row[key].ljust(widths[key]) for key in row)
        lines.append("  ".join(cells).rstrip())
    return lines


def _show_machines(found: Sequence[PublishedTable]) -> None:
    """Tell on which machine times are: one line, or one for the tables of each."""
    machines: dict[str, dict[str, None]] = {}
    for table in found:
        if table.machine:
            machines.setdefault(table.machine, {})[table.run] = None
    for machine, runs in machines.items():
        of = f" of {', '.join(runs)}" if len(machines) > 1 else ""
        click.echo(f"\nns{of}: a call, all bands; {machine}.")


def _show_comparison(pair: Sequence[PublishedTable], as_json: bool) -> None:
    from skylight_sh import runtime
    from skylight_sh.table import difference

    found, why = None, ""
    try:
        first, second = (runtime.read(table.folder / "skylight_sh.npz") for table in pair)
        why = difference.incomparable(first, second)
        found = None if why else difference.greatest(first, second)
    except (OSError, ValueError) as error:
        why = f"{error} Run its config again with the target npz."
    if as_json:
        record = {"tables": [_record_told(table) for table in pair], "difference": vars(found) if found else None}
        click.echo(json.dumps({**record, "why": why or None}, indent=2))
        return
    columns = [_cells(table) for table in pair]
    widths = [max(len(value) for value in column.values()) for column in columns]
    for key in KEYS:
        values = "  ".join(column[key].ljust(width) for column, width in zip(columns, widths, strict=True))
        click.echo(f"{key:<10}{values}".rstrip())
    _show_machines(pair)
    if not found:
        click.echo(f"\nWeights are not compared: {why.rstrip('.')}.")
        return
    at = ", ".join(f"{name} {value:.4g}" for name, value in found.at.items())
    click.echo(
        f"\nGreatest difference of a weight over {found.bands} bands on {found.sets:,} places: {found.greatest:.3g}, "
        f"{_percent(found.relative)} of the largest weight; {found.channel}, l = {found.l}, m = {found.m}, at {at}."
    )


def _percent(fraction: float) -> str:
    from skylight_sh.report.amounts import percent

    return percent(fraction)


def _show_advice(found: Sequence[PublishedTable], limits: Limits, as_json: bool) -> None:
    from skylight_sh.report import advice

    # Errors of two conventions cannot be compared either.
    skies: dict[tuple[str, ...], list[PublishedTable]] = {}
    for table in found:
        skies.setdefault((table.sky, table.quantity, table.convention), []).append(table)
    told = []
    for alike in skies.values():
        errors = _errors(alike)
        told.append((alike, advice.advise(alike, errors, limits)))
    if as_json:
        click.echo(json.dumps({"advice": [_advice_record(alike, given) for alike, given in told]}, indent=2))
    else:
        for i, (alike, given) in enumerate(told):
            _show_one(alike, given, first=i == 0)
        _show_machines([offer.table for _, given in told if (offer := given.take or given.nearest)])
    if not any(given.take for _, given in told):
        sys.exit(1)


def _errors(alike: Sequence[PublishedTable]) -> list[dict[int, tuple[float, float]]]:
    """Return each table's errors by its number of bands; all bands alone where a run's errors.csv is damaged."""
    from skylight_sh.report import published_tables

    by_run: dict[Path, list[PublishedTable]] = {}
    for table in alike:
        by_run.setdefault(table.reports / table.run, []).append(table)
    known: dict[tuple[str, str], dict[int, tuple[float, float]]] = {}
    for folder, held in by_run.items():
        try:
            known |= {(folder.name, name): each for name, each in published_tables.errors_by_bands(held, folder).items()}
        except UserError as error:
            warn(str(error))
            known |= {(folder.name, table.name): {table.bands: (table.e_mean, table.e_max)} for table in held}
    return [known[table.run, table.name] for table in alike]


def _advice_record(alike: Sequence[PublishedTable], given: Advice) -> dict[str, Any]:
    def offer(one: Any) -> dict[str, Any] | None:
        if one is None:
            return None
        return {**_record_told(one.table), "evaluate_bands": one.bands, "e_mean": one.e_mean, "e_max": one.e_max}

    runs = list(dict.fromkeys(table.run for table in alike))
    return {
        "runs": runs,
        "quantity": alike[0].unit,
        "sky": alike[0].sky_words,
        "take": offer(given.take),
        "nearest": offer(given.nearest),
        "why": given.why,
    }


def _show_one(alike: Sequence[PublishedTable], given: Advice, *, first: bool) -> None:
    from skylight_sh.report import advice

    runs = ", ".join(dict.fromkeys(table.run for table in alike))
    click.echo(f"{'' if first else chr(10)}{runs}: {alike[0].unit}, {alike[0].sky_words}")
    take = given.take
    if take:
        table = take.table
        fewer = take.bands < table.bands
        evaluate = f"evaluate {take.bands} of its {table.bands} bands" if fewer else f"evaluate all its {table.bands} bands"
        click.echo(f"  Take {table.title} and {evaluate}: {advice.figures(take)}.")
    click.echo(f"  {given.why}")
    about = take or given.nearest
    if about:
        words = advice.unpacking(about.table)
        if words:
            click.echo(f"  {words}")
        call = f"{about.table.prefix}_weights_bands(.., {about.bands}, ..)"
        fewer = about.bands < about.table.bands
        click.echo(f"  {about.table.folder.as_posix()}{f', in C {call}' if fewer else ''}")
