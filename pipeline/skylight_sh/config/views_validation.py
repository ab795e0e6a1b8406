"""What the schema cannot see of a config's pictures: whether their suns, parameters and tables exist."""

from __future__ import annotations

import math
from collections.abc import Iterator
from datetime import datetime
from zoneinfo import ZoneInfo, ZoneInfoNotFoundError

from skylight_sh.config.problem import Problem
from skylight_sh.config.schema import Config
from skylight_sh.config.views_schema import SkySunSection, ViewSection
from skylight_sh.config.wanted import table_names


def find(config: Config) -> Iterator[Problem]:
    """Yield every problem."""
    if config.views and config.scene.mesh is None:
        yield Problem("$.views", len(config.views), 'Pictures need surfaces. Add [scene.mesh] with file = "courtyard".')
    if config.views and config.scene.quantity != "radiance":
        remedy = 'Transfer takes radiance. Use "radiance", or leave [[views]] out.'
        yield Problem("$.scene.quantity", config.scene.quantity, remedy)
    if config.views and getattr(config.light, "colour_space", "srgb") != "srgb":
        yield Problem("$.light.colour_space", getattr(config.light, "colour_space", ""), "Pictures need srgb.")
    names = [view.name for view in config.views]
    for i, view in enumerate(config.views):
        path = f"$.views[{i}]"
        if view.name in names[:i]:
            yield Problem(f"{path}.name", view.name, "This name stands twice. Give every view its own.")
        if view.table and view.table not in table_names(config):
            known = ", ".join(table_names(config))
            yield Problem(f"{path}.table", view.table, f"No winner has this name. Use one of: {known}.")
        flat = math.hypot(view.target[0] - view.eye[0], view.target[1] - view.eye[1])
        if flat <= 1e-6 * abs(view.target[2] - view.eye[2]):
            yield Problem(f"{path}.target", list(view.target), "Lies straight above or below the eye, or in it. Move it.")
        yield from _sun(config, f"{path}.sun", view.sun)
        yield from _parameters(config, f"{path}.at", view)


def _sun(config: Config, path: str, sun: SkySunSection) -> Iterator[Problem]:
    peak = config.light.hints.peak_axis
    by_angles, by_time = sun.height is not None or sun.azimuth is not None, sun.time is not None
    if peak is None or peak in config.scene.fixed:
        if by_angles or by_time:
            yield Problem(path, sun.model_dump(exclude_none=True), "This light has no sun that moves. Leave it out.")
        return
    if by_angles == by_time or (by_angles and sun.height is None):
        remedy = "Give { height = 12.0, azimuth = -15.0 }, or { time = ..., latitude = ..., longitude = ... }"
        yield Problem(path, sun.model_dump(exclude_none=True), f"{remedy}: one of the two.")
    elif by_time:
        if sun.latitude is None or sun.longitude is None:
            yield Problem(path, sun.time, "A time needs a place: give latitude and longitude.")
        try:
            datetime.fromisoformat(sun.time or "")
        except ValueError:
            yield Problem(f"{path}.time", sun.time, 'Should be ISO 8601, like "2026-06-21T18:30".')
        try:
            ZoneInfo(sun.timezone)
        except (ZoneInfoNotFoundError, ValueError, OSError):
            yield Problem(f"{path}.timezone", sun.timezone, "Should be an IANA name, like UTC or Europe/Vienna.")


def _parameters(config: Config, path: str, view: ViewSection) -> Iterator[Problem]:
    peak = config.light.hints.peak_axis
    ranges = {axis.name: axis.range for axis in config.axes if axis.name != peak}
    for name in view.at:
        if name not in ranges:
            known = ", ".join(ranges) or "none"
            yield Problem(f"{path}.{name}", view.at[name], f"No parameter of the light beside its sun: {known}.")
    for name, (low, high) in ranges.items():
        if name not in view.at:
            yield Problem(path, dict(view.at), f"Give {name} a value within [{low:.9g}, {high:.9g}].")
        elif low <= high and not low <= view.at[name] <= high:
            yield Problem(f"{path}.{name}", view.at[name], f"Stay within the axis's range [{low:.9g}, {high:.9g}].")
