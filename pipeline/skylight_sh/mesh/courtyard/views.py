"""Where pictures of the courtyard are taken from."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class View:
    """Where a picture is taken from: ``eye`` and ``target`` in metres, ``field`` the vertical angle in degrees."""

    eye: tuple[float, float, float]
    target: tuple[float, float, float]
    field: float


ENTRANCE = View(eye=(4.6, -7.6, 1.75), target=(-1.5, 1.0, 1.75), field=40.0)
"""The wall on the left, the sculpture on a third, the arcade leading to the right."""

WALK = View(eye=(7.2, 6.3, 1.75), target=(-2.6, 2.0, 1.45), field=42.0)
"""From beneath the arcade."""
