"""Tests of captures that sbgc record writes."""

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
from pathlib import Path

import pytest

from captures import ANGLES, CAPTURE, FROM_BOARD, NOTE, keys, records
from sbgc_command import PROGRAM, decode, run


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
    "address, status, words",
    [
        ("tcp:host", 2, "the port is missing"),
        ("ttyUSB0", 2, "/dev/ttyUSB0"),
        ("/dev/ttyNONE", 1, "There is no port /dev/ttyNONE"),
        ("/dev/null", 1, "not a serial port"),
        ("capture:/nowhere", 1, "There is no file /nowhere"),
    ],
)
def test_record_says_what_is_wrong(address: str, status: int, words: str, tmp_path: Path) -> None:
    result = run("record", address, str(tmp_path / "c"))
    assert result.status == status and words in result.error
    assert not (tmp_path / "c").exists()


def test_record_says_what_is_wrong_with_the_file(tmp_path: Path) -> None:
    assert "/nowhere/c" in run("record", "pty:", "/nowhere/c").error
    other = tmp_path / "other"
    other.write_text("my thesis")
    assert "not a capture" in run("record", "pty:", str(other)).error
    assert other.read_text() == "my thesis"


def leave_little_room() -> None:
    """Leaves space for the header of a session, but not for the first record."""
    resource.setrlimit(resource.RLIMIT_FSIZE, (30, 30))


def test_record_says_that_there_is_no_room(tmp_path: Path) -> None:
    (tmp_path / "in").write_bytes(CAPTURE)
    done = subprocess.run(
        [PROGRAM, "record", f"capture:{tmp_path / 'in'}", str(tmp_path / "c")],
        capture_output=True,
        preexec_fn=leave_little_room,
        timeout=60,
        check=False,
    )
    assert done.returncode == 1
    assert b"c cannot be written: File too large" in done.stderr
