"""Tests of captures in sbgc decode and sbgc record. The files are built here from the description
of the format, not by the library."""

from __future__ import annotations

import fcntl
import json
import os
import pty
import resource
import signal
import socket
import struct
import subprocess
import sys
import termios
import threading
import tty
import zlib
from pathlib import Path
from typing import Any

import pytest

from sbgc_command import PROGRAM, decode, frame, run

FROM_BOARD, TO_BOARD, NOTE = 1, 2, 3
ANGLES_REQUEST = frame(73)
ANGLES = frame(73, struct.pack("<9h", *range(9)))


def session(start: float = 0.0) -> bytes:
    head = b"\x89SBGC\r\n\x1a" + struct.pack("<HHQ", 1, 0, int(start * 1e6))
    return head + struct.pack("<I", zlib.crc32(head))


def record(kind: int, seconds: float, data: bytes) -> bytes:
    head = struct.pack("<BBHQ", 0xA5, kind, len(data), round(seconds * 1e6)) + data
    return head + struct.pack("<I", zlib.crc32(head))


def records(capture: bytes) -> list[tuple[int, bytes]]:
    """Returns kind and bytes of the records of a capture with one session."""
    assert capture[:8] == session()[:8]
    assert zlib.crc32(capture[:20]) == struct.unpack_from("<I", capture, 20)[0]
    result = []
    at = 24
    while at < len(capture):
        mark, kind, size, _ = struct.unpack_from("<BBHQ", capture, at)
        end = at + 12 + size
        assert mark == 0xA5
        assert zlib.crc32(capture[at:end]) == struct.unpack_from("<I", capture, end)[0]
        result.append((kind, capture[at + 12 : end]))
        at = end + 4
    return result


CAPTURE = (
    session(1_700_000_000)
    + record(NOTE, 0, b"serial port /dev/ttyUSB0, 115200 8N1")
    + record(TO_BOARD, 0.25, ANGLES_REQUEST)
    + record(FROM_BOARD, 0.5, b"??" + ANGLES[:10])
    + record(TO_BOARD, 0.625, ANGLES_REQUEST)
    + record(FROM_BOARD, 1.75, ANGLES[10:] + ANGLES)
)


def keys(lines: list[Any], *names: str) -> list[Any]:
    return [tuple(line[name] for name in names) for line in lines]


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


def test_raw_captures_have_no_time() -> None:
    assert "time" not in decode(ANGLES)[0]


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


@pytest.mark.parametrize("size", range(8, len(CAPTURE), 3))
def test_a_torn_capture_is_reported_and_read_up_to_there(size: int) -> None:
    result = run("decode", "--format", "jsonl", stdin=CAPTURE[:size])
    whole = decode(CAPTURE)
    assert result.objects == [line for line in whole if size >= end_of_record(line["time"])]
    end = max([end for end in record_ends() if end <= size], default=0)
    if end == size:
        assert result.status == 0
    else:
        assert result.status == 1
        rest = size - end
        assert (
            f"The last {rest} byte{'' if rest == 1 else 's'} from offset {end} on" in result.error
        )


def record_ends() -> list[int]:
    """Returns the offsets at which the header and the records of CAPTURE end."""
    result = [24]
    while result[-1] < len(CAPTURE):
        size: int = struct.unpack_from("<H", CAPTURE, result[-1] + 2)[0]
        result.append(result[-1] + 16 + size)
    return result


def end_of_record(time: float) -> int:
    """Returns the offset at which the record with this time ends in CAPTURE."""
    starts = record_ends()
    (at,) = [s for s in starts[:-1] if struct.unpack_from("<Q", CAPTURE, s + 4)[0] == time * 1e6]
    return starts[starts.index(at) + 1]


def test_damage_costs_one_record() -> None:
    damaged = bytearray(CAPTURE)
    damaged[record_ends()[1] + 2] ^= 1  # the size of the first request
    result = run("decode", "--format", "jsonl", stdin=bytes(damaged) + CAPTURE)
    assert result.status == 1
    assert f"bytes from offset {record_ends()[1]} are damaged" in result.error
    both = decode(CAPTURE + CAPTURE)
    assert keys(result.objects, "session", "time") == keys(both, "session", "time")[1:]


def test_a_damaged_header_costs_no_other_session() -> None:
    damaged = bytearray(CAPTURE)
    damaged[12] ^= 1
    result = run("decode", "--format", "jsonl", stdin=CAPTURE + bytes(damaged) + CAPTURE)
    assert result.status == 1
    assert f"{len(CAPTURE)} bytes from offset {len(CAPTURE)} are damaged" in result.error
    assert keys(result.objects, "session", "time") == keys(
        decode(CAPTURE + CAPTURE), "session", "time"
    )


def test_times_out_of_all_bounds() -> None:
    late = bytearray(session())
    late[12:20] = b"\xff" * 8
    late[20:24] = struct.pack("<I", zlib.crc32(late[:20]))
    capture = bytes(late) + record(FROM_BOARD, 2**62 / 1e6, ANGLES)
    assert decode(capture)[0]["time"] > 4e12
    assert run("decode", stdin=capture).status == 0


def test_notes_can_not_talk_to_the_terminal() -> None:
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


def test_record_replays_and_decodes(tmp_path: Path) -> None:
    (tmp_path / "in").write_bytes(CAPTURE)
    result = run("record", f"capture:{tmp_path / 'in'}?timing=fast", str(tmp_path / "out"))
    assert result.status == 0
    assert result.text.splitlines() == [
        f"capture {tmp_path / 'in'}",
        f"{2 + 2 * len(ANGLES)} bytes recorded in {tmp_path / 'out'}",
    ]
    kept = records((tmp_path / "out").read_bytes())
    assert [data for kind, data in kept if kind == FROM_BOARD] == [
        b"??" + ANGLES[:10],
        ANGLES[10:] + ANGLES,
    ]
    assert kept[0] == (NOTE, f"capture {tmp_path / 'in'}".encode())
    lines = decode((tmp_path / "out").read_bytes())
    assert keys(lines, "message") == [("GetAngles",), ("GetAngles",)]


def test_record_to_the_standard_output(tmp_path: Path) -> None:
    """Only the capture is written there, and it can be read while it grows."""
    (tmp_path / "in").write_bytes(CAPTURE)
    result = run("record", f"capture:{tmp_path / 'in'}?timing=fast", "-")
    assert result.status == 0
    assert [data for kind, data in records(result.out) if kind == FROM_BOARD] == [
        b"??" + ANGLES[:10],
        ANGLES[10:] + ANGLES,
    ]
    assert not (tmp_path / "-").exists()
    with socket.create_server(("127.0.0.1", 0)) as server:
        port = server.getsockname()[1]
        with subprocess.Popen(
            [PROGRAM, "record", f"tcp:127.0.0.1:{port}", "-"], stdout=subprocess.PIPE
        ) as recorder, subprocess.Popen(
            [PROGRAM, "decode", "--format", "jsonl"], stdin=recorder.stdout, stdout=subprocess.PIPE
        ) as decoder:
            assert recorder.stdout and decoder.stdout
            recorder.stdout.close()
            connection, _ = server.accept()
            connection.sendall(ANGLES)
            assert json.loads(decoder.stdout.readline())["message"] == "GetAngles"
            recorder.send_signal(signal.SIGINT)
            assert recorder.wait(60) == 0
            assert decoder.wait(60) == 0
            connection.close()


def send_until_closed(connection: socket.socket) -> None:
    try:
        while True:
            connection.sendall(bytes(65536))
    except OSError:
        pass


def waiting_bytes(pipe: int) -> int:
    buffer = bytearray(4)
    fcntl.ioctl(pipe, termios.FIONREAD, buffer)
    return int.from_bytes(buffer, sys.byteorder)


def test_a_reader_that_does_not_read_can_be_left() -> None:
    """The recorder waits for its reader, but can be interrupted."""
    with socket.create_server(("127.0.0.1", 0)) as server:
        port = server.getsockname()[1]
        with subprocess.Popen(
            [PROGRAM, "record", f"tcp:127.0.0.1:{port}", "-"],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        ) as process:
            assert process.stdout and process.stderr
            connection, _ = server.accept()
            sender = threading.Thread(target=send_until_closed, args=(connection,))
            sender.start()
            while waiting_bytes(process.stdout.fileno()) < 32768:
                assert process.poll() is None
            while process.poll() is None:  # it may not have been waiting yet
                process.send_signal(signal.SIGINT)
            # The last signal may have arrived during the exit.
            assert process.returncode in (0, 1, -signal.SIGINT)
            error = process.stderr.read()
            assert b"Interrupted" in error or process.returncode != 1
            sender.join()
            connection.close()


def test_record_from_a_serial_port_until_it_is_unplugged(tmp_path: Path) -> None:
    master, slave = pty.openpty()
    tty.setraw(slave)
    capture = tmp_path / "capture"
    with subprocess.Popen(
        [PROGRAM, "record", f"{os.ttyname(slave)}?baud=57600", str(capture)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    ) as process:
        assert process.stdout and process.stderr
        assert b"57600 8N1" in process.stdout.readline()
        os.close(slave)
        os.write(master, ANGLES)
        while sum(len(d) for k, d in records_so_far(capture) if k == FROM_BOARD) < len(ANGLES):
            assert process.poll() is None
        os.close(master)
        assert process.wait(60) == 1
        assert b"unplugged" in process.stderr.read()
    assert keys(decode(capture.read_bytes()), "message") == [("GetAngles",)]


def records_so_far(path: Path) -> list[tuple[int, bytes]]:
    """Returns the records of a capture that is being written."""
    try:
        return records(path.read_bytes()) if path.exists() and path.stat().st_size >= 24 else []
    except struct.error:
        return []


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGTERM])
def test_record_stops_when_asked(how: signal.Signals, tmp_path: Path) -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        port = server.getsockname()[1]
        with subprocess.Popen(
            [PROGRAM, "record", f"tcp:127.0.0.1:{port}", str(tmp_path / "c")],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        ) as process:
            connection, _ = server.accept()
            assert process.stdout and process.stderr
            process.stdout.readline()
            connection.sendall(ANGLES)
            while FROM_BOARD not in [kind for kind, _ in records_so_far(tmp_path / "c")]:
                assert process.poll() is None
            process.send_signal(how)
            assert process.wait(60) == 0
            assert process.stderr.read() == b""
            connection.close()
    assert keys(decode((tmp_path / "c").read_bytes()), "message") == [("GetAngles",)]


def test_record_stops_in_time(tmp_path: Path) -> None:
    result = run("record", "pty:", str(tmp_path / "c"), "--seconds", "0.01")
    assert result.status == 0
    assert "0 bytes recorded" in result.text


@pytest.mark.parametrize(
    "address, words",
    [
        ("tcp:host", "the port is missing"),
        ("ttyUSB0", "/dev/ttyUSB0"),
        ("/dev/ttyNONE", "There is no port /dev/ttyNONE"),
        ("/dev/null", "not a serial port"),
        ("capture:/nowhere", "There is no file /nowhere"),
    ],
)
def test_record_says_what_is_wrong(address: str, words: str, tmp_path: Path) -> None:
    result = run("record", address, str(tmp_path / "c"))
    assert result.status == 1 and words in result.error
    assert not (tmp_path / "c").exists()


def test_record_says_what_is_wrong_with_the_file(tmp_path: Path) -> None:
    assert "/nowhere/c" in run("record", "pty:", "/nowhere/c").error
    other = tmp_path / "other"
    other.write_text("my thesis")
    assert "not a capture" in run("record", "pty:", str(other)).error
    assert other.read_text() == "my thesis"


def leave_little_room() -> None:
    """Leaves space for the header of a session, but not for the first record."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (30, 30))


def test_record_says_that_there_is_no_room(tmp_path: Path) -> None:
    (tmp_path / "in").write_bytes(CAPTURE)
    done = subprocess.run(
        [PROGRAM, "record", f"capture:{tmp_path / 'in'}", str(tmp_path / "c")],
        capture_output=True,
        preexec_fn=leave_little_room,
        restore_signals=False,
        timeout=60,
        check=False,
    )
    assert done.returncode == 1
    assert b"c cannot be written: File too large" in done.stderr
