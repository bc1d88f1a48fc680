"""Tests of commands whose board leaves a requested block out, as one with firmware 2.68b6 does."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from emulated_gimbal import emulated_gimbal
from relay import relay_to
from sbgc_command import frame, run

REALTIME_DATA_CUSTOM = 88
FLAGS = "IMU_ANGLES|TARGET_ANGLES|RC_DATA|ENCODER_RAW24"
WORDS = (
    "CMD_REALTIME_DATA_CUSTOM cannot be decoded: "
    "26 bytes, the flags need 35, and 26 without ENCODER_RAW24"
)


class Board:
    """An emulated gimbal behind a relay that cuts off ENCODER_RAW24, the last requested block."""

    def __init__(self) -> None:
        self.address = ""
        self.requests = 0
        self._pending = b""

    def ask(self, request: bytes) -> bytes:
        if request[0] != ord(">"):
            return b""  # so that all frames are of the first framing
        self.requests += request[1] == REALTIME_DATA_CUSTOM
        return request

    def answer(self, data: bytes) -> bytes:
        self._pending += data
        answers = b""
        while len(self._pending) >= 5 and len(self._pending) >= 5 + self._pending[2]:
            command, end = self._pending[1], 5 + self._pending[2]
            body, self._pending = self._pending[4 : end - 1], self._pending[end:]
            answers += frame(command, body[:26] if command == REALTIME_DATA_CUSTOM else body)
        return answers


@pytest.fixture(name="board")
def one_board() -> Iterator[Board]:
    board = Board()
    with emulated_gimbal("--firmware", "2.68b6") as gimbal:
        with relay_to(gimbal.address, board.ask, board.answer) as board.address:
            yield board


def test_send_prints_what_came(board: Board) -> None:
    arguments = ("send", "CMD_REALTIME_DATA_CUSTOM", f"flags={FLAGS}", "-p", board.address)
    result = run(*arguments, "--format", "jsonl")
    assert result.status == 1 and result.error == f"sbgc: {WORDS}\n"
    (line,) = result.objects
    assert line["error"]["code"] == "too_short" and len(line["body"]) == 2 * 26
    assert "fields" not in line
    assert board.requests == 1, "it has not sent the request again"
    result = run(*arguments)
    assert result.status == 1 and f"error: {WORDS.split(': ')[1]} (" in result.text


@pytest.mark.parametrize("format_name", ["text", "csv", "jsonl"])
def test_stream_ends(board: Board, format_name: str) -> None:
    arguments = ("RealtimeDataCustom", "--with", FLAGS, "--format", format_name)
    result = run("stream", *arguments, "-p", board.address)
    assert result.status == 1 and result.error == f"sbgc: {WORDS}\n"
    assert len(result.text.splitlines()) <= 1, "only the header"


def test_other_requests_are_answered(board: Board) -> None:
    result = run(
        "send", "CMD_REALTIME_DATA_CUSTOM", "flags=IMU_ANGLES|RC_DATA", "-p", board.address
    )
    assert result.status == 0, result
