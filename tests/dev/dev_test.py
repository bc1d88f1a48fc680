"""Tests of the messages of ./dev about the tests and the machine."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent
TESTS = {
    "good": 'add_test(good "true")',
    "bad": 'add_test(bad "false")',
    "skipped": 'add_test(skipped "echo" "skipped: there is no Node")\n'
    'set_tests_properties(skipped PROPERTIES SKIP_REGULAR_EXPRESSION "^skipped: ")',
    "cases": 'add_test(cases "printf" "[  SKIPPED ] Ports.Usb (0 ms)\\nSKIPPED [1] a.py:3: none\\n")',
}


def summary_of(folder: Path, *names: str) -> tuple[int, list[str]]:
    """Runs the named TESTS with ctest; returns exit status and lines of the summary."""
    (folder / "CTestTestfile.cmake").write_text("\n".join(TESTS[name] for name in names))
    report = folder / "tests.xml"
    ctest = ["ctest", "--test-dir", str(folder), "--output-junit", str(report)]
    subprocess.run(ctest, capture_output=True, check=False)
    summary = [sys.executable, str(HERE / "summary.py"), str(report)]
    done = subprocess.run(summary, capture_output=True, text=True, check=False)
    assert done.stderr == ""
    return done.returncode, done.stdout.splitlines()


def test_numbers_stand_at_the_end(tmp_path: Path) -> None:
    assert summary_of(tmp_path, "good") == (0, ["tests: 1 passed, 0 failed, 0 skipped"])


def test_failed_tests_are_named(tmp_path: Path) -> None:
    status, lines = summary_of(tmp_path, "good", "bad")
    assert status == 0, "ctest itself has failed"
    assert lines == ["Failed:", "  bad", "tests: 1 passed, 1 failed, 0 skipped"]


def test_a_skipped_test_is_a_failure(tmp_path: Path) -> None:
    status, lines = summary_of(tmp_path, "good", "skipped")
    assert status == 1
    assert "  skipped: skipped: there is no Node" in lines
    assert lines[-1] == "tests: 1 passed, 0 failed, 1 skipped"


def test_skipped_cases_are_listed(tmp_path: Path) -> None:
    status, lines = summary_of(tmp_path, "cases")
    assert status == 0
    assert lines[1:3] == ["  cases: Ports.Usb", "  cases: a.py:3: none"]
    assert lines[-1] == "tests: 1 passed, 0 failed, 0 skipped"


def test_fresh_wants_root() -> None:
    # The script is piped, because the other user may be unable to read the folder.
    user = ["setpriv", "--reuid=65534", "--clear-groups"] if os.geteuid() == 0 else []
    if user and subprocess.run([*user, "true"], capture_output=True, check=False).returncode != 0:
        pytest.skip("cannot switch to another user")
    script = (HERE / "fresh").read_text(encoding="utf-8")
    done = subprocess.run(
        [*user, "bash", "-s"], input=script, capture_output=True, text=True, check=False, cwd="/"
    )
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr == "dev: fresh: needs root, for debootstrap and chroot\n"
