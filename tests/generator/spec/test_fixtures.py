"""Each rule has at least one small spec that breaks it, and is reported at the right position.

A fixture is the family file `probe.yaml` (or the file named in its first line, `# file: …`), used with
the files in `minimal/`. Its comments list all findings, in this order:

    # expect 12:21 SBGC017 part of the message
    #   hint: part of the hint

The position is `file:line:column` if the finding is in another file.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import pytest

from sbgcgen.cli import main
from sbgcgen.spec.diagnostics import Diagnostic
from support import GENERATOR, HERE, PROBE, findings, write_spec

FIXTURES = sorted((HERE / "spec" / "fixtures").iterdir())
_EXPECT = re.compile(
    r"# expect (?:(?P<file>\S+\.yaml):)?(?P<line>\d+):(?P<column>\d+) (?P<code>SBGC\d{3}) "
    r"(?P<message>.+)\n#   hint: (?P<hint>.+)"
)


def name_of(path: Path) -> str:
    return path.stem


@dataclass(frozen=True)
class Fixture:
    """A broken spec and its expected findings."""

    file: str
    text: str
    expected: list[tuple[str, str, str, str]]


def read(path: Path) -> Fixture:
    """Reads a fixture and its comments."""
    text = path.read_text(encoding="utf-8")
    named = re.match(r"# file: (\S+)\n", text)
    file = named[1] if named else PROBE
    expected = [
        (f"spec/{m['file'] or file}:{m['line']}:{m['column']}", m["code"], m["message"], m["hint"])
        for m in _EXPECT.finditer(text)
    ]
    assert len(expected) == text.count("# expect"), f"{path.name}: a malformed comment"
    return Fixture(file, text, expected)


def describe(found: list[Diagnostic]) -> list[tuple[str, str]]:
    return [(str(d.position), d.code) for d in found]


@pytest.mark.parametrize("path", FIXTURES, ids=name_of)
def test_exactly_the_expected_findings(path: Path, tmp_path: Path) -> None:
    fixture = read(path)
    found = findings(tmp_path, fixture.text, fixture.file)
    assert describe(found) == [(at, code) for at, code, _, _ in fixture.expected]
    for diagnostic, (_, _, message, hint) in zip(found, fixture.expected):
        assert message in diagnostic.message
        assert hint in diagnostic.hint


@pytest.mark.parametrize("path", FIXTURES, ids=name_of)
def test_command_line_reports_it_and_fails(
    path: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    fixture = read(path)
    spec = write_spec(tmp_path, fixture.text, fixture.file)
    assert main(["generate", "--spec", str(spec), "--output", str(tmp_path / "out")]) == 1
    assert not (tmp_path / "out").exists(), "a broken spec must not be generated from"
    output = capsys.readouterr()
    assert output.out == ""
    for at, code, message, _ in fixture.expected:
        assert re.search(rf"^{re.escape(f'{at}: {code} ')}.*{re.escape(message)}", output.err, re.M)


def test_every_rule_has_a_fixture_and_every_fixture_a_rule() -> None:
    sources = "".join(p.read_text(encoding="utf-8") for p in (GENERATOR / "sbgcgen").rglob("*.py"))
    rules = set(re.findall(r"\"(SBGC\d{3})\"", sources))
    assert {path.stem[:7] for path in FIXTURES} == rules


@pytest.mark.parametrize("path", FIXTURES, ids=name_of)
def test_fixture_is_named_after_its_rule(path: Path) -> None:
    fixture = read(path)
    assert re.fullmatch(r"SBGC\d{3}(_[a-z0-9]+)+", path.stem)
    assert path.stem[:7] in [code for _, code, _, _ in fixture.expected]
    assert all(hint.strip() for _, _, _, hint in fixture.expected)


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
