"""Formulas as values: the graph of arithmetic that a Python function of numbers becomes when it is called with symbols.

Formulas are written once, as such functions. Their graphs are kept as programs (``runtime.Program``), differentiated, and
printed by ``printers``.

Nothing is rearranged, so that every language adds and multiplies in the order of the Python function.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from skylight_sh.runtime import Program


@dataclass(frozen=True, eq=False, slots=True)
class Expression:
    """A node: ``operation`` of ``arguments``; a leaf is a ``number``, a ``constant`` or an ``input`` (its place, ``value``).

    Nodes are told apart by identity: one that is used twice is computed once. ``label`` names it where code is printed.
    """

    operation: str
    arguments: tuple[Expression, ...] = ()
    value: float = 0.0
    label: str = ""

    def __add__(self, other: Operand) -> Expression:
        """Return the sum; the literal 0 adds nothing."""
        return _sum(self, expression(other))

    def __radd__(self, other: float) -> Expression:
        """Return the sum."""
        return _sum(expression(other), self)

    def __sub__(self, other: Operand) -> Expression:
        """Return the difference."""
        return _difference(self, expression(other))

    def __rsub__(self, other: float) -> Expression:
        """Return the difference."""
        return _difference(expression(other), self)

    def __mul__(self, other: Operand) -> Expression:
        """Return the product; the literals 0 and 1 are carried out."""
        return _product(self, expression(other))

    def __rmul__(self, other: float) -> Expression:
        """Return the product."""
        return _product(expression(other), self)

    def __truediv__(self, other: Operand) -> Expression:
        """Return the quotient."""
        return _quotient(self, expression(other))

    def __rtruediv__(self, other: float) -> Expression:
        """Return the quotient."""
        return _quotient(expression(other), self)

    def __neg__(self) -> Expression:
        """Return the negative."""
        return self if _is(self, 0.0) else Expression("negative", (self,))


Operand = Expression | float
Formula = Callable[..., Sequence[Operand]]


def expression(value: Operand) -> Expression:
    """Return ``value`` as a node: a literal number where it is none.

    >>> expression(2).operation, expression(2).value
    ('number', 2.0)
    """
    return value if isinstance(value, Expression) else Expression("number", value=float(value))


def _is(node: Expression, number: float) -> bool:
    """Say whether ``node`` is the literal ``number``."""
    return node.operation == "number" and node.value == number


def _sum(a: Expression, b: Expression) -> Expression:
    return b if _is(a, 0.0) else a if _is(b, 0.0) else Expression("+", (a, b))


def _difference(a: Expression, b: Expression) -> Expression:
    return -b if _is(a, 0.0) else a if _is(b, 0.0) else Expression("-", (a, b))


def _product(a: Expression, b: Expression) -> Expression:
    if _is(a, 0.0) or _is(b, 0.0):
        return expression(0.0)
    return b if _is(a, 1.0) else a if _is(b, 1.0) else Expression("*", (a, b))


def _quotient(a: Expression, b: Expression) -> Expression:
    return a if _is(a, 0.0) or _is(b, 1.0) else Expression("/", (a, b))


def trace(formula: Formula, inputs: Sequence[str], constants: Sequence[float] = ()) -> Program:
    """Return the program of ``formula(*inputs, constants)``, a function of generic numbers that returns a sequence of them.

    ``constants`` are passed as a tuple, and left out where there are none.

    >>> trace(lambda x, k: [(x - k[0]) * k[1]], ["x"], [1.0, 2.0]).steps
    (('input', 0), ('constant', 0), ('-', 0, 1), ('constant', 1), ('*', 2, 3))
    """
    symbols = [Expression("input", value=place) for place in range(len(inputs))]
    numbers = tuple(Expression("constant", value=place) for place in range(len(constants)))
    outputs = formula(*symbols, numbers) if numbers else formula(*symbols)
    return program([expression(output) for output in outputs], inputs, constants)


def program(outputs: Sequence[Expression], inputs: Sequence[str], constants: Sequence[float] = ()) -> Program:
    """Return the graph of ``outputs`` as a list of steps, each of which uses earlier ones alone."""
    places: dict[Expression, int] = {}
    steps: list[tuple[str | int | float, ...]] = []
    labels: list[tuple[int, str]] = []
    for output in outputs:
        for node in _ordered(output, places):
            places[node] = len(steps)
            if node.label:
                labels.append((len(steps), node.label))
            if node.operation == "number":
                steps.append(("number", node.value))
            elif node.operation in ("input", "constant"):
                steps.append((node.operation, int(node.value)))
            else:
                steps.append((node.operation, *(places[argument] for argument in node.arguments)))
    return Program(
        tuple(inputs), tuple(map(float, constants)), tuple(steps), tuple(places[o] for o in outputs), tuple(labels)
    )


def _ordered(output: Expression, known: dict[Expression, int]) -> list[Expression]:
    """Return the nodes below ``output`` that are not ``known``, arguments first, without recursion's limit."""
    found: dict[Expression, None] = {}
    todo: list[tuple[Expression, bool]] = [(output, False)]
    while todo:
        node, ready = todo.pop()
        if node in known or node in found:
            continue
        if ready or not node.arguments:
            found[node] = None
            continue
        todo.append((node, True))
        todo.extend((argument, False) for argument in reversed(node.arguments))
    return list(found)


def expressions(program: Program, inputs: Sequence[Operand] | None = None) -> list[Expression]:
    """Return the outputs of ``program`` as graphs, over ``inputs`` where they are given: programs put one into another.

    Constants become literals where ``inputs`` are given, since another program would number them otherwise.

    >>> halved, doubled = trace(lambda x: [x / 2], ["x"]), trace(lambda x: [x * 2], ["x"])
    >>> program(expressions(doubled, expressions(halved)), ["x"]).steps
    (('input', 0), ('number', 2.0), ('/', 0, 1), ('number', 2.0), ('*', 2, 3))
    """
    labels = dict(program.labels)
    nodes: list[Expression] = []
    for place, (operation, *arguments) in enumerate(program.steps):
        if operation == "number":
            node = Expression("number", value=float(arguments[0]), label=labels.get(place, ""))
        elif operation == "constant":
            at = int(arguments[0])
            node = expression(program.constants[at]) if inputs else Expression("constant", value=at)
        elif operation == "input":
            at = int(arguments[0])
            node = expression(inputs[at]) if inputs else Expression("input", value=at)
        else:
            node = Expression(
                str(operation), tuple(nodes[int(argument)] for argument in arguments), label=labels.get(place, "")
            )
        nodes.append(node)
    return [nodes[place] for place in program.outputs]


def derivatives(program: Program, by: int) -> Program:
    """Return the program of the outputs' exact derivatives after input number ``by``; it shares the program's constants.

    >>> squared = trace(lambda x, y: [x * x * y], ["x", "y"])
    >>> float(derivatives(squared, 0).run([3.0, 5.0])[0])
    30.0
    """
    return _program_of(program, _slopes(expressions(program), by))


def with_derivatives(program: Program, by: Sequence[int]) -> Program:
    """Return the program of the outputs, then of their exact derivatives after each input of ``by`` in turn.

    >>> squared = trace(lambda x, y: [x * x * y], ["x", "y"])
    >>> [float(value) for value in with_derivatives(squared, [0, 1]).run([3.0, 5.0])]
    [45.0, 30.0, 9.0]
    """
    outputs = expressions(program)
    return _program_of(program, [*outputs, *(slope for place in by for slope in _slopes(outputs, place))])


def composed(outer: Program, inner: Sequence[Program]) -> Program:
    """Return the program of ``outer`` whose inputs are the first outputs of ``inner``, all over the same inputs.

    >>> shifted = trace(lambda x: [x + 1], ["x"])
    >>> float(composed(trace(lambda u: [u * u], ["u"]), [shifted]).run([2.0])[0])
    9.0
    """
    names = inner[0].inputs
    symbols = [Expression("input", value=place) for place in range(len(names))]
    return program(expressions(outer, [expressions(one, symbols)[0] for one in inner]), names)


def _slopes(outputs: Sequence[Expression], by: int) -> list[Expression]:
    known: dict[Expression, Expression] = {}
    for output in outputs:
        for node in _ordered(output, {}):
            if node not in known:
                known[node] = _slope(node, by, known)
    return [known[output] for output in outputs]


def _program_of(like: Program, outputs: Sequence[Expression]) -> Program:
    return program(outputs, like.inputs, like.constants)


def _slope(node: Expression, by: int, known: dict[Expression, Expression]) -> Expression:
    if not node.arguments:
        return expression(1.0 if node.operation == "input" and node.value == by else 0.0)
    return _slope_of(node, [known[argument] for argument in node.arguments])


def _slope_of(f: Expression, slopes: Sequence[Expression]) -> Expression:
    """Return the slope of the node ``f`` by those of its arguments."""
    if f.operation == "negative":
        return -slopes[0]
    if len(f.arguments) == 1:
        return _chain(f, f.arguments[0], slopes[0])
    (a, b), (da, db) = f.arguments, slopes
    rules = {
        "+": lambda: da + db,
        "-": lambda: da - db,
        "*": lambda: da * b + a * db,
        "/": lambda: da / b - f * db / b,
    }
    return rules[f.operation]()


def _chain(f: Expression, a: Expression, da: Expression) -> Expression:
    """Return the slope of the elementary function ``f`` of ``a``, whose slope is ``da``."""
    rules = {
        "log": lambda: da / a,
        "exp": lambda: da * f,
        "sin": lambda: da * Expression("cos", (a,)),
        "cos": lambda: -(da * Expression("sin", (a,))),
        "sqrt": lambda: da / (2.0 * f),
        "cbrt": lambda: da / (3.0 * (f * f)),
    }
    return rules[f.operation]()
