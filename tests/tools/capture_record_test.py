"""Tests of captures that sbgc record writes."""

from __future__ import annotations

import json
import os
import pty
import signal
import socket
import struct
import subprocess
import tty
from pathlib import Path


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


def test_record_stops_in_time(tmp_path: Path) -> None:
    result = run("record", "pty:", str(tmp_path / "c"), "--seconds", "0.01")
    assert result.status == 0
    assert "0 bytes recorded" in result.text
