"""The texts of values."""

from __future__ import annotations

import json
from typing import Any

import pytest

from sbgcgen.model import AxisDirection
from sbgcgen.views.words import directions_text, to_json

VALUES: list[Any] = [
    *({}, [], (), "", 0, -5, True, False, None, 1 << 70, 0.1, 1e300),
    'quotes " and \\, a\nline, \x00, \x7f, \u00e9\u20ac\U0001f4f7',
    {"": [], "a": {}, "true": [True, 1, 1.0, False, 0, None], "é": {"b": [[], [{}], [[1], "2"]]}},
    [("a", 1), {"c": ({"d": None},)}],
]


@pytest.mark.parametrize("value", VALUES, ids=repr)
def test_json_is_that_of_the_standard_library(value: Any) -> None:
    assert to_json(value) == json.dumps(value, indent=2, ensure_ascii=False)


def test_directions_are_a_sentence() -> None:
    pitch = AxisDirection("PITCH", "down", "up", ())
    roll = AxisDirection("ROLL", None, None, ())
    assert directions_text([]) == ""
    assert directions_text([roll]) == "For roll it is not known."
    text = "Positive pitch is down, negative up; for roll it is not known."
    assert directions_text([roll, pitch]) == text
