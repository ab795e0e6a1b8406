"""What a camera sees of a mesh: points of a picture's samples, several a pixel, and how they become pixels."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from skylight_sh.render.camera import Camera
from skylight_sh.render.surface import Surface

Array = NDArray[np.float64]


class View:
    """A picture of ``width`` x ``height`` pixels with ``side`` x ``side`` samples each.

    ``along`` ``(samples, 3)`` are their directions, ``seen`` ``(samples,)`` says which meet the mesh, ``points`` where;
    ``shown`` ``(height, width)`` are the pixels with any of these.
    """

    def __init__(
        self,
        surface: Surface,
        eye: tuple[float, float, float],
        target: tuple[float, float, float],
        field: float,
        *,
        width: int,
        height: int,
        side: int = 2,
    ) -> None:
        camera = Camera(eye, target, field, side * width, side * height)
        self._shape = (height, side, width, side)
        self.eye = np.array(eye)
        self.along = camera.directions().reshape(-1, 3)
        self.hits = surface.rays.nearest(np.broadcast_to(self.eye, self.along.shape), self.along)
        self.points, self.seen = surface.met(self.hits, self.along)
        self.shown = self.pixels(self.seen[:, np.newaxis].astype(np.float64))[..., 0] > 0.0

    def picture(self, radiance: NDArray[np.floating], behind: Array | None = None) -> Array:
        """Return pixels ``(height, width, 3)`` of the points' ``radiance`` ``(points, 3)``.

        ``behind`` ``(samples - points, 3)`` is what the other samples see, black if it is left out.
        """
        samples = np.zeros(self.along.shape)
        samples[self.seen] = radiance
        if behind is not None:
            samples[~self.seen] = behind
        return self.pixels(samples)

    def pixels(self, samples: Array) -> Array:
        """Return the means ``(height, width, k)`` of ``samples`` ``(samples, k)``."""
        return np.asarray(samples.reshape(*self._shape, -1).mean(axis=(1, 3)))
