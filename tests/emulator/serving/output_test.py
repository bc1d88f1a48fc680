"""Tests of the output for people, and of a host on standard input and output."""

from __future__ import annotations

import fcntl
import os
import re
import signal
import subprocess
import time
from pathlib import Path

import pytest

from emulator import (
    BOARD_INFO,
    BOARD_INFO_3,
    CONFIRM,
    DATA_STREAM_INTERVAL,
    PATIENCE,
    Emulator,
    Terminal,
    stream,
    talk,
)
from full_output import full_output
from gimbal_observer import Observer
from sbgc_command import PROGRAM, frame, run


def test_every_frame_as_a_line() -> None:
    with Emulator("--tcp", "0", "--verbose") as emulator:
        host = emulator.host()
        host.ask(BOARD_INFO)
        host.send(200)
        host.ask(BOARD_INFO)
        emulator.end()
        request = emulator.rest.index("> CMD_BOARD_INFO (86), 0 bytes  executed")
        assert request < emulator.rest.index("< CMD_BOARD_INFO (86), 18 bytes")
        assert "> unknown command (200), 0 bytes  not supported" in emulator.rest
        assert "is host 0" in emulator.rest


def test_a_reader_of_its_output_that_goes_away(tmp_path: Path) -> None:
    link = tmp_path / "gimbal"
    with Emulator("--link", str(link), "--verbose") as emulator:
        assert emulator.process.stdout is not None
        emulator.process.stdout.close()
        emulator.process.stdout = None
        terminal = Terminal(str(link))
        for _ in range(5):
            assert terminal.ask(BOARD_INFO)
        terminal.close()
        emulator.process.send_signal(signal.SIGTERM)
        assert emulator.process.wait(PATIENCE) == 0
        assert emulator.process.stderr is not None
        emulator.process.stderr.close()
    assert not link.is_symlink()


def test_a_reader_of_its_warnings_that_stalls() -> None:
    with Emulator("--tcp", "0") as emulator:
        assert emulator.process.stderr is not None
        fcntl.fcntl(emulator.process.stderr, fcntl.F_SETPIPE_SZ, 4096)
        hosts = [emulator.host() for _ in range(8)]
        for host in hosts:
            assert host.ask(BOARD_INFO)
        for _ in range(100):
            refusal = emulator.host()
            assert refusal.is_refused()
            refusal.close()
        assert hosts[0].ask(BOARD_INFO)
        emulator.process.terminate()
        assert emulator.process.wait(PATIENCE) == 0


def test_warnings_that_cannot_be_written() -> None:
    with Emulator("--tcp", "0", stderr="/dev/full") as emulator:
        hosts = [emulator.host() for _ in range(8)]
        for host in hosts:
            assert host.ask(BOARD_INFO)
        assert emulator.host().is_refused()  # which prints a warning
        assert hosts[0].ask(BOARD_INFO)


def test_an_example_whose_output_stalls(tmp_path: Path) -> None:
    """A signal turns the motors off that the example has turned on."""
    tour = os.environ.get("SBGC_TOUR")
    if not tour:
        pytest.skip("examples are not built")
    with Emulator("--tcp", "0", "--verbose") as emulator, full_output(
        "terminal stopped later"
    ) as output:
        place = emulator.places[0]
        assert run("motors", "off", "--yes", "-p", place).status == 0
        arguments = [tour, place, str(tmp_path / "capture"), str(tmp_path / "backup"), "--yes"]
        process = subprocess.Popen(arguments, stdout=output.descriptor)
        try:
            shown = b""
            while b"pitch to" not in shown:
                shown += os.read(output.reader, 4096)
            output.become_full()
            with Observer(place) as observer:
                observer.await_motion()
                assert observer.stands_still_within(PATIENCE)
            time.sleep(1)  # until it prints where the camera is
            process.send_signal(signal.SIGINT)
            assert process.wait(PATIENCE) == 1
        finally:
            process.kill()
        emulator.end()
        requests = re.findall(r"> (CMD_(?:CONTROL|MOTORS)\w*)", emulator.rest)
        assert requests[-3:] == ["CMD_MOTORS_ON", "CMD_CONTROL", "CMD_MOTORS_OFF"], requests


def test_standard_input_and_output(tmp_path: Path) -> None:
    """Regular files."""
    (tmp_path / "in").write_bytes(frame(BOARD_INFO) + frame(BOARD_INFO_3))
    with open(tmp_path / "in", "rb") as source, open(tmp_path / "out", "wb") as sink:
        done = subprocess.run(
            [PROGRAM, "emulate", "--stdio", "--verbose"],
            stdin=source,
            stdout=sink,
            stderr=subprocess.PIPE,
            timeout=PATIENCE,
            check=False,
        )
    assert done.returncode == 0, done.stderr
    answers = (tmp_path / "out").read_bytes()
    assert answers[:2] == bytes([0x3E, BOARD_INFO])
    assert bytes([0x3E, BOARD_INFO_3, 69]) in answers
    assert b"emulated gimbal 1: standard input and output" in done.stderr
    assert b"CMD_BOARD_INFO" in done.stderr


def test_standard_input_that_ends_before_the_answers() -> None:
    for line, number in ((["--baud", "9600"], 20), ([], 2000)):
        answers, rest = divmod(len(talk(frame(BOARD_INFO_3) * number, *line)), 74)
        assert rest == 0
        # Requests are read in chunks, and a stall between two chunks may lose a request.
        assert number * 99 // 100 <= answers <= number


@pytest.mark.parametrize("line", [["--baud", "9600"], ["--text", "0.001"], []])
def test_standard_input_that_asks_for_streams(line: list[str]) -> None:
    begin = time.monotonic()
    answers = talk(frame(DATA_STREAM_INTERVAL, stream(1)) + frame(BOARD_INFO) * 20, *line)
    assert answers.count(bytes([0x3E, CONFIRM])) == 1
    assert answers.count(bytes([0x3E, BOARD_INFO, 18])) == 20
    assert time.monotonic() - begin < PATIENCE / 2


def test_answers_that_nobody_takes() -> None:
    reader, out = os.pipe()
    fcntl.fcntl(reader, fcntl.F_SETPIPE_SZ, 4096)
    done = subprocess.run(
        [PROGRAM, "emulate", "--stdio"],
        input=frame(BOARD_INFO_3) * 1000,
        stdout=out,
        stderr=subprocess.PIPE,
        timeout=PATIENCE,
        check=False,
    )
    assert done.returncode == 1
    assert b"standard input and output: " in done.stderr
    os.close(reader)
    os.close(out)


def test_a_request_after_what_only_looked_like_the_beginning_of_one() -> None:
    begun = b">" + bytes([BOARD_INFO, 200, (BOARD_INFO + 200) % 256])
    assert talk(begun + frame(BOARD_INFO))[:2] == bytes([0x3E, BOARD_INFO])


@pytest.mark.parametrize("closed", ["<&-", ">&-"])
def test_standard_files_that_are_closed(closed: str) -> None:
    done = subprocess.run(
        ["sh", "-c", f'exec "$0" emulate --stdio {closed}', PROGRAM],
        stdin=subprocess.DEVNULL,
        capture_output=True,
        timeout=PATIENCE,
        check=False,
    )
    assert done.returncode == 1
    assert b"standard" in done.stderr
