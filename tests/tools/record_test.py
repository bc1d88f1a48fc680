"""Tests of sbgc record with a board, and of sbgc replay."""

from __future__ import annotations

import signal
import socket
import subprocess
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest

from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from sbgc_command import PROGRAM, decode, run


@pytest.fixture(scope="module", params=["tcp", "pty"])
def gimbal(request: pytest.FixtureRequest) -> Iterator[EmulatedGimbal]:
    options = ("--pty",) if request.param == "pty" else ()
    with emulated_gimbal(*options) as running:
        running.address = running.address_with_rate
        yield running


def messages(capture: bytes) -> Counter[str]:
    return Counter(line["message"] for line in decode(capture))


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
        process = subprocess.Popen(
            [PROGRAM, "record", "-p", gimbal.address, str(capture), "--stream", "RealtimeData4"],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        assert process.stderr is not None and process.stdout is not None
        process.stdout.readline()
        gimbal.kill()
        while "connecting again" not in process.stderr.readline():
            pass
        port = gimbal.address.rsplit(":", 1)[1]
        with emulated_gimbal("--tcp", port):
            while "connected again" not in process.stderr.readline():
                pass
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
    process = subprocess.Popen(
        [PROGRAM, "replay", str(capture), "--speed", "5", "--tcp", "0"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert process.stdout is not None
    address = process.stdout.readline().split(": ", 1)[1].strip()
    copy = run("record", address, "-")
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
    with subprocess.Popen(
        [PROGRAM, "replay", str(minute), "--speed", "0.005", "--tcp", "0"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        assert process.stdout is not None and process.stderr is not None
        try:
            address = process.stdout.readline().split(": ", 1)[1].strip()
            with host_at(address):
                assert "is host 0" in process.stderr.readline()
                process.send_signal(signal.SIGTERM)
                assert process.wait(timeout=20) == 0
        finally:
            process.kill()
