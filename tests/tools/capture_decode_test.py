"""Tests of captures in sbgc decode."""

from __future__ import annotations

import json
import struct
import subprocess
from pathlib import Path

import pytest

from captures import (
    ANGLES,
    ANGLES_REQUEST,
    CAPTURE,
    FROM_BOARD,
    NOTE,
    TO_BOARD,
    keys,
    record,
    session,
)
from sbgc_command import PROGRAM, decode, frame, run


def test_json_lines_have_direction_and_time() -> None:
    lines = decode(CAPTURE)
    assert keys(lines, "message", "direction", "time", "session", "offset") == [
        ("GetAnglesRequest", "to_board", 0.25, 0, 0),
        ("GetAnglesRequest", "to_board", 0.625, 0, 5),
        ("GetAngles", "from_board", 1.75, 0, 2),
        ("GetAngles", "from_board", 1.75, 0, 2 + len(ANGLES)),
    ]
    raw = decode(ANGLES)[0]
    for key in ("time", "session", "offset"):
        lines[2].pop(key), raw.pop(key, None)
    assert lines[2] == raw


@pytest.mark.parametrize("size", [0xA5A5 - 1, 0xA5A5, 2_000_000])
def test_damage_that_looks_like_records_takes_linear_time(size: int) -> None:
    """Each byte begins a record of 42 kB, as its mark and its size say; `run` waits for a minute."""
    after = session() + record(NOTE, 1, b"after it")
    result = run("decode", stdin=session() + b"\xa5" * size + after)
    assert f"sbgc: {size} bytes from offset 24 are damaged." in result.error
    assert 'note: "after it"' in result.text


def test_text_shows_direction_time_and_notes() -> None:
    result = run("decode", stdin=CAPTURE)
    assert result.status == 0
    headings = [line for line in result.text.splitlines() if not line.startswith("    ")]
    assert headings == [
        "session 0, started 2023-11-14 22:13:20 UTC",
        '0.000000 s  note: "serial port /dev/ttyUSB0, 115200 8N1"',
        "0.250000 s  CMD_GET_ANGLES (73)  host to board, 0 bytes  GetAnglesRequest",
        "0.625000 s  CMD_GET_ANGLES (73)  host to board, 0 bytes  GetAnglesRequest",
        "1.750000 s  no frame: 2 bytes from the board",
        "1.750000 s  CMD_GET_ANGLES (73)  board to host, 18 bytes  GetAngles",
        "1.750000 s  CMD_GET_ANGLES (73)  board to host, 18 bytes  GetAngles",
        "to the board: 2 frames, 0 bytes skipped (bad headers: 0, bad bodies: 0)",
        "from the board: 2 frames, 2 bytes skipped (bad headers: 0, bad bodies: 0)",
    ]


def test_rejected_candidates_of_a_capture_are_explained() -> None:
    bad = ANGLES[:-1] + bytes([ANGLES[-1] ^ 1])
    begin = session() + record(FROM_BOARD, 1, ANGLES + bad[:7]) + record(FROM_BOARD, 2, bad[7:])
    reason = (
        f"@{len(ANGLES)}: looks like CMD_GET_ANGLES (73) from the board with a body of 18 bytes, "
    )
    text = run("decode", stdin=begin + record(FROM_BOARD, 3, ANGLES))
    assert text.status == 0
    assert f"3.000000 s  no frame: {len(bad)} bytes from the board\n    {reason}" in text.text


def test_a_capture_without_a_frame() -> None:
    assert run("decode", stdin=session() + record(NOTE, 0, b"nothing came")).status == 0
    # Frames of the other direction count as frames, too.
    other = session() + record(TO_BOARD, 0, ANGLES_REQUEST)
    result = run("decode", "--from", "board", stdin=other)
    assert result.status == 0 and result.text.endswith("none of them is selected\n")
    noise = run("decode", "--format", "jsonl", stdin=session() + record(FROM_BOARD, 1, b"?" * 9))
    assert noise.status == 1 and noise.out == b""
    assert (
        "found no frame in 9 bytes; if they come from a serial line, its baud rate" in noise.error
    )
    cut = run("decode", "--format", "jsonl", stdin=session() + record(FROM_BOARD, 1, ANGLES[:-1]))
    assert cut.status == 1 and cut.out == b""
    assert "the checksum of its body, 0x24, is missing at the end" in cut.error


def test_a_frame_has_the_time_of_its_last_byte() -> None:
    # The frame is found only when a longer candidate that starts before it turns out to be false.
    false_start = b">" + bytes([86, 50, 136])
    capture = (
        session()
        + record(FROM_BOARD, 1, false_start)
        + record(FROM_BOARD, 2, ANGLES[:5])
        + record(FROM_BOARD, 3, ANGLES[5:])
        + record(FROM_BOARD, 4, bytes(60))
    )
    assert keys(decode(capture), "message", "time") == [("GetAngles", 3)]
    # The same at the end of the capture.
    assert keys(decode(capture[: -60 - 16]), "message", "time") == [("GetAngles", 3)]


def test_a_request_tells_what_its_answer_holds() -> None:
    request = frame(88, struct.pack("<I", 0x10) + bytes(6))
    answer = frame(88, struct.pack("<H3h", 7, 1, 2, 3))
    lines = decode(session() + record(TO_BOARD, 0, request) + record(FROM_BOARD, 1, answer))
    assert lines[1]["fields"] == {"timestamp_ms": 7, "gyro_data": {"roll": 1, "pitch": 2, "yaw": 3}}
    # Also if the request itself is not shown.
    whole = session() + record(TO_BOARD, 0, request) + record(FROM_BOARD, 1, answer)
    for options in (["--from", "board"], ["--from", "0.5"]):
        assert decode(whole, *options) == [lines[1]]
    # Requests of another session provide no context.
    lines = decode(
        session() + record(TO_BOARD, 0, request) + session() + record(FROM_BOARD, 1, answer)
    )
    assert "gyro_data" not in lines[1]["fields"]


@pytest.mark.parametrize("sender, message", [("board", "GetAngles"), ("host", "GetAnglesRequest")])
def test_one_direction_only(sender: str, message: str) -> None:
    assert {line["message"] for line in decode(CAPTURE, "--from", sender)} == {message}
    text = run("decode", "--from", sender, stdin=CAPTURE).text
    assert ("host to board" in text) == (sender == "host")
    assert ("board to host" in text) == (sender == "board")


def test_times_of_a_capture() -> None:
    def times(*options: str) -> list[float]:
        return [line["time"] for line in decode(CAPTURE, *options)]

    assert times("--from", "0.5") == [0.625, 1.75, 1.75]
    assert times("--from", "600ms", "--to", "1s") == [0.625]
    assert times("--to", "0.25") == [0.25]
    assert times("--from", "host", "--from", "0.5") == [0.625]
    text = run("decode", "--from", "0.5", "--to", "1", stdin=CAPTURE).text
    assert "note" not in text and "0.625000 s" in text


def test_csv_counts_from_the_first_session() -> None:
    later = session(1_700_000_010) + record(FROM_BOARD, 0.5, ANGLES)
    rows = run("decode", "--format", "csv", "-m", "GetAngles", stdin=CAPTURE + later).text
    assert [line.split(",")[0] for line in rows.splitlines()] == [
        *("time[s]", "1.750000", "1.750000", "10.500000")
    ]
    # Times are selected as they are shown there.
    assert [line["session"] for line in decode(CAPTURE + later, "--from", "2")] == [1]


def test_csv_with_other_fields_than_at_first() -> None:
    def exchange(at: float, flags: int, answer: bytes) -> bytes:
        request = frame(88, struct.pack("<I", flags) + bytes(6))
        return record(TO_BOARD, at, request) + record(FROM_BOARD, at, frame(88, answer))

    changing = exchange(1, 0x10, bytes(8)) + exchange(2, 0x11, bytes(14))
    options = ("--format", "csv", "-m", "RealtimeDataCustom")
    result = run("decode", *options, stdin=session() + changing)
    assert result.status == 1 and "has the columns of its first frame" in result.error
    later = run("decode", *options, "--from", "1.5", stdin=session() + changing)
    assert later.status == 0 and len(later.text.splitlines()[1].split(",")) == 8


def test_sessions_do_not_mix() -> None:
    half = session() + record(FROM_BOARD, 1, ANGLES[:9])
    rest = session() + record(FROM_BOARD, 2, ANGLES[9:]) + record(FROM_BOARD, 3, ANGLES)
    lines = decode(half + rest)
    assert keys(lines, "time", "session", "offset") == [(3, 1, len(ANGLES) - 9)]


def test_a_torn_and_damaged_capture_is_reported() -> None:
    """tests/io has each place of damage."""
    torn = run("decode", "--format", "jsonl", stdin=CAPTURE[:-1])
    assert torn.status == 1 and keys(torn.objects, "time") == [(0.25,), (0.625,)]
    last = 12 + 2 * len(ANGLES) - 10 + 4 - 1
    assert f"The last {last} bytes from offset {len(CAPTURE) - 1 - last} on" in torn.error
    damaged = bytearray(CAPTURE)
    damaged[12] ^= 1  # the header
    result = run("decode", "--format", "jsonl", stdin=CAPTURE + bytes(damaged) + CAPTURE)
    assert result.status == 1
    assert f"{len(CAPTURE)} bytes from offset {len(CAPTURE)} are damaged" in result.error
    both = decode(CAPTURE + CAPTURE)
    assert keys(result.objects, "session", "time") == keys(both, "session", "time")


def test_longest_times() -> None:
    late = record(FROM_BOARD, (2**62 - 2**10) / 1e6, ANGLES)
    # The two highest bits do not belong to the time.
    capture = session() + session((2**64 - 2**12) / 1e6) + late + late
    frames = decode(capture)
    assert [frame["time"] for frame in frames] == [pytest.approx(2**62 / 1e6)] * 2
    assert "started 148108-07-06 14:00:27 UTC" in run("decode", stdin=capture).text
    assert len(decode(capture, "--from", "1000000000")) == 2


def test_notes_cannot_talk_to_the_terminal() -> None:
    text = run("decode", stdin=session() + record(NOTE, 0, b"\x1b[2J\x07")).out
    assert b"\x1b" not in text and b"\x07" not in text


def test_a_capture_arrives_in_pieces(tmp_path: Path) -> None:
    with subprocess.Popen(
        [PROGRAM, "decode", "--format", "jsonl"], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as process:
        assert process.stdin and process.stdout
        for piece in (CAPTURE[:1], CAPTURE[1:7], CAPTURE[7:150]):
            process.stdin.write(piece)
            process.stdin.flush()
        # Complete frames are printed while the remaining bytes are still to come.
        assert json.loads(process.stdout.readline())["time"] == 0.25
        process.stdin.close()
        process.stdout.read()
        assert process.wait(60) == 1  # torn
