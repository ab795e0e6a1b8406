"""What is wrong with a config: one thing, and the error that tells all of them at once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from skylight_sh import UserError


@dataclass(frozen=True)
class Problem:
    """One thing wrong: the field's path, its value, what is allowed and how to mend it."""

    path: str
    value: object
    remedy: str

    def __str__(self) -> str:
        return f"{self.path} = {self.value!r}: {self.remedy}"


class ConfigError(UserError, ValueError):
    """A config that cannot be run; its text has one line a problem."""


def refusal(where: str, found: Sequence[Problem]) -> ConfigError:
    """Return the error that tells all problems ``found`` in what ``where`` names."""
    lines = [f"{where} has {len(found)} problem{'s' if len(found) > 1 else ''}:", *(f"  {p}" for p in found)]
    return ConfigError("\n".join(lines))
