"""WGSL functions of tables of layout rows in float32."""

from __future__ import annotations

from skylight_sh.export.shader_dialects import WGSL
from skylight_sh.export.targets import shader

TARGET = shader.target(WGSL)
