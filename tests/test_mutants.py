"""The mutants themselves: what is changed, what is not, that a draw is reproducible, and that tests kill and miss."""

from __future__ import annotations

from pathlib import Path

import pytest
from mutants import equivalents, generate, run, text

TOY = b'''"""A docstring of 3 words."""

SIZE: int = 7


def area(width: float, factor: float = 0.5) -> float:
    """Return 2."""
    if width <= 0.0:
        raise ValueError(f"Should be more than {0 + 1}.")
    return factor * width + 1e-3 - -SIZE  # 4 - 3


text = "a" + "b" * len("abc")
same = text == "abbb"
'''
TEST = """from skylight_sh.light.toy import area


def test_area():
    assert abs(area(2.0) - 8.001) < 1e-3
"""
C = "/* 1 + 1 */ if (a[2] < b->c && {{ x - 1 }} != 3u) { t -= 1.5f * u; ++i; } // 2\n"


def test_numbers_signs_and_comparisons_of_python_change_and_nothing_else() -> None:
    found = {(one.line, one.after) for one in generate.of_file("pipeline/skylight_sh/light/toy.py", TOY)}
    last = "return factor * width + 1e-3 - -SIZE  # 4 - 3"
    assert found == {
        (3, "SIZE: int = 8"),
        (6, "def area(width: float, factor: float = 0.505) -> float:"),
        (8, "if width < 0.0:"),
        (8, "if width > 0.0:"),
        (8, "if width <= 1.0:"),
        (10, last.replace("factor *", "factor /")),
        (10, last.replace("+ 1e-3", "- 1e-3")),
        (10, last.replace("1e-3", "0.01")),
        (10, last.replace("- -SIZE", "+ -SIZE")),
        (10, last.replace("- -SIZE", "- SIZE")),
    }


def test_numbers_signs_and_comparisons_of_c_change_and_nothing_else() -> None:
    found = {C[:start] + new + C[end:] for start, end, new in text.changes(C)}
    changes = [("a[2]", "a[3]"), ("<", "<="), ("<", ">="), ("!=", "=="), ("3u", "4u"), ("-= 1.5f", "+= 1.5f")]
    changes += [("1.5f", "1.515f"), ("f * u", "f / u")]
    assert found == {C.replace(before, after, 1) for before, after in changes}


def test_c_in_python_strings_changes_and_prose_does_not() -> None:
    source = b'X = f"t[{i}] = 2 * u;"\nABOUT = "as of 1.5 it takes two"\n'
    found = {one.after for one in generate.of_file("pipeline/skylight_sh/export/shaders.py", source)}
    assert found == {'X = f"t[{i}] = 3 * u;"', 'X = f"t[{i}] = 2 / u;"'}


def test_every_mutant_of_a_module_is_python() -> None:
    root = Path(__file__).resolve().parents[1]
    path = "pipeline/skylight_sh/export/shaders.py"
    source = (root / path).read_bytes()
    for mutant in generate.of_file(path, source):
        compile(mutant.applied(source), path, "exec")


def test_a_draw_is_reproducible_and_does_not_depend_on_other_files() -> None:
    toy = generate.of_file("pipeline/skylight_sh/light/toy.py", TOY)
    other = generate.of_file("pipeline/skylight_sh/light/other.py", TOY)
    drawn = generate.draw(toy, 4, seed=1)
    assert drawn == generate.draw(toy, 4, seed=1)
    assert drawn != generate.draw(toy, 4, seed=2)
    both = {one for one in generate.draw(toy + other, 8, seed=1) if one.path == toy[0].path}
    assert both == set(generate.draw(toy, len(both), seed=1))
    assert generate.draw(toy, len(toy), seed=3) == toy


def test_tests_kill_a_mutant_and_miss_another(tmp_path: Path) -> None:
    place = tmp_path / "copy"
    for path, contents in {
        "pipeline/skylight_sh/light/toy.py": TOY.decode(),
        "pipeline/skylight_sh/__init__.py": "",
        "pipeline/skylight_sh/light/__init__.py": "",
        "tests/test_toy.py": TEST,
        "pytest.ini": "[pytest]\n",
    }.items():
        (place / path).parent.mkdir(parents=True, exist_ok=True)
        (place / path).write_text(contents, encoding="utf-8")
    mutants = generate.of_file("pipeline/skylight_sh/light/toy.py", TOY)
    seen, missed = (next(one for one in mutants if one.after == after) for after in ("SIZE: int = 8", "if width < 0.0:"))
    tests = [("tests/test_toy.py::test_area", 0.01)]
    said: list[str] = []
    outcomes = run.attempt_all([place], [seen, missed], lambda _: tests, said.append)
    assert [outcome.killed for outcome in outcomes] == [True, False]
    assert outcomes[0].how == tests[0][0]
    assert [line.split()[1] for line in said[:2]] == ["killed", "SURVIVED"]
    assert (place / "pipeline" / "skylight_sh" / "light" / "toy.py").read_bytes() == TOY
    assert not run.Outcome(missed, killed=False, asked=0, how="").killed


def test_an_equivalent_needs_a_proof_and_its_line() -> None:
    mutants = generate.of_file("pipeline/skylight_sh/light/toy.py", TOY)
    file = "pipeline/skylight_sh/light/toy.py"
    entry = f'[[mutant]]\nfile = "{file}"\nwithin = ""\nbefore = "SIZE: int = 7"\nafter = "SIZE: int = 8"\n'
    known = equivalents.Equivalents(f'{entry}proof = "Nobody reads it."')
    assert [one.after for one in mutants if one in known] == ["SIZE: int = 8"]
    assert not known.stale(mutants)
    assert len(known.stale(mutants[1:])) == 1
    with pytest.raises(ValueError, match="proof"):
        equivalents.Equivalents(f'{entry}proof = ""')
