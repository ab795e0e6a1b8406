"""Evaluators as source files that a compiler and a debugger read as they are, and what an export makes of them.

They are written with the prefix ``skylight_sh_``. Lines ``#if SKYLIGHT_SH_HAS_..`` (or ``IS``, ``TAKES``; in JavaScript
``//#if``) to ``#endif`` stand for one kind of table; an export keeps what its table needs, without these lines.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Collection, Iterable, Iterator
from importlib.resources import files

PREFIX = "skylight_sh"
COLUMNS = 100

_CONDITION = re.compile(r"\s*(?://)?#if (!?)SKYLIGHT_SH_((?:HAS|IS|TAKES)_\w+)\s*$")
_OPENING, _MIDDLE, _END = (re.compile(rf"\s*(?://)?#{word}") for word in ("if", "else", "endif"))
# What a part asks for while it is read alone stands in an export already.
_INCLUDED = re.compile(r'#include "|#pragma once|import .* from "\./')


def part(path: str, features: Collection[str]) -> str:
    """Return the source ``path`` (``c/rows.h``) as a table of these ``features`` (``HAS_ROWS`` ..) needs it."""
    text = files(__name__).joinpath(path).read_text(encoding="utf-8")
    return "\n".join(_kept(text.splitlines(), features)).strip("\n") + "\n"


def _kept(lines: list[str], features: Collection[str]) -> Iterator[str]:
    # Of each open condition: whether it is one of features, and whether its lines are kept.
    open_: list[tuple[bool, bool]] = []
    for line in lines:
        found = _CONDITION.match(line)
        if found:
            open_.append((True, (found[2] in features) != (found[1] == "!")))
        elif _OPENING.match(line):
            open_.append((False, True))
        if _MIDDLE.match(line) and open_[-1][0]:
            open_[-1] = (True, not open_[-1][1])
            continue
        shown = all(kept for _, kept in open_) and not _INCLUDED.match(line)
        if _END.match(line):
            ours, _ = open_.pop()
            shown = shown and not ours
        if shown and not found:
            yield line


def renamed(text: str, prefix: str) -> str:
    """Return ``text`` with every name under ``prefix`` instead.

    >>> renamed("skylight_sh_weights SKYLIGHT_SH_BANDS", "sky")
    'sky_weights SKY_BANDS'
    """
    text = re.sub(rf"\b{PREFIX}_", f"{prefix}_", text)
    return re.sub(rf"\b{PREFIX.upper()}_", f"{prefix.upper()}_", text)


def commented(text: str) -> Iterator[str]:
    """Yield the lines of a comment."""
    yield from textwrap.wrap(f"/* {text} */", COLUMNS - 24, subsequent_indent="   ", break_on_hyphens=False)


def filled(items: Iterable[str], columns: int = 96) -> Iterator[str]:
    """Yield the lines of a list's items, as many a line as fit."""
    line = ""
    for item in items:
        if line and len(line) + len(item) + 3 > columns:
            yield f"    {line},"
            line = item
        else:
            line = f"{line}, {item}" if line else item
    yield f"    {line}"


def wrapped(text: str) -> str:
    """Return C text with lines of at most ``COLUMNS``, broken at blanks; directives go on behind a backslash."""
    out: list[str] = []
    directive = False
    for line in text.splitlines():
        directive = line.startswith("#") or (directive and out[-1].endswith("\\"))
        out += _broken(line, directive)
    return "\n".join(line.rstrip() for line in out) + "\n"


def _broken(line: str, directive: bool) -> Iterator[str]:
    indent = line[: len(line) - len(line.lstrip())]
    inside = line.lstrip().startswith(("/*", "* ", "//"))
    start = {"/*": " * " if not directive else "   ", "* ": "* ", "//": "// "}.get(line.lstrip()[:2], "    ")
    # What an #error says is one text.
    start = "" if line.startswith("#error") else start
    room = COLUMNS - (2 if directive else 0)
    while len(line) > COLUMNS:
        place = _place(line, room, len(indent) + len(start), whole=directive or inside)
        if (place < 0 or place > room) and len(indent) > 4 and not inside:
            # Rather to the left than too wide.
            line, indent = f"    {line.lstrip()}", ""
            continue
        if place < 0:
            break
        yield line[:place] + (" \\" if directive else "")
        line = f"{indent}{start}{line[place:].lstrip()}"
    yield line


def _place(line: str, room: int, least: int, *, whole: bool) -> int:
    """Return where a line ends: at a blank, else at a bracket, within ``room`` or as soon as may be; -1 nowhere.

    Not inside a string, unless the ``whole`` line is text or a directive.
    """
    quoted = False
    blanks, brackets = [], []
    for place, character in enumerate(line):
        quoted ^= character == '"'
        if place > least and (whole or not quoted):
            if character == " ":
                blanks.append(place)
            elif character == "[" or (line[place - 1] in "()" and (character.isalnum() or character == "_")):
                brackets.append(place)
    commas = [place for place in blanks if line[place - 1] == "," and not whole and room // 3 < place <= room]
    within = commas or [p for p in blanks if p <= room] or [p for p in brackets if p <= room]
    return within[-1] if within else min([*blanks, *brackets], default=-1)
