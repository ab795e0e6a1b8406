"""Mutants: one number, sign, operator or comparison changed, of Python code, templates and C in Python strings."""

from __future__ import annotations

import ast
import hashlib
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from . import text

# The numeric folders and modules, the templates, and the evaluators of other languages.
SOURCES = (
    *(
        f"pipeline/skylight_sh/{folder}/**/*.py"
        for folder in ("formula", "light", "sphere", "quadrature", "fit", "table", "probe", "scene", "export")
    ),
    "pipeline/skylight_sh/runtime.py",
    *(f"pipeline/skylight_sh/run/{name}.py" for name in ("config_axes", "config_surroundings", "from_config")),
    *(f"pipeline/skylight_sh/run/stages/{name}.py" for name in ("fit", "select", "origins", "truth")),
    *(f"pipeline/skylight_sh/report/{name}.py" for name in ("errors_csv", "ringing", "panorama")),
    "pipeline/skylight_sh/export/templates/*.j2",
    "pipeline/skylight_sh/export/evaluators/*/*",
)
# A generator of random inputs, and data of evaluators that no export reads: other numbers there change no result.
_NO_NUMERICS = ("fuzz.c.j2", "example.h", "example.mjs", "example.cs")
_C_IN_PYTHON = re.compile(r".*/(formula/printers|export/(c_data|c_formulas|c_header|shaders|shader_dialects))\.py")
# Widths and counts of digits of what is printed, for people.
_FORMATTING = {
    "about",
    "digits",
    "width",
    "indent",
    "figsize",
    "dpi",
    "precision",
    "threshold",
    "stacklevel",
    "maxsize",
    "timeout",
}
_CALLS_OF_TEXT = {"warn", "print", "warning", "TypeVar", "Field", "Path", "compile", "batch"}

_OPERATORS: dict[type[ast.operator], str] = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/"}
_COMPARISONS: dict[type[ast.cmpop], str] = {
    ast.Lt: "<",
    ast.LtE: "<=",
    ast.Gt: ">",
    ast.GtE: ">=",
    ast.Eq: "==",
    ast.NotEq: "!=",
}


@dataclass(frozen=True)
class Mutant:
    """``new`` in place of the bytes ``start`` to ``end`` of the file ``path`` (relative, with slashes).

    ``line`` counts from 1; ``before`` and ``after`` are that line without its indent; ``within`` is the function around it.
    ``lines``: first and last line of the statement, or of the whole function where its head is changed; ``names``: what a
    module's or class's statement defines; ``wide``: whether lines do not tell who runs it (constants, cached functions).
    """

    path: str
    start: int
    end: int
    new: str
    line: int
    before: str
    after: str
    within: str = ""
    lines: tuple[int, int] = (0, 0)
    names: tuple[str, ...] = ()
    wide: bool = True

    @property
    def key(self) -> tuple[str, str, str, str]:
        """What names it whatever stands around it."""
        return self.path, self.within, self.before, self.after

    def applied(self, source: bytes) -> bytes:
        """Return the changed file."""
        return source[: self.start] + self.new.encode() + source[self.end :]

    def __str__(self) -> str:
        return f"{self.path}:{self.line}\n    - {self.before}\n    + {self.after}"


def sources(root: Path) -> list[str]:
    """Return the files that mutants are made of, sorted."""
    found = {path.relative_to(root).as_posix() for pattern in SOURCES for path in root.glob(pattern)}
    return sorted(path for path in found if not path.endswith(("__init__.py", *_NO_NUMERICS)))


def mutants(root: Path, only: str = "") -> list[Mutant]:
    """Return all mutants of the files whose path begins with ``only``, in the order of files and places."""
    return [one for path in sources(root) if path.startswith(only) for one in of_file(path, (root / path).read_bytes())]


def draw(found: Sequence[Mutant], count: int, seed: int) -> list[Mutant]:
    """Return ``count`` mutants: those whose hashes with the seed are least, so that other files' changes move no draw."""
    seen: dict[tuple[str, ...], int] = {}
    ranked = []
    for one in found:
        seen[one.key] = seen.get(one.key, 0) + 1
        ranked.append((hashlib.sha256(repr((seed, one.key, seen[one.key])).encode()).digest(), one))
    drawn = sorted(ranked, key=lambda pair: pair[0])[:count]
    return sorted((one for _, one in drawn), key=lambda one: (one.path, one.start, one.new))


def of_file(path: str, source: bytes) -> list[Mutant]:
    """Return the mutants of one file's contents."""
    found = _Python(path, source).mutants() if path.endswith(".py") else _of_template(path, source)
    return sorted(found, key=lambda one: (one.start, one.new))


def _mutant(path: str, source: bytes, start: int, end: int, new: str) -> Mutant:
    first = source.rfind(b"\n", 0, start) + 1
    last = source.find(b"\n", end)
    last = len(source) if last < 0 else last
    before, after = source[first:last], source[first:start] + new.encode() + source[end:last]
    line = source.count(b"\n", 0, start) + 1
    return Mutant(path, start, end, new, line, before.decode().strip(), after.decode().strip())


def _of_template(path: str, source: bytes) -> Iterator[Mutant]:
    decoded = source.decode()
    for start, end, new in text.changes(decoded):
        place = len(decoded[:start].encode())
        yield _mutant(path, source, place, place + len(decoded[start:end].encode()), new)


class _Python:
    """The mutants of one Python module."""

    def __init__(self, path: str, source: bytes) -> None:
        self.path, self.source = path, source
        self.line_starts = [0, *(i + 1 for i, byte in enumerate(source) if byte == ord("\n"))]
        self.found: list[Mutant] = []
        self.functions: list[str] = []
        self.scope: tuple[tuple[int, int], tuple[str, ...], bool] = ((0, 0), (), True)
        self.c_strings = bool(_C_IN_PYTHON.fullmatch(path))

    def mutants(self) -> list[Mutant]:
        self._body(ast.parse(self.source).body, None)
        return self.found

    def _place(self, line: int, column: int) -> int:
        return self.line_starts[line - 1] + column

    def _span(self, node: ast.expr) -> tuple[int, int]:
        assert node.end_lineno is not None
        assert node.end_col_offset is not None
        return self._place(node.lineno, node.col_offset), self._place(node.end_lineno, node.end_col_offset)

    def _add(self, start: int, end: int, new: str) -> None:
        one = _mutant(self.path, self.source, start, end, new)
        lines, names, wide = self.scope
        self.found.append(
            Mutant(**{**vars(one), "within": ".".join(self.functions), "lines": lines, "names": names, "wide": wide})
        )

    def _body(self, body: Sequence[ast.stmt], cached: bool | None) -> None:
        """Visit statements; ``cached`` says whether the function around them is, and is None outside of functions."""
        for statement in body:
            self._statement(statement, cached)

    def _statement(self, node: ast.stmt, cached: bool | None) -> None:
        last = node.end_lineno or node.lineno
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            self.functions.append(node.name)
            self.scope = ((node.lineno, last), (), cached is None)
            inside: bool | None = None
            if isinstance(node, ast.FunctionDef):
                inside = bool(cached) or any("cache" in ast.unparse(one) for one in node.decorator_list)
                for default in [*node.args.defaults, *node.args.kw_defaults]:
                    self._expression(default)
            self._body(node.body, inside)
            self.functions.pop()
            return
        if isinstance(node, (ast.Raise, ast.Import, ast.ImportFrom, ast.Assert)):
            return
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            return
        names: tuple[str, ...] = ()
        if cached is None:
            targets = node.targets if isinstance(node, ast.Assign) else [getattr(node, "target", node)]
            names = tuple(one.id for target in targets for one in ast.walk(target) if isinstance(one, ast.Name))
        bodies = [part for field in ("body", "orelse", "finalbody") for part in getattr(node, field, [])]
        # The head of a compound statement, or all of a simple one.
        head = min((part.lineno for part in bodies), default=last + 1) - 1
        self.scope = ((node.lineno, max(head, node.lineno)), names, bool(cached) or cached is None)
        if isinstance(node, ast.AugAssign) and type(node.op) in _OPERATORS:
            self._operator(node.target, node.value, _OPERATORS[type(node.op)] + "=")
        for field, value in ast.iter_fields(node):
            if field not in ("annotation", "returns", "body", "orelse", "finalbody", "handlers"):
                for part in value if isinstance(value, list) else [value]:
                    self._expression(part)
        self._body(bodies, cached)
        for handler in getattr(node, "handlers", []):
            self._body(handler.body, cached)

    def _expression(self, node: object) -> None:
        """Visit an expression and all in it."""
        if not isinstance(node, ast.AST) or _for_people(node):
            return
        if isinstance(node, (ast.Constant, ast.JoinedStr)):
            self._literal(node)
        self._operations(node)
        if not isinstance(node, ast.JoinedStr):
            for child in ast.iter_child_nodes(node):
                if not _is_unknown_length(node, child):
                    self._expression(child)
        elif self.c_strings:
            for part in node.values:
                if isinstance(part, ast.FormattedValue):
                    self._formatted(part)

    def _operations(self, node: ast.AST) -> None:
        """Change what this node does, its parts aside."""
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
            start = self._span(node)[0]
            self._add(start, start + 1, "")
        if isinstance(node, ast.BinOp) and type(node.op) in _OPERATORS and not (_is_list(node.left) or _is_list(node.right)):
            self._operator(node.left, node.right, _OPERATORS[type(node.op)])
        if isinstance(node, ast.Compare):
            for left, op, right in zip([node.left, *node.comparators], node.ops, node.comparators, strict=False):
                if type(op) in _COMPARISONS and not (_is_list(left) or _is_list(right)):
                    self._operator(left, right, _COMPARISONS[type(op)])

    def _formatted(self, part: ast.FormattedValue) -> None:
        # Python 3.11 gives parts of strings places that may be wrong.
        start, end = self._span(part.value)
        if self.source[start:end].decode(errors="replace").strip("()") == ast.unparse(part.value).strip("()"):
            self._expression(part.value)

    def _operator(self, left: ast.expr, right: ast.expr, operator: str) -> None:
        start, end = self._span(left)[1], self._span(right)[0]
        between = re.sub(rb"#[^\n]*", lambda found: b" " * len(found[0]), self.source[start:end])
        place = start + between.index(operator.encode())
        for new in text.COMPARISONS.get(operator) or (text.OPPOSITE[operator],):
            self._add(place, place + len(operator), new)

    def _literal(self, node: ast.Constant | ast.JoinedStr) -> None:
        start, end = self._span(node)
        written = self.source[start:end].decode()
        if isinstance(node, ast.JoinedStr) or isinstance(node.value, str):
            plain = isinstance(node, ast.Constant)
            value = (
                node.value
                if isinstance(node, ast.Constant)
                else "".join(str(part.value) if isinstance(part, ast.Constant) else "{0}" for part in node.values)
            )
            if self.c_strings and text.is_c(str(value)):
                self._in_string(start, written, braces=not plain or ("{" in written and ";" not in written))
        elif not isinstance(node.value, (bool, complex)) and isinstance(node.value, (int, float)):
            self._add(start, end, text.other_number(written))

    def _in_string(self, start: int, written: str, *, braces: bool) -> None:
        # Several strings in a row are one to Python: quotes and prefixes become blanks.
        bare = re.sub(r'\b[rfbRFB]*("""|"|\'\'\'|\')', lambda found: " " * len(found[0]), written)
        for a, b, new in text.changes(bare, braces=braces):
            place = start + len(bare[:a].encode())
            self._add(place, place + len(bare[a:b].encode()), new)


def _for_people(node: ast.AST) -> bool:
    """Whether an expression is a message, a width of what is printed, or a type."""
    if isinstance(node, ast.Call):
        return _name(node.func) in _CALLS_OF_TEXT
    if isinstance(node, ast.Subscript):
        return _name(node.value) in ("Literal", "Annotated", "NDArray")
    return isinstance(node, ast.keyword) and node.arg in _FORMATTING


def _is_unknown_length(node: ast.AST, argument: ast.AST) -> bool:
    """Whether an argument is the -1 of reshape: NumPy takes any negative length for the one to be found."""
    return isinstance(node, ast.Call) and _name(node.func) == "reshape" and ast.unparse(argument) == "-1"


def _name(node: ast.expr) -> str:
    return node.id if isinstance(node, ast.Name) else node.attr if isinstance(node, ast.Attribute) else ""


def _is_list(node: ast.expr) -> bool:
    """Whether a value is text or a list: then + and * join and repeat, and == compares no numbers."""
    if isinstance(node, ast.BinOp):
        return _is_list(node.left) or _is_list(node.right)
    text_like = isinstance(node, ast.Constant) and isinstance(node.value, (str, bytes))
    return text_like or isinstance(node, (ast.JoinedStr, ast.List, ast.Tuple, ast.ListComp))
