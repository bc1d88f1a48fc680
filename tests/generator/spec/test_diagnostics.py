"""Tests of the findings as a whole: complete, ordered, without duplicates, and with hints."""

from __future__ import annotations

from pathlib import Path

import pytest

from sbgcgen.build import load_protocol
from sbgcgen.model import Position
from sbgcgen.spec.diagnostics import Diagnostics, SpecError, did_you_mean
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
    assert did_you_mean("Agnle", ["Speed", "Angle"]) == "did you mean 'Angle'?"
    assert did_you_mean("U8", ["u8", "i8"]) == "did you mean 'u8'?"
    assert did_you_mean("zzz", ["u8", "i8"]) == ""
    assert did_you_mean("x", []) == ""
