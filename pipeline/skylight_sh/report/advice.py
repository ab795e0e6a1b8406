"""Which table to take, and how many of its bands to evaluate, under limits on bytes, time and error. Pure choosing."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from skylight_sh.report.amounts import count, nanoseconds, percent
from skylight_sh.report.published_tables import PublishedTable

# The limit on E_mean where none is given of bytes, time or error: what the default config's recommended table keeps to.
DEFAULT_ERROR = 0.001

# E_mean and E_max of a table over its first so many bands.
ByBands = Mapping[int, tuple[float, float]]


@dataclass(frozen=True)
class Limits:
    """What is asked for: at most ``bytes``, ``ns`` nanoseconds a call and ``error`` of E_mean; ``bands`` to be evaluated."""

    bytes: int | None = None
    ns: float | None = None
    error: float | None = None
    bands: int | None = None

    def filled(self) -> Limits:
        """Return these limits, with one on the error where nothing else would end the choice."""
        free = self.bytes is None and self.ns is None and self.error is None
        return Limits(error=DEFAULT_ERROR, bands=self.bands) if free else self


@dataclass(frozen=True)
class Offer:
    """A table of which the first ``bands`` are evaluated, and its errors over these; it keeps all its bytes."""

    table: PublishedTable
    bands: int
    e_mean: float
    e_max: float


@dataclass(frozen=True)
class Advice:
    """What to ``take``, or None and what comes ``nearest``, None where no table is there at all; ``why`` in sentences."""

    take: Offer | None
    nearest: Offer | None
    why: str


def advise(tables: Sequence[PublishedTable], errors: Sequence[ByBands], limits: Limits) -> Advice:
    """Return which of ``tables``, all of one sky, keeps to the ``limits``; ``errors`` are in the tables' order.

    Where no number of bands is asked for, as many as the limits allow come first. Of the tables left that of the fewest
    bytes is taken; where bytes or time are limited and the error is not, that of the least error.
    """
    limits = limits.filled()
    offers = [_offer(table, known, limits) for table, known in zip(tables, errors, strict=True)]
    if not offers:
        return Advice(None, None, "There is no table.")
    kept = [offer for offer in offers if not _missed(offer, limits)]
    if not kept:
        nearest = min(offers, key=lambda offer: _distance(offer, limits))
        return Advice(None, nearest, _why_none(offers, nearest, limits))
    take = min(kept, key=lambda offer: _rank(offer, limits))
    # What smaller ones would cost is told over the same bands.
    alike = [_offer(table, known, replace(limits, bands=take.bands)) for table, known in zip(tables, errors, strict=True)]
    return Advice(take, None, f"{_why(take, offers, kept, limits)} {_smaller(take, alike, limits)}".strip())


def _offer(table: PublishedTable, known: ByBands, limits: Limits) -> Offer:
    """Return a table with the bands asked for, or where they are free as many as the error allows, or else all it has."""
    if limits.bands is not None:
        bands = limits.bands if limits.bands in known else table.bands
    else:
        within = [n for n, (e_mean, _) in known.items() if limits.error is None or e_mean <= limits.error]
        bands = max(within, default=table.bands)
    return Offer(table, bands, *known[bands])


def _rank(offer: Offer, limits: Limits) -> tuple[float | str, ...]:
    table = offer.table
    bands = -offer.bands if limits.bands is None else 0
    cost = (table.bytes, offer.e_mean) if limits.error is not None else (offer.e_mean, table.bytes)
    return (bands, *cost, math.inf if table.ns is None else table.ns, table.run, table.name)


def _excess(offer: Offer, limits: Limits) -> Iterator[tuple[str, float]]:
    """Yield each limit's name and how many times an offer is over it; up to 1 it is kept."""
    table = offer.table
    if limits.bytes is not None:
        yield "bytes", table.bytes / limits.bytes
    if limits.ns is not None:
        yield "time", math.inf if table.ns is None else table.ns / limits.ns
    if limits.error is not None:
        yield "error", offer.e_mean / limits.error
    if limits.bands is not None:
        # Fewer bands than all, where it is not known how far off they are, are not what is asked for either.
        fewer = limits.bands / offer.bands
        yield "bands", fewer if fewer >= 1 else math.inf


def _missed(offer: Offer, limits: Limits) -> list[str]:
    return [name for name, times in _excess(offer, limits) if times > 1]


def _distance(offer: Offer, limits: Limits) -> tuple[float | str, ...]:
    """Return what an offer that misses limits is ranked by: the product of how many times it is over each."""
    over = math.prod(max(times, 1.0) for _, times in _excess(offer, limits))
    return (over, offer.table.bytes, offer.table.run, offer.table.name)


def _why(take: Offer, offers: Sequence[Offer], kept: Sequence[Offer], limits: Limits) -> str:
    least = "fewest bytes" if limits.error is not None else "least E_mean"
    alike = [offer for offer in kept if limits.bands is not None or offer.bands == take.bands]
    if len(kept) == 1:
        told = f"It is the only one of {len(offers)} tables that keeps to {words(limits)}." if len(offers) > 1 else ""
    elif len(alike) < len(kept):
        told = f"{len(kept)} of {len(offers)} tables keep to {words(limits)}; it has the most bands"
        told += f" and of the {len(alike)} that have them the {least}." if len(alike) > 1 else "."
    else:
        told = f"{len(kept)} of {len(offers)} tables keep to {words(limits)}; it has the {least}."
    return told


def _smaller(take: Offer, alike: Sequence[Offer], limits: Limits) -> str:
    """Return in words what the next smaller table than ``take`` costs; those ``alike`` have its bands where they can."""
    smaller = [offer for offer in alike if offer.table.bytes < take.table.bytes]
    if not smaller:
        return "None is smaller."
    # One that lacks bands tells least; of two that are equally small the better one.
    smaller = [offer for offer in smaller if offer.bands == take.bands] or smaller
    nearest = max(smaller, key=lambda offer: (offer.table.bytes, -offer.e_mean))
    missed = _missed(nearest, limits)
    beyond = f", over the limit on {' and '.join(missed)}" if missed else ""
    return f"The next smaller, {_named(nearest)} has {figures(nearest)}{beyond}."


def _why_none(offers: Sequence[Offer], nearest: Offer, limits: Limits) -> str:
    missed_by_all = [name for name, _ in _excess(nearest, limits) if all(name in _missed(o, limits) for o in offers)]
    best = {
        "bytes": lambda: f"{count(limits.bytes or 0)} bytes: the smallest has {count(min(o.table.bytes for o in offers))}",
        "time": lambda: _fastest(offers, limits),
        "error": lambda: f"an E_mean of {percent(limits.error or 0)}: the least is {percent(min(o.e_mean for o in offers))}",
        "bands": lambda: _most_bands(offers, limits),
    }
    if missed_by_all:
        told = f"No table keeps to {'; nor to '.join(best[name]() for name in missed_by_all)}."
    else:
        told = f"Each limit is kept by some table, but {words(limits)} together by none."
    return f"{told} {_named(nearest)} comes nearest: {figures(nearest)}."


def _fastest(offers: Sequence[Offer], limits: Limits) -> str:
    timed = [o.table.ns for o in offers if o.table.ns is not None]
    fastest = f"the fastest takes {nanoseconds(min(timed))}" if timed else "none was timed"
    return f"{nanoseconds(limits.ns or 0)}: {fastest}"


def _most_bands(offers: Sequence[Offer], limits: Limits) -> str:
    most = max(offer.table.bands for offer in offers)
    known = f"the most are {most}" if most < (limits.bands or 0) else "no errors.csv here tells how far off so many are"
    return f"{limits.bands} bands: {known}"


def words(limits: Limits) -> str:
    """Return limits in words.

    >>> words(Limits(bytes=2000, error=0.001, bands=5))
    '2,000 bytes, E_mean 0.1 % over 5 bands'
    """
    told = [f"{count(limits.bytes)} bytes"] if limits.bytes is not None else []
    told += [nanoseconds(limits.ns)] if limits.ns is not None else []
    told += [f"E_mean {percent(limits.error)}"] if limits.error is not None else []
    return ", ".join(told) + (f" over {limits.bands} bands" if limits.bands is not None else "")


def figures(offer: Offer) -> str:
    """Return in words what an offer costs and how far off it is."""
    table = offer.table
    every = " for all bands" if offer.bands < table.bands else ""
    time = f"{nanoseconds(table.ns)} a call{every}" if table.ns is not None else f"time unknown ({table.untimed})"
    return f"{count(table.bytes)} bytes, {time}, E_mean {percent(offer.e_mean)}, E_max {percent(offer.e_max)}"


def _named(offer: Offer) -> str:
    bands = offer.table.bands
    evaluated = f"{bands} bands" if offer.bands == bands else f"{offer.bands} of its {bands} bands"
    return f"{offer.table.title}, {evaluated},"


def unpacking(table: PublishedTable) -> str:
    """Return a sentence on what a packed table takes once it is unpacked; empty for others."""
    if table.layout != "packed":
        return ""
    timing = table.timing
    if timing and timing.unpack and timing.unpacked and timing.memory:
        return (
            f"{table.title} is packed, and each call decodes it; unpacked once, in {nanoseconds(timing.unpack)} into "
            f"{count(timing.memory)} bytes of memory, a call takes {nanoseconds(timing.unpacked)}."
        )
    return (
        f"{table.title} is packed, and each call decodes it, for longer than the sum takes: unpack it once if memory allows."
    )
