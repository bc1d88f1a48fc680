"""The dissector for Wireshark: what Lua and Wireshark cannot have is found before anything is written."""

from __future__ import annotations

from pathlib import Path

import pytest

from sbgcgen.targets.wireshark.tables import lua
from support import findings

LONG = "A" * 60
WIDE = """  V:
    type: u64
    summary: Parts.
    source: L1
    parts:
      - {name: wide, bits: 0..39, summary: A wide part.}
"""


@pytest.mark.parametrize(
    ("field", "packed", "problem"),
    [
        ("{name: A, type: Angle, summary: One.}", "", ""),
        (f"{{name: {LONG}, type: P, summary: One.}}", "", "has over 128 characters"),
        ("{name: A, type: u8, summary: One.}", WIDE, "has over 32 bits"),
    ],
)
def test_limits(tmp_path: Path, field: str, packed: str, problem: str) -> None:
    text = f"""family: probe
summary: Limits.
packed:
  P:
    type: u8
    summary: Parts.
    source: L1
    parts:
      - {{name: {'part_' * 12}, bits: 0..3, summary: A part with a long name.}}
{packed}commands:
  CMD_PROBE:
    id: 9
    summary: A command.
    from_board:
      source: L1
      fields:
        - {field}
"""
    found = [str(one) for one in findings(tmp_path, text) if "SBGC022" in one.code]
    assert any(problem in one for one in found) if problem else not found, found


def test_literals_of_lua() -> None:
    assert lua({"a": 1, "end": "x", 3: True, "no": False, "none": None, "empty": []}) == (
        '{a = 1, ["end"] = "x", [3] = true}'
    )
    assert lua('"\\\n') == '"\\"\\\\\\n"'
