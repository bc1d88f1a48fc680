"""Tests of sbgc encode: encoding JSON lines and rejecting invalid ones."""

from __future__ import annotations

import json
import os
import random
import subprocess
from pathlib import Path

import pytest

from sbgc_command import MODEL, PROGRAM, decode, frame, run, valid_frames

GET_ANGLES = '{"message":"GetAnglesRequest","fields":{}}\n'
CONTROL = {
    "message": "Control",
    "fields": {
        "control_mode": 2,
        "axes": {axis: {"speed": 0, "angle": 0} for axis in ("roll", "pitch", "yaw")},
    },
}
BEEP = {
    "message": "BeepSound",
    "fields": {
        "mode": 0x8000,
        "note_length": 5,
        "decay_factor": 3,
        "reserved": "00" * 8,
        "note_freq_hz": [554, 21000],
    },
}


def changed(line: dict, path: str, value: object) -> str:
    """Returns the line with the field at `path` replaced (or, for "REMOVE", removed)."""
    copy = json.loads(json.dumps(line))
    place = copy["fields"]
    *way, last = path.split(".")
    for step in way:
        place = place[step]
    if value == "REMOVE":
        del place[last]
    else:
        place[last] = value
    return json.dumps(copy)


def refusal(text: str, *options: str) -> str:
    """Returns the error message for input that is rejected as a whole."""
    result = run("encode", *options, stdin=text)
    assert result.status == 1
    assert result.out == b""
    assert result.error.startswith("sbgc: line 1: ")
    return result.error


def test_hex_and_raw() -> None:
    assert run("encode", stdin=GET_ANGLES).out == frame(73)
    assert run("encode", "--hex", stdin=GET_ANGLES).out == b"3e49004900\n"


@pytest.mark.parametrize("vector", valid_frames(), ids=lambda v: v["meaning"][:40])
def test_vectors_from_outside_and_back(vector: dict) -> None:
    sender = "host" if vector["direction"] == "to_board" else "board"
    result = run("decode", "--format", "jsonl", "--from", sender, stdin=vector["bytes"])
    if "error" in result.objects[0]:
        pytest.skip("not in the specification of the project yet")
    assert run("encode", "--no-validate", stdin=result.out).out == vector["bytes"]


@pytest.mark.parametrize("direction", ["board", "host"])
def test_every_message_and_back(direction: str) -> None:
    generator = random.Random(3)
    frames = []
    for message in MODEL["messages"]:
        for size in {message["min_size"], message["max_size"], generator.randrange(256)}:
            for _ in range(8):
                body = bytes(generator.choices((0, 1, 2, 3, 0x7F, 0x80, 0xFE, 0xFF), k=size))
                frames.append(frame(message["id"], body))
    printed = run("decode", "--format", "jsonl", "--from", direction, stdin=b"".join(frames))
    lines = printed.out.decode().splitlines(keepends=True)
    assert len(lines) == len(frames)
    good = [pair for pair in zip(lines, frames) if "fields" in json.loads(pair[0])]
    assert len(good) > len(frames) / 8
    result = run("encode", "--no-validate", stdin="".join(line for line, _ in good))
    assert result.status == 0
    assert result.out == b"".join(data for _, data in good)


@pytest.mark.parametrize(
    "path, value, words",
    [
        ("note_freq_hz", [554, 553], ["note_freq_hz[1]", "553", "554"]),
        ("note_freq_hz", [21001], ["note_freq_hz[0]", "21001", "20999"]),
        ("note_freq_hz", [600] * 51, ["note_freq_hz", "51", "50"]),
        ("decay_factor", 16, ["decay_factor", "16", "15"]),
    ],
)
def test_values_that_do_not_validate(path: str, value: object, words: list[str]) -> None:
    line = changed(BEEP, path, value)
    error = refusal(line)
    for word in words:
        assert word in error
    assert run("encode", "--no-validate", stdin=line).status == 0


def test_all_violations_are_named() -> None:
    line = json.loads(changed(BEEP, "decay_factor", 16))
    line["fields"]["note_freq_hz"] = [1, 2]
    assert (
        refusal(json.dumps(line))
        .rstrip()
        .endswith(
            "decay_factor: 16 is above 15; note_freq_hz[0]: 1 Hz is below 554 Hz; "
            "note_freq_hz[1]: 2 Hz is below 554 Hz"
        )
    )


def test_alignment() -> None:
    line = {"message": "EepromWrite", "fields": {"addr": 65, "data": "00" * 64}}
    error = refusal(json.dumps(line))
    assert "addr" in error and "65" in error and "64" in error


@pytest.mark.parametrize(
    "path, value, words",
    [
        ("axes.pitch.angle", 32768, ["axes.pitch.angle", "32768", "32767"]),
        ("axes.pitch.angle", -32769, ["axes.pitch.angle", "-32769", "-32768"]),
        ("axes.pitch.angle", 2**64 - 1, ["axes.pitch.angle", "18446744073709551615", "32767"]),
        ("axes.pitch.angle", 1.5, ["axes.pitch.angle", "integer"]),
        ("axes.pitch.angle", "1", ["axes.pitch.angle", "integer"]),
        ("axes.pitch.angle", None, ["axes.pitch.angle", "integer"]),
        ("axes.pitch.angle", True, ["axes.pitch.angle", "integer"]),
        ("axes.pitch", 7, ["axes.pitch", "object"]),
        ("axes.pitch.angle", "REMOVE", ["axes.pitch.angle", "missing"]),
        ("control_mode", "REMOVE", ["control_mode", "missing"]),
        ("axes.pitch.angel", 1, ["axes.pitch.angel", "unknown"]),
        ("control_mode", 256, ["control_mode", "256", "255"]),
    ],
)
def test_fields_that_do_not_fit(path: str, value: object, words: list[str]) -> None:
    """These cannot be sent, with or without validation."""
    for options in ([], ["--no-validate"]):
        error = refusal(changed(CONTROL, path, value), *options)
        for word in words:
            assert word in error


@pytest.mark.parametrize("value", ["0", "00" * 7, "zz" * 8, 7, ["00"] * 8, "00" * 9])
def test_bytes_that_are_not_hex(value: object) -> None:
    error = refusal(changed(BEEP, "reserved", value), "--no-validate")
    assert "reserved" in error


def test_counter_that_disagrees() -> None:
    fields = {"num_vars": 3, "params": [{"param_id": 1, "param_value": 2}]}
    error = refusal(json.dumps({"message": "SetAdjVarsVal", "fields": fields}))
    assert "num_vars" in error and "3" in error and "1" in error
    del fields["num_vars"]
    assert (
        run("encode", stdin=json.dumps({"message": "SetAdjVarsVal", "fields": fields})).status == 0
    )


def test_condition_that_does_not_hold() -> None:
    fields = {"cmd": 67, "addr": 64, "data": ""}
    error = refusal(json.dumps({"message": "Confirm", "fields": fields}), "--no-validate")
    assert "addr" in error


@pytest.mark.parametrize(
    "text, words",
    [
        ("{", ["JSON"]),
        ('{"message":"Control",}', ["JSON"]),
        ("nonsense", ["JSON"]),
        ('{"message":"Control","fields":{"x":1e999}}', ["JSON"]),
        ('{"message":"\\ud800","fields":{}}', ["JSON"]),
        ("7", ["object"]),
        ("[]", ["object"]),
        ("{}", ["message"]),
        ('{"message":7,"fields":{}}', ["message"]),
        ('{"fields":{}}', ["message"]),
        ('{"message":"Control"}', ["fields"]),
        ('{"message":"Control","fields":[]}', ["object"]),
        ('{"message":"Contrl","fields":{}}', ["Contrl"]),
        ('{"message":"","fields":{}}', ["message"]),
    ],
)
def test_lines_that_make_no_sense(text: str, words: list[str]) -> None:
    error = refusal(text)
    for word in words:
        assert word in error


def test_deep_nesting() -> None:
    depth = 100_000
    deep = "[" * depth + "]" * depth
    for text in (
        "[" * depth,
        deep,
        '{"a":' * depth + "1" + "}" * depth,
        f'{{"message":{deep},"fields":{{}}}}',
        f'{{"message":"Control","fields":{deep}}}',
    ):
        assert "nested deeper than 64 levels, at column " in refusal(text)


def test_members_that_grow_on_many_levels() -> None:
    """A naive reader would copy the inner value at each level when the second member follows."""
    depth = 8_000
    refusal('{"a":' * depth + "{}" + ',"b":1}' * depth)
    fields = '{"a":' * 60 + f'"{"x" * 10_000_000}"' + ',"b":1}' * 60
    assert "unknown" in refusal(f'{{"message":"GetAnglesRequest","fields":{fields}}}')


@pytest.mark.parametrize(
    "text, key, column",
    [
        ('{"message":"Control","message":"MotorsOn","fields":{}}', "message", 22),
        ('{"message":"MotorsOff","fields":{"mode":1, "mode":1}}', "mode", 44),
    ],
)
def test_a_key_that_is_there_twice(text: str, key: str, column: int) -> None:
    assert f"the key '{key}' occurs twice, at column {column}" in refusal(text)


def test_long_lines(tmp_path: Path) -> None:
    limit = 16 * 1024 * 1024
    start = GET_ANGLES.rstrip()
    fits = start + " " * (limit - len(start))
    assert run("encode", stdin=fits + "\r\n" + fits).out == frame(73) * 2
    for text in (fits + " ", " " * (limit + 1) + start):
        assert f"longer than {limit} bytes" in refusal(text)
    # The line is not stored, and the next line can be read.
    huge = tmp_path / "huge"
    with huge.open("wb") as file:
        file.write(b"[" * 1000)
        file.truncate(100_000_000)  # a sparse file
        file.seek(0, os.SEEK_END)
        file.write(b"\n" + GET_ANGLES.encode())
    with subprocess.Popen(
        [PROGRAM, "encode", str(huge)], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        assert process.stdout and process.stderr
        assert process.stdout.read() == frame(73)
        assert b"line 1: this is binary data" in process.stderr.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    assert process.returncode == 1
    assert usage.ru_maxrss < 400_000  # kB, including the memory of a sanitizer


def test_messages_that_quote_the_input_are_harmless() -> None:
    error = refusal(f'{{"message":"\\u001b[2J{"x" * 1_000_000}","fields":{{}}}}')
    assert "\x1b" not in error and len(error) < 2000


def test_bytes_that_are_not_utf8() -> None:
    result = run("encode", stdin=b'{"message":"\xff","fields":{}}\n')
    assert result.status == 1 and result.error.startswith("sbgc: line 1: ")


def test_bad_lines_do_not_stop_the_good_ones() -> None:
    lines = GET_ANGLES + "{\n\n" + '{"message":"Control","fields":{"x":1e999}}\n' + GET_ANGLES
    result = run("encode", "--hex", stdin=lines)
    assert result.status == 1
    assert result.out == b"3e49004900\n" * 2
    assert [line.split(":")[1] for line in result.error.splitlines()] == [" line 2", " line 4"]


def test_last_line_may_lack_its_end_and_lines_may_end_as_on_windows() -> None:
    text = GET_ANGLES.replace("\n", "\r\n") + GET_ANGLES.rstrip()
    assert run("encode", stdin=text).out == frame(73) * 2


def test_floats_that_json_has_no_number_for() -> None:
    stream = frame(85, bytes([88, 0, 0, 0x40]) + bytes(17))
    values = bytes.fromhex("0000807f 000080ff 0100807f ffffffff 00000080 01000000")
    live = frame(88, b"\0\0" + values)
    printed = run("decode", "--format", "jsonl", stdin=stream + live).out
    for line in printed.splitlines():
        json.loads(line, parse_constant=lambda name: pytest.fail(f"{name} is not JSON"))
    assert run("encode", "--no-validate", stdin=printed).out == stream + live


def test_texts_that_are_not_utf8() -> None:
    names = b"\xff\xfe ok \xc3".ljust(48, b"\0") + "\uf7ff".encode().ljust(48, b"\0") + bytes(144)
    data = frame(28, names)
    printed = run("decode", "--format", "jsonl", "--from", "board", stdin=data).out
    printed.decode()
    assert run("encode", "--no-validate", stdin=printed).out == data


def test_empty_input() -> None:
    assert run("encode").out == b""
    assert decode(run("encode", stdin="\n \n\t\n").out) == []


def test_names_instead_of_numbers() -> None:
    line = json.loads(changed(CONTROL, "control_mode", "MODE_ANGLE|CONTROL_FLAG_AUTO_TASK"))
    by_name = run("encode", stdin=json.dumps(line))
    assert by_name.status == 0, by_name
    assert by_name.out == run("encode", stdin=changed(CONTROL, "control_mode", 0x42)).out
    line["fields"]["control_mode"] = ["MODE_ANGLE", "CONTROL_FLAG_AUTO_TASK"]
    assert run("encode", stdin=json.dumps(line)).out == by_name.out
    of_an_axis = [
        json.dumps({"message": "WriteParams3", "fields": {"output": {"yaw": output}}})
        for output in ("I2C_DRV1", 4)
    ]
    by_name, by_number = (
        run("encode", "--defaults", "--no-validate", stdin=line) for line in of_an_axis
    )
    assert by_name.status == 0 and by_name.out == by_number.out
    beep = json.loads(changed(BEEP, "mode", "BEEPER_MODE_CUSTOM_MELODY"))
    assert run("encode", stdin=json.dumps(beep)).out == run("encode", stdin=json.dumps(BEEP)).out
    assert "did you mean 'MODE_ANGLE'" in refusal(changed(CONTROL, "control_mode", "MODE_ANGEL"))
    error = refusal(changed(CONTROL, "axes.pitch.angle", "-30deg"))
    assert "axes.pitch.angle" in error, "quantities are raw integers"


def test_names_of_the_document() -> None:
    assert run("encode", stdin='{"message":"CMD_MOTORS_ON","fields":{}}').out[:2] == b">M"
    assert run("encode", stdin='{"message":"get_angles","fields":{}}').out == frame(73)
    answer = {"message": "CMD_GET_ANGLES", "direction": "from_board", "fields": {}}
    assert "axes" in refusal(json.dumps(answer)), "the message of the board has fields"
    ext = {"message": "CMD_MOTORS_OFF", "fields": {"mode": "BRAKE"}}
    assert run("encode", stdin=json.dumps(ext)).out == frame(109, b"\x01")
    assert "'CMD_MOTORS_ON'" in refusal('{"message":"CMD_MOTOR_ON","fields":{}}')


def test_defaults() -> None:
    short = {"message": "Control", "fields": {"axes": {"pitch": {"angle": -1365}}}}
    assert "missing" in refusal(json.dumps(short))
    whole = changed(CONTROL, "axes.pitch.angle", -1365)
    expected = run("encode", stdin=changed(json.loads(whole), "control_mode", 0)).out
    assert run("encode", "--defaults", stdin=json.dumps(short)).out == expected
    assert run("encode", "--defaults", stdin='{"message":"get_angles"}').out == frame(73)
    counted = {"message": "SetAdjVarsVal", "fields": {"params": [{"param_id": 3}]}}
    assert run("encode", "--defaults", stdin=json.dumps(counted)).out == (
        frame(31, b"\x01\x03" + bytes(4))
    ), "the number of elements follows from them"
    unknown = {"message": "Control", "fields": {"axis": 1}}
    assert run("encode", "--defaults", stdin=json.dumps(unknown)).status == 1


def test_defaults_of_all_fields_that_flags_announce() -> None:
    """The flags of the state of an external motor announce 20 fields, of 2 or 4 bytes or of one."""
    (flags,) = [enum for enum in MODEL["enums"] if enum["name"] == "ExtMotorsStateFields"]
    every = sum(value["value"] for value in flags["values"])
    line = {"message": "ExtMotorsState", "fields": {"motor_id": 1, "data_set": every}}
    result = run("encode", "--defaults", stdin=json.dumps(line))
    assert result.status == 0, result
    assert result.out == frame(131, b"\x01" + every.to_bytes(4, "little") + bytes(45))
