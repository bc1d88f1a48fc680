"""Tests the output of commands against answers/*.txt: lines of the form `STATUS COMMAND => WORDS`.

The words stand in the output, without its breaks of lines, and at its begin if they begin with `sbgc:`; without
words, there is no output. `$` is its end, `…` any text, `#` a number with words around it. `<<<` is the input, as
Python writes it; `{folder}` is an empty folder, `{file}` has two bytes, `{bytes}` 1280. A section `[OPTIONS]` adds
options to each command; `[board OPTIONS]` gives them an emulated gimbal, whose parameters must be the same
afterwards, except in `[changing board OPTIONS]`.
"""

from __future__ import annotations

import ast
import os
import re
import shlex
from pathlib import Path

import pytest

from emulated_gimbal import emulated_gimbal
from sbgc_command import run

FOLDER = Path(__file__).parent / "answers"
# Programs of other systems have only the commands that need no gimbal.
FILES = [
    file
    for file in sorted(FOLDER.glob("*.txt"))
    if "SBGC_SYSTEM" not in os.environ or file.stem in ("describe", "frames")
]
SECTIONS = [
    pytest.param(heading, re.findall(r"^\d .*", lines, re.M), id=f"{file.stem} [{heading}]")
    for file in FILES
    for heading, lines in re.findall(r"^\[(.*)\]\n((?:(?!\[).*\n)*)", file.read_text("utf-8"), re.M)
]


def problem_of(line: str, options: list[str], folder: Path) -> str:
    """Returns what is wrong with an answer, or nothing."""
    named = re.sub(r"\{(folder|file|bytes)\}", rf"{folder.parent}/\1", line)
    request, _, words = named.partition(" =>")
    status, _, command = request.partition(" ")
    command, _, stdin = command.partition(" <<< ")
    for _ in range(3):  # beside busy programs, the emulated board may answer too late
        result = run(
            *shlex.split(command), *options, stdin=ast.literal_eval(stdin) if stdin else ""
        )
        if "no response to" in words or "no response to" not in result.error:
            break
    said = " ".join((result.text + result.error).split())
    wanted = (
        re.escape(words := words.strip())
        .replace(r"\ …\ ", ".*?")
        .replace(r"\#", r"[^:;]*?\d[^:;]*?")
        .replace(r"\$", "$")
    )
    find = {"": re.fullmatch, "sbgc:": re.match}.get(words[:5], re.search)
    is_right = result.status == int(status) and find(wanted, said)
    if is_right and (result.status != 2 or not result.out and result.error.startswith("sbgc: ")):
        return ""
    return f"{line}\n    {result.status} {said}"


@pytest.mark.parametrize("heading, lines", SECTIONS)
def test_answers(heading: str, lines: list[str], tmp_path: Path) -> None:
    (folder := tmp_path / "folder").mkdir()
    (tmp_path / "file").write_bytes(b"ab")
    (tmp_path / "bytes").write_bytes(bytes(range(256)) * 5)
    place, is_board, options = heading.partition("board")
    if not is_board:
        problems = [problem_of(line, heading.split(), folder) for line in lines]
        assert not list(folder.iterdir()), "a command that fails leaves no file"
    else:
        with emulated_gimbal(*options.split()) as gimbal:
            port, backup = ["-p", gimbal.address], str(tmp_path / "backup")
            assert place or run("params", "backup", backup, *port).status == 0
            problems = [problem_of(line, port, folder) for line in lines]
            is_same = place or run("params", "diff", backup, *port).status == 0
            assert is_same, "something was written"
    problems = [problem for problem in problems if problem]
    assert lines and not problems, "\n".join(problems)
