"""Tests of sbgc send: any message, with values from the command line."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from typing import Any

import pytest

from board_command import answer_on_terminal
from emulated_gimbal import emulated_gimbal
from sbgc_command import MODEL, Result, decode_one, run

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


def refused(*arguments: str) -> str:
    result = run("send", *arguments, "--dry-run")
    assert result.status == 2 and result.out == b"", result
    return result.error


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
    error = refused("ControlQuatAttitudePacked", "target_attitude=a:0.9")
    assert "0.9 does not fit into 'a'" in error


def test_the_response_as_text_and_json(board: str) -> None:
    text = run("send", "CMD_GET_ANGLES", "-p", board).text
    assert "GetAngles" in text and "axes.pitch.imu_angle" in text and "deg" in text
    line = run("send", "CMD_GET_ANGLES", "--format", "jsonl", "-p", board).objects[0]
    assert line["message"] == "GetAngles" and line["direction"] == "from_board"
    assert set(line["fields"]["axes"]) == {"roll", "pitch", "yaw"}


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


def test_errors_of_the_board(board: str) -> None:
    result: Result = run("send", "ReadParamsExt3Request", "-p", board)
    assert result.status == 1 and "firmware" in result.error
    assert run("send", "get_angles", "-p", "tcp:127.0.0.1:1", "--timeout", "1").status == 1


def test_requests_without_a_response_say_so(board: str) -> None:
    result = run("send", "CMD_HELPER_DATA", "--yes", "-p", board)
    assert result.status == 0 and result.out == b""
    assert "no response" in result.error or "did not confirm" in result.error


def test_json_of_a_dry_run_can_be_encoded() -> None:
    line = dry("Control", "pitch.angle=-30deg")
    assert run("encode", "--hex", stdin=json.dumps(line)).text.split()[0] == (
        run("send", "Control", "pitch.angle=-30deg", "--dry-run").text.split()[0]
    )


def test_the_scale_is_that_of_the_board() -> None:
    """P of roll is logarithmic from firmware 2.73.1 on: 5 * 52^(raw / 255) - 5."""
    change = ("SetAdjVarsVal", "params[0].param_id=P_ROLL", "params[0].param_value=20")

    def raw(*options: str) -> int:
        (line,) = run("send", *change, "--dry-run", "--format", "jsonl", *options).objects
        value: int = line["fields"]["params"][0]["param_value"]
        return value

    assert (raw(), raw("--firmware", "2.73"), raw("--firmware", "2.74.5")) == (20, 20, 104)
    assert "20 (before firmware 2.73.1)" in run("send", *change, "--dry-run").text
    assert "before" not in run("send", *change, "--dry-run", "--firmware", "2.73").text
    assert run("send", *change, "--firmware", "2.73").status == 2, "only a dry run has no board"
    for firmware, sent in (("2.73", 20), ("2.74.5", 104)):
        with emulated_gimbal("--firmware", firmware) as gimbal:
            board = ("--port", gimbal.address)
            assert run("send", *change, *board, "--yes").status == 0
            ask = ("GetAdjVarsVal", "param_id=P_ROLL")
            (answer,) = run("send", *ask, *board, "--format", "jsonl").objects
            assert answer["fields"]["params"] == [{"param_id": 0, "param_value": sent}]
            assert "before" not in run("send", *ask, *board).text
            # Only the later scale has fractions.
            fraction = run("send", *change[:2], "params[0].param_value=20.5", *board, "--yes")
            assert (fraction.status == 0) == (firmware == "2.74.5"), fraction


def test_any_id_and_body_can_be_sent(board: str) -> None:
    """Also of a command that the model does not know: armed, because its effect is unknown."""
    assert 200 not in {message["id"] for message in MODEL["messages"]}
    (line,) = run("send", "--id", "200", "--body", "0e45", "--dry-run", "--format", "jsonl").objects
    assert (line["id"], line["body"]) == (200, "0e45")

    unarmed = run("send", "--id", "200", "--body", "0e45", "--port", board)
    assert unarmed.status != 0 and "effect is not checked" in unarmed.error
    unknown = run("send", "--id", "200", "--body", "0e45", "--port", board, "--yes")
    assert unknown.status == 1 and "the board refused" in unknown.error

    assert run("send", "--id", "200", "--body", "00" * 256, "--dry-run").status == 2
    answered = run("send", "--id", "73", "--port", board, "--yes", "--format", "jsonl")
    assert answered.status == 0, answered
    assert answered.objects[0]["message"] == "GetAngles"
