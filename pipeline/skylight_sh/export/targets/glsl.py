"""GLSL functions of tables of layout rows in float32."""

from __future__ import annotations

from skylight_sh.export.shader_dialects import Dialect
from skylight_sh.export.targets import shader

DIALECT = Dialect(
    title="GLSL",
    extension="glsl",
    about="GLSL ES 3.00 (WebGL 2) and GLSL 3.30 or newer; makes highp the default precision of floats and ints",
    types={"real": "float", "whole": "int", "vec2": "vec2", "vec3": "vec3", "vec4": "vec4"},
    opening="#ifndef {guard}_GLSL\n#define {guard}_GLSL\n"
    "#ifdef GL_ES\nprecision highp float;\nprecision highp int;\n#endif\n\n",
    closing="\n#endif // {guard}_GLSL\n",
    constant_form="const {type} {name} = {value};",
    constants_form="const {type} {name}[{size}] = {type}[{size}]({items});",
    fixed_form="{type} {name} = {value};",
    variable_form="{type} {name} = {value};",
    array_form="{type} {name}[{size}];",
    loop_form="for (int {name} = 0; {name} < {size}; ++{name}) {{",
    function_form="{type} {name}({parameters})",
    procedure_form="void {name}({parameters})",
    parameter_form="{type} {name}",
    array_parameter_form="{type} {name}[{size}]",
    result_parameter_form="out {type} {name}[{size}]",
    element_form="{name}[{index}]",
    passed_form="{name}",
)
TARGET = shader.target(DIALECT)
