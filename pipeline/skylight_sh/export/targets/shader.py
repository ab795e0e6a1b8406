"""What the shading languages' targets share."""

from __future__ import annotations

from skylight_sh.export import shaders
from skylight_sh.export.shader_dialects import Dialect
from skylight_sh.export.target import Target


def target(dialect: Dialect) -> Target:
    """Return the target that writes tables of layout rows, in float32, in a shading language."""
    language = dialect.extension
    return Target(
        lambda table, facts, prefix: {f"skylight_sh.{language}": shaders.write(table, facts, language, prefix).encode()},
        shaders.obstacle,
    )
