"""A panorama, azimuth across and altitude up, +x in the middle, 2:1."""

from __future__ import annotations

from skylight_sh.probe.charts import LatLong
from skylight_sh.probe.image_layouts.protocol import ImageLayout, Patch


def _patches(height: int, width: int) -> list[Patch]:
    return [Patch(0, 0, height, width, LatLong())] if width == 2 * height else []


LAYOUT = ImageLayout("2:1", _patches, half_turns=1.0)
