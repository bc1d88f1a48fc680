"""Tests of sbgc encode: encoding JSON lines and rejecting invalid ones."""

from __future__ import annotations

import json
import os
import random
import subprocess
from pathlib import Path

import pytest

from sbgc_command import MODEL, PROGRAM, frame, run, valid_frames

GET_ANGLES = '{"message":"GetAnglesRequest","fields":{}}\n'


def refusal(text: str, *options: str) -> str:
    """Returns the error message for input that is rejected as a whole."""
    result = run("encode", *options, stdin=text)
    assert result.status == 1
    assert result.out == b""
    assert result.error.startswith("sbgc: line 1: ")
    return result.error


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


def test_defaults_of_all_fields_that_flags_announce() -> None:
    """The flags of the state of an external motor announce 20 fields, of 2 or 4 bytes or of one."""
    (flags,) = [enum for enum in MODEL["enums"] if enum["name"] == "ExtMotorsStateFields"]
    every = sum(value["value"] for value in flags["values"])
    line = {"message": "ExtMotorsState", "fields": {"motor_id": 1, "data_set": every}}
    result = run("encode", "--defaults", stdin=json.dumps(line))
    assert result.status == 0, result
    assert result.out == frame(131, b"\x01" + every.to_bytes(4, "little") + bytes(45))


def test_a_name_of_an_axis() -> None:
    by_name, by_number = (
        run("encode", "--defaults", "--no-validate", stdin=json.dumps(line))
        for line in (
            {"message": "WriteParams3", "fields": {"output": {"yaw": output}}}
            for output in ("I2C_DRV1", 4)
        )
    )
    assert by_name.status == 0 and by_name.out == by_number.out
