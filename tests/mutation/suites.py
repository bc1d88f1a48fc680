"""The tests that mutants must fail: suites of GoogleTest programs and pytest functions."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

MOST_MUTANTS = 65536  # as in switch.cpp
PROGRAMS = (
    "core",
    "session",
    "io",
    "client",
    "client_lines",
    "emulator",
    "tools_parts",
)
PYTEST_FOLDERS = ("tests/tools", "tests/emulator/serving", "tests/crash")
# A suite of GoogleTest that takes longer is divided into its tests.
SHORT = 2.0
# The seconds of several suites that one process runs.
SHORT_GROUP = 30.0
PYTEST = [
    "generator/python",
    "--with",
    "pytest",
    "-m",
    "pytest",
    "-q",
    "-x",
    "-p",
    "no:cacheprovider",
]
# A process namespace of its own: when its first process ends, the kernel kills all others, and a mutant
# that signals wrong processes finds none.
ALONE = ["unshare", "--fork", "--kill-child", "--pid", "--mount-proc"] + (
    [] if os.geteuid() == 0 else ["--map-root-user"]
)


@dataclass(eq=False)
class Suite:
    """A suite, test or function, its seconds and the mutants that it reaches."""

    program: str  # a path in the build folder, or "pytest"
    name: str  # as the program takes it
    seconds: float = 0
    passes: bool = False
    reached: frozenset[int] = frozenset()


def groups_of(suites: list[Suite]) -> Iterator[list[Suite]]:
    """Divides suites into those that one process runs. A group is short, because it is given up only
    after twice its time if a test hangs."""
    groups: dict[str, list[Suite]] = {}
    for suite in suites:
        group = groups.setdefault(suite.program, [])
        if group and sum(one.seconds for one in group) + suite.seconds > SHORT_GROUP:
            yield group
            group = groups[suite.program] = []
        group.append(suite)
    yield from groups.values()


class Tests:
    """Runs suites in a copy of the sources with switches, built in `build`."""

    def __init__(self, copy: Path, build: Path) -> None:
        self.copy = copy
        self.build = build

    def suites(self) -> list[Suite]:
        """Returns all suites, without seconds and mutants."""
        found = []
        for program in PROGRAMS:
            (path,) = (self.build / "tests").glob(f"*/{program}_tests")
            found += [Suite(str(path), f"{name}*") for name in self._listed(path, "*")]
        collected = self._run([*PYTEST, "--collect-only", *PYTEST_FOLDERS], 120, {}).stdout
        # The parameters of a function are run together.
        names = re.findall(r"^(tests/[^\[\s]+::[^\[\s]+)", collected, re.M)
        return found + [Suite("pytest", name) for name in dict.fromkeys(names)]

    def parts(self, suite: Suite) -> list[Suite]:
        """Returns the tests of a long suite of GoogleTest, otherwise the suite."""
        if suite.program == "pytest" or suite.seconds < SHORT:
            return [suite]
        tests = self._listed(Path(suite.program), suite.name)
        return [Suite(suite.program, f"{name}{test}") for name in tests for test in tests[name]]

    def _listed(self, program: Path, pattern: str) -> dict[str, list[str]]:
        """Returns the suites of a program, as "name.", and their tests."""
        listed = self._run(
            [str(program), "--gtest_list_tests", f"--gtest_filter={pattern}"], 60, {}
        )
        found: dict[str, list[str]] = {}
        for indent, name in re.findall(r"^(  )?(\S+)(?:  # .*)?$", listed.stdout, re.M):
            if indent:
                found[list(found)[-1]].append(name)
            elif name.endswith("."):
                found[name] = []
        return found

    def measure(self, suite: Suite) -> None:
        """Runs a suite without a mutant."""
        with tempfile.NamedTemporaryFile() as reached:
            reached.truncate(MOST_MUTANTS)
            start = time.monotonic()
            suite.passes = self._passes(
                suite.program, [suite.name], 600, {"SBGC_REACHED": reached.name}
            )
            suite.seconds = time.monotonic() - start
            content = Path(reached.name).read_bytes()
        suite.reached = frozenset(number for number, byte in enumerate(content) if byte)

    def survives(self, mutant: int, suites: list[Suite]) -> bool:
        """Runs suites with a mutant until one fails."""
        return all(
            self._passes(
                group[0].program,
                [suite.name for suite in group],
                10 + 2 * sum(suite.seconds for suite in group),
                {"SBGC_MUTANT": str(mutant)},
            )
            for group in groups_of(suites)
        )

    def _passes(
        self, program: str, names: list[str], seconds: float, variables: dict[str, str]
    ) -> bool:
        if program == "pytest":
            command = [*PYTEST, *names]
        else:
            command = [
                program,
                "--gtest_fail_fast",
                f"--gtest_filter={':'.join(names)}",
            ]
        try:
            return self._run(command, seconds, variables).returncode == 0
        except subprocess.TimeoutExpired:
            return False

    def _run(
        self, command: list[str], seconds: float, variables: dict[str, str]
    ) -> subprocess.CompletedProcess[str]:
        folder = tempfile.mkdtemp(prefix="sbgc-mutant-")
        environment = {
            **os.environ,
            "SBGC": str(self.build / "tools" / "sbgc"),
            "SBGC_TOUR": str(self.build / "examples" / "example_tour"),
            "SBGC_FAULTS": str(self.build / "tests" / "crash" / "libcrash_faults.so"),
            "PYTHONPATH": os.pathsep.join(str(self.copy / folder) for folder in PYTEST_FOLDERS),
            "TMPDIR": folder,
            **variables,
        }
        try:
            return subprocess.run(
                [*ALONE, *command],
                cwd=self.copy,
                env=environment,
                stdin=subprocess.DEVNULL,
                capture_output=True,
                text=True,
                errors="replace",
                timeout=seconds,
                check=False,
            )
        finally:
            shutil.rmtree(folder, ignore_errors=True)
