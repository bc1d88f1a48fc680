"""Tests of sbgc stream, over TCP and over a pseudo-terminal."""

from __future__ import annotations

import csv
import io
import json
import os
import pty
import re
import signal
import socket
import subprocess
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from sbgc_command import PROGRAM, Result, Running, frame, run


@pytest.fixture(scope="module", params=["tcp", "pty"])
def gimbal(request: pytest.FixtureRequest) -> Iterator[EmulatedGimbal]:
    options = ("--pty",) if request.param == "pty" else ()
    with emulated_gimbal(*options) as running:
        yield running


def stream(gimbal: EmulatedGimbal, *arguments: str) -> Result:
    return run("stream", "-p", gimbal.address, *arguments)


def rows_of(result: Result) -> tuple[list[str], list[list[str]]]:
    assert result.status == 0, result
    rows = list(csv.reader(io.StringIO(result.text)))
    return rows[0], rows[1:]


def test_csv_has_a_row_for_each_message(gimbal: EmulatedGimbal) -> None:
    header, rows = rows_of(
        stream(gimbal, "25", "--rate", "20", "--format", "csv", "--for", "1s")  # RealtimeData4
    )
    assert header[0] == "time[s]"
    assert {"angle.roll[deg]", "bat_level[V]", "cycle_time[us]", "error_code"} <= set(header)
    assert 5 <= len(rows) <= 21  # a busy machine delivers fewer than 20
    assert all(len(row) == len(header) for row in rows)
    assert all(float(cell) is not None for row in rows for cell in row if cell)
    times = [float(row[0]) for row in rows]
    assert times == sorted(times) and 0 < times[0] < times[-1] < 1.1
    # Values in their units: the emulated camera is at rest, its battery is charged.
    values = dict(zip(header, rows[-1]))
    assert abs(float(values["angle.pitch[deg]"])) < 1
    assert 6 < float(values["bat_level[V]"]) < 30


def test_fields_choose_what_the_message_contains(gimbal: EmulatedGimbal) -> None:
    arguments = ("RealtimeDataCustom", "--format", "jsonl", "--for", "1s", "--rate", "20")
    result = stream(gimbal, *arguments, "--fields", "imu_angles.yaw,rc_data")
    assert result.status == 0, result
    for sample in result.objects:
        assert 0 < sample["time"] < 10
        assert sample["version"] == 1 and sample["message"] == "RealtimeDataCustom"
        assert set(sample["fields"]) == {"imu_angles.yaw", *(f"rc_data[{i}]" for i in range(6))}
        angle = sample["fields"]["imu_angles.yaw"]
        assert angle["unit"] == "deg"
        assert angle["real"] == pytest.approx(angle["raw"] * 360 / 16384)
    same = stream(gimbal, *arguments, "--with", "imu_angles|RC_DATA")
    assert {"timestamp_ms", "imu_angles.roll", "rc_data[5]"} <= set(same.objects[0]["fields"])


@pytest.mark.parametrize("columns", [60, 80, 120])
def test_the_table_has_as_many_columns_as_fit_into_the_terminal(
    gimbal: EmulatedGimbal, columns: int
) -> None:
    header = header_of_table(gimbal, columns)
    assert len(header) <= columns
    assert header_of_table(gimbal, len(header)) == header
    assert len(header_of_table(gimbal, len(header) - 1)) < len(header) - 2


def header_of_table(gimbal: EmulatedGimbal, columns: int) -> str:
    """Returns the last line of the titles, after a look at the next lines."""
    header, note, row = table_on_terminal(gimbal, columns, "RealtimeData4")[2:5]
    assert re.fullmatch(r"\(\d+ more fields: choose with --fields\)", note)
    assert len(row) == len(header)
    return header


def test_the_angles_fit_into_a_small_terminal(gimbal: EmulatedGimbal) -> None:
    titles = [line.split() for line in table_on_terminal(gimbal, 40)[:4]]
    assert titles[0] == ["angle.", "angle.", "angle."]
    assert titles[1] == ["roll", "pitch", "yaw"]
    assert titles[2] == ["time[s]", "[deg]", "[deg]", "[deg]"]
    assert len(titles[3]) == 4
    more = ("RealtimeData3", "--fields", "angle.*,error_code")
    note = table_on_terminal(gimbal, 40, *more)[3]
    assert note == "(1 more field: choose with --fields)"


def table_on_terminal(gimbal: EmulatedGimbal, columns: int, *stream: str) -> list[str]:
    outside, inside = pty.openpty()
    arguments = ["stream", "-p", gimbal.address, *stream]
    environment = {**os.environ, "COLUMNS": str(columns)}
    with subprocess.Popen([PROGRAM, *arguments], stdout=inside, env=environment) as process:
        os.close(inside)
        shown = b""
        while shown.count(b"\n") < 5:
            shown += os.read(outside, 4096)
        process.send_signal(signal.SIGINT)
        assert process.wait(60) == 0
    os.close(outside)
    return shown.decode().splitlines()


def test_a_restart_is_reported() -> None:
    with emulated_gimbal() as board:
        process = start(board, "RealtimeData4", "--format", "jsonl", "--for", "8s")
        process.line()
        assert run("reset", "-p", board.address, "--yes").status == 0
        _, error = process.communicate(timeout=60)
    assert "the board may have restarted" in error or "connected again" in error


def without_losses(error: str) -> str:
    """Returns the other lines: on a busy machine, the last message may be late and count as lost."""
    return re.sub(r"sbgc: about \d+ messages? lost on the line, \d+ received\n", "", error)


def test_lost_messages_are_counted() -> None:
    with emulated_gimbal("--bit-errors", "4e-4") as noisy:
        arguments = ("RealtimeData4", "--rate", "50", "--for", "1500ms", "--format", "csv")
        result = run("stream", *arguments, "-p", noisy.address, "--attempts", "50")
    rows = rows_of(result)[1]
    told = re.search(r"about (\d+) messages? lost on the line, (\d+) received", result.error)
    assert told, result
    lost, received = map(int, told.groups())
    assert received == len(rows)
    assert 0 < lost <= 75


def test_a_capture_ends(gimbal: EmulatedGimbal, tmp_path: Path) -> None:
    capture = tmp_path / "capture"
    recorded = ("record", "-p", gimbal.address, str(capture), "--stream", "RealtimeData4")
    assert run(*recorded, "--for", "1s").status == 0
    result = run("stream", "RealtimeData4", "-p", f"capture:{capture}", "--format", "csv")
    assert (result.status, without_losses(result.error)) == (0, "")
    assert len(rows_of(result)[1]) > 3
    capture.write_bytes(capture.read_bytes()[:-1])
    result = run("stream", "RealtimeData4", "-p", f"capture:{capture}", "--format", "csv")
    assert result.status == 1 and "has damaged parts, which are left out" in result.error


def start(gimbal: EmulatedGimbal, *arguments: str) -> Running:
    return Running("stream", "-p", gimbal.address, *arguments)


def test_each_row_is_written_at_once_and_ctrl_c_is_an_end(gimbal: EmulatedGimbal) -> None:
    process = start(gimbal, "RealtimeData4", "--format", "jsonl", "--rate", "10")
    for _ in range(3):
        assert json.loads(process.line())["time"] > 0
    process.send_signal(signal.SIGINT)
    _, error = process.communicate(timeout=20)
    assert (process.returncode, without_losses(error)) == (0, "")


def test_a_reader_that_leaves_is_a_quiet_end(gimbal: EmulatedGimbal) -> None:
    process = start(gimbal, "RealtimeData4", "--format", "csv")
    assert process.stdout is not None and process.stderr is not None
    process.stdout.readline()
    process.stdout.close()
    assert process.wait(timeout=20) == 0
    assert without_losses(process.stderr.read()) == ""
    process.stderr.close()


def test_a_stream_of_an_unknown_message_is_bytes() -> None:
    server = socket.create_server(("127.0.0.1", 0))
    asked: list[bytes] = []

    def serve() -> None:
        line, _ = server.accept()
        with line, line.makefile("rb") as requests:
            while head := requests.read(4):
                _, number, size, _ = head
                body = requests.read(size + 1)[:-1]
                if number == 86:
                    line.sendall(frame(86, bytes.fromhex("1e4b0a000200010000000000000000000000")))
                elif number == 85:
                    asked.append(body)
                    line.sendall(frame(67, b"\x55"))
                    line.sendall(frame(200, b"\x0e\x45") + frame(201, b"\x01") + frame(200))
                else:
                    line.sendall(frame(255, bytes([number, 6, 0, 0, 0, 0])))

    thread = threading.Thread(target=serve, daemon=True)
    thread.start()
    address = "tcp:127.0.0.1:%d" % server.getsockname()[1]
    result = run(
        "stream", "-p", address, "--id", "200", "--config", "beef", "--rate", "10",
        "--format", "jsonl", "--for", "1s",
    )  # fmt: skip
    thread.join(20)
    assert result.status == 0, result
    bodies = [one["body"] for one in result.objects]
    assert bodies[:2] == ["0e45", ""]
    assert {one["id"] for one in result.objects} == {200}
    start, *_, end = asked
    assert start == bytes([200, 100, 0, 0xBE, 0xEF]) + bytes(16)
    assert end == bytes([200, 0, 0, 0xBE, 0xEF]) + bytes(16)
