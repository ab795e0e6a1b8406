"""Pictures of the report, one file a picture, named here in the order of the page."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from matplotlib.figure import Figure

from skylight_sh.report.figures import (
    bands,
    daylight,
    degrees,
    encoding,
    gibbs,
    maps,
    origins,
    panoramas,
    ringing,
    sizes,
    surroundings,
)
from skylight_sh.report.report_data import Material


@dataclass(frozen=True)
class Picture:
    """A picture's title, what it shows, and how it is drawn (None where there is nothing to show)."""

    title: str
    caption: str
    draw: Callable[[Material], Figure | None]


PICTURES = {
    "bands": Picture("Largest errors against bands", bands.CAPTION, bands.draw),
    "origins": Picture("The 2008 result explained", origins.CAPTION, origins.draw),
    "bytes": Picture("Error against bytes", sizes.CAPTION, sizes.draw),
    "degrees": Picture("Error of every combination of degrees", degrees.CAPTION, degrees.draw),
    "maps": Picture("Where the error is", maps.CAPTION, maps.draw),
    "panoramas": Picture("The worst cases as skies", panoramas.CAPTION, panoramas.draw),
    "surroundings": Picture("The scene's surroundings", surroundings.CAPTION, surroundings.draw),
    "daylight": Picture("A clear day in lux", daylight.CAPTION, daylight.draw),
    "ringing": Picture("Ringing, before and after the window", ringing.CAPTION, ringing.draw),
    "gibbs": Picture("Ringing: every window, every ground", gibbs.CAPTION, gibbs.draw),
    "encoding": Picture("Ringing of captured light", encoding.CAPTION, encoding.draw),
}
