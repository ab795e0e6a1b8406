"""Names that an axis cannot have: it becomes the name of a parameter in generated code and of a dimension in the store.

C has one scope of ordinary identifiers a block, so a parameter must be no keyword, no other parameter, no library function
that the code calls, and no local of the functions that take it.
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
# What stands beside the axes in the functions that renderers call.
PARAMETERS = ("sun_azimuth", "bands", "count", "weights", "gradient", "status", "normal", "direction")
# Dimensions and variables of the truth in the store.
_STORE = ("channel", "degree", "estimate", "least_luminance", "order", "set", "weight")
_LIBRARY = """
fabs fabsf log logf exp expf sin sinf cos cosf tan tanf sqrt sqrtf cbrt cbrtf memset memcpy memcmp
"""
# Locals that share a scope with the axes: those that carry a number, such as x0, a3_1 and fade2, and these.
_NUMBERED = re.compile(r"([a-z]|fade)\d+(_\d+)?")
_LOCALS = """
scale transfer own below row wave depth rest wave_cos wave_sin line known acc phi from slope grown low high worst ready value
lights fallen out sum in first last bits room body lower length luminance factor ratio
"""
NAMES = frozenset([*f"{_C} {_CPP} {_LIBRARY} {_LOCALS}".split(), *PARAMETERS, *_STORE])


def usable(name: str) -> bool:
    """Say whether an axis may have this name: a lower-case identifier of 2 to 32 characters that nothing else has.

    >>> usable("haze"), usable("x0"), usable("weights"), usable("Haze"), usable("class")
    (True, False, False, False, False)
    """
    return bool(_IDENTIFIER.fullmatch(name)) and not _NUMBERED.fullmatch(name) and name not in NAMES
