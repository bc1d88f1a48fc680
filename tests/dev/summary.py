"""Summarizes a run of ctest from the JUnit file of `ctest --output-junit FILE`.

The exit status is 1 if a test was skipped: `./dev test` installs the requirements of all tests, so each
can run. Cases that a test program itself skips, because they do not apply to this machine, are listed.
"""

from __future__ import annotations

import re
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

# A skipped case in the output of GoogleTest or of pytest with -rs.
SKIPPED_CASE = re.compile(
    r"^(?:\[  SKIPPED \] (\w+\.\w+) \(\d+ ms\)|SKIPPED \[\d+\] (.+))$", re.MULTILINE
)


def skipped_cases(output: str) -> list[str]:
    """Returns the names of the skipped cases in the output of one test."""
    return [googletest or pytest for googletest, pytest in SKIPPED_CASE.findall(output)]


def summarize(report: Path) -> tuple[list[str], bool]:
    """Returns the lines to print, and True if every test has run."""
    results: dict[str, list[str]] = {"run": [], "fail": [], "notrun": []}
    cases, reasons = [], []
    for test in ET.parse(report).getroot().iter("testcase"):
        name, output = test.get("name", ""), test.findtext("system-out", "").strip()
        results[test.get("status", "fail")].append(name)
        if test.get("status") == "notrun":
            reasons.append(f"  {name}: {output.splitlines()[-1] if output else 'did not run'}")
        cases += [f"  {name}: {case}" for case in skipped_cases(output)]
    lines = []
    if cases:
        lines += ["Cases that do not apply to this machine:", *cases]
    if results["fail"]:
        lines += ["Failed:", *(f"  {name}" for name in results["fail"])]
    if reasons:
        lines += ["Skipped, although each test must run:", *reasons]
    numbers = (len(results[status]) for status in ("run", "fail", "notrun"))
    lines.append("tests: {} passed, {} failed, {} skipped".format(*numbers))
    return lines, not reasons


def main() -> int:
    lines, complete = summarize(Path(sys.argv[1]))
    print("\n".join(lines))
    return 0 if complete else 1


if __name__ == "__main__":
    sys.exit(main())
