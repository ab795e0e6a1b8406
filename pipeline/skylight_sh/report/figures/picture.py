"""What a picture of the report is."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from skylight_sh.report.report_data import ReportData


@dataclass(frozen=True)
class Picture:
    """A picture's title, what it shows, and how it is drawn (None where there is nothing to show).

    ``see`` is the one sentence that says what to look at, ``caption`` all that it takes to read the picture.
    ``files`` returns further files of the report by name: the numbers that the picture shows, say.
    """

    title: str
    caption: str
    draw: Callable[[ReportData], Figure | None]
    files: Callable[[ReportData], Mapping[str, bytes]] = lambda _: {}
    see: str = ""
