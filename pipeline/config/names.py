"""Names of the tables that a config asks for."""

from __future__ import annotations

from pipeline.config.schema import Config, WinnerSection


def table_names(config: Config) -> list[str]:
    """Return the winners' names in the config's order, e.g. ``7-bands-0.1pct`` or ``7-bands-degrees-13-7-float64``."""
    return [name for winner in config.winners for name in winner_names(winner)]


def winner_names(winner: WinnerSection) -> list[str]:
    """Return the names of one section's tables: one a budget, or one for its degrees."""
    suffix = "" if winner.dtype == "float32" else f"-{winner.dtype}"
    if winner.degrees is not None:
        return [f"{winner.bands}-bands-degrees-{'-'.join(map(str, winner.degrees))}{suffix}"]
    return [f"{winner.bands}-bands-{100 * budget:.6g}pct{suffix}" for budget in winner.budgets]
