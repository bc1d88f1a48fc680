"""Tests of a host on standard input and output."""

from __future__ import annotations

import fcntl
import os
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
    stream,
    talk,
)
from sbgc_command import PROGRAM, frame


def test_standard_input_and_output(tmp_path: Path) -> None:
    done = subprocess.run(
        [PROGRAM, "emulate", "--stdio", "--verbose"],
        input=frame(BOARD_INFO) + frame(BOARD_INFO_3),
        capture_output=True,
        timeout=PATIENCE,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout[:2] == bytes([0x3E, BOARD_INFO])
    assert bytes([0x3E, BOARD_INFO_3, 69]) in done.stdout
    assert b"emulated gimbal 1: standard input and output" in done.stderr
    assert b"CMD_BOARD_INFO" in done.stderr

    # Regular files work as well.
    (tmp_path / "in").write_bytes(frame(BOARD_INFO))
    with open(tmp_path / "in", "rb") as source, open(tmp_path / "out", "wb") as sink:
        done = subprocess.run(
            [PROGRAM, "emulate", "--stdio"],
            stdin=source,
            stdout=sink,
            stderr=subprocess.PIPE,
            timeout=PATIENCE,
            check=False,
        )
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "out").read_bytes()[:2] == bytes([0x3E, BOARD_INFO])


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
