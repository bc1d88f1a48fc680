"""Small specs for tests: the minimal spec with one file replaced; a git repository."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

from sbgcgen.build import load_protocol
from sbgcgen.spec.diagnostics import Diagnostic, SpecError
from sbgcgen.model import Layout, Message

Capture = pytest.CaptureFixture[str]
HERE = Path(__file__).resolve().parent
PROJECT = HERE.parent.parent
GENERATOR = PROJECT / "generator"
PROBE = "probe.yaml"
BASE = """\
family: probe
summary: What a test needs.
commands:
  CMD_PROBE:
    id: 9
    summary: A message.
    from_board:
      source: L1
      fields:
        - {name: A, type: u8, summary: A number.}
"""


def indentation(line: str) -> int:
    return len(line) - len(line.lstrip(" "))


def probe(lines: str) -> str:
    """Returns BASE with these lines.

    They replace the last line that is indented as the first of them, and what follows it.
    """
    before = BASE.splitlines(keepends=True)
    while indentation(before.pop()) != indentation(lines):
        pass
    return "".join(before) + lines


def write_spec(folder: Path, text: str | bytes | None = None, file: str = PROBE) -> Path:
    """Writes the minimal spec to folder/spec, with `text` as the content of `file`.

    A text that begins with blanks is completed by probe().
    """
    spec = folder / "spec"
    shutil.copytree(HERE / "minimal", spec, dirs_exist_ok=True)
    if isinstance(text, str) and text.startswith(" "):
        text = probe(text)
    if text is not None:
        content = text.encode() if isinstance(text, str) else text
        (spec / file).write_bytes(content)
    return spec


def findings(folder: Path, text: str | bytes | None = None, file: str = PROBE) -> list[Diagnostic]:
    """Returns the findings for the minimal spec with `text` as `file`."""
    try:
        load_protocol(write_spec(folder, text, file))
    except SpecError as error:
        return error.diagnostics
    return []


def layout_of(folder: Path, text: str) -> Layout:
    """Returns the Layout of the minimal spec with the family `text`, which must have no findings."""
    return load_protocol(write_spec(folder, text)).layout


@cache
def project_layout() -> Layout:
    """Returns the Layout of the project's spec."""
    return load_protocol(PROJECT / "spec").layout


def message_of(layout: Layout, name: str, direction: str | None = None) -> Message:
    """Returns the message with that name; `direction` is needed only if both directions have it."""
    found = [m for m in layout.messages if m.name == name and direction in (None, m.direction)]
    assert len(found) == 1, f"{len(found)} messages are called {name}"
    return found[0]


# The generator as a program


def run_generator(
    *arguments: object, generator: Path = GENERATOR, folder: Path | None = None, **settings: str
) -> subprocess.CompletedProcess[str]:
    """Runs a generator in a separate process, in a folder, with settings of its environment."""
    own = {"PYTHONPATH": str(generator), "PYTHONDONTWRITEBYTECODE": "1"}
    return subprocess.run(
        [sys.executable, "-m", "sbgcgen", *map(str, arguments)],
        env={**os.environ, **own, **settings},
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
    )


def files_in(folder: Path) -> dict[str, bytes]:
    """Returns the contents of all files below a folder."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


# A git repository


def git(folder: Path, *arguments: str) -> None:
    """Runs a git command with a fixed user."""
    user = ["-c", "user.name=Test", "-c", "user.email=test@example.org"]
    command = ["git", *user, "-C", str(folder), *arguments]
    subprocess.run(command, check=True, capture_output=True)


def start_repository(folder: Path) -> Path:
    """Creates an empty repository."""
    folder.mkdir(parents=True)
    git(folder, "init", "--quiet")
    return folder


def commit(folder: Path, tag: str) -> None:
    """Commits all files and tags the revision `tag`."""
    git(folder, "add", ".")
    git(folder, "commit", "--quiet", "-m", tag)
    git(folder, "tag", tag)
