"""What each engine expects: sign, stored quantity, axes and layout, one row an engine.

All of them number the weights ``l*(l+1)+m``, and all evaluate the same polynomials, polar about *their* z axis; a y-up
engine has no basis of its own. So the axes are a true change of axes, not another order of the weights.

The quantities, for a weight ``c`` of the radiance, of degree l and order m:

- ``radiance``: c.
- ``radiance/pi``: c / pi, for shaders that take the result for reflected light.
- ``irradiance``: A_l c, with A_l = pi, 2 pi / 3, pi / 4, the cosine lobe (Ramamoorthi and Hanrahan 2001).
- ``irradiance/pi``: A_l c / pi, what a white Lambertian surface reflects.
- ``irradiance/pi, scaled``: A_l c / pi times the constant of the basis function, so that a shader sums
  1, y, z, x, xy, yz, 3zz - 1, xz, xx - yy.

``condon_shortley`` says whether the engine's basis has the factor (-1)**m; in scaled quantities it cancels.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

Quantity = Literal["radiance", "radiance/pi", "irradiance", "irradiance/pi", "irradiance/pi, scaled"]
# The order of the numbers: all weights of red, then green, then blue; or red, green and blue of each weight in turn,
# as triples, in one flat list, or as lines of text.
Arrangement = Literal["planar", "triples", "flat", "lines"]

Y_UP_RIGHT = "x=+x,y=-z,z=+y"
Y_UP_LEFT = "x=+x,y=+z,z=+y"
Z_UP_LEFT = "x=+x,y=-y,z=+z"
OURS = "x=+x,y=+y,z=+z"


@dataclass(frozen=True)
class Profile:
    """One engine's form. ``bands`` is the fewest and the most it takes; ``axes`` says where our +x, +y and +z go.

    ``keys`` names the numbers in JSON: none, one for all, or one a channel of a planar layout. ``around`` holds the JSON
    beside them, and ``inside`` the keys of the object among it that they belong to.
    """

    title: str
    reader: str
    quantity: Quantity
    condon_shortley: bool
    axes: str
    layout: Arrangement
    bands: tuple[int, int] = (3, 3)
    keys: tuple[str, ...] = ()
    around: dict[str, object] = field(default_factory=dict)
    inside: str = ""


PROFILES = {
    "filament": Profile(
        title="Filament, the text of cmgen",
        reader="IndirectLight::Builder::irradiance(bands, sh)",
        quantity="irradiance/pi, scaled",
        condon_shortley=False,
        axes=Y_UP_RIGHT,
        layout="lines",
        bands=(1, 3),
    ),
    "filament-radiance": Profile(
        title="Filament, radiance",
        reader="IndirectLight::Builder::radiance(bands, sh)",
        quantity="radiance",
        condon_shortley=True,
        axes=Y_UP_RIGHT,
        layout="triples",
        bands=(1, 3),
    ),
    "unity": Profile(
        title="Unity",
        reader="SphericalHarmonicsL2, sh[channel, i]",
        quantity="irradiance/pi, scaled",
        condon_shortley=False,
        axes=Y_UP_LEFT,
        layout="planar",
    ),
    "unreal": Profile(
        title="Unreal Engine",
        reader="FSHVectorRGB3, its R, G and B",
        quantity="radiance",
        condon_shortley=True,
        axes=Z_UP_LEFT,
        layout="planar",
        keys=("R", "G", "B"),
    ),
    "godot": Profile(
        title="Godot",
        reader="the 9 colours of a lightmap probe",
        quantity="radiance/pi",
        condon_shortley=False,
        axes=Y_UP_RIGHT,
        layout="triples",
    ),
    "threejs": Profile(
        title="three.js",
        reader="ObjectLoader.parse(json), or LightProbe.fromJSON(json.object) before it was dropped",
        quantity="radiance",
        condon_shortley=False,
        axes=Y_UP_RIGHT,
        layout="flat",
        keys=("sh",),
        around={"metadata": {"version": 4.5, "type": "Object"}, "object": {"type": "LightProbe", "intensity": 1}},
        inside="object",
    ),
    "directxmath": Profile(
        title="DirectXMath",
        reader="XMSH functions of that order, an array a channel",
        quantity="radiance",
        condon_shortley=True,
        axes=OURS,  # XMSH has no axes of its own
        layout="planar",
        bands=(2, 6),
        keys=("red", "green", "blue"),
    ),
    "babylonjs": Profile(
        title="Babylon.js",
        reader="SphericalHarmonics.FromArray, which it scales itself for rendering",
        quantity="irradiance/pi",
        condon_shortley=True,
        axes=Y_UP_LEFT,
        layout="triples",
    ),
    "gltf": Profile(
        title="glTF EXT_lights_image_based",
        reader="a light of the extension; its specular images are yours",
        quantity="irradiance",
        condon_shortley=True,  # the extension leaves it open; its reader, Babylon.js, has it
        axes=Y_UP_RIGHT,
        layout="triples",
        keys=("irradianceCoefficients",),
        around={"intensity": 1},
    ),
}
