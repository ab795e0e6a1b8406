"""A study run: its sections measured on a config's published tables and on samples of its light, as one page."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from skylight_sh.config.schema import Config
from skylight_sh.runtime import Table
from skylight_sh.studies import page
from skylight_sh.studies.grid_samples import Samples, sample
from skylight_sh.studies.page import Section
from skylight_sh.studies.published import exported

_BANDS = 7


@dataclass(frozen=True)
class Subject:
    """What is studied: a config, its exported ``tables`` and their ``published`` E_mean by name, and samples of its light.

    Timings are medians of ``repeats`` rounds; the study's files go to ``folder``.
    """

    config: Config
    tables: Mapping[str, Table]
    published: Mapping[str, float]
    samples: Samples
    repeats: int
    folder: Path

    @property
    def recommended(self) -> Table:
        """The table that the config recommends."""
        return self.tables[self.config.export.recommended]


@dataclass(frozen=True)
class Study:
    """A page of measurements: its folder's ``name``, ``title`` and ``lead``, and what measures each section, or several."""

    name: str
    title: str
    lead: str
    sections: Sequence[Callable[[Subject], Section | Sequence[Section]]]


def run(study: Study, config: Config, reports: Path, advance: Callable[[int, int], None], repeats: int = 1) -> str:
    """Measure every section, publish ``reports/<config>/<study>/`` and return all rows as text; the run must exist.

    Raises OSError where it does not, and what a section raises.
    """
    tables, published = exported(reports / config.name)
    folder = reports / config.name / study.name
    like = tables[config.export.recommended]
    samples = sample(config, max(_BANDS, *(table.bands for table in tables.values())), like=like)
    subject = Subject(config, tables, published, samples, repeats, folder)
    sections = [partial(section, subject) for section in study.sections]
    return page.publish(folder, f"{study.title} of {config.name}", study.lead, sections, advance)
