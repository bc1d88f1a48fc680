"""Every kind of change between two versions of a spec is found and classified."""

from __future__ import annotations

from pathlib import Path

import pytest

from edits import BASE, CASES, OLD, edited_spec, line_of
from sbgcgen.build import load_layout
from sbgcgen.cli import main
from sbgcgen.compat.changes import Level
from sbgcgen.compat.severities import compare
from sbgcgen.compat.report import describe
from support import Capture, commit, git, start_repository, write_spec


def changes_between(old: Path, new: Path) -> list[tuple[Level, str]]:
    return [(c.level, describe(c)) for c in compare(load_layout(old), load_layout(new))]


@pytest.mark.parametrize("name", CASES)
def test_a_change_is_found_and_put_into_its_class(name: str, tmp_path: Path) -> None:
    case = CASES[name]
    old = write_spec(tmp_path / "old", case.old)
    found = changes_between(old, edited_spec(tmp_path / "new", case.old, case.edits))
    for level, words in case.expected:
        assert any(at is level and words in text for at, text in found), found
    worst = [level for level, _ in case.expected[:1]]
    assert [level for level, _ in found[:1]] == worst, f"it breaks more than it should: {found}"


def test_another_prefix_of_commands_breaks_no_program(tmp_path: Path) -> None:
    new = write_spec(tmp_path / "new", OLD)
    for path in new.iterdir():
        text = path.read_text(encoding="utf-8").replace("CMD_", "CM_")
        path.write_text(text.replace("protocol:", "protocol:\n  command_prefix: CM_"), "utf-8")
    found = changes_between(write_spec(tmp_path / "old", OLD), new)
    assert {level for level, _ in found} == {Level.COMPATIBLE}
    assert any("prefix of commands: CMD_ → CM_" in text for _, text in found)


def test_what_was_appended_must_stay_optional(tmp_path: Path) -> None:
    case = CASES["field appended"]
    without = [(a, b.replace("since: {firmware: 2.59}, ", "")) for a, b in case.edits]
    old = edited_spec(tmp_path / "old", case.old, case.edits)
    found = changes_between(old, edited_spec(tmp_path / "new", case.old, without))
    assert found[0][0] is Level.WIRE and "State.MORE: may be absent: yes → no" in found[0][1]


def test_nothing_changed(tmp_path: Path, capsys: Capture) -> None:
    old, new = write_spec(tmp_path / "old", OLD), write_spec(tmp_path / "new", OLD)
    assert main(["compat", str(old), str(new)]) == 0
    nothing = "0 wire-breaking, 0 meaning-breaking, 0 source-breaking, 0 compatible\n"
    assert capsys.readouterr().out == nothing


def test_every_class_has_its_line_and_position(tmp_path: Path, capsys: Capture) -> None:
    edits = [
        ("id: 11", "id: 21"),
        ("unit: deg,", "unit: rad,"),
        ("name: COUNT,  ", "name: TIMES,  "),
    ]
    old = write_spec(tmp_path / "old", OLD)
    new = edited_spec(tmp_path / "new", OLD, [*edits, ("range: -100..100", "range: -110..110")])
    assert main(["compat", str(old), str(new)]) == 1
    lines = capsys.readouterr().out.splitlines()
    assert [line.partition(": ")[0] for line in lines[:2]] == ["wire-breaking", "meaning-breaking"]
    line = line_of("  CMD_MOVE:")
    assert lines[0].endswith(f"command CMD_MOVE: id: 11 → 21  [{new}/probe.yaml:{line}:3]")
    assert lines[-1] == "1 wire-breaking, 1 meaning-breaking, 1 source-breaking, 2 compatible"


def test_a_compatible_change_passes(tmp_path: Path) -> None:
    old = write_spec(tmp_path / "old", OLD)
    new = edited_spec(tmp_path / "new", OLD, CASES["field added at a kept tail"].edits)
    assert main(["compat", str(old), str(new)]) == 0


def test_a_spec_that_does_not_load(tmp_path: Path, capsys: Capture) -> None:
    old = write_spec(tmp_path / "old", OLD)
    new = edited_spec(tmp_path / "new", OLD, [("type: AxisState", "type: AxisStat")])
    assert main(["compat", str(old), str(new)]) == 1
    error = capsys.readouterr().err
    assert f"{new}/probe.yaml:" in error and "SBGC010 unknown type 'AxisStat'" in error


# Revisions


@pytest.fixture
def repository(tmp_path: Path) -> Path:
    """A repository with two revisions of the spec, and an earlier one without a spec."""
    root = start_repository(tmp_path / "project")
    (root / "README").write_text("nothing yet\n", encoding="utf-8")
    commit(root, "v0")
    write_spec(root, OLD)
    commit(root, "v1")
    edited_spec(root, OLD, [("unit: deg,", "unit: rad,")])
    commit(root, "v2")
    return root


def test_two_revisions(repository: Path, capsys: Capture) -> None:
    assert main(["compat", "--root", str(repository), "v1", "v2"]) == 1
    line = line_of("  Angle:", BASE)
    words = f"meaning-breaking: quantity Angle: unit: deg → rad  [v2:spec/base.yaml:{line}:3]"
    assert words in capsys.readouterr().out


def test_a_revision_and_the_working_tree(repository: Path, capsys: Capture) -> None:
    assert main(["compat", "--root", str(repository), "HEAD"]) == 0
    edited_spec(repository, OLD, CASES["command deleted"].edits)
    assert main(["compat", "--root", str(repository), "v1"]) == 1
    output = capsys.readouterr().out
    line = line_of("  CMD_MOVE:")
    assert f"command CMD_MOVE: 11 → deleted  [v1:spec/probe.yaml:{line}:3]" in output


def test_the_project_lies_in_a_folder_of_the_repository(tmp_path: Path) -> None:
    repository = start_repository(tmp_path / "repository")
    project = repository / "some" / "project"
    project.mkdir(parents=True)
    write_spec(project, OLD)
    commit(repository, "v1")
    assert main(["compat", "--root", str(project), "HEAD"]) == 0
    edited_spec(project, OLD, [("id: 11", "id: 21")])
    assert main(["compat", "--root", str(project), "HEAD"]) == 1


def test_a_spec_folder_of_another_name(repository: Path, capsys: Capture) -> None:
    git(repository, "mv", "spec", "protocol")
    commit(repository, "v3")
    options = ["--root", str(repository), "--spec", str(repository / "protocol")]
    assert main(["compat", *options, "HEAD"]) == 0
    assert main(["compat", *options, "v1"]) == 2
    assert "revision v1 has no folder protocol/" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("revision", "words"),
    [
        ("v9", "'v9' is neither a folder nor a revision"),
        ("", "'' is neither a folder nor a revision"),
        ("v0", "revision v0 has no folder spec/"),
        ("v1 --output=x", "is neither a folder nor a revision"),
    ],
)
def test_an_unknown_revision(repository: Path, capsys: Capture, revision: str, words: str) -> None:
    assert main(["compat", "--root", str(repository), revision]) == 2
    assert words in capsys.readouterr().err
