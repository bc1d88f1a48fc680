"""Tests of the command line: exit statuses, messages, the depfile and the stamp."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from sbgcgen.cli import main
from sbgcgen.record import inputs
from support import GENERATOR, Capture, write_spec


@pytest.fixture
def root(tmp_path: Path) -> Path:
    """A project folder with the minimal spec."""
    write_spec(tmp_path)
    return tmp_path


def run(root: Path, command: str, *arguments: object) -> int:
    return main([command, "--root", str(root), *map(str, arguments)])


def test_lint_tells_what_it_has_read(root: Path, capsys: Capture) -> None:
    assert run(root, "lint") == 0
    assert capsys.readouterr().out == "2 commands, 3 messages: no errors\n"
    assert sorted(path.name for path in root.iterdir()) == ["spec"]


def test_generate_then_check(root: Path, capsys: Capture) -> None:
    assert run(root, "check") == 1
    assert "missing" in capsys.readouterr().err
    assert run(root, "generate") == 0
    first = re.fullmatch(r"(\d+) files, (\d+) changed\n", capsys.readouterr().out)
    assert first and first[1] == first[2] != "0"
    assert run(root, "check") == 0
    assert capsys.readouterr() == ("", "")
    assert run(root, "generate") == 0
    assert capsys.readouterr().out == f"{first[1]} files, 0 changed\n"


def test_findings_are_counted_and_nothing_is_written(root: Path, capsys: Capture) -> None:
    write_spec(root, "family: prob\nsumary: x\n")
    for command in ("lint", "check"):  # spec/test_fixtures.py has the findings of `generate`
        assert run(root, command) == 1
        assert capsys.readouterr().err.splitlines()[-1] == "2 errors in spec/"
    assert not (root / "generated").exists()


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        *(
            (words, "usage: sbgcgen")
            for words in ("", "explode", "lint --no-such", "check --stamp x")
        ),
        ("generate --depfile x.d", "--depfile needs --stamp"),
    ],
)
def test_wrong_usage(arguments: str, words: str, capsys: Capture) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(arguments.split())
    assert stopped.value.code == 2
    assert words in capsys.readouterr().err


def test_output_that_cannot_be_written(root: Path, capsys: Capture) -> None:
    (root / "file").write_text("not a folder")
    assert run(root, "generate", "--output", root / "file") == 1
    message = capsys.readouterr().err
    assert message.startswith(f"cannot write {root}/file")
    assert len(message.splitlines()) == 1


def depfile_of(text: str) -> tuple[str, list[str]]:
    """Parses a Make rule into its target and prerequisites."""
    words = re.split(r"(?<!\\)\s+", text.replace("\\\n", " ").strip())
    names = [re.sub(r"\\([ #\\])", r"\1", word).replace("$$", "$") for word in words]
    assert names[0].endswith(":")
    return names[0][:-1], names[1:]


@pytest.mark.parametrize("folder", ["build", "a b #1 $x"])
def test_depfile_lists_all_that_was_read(root: Path, folder: str) -> None:
    stamp, depfile = root / folder / "x.stamp", root / folder / "x.stamp.d"
    assert run(root, "generate", "--depfile", depfile, "--stamp", stamp) == 0
    target, names = depfile_of(depfile.read_text())
    assert target == str(stamp)
    assert set(names) == {str(p) for p in [*(root / "spec").glob("*.yaml"), *inputs(root)]}
    assert len(names) == len(set(names)) and all(Path(name).is_file() for name in names)
    assert sorted(name for name in names if "__pycache__" in name) == []


def test_stamp_is_touched_each_time_except_on_failure(root: Path) -> None:
    stamp = root / "x.stamp"
    for _ in range(2):  # at first there are changes
        assert run(root, "generate", "--stamp", stamp) == 0
        assert stamp.stat().st_mtime_ns > 10**18
        os.utime(stamp, ns=(10**18, 10**18))
    write_spec(root, "broken: [\n")
    assert run(root, "generate", "--stamp", stamp) == 1
    assert stamp.stat().st_mtime_ns == 10**18


def test_as_a_program_from_anywhere(root: Path, tmp_path: Path) -> None:
    """Runs `python -m sbgcgen` and the launcher that selects a suitable Python."""
    environment = {**os.environ, "SBGC_PYTHON": sys.executable}
    for command in ([sys.executable], [str(GENERATOR / "python")]):
        done = subprocess.run(
            [*command, "-m", "sbgcgen", "lint", "--root", str(root)],
            cwd=tmp_path,
            env={**environment, "PYTHONPATH": str(GENERATOR)},
            capture_output=True,
            text=True,
        )
        assert (done.returncode, done.stderr) == (0, "")
        assert done.stdout == "2 commands, 3 messages: no errors\n"
