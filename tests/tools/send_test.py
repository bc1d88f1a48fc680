"""Tests of sbgc send: any message, with values from the command line."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from typing import Any

import pytest

from board_command import answer_on_terminal
from emulated_gimbal import emulated_gimbal
from sbgc_command import MODEL, Result, decode_one, frame, run

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


@pytest.mark.parametrize(
    "values, words",
    [
        (["cmd_id=24"], "24 has no name; the nearest are CMD_REALTIME_DATA_3 (23) and "),
        ([], "0 has no name; the nearest is CMD_"),
        (["cmd_id=25"], None),
    ],
)
def test_a_value_without_a_name_is_sent_with_a_warning(
    values: list[str], words: str | None, board: str
) -> None:
    for options in (["--dry-run"], ["--port", board, "-y"]):
        result = run("send", "CMD_DATA_STREAM_INTERVAL", *values, *options)
        assert ("warning: cmd_id: " in result.error) == (words is not None), result.error
        assert words is None or f"cmd_id: {words}" in result.error


@pytest.mark.parametrize(
    "name", ["GetAnglesRequest", "getanglesrequest", "CMD_GET_ANGLES", "get_angles"]
)
def test_names_of_a_message(name: str) -> None:
    assert run("send", name, "--dry-run").text.splitlines()[0] == frame(73).hex()


@pytest.mark.parametrize(
    "arguments, message",
    [
        (["CMD_MOTORS_OFF"], "MotorsOff"),
        (["motors_off", "mode=BRAKE"], "MotorsOffExt"),
        (["control", "control_mode=MODE_SPEED"], "Control"),
        (["control", "pitch.control_mode=MODE_SPEED"], "ControlExt"),
    ],
)
def test_the_form_has_the_fields(arguments: list[str], message: str) -> None:
    assert dry(*arguments)["message"] == message


@pytest.mark.parametrize(
    "values, path, expected",
    [
        (["axes.pitch.angle=-30deg"], "axes.pitch.angle", -1365),
        (["pitch.angle=-30"], "axes.pitch.angle", -1365),
        (["pitch.angle=-30 deg"], "axes.pitch.angle", -1365),
        (["pitch.angle=+30"], "axes.pitch.angle", 1365),
        (["pitch.angle=-30°"], "axes.pitch.angle", -1365),
        (["ANGLE_PITCH=raw:-1365"], "axes.pitch.angle", -1365),
        (["angle=10,20,30"], "axes.yaw.angle", 1365),
        (["SPEED_YAW=5deg/s"], "axes.yaw.speed", 41),
        (
            ["yaw.speed=5", "control_mode=MODE_SPEED|CONTROL_FLAG_HIGH_RES_SPEED"],
            "axes.yaw.speed",
            5000,
        ),
        (["control_mode=mode_angle,CONTROL_FLAG_AUTO_TASK"], "control_mode", 0x42),
        (["control_mode=0x42"], "control_mode", 0x42),
        (["control_mode=mode:2"], "control_mode", 2),
    ],
)
def test_values(values: list[str], path: str, expected: int) -> None:
    value = fields_of("Control", *values)
    for step in path.split("."):
        value = value[step]
    assert value == expected


def test_values_with_a_meaning_of_their_own_may_be_outside_of_the_range() -> None:
    assert fields_of("ReadParams3Request", "profile_id=255") == {"profile_id": 255}
    assert "254 is above 4" in refused("ReadParams3Request", "profile_id=254")


def test_a_name_of_the_specification_counts_elements_as_it_does() -> None:
    names = fields_of("WriteProfileNames", "PROFILE3_NAME=abc")["profile_name"]
    assert names == ["", "", "abc", "", ""]
    for other in ("PROFILE0_NAME", "PROFILE6_NAME", "PROFILE_NAME_"):
        assert f"no field '{other}'" in refused("WriteProfileNames", f"{other}=abc")


def test_parts_of_a_packed_value_in_their_unit() -> None:
    values = fields_of("ControlQuatAttitudePacked", "target_attitude=a:0.5,b:-0.25,largest:Z")
    # A component is its count divided by 524287 times the square root of 2; the sign is the bit
    # above it.
    a, b = (round(size * 524287 * math.sqrt(2)) for size in (0.5, 0.25))
    assert int(values["target_attitude"]) == 3 << 60 | 1 << 39 | b << 20 | a
    error = refused("ControlQuatAttitudePacked", "target_attitude=a:0.9")
    assert "0.9 does not fit into 'a'" in error


def test_real_numbers_in_their_unit() -> None:
    # A board counts in amperes.
    assert fields_of("WriteStateVars", "avg_current=2500mA")["avg_current"] == 2.5
    assert fields_of("WriteStateVars", "avg_current=raw:2500")["avg_current"] == 2500


def test_lists_that_need_elements_have_them() -> None:
    assert fields_of("DebugVars3RequestSelected") == {"selected_mask": [0]}


def test_lists_bytes_texts_and_flags() -> None:
    beep = fields_of(
        "BeepSound", "note_freq_hz=600Hz,700,21000", "note_length=40ms", "mode=CUSTOM_MELODY"
    )
    assert beep["note_freq_hz"] == [600, 700, 21000]
    assert (beep["note_length"], beep["mode"]) == (5, 0x8000)
    two = fields_of(
        *("SetAdjVarsVal", "params[1].param_id=LPF_FREQ_ROLL", "params[1].param_value=30Hz"),
        *("params[0].param_id=P_YAW", "params[0].param_value=7"),
    )
    assert two["params"] == [{"param_id": 2, "param_value": 7}, {"param_id": 45, "param_value": 30}]
    data = fields_of("EepromWrite", "addr=64", "data=" + "00ff" * 32)
    assert data["data"] == "00ff" * 32
    names = fields_of("WriteProfileNames", "profile_name[2]=Ünï")
    assert names["profile_name"][2] == "Ünï"
    assert run("send", "73", "--dry-run").text == run("send", "GetAnglesRequest", "--dry-run").text
    stream = fields_of("DataStreamInterval", "cmd_id=88", "config.flags=IMU_ANGLES|GYRO_DATA")
    assert stream["config"]["flags"] == flags_named(
        "RealtimeDataCustomFlags", "IMU_ANGLES", "GYRO_DATA"
    )


def flags_named(enum: str, *names: str) -> int:
    (found,) = [one for one in MODEL["enums"] if one["name"] == enum]
    return sum(value["value"] for value in found["values"] if value["name"] in names)


@pytest.mark.parametrize(
    "arguments, words",
    [
        (["Contrl"], ["unknown message 'Contrl'"]),
        (["CMD_GET_ANGELS"], ["'CMD_GET_ANGLES'"]),
        (["GetAngles"], ["only the board", "GetAnglesRequest"]),
        (["Control", "anle=5"], ["no field 'anle'", "'angle'"]),
        (
            ["SetAdjVarsVal", "params[1].param_id=P_ROLL"],
            ["params[0] has no value, but params[1].param_id has one", "count from 0"],
        ),
        (["Control", "angle=5V"], ["axes.roll.angle", "'V'", "deg"]),
        (["Control", "pitch.angle=900"], ["axes.pitch.angle", "900", "719.978 deg"]),
        (["Control", "control_mode=MODE_ANGEL"], ["'MODE_ANGLE'"]),
        (["Control", "axes.pitch=3"], ["speed or angle"]),
        (["Control", "control_mode=256"], ["256", "0 to 255"]),
        (["Control", "pitch.angle=1", "axes.pitch.angle=2"], ["axes.pitch.angle is set twice"]),
        (["Control", "pitch.angle"], ["NAME=VALUE"]),
        (
            ["Control", "pitch.angle+=5"],
            ["a request has no present value", "write pitch.angle=VALUE"],
        ),
        (["Control", "pitch.angle=+10%"], ["a request has no present value"]),
        (["BeepSound", "note_freq_hz=600,1"], ["note_freq_hz", "554 Hz"]),
        (["BeepSound", "note_freq_hz[99]=600"], ["99"]),
        (["BeepSound", "decay_factor=16"], ["decay_factor", "16"]),
        (["Control", "pitch.angle=+"], ["'+' is not a number"]),
        (["Control", "pitch.angle=+-3"], ["'+-3' is not a number"]),
        (["BeepSound", "mode=CUSTOM_MELODY|0x10000"], ["does not fit into 2 bytes"]),
        (["SetAdjVarsVal", "param_id=3"], ["such as params[0].…"]),
        (["WriteProfileNames", "profile_name=x,y"], ["5 elements"]),
        (["SetAdjVarsVal", "num_vars=3"], ["num_vars"]),
        (["EepromWrite", "data=0"], ["data", "hex"]),
        (["WriteProfileNames", "profile_name[0]=" + "x" * 49], ["49", "48"]),
        # An empty list that should not be there.
        (
            ["ExtMotorsControl", "data_set=SETPOINT_32BIT", "setpoint16="],
            ["setpoint16", "condition"],
        ),
    ],
)
def test_mistakes(arguments: list[str], words: list[str]) -> None:
    error = refused(*arguments)
    for word in words:
        assert word in error


def test_dry_run_shows_the_frame_and_the_effect() -> None:
    text = run("send", "CMD_MOTORS_ON", "--dry-run").text
    assert text.startswith(frame(77, b"").hex()) or text.split()[0].startswith("3e4d")
    assert "The camera can move" in text


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


@pytest.mark.parametrize(
    "values, words",
    [
        ([], "Sends CMD_CONTROL. The camera can move"),
        (
            ["control_mode=MODE_SPEED", "SPEED_YAW=5"],
            "Sends CMD_CONTROL with control_mode = MODE_SPEED, SPEED_YAW = 5; every other field is "
            "0, empty or its default. The camera can move",
        ),
        (
            ["control_mode=0", "speed=0", "roll.angle=0", "pitch.angle=0", "yaw.angle=1"],
            "Sends CMD_CONTROL with control_mode = 0, speed = 0, roll.angle = 0, pitch.angle = 0, "
            "yaw.angle = 1",
        ),
    ],
)
def test_the_question_says_what_is_sent(board: str, values: list[str], words: str) -> None:
    result = run("send", "Control", *values, "-p", board)
    assert result.status == 1
    assert " ".join(result.error.split()).startswith(words)


def motors(board: str) -> int:
    """Whether the motors are on, according to the live data."""
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

    answered = run("send", "--id", "73", "--port", board, "--yes", "--format", "jsonl")
    assert answered.status == 0, answered
    assert answered.objects[0]["message"] == "GetAngles"


@pytest.mark.parametrize(
    "arguments",
    [
        [],
        ["get_angles", "--id", "73"],
        ["--id", "0"],
        ["--id", "256"],
        ["--body", "0e45"],
        ["--id", "200", "--body", "0e4"],
        ["--id", "200", "--body", "xy"],
        ["--id", "200", "--body", "00" * 256],
    ],
)
def test_wrong_ids_and_bodies(arguments: list[str]) -> None:
    refused(*arguments)
