"""Tests of the findings as a whole: complete, ordered, without duplicates, and with hints. Any two mistakes in
one line are reported in one run."""

from __future__ import annotations

import itertools
from pathlib import Path

import pytest

from sbgcgen.build import load_protocol
from sbgcgen.model import Position
from sbgcgen.spec.diagnostics import Diagnostics, SpecError, closest, did_you_mean
from support import findings, write_spec


def test_mistakes_of_several_files_come_out_together(tmp_path: Path) -> None:
    spec = write_spec(tmp_path, "family: probe\nsumary: Misspelt.\n")
    (spec / "extra.yaml").write_text("family: extra\n")
    (spec / "errata.yaml").write_text("errata: []\n")
    with pytest.raises(SpecError) as caught:
        load_protocol(spec)
    assert [f"{d.position} {d.code}" for d in caught.value.diagnostics] == [
        "spec/errata.yaml:1:1 SBGC004",
        "spec/extra.yaml:1:1 SBGC003",
        "spec/probe.yaml:2:1 SBGC004",
    ]


def test_a_repeated_finding_is_dropped() -> None:
    found = Diagnostics()
    for _ in range(3):
        found.add(Position("a.yaml", 1, 2), "SBGC010", "unknown type 'x'")
    assert len(found.found) == 1
    assert found.any_of(["SBGC010"]) and not found.any_of(["SBGC011"])


def test_position_and_hint_are_written_as_compilers_do(tmp_path: Path) -> None:
    first = findings(tmp_path, "family: prob\n")[0]
    assert str(first) == (
        "spec/probe.yaml:1:1: SBGC003 the family 'prob' is in probe.yaml\n"
        "    hint: a family has the name of its file"
    )


def test_did_you_mean() -> None:
    """Names that differ only in numbers are not suggested."""
    assert did_you_mean("Agnle", ["Speed", "Angle"]) == "did you mean 'Angle'?"
    assert did_you_mean("U8", ["u8", "i8"]) == "did you mean 'u8'?"
    assert did_you_mean("x", []) == ""
    known = ["E099", "E009", "CMD_READ_PARAMS_3", "u8", "u16"]
    for word in ("zzz", "E999", "CMD_READ_PARAMS_5", "u18"):
        assert closest(word, known) == "", word
    for word in ("CMD_RAED_PARAMS_3", "cmd_read_params_3"):
        assert closest(word, known) == "CMD_READ_PARAMS_3", word


SPEC = """\
    to_board:
      source: L1
      effect: reads
      answer: {{confirm: always}}
      fields:
        - {{name: REST, type: u8, summary: More.}}
        - {{{name}, {type}, {range}, {summary}, {errata}}}
"""
RIGHT = {
    "name": "name: LIMIT",
    "type": "type: u8",
    "range": "range: 1..90",
    "summary": "summary: A limit.",
    "errata": "errata: [E001]",
}
# The replaced part and its text, and the code and a word of the finding.
WRONG = [
    ("name", "name: limit", "SBGC053", "upper case"),
    ("name", "name: CLASS", "SBGC022", "'class'"),
    ("name", "name: LI MIT", "SBGC031", "LI MIT"),
    ("name", "nmae: LIMIT", "SBGC004", "nmae"),
    ("name", "name: REST", "SBGC012", "'rest'"),
    ("type", "type: u18", "SBGC010", "u18"),
    ("type", "tpye: u8", "SBGC004", "tpye"),
    ("type", "size: 3", "SBGC040", "no type"),
    ("range", "range: 90..1", "SBGC017", "reversed"),
    ("range", "range: 1-90", "SBGC004", "1-90"),
    ("range", "rnage: 1..90", "SBGC004", "rnage"),
    ("range", "range: [1, 90]", "SBGC004", "not a list"),
    ("summary", 'summary: ""', "SBGC019", "no summary"),
    ("summary", "summary: See CMD_NOTHING.", "SBGC052", "CMD_NOTHING"),
    ("summary", "sumary: A limit.", "SBGC004", "sumary"),
    ("errata", "errata: [E999]", "SBGC023", "E999"),
    ("errata", "errata: E001", "SBGC004", "'E001'"),
    ("errata", "erata: [E001]", "SBGC004", "erata"),
    ("errata", "since: {firmware: 2.4x}", "SBGC030", "2.4x"),
    ("errata", "deprecated: yes", "SBGC004", "yes"),
]
PAIRS = [(a, b) for a, b in itertools.combinations(WRONG, 2) if a[0] != b[0]]
LINE = 13


@pytest.mark.parametrize("pair", PAIRS, ids=lambda pair: f"{pair[0][1]} and {pair[1][1]}")
def test_both_are_reported(pair: tuple[tuple[str, ...], ...], tmp_path: Path) -> None:
    parts = RIGHT | {place: text for place, text, _, _ in pair}
    found = findings(tmp_path, SPEC.format(**parts))
    assert {d.position.line for d in found} == {LINE}
    for _, _, code, word in pair:
        assert [d for d in found if d.code == code and word in d.message], found
    assert len(found) == len(pair), "and nothing else"


def test_the_line_without_mistakes_is_fine(tmp_path: Path) -> None:
    assert findings(tmp_path, SPEC.format(**RIGHT)) == []


def test_families_that_are_not_read_bring_no_findings_with_them(tmp_path: Path) -> None:
    main_file = write_spec(tmp_path) / "simplebgc.yaml"
    text = main_file.read_text().replace("families:", "famlies:")
    found = findings(tmp_path, text, "simplebgc.yaml")
    assert [d.message for d in found] == ["unknown key 'famlies'"]
