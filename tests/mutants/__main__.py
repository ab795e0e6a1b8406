"""Draw mutants of the numerics, run the tests that concern each, and name the survivors; exit with 1 where there are any."""

from __future__ import annotations

import argparse
import functools
import itertools
import sys
import tempfile
from pathlib import Path

from . import concern, equivalents, generate, run

ROOT = Path(__file__).resolve().parents[2]
COUNT, SEED, WORKERS = 120, 1, 2


def say(text: str) -> None:
    """Print at once, wherever the output goes."""
    print(text, flush=True)


def main() -> int:
    """Run the command and return its exit code."""
    parser = argparse.ArgumentParser(prog="mutants", description=__doc__)
    parser.add_argument("--count", type=int, default=COUNT, help="how many mutants to draw (0: all)")
    parser.add_argument("--seed", type=int, default=SEED, help="which draw")
    parser.add_argument("--only", default="", metavar="PATH", help="mutants of the files whose path begins with this")
    parser.add_argument("--list", action="store_true", help="print the mutants drawn, and try none")
    parser.add_argument("--quick", type=float, metavar="SECONDS", help="ask so many seconds of tests alone, the first ones")
    options = parser.parse_args()

    every = generate.mutants(ROOT)
    known = equivalents.load()
    candidates = [one for one in every if one.path.startswith(options.only)]
    if not candidates:
        parser.error(
            f"--only {options.only}: no mutants. Should begin the path of a numeric file, such as pipeline/skylight_sh/fit."
        )
    drawn = generate.draw(candidates, options.count or len(candidates), options.seed)
    say(f"{len(drawn)} of {len(candidates)} mutants, seed {options.seed}")
    if options.list:
        say("\n".join(map(str, drawn)))
        return 0
    for path, _, before, after in known.stale(every):
        say(f"no longer there: {path}: {before!r} -> {after!r}; remove it from {equivalents.PLACE.name}")

    asked = [one for one in drawn if one not in known]
    with tempfile.TemporaryDirectory(prefix="mutants-") as folder:
        places = [run.copy(ROOT, Path(folder) / f"copy{i}") for i in range(WORKERS)]
        record = concern.measure(ROOT, places, ROOT / "build" / "mutants", say)
        if broken := sorted(record.failed - record.tools):
            say("These tests fail without any mutant; mend them first:\n" + "\n".join(broken))
            return 2
        if absent := len(record.failed & record.tools):
            say(f"{absent} tests marked `tools` fail without any mutant, for want of their tools, and are not asked")
        read = functools.cache(lambda path: (ROOT / path).read_text(encoding="utf-8"))

        def tests_of(mutant: generate.Mutant) -> list[tuple[str, float]]:
            tests = [(test, record.seconds[test]) for test in record.concerned(mutant, read)]
            ends = itertools.accumulate(seconds for _, seconds in tests)
            return [pair for pair, end in zip(tests, ends, strict=True) if not options.quick or end < options.quick]

        outcomes = run.attempt_all(places, asked, tests_of, say)
    survivors = [outcome for outcome in outcomes if not outcome.killed]
    for outcome in survivors:
        say(f"{outcome.mutant}\n    {outcome.how}")
    killed = len(outcomes) - len(survivors)
    proved = len(drawn) - len(asked)
    say(f"{len(drawn)} drawn, {killed} killed, {proved} equivalents (proved), {len(survivors)} survivors")
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main())
