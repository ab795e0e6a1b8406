"""WGSL functions of tables of layout rows in float32."""

from __future__ import annotations

from skylight_sh.export.shader_dialects import Dialect
from skylight_sh.export.targets import shader

DIALECT = Dialect(
    title="WGSL",
    extension="wgsl",
    about="WGSL (WebGPU), no extension; pass &weights to fill a function's own array",
    types={"real": "f32", "whole": "i32", "vec2": "vec2<f32>", "vec3": "vec3<f32>", "vec4": "vec4<f32>"},
    opening="",
    closing="",
    constant_form="const {name}: {type} = {value};",
    constants_form="const {name} = array<{type}, {size}>({items});",
    fixed_form="let {name}: {type} = {value};",
    variable_form="var {name}: {type} = {value};",
    array_form="var {name}: array<{type}, {size}>;",
    loop_form="for (var {name}: i32 = 0; {name} < {size}; {name}++) {{",
    function_form="fn {name}({parameters}) -> {type}",
    procedure_form="fn {name}({parameters})",
    parameter_form="{name}: {type}",
    array_parameter_form="{name}: array<{type}, {size}>",
    result_parameter_form="{name}: ptr<function, array<{type}, {size}>>",
    element_form="(*{name})[{index}]",
    passed_form="&{name}",
)
TARGET = shader.target(DIALECT)
