"""What a run is, in words: its title, and what stands in its scene; told by the config's settings alone."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

# Lights whose zenith has a luminance of 1 by definition.
_RELATIVE = ("cie_general", "cie_traditional")
_QUANTITIES = {"radiance": "radiance in cd/m²", "irradiance": "diffuse irradiance in lux"}


def title(light: str, settings: Mapping[str, Any]) -> str:
    """Return a run's title: its name, the ``light`` by its own title, the scene, the quantity and its unit.

    >>> scene = {"quantity": "radiance", "ground": "black", "fixed": {}}
    >>> title("CIE overcast sky", {"name": "grey", "light": {"model": "cie_traditional"}, "scene": scene, "axes": []})
    'grey: CIE overcast sky, radiance in units of the zenith'
    """
    scene = ", ".join(surroundings(settings))
    return f"{settings['name']}: {light}{f', {scene}' if scene else ''}, {quantity(settings)}"


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
    """Return in words what a config's scene adds to the light or leaves out of it; nothing where it is the light alone."""
    scene = settings["scene"]
    found = [f"{name.replace('_', ' ')} fixed at {value:g}" for name, value in scene.get("fixed", {}).items()]
    ground = scene.get("ground", "black")
    if ground == "mirror":
        found.append("mirrored below the horizon")
    elif ground != "black":
        found.append(f"ground of albedo {' / '.join(f'{albedo:g}' for albedo in ground)}")
    found += [f"with {word}" for word in ("twilight", "clouds") if scene.get(word)]
    found += ["with the sun's disc"] if scene.get("sun_disc") else []
    found += ["a skyline"] if scene.get("horizon") else []
    for key, word in (("occluders", "occluder"), ("lights", "lamp")):
        count = len(scene.get(key) or ())
        found += [f"{count} {word}{'s' if count > 1 else ''}"] if count else []
    mesh = scene.get("mesh")
    found += [f"on a mesh ({str(mesh['file']).rpartition('/')[2]})"] if mesh else []
    if scene.get("channels") == "luminance":
        found.append("luminance alone")
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
