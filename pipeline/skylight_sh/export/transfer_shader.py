"""The shader that lights a vertex from compressed transfer, in any of the shading languages."""

from __future__ import annotations

from skylight_sh.export import prefixes
from skylight_sh.export.shader_dialects import DIALECTS, check_prefix

_ABOUT = """\
// Diffuse light on a vertex from compressed transfer. Written by skylight-sh; CC0-1.0.
// {about}.
//
// {p}_transfer(light, {names}): irradiance / pi in cd/m2, linear, shadows and bounces of the sky and
//   bounces of the sun included. light: the frame's uniforms, {count} vec3, made as transfer_uniforms.json says.
//   {names}: the attributes {attributes}, bytes from -1 to 1.
// Times the albedo (COLOR_0, times its texture) it is radiance; add what the sun's disc sends directly, with your shadows.
// Few bands ring: it may dip a little below 0; clamp where that matters.
"""


def attributes(count: int) -> list[str]:
    """Return the names of the vertex attributes that hold ``count`` components, four each.

    >>> attributes(6)
    ['_TRANSFER0', '_TRANSFER1']
    """
    return [f"_TRANSFER{i}" for i in range((count + 3) // 4)]


def write(language: str, count: int, prefix: str = "skylight_sh") -> str:
    """Return the function ``<prefix>_transfer`` in ``language`` (``glsl``, ``hlsl`` or ``wgsl``) for ``count`` components.

    Raises ValueError for a prefix that the languages reserve.
    """
    prefixes.check(prefix)
    check_prefix(prefix)
    d = DIALECTS[language]
    names = "abcdefghijklm"[: len(attributes(count))]
    terms = [f"{name}.{axis} * light[{1 + 4 * i + j}]" for i, name in enumerate(names) for j, axis in enumerate("xyzw")]
    terms = terms[:count]
    given = [d.array_parameter("vec3", "light", 1 + count), *(d.parameter("vec4", name) for name in names)]
    about = _ABOUT.format(
        about=d.about.partition(";")[0],
        p=prefix,
        names=", ".join(names),
        count=1 + count,
        attributes=", ".join(attributes(count)),
    )
    lines = [
        d.function("vec3", f"{prefix}_transfer", given),
        "{",
        f"    {d.variable('vec3', 'lit', 'light[0]')}",
        *(f"    lit += {' + '.join(terms[i : i + 4])};" for i in range(0, count, 4)),
        "    return lit;",
        "}",
    ]
    guard = f"{prefix}_transfer".upper()
    return about + "\n" + d.opening.format(guard=guard) + "\n".join(lines) + "\n" + d.closing.format(guard=guard)
