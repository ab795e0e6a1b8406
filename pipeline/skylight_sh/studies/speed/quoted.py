"""What engines themselves say of their skylight's cost, with where they say it, beside one of ours: quoted, not measured."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from skylight_sh.studies.page import Row, Section
from skylight_sh.studies.speed.contest import Contest

TEXT = (
    "Engines render their sky, project the picture on the GPU and read it back. These figures are theirs or their users', "
    "of their machines: quoted with their sources, not measured here. Our row is the recommended table, on this machine's "
    "CPU, of this run; it lacks whatever else such a picture shows, clouds for instance."
)


@dataclass(frozen=True)
class Quoted:
    """An engine's ``way`` of lighting by its sky, what is told of its cost, and the ``source`` that tells it."""

    way: str
    told: str
    source: str
    ms: float | None = None
    frames_late: int | None = None


QUOTED = (
    Quoted(
        "Unreal Engine: RecaptureSky",
        "the documentation warns of a high cost and a certain hitch",
        "https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/USkyLightComponent/RecaptureSky",
    ),
    Quoted(
        "Unreal Engine 4: a sky light's new cube map",
        "a user's profile: the filter just below 5 ms, diffuse irradiance just below 6 ms, a VR frame's whole time",
        "https://answers.unrealengine.com/questions/444046/view.html",
        ms=11.0,
    ),
    Quoted(
        "Unity HDRP: dynamic ambient probe",
        "the documentation: computed on the GPU and read back, always a frame late",
        "https://docs.unity3d.com/Packages/com.unity.render-pipelines.high-definition@17.0/manual/ambient-light-probe.html",
        frames_late=1,
    ),
    Quoted(
        "Bevy: AtmosphereEnvironmentMapLight",
        "a user's measurement on an integrated GPU: 58 frames a second without, 13 with it",
        "https://github.com/bevyengine/bevy/issues/24517",
        ms=round(1000 / 13 - 1000 / 58, 0),
    ),
    Quoted(
        "Godot: SH sky, proposed",
        "a pull request, open: two bands from 1,024 samples of the sky, in place of 64; its speed not measured",
        "https://github.com/godotengine/godot/pull/108127",
    ),
)


def section(contest: Contest, recommended: str) -> Section:
    """Return the quoted costs, and the ``recommended`` table's own, as measured."""
    ours: Mapping[str, object] = {
        "way": f"this table: {recommended}",
        "ms": 1e3 * contest.results["portable"].warm.time(recommended).median,
        "frames late": 0,
        "told": "measured in this run, -O3, warm",
        "source": "evaluation",
    }
    rows: list[Row] = [ours]
    rows += [{"way": q.way, "ms": q.ms, "frames late": q.frames_late, "told": q.told, "source": q.source} for q in QUOTED]
    return Section("engines", "What engines pay", TEXT, rows)
