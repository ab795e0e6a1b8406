"""Templates of programs around exported tables."""

from __future__ import annotations

from jinja2 import Environment, PackageLoader, StrictUndefined, Template, select_autoescape


def template(name: str) -> Template:
    """Return the template ``name`` of ``export/templates``."""
    return _TEMPLATES.get_template(name)


_TEMPLATES = Environment(
    loader=PackageLoader("skylight_sh.export"),
    undefined=StrictUndefined,
    keep_trailing_newline=True,
    # C is no markup; ``c_comment.safe`` keeps text inside its comment.
    autoescape=select_autoescape(default=False),
)
