"""The tables that a config asks for, by name."""

from __future__ import annotations

from dataclasses import dataclass

from pipeline.config.schema import Config, WinnerSection


@dataclass(frozen=True)
class Wanted:
    """One table: the section that asks for it, its budget (None: the section's degrees) and its layout."""

    name: str
    winner: WinnerSection
    budget: float | None
    layout: str


def wanted(config: Config) -> list[Wanted]:
    """Return the tables in the config's order, e.g. ``7-bands-0.1pct``, ``..-packed`` or ``..-degrees-13-7-float64``."""
    found = []
    for winner in config.winners:
        for budget in winner.budgets or (None,):
            for layout in winner.layouts:
                if winner.degrees is not None:
                    about = f"degrees-{'-'.join(map(str, winner.degrees))}"
                else:
                    about = f"{100 * (budget or 0.0):.6g}pct"
                parts = [f"{winner.bands}-bands", about]
                parts += [winner.dtype] if winner.dtype != "float32" else []
                parts += ["packed"] if layout == "packed" else []
                found.append(Wanted("-".join(parts), winner, budget, layout))
    return found


def table_names(config: Config) -> list[str]:
    """Return the names of all tables."""
    return [table.name for table in wanted(config)]
