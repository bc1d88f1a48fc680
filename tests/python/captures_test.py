"""Captures as arrays, compared with what the messages and the command say."""

from __future__ import annotations

import json
import os
import re
import struct
import subprocess
import sys
import zlib
from datetime import datetime, timezone
from pathlib import Path
from typing import Any

import numpy
import pytest

import sbgc
from sbgc import DecodeError, Direction, Message, _core, msg, read_capture
from vectors_test import vectors

FROM_BOARD, TO_BOARD, NOTE = 1, 2, 3


def _summed(data: bytes) -> bytes:
    return data + struct.pack("<I", zlib.crc32(data))


def session(start: int = 0) -> bytes:
    return _summed(b"\x89SBGC\r\n\x1a" + struct.pack("<HHQ", 1, 0, start))


def record(kind: int, time: int, data: bytes) -> bytes:
    return _summed(struct.pack("<BBHQ", 0xA5, kind, len(data), time) + data)


def frame(id: int, body: bytes) -> bytes:
    head = bytes([id, len(body), (id + len(body)) % 256])
    return b">" + head + body + bytes([sum(body) % 256])


def write(path: Path, *parts: bytes) -> Path:
    path.write_bytes(b"".join(parts))
    return path


ANGLES = 73  # CMD_GET_ANGLES
# The body of CMD_GET_ANGLES has three numbers for each axis.
BODY = struct.pack("<9h", 4096, 0, 0, -1365, 0, 0, 0, 0, 0)


def command(capture: Path, *options: str) -> str:
    # The command has an address sanitizer of its own, if this interpreter has loaded one.
    own = {name: value for name, value in os.environ.items() if name != "LD_PRELOAD"}
    done = subprocess.run(
        [os.environ["SBGC"], "decode", *options, capture],
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
        env=own,
    )
    return done.stdout


def leaves(fields: Any, path: str = "") -> dict[str, Any]:
    """The values of a line of `sbgc decode`, by their paths."""
    if isinstance(fields, dict):
        inner = [(f"{path}.{name}" if path else name, one) for name, one in fields.items()]
    elif isinstance(fields, list):
        inner = [(f"{path}[{index}]", one) for index, one in enumerate(fields)]
    else:
        return {path: fields}
    return {key: value for name, one in inner for key, value in leaves(one, name).items()}


def is_same(column: Any, expected: Any) -> bool:
    if isinstance(expected, float):
        return column == expected or bool(numpy.isnan(column) and numpy.isnan(expected))
    return bool(column == expected)


@pytest.fixture(scope="module")
def everything(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A capture of all vectors, each with what was said before it, in records of odd sizes."""
    parts = [session()]
    for time, vector in enumerate(vectors()):
        if "hex" not in vector:
            continue
        for one in (*vector.get("after", []), vector):
            data = frame(one["id"], bytes.fromhex(one["hex"]))
            kind = FROM_BOARD if one["direction"] == "from_board" else TO_BOARD
            parts += [record(kind, time, data[i : i + 61]) for i in range(0, len(data), 61)]
    return write(tmp_path_factory.mktemp("capture") / "everything.sbgc", *parts)


def test_every_value_of_every_message_is_that_of_the_command(everything: Path) -> None:
    capture = read_capture(everything)
    rows = dict.fromkeys(capture, 0)
    undecoded = values = 0
    for line in command(everything, "--format", "jsonl", "--show-passwords").splitlines():
        one = json.loads(line)
        if "error" in one:
            undecoded += 1
            continue
        message: type[Message] = getattr(msg, one["message"])
        table, row = capture[message], rows[message]
        rows[message] += 1
        assert table["time"][row] == pytest.approx(one["time"], abs=1e-9)
        if row >= 12:  # what the rows of a kind have in common is known by then
            continue
        decoded = message.from_json(json.dumps(one["fields"]))._message
        for path, raw in leaves(one["fields"]).items():
            if path not in table or isinstance(raw, str):
                continue
            values += 1
            where = f"{one['message']}: {path} = {raw}"
            assert is_same(table[path][row], decoded.get(path)), where
    assert capture.undecoded == undecoded > 100
    assert {m: table.rows for m, table in capture.items()} == rows
    assert len(rows) > 200 and values > 10_000, values


def test_all_columns_at_once_are_those_asked_for_singly(everything: Path) -> None:
    singly = read_capture(everything)
    for message, table in read_capture(everything).items():
        columns = table.columns()
        assert list(columns) == list(table)
        for path, column in columns.items():
            expected = singly[message][path]
            assert column.dtype == expected.dtype
            assert column.tolist() == pytest.approx(expected.tolist(), rel=0, nan_ok=True), path


def test_columns_of_many_messages_are_those_of_their_bytes(tmp_path: Path) -> None:
    count = 150_001  # for several threads, whose last block is not full
    raw = numpy.arange(9 * count, dtype="<i8").astype("<i2").reshape(count, 9)
    frames = [frame(ANGLES, one.tobytes()) for one in raw]
    records = [record(FROM_BOARD, time, one) for time, one in enumerate(frames)]
    table = read_capture(write(tmp_path / "long.sbgc", session(), *records))[msg.GetAngles]
    columns = table.columns()
    assert numpy.array_equal(columns["time"], numpy.arange(count) / 1e6)
    for axis, name in enumerate(("roll", "pitch", "yaw")):
        angle = columns[f"axes.{name}.imu_angle"]
        assert numpy.array_equal(angle, raw[:, 3 * axis] * 360.0 / 16384), name


def test_arrays_have_the_bytes_of_the_bodies(everything: Path) -> None:
    bodies: dict[str, list[bytes]] = {}
    for line in command(everything, "--format", "jsonl", "--show-passwords").splitlines():
        one = json.loads(line)
        if "error" not in one:
            message: type[Message] = getattr(msg, one["message"])
            body = sbgc.encode_body(message.from_json(json.dumps(one["fields"])))
            bodies.setdefault(one["message"], []).append(body)
    fixed = 0
    for message, table in read_capture(everything).items():
        if _core.layout_of(message.__name__) is None:
            with pytest.raises(TypeError, match="no fixed layout"):
                table.array
            continue
        fixed += 1
        array = table.array
        assert array.dtype.names[:2] == ("time", "body_size")
        for row, body in zip(array, bodies[message.__name__], strict=True):
            assert row["body_size"] == len(body), message
            assert row.tobytes()[9:].rstrip(b"\0") == body.rstrip(b"\0"), message
    assert fixed > 100


def test_columns_are_in_units_and_times_in_seconds(tmp_path: Path) -> None:
    data = frame(ANGLES, BODY)
    path = write(
        tmp_path / "capture.sbgc",
        session(1_700_000_000_000_000),
        record(FROM_BOARD, 1_000_000, data[:7]),
        record(NOTE, 1_200_000, b"hello"),
        record(FROM_BOARD, 1_500_000, data[7:]),
        session(1_700_000_060_000_000),
        record(FROM_BOARD, 250_000, data),
    )
    capture = read_capture(path)
    table = capture[msg.GetAngles]
    assert table["time"].tolist() == [1.5, 60.25]
    assert table["axes.roll.imu_angle"].tolist() == [90, 90]
    assert table["axes.pitch.imu_angle"].tolist() == [-1365 * 360 / 16384] * 2
    assert table.array["axes.pitch.imu_angle"].tolist() == [-1365] * 2
    assert capture.notes == [(1.2, "hello")]
    assert capture.sessions[0] == datetime(2023, 11, 14, 22, 13, 20, tzinfo=timezone.utc)
    assert repr(capture) == "<Capture GetAngles: 2>"
    with pytest.raises(KeyError, match="the capture has no Control"):
        capture[msg.Control]
    with pytest.raises(KeyError, match="no column axes.roll; it has axes.roll.imu_angle, axes"):
        table["axes.roll"]


def test_damage_is_skipped_and_counted_as_by_the_command(tmp_path: Path) -> None:
    good = frame(ANGLES, BODY)
    wrong = bytearray(good)
    wrong[9] ^= 1
    torn = record(FROM_BOARD, 9, good)
    damaged = bytearray(record(FROM_BOARD, 5, good))
    damaged[20] ^= 1
    path = write(
        tmp_path / "capture.sbgc",
        session(),
        record(FROM_BOARD, 1, b"noise" + good + bytes(wrong) + good),
        record(TO_BOARD, 2, b">\x01\x02\x09" + frame(ANGLES, b"")),
        record(FROM_BOARD, 3, frame(3, b"unknown") + frame(ANGLES, BODY[:-1])),
        bytes(damaged),
        record(FROM_BOARD, 6, good[:10]),
        torn[:-3],
    )
    capture = read_capture(path)
    assert capture[msg.GetAngles].rows == 2
    assert capture[msg.GetAnglesRequest].rows == 1
    assert capture.undecoded == 2
    lengths = f"{len(damaged)} bytes from offset", f"The last {len(torn) - 3} bytes"
    assert [text.startswith(length) for text, length in zip(capture.damage, lengths)] == [True] * 2
    printed = command(path)
    for direction, counters in capture.counters.items():
        side = "from" if direction == Direction.FROM_BOARD else "to"
        summary = rf"{side} the board: {counters.frames} frames?, {counters.skipped_bytes} bytes "
        errors = rf"\(bad headers: {counters.header_errors}, bad bodies: {counters.body_errors}\)"
        assert re.search(f"{summary}skipped {errors}", printed), printed
    assert capture.counters[Direction.FROM_BOARD].body_errors == 1


def test_later_firmware_appends_to_bodies(tmp_path: Path) -> None:
    plain, longer = bytes(124), bytes(124) + b"new"
    frames = [frame(25, body) for body in (plain, longer, plain)]
    records = [record(FROM_BOARD, time, data) for time, data in enumerate(frames)]
    table = read_capture(write(tmp_path / "capture.sbgc", session(), *records))[msg.RealtimeData4]
    assert table.array["body_size"].tolist() == [124, 127, 124]
    assert [bytes(tail) for tail in table.array["tail"]] == [bytes(3), b"new", bytes(3)]


def test_the_request_decides_between_answers_of_one_size(tmp_path: Path) -> None:
    answer = (FROM_BOARD, frame(46, bytes.fromhex("00201200c00000c03f6400000010c0")))
    requests = [(TO_BOARD, frame(46, bytes(size))) for size in (7, 2)]
    sent = [answer, requests[0], answer, answer, requests[1], answer]
    records = [record(kind, time, data) for time, (kind, data) in enumerate(sent)]
    capture = read_capture(write(tmp_path / "capture.sbgc", session(), *records))
    assert capture[msg.AdjVarsState].array["analog_value"].tolist() == [1069547520] * 2
    assert capture[msg.AdjVarsStateExt].array["analog_var_value"].tolist() == [1.5] * 2


def test_a_live_recording_is_read(tmp_path: Path) -> None:
    path = tmp_path / "live.sbgc"
    with sbgc.emulator() as board, sbgc.connect(board, capture=path) as gimbal:
        with gimbal.stream(msg.RealtimeData4, 0.01) as samples:
            seen = [next(samples) for _ in range(5)]
        versions = gimbal.identity.info
    capture = read_capture(path)
    table = capture[msg.RealtimeData4]
    for column in ("angle.pitch", "axes.yaw.acc_data"):
        first = [sample._message.get(column) for sample in seen]
        assert table[column][:5].tolist() == first
    assert (numpy.diff(table["time"]) >= 0).all()
    assert capture[msg.BoardInfo]["board_ver"][0] == versions.board_ver


@pytest.mark.parametrize("content", [b"", b"\x89SBGC"], ids=["nothing", "a torn header"])
def test_a_file_with_nothing_is_an_empty_capture(tmp_path: Path, content: bytes) -> None:
    capture = read_capture(write(tmp_path / "capture.sbgc", content))
    assert not capture and len(capture.damage) == bool(content)


def test_what_is_no_capture_is_an_error(tmp_path: Path) -> None:
    path = write(tmp_path / "other.txt", b"time,angle\n")
    with pytest.raises(DecodeError, match="other.txt: This is not a capture.") as caught:
        read_capture(path)
    assert caught.value.code == "not_a_capture"
    with pytest.raises(FileNotFoundError):
        read_capture(tmp_path / "missing")


def test_only_captures_need_numpy() -> None:
    program = """
import sys
sys.modules["numpy"] = None
import sbgc
assert sbgc.msg.Control()
try:
    sbgc.read_capture("capture.sbgc")
except ImportError as error:
    print(error)
"""
    command_line = [sys.executable, "-W", "error", "-c", program]
    done = subprocess.run(command_line, capture_output=True, text=True, timeout=60, check=False)
    assert done.stdout == (
        "read_capture() needs numpy: apt-get install python3-numpy, or pip install numpy\n"
    ), done.stderr
