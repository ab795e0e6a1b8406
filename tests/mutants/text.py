"""Mutants of C and shader text: by a tokenizer that passes over comments, strings and template tags."""

from __future__ import annotations

import re
from collections.abc import Iterator

# (start, end, new text), places in the text.
Change = tuple[int, int, str]

_SKIPPED = r"""
    \{\#.*?\#\} | \{%.*?%\}                  # a template's comments and statements
  | /\*.*?\*/ | //[^\n]*                     # C's comments
  | (?P<tag>\{\{.*?\}\})                     # an expression of a template
  | "(?:\\.|[^"\\\n])*" | '(?:\\.|[^'\\\n])' # strings
  | \\.                                      # an escape, where the text stands in a Python string
  | ^[ \t]*\#[ \t]*(?:include|if|ifdef|ifndef|endif|else|undef)\b[^\n]*
"""
_TOKEN = re.compile(
    rf"""(?P<skip>{_SKIPPED})
  | (?P<size>(?<=[\w}}]\[)\d+(?=\]\s*[;,=)]))
  | (?P<number>(?<![\w.])(?:0x[0-9a-fA-F]+|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)(?P<suffix>[uUlLfF]*)(?![\w.]))
  | (?P<word>[A-Za-z_]\w*)
  | (?P<longer>\+\+|--|->|<<=?|>>=?|\*\*|\*=|/=)
  | (?P<sum>\+=?|-=?)
  | (?P<compare><=|>=|==|!=|<|>)
  | (?P<product>(?<=[ ])[*/](?=[ ]))""",
    re.VERBOSE | re.DOTALL | re.MULTILINE,
)
COMPARISONS = {"<": ("<=", ">="), "<=": ("<", ">"), ">": (">=", "<="), ">=": (">", "<"), "==": ("!=",), "!=": ("==",)}
OPPOSITE = {"+": "-", "-": "+", "*": "/", "/": "*", "+=": "-=", "-=": "+=", "*=": "/=", "/=": "*="}
# Generic types and headers hold brackets that compare nothing.
_GENERIC = {"ptr", "array", "vec2", "vec3", "vec4", "var", "include"}


def other_number(text: str) -> str:
    """Return a number's literal changed: whole ones by one, from 1000 doubled; others by 1 %, in powers of ten tenfold."""
    if re.fullmatch(r"0[xXbBoO][0-9a-fA-F_]+", text):
        return hex(int(text, 0) ^ 1)
    if re.fullmatch(r"[\d_]+", text):
        value = int(text)
        return str(2 * value if value >= 1000 else value + 1)
    number = float(text)
    if not number:
        return "1.0"
    # A power of ten is a tolerance or a unit: one per cent of it would be lost.
    factor = 10.0 if re.match(r"1(\.0*)?e", text.lower()) else 1.01
    return repr(float(f"{number * factor:.12g}"))


def changes(text: str, *, braces: bool = False) -> Iterator[Change]:
    """Yield the mutants of C or shader text. ``braces``: parts in ``{}`` belong to a Python format and are passed over."""
    held = [(m.start(), m.end()) for m in re.finditer(r"\{\{|\}\}|\{[^{}]*\}", text)] if braces else []
    held = [(start, end) for start, end in held if end - start != 2 or text[start:end] == "{}"]
    word = ""
    for token in _TOKEN.finditer(text):
        start, end = token.span()
        kind, found = token.lastgroup, token[0]
        if kind == "suffix":
            kind = "number"
        if any(a < end and start < b for a, b in held):
            continue
        before = text[:start].rstrip()[-1:]
        if token["tag"]:
            yield from _in_tag(found, start)
        elif kind == "number":
            bare = found[: len(found) - len(token["suffix"] or "")] if not found.startswith("0x") else found.rstrip("uUlL")
            yield start, end, other_number(bare) + found[len(bare) :]
        elif kind in ("sum", "product"):
            yield start, end, OPPOSITE[found]
        elif kind == "compare" and word not in _GENERIC and before not in ("", ">"):
            for other in COMPARISONS[found]:
                yield start, end, other
        word = found if kind == "word" else ""


def _in_tag(tag: str, start: int) -> Iterator[Change]:
    """Yield the mutants of the shader text that stands as strings inside a template's expression."""
    for string in re.finditer(r'"([^"]*)"', tag):
        # A lone name, type or separator is no formula.
        if re.search(r"\d\.\d|[+*<>]", string[1]):
            for a, b, new in changes(string[1]):
                yield start + string.start(1) + a, start + string.start(1) + b, new


def is_c(text: str) -> bool:
    """Whether a Python string is C or shader code, or numbers, rather than a name or a message."""
    code = re.sub(r"/\*.*?\*/|//[^\n]*", "", text)
    if ";" in code:
        return True
    prose = re.search(r"\b[a-z]{2,},? [a-z]{2,},? [a-z]{2,}|[A-Z][a-z]+ [a-z]{2,}|\w: \w", code)
    return not prose and bool(re.search(r"\bk\[|\w\[[^\]]*\]|[\w)}\]] [*+/-] [\w({]|\d\.\d", code))
