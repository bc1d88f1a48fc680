"""Broken YAML is read or refused with findings that name a place: no traceback, no hang."""

from __future__ import annotations

import shutil
import time
from pathlib import Path

import pytest

from broken_yaml import LIMIT, PROJECT, broken, outcome
from support import findings, write_spec
from test_mutations import SPEC


@pytest.mark.parametrize("part", range(4))
def test_a_small_spec(part: int, tmp_path: Path) -> None:
    spec = write_spec(tmp_path, SPEC, "base.yaml")
    contents = {path: path.read_bytes() for path in sorted(spec.iterdir())}
    # Most of what can be said is in this file.
    files = [spec / "base.yaml"] * 4 + list(contents)
    refused = 0
    for seed in range(part, 300, 4):
        file = files[seed // 4 % len(files)]
        file.write_bytes(broken(seed, contents[file]))
        refused += bool(outcome(spec))
        file.write_bytes(contents[file])
    assert refused > 40


@pytest.mark.parametrize("seed", [7, 12, 44, 45])
def test_the_spec_of_the_project(seed: int, tmp_path: Path) -> None:
    """`broken_yaml.py` tries more, in minutes."""
    spec = tmp_path / "spec"
    shutil.copytree(PROJECT / "spec", spec)
    file = spec / ("system.yaml", "units.yaml", "simplebgc.yaml")[seed % 3]
    file.write_bytes(broken(seed, file.read_bytes()))
    outcome(spec)


def test_what_a_finding_quotes_is_one_short_line(tmp_path: Path) -> None:
    text = f'family: probe\n"key\\e[31m\\nnext\\u202e": 1\ncommands: {"x" * 5000}\n'
    found = findings(tmp_path, text)
    for finding in found:
        assert finding.message.isprintable() and len(finding.message) < 1200
    assert any("key\\x1b[31m\\nnext\\u202e" in finding.message for finding in found)
    assert any("not 'xxx" in finding.message for finding in found)


@pytest.mark.parametrize("text", ["{}\n", "# nothing\n{}\n"])
def test_an_empty_mapping_is_no_spec_file(text: str, tmp_path: Path) -> None:
    assert [finding.code for finding in findings(tmp_path, text)] == ["SBGC001"]


def test_fields_of_an_example_value_are_no_fields(tmp_path: Path) -> None:
    """Repairing a mistake meets keys that only look like those of the language."""
    text = """\
family: probe
commands:
  CMD_PROBE:
    id: 9
    summary: A number.
    from_board:
      source: L1
      fields:
        - {name: A, type: u8, struct: B, summary: A., unknown_key: 1}
        - {name: C, type: u8, summary: C., typical: [{fields: [1]}]}
"""
    assert [finding.code for finding in findings(tmp_path, text)] == ["SBGC004"]


def test_the_time_per_finding_does_not_grow(tmp_path: Path) -> None:
    """Comparing each finding with all others would take minutes."""
    lines = "".join(f"key{number}: 1\n" for number in range(20_000))
    start = time.monotonic()
    assert len(findings(tmp_path, "family: probe\nsummary: A family.\n" + lines)) == 20_000
    assert time.monotonic() - start < LIMIT
