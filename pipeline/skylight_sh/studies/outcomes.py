"""What came out of measurements, in words that follow from their rows' own figures: no page claims what is not in it."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence

Rows = Sequence[Mapping[str, object]]

# An error that is so many times another's has broken; one within this share of it is as good.
_BROKEN, _AS_GOOD = 2.0, 1.1


def evaluation(rows: Rows) -> str:
    """Say which table is fastest, and by how much each build's tables beat the paper's scheme."""
    found = []
    for build in dict.fromkeys(str(row["build"]) for row in rows):
        mine = [row for row in rows if row["build"] == build and row["kind"] == "table"]
        if mine:
            best = min(mine, key=lambda row: _number(row["ns"]))
            ratios = _spoken(_numbers(mine, "times faster"))
            fastest = f"{best['table']} the fastest at {_three(best['ns'])} ns"
            found.append(f"{build}: {ratios} times as fast as paper-literal, {fastest}")
    return f"Tables laid out for speed, {'; '.join(found)}." if found else ""


def rivals(rows: Rows) -> str:
    """Say how often a rival wins in some build, and which kinds of rivals do."""
    lost = dict.fromkeys(_kind(str(row["rival"])) for row in rows if row["rival wins"])
    count = sum(bool(row["rival wins"]) for row in rows)
    return (
        f"In {count} of {len(rows)} pairs the rival is faster in some build{': ' if lost else ''}{', '.join(lost)}; rivals "
        f"read {_spoken(_numbers(rows, 'bytes'))} times as many bytes."
    )


def _kind(rival: str) -> str:
    """Return what a rival is, whatever table it is as exact as.

    >>> [_kind(name) for name in ("a-1pct: lookup 3 x 4, linear", "a-1pct: direct", "a-1pct", "paper-literal")]
    ['lookup tables, linear', 'direct', 'the fast table', 'paper-literal']
    """
    table, _, rest = rival.partition(": ")
    if rest.startswith("lookup"):
        return f"lookup tables, {rest.rpartition(', ')[2]}"
    return rest or ("the fast table" if "-bands-" in table or table.endswith("pct") else table)


def batches(rows: Rows) -> str:
    """Say what a batch gains over single calls."""
    found = []
    for suns in dict.fromkeys(str(row["suns"]) for row in rows):
        mine = [row for row in rows if row["suns"] == suns]
        found.append(f"{_spoken(_numbers(mine, 'times faster'))} times as fast as single calls for {suns}")
    return f"A batch is {', '.join(found)}."


def packed(rows: Rows) -> str:
    """Say how far packed streams are above their entropy."""
    over = [100 * value for value in _numbers(rows, "over")]
    return f"Streams are {_spoken(over)} % above the entropy of their own numbers." if over else ""


def profiles(rows: Rows) -> str:
    """Say what the cheapest profile saves."""
    first, least = rows[0], min(rows, key=lambda row: _number(row["ns"]))
    times, size = (_number(first[key]) / _number(least[key]) for key in ("ns", "bytes"))
    than = f"than '{first['profile']}'"
    return f"'{least['profile']}' takes {_three(times)} times less time and {_three(size)} times fewer bytes {than}."


def rules(rows: Rows) -> str:
    """Say which rule is the cheapest at each of three errors."""
    found = []
    for error in (1e-3, 1e-6, 1e-9):
        mine = [row for row in rows if _number(row["error"]) <= error]
        if mine:
            best = min(mine, key=lambda row: _number(row["ms"]))
            found.append(f"below {error:g} {best['rule']} ({_three(best['ms'])} ms)")
    return f"The cheapest rules: {'; '.join(found)}." if found else ""


def fits(rows: Rows) -> str:
    """Say which fit is the fastest of those about as exact as the best."""
    least = min(_numbers(rows, "E_mean"))
    good = [row for row in rows if _number(row["E_mean"]) <= _AS_GOOD * least]
    best = min(good, key=lambda row: _number(row["ms"]))
    return (
        f"{len(good)} of {len(rows)} fits are within a tenth of the least error, {_percent(least)}; the fastest of them is "
        f"'{best['fit']}' at {_three(best['ms'])} ms."
    )


def discs(rows: Rows) -> str:
    """Say what each scheme costs in operations."""
    counted = [row for row in rows if row["additions"] is not None]
    told = [f"{row['what']}: {row['additions']} + {row['multiplications']}" for row in counted]
    return f"Additions + multiplications of {'; '.join(told)}." if told else ""


def growth(rows: Rows) -> str:
    """Say by which power time grows, and how much memory from the least work to the most."""
    found = []
    for label in dict.fromkeys(str(row["grows"]) for row in rows):
        mine = [row for row in rows if row["grows"] == label]
        sizes = f"{_count(mine[0]['size'])} to {_count(mine[-1]['size'])} {label}"
        power = mine[0]["power"]
        time = f"CPU time grows as size to the power of {_number(power):.2f}, " if power is not None else ""
        found.append(f"{sizes}: {time}memory grows by {_three(mine[0]['growth MB'])} and {_three(mine[-1]['growth MB'])} MB")
    return f"{'; '.join(found)}."


def daylight(rows: Rows) -> str:
    """Say how many times as bright the model's sky, sun and sum are as the published ones, high and on the horizon."""
    published = {row["sun's height"]: row for row in rows if row["turbidity"] == "IES RP-21"}
    ours = [row for row in rows if row["turbidity"] != "IES RP-21"]
    found = []
    for words, low, high in (("on the horizon", 0, 0), ("from 30 degrees up", 30, 90)):
        parts: list[str] = []
        for key in ("sky", "sun", "both"):
            ratios = [
                _number(row[key]) / lit
                for row in ours
                if low <= _number(row["sun's height"]) <= high
                and (lit := _number(published[row["sun's height"]][key])) > 0.0
            ]
            parts += [f"{key} {_spoken(ratios)}"] if ratios else []
        found.append(f"{words}: {', '.join(parts)}")
    return f"Times as bright as IES RP-21 {'; '.join(found)}."


def bases(rows: Rows) -> str:
    """Say which fits break as the degree grows, in each number type."""
    found = []
    for dtype in ("float64", "float32"):
        broken = []
        for label in dict.fromkeys(str(row["fit"]) for row in rows):
            errors = [_number(row[f"E_mean {dtype}"]) for row in rows if row["fit"] == label]
            if not errors[-1] <= _BROKEN * min(errors):
                broken.append(label)
        found.append(f"in {dtype} by {_listed(broken) or 'none'}")
    return f"The highest degree errs more than twice as much as the best one {'; '.join(found)}."


def schemes(rows: Rows) -> str:
    """Say in which number types which fits err more than twice as much as in double precision."""
    found = []
    for bits in ("float32", "float16", "int16"):
        lost = [row for row in rows if not _number(row[bits]) <= _BROKEN * _number(row["float64"])]
        least = min((value for value in _numbers(rows, bits) if math.isfinite(value)), default=math.inf)
        names = _listed(dict.fromkeys(str(row["fit"]) for row in lost)) or "none"
        who = "every one" if len(lost) == len(rows) else names
        best = f", the best at {_percent(least)}" if math.isfinite(least) else ""
        found.append(f"{bits}: {who}{best}")
    return f"More than twice as far off as in double precision, by number type: {'; '.join(found)}."


def contraction(rows: Rows) -> str:
    """Say how far compilers' results are from the runtime's, with and without contraction."""
    columns = [key for key in rows[0] if key.endswith(": from the runtime")]
    told = [f"{key.partition(':')[0]} {max(_numbers(rows, key)):.1g}" for key in columns]
    worst = []
    for row in rows:
        errors = [_number(value) for key, value in row.items() if key.endswith(": E_mean")]
        worst.append(max(errors) / min(errors) - 1.0)
    return (
        f"Largest difference from the runtime, of the largest weight: {', '.join(told)}. A table's E_mean differs between "
        f"compilers by {_percent(max(worst))} of itself at most."
    )


def noise(rows: Rows) -> str:
    """Say between what each fit's amplification lies over all levels."""
    found = []
    for label in dict.fromkeys(str(row["fit"]) for row in rows):
        values = _numbers([row for row in rows if row["fit"] == label], "amplification")
        found.append(f"{label} {_spoken(values)}")
    return f"Amplification over all levels: {'; '.join(found)}."


def harmonics(rows: Rows) -> str:
    """Say how far the basis is off at the highest degree."""
    last = rows[-1]
    measures = ("orthonormal", "against mpmath", "against SciPy")
    told = [f"{key} {_number(last[key]):.1g}" for key in measures if last.get(key) is not None]
    return f"At l = {last['l']}: {', '.join(told)}."


def bands(rows: Rows) -> str:
    """Say where errors of both number types part, where they jump, and how far the rules are apart."""
    double, single = (_numbers(rows, f"E_mean {dtype}") for dtype in ("float64", "float32"))
    jump, at = max((b / a, int(_number(row["bands"]))) for a, b, row in zip(single, single[1:], rows[1:], strict=False))
    apart = max(s / d for s, d in zip(single, double, strict=True))
    rules_ = max(_numbers(rows, "rules apart"))
    return (
        f"The largest step of the error in float32 is {_three(jump)} times, from {at - 1} to {at} bands; it is there at "
        f"most {_three(apart)} times that in float64; both rules differ by {rules_:.1g} at most."
    )


def again(rows: Rows) -> str:
    """Say how many published errors hold on new sets."""
    ratios = _numbers(rows, "ratio")
    held = sum(ratio <= 1.0 for ratio in ratios)
    return f"{held} of {len(rows)} published errors hold; the largest ratio is {_three(max(ratios))}."


def smoothness(rows: Rows) -> str:
    """Say by how much errors jump at most."""
    worst = max(rows, key=lambda row: _number(row["error step"]))
    return f"The largest step of an error is {_percent(_number(worst['error step']))} of L_min ({worst['table']})."


def _number(value: object) -> float:
    return float(str(value))


def _numbers(rows: Rows, key: str) -> list[float]:
    return [_number(row[key]) for row in rows if row[key] is not None]


def _three(value: object) -> str:
    number = _number(value)
    return f"{number:,.0f}" if abs(number) >= 1000 else f"{number:.3g}"


def _count(value: object) -> str:
    return f"{int(_number(value)):,}"


def _percent(fraction: float) -> str:
    return f"{100 * fraction:.3g} %"


def _spoken(values: Sequence[float]) -> str:
    """Return the range of values in words.

    >>> _spoken([1.0, 2.5]), _spoken([3.0])
    ('1 to 2.5', '3')
    """
    low, high = (_two(value) for value in (min(values), max(values)))
    return low if low == high else f"{low} to {high}"


def _two(value: float) -> str:
    shown = float(f"{value:.2g}")
    return f"{shown:,.0f}" if 100 <= abs(shown) < 1e6 else f"{shown:.2g}".replace("e+", "e").replace("e0", "e")


def _listed(words: Iterable[str]) -> str:
    return ", ".join(f"'{word}'" for word in words)
