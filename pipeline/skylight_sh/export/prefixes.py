"""Prefixes of the names in generated code: one a table, so that any two tables meet in one program."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Sequence

LONGEST = 63
_PREFIX = re.compile(rf"[a-z][a-z0-9_]{{0,{LONGEST - 1}}}")


def check(prefix: str) -> None:
    """Raise ValueError for a prefix that is no C identifier of lower-case letters, digits and underscores."""
    if not _PREFIX.fullmatch(prefix):
        raise ValueError(f"Invalid prefix {prefix!r}. Should be a lower-case C identifier of at most {LONGEST} characters.")


def by_table(names: Sequence[str], recommended: str, prefix: str) -> dict[str, str]:
    """Return each table's own prefix: ``prefix`` for the ``recommended`` one, else its name behind that.

    No two are equal, none is longer than ``LONGEST`` or holds two underscores in a row, which C++ reserves.

    >>> by_table(["7-bands-0.1pct", "4-bands-1pct-packed"], "7-bands-0.1pct", "sky_sh")
    {'7-bands-0.1pct': 'sky_sh', '4-bands-1pct-packed': 'sky_sh_4_bands_1pct_packed'}
    """
    found: dict[str, str] = {}
    for name in names:
        wanted = prefix if name == recommended else f"{prefix}_{re.sub('[^a-z0-9]+', '_', name.lower()).strip('_')}"
        if len(wanted) > LONGEST or wanted in found.values() or (wanted == prefix and name != recommended):
            sign = hashlib.sha256(name.encode()).hexdigest()[:8]
            wanted = f"{wanted[: LONGEST - 9].rstrip('_')}_{sign}"
        found[name] = wanted
    return found
