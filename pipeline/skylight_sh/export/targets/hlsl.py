"""HLSL functions of tables of layout rows in float32."""

from __future__ import annotations

from dataclasses import replace

from skylight_sh.export.targets import shader
from skylight_sh.export.targets.glsl import DIALECT as GLSL

DIALECT = replace(
    GLSL,
    title="HLSL",
    extension="hlsl",
    about="HLSL, shader model 4 or newer",
    types={"real": "float", "whole": "int", "vec2": "float2", "vec3": "float3", "vec4": "float4"},
    opening="#ifndef {guard}_HLSL\n#define {guard}_HLSL\n\n",
    closing="\n#endif // {guard}_HLSL\n",
    constant_form="static const {type} {name} = {value};",
    constants_form="static const {type} {name}[{size}] = {{{items}}};",
    fixed_form="const {type} {name} = {value};",
)
TARGET = shader.target(DIALECT)
