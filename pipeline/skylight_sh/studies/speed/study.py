"""The measurements of error against time: tables and rivals, batches, packed bytes, scenes, rules, fits, lamps, growth."""

from __future__ import annotations

from collections.abc import Sequence

from skylight_sh.studies import illuminance
from skylight_sh.studies.page import Section
from skylight_sh.studies.run import Study, Subject
from skylight_sh.studies.speed import (
    batch,
    contest,
    discs,
    entropy,
    evaluation,
    fits,
    growth,
    profiles,
    quoted,
    rules,
    speed,
)


def _contest(on: Subject) -> Sequence[Section]:
    """Let tables and rivals race, and leave the figures in ``speed.json`` too."""
    found = contest.hold(on.samples, on.tables, on.repeats)
    speed.save(on.folder, found)
    return [evaluation.calls(found), evaluation.rivals(found), quoted.section(found, on.config.export.recommended)]


SPEED = Study(
    name="bench",
    title="Benchmarks",
    lead="Error against time, measured in one run on one thread by its CPU clock: medians after a warm-up, candidates timed "
    "in turn, so that ratios hold on a noisy machine where times do not. What spreads by a tenth or more is flagged as "
    "noisy. Errors are fractions.",
    sections=(
        _contest,
        lambda on: batch.section(on.tables, on.config.export.recommended, on.repeats),
        lambda on: entropy.section(on.tables),
        lambda on: profiles.section(on.config, on.samples, on.repeats),
        lambda on: rules.section(on.config, on.repeats),
        lambda on: fits.section(on.samples, on.repeats),
        lambda on: discs.section(on.repeats),
        lambda on: growth.section(on.config),
        lambda _: illuminance.section(),
    ),
)
