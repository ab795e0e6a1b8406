"""None: the parameter itself, as the paper fits it."""

from __future__ import annotations

from skylight_sh.formula.variables.protocol import Variable

VARIABLE = Variable(
    constants=lambda *_: (),
    forward=lambda v, _: v,
    inverse=lambda u, _: u,
    own_nodes=False,
)
