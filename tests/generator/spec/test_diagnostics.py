"""Tests of the findings as a whole: complete, ordered, without duplicates, and with hints."""

from __future__ import annotations

from pathlib import Path

import pytest

from sbgcgen.build import load_protocol
from sbgcgen.model import Position
from sbgcgen.spec.diagnostics import Diagnostics, SpecError, did_you_mean
from support import findings, write_spec

MISTAKES = """\
family: probe
summary: One mistake of many kinds each.

enums:
  Sort:
    type: u8
    summary: Some values.
    source: L1
    values:
      BIG: {value: 300, summary: Too big.}

commands:
  CMD_PROBE:
    id: 1
    summary: Its id is taken.
    from_board:
      fields:
        - {name: A, type: u8, range: 9..1, summary: A number.}
        - {name: A, type: u8, errata: [E900], summary: A number.}
        - {name: B, type: Agnle}
        - {name: CLASS, type: u8, summary: A number.}
    to_board:
      source: L1
      effect: reads
      summary: Ask.
      answer: {message: Prob}
"""


def test_several_mistakes_come_out_in_one_run_by_position(tmp_path: Path) -> None:
    found = findings(tmp_path, MISTAKES)
    assert [(d.position.line, d.position.column, d.code) for d in found] == [
        (10, 7, "SBGC016"),
        (14, 5, "SBGC011"),
        (14, 5, "SBGC011"),  # used in both directions
        (16, 5, "SBGC020"),
        (18, 31, "SBGC017"),
        (19, 12, "SBGC012"),
        (19, 40, "SBGC023"),
        (20, 12, "SBGC019"),
        (20, 21, "SBGC010"),
        (21, 12, "SBGC022"),
        (26, 16, "SBGC021"),
    ]


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


def test_misspelt_type_does_not_bring_other_findings_with_it(tmp_path: Path) -> None:
    """The size of a form is unknown while one of its types is."""
    forms = """\
family: probe
commands:
  CMD_PROBE:
    id: 9
    summary: Two forms.
    from_board:
      source: L1
      forms:
        simple:
          fields: [{name: A, type: u8, summary: A number.}]
        extended:
          fields: [{name: A, type: u8, summary: A number.}, {name: B, type: u18, summary: B.}]
"""
    assert [d.code for d in findings(tmp_path, forms)] == ["SBGC010"]


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
    assert did_you_mean("Agnle", ["Speed", "Angle"]) == "did you mean 'Angle'?"
    assert did_you_mean("U8", ["u8", "i8"]) == "did you mean 'u8'?"
    assert did_you_mean("zzz", ["u8", "i8"]) == ""
    assert did_you_mean("x", []) == ""
