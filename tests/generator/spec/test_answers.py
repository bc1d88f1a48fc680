"""Tests of response policies by case, and of the line. The spec of the project has the other facts of both."""

from __future__ import annotations

from pathlib import Path

import pytest

from sbgcgen.build import load_layout
from support import HERE, layout_of, message_of, write_spec

TEXT = """\
family: probe
summary: A request with three cases.
enums:
  Rate:
    type: u8
    summary: How fast.
    source: Variables L23
    values:
      SLOW: {value: 0, number: 9600, summary: Slow.}
      FAST: {value: 1, number: 115200, summary: Fast.}
commands:
  CMD_GET:
    id: 12
    summary: Something.
    to_board:
      source: Outgoing commands L61
      effect: reads
      answer:
        - {when: {field: OPTIONS, has: OPTION_FAST}, confirm: FIRST}
        - {when: {field: MODE, is: [MODE_OFF, MODE_ON]}, confirm: FIRST, then: restart}
        - {confirm: SECOND}
      fields:
        - {name: OPTIONS, type: Options, summary: How.}
        - {name: MODE, type: Mode, summary: What.}
        - {name: RATE, type: Rate, summary: How fast.}
"""


@pytest.mark.parametrize(
    ("first", "second", "both"),
    [
        ("unlikely", "unlikely", "unlikely"),
        ("unlikely", "never", "unlikely"),
        ("unlikely", "possible", "possible"),
        ("unlikely", "always", "possible"),
        ("never", "always", "possible"),
    ],
)
def test_how_sure_a_confirmation_is_in_all_cases(
    first: str, second: str, both: str, tmp_path: Path
) -> None:
    text = TEXT.replace("FIRST", first).replace("SECOND", second)
    answer = message_of(layout_of(tmp_path, text), "Get").answer
    assert answer is not None and answer.confirm == both


def test_line(tmp_path: Path) -> None:
    main = (HERE / "minimal" / "simplebgc.yaml").read_text(encoding="utf-8")
    spec = write_spec(tmp_path, TEXT.replace("FIRST", "never").replace("SECOND", "never"))
    assert load_layout(spec).line.baud_rates == (), "a spec need not say anything about it"
    line = (
        "line:\n  baud_rates: Rate\n  more_baud_rates: [1000]\n  parities: [even, none]\n"
        '  pause_ms: 3..40\n  source: "Message format (L2)"\n'
    )
    (spec / "simplebgc.yaml").write_text(f"{main}\n{line}", encoding="utf-8")
    found = load_layout(spec).line
    assert (found.baud_rates, found.named) == ((9600, 115200, 1000), 2)
    assert found.parities == ("even", "none")
    assert (found.shortest_pause_ms, found.longest_pause_ms) == (3, 40)
