"""The version that changes since the last release require, and the record of a release."""

from __future__ import annotations

from pathlib import Path

import pytest

from edits import CASES, OLD, WITHOUT_AIM, line_of
from sbgcgen import library
from sbgcgen.cli import main
from sbgcgen.compat.release import NAME, Step, Version, lowest_version, parse, read
from support import PROJECT, Capture, write_spec

SAME = OLD
REWORDED = OLD.replace("summary: How often.", "summary: Number of times.")
EXTENDED = OLD.replace(*CASES["command added"].edits[0])
BROKEN = OLD.replace("id: 11", "id: 21")


@pytest.mark.parametrize(
    "released, step, lowest",
    [
        ("0.1.0", Step.PROSE, "0.1.0"),
        ("0.1.0", Step.ADDITION, "0.1.1"),
        ("0.1.7", Step.BREAK, "0.2.0"),
        ("1.4.2", Step.PROSE, "1.4.2"),
        ("1.4.2", Step.ADDITION, "1.5.0"),
        ("1.4.2", Step.BREAK, "2.0.0"),
    ],
)
def test_the_lowest_version_after_a_release(released: str, step: Step, lowest: str) -> None:
    assert lowest_version(parse(released), step) == parse(lowest)


def test_versions_are_compared_by_number() -> None:
    assert parse("0.10.0") > parse("0.9.9") and str(Version(0, 10, 0)) == "0.10.0"
    for wrong in ("1.2", "1.2.3.4", "1.2.x", ""):
        with pytest.raises(ValueError):
            parse(wrong)


# A project with a release


def write_version(root: Path, version: str) -> None:
    header = root / library.VERSION_HEADER
    header.parent.mkdir(parents=True, exist_ok=True)
    parts = zip(Version._fields, version.split("."))
    header.write_text("".join(f"#define SBGC_VERSION_{p.upper()} {n}\n" for p, n in parts))


@pytest.fixture(name="project")
def with_a_release(tmp_path: Path, request: pytest.FixtureRequest, capsys: Capture) -> Path:
    """A project that has released 0.1.0, or the version in the parameter."""
    write_spec(tmp_path, OLD)
    write_version(tmp_path, getattr(request, "param", "0.1.0"))
    assert main(["record", "--root", str(tmp_path)]) == 0
    assert f"{NAME} is now the model of" in capsys.readouterr().out
    return tmp_path


def check(root: Path, spec: str, version: str, command: str = "compat") -> int:
    write_spec(root, spec)
    write_version(root, version)
    return main([command, "--root", str(root)])


@pytest.mark.parametrize(
    "project, spec, too_low, enough",
    [
        ("0.1.0", SAME, "0.0.9", "0.1.0"),
        ("0.1.0", REWORDED, "0.0.9", "0.1.0"),
        ("0.1.0", EXTENDED, "0.1.0", "0.1.1"),
        ("0.1.0", BROKEN, "0.1.9", "0.2.0"),
        ("1.2.3", REWORDED, "1.2.2", "1.2.3"),
        ("1.2.3", EXTENDED, "1.2.9", "1.3.0"),
        ("1.2.3", BROKEN, "1.9.9", "2.0.0"),
    ],
    indirect=["project"],
)
def test_changes_need_a_version(
    project: Path, spec: str, too_low: str, enough: str, capsys: Capture
) -> None:
    assert check(project, spec, too_low) == 1
    error = capsys.readouterr().err
    assert (
        f"the version is {too_low}.\nSet it to {enough} or higher in {library.VERSION_HEADER}"
        in error
    )
    assert check(project, spec, enough) == 0
    assert capsys.readouterr().err == ""


def test_the_changes_are_listed(project: Path, capsys: Capture) -> None:
    check(project, BROKEN, "0.2.0")
    lines = capsys.readouterr().out.splitlines()
    line = line_of("  CMD_MOVE:")
    assert lines[0] == (f"wire-breaking: command CMD_MOVE: id: 11 → 21  [spec/probe.yaml:{line}:3]")
    assert lines[-1].startswith("fingerprint: ")
    write_spec(project, OLD.replace("CMD_AIM", "CMD_TURN"))
    main(["compat", "--root", str(project)])
    assert "CMD_AIM → CMD_TURN" in capsys.readouterr().out


def test_a_deletion_is_found_in_the_release(project: Path, capsys: Capture) -> None:
    check(project, WITHOUT_AIM, "0.2.0")
    line = line_of("  CMD_AIM:")
    assert f"15 → deleted  [0.1.0:spec/probe.yaml:{line}:3]" in capsys.readouterr().out


def test_without_a_release_there_is_nothing_to_compare(tmp_path: Path, capsys: Capture) -> None:
    assert check(tmp_path, OLD, "0.1.0") == 0
    assert capsys.readouterr().out == "no release is recorded: nothing to compare\n"


# The record


def test_the_record_of_a_version_is_not_replaced(project: Path, capsys: Capture) -> None:
    file = project / "spec" / NAME
    before = file.read_bytes()
    assert check(project, REWORDED, "0.1.0", "record") == 0
    assert check(project, BROKEN, "0.1.0", "record") == 1
    assert file.read_bytes() == before
    assert "Set it to 0.2.0 or higher" in capsys.readouterr().err
    assert check(project, BROKEN, "0.2.0", "record") == 0
    assert read(file).version == Version(0, 2, 0)
    assert check(project, BROKEN, "0.2.0") == 0
    assert check(project, OLD, "0.2.0") == 1


def test_the_committed_release_is_not_newer_than_the_library() -> None:
    assert read(PROJECT / "spec" / NAME).version <= parse(library.version(PROJECT))
