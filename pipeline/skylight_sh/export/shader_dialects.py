"""Shading languages as data: how one spells types, constants, locals, loops and functions. One file a language, named here.

What they have in common (operators, components, ``if``, ``clamp``, ``floor``, elementary functions, comments) needs no
description. Types are named here as the generator names them: ``real``, ``whole``, ``vec2``, ``vec3`` and ``vec4``.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from skylight_sh.registry import Registry

# Two underscores, and what these begin with, are the languages' own.
_RESERVED_PREFIX = re.compile(r"gl_|webgl_|.*__|.*_$")


@dataclass(frozen=True)
class Dialect:
    """One language: its types, and format strings over ``type``, ``name``, ``value``, ``items``, ``size`` and the like.

    ``about`` says which versions compile the file; ``opening`` and ``closing`` (over ``guard``) enclose it.
    """

    title: str
    extension: str
    about: str
    types: Mapping[str, str]
    opening: str
    closing: str
    constant_form: str
    constants_form: str
    fixed_form: str
    variable_form: str
    array_form: str
    loop_form: str
    function_form: str
    procedure_form: str
    parameter_form: str
    array_parameter_form: str
    result_parameter_form: str
    element_form: str
    passed_form: str

    def constant(self, kind: str, name: str, value: object) -> str:
        """Declare a global constant."""
        return self.constant_form.format(type=self.types[kind], name=name, value=value)

    def constants(self, kind: str, name: str, items: Sequence[str], a_line: int) -> str:
        """Declare a global array of constants, ``a_line`` of them a line."""
        lines = [", ".join(items[i : i + a_line]) for i in range(0, len(items), a_line)]
        text = "\n    " + ",\n    ".join(lines) + "\n"
        return self.constants_form.format(type=self.types[kind], name=name, size=len(items), items=text)

    def fixed(self, kind: str, name: str, value: str) -> str:
        """Declare a local that never changes."""
        return self.fixed_form.format(type=self.types[kind], name=name, value=value)

    def variable(self, kind: str, name: str, value: str) -> str:
        """Declare a local that changes."""
        return self.variable_form.format(type=self.types[kind], name=name, value=value)

    def array(self, kind: str, name: str, size: int) -> str:
        """Declare a local array, to be filled."""
        return self.array_form.format(type=self.types[kind], name=name, size=size)

    def loop(self, name: str, size: object) -> str:
        """Open a loop of ``name`` over 0 to ``size`` - 1."""
        return self.loop_form.format(name=name, size=size)

    def function(self, kind: str, name: str, parameters: Sequence[str]) -> str:
        """Head of a function that returns a ``kind``."""
        return self.function_form.format(type=self.types[kind], name=name, parameters=", ".join(parameters))

    def procedure(self, name: str, parameters: Sequence[str]) -> str:
        """Head of a function that returns nothing."""
        return self.procedure_form.format(name=name, parameters=", ".join(parameters))

    def parameter(self, kind: str, name: str) -> str:
        """Return a parameter passed in."""
        return self.parameter_form.format(type=self.types[kind], name=name)

    def array_parameter(self, kind: str, name: str, size: object) -> str:
        """Return an array parameter passed in."""
        return self.array_parameter_form.format(type=self.types[kind], name=name, size=size)

    def result_parameter(self, kind: str, name: str, size: object) -> str:
        """Return an array parameter that the function fills; see ``element``."""
        return self.result_parameter_form.format(type=self.types[kind], name=name, size=size)

    def element(self, name: str, index: object) -> str:
        """Return an element of a ``result_parameter``."""
        return self.element_form.format(name=name, index=index)

    def passed(self, name: str) -> str:
        """Return a local array as the argument of a ``result_parameter``."""
        return self.passed_form.format(name=name)

    def vector(self, items: Sequence[str]) -> str:
        """Return a vector of two to four scalars; one stays a scalar.

        >>> DIALECTS["wgsl"].vector(["a", "b"]), DIALECTS["wgsl"].vector(["a"])
        ('vec2<f32>(a, b)', 'a')
        """
        return items[0] if len(items) == 1 else f"{self.types[f'vec{len(items)}']}({', '.join(items)})"


def check_prefix(prefix: str) -> None:
    """Raise ValueError where shading languages reserve ``prefix``."""
    if _RESERVED_PREFIX.match(prefix):
        raise ValueError(f"Invalid prefix {prefix!r} for shaders. Should not begin with gl_ or webgl_, hold __ or end in _.")


# Each language's file holds its dialect, DIALECT, and the target that ships it, TARGET.
DIALECTS: Registry[Dialect] = Registry(
    {
        "glsl": "skylight_sh.export.targets.glsl:DIALECT",
        "hlsl": "skylight_sh.export.targets.hlsl:DIALECT",
        "wgsl": "skylight_sh.export.targets.wgsl:DIALECT",
    }
)
