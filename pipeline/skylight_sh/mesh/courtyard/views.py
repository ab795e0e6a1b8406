"""Where pictures of the courtyard are taken from, and where its sun stands."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class View:
    """Where a picture is taken from: ``eye`` and ``target`` in metres, ``field`` the vertical angle in degrees."""

    eye: tuple[float, float, float]
    target: tuple[float, float, float]
    field: float


@dataclass(frozen=True)
class Hour:
    """A view with a sun: ``height`` above the horizon and ``azimuth`` from +x (east) towards +y (north), in degrees."""

    view: View
    height: float
    azimuth: float
    turbidity: float = 3.0


ENTRANCE = View(eye=(4.6, -7.6, 1.75), target=(-1.5, 1.0, 1.75), field=40.0)
"""The wall on the left, the sculpture on a third, the arcade leading to the right."""

WALK = View(eye=(8.6, 6.35, 1.75), target=(-2.0, 4.6, 1.95), field=42.0)
"""From beneath the arcade along its columns, the court on the left."""

BENCH = View(eye=(-5.3, -4.9, 1.75), target=(1.75, 3.2, 1.8), field=40.0)
"""From beside the wall: the sculpture on the left, the arcade behind it, the blue jar on the right."""

MORNING = Hour(ENTRANCE, 11.0, 10.0)
"""A raking sun from the right: the arcade's corner, the ring and a cypress that is not seen lie on the wall as shadows."""

NOON = Hour(ENTRANCE, 52.0, -60.0)
"""The sun high in the south-east."""

SUNSET = Hour(BENCH, 7.0, 205.0)
"""The sun beyond the wall, on the arches alone."""
