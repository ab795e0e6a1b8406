"""Programs printed as statements of a language, in the order of their steps: nothing is rearranged."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from skylight_sh.formula.side_by_side import PACK, is_lane
from skylight_sh.runtime import Program

_ATOM, _NEGATIVE = 4, 3
_SIZES = {2: "pair", 3: "triple", 4: "quadruple"}
_PRECEDENCE = {"+": 1, "-": 1, "*": 2, "/": 2}


@dataclass(frozen=True)
class Language:
    """How a language writes numbers, functions (formats over ``x``) and the declaration of a local that never changes."""

    number: Callable[[float], str]
    functions: Mapping[str, str]
    declare: Callable[[str, str], str]
    vectors: Vectors | None = None


@dataclass(frozen=True)
class Vectors:
    """How a language writes vectors: ``inputs`` says whether the inputs are some.

    ``pack`` is a format over ``{size}`` (pair ..) and ``{numbers}``, ``spread`` one over a number ``{x}``; ``declare`` is
    as that of numbers, ``keep`` stores a vector.
    """

    inputs: bool
    declare: Callable[[str, str], str]
    pack: str = "{numbers}"
    spread: str = "{x}"
    keep: Callable[[str, str], str] = "{} = {};".format


def pointed(text: str) -> str:
    """Add the point without which a number is a whole one.

    >>> pointed("3"), pointed("3e5")
    ('3.0', '3e5')
    """
    return text if any(c in text for c in ".en") else text + ".0"


def single(value: float) -> str:
    """Return a float32 in nine digits, which give it back.

    >>> single(0.1), single(2.0)
    ('0.100000001', '2.0')
    """
    return pointed(f"{float(np.float32(value)):.9g}")


def double(value: float) -> str:
    """Return a float64 in seventeen digits, which give it back.

    >>> double(0.1)
    '0.10000000000000001'
    """
    return pointed(f"{value:.17g}")


_C_FUNCTIONS = ("log", "exp", "sin", "cos", "sqrt", "cbrt")
C_SINGLE = Language(
    number=lambda value: single(value) + "f",
    functions={name: f"{name}f({{x}})" for name in _C_FUNCTIONS},
    declare=lambda name, value: f"const float {name} = {value};",
)
C_DOUBLE = Language(
    number=double,
    functions={name: f"{name}({{x}})" for name in _C_FUNCTIONS},
    declare=lambda name, value: f"const double {name} = {value};",
)
C_FOUR = replace(
    C_SINGLE,
    vectors=Vectors(
        inputs=False,
        declare=lambda name, value: f"const skylight_sh_four {name} = {value};",
        pack="skylight_sh_{size}({numbers})",
        spread="skylight_sh_spread_four({x})",
        keep=lambda target, value: f"skylight_sh_keep({target}, {value});",
    ),
)
"""Single precision, with vectors of four beside numbers."""
C_SUNS = replace(
    C_SINGLE,
    functions={name: f"skylight_sh_{name}_suns({{x}})" for name in _C_FUNCTIONS},
    vectors=Vectors(
        inputs=True,
        declare=lambda name, value: f"const skylight_sh_lanes {name} = {value};",
        spread="skylight_sh_spread({x})",
    ),
)
"""Single precision, a vector of suns instead of each number."""
JAVASCRIPT = Language(
    number=double,
    functions={name: f"Math.{name}({{x}})" for name in _C_FUNCTIONS},
    declare=lambda name, value: f"const {name} = {value};",
)
CSHARP_SINGLE = Language(
    number=C_SINGLE.number,
    functions={name: f"MathF.{name.capitalize()}({{x}})" for name in _C_FUNCTIONS},
    declare=lambda name, value: f"float {name} = {value};",
)
CSHARP_DOUBLE = Language(
    number=double,
    functions={name: f"Math.{name.capitalize()}({{x}})" for name in _C_FUNCTIONS},
    declare=lambda name, value: f"double {name} = {value};",
)


def statements(program: Program, language: Language, inputs: Sequence[str]) -> tuple[list[str], list[str]]:
    """Return the declarations of what is used twice or has a label, and the outputs as expressions over ``inputs``.

    >>> from skylight_sh.formula.expression import trace
    >>> statements(trace(lambda v, k: [(v - k[0]) * k[1] - 1], ["v"], [0.5, 2.0]), C_SINGLE, ["v"])
    ([], ['(v - 0.5f) * 2.0f - 1.0f'])
    """
    lines, texts = _printed(program, language, inputs, {})
    return lines, [texts[place][0] for place in program.outputs]


def assignments(program: Program, language: Language, inputs: Sequence[str], targets: Sequence[str]) -> list[str]:
    """Return the statements that give each of ``targets`` its output; later outputs read earlier targets.

    >>> from skylight_sh.formula.expression import trace
    >>> assignments(trace(lambda u: [u, 2 * u], ["u"]), C_SINGLE, ["u"], ["t[0]", "t[1]"])
    ['t[0] = u;', 't[1] = 2.0f * t[0];']
    """
    named: dict[int, str] = {}
    for place, target in zip(program.outputs, targets, strict=True):
        named.setdefault(place, target)
    lines, texts = _printed(program, language, inputs, named)
    # What is a plain input or stands twice among the outputs.
    lines += [
        f"{target} = {texts[place][0]};"
        for place, target in zip(program.outputs, targets, strict=True)
        if named[place] != target
    ]
    return lines


def declarations(program: Program, language: Language, inputs: Sequence[str], names: Sequence[str]) -> list[str]:
    """Return the statements that declare each output under its name; outputs are different steps, none an input.

    >>> from skylight_sh.formula.expression import trace
    >>> declarations(trace(lambda x: [x * x], ["x"]), C_SINGLE, ["x"], ["square"])
    ['const float square = x * x;']
    """
    return _printed(program, language, inputs, dict(zip(program.outputs, names, strict=True)), language.declare)[0]


def _assigned(target: str, text: str) -> str:
    return f"{target} = {text};"


def _printed(
    program: Program,
    language: Language,
    inputs: Sequence[str],
    targets: Mapping[int, str],
    write: Callable[[str, str], str] = _assigned,
) -> tuple[list[str], list[tuple[str, int]]]:
    used = Counter(int(place) for step in program.steps if _is_node(step) for place in step[1:])
    labels, taken = dict(program.labels), Counter[str]()
    vectors = language.vectors
    wide = _wide(program, vectors) if vectors else [False] * len(program.steps)
    lines: list[str] = []
    # Text and precedence of every step.
    texts: list[tuple[str, int]] = []
    for place, step in enumerate(program.steps):
        text, precedence = _text(step, program, language, inputs, texts)
        if vectors and place in targets:
            if _is_node(step):
                name = _named(labels.get(place, "part"), taken)
                lines.append((vectors.declare if wide[place] else language.declare)(name, text))
                text, precedence = name, _ATOM
            lines.append(vectors.keep(targets[place], text if wide[place] else vectors.spread.format(x=text)))
        elif place in targets:
            lines.append(write(targets[place], text))
            text, precedence = targets[place], _ATOM
        elif _is_node(step) and (used[place] > 1 or place in labels):
            name = _named(labels.get(place, "part"), taken)
            lines.append((vectors.declare if vectors and wide[place] else language.declare)(name, text))
            text, precedence = name, _ATOM
        texts.append((text, precedence))
    return lines, texts


def _named(name: str, taken: Counter[str]) -> str:
    """Return a name that is not ``taken`` yet: numbered, but for the first of a label."""
    taken[name] += 1
    return name if name != "part" and taken[name] == 1 else f"{name}_{taken[name]}"


def _wide(program: Program, vectors: Vectors) -> list[bool]:
    """Say of each step whether its value is a vector."""
    found: list[bool] = []
    for operation, *arguments in program.steps:
        if operation in ("number", "constant", "input"):
            found.append(operation == "input" and vectors.inputs)
        else:
            found.append(operation == PACK or (not is_lane(operation) and any(found[int(a)] for a in arguments)))
    return found


def _is_node(step: tuple[str | int | float, ...]) -> bool:
    return step[0] not in ("number", "constant", "input")


def _text(
    step: tuple[str | int | float, ...],
    program: Program,
    language: Language,
    inputs: Sequence[str],
    texts: Sequence[tuple[str, int]],
) -> tuple[str, int]:
    operation, *arguments = step
    if operation == "input":
        return inputs[int(arguments[0])], _ATOM
    if operation in ("number", "constant"):
        value = float(arguments[0]) if operation == "number" else program.constants[int(arguments[0])]
        text = language.number(value)
        # A sign may not meet the operator before it.
        return (f"({text})", _ATOM) if text.startswith("-") else (text, _ATOM)
    parts = [texts[int(argument)] for argument in arguments]
    if operation in language.functions or operation == PACK or is_lane(operation):
        return _called(str(operation), language, parts), _ATOM
    if operation == "negative":
        return f"-{_enclosed(parts[0], _ATOM)}", _NEGATIVE
    own = _PRECEDENCE[str(operation)]
    # The right side of the same precedence keeps its brackets: sums are not rearranged.
    return f"{_enclosed(parts[0], own)} {operation} {_enclosed(parts[1], own + 1)}", own


def _called(operation: str, language: Language, parts: Sequence[tuple[str, int]]) -> str:
    """Return a function's call; of vectors, how one is made and what one holds."""
    if operation == PACK and language.vectors:
        return language.vectors.pack.format(size=_SIZES[len(parts)], numbers=", ".join(text for text, _ in parts))
    if is_lane(operation):
        return f"{_enclosed(parts[0], _ATOM)}[{operation[-1]}]"
    return language.functions[operation].format(x=parts[0][0])


def _enclosed(part: tuple[str, int], least: int) -> str:
    text, precedence = part
    return text if precedence >= least else f"({text})"
