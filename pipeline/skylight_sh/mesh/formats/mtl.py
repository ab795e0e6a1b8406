"""The MTL files of Wavefront OBJ: the diffuse colours and pictures of named materials."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from skylight_sh import UserError
from skylight_sh.mesh.findings import Finding

# How many words an option of a picture takes, where that is always the same.
_OPTIONS = {"-blendu": 1, "-blendv": 1, "-cc": 1, "-clamp": 1, "-mm": 2, "-texres": 1, "-imfchan": 1, "-type": 1, "-bm": 1}
_PLACED = {"-o": 0.0, "-s": 1.0, "-t": 0.0}


@dataclass(frozen=True)
class Picture:
    """A picture's file, and how it lies: texture coordinates times ``scale`` plus ``offset``."""

    path: Path
    scale: tuple[float, float] = (1.0, 1.0)
    offset: tuple[float, float] = (0.0, 0.0)


@dataclass(frozen=True)
class Material:
    """Linear ``albedo``, a ``texture`` that multiplies it, a ``relief`` (normal map) and ``opacity``."""

    albedo: tuple[float, float, float] | None = None
    texture: Picture | None = None
    relief: Picture | None = None
    opacity: float = 1.0


def read(paths: Sequence[Path]) -> tuple[dict[str, Material], list[Finding]]:
    """Return materials by name, and a finding for every file that is not there.

    ``Kd`` is taken as linear, ``map_Kd`` multiplies it. Raises UserError for a line that cannot be read.
    """
    materials: dict[str, Material] = {}
    findings = []
    for path in paths:
        if not path.is_file():
            sentence = f"No file {path.name!r} beside the mesh: its materials have no colour. Copy it there."
            findings.append(Finding(path.name, "no materials", 1, False, sentence))
            continue
        name = ""
        for number, line in enumerate(path.read_text(encoding="utf-8", errors="replace").splitlines(), 1):
            words = line.partition("#")[0].split()
            if words[:1] == ["newmtl"]:
                name = " ".join(words[1:])
                materials[name] = Material()
            elif words and name in materials:
                try:
                    materials[name] = _with(materials[name], words, path.parent)
                except (ValueError, IndexError) as error:
                    told = " ".join(words)[:60]
                    raise UserError(f"{path.name}: line {number} cannot be read: {told!r}. Should hold numbers.") from error
    return materials, findings


def _with(material: Material, words: list[str], folder: Path) -> Material:
    if words[0] == "Kd":
        numbers = [float(word) for word in words[1:4]]
        return replace(material, albedo=(numbers[0], numbers[len(numbers) // 2], numbers[-1]))
    if words[0] == "map_Kd":
        return replace(material, texture=_picture(words[1:], folder))
    if words[0] in ("norm", "map_Kn"):
        return replace(material, relief=_picture(words[1:], folder))
    if words[0] == "d":
        return replace(material, opacity=float(words[-1]))
    if words[0] == "Tr":
        return replace(material, opacity=1.0 - float(words[-1]))
    return material


def _picture(words: list[str], folder: Path) -> Picture:
    placed = {option: (default, default) for option, default in _PLACED.items()}
    at = 0
    while at < len(words) - 1 and words[at].startswith("-"):
        option = words[at]
        at += 1
        if option in _OPTIONS:
            at += _OPTIONS[option]
        elif option in _PLACED:
            numbers: list[float] = []
            while at < len(words) - 1 and len(numbers) < 3 and _is_number(words[at]):
                numbers.append(float(words[at]))
                at += 1
            placed[option] = (numbers[0], numbers[1] if len(numbers) > 1 else _PLACED[option])
        else:
            raise ValueError(option)
    # Windows' programs write backslashes.
    name = " ".join(words[at:]).replace("\\", "/")
    return Picture(folder / name, placed["-s"], placed["-o"])


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True
