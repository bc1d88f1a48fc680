"""The fingerprint of the model changes with the meaning of the protocol, and with nothing else."""

from __future__ import annotations

from pathlib import Path

import pytest

from sbgcgen.build import load_layout
from sbgcgen.model.export import export
from support import layout_of

PROBE = """\
family: probe
summary: Two commands.

enums:
  Color:
    type: u8
    prefix: COLOR_
    summary: A color.
    source: Variables L30
    values:
      COLOR_RED: {value: 0, summary: Like fire.}

commands:
  CMD_FIRST:
    id: 10
    summary: The first.
    from_board:
      source: Incoming commands L50
      fields:
        - {name: COLOR, type: Color, summary: Which color.}
        - {name: LEVEL, type: u8, range: 0..100, special: {255: unknown}, summary: How full it is.}

  CMD_SECOND:
    id: 11
    summary: The second.
    from_board:
      source: Incoming commands L51
      fields:
        - {name: ANGLE, type: Angle, summary: Where it is.}
"""
SECOND = PROBE[PROBE.index("  CMD_SECOND:") :]
SWAPPED = PROBE.replace(SECOND, "").replace("  CMD_FIRST:", SECOND + "\n  CMD_FIRST:")


def fingerprint(folder: Path, text: str) -> str:
    return str(export(layout_of(folder, text))["fingerprint"])


@pytest.mark.parametrize(
    "edited",
    [
        PROBE.replace("How full it is.", "The level."),
        PROBE.replace("Like fire.", "Like blood."),
        PROBE.replace("Two commands.", "Some commands."),
        PROBE.replace("255: unknown", "255: not known"),
        PROBE.replace("L50", "L52"),
        SWAPPED,
    ],
    ids=["field", "value", "family", "special value", "source", "order"],
)
def test_prose_and_order_have_no_effect(edited: str, tmp_path: Path) -> None:
    assert edited != PROBE
    assert fingerprint(tmp_path / "new", edited) == fingerprint(tmp_path / "old", PROBE)


@pytest.mark.parametrize(
    "old, new",
    [
        ("id: 10", "id: 12"),
        ("CMD_SECOND", "CMD_OTHER"),
        ("name: LEVEL", "name: HEIGHT"),
        ("LEVEL, type: u8", "LEVEL, type: u16"),
        ("0..100", "0..101"),
        ("255: unknown", "254: unknown"),
        ("{value: 0,", "{value: 1,"),
        ("COLOR_RED", "COLOR_BLUE"),
        ("type: Angle", "type: Speed"),
    ],
)
def test_every_fact_has_an_effect(old: str, new: str, tmp_path: Path) -> None:
    edited = PROBE.replace(old, new)
    assert edited != PROBE
    assert fingerprint(tmp_path / "new", edited) != fingerprint(tmp_path / "old", PROBE)


def test_the_shared_facts_have_an_effect(tmp_path: Path) -> None:
    before = fingerprint(tmp_path, PROBE)
    for file, old, new in (
        ("simplebgc.yaml", "start: 0x3E", "start: 0x3F"),
        ("simplebgc.yaml", "answer_timeout_ms: 500", "answer_timeout_ms: 600"),
        ("base.yaml", "scale: 360/16384", "scale: 360/16385"),
    ):
        text = (tmp_path / "spec" / file).read_text(encoding="utf-8")
        assert old in text
        (tmp_path / "spec" / file).write_text(text.replace(old, new), encoding="utf-8")
        after = fingerprint_of_spec(tmp_path / "spec")
        assert after != before
        before = after


def fingerprint_of_spec(spec: Path) -> str:
    return str(export(load_layout(spec))["fingerprint"])
