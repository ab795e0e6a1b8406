"""Headers in programs of one and of several units, C and C++: one implementation, any two tables, and what is refused."""

from __future__ import annotations

import itertools
import re
import subprocess
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from c_programs import FACTS as COLOURS
from conftest import ROOT
from skylight_sh import runtime
from skylight_sh.export import c_header, evaluators, prefixes
from skylight_sh.run.runner import Result
from skylight_sh.runtime import Table
from skylight_sh.studies.stability.flavours import flavours

FLAVOURS = flavours()
FACTS = replace(COLOURS, luminance=())
WARNINGS = ["-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-pedantic", "-Werror"]
BUILDS = {
    "gcc": ["gcc", "-std=c99", "-O2", *WARNINGS],
    "clang": ["clang", "-std=c99", "-O2", *WARNINGS],
    "g++": ["g++", "-x", "c++", "-std=c++11", "-O2", *WARNINGS],
    "clang++": ["clang++", "-x", "c++", "-std=c++11", "-O2", *WARNINGS],
}
UNIT = """{defines}
#include <stdio.h>
#include "day.h"
#include "night.h"
#include "day.h"
void {name}(void);
void {name}(void)
{{
    static const float reflects[DAY_SH_CHANNELS] = {{ 0.1f, 0.2f, 0.3f }};
    float w[DAY_SH_CHANNELS][DAY_SH_WEIGHTS], v[NIGHT_SH_CHANNELS][NIGHT_SH_WEIGHTS], direction[3];
    int status = day_sh_weights(0.8f, 0.3f, 3.0f, w) + night_sh_weights_bands(0.8f, 0.3f, 3.0f, 3, v);
    printf("%d %.9g %.9g\\n", status, (double)w[1][2], (double)v[1][2]);
    status = day_sh_dominant(w, direction);
    day_sh_ground(reflects, w);
    night_sh_window(3, v);
    printf("%d %.9g %.9g %.9g\\n", status, (double)direction[0], (double)w[2][0], (double)v[0][2]);
}}
"""
MAIN = "{declared}\nint main(void)\n{{\n{calls}    return 0;\n}}\n"


def two(folder: Path) -> tuple[Table, Table]:
    """A fast and a packed table under two prefixes."""
    tables = FLAVOURS["rows"], FLAVOURS["packed"]
    for name, table in zip(("day", "night"), tables, strict=True):
        (folder / f"{name}.h").write_text(c_header.write(table, FACTS, f"{name}_sh"), encoding="utf-8")
    return tables


def built(folder: Path, command: Sequence[str], units: Sequence[str]) -> str:
    """Compile ``units`` and a main, link them, and return what the program prints."""
    names = [f"unit_{k}" for k in range(len(units))]
    sources = {name: UNIT.format(defines=defines, name=name) for name, defines in zip(names, units, strict=True)}
    declared, calls = "\n".join(f"void {n}(void);" for n in names), "".join(f"    {n}();\n" for n in names)
    sources["main"] = MAIN.format(declared=declared, calls=calls)
    for name, text in sources.items():
        (folder / f"{name}.c").write_text(text, encoding="utf-8")
    done = subprocess.run(
        [*command, *(f"{name}.c" for name in sources), "-o", "program", "-lm"],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return subprocess.run(["./program"], cwd=folder, capture_output=True, text=True, check=True).stdout


DECLARING = "#define DAY_SH_EXTERN\n#define NIGHT_SH_EXTERN"
HOLDING = f"{DECLARING}\n#define DAY_SH_IMPLEMENTATION\n#define NIGHT_SH_IMPLEMENTATION"


@pytest.mark.parametrize("build", ["gcc", "g++"])
@pytest.mark.parametrize("units", [[""], ["", "", ""], [HOLDING], [DECLARING, HOLDING, DECLARING]], ids=repr)
def test_two_tables_meet_in_one_program(tmp_path: Path, build: str, units: list[str]) -> None:
    day, night = (runtime.Runtime(table) for table in two(tmp_path))
    expected = day.weights(0.8, 0.3, 3.0), night.weights(0.8, 0.3, 3.0, bands=3)
    lines = built(tmp_path, BUILDS[build], units).splitlines()
    assert len(lines) == 2 * len(units)
    for first, second in (
        itertools.batched(lines, 2) if hasattr(itertools, "batched") else zip(*[iter(lines)] * 2, strict=True)
    ):
        status, a, b = map(float, first.split())
        assert status == 0
        assert (a, b) == (pytest.approx(expected[0][1][2], rel=1e-5), pytest.approx(expected[1][1][2], rel=1e-5))
        assert second.split()[0] == "0"


@pytest.mark.tools
@pytest.mark.parametrize("build", ["clang", "clang++"])
def test_another_compiler_takes_them_too(tmp_path: Path, build: str) -> None:
    two(tmp_path)
    plain, held = (built(tmp_path, BUILDS[build], units).split() for units in (["", ""], [DECLARING, HOLDING]))
    assert [float(v) for v in plain] == pytest.approx([float(v) for v in held], rel=1e-5)


def test_c_calls_what_cpp_holds(tmp_path: Path) -> None:
    """Names are C's in both languages."""
    two(tmp_path)
    for name, defines in (("holding", HOLDING), ("calling", DECLARING)):
        (tmp_path / f"{name}.c").write_text(UNIT.format(defines=defines, name=name), encoding="utf-8")
    main = '#ifdef __cplusplus\nextern "C"\n#endif\nvoid calling(void);\nint main(void) { calling(); return 0; }\n'
    (tmp_path / "main.c").write_text(main, encoding="utf-8")
    subprocess.run([*BUILDS["g++"], "-c", "holding.c"], cwd=tmp_path, check=True)
    subprocess.run([*BUILDS["gcc"], "-c", "calling.c", "main.c"], cwd=tmp_path, check=True)
    subprocess.run(["g++", "holding.o", "calling.o", "main.o", "-o", "both", "-lm"], cwd=tmp_path, check=True)
    assert subprocess.run(["./both"], cwd=tmp_path, capture_output=True, check=True).stdout


def text_of(folder: Path, unit: str) -> int:
    (folder / "sized.c").write_text(unit, encoding="utf-8")
    subprocess.run(["gcc", "-std=c99", "-O2", "-c", "sized.c"], cwd=folder, check=True)
    out = subprocess.run(["size", "sized.o"], cwd=folder, capture_output=True, text=True, check=True).stdout
    return int(out.splitlines()[1].split()[0])


def test_a_program_holds_the_table_once(tmp_path: Path) -> None:
    """Of three units, two take a few hundred bytes more than their call; plainly included each takes the table."""
    table = FLAVOURS["rows"]
    (tmp_path / "sky.h").write_text(c_header.write(table, FACTS, "sky_sh"), encoding="utf-8")
    head = "int call(float z, float w[3][49])"
    call = f'#include "sky.h"\n{head};\n{head} {{ return sky_sh_weights(z, 0.0f, 3.0f, w); }}\n'
    rows = table.body.rows.nbytes
    plain = text_of(tmp_path, call)
    declaring = text_of(tmp_path, f"#define SKY_SH_EXTERN\n{call}")
    holding = text_of(tmp_path, f"#define SKY_SH_EXTERN\n#define SKY_SH_IMPLEMENTATION\n{call}")
    assert plain > rows
    assert declaring < 200
    assert rows < holding < 2 * rows + 40_000


ASKED = '#include "sky.h"\n'
REFUSED = {
    "a holding unit that does not declare": (
        "#define SKY_SH_IMPLEMENTATION\n" + ASKED,
        "Define SKY_SH_EXTERN in every unit",
    ),
    "declared too late": (f"{ASKED}#define SKY_SH_EXTERN\n{ASKED}", "before this file is included for the first time"),
    "declared no more": (f"#define SKY_SH_EXTERN\n{ASKED}#undef SKY_SH_EXTERN\n{ASKED}", "Leave SKY_SH_EXTERN defined"),
    "another table's prefix": (f'{ASKED}#include "other.h"\n', "Another table has the prefix sky_sh already"),
}


@pytest.mark.parametrize("why", REFUSED)
def test_what_cannot_work_is_refused(tmp_path: Path, why: str) -> None:
    source, message = REFUSED[why]
    for name, table in (("sky", FLAVOURS["one-axis"]), ("other", FLAVOURS["rows"])):
        (tmp_path / f"{name}.h").write_text(c_header.write(table, FACTS, "sky_sh"), encoding="utf-8")
    (tmp_path / "asked.c").write_text(source, encoding="utf-8")
    done = subprocess.run(
        ["gcc", "-std=c99", "-fsyntax-only", "asked.c"], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert done.returncode != 0
    assert message in done.stderr


@pytest.mark.parametrize(
    ("compiler", "message"), [(["gcc", "-std=c90"], "C99"), (["g++", "-x", "c++", "-std=c++98"], "C++11")]
)
def test_older_languages_are_refused(tmp_path: Path, compiler: list[str], message: str) -> None:
    (tmp_path / "sky.h").write_text(c_header.write(FLAVOURS["one-axis"], FACTS, "sky_sh"), encoding="utf-8")
    (tmp_path / "asked.c").write_text(ASKED, encoding="utf-8")
    done = subprocess.run([*compiler, "-fsyntax-only", "asked.c"], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert f"needs {message} or later" in done.stderr


def test_a_table_may_come_twice(tmp_path: Path) -> None:
    """The same header, or an equal copy of it."""
    text = c_header.write(FLAVOURS["one-axis"], FACTS, "sky_sh")
    for name in ("sky", "copy"):
        (tmp_path / f"{name}.h").write_text(text, encoding="utf-8")
    (tmp_path / "asked.c").write_text(f'{ASKED}#include "copy.h"\n{ASKED}int main(void) {{ return 0; }}\n', encoding="utf-8")
    subprocess.run([*BUILDS["gcc"], "-fsyntax-only", "asked.c"], cwd=tmp_path, check=True)


@pytest.mark.parametrize("name", FLAVOURS)
def test_headers_are_read_with_ease(name: str) -> None:
    """Lines of at most 100 columns under a long prefix too, no name that ends in a number, no mark of the exporter's."""
    long = "a" * prefixes.LONGEST
    for prefix in ("skylight_sh", long):
        text = c_header.write(FLAVOURS[name], FACTS, prefix)
        # What is wider is one name alone.
        assert not [line for line in text.splitlines() if len(line) > 100 and " " in line.strip(" */\\")]
        assert prefix == long or max(map(len, text.splitlines())) <= 100
    assert not re.search(r"\b(HAS|IS|TAKES)_[A-Z]|#include \"", text)
    own = set(re.findall(r"\baaa+_(\w+)", text))
    assert own
    assert not [one for one in own if re.search(r"\d$", one)]


def test_inputs_are_const(tmp_path: Path) -> None:
    (tmp_path / "sky.h").write_text(c_header.write(FLAVOURS["rows"], FACTS, "sky_sh"), encoding="utf-8")
    source = """#include "sky.h"
int call(const float w[3][49], float direction[3], const float *angles, float out[2][3][49]);
int call(const float w[3][49], float direction[3], const float *angles, float out[2][3][49])
{
    return sky_sh_dominant(w, direction) + sky_sh_weights_batch(2, angles, angles, angles, out);
}
"""
    (tmp_path / "asked.c").write_text(source, encoding="utf-8")
    for build in ("gcc", "g++"):
        subprocess.run([*BUILDS[build], "-c", "asked.c", "-o", "asked.o"], cwd=tmp_path, check=True)


def test_the_released_tables_have_prefixes_of_their_own(small_run: Result) -> None:
    rows = small_run.summary["tables"]
    found = {row["name"]: row["prefix"] for row in rows}
    assert found[small_run.summary["recommended"]] == "skylight_sh"
    assert len(set(found.values())) == len(rows)
    assert found["4-bands-1pct-packed"] == "skylight_sh_4_bands_1pct_packed"
    for row in rows:
        text = (small_run.folder / row["path"] / "skylight_sh.h").read_text(encoding="utf-8")
        assert f"int {row['prefix']}_weights(float sun_zenith" in " ".join(text.split())
        assert max(map(len, text.splitlines())) <= 100


def test_prefixes_are_identifiers_and_differ() -> None:
    names = ["7-bands-0.1pct", "7-bands-0-1pct", f"7-bands-{'9' * 80}-bytes", "Sky"]
    found = prefixes.by_table(names, "7-bands-0-1pct", "skylight_sh")
    assert found["7-bands-0-1pct"] == "skylight_sh"
    assert len(set(found.values())) == len(names)
    for prefix in found.values():
        prefixes.check(prefix)
        assert "__" not in prefix
    assert (
        len(prefixes.by_table(["7-bands-0.1pct", "7-bands-0-1pct"], "", "p"))
        == len({*prefixes.by_table(names, "", "p")}) - 2
    )


def test_the_evaluator_is_c_as_it_stands(tmp_path: Path) -> None:
    """Its files, beside the data and formulas of one table that ``example.h`` holds, compile without an export."""
    folder = ROOT / "pipeline" / "skylight_sh" / "export" / "evaluators" / "c"
    example = c_header.example(FLAVOURS["surrounded"], FLAVOURS["twilight-packed"])
    assert (folder / "example.h").read_text(encoding="utf-8") == example
    for path in sorted(folder.glob("*.h")):
        if path.name == "requirements.h":
            continue
        for command in (["gcc", "-std=c99"], ["g++", "-std=c++11", "-x", "c++"]):
            (tmp_path / "one.c").write_text(f'#include "{path}"\n', encoding="utf-8")
            done = subprocess.run(
                [*command, "-fsyntax-only", str(tmp_path / "one.c")], capture_output=True, text=True, check=False
            )
            assert done.stderr == "", path.name


def test_conditions_of_a_part_are_kept_or_left_out() -> None:
    text = evaluators.part("c/turn.h", {"IS_MIRRORED"})
    other = evaluators.part("c/turn.h", set())
    assert "skylight_sh_turn_all" in other
    assert "skylight_sh_turn_all" not in text
    assert not re.search(r"#if !?SKYLIGHT_SH_(HAS|IS|TAKES)_|#include", text + other)
    assert np.all([len(one.splitlines()) > 5 for one in (text, other)])
