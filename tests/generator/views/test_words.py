"""The texts of values."""

from __future__ import annotations

import json
from typing import Any

import pytest

from sbgcgen.model import AxisDirection
from sbgcgen.views.words import directions_text, to_json

VALUES: list[Any] = [
    *({}, [], "", 0, -5, True, False, None, 1 << 70, 0.1, 1e300),
    'quotes " and \\, a\nline, \x00, \x7f, \u00e9\u20ac\U0001f4f7',
    {"": [], "a": {}, "true": [True, 1, 1.0, False, 0, None], "é": {"b": [[], [{}], [[1], "2"]]}},
    [{"a": 1, "b": [{"c": [{"d": None}]}], "e": 2}, {}, {"b": []}],
]


@pytest.mark.parametrize("value", VALUES, ids=repr)
def test_json_says_what_the_standard_library_reads(value: Any) -> None:
    assert json.loads(to_json({"a": value, "b": [value]})) == {"a": value, "b": [value]}


def test_json_has_a_line_for_each_object_of_a_list() -> None:
    enums = [{"name": "A", "values": [{"raw": 0}, {"raw": 1}], "size": 1}, {"name": "B", "of": {}}]
    assert to_json({"version": [1, 2], "enums": enums}).splitlines() == [
        "{",
        '  "version": [1, 2],',
        '  "enums": [',
        '    {"name": "A",',
        '      "values": [',
        '        {"raw": 0},',
        '        {"raw": 1}',
        '      ], "size": 1},',
        '    {"name": "B", "of": {}}',
        "  ]",
        "}",
    ]


def test_directions_are_a_sentence() -> None:
    pitch = AxisDirection("PITCH", "down", "up", ())
    roll = AxisDirection("ROLL", None, None, ())
    assert directions_text([]) == ""
    assert directions_text([roll]) == "For roll it is not known."
    text = "Positive pitch is down, negative up; for roll it is not known."
    assert directions_text([roll, pitch]) == text
