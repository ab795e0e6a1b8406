"""The measurements of error against time: truth rules, fits, evaluation, batches, lamps, scene profiles, growth of cost."""

from __future__ import annotations

from skylight_sh.studies import illuminance
from skylight_sh.studies.page import Section
from skylight_sh.studies.run import Study, Subject
from skylight_sh.studies.speed import batch, discs, evaluation, fits, growth, profiles, rules, speed


def _evaluation(on: Subject) -> Section:
    """Time evaluation, and leave its figures in ``speed.json`` too."""
    section = evaluation.section(on.samples, on.tables, on.repeats)
    speed.save(on.folder, section, on.tables, on.repeats)
    return section


SPEED = Study(
    name="bench",
    title="Benchmarks",
    lead="Error against time, measured in one run on one thread: medians after a warm-up, candidates timed in turn, so that "
    "ratios hold on a noisy machine where seconds do not. Errors are fractions.",
    sections=(
        lambda on: rules.section(on.config, on.repeats),
        lambda on: fits.section(on.samples, on.repeats),
        _evaluation,
        lambda on: batch.section(on.tables, on.repeats),
        lambda on: discs.section(on.repeats),
        lambda _: illuminance.section(),
        lambda on: profiles.section(on.config, on.samples, on.repeats),
        lambda on: growth.section(on.config),
    ),
)
