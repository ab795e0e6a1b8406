"""One thing wrong with a config."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Problem:
    """One thing wrong: the field's path, its value, what is allowed and how to mend it."""

    path: str
    value: object
    remedy: str

    def __str__(self) -> str:
        return f"{self.path} = {self.value!r}: {self.remedy}"
