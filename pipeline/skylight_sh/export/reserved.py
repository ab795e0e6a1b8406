"""Names that an axis cannot have: it becomes the name of a parameter in generated code and of a dimension in the store.

In C the axes are parameters of the public functions alone, which only hand them on: no local meets them there. A shader's
one function works with them itself.
"""

from __future__ import annotations

import re

_IDENTIFIER = re.compile(r"[a-z][a-z0-9_]{1,31}")
# ISO/IEC 9899:1999, 6.4.1, in lower case.
_C = """
auto break case char const continue default do double else enum extern float for goto if inline int long register restrict
return short signed sizeof static struct switch typedef union unsigned void volatile while
"""
# What ISO/IEC 14882:2011, 2.12 and 2.13, adds.
_CPP = """
alignas alignof and and_eq asm bitand bitor bool catch char16_t char32_t class compl const_cast constexpr decltype delete
dynamic_cast explicit export false friend mutable namespace new noexcept not not_eq nullptr operator or or_eq private
protected public reinterpret_cast static_assert static_cast template this thread_local throw true try typeid typename using
virtual wchar_t xor xor_eq
"""
# What ECMA-262, 12.7.2, adds for modules.
_JAVASCRIPT = """
arguments async await debugger eval extends finally function implements import in instanceof interface let null of package
super typeof var with yield
"""
# What stands beside the axes in the public functions.
_PARAMETERS = "bands count gradient sun_azimuth weights"
# Locals of a shader's function, those with a number apart; what it calls, and words of the languages in it.
_SHADER_LOCALS = "acc depth factors phi rest row scale status wave"
_SHADER_WORDS = """
abs array clamp cos exp f32 float2 float3 float4 floor fn function i32 in inout let log max min out pow ptr sin sqrt var vec2
vec3 vec4
"""
_NUMBERED = re.compile(r"([a-z]|part_)\d+(_\d+)?")
# Dimensions and variables of the truth in the store.
_STORE = "channel degree estimate least_luminance order set weight"
NAMES = frozenset(" ".join((_C, _CPP, _JAVASCRIPT, _PARAMETERS, _SHADER_LOCALS, _SHADER_WORDS, _STORE)).split())


def usable(name: str) -> bool:
    """Say whether an axis may have this name: a lower-case identifier of 2 to 32 characters that nothing else has.

    >>> usable("haze"), usable("x0"), usable("weights"), usable("Haze"), usable("class")
    (True, False, False, False, False)
    """
    return bool(_IDENTIFIER.fullmatch(name)) and not _NUMBERED.fullmatch(name) and name not in NAMES
