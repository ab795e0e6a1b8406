"""What a run is, in words: its title, and what stands in its scene; told by the config's settings alone."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import numpy as np

from skylight_sh.report.figures import SCENES

# What a table's name tells of it.
_ASKED = re.compile(r"(\d+)-bands-(?:([\d.]+)pct)?")
# Lights whose zenith has a luminance of 1 by definition.
_RELATIVE = ("cie_general", "cie_traditional")
_QUANTITIES = {"radiance": "radiance in cd/m²", "irradiance": "diffuse irradiance in lux"}


def title(light: str, settings: Mapping[str, Any]) -> str:
    """Return a run's title: its name, the ``light`` by its own title, the scene, the quantity and its unit.

    >>> told = {"name": "grey", "light": {"model": "cie_traditional"}, "scene": {"quantity": "radiance"}}
    >>> title("CIE overcast sky", {**told, "export": {"recommended": "7-bands-0.1pct"}, "report": {"figures": []}})
    'grey: CIE overcast sky, radiance in units of the zenith, 7 bands within 0.1 %'
    """
    parts = [light, *surroundings(settings), quantity(settings)]
    asked = _ASKED.match(settings["export"]["recommended"])
    if asked:
        parts.append(f"{asked[1]} bands" + (f" within {asked[2]} %" if asked[2] else ""))
    if set(settings["report"]["figures"]) & set(SCENES):
        parts.append("with pictures of lit scenes")
    return f"{settings['name']}: {', '.join(parts)}"


def quantity(settings: Mapping[str, Any]) -> str:
    """Return what the weights are of, and its unit."""
    told = str(settings["scene"]["quantity"])
    return f"{told} in units of the zenith" if _is_relative(settings) else _QUANTITIES[told]


def unit(settings: Mapping[str, Any]) -> str:
    """Return the unit of the light's luminance."""
    return "of the zenith's" if _is_relative(settings) else "cd/m²"


def _is_relative(settings: Mapping[str, Any]) -> bool:
    light = settings["light"]
    return light["model"] in _RELATIVE or light.get("quantity") == "relative"


def surroundings(settings: Mapping[str, Any]) -> list[str]:
    """Return in words what a config's scene adds to the light; nothing where it is the light alone.

    What the scene fixes of the light, and its channels, the light's own title tells.
    """
    scene = settings["scene"]
    found: list[str] = []
    ground = scene.get("ground", "black")
    if ground == "mirror":
        found.append("mirrored below the horizon")
    elif ground != "black":
        each = ground if len(set(ground)) > 1 else ground[:1]
        found.append(f"ground of albedo {' / '.join(f'{albedo:g}' for albedo in each)}")
    found += [f"with {word}" for word in ("twilight", "clouds") if scene.get(word)]
    found += ["with the sun's disc"] if scene.get("sun_disc") else []
    found += ["a skyline"] if scene.get("horizon") else []
    for key, word in (("occluders", "occluder"), ("lights", "lamp")):
        count = len(scene.get(key) or ())
        found += [f"{count} {word}{'s' if count > 1 else ''}"] if count else []
    mesh = scene.get("mesh")
    found += [f"on a mesh ({str(mesh['file']).rpartition('/')[2]})"] if mesh else []
    if scene.get("azimuth") is not None:
        found.append(f"sun azimuth fixed at {np.degrees(scene['azimuth']):.4g}°")
    if scene.get("window"):
        found.append("windowed")
    return found


def ranges(settings: Mapping[str, Any], units: Mapping[str, str]) -> str:
    """Return the axes and their ranges, angles in degrees; ``units`` are those of the light's parameters by name.

    >>> ranges({"axes": [{"name": "sun_zenith", "range": [0.0, 1.5707963267948966]}]}, {"sun_zenith": "rad"})
    'sun zenith 0° to 90°'
    """
    told = []
    for axis in settings["axes"]:
        angle = units.get(axis["name"]) == "rad"
        low, high = (f"{np.degrees(v):.4g}°" if angle else f"{v:.4g}" for v in axis["range"])
        told.append(f"{axis['name'].replace('_', ' ')} {low} to {high}")
    return ", ".join(told)
