"""Texts of values, and the history of the protocol: what each version added, changed and ended."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from sbgcgen.model import AxisDirection, Layout
from sbgcgen.views.firmware import History
from sbgcgen.views.words import directions_text, to_json
from support import layout_of

VALUES: list[Any] = [
    *({}, [], "", 0, -5, True, False, None, 1 << 70, 0.1, 1e300),
    'quotes " and \\, a\nline, \x00, \x7f, \u00e9\u20ac\U0001f4f7',
    {"": [], "a": {}, "true": [True, 1, 1.0, False, 0, None], "é": {"b": [[], [{}], [[1], "2"]]}},
    [{"a": 1, "b": [{"c": [{"d": None}]}], "e": 2}, {}, {"b": []}],
]


@pytest.mark.parametrize("value", VALUES, ids=repr)
def test_json_says_what_the_standard_library_reads(value: Any) -> None:
    assert json.loads(to_json({"a": value, "b": [value]})) == {"a": value, "b": [value]}


def test_directions_are_a_sentence() -> None:
    pitch = AxisDirection("PITCH", "down", "up", ())
    roll = AxisDirection("ROLL", None, None, ())
    assert directions_text([]) == ""
    assert directions_text([roll]) == "For roll it is not known."
    text = "Positive pitch is down, negative up; for roll it is not known."
    assert directions_text([roll, pitch]) == text


PROBE = """\
family: probe
enums:
  Lamp:
    type: u8
    summary: A lamp.
    source: L1
    values:
      OFF: {value: 0, summary: It is off.}
      LIT: {value: 1, since: {firmware: 2.60b3}, summary: It is lit.}
      DIM: {value: 2, since: {firmware: 2.60}, before: {firmware: 2.60, summary: It was red.}, summary: It is dim.}
structs:
  Colors:
    summary: Colors.
    fields:
      - {name: RED, type: u8, summary: Red.}
      - {name: BLUE, type: u8, summary: Blue.}
variables:
  DIMMER: {id: 7, type: u8, range: 0..9, since: {firmware: 2.70}, summary: A dimmer.}
commands:
  CMD_OLD:
    id: 9
    since: {board: 3.0}
    summary: An old command.
    from_board:
      source: L1
      fields:
        - {name: ID, type: VariableId, deprecated: {since: {firmware: 2.70}}, summary: A variable.}
        - {name: LAMP, type: Lamp, since: {firmware: 2.60b3}, summary: A lamp.}
        - {name: COLORS, type: Colors, since: {firmware: 2.60b3}, summary: Its colors.}
    to_board:
      source: L2
      effect: sets
      summary: Set the lamp.
      answer: none
      forms:
        simple:
          since: {board: 3.0}
          until: {firmware: 2.70, instead: extended}
          fields:
            - {name: MODE, type: u8, summary: A mode.}
        extended:
          since: {firmware: 2.70}
          fields:
            - {name: MODE, type: u16, summary: A mode.}
  CMD_LATER:
    id: 10
    since: {firmware: 2.70}
    summary: A new command.
    from_board:
      source: L1
      fields:
        - {name: A, type: u8, since: {firmware: 2.70}, summary: A number.}
"""


@pytest.fixture(name="layout")
def made(tmp_path: Path) -> Layout:
    return layout_of(tmp_path, PROBE)


def test_news_of_a_firmware(layout: Layout) -> None:
    first, beta, last = History(layout).of_firmware
    assert [value.name for _, value in first.changed] == ["DIM"]
    assert first.enum_values == [], "a value that changed its meaning is not new"
    assert [value.name for _, value in beta.enum_values] == ["LIT"]
    assert [row.path for _, row in beta.fields] == ["lamp", "colors"]
    assert [command.name for command in last.commands] == ["CMD_LATER"]
    assert [message.name for message in last.messages_of(last.commands[0])] == ["Later"]
    assert [message.name for message in last.forms] == ["OldRequestExt"]
    assert [message.name for message in last.ended] == ["OldRequest"]
    assert [variable.name for variable in last.variables] == ["DIMMER"]
    assert [row.path for _, row in last.deprecated] == ["id"]
    assert last.fields == [], "a field is not newer than its message"
