"""Mutants that are proven to change nothing that anybody may rely on."""

from __future__ import annotations

import tomllib
from collections.abc import Iterable
from pathlib import Path

from .generate import Mutant

PLACE = Path(__file__).with_name("equivalents.toml")
_FIELDS = {"file", "within", "before", "after", "proof"}


class Equivalents:
    """The proofs, by file, function around the line, and the line before and after; whatever its number."""

    def __init__(self, text: str) -> None:
        entries = tomllib.loads(text).get("mutant", [])
        for entry in entries:
            if set(entry) != _FIELDS or not entry["proof"].strip():
                raise ValueError(
                    f"Incomplete entry {entry!r}. Should have {', '.join(sorted(_FIELDS))}, a proof among them."
                )
        self.proofs = {(e["file"], e["within"], e["before"], e["after"]): str(e["proof"]) for e in entries}

    def __contains__(self, mutant: Mutant) -> bool:
        return mutant.key in self.proofs

    def stale(self, every: Iterable[Mutant]) -> list[tuple[str, str, str, str]]:
        """Return the entries that name none of all mutants: their line has changed."""
        known = {mutant.key for mutant in every}
        return [key for key in self.proofs if key not in known]


def load() -> Equivalents:
    """Return the repository's own."""
    return Equivalents(PLACE.read_text(encoding="utf-8"))
