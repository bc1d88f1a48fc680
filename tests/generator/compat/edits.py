"""Changes of a spec, and what is reported for them.

`changes.txt` has edits of changes.yaml, and `growth.txt` those of growth.yaml that firmware really makes. A case
has the class and the text of what is reported, or nothing for a change that is none, and then the edits:

    == field inserted
    WIRE State.MORE: none → u8 in between
     a line before or after it
    -what is there, whole lines or a part of one
    +what replaces it
    @@
    -another place in any file of the spec
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from sbgcgen.compat.changes import Level
from support import HERE, write_spec

FOLDER = HERE / "compat"
BASE = (HERE / "minimal" / "base.yaml").read_text(encoding="utf-8")

Edits = list[tuple[str, str]]  # old and new text


@dataclass(frozen=True)
class Case:
    """The edits of a spec, and what is reported for them."""

    old: str
    edits: Edits
    expected: list[tuple[Level, str]]


def _edit(lines: str) -> tuple[str, str]:
    all_lines = lines.splitlines()
    old = [line[1:] for line in all_lines if not line.startswith("+")]
    new = [line[1:] for line in all_lines if not line.startswith("-")]
    return "\n".join(old), "\n".join(new)


def _cases(name: str) -> Iterator[tuple[str, Case]]:
    old = (FOLDER / f"{name}.yaml").read_text(encoding="utf-8")
    text = (FOLDER / f"{name}.txt").read_text(encoding="utf-8")
    for part in re.split("(?m)^== ", text)[1:]:
        title, lines = part.split("\n", 1)
        reports = re.findall("(?m)^([A-Z]+) (.*)\n", lines)
        edits = re.sub("(?m)^[A-Z]+ .*\n", "", lines).split("@@\n")
        expected = [(Level[level], words) for level, words in reports]
        yield title, Case(old, [_edit(edit) for edit in edits], expected)


CASES = dict([*_cases("changes"), *_cases("growth")])
OLD = CASES["id"].old
WITHOUT_AIM = OLD[: OLD.index("  CMD_AIM:")] + OLD[OLD.index("variables:") :]


def line_of(line: str, text: str = OLD) -> int:
    return 1 + text.splitlines().index(line)


def edited_spec(folder: Path, old: str, edits: Edits) -> Path:
    """Returns a spec with words replaced in all files that contain them."""
    spec = write_spec(folder, old)
    for before, after in edits:
        files = [path for path in spec.glob("*.yaml") if before in path.read_text(encoding="utf-8")]
        assert files, f"nothing to edit: {before}"
        for path in files:
            text = path.read_text(encoding="utf-8")
            path.write_text(text.replace(before, after), encoding="utf-8")
    return spec
