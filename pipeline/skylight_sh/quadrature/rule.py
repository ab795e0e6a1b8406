"""What a truth rule is: its title, how it integrates, and the numbers of nodes to try."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from skylight_sh.quadrature.samples import Samples

# For rules whose error falls geometrically.
FINE = (24, 32, 40, 48, 56, 64, 72, 88, 104, 128, 160, 200, 256)


@dataclass(frozen=True)
class Rule:
    """A way to integrate.

    ``project(light, parameters, *, nodes | tolerance, harmonics)`` returns ``Samples``. A rule with fixed nodes
    has ``ladder(bands)``, the numbers of nodes to try in turn until two runs agree; an adaptive one has none, and is
    told the tolerance itself.
    """

    title: str
    project: Callable[..., Samples]
    ladder: Callable[[int], tuple[int, ...]] | None


def steps(*nodes: int, beyond: int | None = None) -> Callable[[int], tuple[int, ...]]:
    """Return a ladder of ``nodes``, but for those below the number of bands and ``beyond``.

    >>> steps(16, 32, 64, beyond=12)(7)
    (32, 64)
    """
    return lambda bands: tuple(n for n in nodes if beyond is None or n >= bands + beyond)
