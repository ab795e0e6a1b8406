"""The tables that a config asks for, by name."""

from __future__ import annotations

from skylight_sh.config.schema import Config
from skylight_sh.table.request import Request


def wanted(config: Config) -> list[Request]:
    """Return the tables in the config's order: ``7-bands-0.1pct``, ``..-packed``, ``..-2048-bytes``, ``..-degrees-13-7``."""
    found = []
    for winner in config.winners:
        limits: list[tuple[str, float | None, int | None]]
        limits = [(f"{100 * budget:.6g}pct", budget, None) for budget in winner.budgets]
        limits += [(f"{size}-bytes", None, size) for size in winner.sizes]
        if winner.degrees is not None:
            limits = [(f"degrees-{'-'.join(map(str, winner.degrees))}", None, None)]
        for about, budget, size in limits:
            for layout in winner.layouts:
                parts = [f"{winner.bands}-bands", about]
                parts += [winner.dtype] if winner.dtype != "float32" else []
                parts += ["packed"] if layout == "packed" else []
                found.append(Request("-".join(parts), winner.bands, winner.dtype, layout, budget, size, winner.degrees))
    return found


def table_names(config: Config) -> list[str]:
    """Return the names of all tables."""
    return [table.name for table in wanted(config)]
