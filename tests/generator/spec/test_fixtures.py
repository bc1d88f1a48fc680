"""Each rule has at least one small spec that breaks it, and is reported at the right position.

`broken_specs.txt` has, below `=== SBGC010`, the specs that break that rule: the name of each, and the lines
of `probe.yaml` that differ from BASE (see support.probe). A caret marks the place of a finding in the line above it:

    == misspelt_key
            - {name: A, typ: u8, summary: A number.}
                        ^ part of the message | part of the hint

A finding of another rule has its code, `^ SBGC004 ...`; one in another file has its position,
`@ base.yaml:6:17 ...`. `== NAME: FILE` has sections of another file; they replace those of the file in
`minimal/`. `== NAME: whole FILE` has all of a file. `== NAME + OTHER` follows the lines of OTHER, which is another
spec of the rule, or one of the `bases`; with `<` it replaces their last line of its indentation, and what follows.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from sbgcgen.cli import main
from sbgcgen.model import Position
from support import GENERATOR, HERE, PROBE, Capture, findings, indentation, probe, write_spec

_FOUND = re.compile(r"( *)(?:\^|@ (.+):(\d+):(\d+)) (?:(SBGC\d{3}) )?(.+) \| (.+)\n")


@dataclass(frozen=True)
class Fixture:
    """A broken spec and its expected findings: position, rule, and parts of message and hint."""

    rule: str
    name: str
    file: str
    text: str
    expected: list[tuple[Position, str, str, str]]


def _sections(text: str) -> dict[str, str]:
    """The sections of a file by their keys."""
    return {section.split(":")[0]: section for section in re.split("(?m)^(?=[a-z])", text)}


def _whole(base: str, lines: str) -> str:
    """The text of a file with the lines of a fixture in their place."""
    minimal = HERE / "minimal" / base
    if not base:
        return probe(lines)
    if minimal.is_file():
        sections = {**_sections(minimal.read_text(encoding="utf-8")), **_sections(lines)}
        return "".join(sections.values())
    return lines


Lines = dict[
    str, tuple[str, list[str]]
]  # by the name of a spec: its file, and lines without findings


def _before(other: list[str], how: str, lines: str) -> list[str]:
    """The lines of another spec that stand before those of a fixture."""
    before = list(other)
    while how == "<" and indentation(before[-1]) > indentation(lines):
        before.pop()
    return before[:-1] if how == "<" and indentation(before[-1]) == indentation(lines) else before


def read(section: str, known: Lines) -> Iterator[Fixture]:
    """The fixtures of a rule; `known` are the bases."""
    rule, specs = section.split("\n", 1)
    for part in re.split("(?m)^== ", specs)[1:]:
        head, lines = part.split("\n", 1)
        start, _, base = head.partition(": ")
        name, how, other = (*start.split(" "), "", "")[:3]
        if other:
            base, before = known[other]
            lines = "".join(_before(before, how, lines)) + lines
        own = [line for line in lines.splitlines(keepends=True) if not _FOUND.match(line)]
        known[name] = (base, own)
        file = base.split(" ")[-1] or PROBE
        text: list[str] = []
        expected = []
        for line in _whole(base, lines).splitlines(keepends=True):
            found = _FOUND.match(line)
            if found is None:
                assert not line.lstrip().startswith("^"), f"{rule}: malformed: {line}"
                text.append(line)
                continue
            indented, other, row, column, code, message, hint = found.groups()
            at = Position(f"spec/{file}", len(text), len(indented) + 1)
            if other:
                at = Position(f"spec/{other}", int(row), int(column))
            expected.append((at, code or rule, message, hint))
        expected.sort(key=lambda finding: finding[0])
        yield Fixture(rule, name, file, "".join(text), expected)


_TEXT = (HERE / "spec" / "broken_specs.txt").read_text(encoding="utf-8")
_SECTIONS = re.split("(?m)^=== ", _TEXT)[1:]
_BASES: Lines = {}
list(read(_SECTIONS[0], _BASES))
FIXTURES = [f for section in _SECTIONS[1:] for f in read(section, dict(_BASES))]


@pytest.mark.parametrize("fixture", FIXTURES, ids=lambda f: f"{f.rule}_{f.name}")
def test_exactly_the_expected_findings(fixture: Fixture, tmp_path: Path, capsys: Capture) -> None:
    spec = write_spec(tmp_path, fixture.text, fixture.file)
    assert main(["generate", "--spec", str(spec), "--output", str(tmp_path / "out")]) == 1
    assert not (tmp_path / "out").exists(), "a broken spec must not be generated from"
    output = capsys.readouterr()
    assert output.out == ""
    found = re.findall(r"(\S+): (SBGC\d{3}) (.*)\n    hint: (.*)\n", output.err)
    assert [(at, code) for at, code, _, _ in found] == [
        (str(at), code) for at, code, _, _ in fixture.expected
    ]
    for (_, _, message, hint), (_, _, part_of_message, part_of_hint) in zip(
        found, fixture.expected
    ):
        assert part_of_message in message
        assert part_of_hint in hint
    assert f"{len(found)} error{'s' if len(found) != 1 else ''} in spec/" in output.err


def test_every_rule_has_a_fixture_and_every_fixture_breaks_its_rule() -> None:
    sources = "".join(p.read_text(encoding="utf-8") for p in (GENERATOR / "sbgcgen").rglob("*.py"))
    assert {f.rule for f in FIXTURES} == set(re.findall(r"\"(SBGC\d{3})\"", sources))
    assert all(f.rule in [code for _, code, _, _ in f.expected] for f in FIXTURES)


def test_minimal_spec_itself_is_fine(tmp_path: Path) -> None:
    assert findings(tmp_path) == []


def test_guides_of_the_project_exist(tmp_path: Path) -> None:
    """Checked only if the project's docs/ is next to the spec: other specs may name any guide."""
    text = (HERE / "minimal/simplebgc.yaml").read_text(encoding="utf-8")
    text += "guides:\n  safety: docs/2-savety.md\n"
    assert findings(tmp_path, text, "simplebgc.yaml") == []
    (tmp_path / "docs").mkdir()
    (tmp_path / "docs/2-safety.md").write_text("# Safety\n")
    (found,) = findings(tmp_path, text, "simplebgc.yaml")
    line = len(text.splitlines())
    assert str(found).startswith(f"spec/simplebgc.yaml:{line}:3: SBGC021 there is no guide")
    assert "docs/2-safety.md" in found.hint
    good = text.replace("savety", "safety")
    assert findings(tmp_path, good, "simplebgc.yaml") == []
