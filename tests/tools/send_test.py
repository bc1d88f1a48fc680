"""Tests of sbgc send: any message, with values from the command line."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from typing import Any

import pytest

from board_command import answer_on_terminal
from emulated_gimbal import emulated_gimbal
from sbgc_command import MODEL, decode_one, run

REQUESTS = [message for message in MODEL["messages"] if message["direction"] == "to_board"]


@pytest.fixture(name="board", scope="module")
def fixture_board() -> Iterator[str]:
    with emulated_gimbal() as gimbal:
        yield gimbal.address


def dry(*arguments: str) -> Any:
    """The object that a dry run prints."""
    result = run("send", *arguments, "--dry-run", "--format", "jsonl")
    assert result.status == 0, result
    return result.objects[0]


def fields_of(*arguments: str) -> Any:
    return dry(*arguments)["fields"]


@pytest.mark.parametrize("name", sorted({message["name"] for message in REQUESTS}))
def test_every_request_can_be_made(name: str) -> None:
    """A new message is a frame that decodes as this message, if it has its smallest size."""
    result = run("send", name, "--dry-run", "--no-validate")
    (message,) = [one for one in REQUESTS if one["name"] == name]
    assert result.status == 0, result
    line = decode_one(result.text.splitlines()[0], "--hex", "--from", "host")
    assert line["id"] == message["id"]
    assert "error" not in line


def test_parts_of_a_packed_value_in_their_unit() -> None:
    values = fields_of("ControlQuatAttitudePacked", "target_attitude=a:0.5,b:-0.25,largest:Z")
    # A component is its count divided by 524287 times the square root of 2; the sign is the bit
    # above it.
    a, b = (round(size * 524287 * math.sqrt(2)) for size in (0.5, 0.25))
    assert int(values["target_attitude"]) == 3 << 60 | 1 << 39 | b << 20 | a


def test_what_reads_needs_no_confirmation_and_what_moves_does(board: str) -> None:
    assert run("send", "CMD_MOTORS_ON", "--yes", "-p", board).status == 0
    unarmed = run("send", "CMD_MOTORS_OFF", "-p", board)
    assert unarmed.status == 1 and "add --yes" in unarmed.error
    assert motors(board) == 1
    armed = run("send", "CMD_MOTORS_OFF", "--yes", "-p", board)
    assert armed.status == 0 and "CMD_CONFIRM" in armed.text
    assert motors(board) == 0
    for hidden in (("CMD_AHRS_HELPER", "mode=SET"), ("CMD_BEEP_SOUND", "mode=1")):
        assert "add --yes" in run("send", *hidden, "-p", board).error
    assert run("send", "CMD_AHRS_HELPER", "-p", board).status == 0
    assert answer_on_terminal("n", "send", "CMD_MOTORS_ON", "-p", board).status == 1
    assert motors(board) == 0
    assert answer_on_terminal("y", "send", "CMD_MOTORS_ON", "-p", board).status == 0
    assert motors(board) == 1


def motors(board: str) -> int:
    """Returns whether the motors are on, according to the live data."""
    line = run("send", "RealtimeData4Request", "--format", "jsonl", "-p", board).objects[0]
    return line["fields"]["other_flags"] & 1


def test_json_of_a_dry_run_can_be_encoded() -> None:
    line = dry("Control", "pitch.angle=-30deg")
    assert run("encode", "--hex", stdin=json.dumps(line)).text.split()[0] == (
        run("send", "Control", "pitch.angle=-30deg", "--dry-run").text.split()[0]
    )
