"""Tests of sbgc record with a board, and of sbgc replay."""

from __future__ import annotations

import os
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


def test_a_stream_without_a_name_is_asked_for_by_its_number(tmp_path: Path) -> None:
    """200 is not known here; the board refuses it, but gets its configuration."""
    capture = tmp_path / "capture"
    with emulated_gimbal() as gimbal:
        options = ("-p", gimbal.address, "--for", "1s", "--rate", "20")
        result = run("record", *options, str(capture), "--stream", "23")
        assert result.status == 0, result
        assert 15 <= rate_of("RealtimeData3", capture) <= 25
        refused = run("record", *options, str(capture), "--stream", "200:0e45")
        assert refused.status == 1 and "refused" in refused.error
    (request,) = (
        line for line in decode(capture.read_bytes()) if line["fields"].get("cmd_id") == 200
    )
    assert request["fields"]["config"]["rest"].startswith("0e45")


def test_an_existing_capture_gets_another_session(gimbal: EmulatedGimbal, tmp_path: Path) -> None:
    capture = tmp_path / "capture"
    for _ in range(2):
        arguments = (
            "record",
            gimbal.address,
            str(capture),
            "--stream",
            "realtime_data_4",
        )
        assert run(*arguments, "--for", "200ms").status == 0
    assert {line["session"] for line in decode(capture.read_bytes())} == {0, 1}


@pytest.mark.parametrize(
    "name, stream, advice",
    [
        ("flight.csv", "AhrsHelper", "for a table, use `sbgc stream AhrsHelper --format csv`"),
        ("FLIGHT.CSV", "AhrsHelper", "for a table, use `sbgc stream AhrsHelper --format csv`"),
        ("a.csv", "23", "for a table, use `sbgc stream --id 23 --format csv`"),
        ("a.jsonl", "AhrsHelper", "for JSON, use `sbgc stream AhrsHelper --format jsonl`"),
        ("a.PCAPNG", "AhrsHelper", "for a file of Wireshark, add --pcapng"),
    ],
)
def test_a_capture_is_no_table(name: str, stream: str, advice: str, tmp_path: Path) -> None:
    result = run("record", str(tmp_path / name), "--stream", stream, "-p", "capture:none")
    assert result.status == 2 and not list(tmp_path.iterdir())
    assert advice in " ".join(result.error.split())


def test_a_named_pipe_needs_a_reader(gimbal: EmulatedGimbal, tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    arguments = ("record", "-p", gimbal.address, str(pipe), "--stream", "AhrsHelper")
    alone = run(*arguments, "--for", "200ms")
    assert alone.status == 1 and f"no program reads the named pipe {pipe}" in alone.error
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    assert run(*arguments, "--for", "200ms").status == 0
    assert messages(os.read(reader, 65536))["AhrsHelper"] >= 5
    os.close(reader)


def test_standard_output_carries_only_the_capture(gimbal: EmulatedGimbal) -> None:
    result = run("record", "-p", gimbal.address, "-", "--stream", "AhrsHelper", "--for", "200ms")
    assert result.status == 0, result
    assert messages(result.out)["AhrsHelper"] >= 5


def test_the_gimbal_is_killed_and_started_again(tmp_path: Path) -> None:
    capture = tmp_path / "capture"
    with emulated_gimbal() as gimbal:
        process = subprocess.Popen(
            [
                PROGRAM,
                "record",
                "-p",
                gimbal.address,
                str(capture),
                "--stream",
                "RealtimeData4",
            ],
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


@pytest.mark.parametrize(
    ("arguments", "status", "words"),
    [
        (["file"], 2, "--port"),
        (["tcp:127.0.0.1:9", "file", "-p", "tcp:127.0.0.1:9"], 2, "twice"),
        (["tcp:127.0.0.1:9", "file", "--stream", "RealtimeDta4"], 2, "did you mean"),
        (["tcp:127.0.0.1:9", "file", "--stream", "AhrsHelper", "--rate", "1", "--rate", "2"], 2,
         "one --rate"),
        (["tcp:127.0.0.1:9", "/tmp/capture", "--stream", "AhrsHelper"], 1, "refused"),
        (["tcp:127.0.0.1:9", "file", "--rate", "5"], 2, "--rate is for --stream"),
        (["tcp:127.0.0.1:9", "file", "--stream", "200:0e4"], 2, "pairs of hex digits"),
        (["tcp:127.0.0.1:9", "file", "--stream", "88"], 2, "has a name"),
        (["tcp:127.0.0.1:9", "file", "--stream", "0"], 2, "no data stream of '0'"),
        (["-p", "tcp:127.0.0.1:9", "file", "--rate", "5"], 2, "--rate is for --stream"),
        (["tcp:127.0.0.1:9", "file", "--timeout", "5"], 2, "--timeout has no effect"),
        (["tcp:127.0.0.1:9", "file", "-v"], 2, "--verbose has no effect"),
    ],
)  # fmt: skip
def test_mistakes_are_explained(arguments: list[str], status: int, words: str) -> None:
    result = run("record", *arguments)
    assert result.status == status, result
    assert words in result.error


def test_a_file_that_cannot_be_written(gimbal: EmulatedGimbal) -> None:
    result = run("record", "-p", gimbal.address, "/nowhere/capture", "--for", "10s")
    assert result.status == 1
    assert "/nowhere/capture" in result.error


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


def test_replay_goes_on_if_nobody_reads_its_reports(minute: Path) -> None:
    with subprocess.Popen(
        [PROGRAM, "replay", str(minute), "--tcp", "0"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        assert process.stdout is not None and process.stderr is not None
        process.stderr.close()
        address = process.stdout.readline().split(": ", 1)[1].strip()
        copy = run("record", address, "-")
        assert copy.status == 0 and messages(copy.out)["RealtimeData4"] > 0
        assert process.wait(timeout=20) == 0


def test_replay_of_nothing() -> None:
    result = run("replay", "/nowhere", "--tcp", "0")
    assert result.status == 1
    assert "there is no file" in result.error
