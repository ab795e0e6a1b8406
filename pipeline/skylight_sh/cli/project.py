"""The command ``project``: the SH weights of a picture of the whole sphere."""

from __future__ import annotations

import math
from pathlib import Path

import click

from skylight_sh import UserError
from skylight_sh.cli import warn
from skylight_sh.cli.evaluate import show_weights
from skylight_sh.probe.image_layouts import IMAGE_LAYOUTS

_HELP = """Print the SH weights of captured light from IMAGE: OpenEXR, Radiance HDR, PNG, JPEG or TIFF.

The picture is seen from inside: +x ahead, +z up, -y to the right. Layouts:

\b
{layouts}

Example: skylight-sh project probe.exr --bands 5 --blur 10
"""


@click.command(help=_HELP.format(layouts="\n".join(f"{name}: {IMAGE_LAYOUTS.about(name)}" for name in IMAGE_LAYOUTS)))
@click.argument("image", type=click.Path(path_type=Path))
@click.option(
    "--layout",
    type=click.Choice(list(IMAGE_LAYOUTS)),
    help="How the picture covers the sphere; if left out, by its proportions.",
)
@click.option("--bands", type=int, required=True, help="SH bands, at least 1 and no more than the texels resolve.")
@click.option(
    "--blur", type=float, default=0.0, show_default=True, help="Gaussian pre-filter, standard deviation in degrees."
)
@click.option("--linear", is_flag=True, help="Take whole-number pixels (PNG, JPEG) as linear, not as sRGB.")
@click.option("--json", "as_json", is_flag=True, help="Print JSON instead of a table.")
def project(image: Path, layout: str | None, bands: int, blur: float, linear: bool, as_json: bool) -> None:
    """Print the SH weights of captured light."""
    from skylight_sh import probe
    from skylight_sh.probe import files

    if not 0.0 <= blur <= 180.0:
        raise UserError(f"Invalid --blur {blur}. Should be from 0 to 180 degrees.")
    try:
        picture = files.read(image, linear=linear)
    except (ValueError, OSError) as error:
        raise UserError(str(error)) from error
    try:
        chosen = layout or probe.layout_of(*picture.pixels.shape[:2])
        weights = probe.blur(probe.project(picture.pixels, chosen, bands), math.radians(blur))
    except ValueError as error:
        raise UserError(f"{image}: {error}") from error
    if picture.clipped:
        warn(f"{100 * picture.clipped:.2g} % of the pixels are clipped: brighter light is lost.")
    show_weights(weights, picture.channels, as_json=as_json)
