"""The documentation: what it names exists, what it lists is all there is, and its examples give what they show."""

from __future__ import annotations

import csv
import doctest
import json
import re
from dataclasses import fields
from functools import cache
from pathlib import Path

import pytest
from conftest import ROOT, scene_config
from skylight_sh import runtime
from skylight_sh.cli import COMMANDS
from skylight_sh.config import load
from skylight_sh.export import targets, vectors
from skylight_sh.export.c_header import Facts
from skylight_sh.run.runner import Result
from skylight_sh.run.steps import steps
from skylight_sh.store import hdf5

DOCS = sorted((ROOT / "docs").glob("*.md"))
PAGES = [*DOCS, ROOT / "README.md", ROOT / "CONTRIBUTING.md"]
PACKAGE = ROOT / "pipeline" / "skylight_sh"
FORMATS = ROOT / "docs" / "formats.md"
WIDTH = 127
_NAME = r"(?!The|January|April|June|September|Publications?|Dissertation|Press|Books|Papers)[A-Z][a-z]{2,}"
_NAMES = rf"{_NAME}(?:, {_NAME})*(?:,? and (?:{_NAME}|others)| et al\.)?"


def text(page: Path) -> str:
    return page.read_text(encoding="utf-8")


def prose(page: Path) -> str:
    """A page without its fenced blocks."""
    return re.sub(r"^```.*?^```", "", text(page), flags=re.DOTALL | re.MULTILINE)


def section(title: str) -> str:
    """What stands under a heading of formats.md."""
    found = re.search(rf"^#+ `?{re.escape(title)}`?\n(.*?)(?=^#|\Z)", text(FORMATS), re.DOTALL | re.MULTILINE)
    assert found, title
    return found[1]


def listed(title: str) -> list[str]:
    """The names in the first column of a section's table, in their order; some rows name several."""
    first = [line.split("|")[1] for line in section(title).splitlines() if line.startswith("| `")]
    return [name for cell in first for name in re.findall(r"`([^`]+)`", cell)]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_lead_somewhere(page: Path) -> None:
    for link in re.findall(r"\]\(([^)\s]+)\)", prose(page)):
        if "://" in link:
            continue
        path, _, place = link.partition("#")
        target = (page.parent / path).resolve() if path else page
        assert target.exists(), f"{page.name}: {link}"
        assert target.is_relative_to(ROOT), f"{page.name}: {link}"
        if place:
            assert place in anchors(target), f"{page.name}: {link}"


def anchors(page: Path) -> set[str]:
    """The places that headings make, as a page's renderer names them."""
    titles = re.findall(r"^#+ (.+)$", prose(page), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_modules_and_files_that_are_named_exist(page: Path) -> None:
    """A path in code marks is one of the repository, or one under ``pipeline/skylight_sh``."""
    for name in re.findall(r"`([\w.\-]+(?:/[\w.\-]+)*\.(?:py|toml|h|j2|md)|[\w.\-]+(?:/[\w.\-]+)*/)`", prose(page)):
        places = [ROOT / name, PACKAGE / name, page.parent / name]
        written = name.startswith(
            ("reports/", "artifacts/", "export/", "skylight_sh.", "skylight_sh_direct.")
        ) or f"File `{name}`:" in text(page)
        assert written or any(place.exists() for place in places), f"{page.name} names {name}"


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_names_of_this_package_exist(page: Path) -> None:
    """``skylight_sh.a.b`` is a module, or a name in one."""
    for name in set(re.findall(r"\bskylight_sh(?:\.[a-z_]\w*)+", text(page))):
        parts = name.split(".")[1:]
        shown = f"File `{'/'.join(parts)}.py`:" in text(page)
        if shown or parts[0] in ("h", "npz", "glsl", "hlsl", "wgsl", "mjs", "cs", "d", "slang", "json", "lights"):
            continue
        assert _found(parts), f"{page.name} names {name}"


def _found(parts: list[str]) -> bool:
    for length in range(len(parts), -1, -1):
        place = PACKAGE.joinpath(*parts[:length])
        file = place / "__init__.py" if place.is_dir() else place.with_suffix(".py")
        if file.is_file():
            rest = parts[length:]
            return not rest or re.search(rf"\b{rest[0]}\b", file.read_text(encoding="utf-8")) is not None
    return False


@cache
def words() -> set[str]:
    """Every word of the package, the configs, the tests, the Makefile and the released files' names."""
    folders = (PACKAGE, ROOT / "configs", ROOT / "tests", ROOT / ".ci")
    files = [file for folder in folders for file in folder.rglob("*") if file.is_file()]
    files += [ROOT / "Makefile", ROOT / "pyproject.toml", ROOT / "reports" / "reference" / "export" / "skylight_sh.h"]
    kinds = (".py", ".j2", ".h", ".c", ".toml", ".md", "")
    found = {word for f in files if f.suffix in kinds for word in re.findall(r"[\w-]+", f.read_text(encoding="utf-8"))}
    return found | {word.rpartition("-")[2] for word in found}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_no_name_is_removed(page: Path) -> None:
    """A single word in code marks stands in the sources too, but for what a page itself defines."""
    own = set(re.findall(r"[\w-]+", "".join(re.findall(r"^```.*?^```", text(page), re.DOTALL | re.MULTILINE))))
    placeholders = re.compile(r"[Pp]_\w+|<\w+>")
    for name in set(re.findall(r"`([A-Za-z_][\w-]{2,})`", prose(page))):
        assert name in words() | own or placeholders.match(name), f"{page.name} names {name}"


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_commands_and_targets_that_are_named_exist(page: Path) -> None:
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    for target in set(re.findall(r"`make (\w+)", text(page))):
        assert re.search(rf"^{target}:", makefile, re.MULTILINE), f"{page.name}: make {target}"
    for command in set(re.findall(r"(?:`|^)skylight-sh ([a-z]\w+)", text(page), re.MULTILINE)):
        assert command in COMMANDS, f"{page.name}: skylight-sh {command}"


@pytest.mark.parametrize("page", DOCS, ids=lambda page: page.name)
def test_examples_give_what_they_show(page: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    done = doctest.testfile(str(page), module_relative=False, optionflags=doctest.NORMALIZE_WHITESPACE)
    assert done.failed == 0


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_lines_are_short_and_fences_close(page: Path) -> None:
    assert text(page).count("\n```") % 2 == 0
    for line in prose(page).splitlines():
        # A table's row and a formula cannot be broken.
        assert len(line) <= WIDTH or line.startswith(("|", "$$")), line


@pytest.mark.parametrize("kind", runtime.KINDS, ids=str)
def test_every_field_of_a_table_is_listed(kind: str) -> None:
    assert listed(kind) == [field.name for field in fields(runtime.KINDS[kind])]


def test_versions_and_steps_are_the_ones_told() -> None:
    assert f"`format`, {runtime.FORMAT}, and" in section("The NPZ of a table")
    assert f"layout of the store, {hdf5.SCHEMA_VERSION} |" in section("The artifact store")
    assert f"version of the format, {vectors.FORMAT} |" in section("Test vectors")
    told = section("Program")
    assert all(f"`{name}`" in told for name in runtime.FUNCTIONS)
    assert "`+ - * /`" in told


def test_errors_and_summary_have_the_columns_listed(small_run: Result) -> None:
    axes = ("sun_zenith", "turbidity")
    columns = [c.replace("<axis>", axis) for c in listed("errors.csv and references.csv") for axis in _each(c, axes)]
    for name, more in (("errors.csv", []), ("references.csv", ["note"])):
        with (small_run.folder / name).open(encoding="utf-8", newline="") as file:
            assert next(csv.reader(file)) == [*columns, *more]
    rows = json.loads((small_run.folder / "summary.json").read_text(encoding="utf-8"))["tables"]
    assert [list(row) for row in rows] == [listed("summary.json")] * len(rows)
    assert set(json.loads((small_run.folder / "run.json").read_text(encoding="utf-8"))) == set(listed("run.json"))


def _each(column: str, axes: tuple[str, ...]) -> tuple[str, ...]:
    return axes if "<axis>" in column else axes[:1]


def test_every_step_of_the_store_is_listed() -> None:
    """Those of five configs and of a scene with a mesh, which have every step there is, and no others."""
    configs = [
        load(ROOT / "configs" / f"{name}.toml") for name in ("preetham", "black-box", "clear-day", "valley", "papers-scenes")
    ]
    configs.append(scene_config('mesh = { file = "courtyard", bands = 3 }'))
    names = {step.name for config in configs for step in steps(config)}
    told = section("The artifact store").partition("What the steps hold:")[2]
    rows = [line.split("|")[1] for line in told.splitlines() if line.startswith("| `")]
    assert names == {name for row in rows for name in re.findall(r"`([^`]+)`", row)}


def test_keys_of_vectors_are_listed(small_run: Result) -> None:
    sky = runtime.read(small_run.folder / "export" / "skylight_sh.npz")
    lines = vectors.write(sky).splitlines()
    assert [line.split()[0] for line in lines[:7]] == listed("Test vectors")


def test_macros_and_functions_of_the_header_are_there(small_run: Result) -> None:
    header = (small_run.folder / "export" / "skylight_sh.h").read_text(encoding="utf-8")
    for name in listed("The C header"):
        plain = name.partition("(")[0].replace("<AXIS>", "SUN_ZENITH")
        whole = re.sub(r"^P_", "SKYLIGHT_SH_", re.sub(r"^p_", "skylight_sh_", plain))
        assert re.search(rf"\b{whole}\b", header), whole


def test_names_of_the_direct_header_are_there(small_run: Result) -> None:
    table = runtime.read(small_run.folder / "export" / "skylight_sh.npz")
    facts = Facts("a sky", 0.01, 0.02, "per-set", [])
    header = targets.write(("direct",), table, facts, "skylight_sh")["skylight_sh_direct.h"].decode()
    for name in listed("The direct header"):
        plain = name.partition("(")[0].replace("<AXIS>", "SUN_ZENITH")
        whole = re.sub(r"^P_", "SKYLIGHT_SH_DIRECT_", re.sub(r"^p_", "skylight_sh_direct_", plain))
        assert re.search(rf"\b{whole}\b", header), whole


def test_names_of_shaders_modules_and_classes_are_there(small_run: Result) -> None:
    table = runtime.read(small_run.folder / "export" / "skylight_sh.npz")
    facts = Facts("a sky", 0.01, 0.02, "per-set", [])
    written = targets.write(("glsl", "hlsl", "wgsl", "javascript", "csharp"), table, facts, "skylight_sh")
    assert len(written) == 6
    titles = {"mjs": "The JavaScript module", "mts": "The JavaScript module", "cs": "The C# class"}
    for file, data in written.items():
        for name in listed(titles.get(file.rpartition(".")[2], "The shaders")):
            plain = name.partition("(")[0].replace("<Axis>", "SunZenith")
            whole = re.sub(r"^P_", "SKYLIGHT_SH_", re.sub(r"^p_", "skylight_sh_", plain))
            assert re.search(rf"\b{whole}\b", data.decode()), f"{file}: {whole}"


def test_every_registry_is_told() -> None:
    """In the architecture by its name and file, and in the worked examples by a line in that file."""
    told, shown = (text(ROOT / "docs" / f"{name}.md") for name in ("architecture", "extending"))
    found = 0
    for path in PACKAGE.rglob("*.py"):
        for name in re.findall(r"^([A-Z_]+): Registry\[", text(path), re.MULTILINE):
            place = path.relative_to(PACKAGE).as_posix()
            assert f"| `{name}` | `{place}` |" in told, name
            assert f"Line in `{place}`:" in shown, name
            found += 1
    assert found >= 8


def test_every_citation_has_an_entry() -> None:
    """``Name 2008``, ``Name and Other 2001``, ``Name et al. 1999``, as docstrings and pages write them."""
    entries = text(ROOT / "docs" / "references.md")
    cited = {}
    for path in [*PACKAGE.rglob("*.py"), *PACKAGE.rglob("*.j2"), *DOCS]:
        for names, year in re.findall(rf"({_NAMES}),? \(?((?:19|20)\d\d)\b", text(path)):
            cited[f"{names} {year}"] = path.name
    assert len(cited) > 25
    for citation, where in sorted(cited.items()):
        first, year = re.split(r",| ", citation)[0], citation[-4:]
        assert re.search(rf"\b{first}\b[^|]*\b{year}\b", entries), f"{where} cites {citation}"


def test_every_reference_is_used() -> None:
    """A row's modules cite it."""
    for row in re.findall(r"^\| .* \|$", text(ROOT / "docs" / "references.md"), re.MULTILINE):
        citation, _, used = (cell.strip() for cell in row.strip("|").split(" | "))
        if citation == "citation":
            continue
        for name in re.findall(r"`([\w/]+\.py)`", used):
            source = text(PACKAGE / name)
            words = re.findall(r"[A-Z][A-Za-z']+|\d{4}", citation)
            assert any(word in source for word in words), f"{name} does not cite {citation}"


def test_every_part_of_the_mathematics_names_its_module_and_source() -> None:
    parts = re.split(r"^## ", text(ROOT / "docs" / "mathematics.md"), flags=re.MULTILINE)[1:]
    for part in parts:
        opening = part.partition("\n\n")[2].partition("\n\n")[0]
        assert re.match(r"Modules?: `[\w/]+(\.py|/)`", opening), part[:60]
        assert "Source:" in opening, part[:60]


def test_bits_are_those_of_the_code() -> None:
    told = text(ROOT / "docs" / "mathematics.md").partition("## The same bits")[2]
    rows = [
        [cell.strip() for cell in line.strip("|").split("|")] for line in told.splitlines() if "bits" in line and "|" in line
    ]
    assert len(rows) > 7
    for number, kept, where in rows:
        source = text(PACKAGE / where.strip("`"))
        for bits in re.findall(r"\b\d\d?\b(?= bits| \(float64)", kept):
            assert re.search(rf"_BITS = .*\b{bits}\b|significant\(.*, {bits}\)", source), number


def test_formulas_are_what_their_renderer_keeps() -> None:
    """It takes a backslash before punctuation away, and knows no ``operatorname``."""
    for page in DOCS:
        for formula in re.findall(r"\$\$.+?\$\$|\$[^$\n]+\$", prose(page)):
            assert not re.search(r"\\[^A-Za-z]|operatorname|[_^]\*", formula), f"{page.name}: {formula}"
            assert formula.count("{") == formula.count("}"), f"{page.name}: {formula}"
            for opening, closing in (("left", "right"), ("begin", "end")):
                pairs = [len(re.findall(rf"\\{part}(?![a-z])", formula)) for part in (opening, closing)]
                assert pairs[0] == pairs[1], f"{page.name}: {formula}"
