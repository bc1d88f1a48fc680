"""Breaks the sources in small ways, one at a time, and lists those that no test notices.

    mutate.py           a sample of the mutants of all files of areas(), always the same
    mutate.py FILE...   all mutants of these files

Fails if a mutant survives that unkillable.yaml does not explain, or if that list is out of date.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import yaml

from instrument import write_copy
from mutants import Mutant, mutants_of
from suites import Suite, Tests

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
BUILD = ROOT / "build" / "mutate"
TARGETS = ["sbgc", "example_tour", "crash_faults"] + [
    f"tests_{folder}" for folder in ("core", "session", "io", "client", "emulator", "tools")
]
# The folders of the sbgc command.
TOOLS = "board bytes care care/memory command frames look look/monitor move parameters share shell values".split()
# Files of other builds, and those that cannot be included together with the rest of their folder.
SEPARATE = ("offline_commands", "system_windows", "web_socket_server")
# The first tests of a mutant take these seconds; it meets all others if it survives them and is not listed.
SECONDS = 15.0
# Many tests wait rather than compute.
AT_ONCE = 2 * (os.cpu_count() or 1)


def areas() -> list[tuple[list[str], float]]:
    """Returns files that one translation unit can include, and the share of their mutants to try."""
    core = "runtime/core/include/sbgc/**/*.hpp"
    parameters = ("parameter*.cpp", "backup_text.cpp")
    parameters += ("tasks/*param*.cpp", "tasks/restore.cpp", "tasks/profiles.cpp")
    parameters += ("tasks/variables.cpp",)
    return [
        (_files(core), 0.075),
        (_files("runtime/session/include/sbgc/**/*.hpp"), 0.15),
        (_files("runtime/any/src/*.cpp"), 0.15),
        (
            _files(
                *(f"runtime/tasks/src/{name}" for name in parameters),
                "runtime/client/src/backup.cpp",
                "runtime/io/src/atomic_file.cpp",
            ),
            0.15,
        ),
        (_files("runtime/io/src/capture*.cpp"), 0.3),
        *((_files(f"tools/{folder}/*.cpp"), 0.045) for folder in TOOLS),
        # Its libraries conflict with those of the others.
        (_files("tools/share/web_socket_server.cpp"), 0.045),
    ]


def _files(*patterns: str) -> list[str]:
    return [
        path.relative_to(ROOT).as_posix()
        for pattern in patterns
        for path in sorted(ROOT.glob(pattern))
        if "*" not in pattern or path.stem not in SEPARATE
    ]


def candidates(only: list[str]) -> tuple[list[Mutant], list[Mutant], set[str]]:
    """Returns all mutants of some files, or the sample of all; others that only show which statements of a
    file a test reaches; and the keys of all in question.
    """
    flags = compile_flags()
    found = []
    others = []
    keys = set()
    for files, share in areas():
        if only and not set(files) & set(only):
            continue
        for mutant in mutants_of(ROOT, files, flags):
            keys.add(mutant.key)
            if mutant.file in only if only else int(mutant.rank, 16) < share * 16**64:
                found.append(mutant)
            elif mutant.file.endswith(".cpp") and mutant.kind == "statement":
                others.append(mutant)
    return found, others, keys


def compile_flags() -> list[str]:
    """Returns the include folders and definitions of all targets."""
    folders = ["generated/include", "emulator/include", "emulator", "tools"]
    layers = ("core", "session", "any", "tasks", "analysis", "doctor", "io", "client")
    folders += [f"runtime/{layer}/include" for layer in layers]
    folders += ["runtime/tasks/internal", "runtime/tasks/src"]
    folders += ["runtime/client/src", "runtime/io", "runtime/io/src"]
    definitions = ["ASIO_STANDALONE", "ASIO_NO_DEPRECATED", "FMT_HEADER_ONLY"]
    return [f"-I{ROOT / folder}" for folder in folders] + [f"-D{name}" for name in definitions]


def build(mutants: list[Mutant]) -> Tests:
    """Builds the tests with all mutants as switches."""
    copy = BUILD / "source"
    copy.mkdir(parents=True, exist_ok=True)
    write_copy(ROOT, copy, mutants)
    switch = BUILD / "switch.o"
    _do(["clang++", "-O1", "-fPIC", "-c", str(HERE / "switch.cpp"), "-o", str(switch)])
    folder = BUILD / "build"
    # -Wno-c++11-narrowing: a switched number is no constant.
    flags = f"-include {HERE / 'switch.hpp'} -w -Wno-c++11-narrowing"
    _do(
        ["cmake", "--preset", "debug", "-S", str(copy), "-B", str(folder), "-DSBGC_TEST_SITE=OFF"]
        + ["-DSBGC_WERROR=OFF", "-DSBGC_REGENERATE=OFF", f"-DCMAKE_CXX_FLAGS={flags}"]
        + [f"-DCMAKE_CXX_STANDARD_LIBRARIES={switch}"],
        cwd=copy,
    )
    _do(["cmake", "--build", str(folder), "--target", *TARGETS, "--", "-k", "0"])
    return Tests(copy, folder)


def _do(command: list[str], cwd: Path = ROOT) -> None:
    done = subprocess.run(command, cwd=cwd, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        errors = [line for line in (done.stdout + done.stderr).splitlines() if "error" in line]
        sys.exit("\n".join([*errors, f"mutate: failed: {' '.join(command)}"]))


def measured(tests: Tests, pool: ThreadPoolExecutor) -> list[Suite]:
    """Runs all suites; returns those that pass, which all should, long ones in parts."""
    suites = tests.suites()
    list(pool.map(tests.measure, suites))
    parts = [part for suite in suites for part in tests.parts(suite)]
    list(pool.map(tests.measure, [part for part in parts if part not in suites]))
    for part in parts:
        if not part.passes:
            print(f"mutate: {part.name} fails without a mutant and is not used")
    return [part for part in parts if part.passes]


def chosen(number: int, of_file: set[int], suites: list[Suite]) -> tuple[list[Suite], list[Suite]]:
    """Returns the suites to run for a mutant, and those to run if it survives them.

    First come quick suites, and those that reach few other mutants; then those that reach most of its file,
    which are about its command: each call of sbgc reaches the statements that add the options of all.
    """
    reaching = [suite for suite in suites if number in suite.reached]
    reaching.sort(key=lambda suite: suite.seconds * len(suite.reached))
    first: list[Suite] = []
    others: list[Suite] = []
    seconds = SECONDS
    for suite in reaching:
        if not first or suite.seconds <= seconds:
            first.append(suite)
            seconds -= suite.seconds
        else:
            others.append(suite)
    others.sort(key=lambda suite: len(suite.reached & of_file), reverse=True)
    return first, others


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("--list", action="store_true", help="only list the mutants")
    parser.add_argument("file", nargs="*")
    arguments = parser.parse_args()
    start = time.monotonic()
    mutants, others, keys = candidates(arguments.file)
    reasons = unkillable()
    if arguments.list:
        for mutant in mutants:
            print(f"{mutant.file}:{mutant.line}: {mutant.change}")
        return
    print(f"mutate: {len(mutants)} mutants; building", flush=True)
    tests = build(mutants + others)
    files: dict[str, set[int]] = {}
    for number, mutant in enumerate(mutants + others):
        files.setdefault(mutant.file, set()).add(number)
    with ThreadPoolExecutor(AT_ONCE) as pool:
        print(
            f"mutate: running the tests without mutants (after {time.monotonic() - start:.0f} s)",
            flush=True,
        )
        suites = measured(tests, pool)
        print(
            f"mutate: {len(suites)} suites; running them with mutants (after {time.monotonic() - start:.0f} s)",
            flush=True,
        )

        def tried(number: int) -> str:
            mutant = mutants[number]
            first, more = chosen(number, files[mutant.file], suites)
            if not first:
                return "not reached"
            if not tests.survives(number, first):
                return "killed"
            if mutant.key in reasons or not more:
                return "survived"
            return "survived" if tests.survives(number, more) else "killed"

        outcomes: list[str] = []
        for outcome in pool.map(tried, range(len(mutants))):
            outcomes.append(outcome)
            if len(outcomes) % 50 == 0:
                print(
                    f"mutate: {len(outcomes)} tried, {outcomes.count('killed')} killed "
                    f"(after {time.monotonic() - start:.0f} s)",
                    flush=True,
                )
    (BUILD / "outcomes.json").write_text(
        json.dumps(
            [[m.file, m.line, m.context, m.change, o] for m, o in zip(mutants, outcomes)], indent=0
        )
    )
    sys.exit(report(mutants, outcomes, reasons, set() if arguments.file else reasons.keys() - keys))


def unkillable() -> dict[str, str]:
    """Returns the reasons why mutants change nothing, by their keys."""
    text = (HERE / "unkillable.yaml").read_text(encoding="utf-8")
    return {f"{e['file']}: {e['in']}: {e['change']}": e["reason"] for e in yaml.safe_load(text)}


def report(
    mutants: list[Mutant], outcomes: list[str], reasons: dict[str, str], outdated: set[str]
) -> int:
    """Prints the outcomes; returns the exit status."""
    problems = []
    for mutant, outcome in zip(mutants, outcomes):
        if outcome == "killed":
            if mutant.key in reasons:
                problems.append(f"{mutant.file}:{mutant.line}: killed, but listed: {mutant.change}")
        elif mutant.key not in reasons:
            problems.append(f"{mutant.file}:{mutant.line}: {outcome}: {mutant.change}")
    problems += [f"listed, but no mutant: {key}" for key in sorted(outdated)]
    for problem in problems:
        print(problem)
    counts = Counter(outcomes)
    print(
        f"mutate: {len(mutants)} mutants: {counts['killed']} killed, {counts['survived']} survived, "
        f"{counts['not reached']} not reached; {len(problems)} to look at"
    )
    return 1 if problems else 0


if __name__ == "__main__":
    main()
