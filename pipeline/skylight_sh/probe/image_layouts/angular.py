"""A light probe: the distance from the centre is the angle from +x, 1:1.

Debevec 1998; the rim of the disc looks along -x, and corners show nothing.
"""

from __future__ import annotations

from skylight_sh.probe.charts import Angular
from skylight_sh.probe.image_layouts.protocol import ImageLayout, Patch


def _patches(height: int, width: int) -> list[Patch]:
    return [Patch(0, 0, height, width, Angular())] if height == width else []


LAYOUT = ImageLayout("1:1", _patches, half_turns=2.0)
