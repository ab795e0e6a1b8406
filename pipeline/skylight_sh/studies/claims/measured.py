"""The README's figures, each measured afresh: gradient, pictures, ringing, a scene, a clear day, and a lit one."""

from __future__ import annotations

import itertools
import tempfile
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from skylight_sh import probe, runtime, sphere
from skylight_sh.config import load
from skylight_sh.light import MissingExtraError
from skylight_sh.light.preetham import Preetham
from skylight_sh.probe import files
from skylight_sh.quadrature import sampling
from skylight_sh.report import panorama
from skylight_sh.report import ringing as study
from skylight_sh.run.stages.lighting import sets_of
from skylight_sh.scene import clear_day as clear
from skylight_sh.studies.claims import day, gradient, scene
from skylight_sh.studies.lighting import study as lit

Array = NDArray[np.float64]

_NAMES = tuple(Preetham().domains)
_NODES = 96
_TURBIDITY = 2.5
_HEIGHTS = (0, 5, 15, 30, 50, 70, 90)
# Suns and turbidities of pictures.
_SKIES = ((0.2, 2.5), (0.9, 3.0), (1.5, 6.0))
_WIDTHS = (512, 2048)
_PICTURE_BANDS = 5
_RINGING_BANDS = 7
_RINGING_EACH = 7
_SCENE_ROWS = 1024
_SCENE_AZIMUTHS = (0.0, 120.0, 240.0)
_SCENE_SHOWN = (3, 5, 7)
_DAY_ROWS, _DAY_PATHS = 72, 64


def all_claims(root: Path, reference: Path) -> dict[str, Any]:
    """Measure everything for the configs under ``root`` and the tables of ``reference``, a released run; minutes.

    Figures are rounded to three digits, lux to whole ones, which no CPU's last bits reach. Raises OSError where there is no
    C compiler, and MissingExtraError without OpenImageIO.
    """
    parts: dict[str, Callable[[], Any]] = {
        "gradient": lambda: gradient.measure(runtime.read(reference / "export" / "skylight_sh.npz")),
        "pictures": lambda: pictures(_WIDTHS),
        "ringing": lambda: ringing(_RINGING_EACH),
        "valley": lambda: valley(root / "configs" / "valley.toml", _SCENE_ROWS),
        "lighting": lambda: lighting(root / "configs" / "preetham.toml", reference),
        "day": lambda: courtyard(root / "configs" / "courtyard.toml", _DAY_ROWS, _DAY_PATHS),
    }
    return {name: rounded(measure()) for name, measure in parts.items()} | {"daylight": daylight()}


def daylight() -> dict[str, Any]:
    """Return whole lux on the horizontal of sky and sun by the sun's height in degrees, and IES RP-21's for a clear day."""
    theta = np.radians(90.0 - np.array(_HEIGHTS))
    ours, published = clear.clear_day(theta, _TURBIDITY), clear.published(theta)
    names = ("sky", "sun", "published_sky", "published_sun")
    rows = [
        {"height": height, **dict(zip(names, (float(round(value)) for value in lux), strict=True))}
        for height, *lux in zip(_HEIGHTS, *ours, *published, strict=True)
    ]
    return {"turbidity": _TURBIDITY, "heights": rows}


def ringing(each: int) -> dict[str, Any]:
    """Return the largest undershoot of 7 bands by ground and window, a share of the same sky's own brightest value.

    Over ``each`` x ``each`` evenly spaced sets of the default config's ranges, edges among them: the study of
    ``report.ringing``.
    """
    light = Preetham()
    zeniths, turbidities = np.linspace(0.0, np.pi / 2, each), np.linspace(2.5, 6.0, each)
    sets = np.array(list(itertools.product(zeniths, turbidities)))
    colours = np.stack([_expansion(light, theta, tau, _RINGING_BANDS) for theta, tau in sets])
    weights = np.einsum("scw,c->sw", colours, light.luminance_row)
    skies = np.stack([panorama.sky(light, values, _NAMES) @ light.luminance_row for values in sets])
    found = study.measure(weights, skies, (_RINGING_BANDS,))
    shown = found.windows[:2]
    undershoot = {
        ground: {window: float(found.undershoot[g, w, 0]) for w, window in enumerate(shown)}
        for g, ground in enumerate(study.GROUNDS)
    }
    return {"bands": _RINGING_BANDS, "sets": len(sets), "undershoot": undershoot}


def pictures(widths: Sequence[int]) -> dict[str, Any]:
    """Return how far weights of a panorama are from the sky's, shares of the largest weight, the largest of three skies.

    ``exact`` by the width, in floats; ``hdr`` of the first width, written and read as Radiance HDR by OpenImageIO, and
    ``hdr_channels``: each channel's error over its own largest weight.
    """
    light, exact = Preetham(), dict.fromkeys(map(str, widths), 0.0)
    hdr, channels = 0.0, np.zeros(3)
    for values in _SKIES:
        truth = _expansion(light, *values, _PICTURE_BANDS)
        largest = np.abs(truth).max(axis=1)
        for width in widths:
            parameters = {name: np.array([value]) for name, value in zip(_NAMES, values, strict=True)}
            drawn = probe.render(light, parameters, "equirect", width // 2, width)
            off = np.abs(probe.project(drawn, "equirect", _PICTURE_BANDS, signed=True) - truth).max(axis=1)
            exact[str(width)] = max(exact[str(width)], float(off.max() / largest.max()))
            if width == widths[0]:
                read = probe.project(_through_hdr(drawn), "equirect", _PICTURE_BANDS)
                off = np.abs(read - truth).max(axis=1)
                hdr, channels = max(hdr, float(off.max() / largest.max())), np.maximum(channels, off / largest)
    by_name = dict(zip(light.channels, channels.tolist(), strict=True))
    return {"bands": _PICTURE_BANDS, "skies": len(_SKIES), "exact": exact, "hdr": hdr, "hdr_channels": by_name}


def _through_hdr(pixels: Array) -> NDArray[np.float32]:
    """Return a picture as it comes back from a Radiance HDR file: eight bits a channel and an exponent for all three."""
    try:
        import OpenImageIO
    except ImportError as error:
        raise MissingExtraError("Picture files need OpenImageIO: pip install 'skylight-sh[images]'.") from error
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "sky.hdr"
        out = OpenImageIO.ImageOutput.create(str(path))
        if out is None:
            raise OSError(f"OpenImageIO cannot write Radiance HDR: {OpenImageIO.geterror()}. Install it whole.")
        out.open(str(path), OpenImageIO.ImageSpec(pixels.shape[1], pixels.shape[0], pixels.shape[2], "float"))
        out.write_image(np.maximum(pixels, 0.0).astype(np.float32))
        out.close()
        return files.read(path).pixels


def valley(path: Path, rows: int) -> dict[str, Any]:
    """Return how far the first bands of a scene are from those of the scene itself (``scene.measure``); config ``path``.

    The sun is the config's first case, at three azimuths in degrees.
    """
    config = load(path)
    at, bands = config.report.cases[0].at, config.winners[0].bands
    suns = [(at, float(np.radians(azimuth))) for azimuth in _SCENE_AZIMUTHS]
    found = scene.measure(config, suns, bands, rows)
    shown = {str(n): dict(zip(("least", "most"), found[n], strict=True)) for n in (*_SCENE_SHOWN, bands)}
    return {"bands": bands, "azimuths": list(_SCENE_AZIMUTHS), "first": shown}


def lighting(path: Path, reference: Path) -> dict[str, Any]:
    """Return what surfaces and pictures lose by each table of ``reference``, and by its bands (``studies.lighting``).

    The largest over all sets, and of half of them: of irradiance, of a picture, and of irradiance by the number of bands.
    """
    config = load(path)
    rows = lit.section([(config, reference)], lambda *_: None).rows
    keys = {
        "irradiance": ("irradiance", "half of the sets"),
        "picture": ("picture", "half of the sets, picture"),
        "bands": ("bands", "half of the sets, bands"),
    }
    tables = {
        str(row["table"]): {key: [float(str(row[name])) for name in names] for key, names in keys.items()} for row in rows
    }
    return {"sets": len(sets_of(config)), "tables": tables}


def courtyard(path: Path, rows: int, paths: int) -> dict[str, Any]:
    """Return what lit the README's first picture and how exact it is (``day.measure``); config ``path``."""
    with tempfile.TemporaryDirectory() as folder:
        return day.measure(load(path), Path(folder), rows, paths)


def rounded(value: Any) -> Any:
    """Return JSON-like data with three digits of every float."""
    if isinstance(value, Mapping):
        return {key: rounded(inner) for key, inner in value.items()}
    if isinstance(value, list):
        return [rounded(inner) for inner in value]
    return float(f"{value:.3g}") if isinstance(value, float) else value


def _expansion(light: Preetham, theta: float, tau: float, bands: int) -> Array:
    """Return true weights ``(channels, N*N)`` of one sky."""
    held = sphere.Harmonics.even(bands)
    job = sampling.Job(light, _NAMES, np.array([[[theta, tau]]]), _NODES, held, "sun-centred")
    return np.asarray(held.unmirror(sampling.project_block(job).weights[0, 0]), dtype=np.float64)
