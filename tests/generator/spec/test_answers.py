"""Tests of response policies by case, correlation fields, roles and the line."""

from __future__ import annotations

from pathlib import Path

import pytest

from sbgcgen.build import load_layout
from sbgcgen.model import Answer, Layout
from support import HERE, layout_of, message_of, write_spec

TEXT = """\
family: probe
summary: Requests of all kinds.

enums:
  Closing:
    type: u8
    summary: How it went.
    source: Variables L22
    success: GOOD
    values:
      GOOD: {value: 3, summary: Well.}
      BAD:  {value: 4, summary: Not well.}
  Rate:
    type: u8
    summary: How fast.
    source: Variables L23
    values:
      SLOW: {value: 0, number: 9600, summary: Slow.}
      FAST: {value: 1, number: 115200, summary: Fast.}

quantities:
  Time:
    {type: u16, unit: ms, accessor: milliseconds, scale: 10, summary: A time.}

commands:
  CMD_DONE:
    id: 10
    summary: It is done.
    from_board:
      source: Incoming commands L50
      role: {is: confirmation, command: CMD}
      fields:
        - {name: CMD, type: CommandToBoard, summary: What.}
        - {name: PLACE, type: u16, when: {field: CMD, is: [CMD_PUT], may_be_missing: true}, summary: Where.}
        - {name: ENDING, type: Closing, when: {field: CMD, is: [CMD_PUT], may_be_missing: true}, summary: How.}

  CMD_PUT:
    id: 11
    summary: Put.
    to_board:
      source: Outgoing commands L60
      effect: reads
      answer: {confirm: always, confirmations: 2, timeout_ms: 70, finish_ms: 900, correlation: [PLACE]}
      fields:
        - {name: PLACE, type: u16, summary: Where.}

  CMD_GET:
    id: 12
    summary: Something.
    from_board:
      source: Incoming commands L51
      forms:
        success:
          summary: It.
          fields:
            - {name: SIZE, type: u8, summary: How much.}
            - {name: PLACE, type: u16, summary: Where.}
        error:
          summary: Why not.
    to_board:
      source: Outgoing commands L61
      effect: reads
      summary: Get.
      answer:
        - {when: {field: OPTIONS, has: OPTION_FAST}, message: [Get, GetError], correlation: [PLACE], retry: safe}
        - {when: {field: MODE, is: [MODE_OFF, MODE_ON]}, confirm: possible, then: restart}
        - none
      fields:
        - {name: PLACE, type: u16, special: {65535: the last one}, summary: Where.}
        - {name: OPTIONS, type: Options, summary: How.}
        - {name: MODE, type: Mode, summary: What.}
        - {name: RATE, type: Rate, summary: How fast.}

  CMD_STREAM:
    id: 13
    summary: Starts a stream.
    to_board:
      source: Outgoing commands L62
      effect: reads
      answer: {confirm: always}
      role: {is: stream_request, command: ID, interval: TIME, config: HOW, end: 0, cycle: 1, cycle_us: 80, limit: 7, messages: [Ping]}
      fields:
        - {name: TIME, type: Time, summary: How long.}
        - {name: ID, type: CommandFromBoard, summary: Which.}
        - {name: HOW, type: "bytes[4]", summary: How.}
"""


def answer_of(layout: Layout, name: str) -> Answer:
    answer = message_of(layout, name).answer
    assert answer is not None
    return answer


def test_cases(tmp_path: Path) -> None:
    answer = answer_of(layout_of(tmp_path, TEXT), "GetRequest")
    first, second, last = answer.cases
    assert first.when and first.when.source == "options" and first.when.mask == 1
    assert (first.messages, first.confirm, first.restarts) == (("Get", "GetError"), "never", False)
    assert second.when and [v.name for v in second.when.values] == ["MODE_OFF", "MODE_ON"]
    assert (second.messages, second.confirm, second.restarts) == ((), "possible", True)
    assert (last.when, last.messages, last.confirm) == (None, (), "never")
    assert answer.messages == ("Get", "GetError")
    assert (answer.confirm, answer.is_certain, answer.retry_safe) == ("possible", False, False)


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
    text = TEXT.replace("message: [Get, GetError], correlation: [PLACE]", f"confirm: {first}")
    text = text.replace("confirm: possible, then: restart", f"confirm: {first}")
    text = text.replace("        - none\n", f"        - {{confirm: {second}}}\n")
    assert answer_of(layout_of(tmp_path, text), "GetRequest").confirm == both


def test_echoes_stand_where_the_answer_has_them(tmp_path: Path) -> None:
    layout = layout_of(tmp_path, TEXT)
    success, error = answer_of(layout, "GetRequest").cases[0].responses
    assert [(e.field.name, e.offset, e.size) for e in success.correlation] == [("place", 1, 2)]
    assert [s.value for s in success.correlation[0].field.special] == [65535]
    assert (success.is_error, success.min_size) == (False, 3)
    assert (error.is_error, error.min_size, error.correlation) == (True, 0, ())


def test_data_of_a_confirmation(tmp_path: Path) -> None:
    layout = layout_of(tmp_path, TEXT)
    (case,) = answer_of(layout, "Put").cases
    assert (case.timeout_ms, case.finish_ms, case.confirmations) == (70, 900, 2)
    assert case.confirmation and (case.confirmation.offset, case.confirmation.size) == (1, 2)
    assert case.result and (case.result.offset, case.result.success.value) == (3, 3)
    (other,) = answer_of(layout, "Stream").cases
    assert other.confirmation is None and other.result is None, "its data belong to another command"


def test_roles(tmp_path: Path) -> None:
    layout = layout_of(tmp_path, TEXT)
    (confirmation,) = layout.having_role("confirmation")
    assert confirmation.name == "Done"
    (request,) = layout.having_role("stream_request")
    role = request.role
    assert role is not None
    assert {part: field.offset for part, field in role.parts.items()} == {
        "command": 2,
        "interval": 0,
        "config": 3,
    }
    assert (role.interval_us, role.end, role.cycle, role.cycle_us) == (10000, 0, 1, 80)
    assert role.limit == 7
    assert [(s.message, s.max_size) for s in role.streams] == [("Ping", 1)]
    assert layout.having_role("reset") == ()


def test_line(tmp_path: Path) -> None:
    main = (HERE / "minimal" / "simplebgc.yaml").read_text(encoding="utf-8")
    spec = write_spec(tmp_path, TEXT)
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
