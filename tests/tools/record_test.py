"""Tests of sbgc record, with a board and with captures, and of sbgc replay."""

from __future__ import annotations

import json
import os
import pty
import signal
import socket
import struct
import subprocess
import tty
from collections.abc import Iterator
from pathlib import Path

import pytest

from captures import ANGLES, CAPTURE, FROM_BOARD, NOTE, keys, records
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from sbgc_command import PROGRAM, Running, decode, run


@pytest.fixture(scope="module", params=["tcp", "pty"])
def gimbal(request: pytest.FixtureRequest) -> Iterator[EmulatedGimbal]:
    options = ("--pty",) if request.param == "pty" else ()
    with emulated_gimbal(*options) as running:
        running.address = running.address_with_rate
        yield running


def rate_of(message: str, capture: Path) -> float:
    """In messages per second of the recorded times: a busy machine may record for longer."""
    lines = decode(capture.read_bytes())
    times = [line["time"] for line in lines if line["message"] == message]
    return (len(times) - 1) / (times[-1] - times[0])


def test_streams_are_asked_for(gimbal: EmulatedGimbal, tmp_path: Path) -> None:
    capture = tmp_path / "capture"
    result = run(
        "record", "-p", gimbal.address, str(capture), "--for", "1s",
        "--stream", "RealtimeData4", "--rate", "20",
        "--stream", "RealtimeDataCustom:IMU_ANGLES|RC_DATA", "--rate", "10",
    )  # fmt: skip
    assert result.status == 0, result
    assert "recorded in" in result.text
    assert 15 <= rate_of("RealtimeData4", capture) <= 25
    assert 7 <= rate_of("RealtimeDataCustom", capture) <= 13


def test_an_existing_capture_gets_another_session(gimbal: EmulatedGimbal, tmp_path: Path) -> None:
    capture = tmp_path / "capture"
    for _ in range(2):
        arguments = ("record", gimbal.address, str(capture), "--stream", "realtime_data_4")
        assert run(*arguments, "--for", "200ms").status == 0
    assert {line["session"] for line in decode(capture.read_bytes())} == {0, 1}


def test_the_gimbal_is_killed_and_started_again(tmp_path: Path) -> None:
    capture = tmp_path / "capture"
    with emulated_gimbal() as gimbal:
        process = Running("record", gimbal.address, str(capture), "--stream", "RealtimeData4")
        process.line()
        gimbal.kill()
        process.wait_for("connecting again")
        port = gimbal.address.rsplit(":", 1)[1]
        with emulated_gimbal("--tcp", port):
            process.wait_for("connected again")
            size = capture.stat().st_size
            while capture.stat().st_size < size + 1000:
                assert process.poll() is None
            process.send_signal(signal.SIGINT)
            process.communicate(timeout=20)
            assert process.returncode == 0
    streamed = [line for line in decode(capture.read_bytes()) if line["message"] == "RealtimeData4"]
    assert streamed[-1]["session"] >= 1


def test_replay_serves_a_capture(gimbal: EmulatedGimbal, tmp_path: Path) -> None:
    capture = tmp_path / "capture"
    arguments = ("record", gimbal.address, str(capture), "--stream", "RealtimeData4")
    assert run(*arguments, "--for", "500ms").status == 0
    process = Running("replay", str(capture), "--speed", "5", "--tcp", "0")
    copy = run("record", process.address(), "-")
    assert copy.status == 0, copy
    process.communicate(timeout=20)
    assert process.returncode == 0
    from_board = [
        line for line in decode(capture.read_bytes()) if line["direction"] == "from_board"
    ]
    replayed = decode(copy.out)
    assert [line["fields"] for line in replayed] == [line["fields"] for line in from_board]
    whole = from_board[-1]["time"] - from_board[0]["time"]
    assert replayed[-1]["time"] - replayed[0]["time"] < whole


@pytest.fixture(name="minute")
def fixture_minute(tmp_path: Path) -> Path:
    """A capture whose replay takes a minute."""
    capture = tmp_path / "minute"
    with emulated_gimbal() as one:
        arguments = ("record", one.address, str(capture), "--stream", "RealtimeData4")
        assert run(*arguments, "--for", "300ms").status == 0
    return capture


def host_at(address: str) -> socket.socket:
    host, port = address.removeprefix("tcp:").rsplit(":", 1)
    return socket.create_connection((host, int(port)), timeout=20)


def test_replay_stops_at_a_signal(minute: Path) -> None:
    with Running("replay", str(minute), "--speed", "0.005", "--tcp", "0") as process:
        try:
            with host_at(process.address()):
                process.wait_for("is host 0")
                process.send_signal(signal.SIGTERM)
                assert process.wait(timeout=20) == 0
        finally:
            process.kill()


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


def test_a_damaged_capture_is_no_whole_one(tmp_path: Path) -> None:
    damaged, copy = tmp_path / "in", tmp_path / "out"
    damaged.write_bytes(CAPTURE[:-1])
    reason = f"sbgc: {damaged} has damaged parts, which are left out: the last "
    result = run("record", f"capture:{damaged}?timing=fast", str(copy))
    assert result.status == 1 and reason.lower() in result.error.lower() and copy.exists(), result
    with Running("replay", str(damaged), "--tcp", "0") as process:
        assert run("record", process.address(), "-").status == 0
        process.wait_for("are left out: The last")
        assert process.wait(timeout=20) == 1


@pytest.mark.parametrize(
    "content, reason",
    [
        (b"", "is empty"),
        (b"a text, no capture\n", "is not a capture, and contains no frame"),
        (CAPTURE[:24], "has no bytes of a board"),
    ],
)
def test_what_has_nothing_to_replay_is_refused(content: bytes, reason: str, tmp_path: Path) -> None:
    (tmp_path / "in").write_bytes(content)
    for command in (
        ("replay", str(tmp_path / "in"), "--tcp", "0"),
        ("record", f"capture:{tmp_path / 'in'}", str(tmp_path / "out")),
    ):
        result = run(*command)
        assert result.status == 1 and result.error == f"sbgc: {tmp_path / 'in'} {reason}\n"
    assert not (tmp_path / "out").exists()


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
    with Running("record", f"{os.ttyname(slave)}?baud=57600", str(capture)) as process:
        assert "57600 8N1" in process.line()
        os.close(slave)
        os.write(master, ANGLES)
        while sum(len(d) for k, d in records_so_far(capture) if k == FROM_BOARD) < len(ANGLES):
            assert process.poll() is None
        os.close(master)
        process.wait_for("unplugged")
        assert process.wait(60) == 1
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
