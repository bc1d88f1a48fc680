"""Tests of boards that answer less: what a board did not confirm is no success, the commands say so and end with
status 3; a block may be missing, as with firmware 2.68b6."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from closed_terminal_test import CASES, CHANGING, prepare
from emulated_gimbal import emulated_gimbal
from relay import relay_to
from sbgc_command import frame, run

SCRIPT, MENU, DEFAULTS, NAMES, SAVE, BATTERY, CONTROL = 57, 69, 70, 29, 32, 66, 67
SENT = "the board did not confirm it"
COMMANDS: dict[str, tuple[int, int, str]] = {
    "script stop 1": (SCRIPT, 3, SENT),
    "menu look_down --yes": (MENU, 3, SENT),
    "menu profile2 --yes": (MENU, 3, SENT),
    "vars set P_ROLL=33 --save --yes": (SAVE, 3, SENT),
    "calibrate battery actual_voltage=12 --yes --no-check": (BATTERY, 3, SENT),
    "params reset --profile 3 --yes": (DEFAULTS, 3, f"{SENT}, and profile 3 is as before"),
    "params diff --defaults --yes": (DEFAULTS, 3, SENT),
    "params rename 2 Studio --yes": (NAMES, 1, "did not confirm ReadProfileNames, and it reads"),
    "speed --yaw 10 --for 200ms --yes": (CONTROL, 3, "nothing shows that the camera has turned"),
    "send CMD_RUN_SCRIPT --yes": (SCRIPT, 0, SENT),
}


@pytest.mark.parametrize("command", COMMANDS)
def test_silence_is_no_success(
    command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    lost, status, sentence = COMMANDS[command]
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.chdir(tmp_path)
    with (
        emulated_gimbal("--firmware", "2.59") as gimbal,
        relay_to(gimbal.address, lambda data: b"" if data[1] == lost else data) as address,
    ):
        if lost == CONTROL:
            assert run("motors", "on", "--yes", "-p", gimbal.address).status == 0
        done = run(*command.split(), "--timeout", "600ms", "-p", address)
        assert done.status == status, done.error
        assert sentence in " ".join(done.error.split())
        assert not (tmp_path / "sbgc").exists(), "no defaults are kept"


# `send` does not wait for what a request does, and what stands already is stopped. `jog` has no end.
@pytest.mark.parametrize("name", sorted(set(CASES) - {"send", "stop", "script stop", "jog"}))
def test_no_command_succeeds_without_its_effect(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    case = CASES[name]
    monkeypatch.chdir(tmp_path)
    board = ("--board", "3.6", "--firmware", case.firmware)
    with (
        emulated_gimbal(*board) as gimbal,
        relay_to(gimbal.address, lambda data: b"" if data[1] in CHANGING else data) as address,
    ):
        prepare(name, gimbal, tmp_path)
        words = [*name.split(), *case.arguments.format(folder=tmp_path).split()]
        done = run(*words, "--yes", "--timeout", "600ms", "-p", address)
        assert done.status in (1, 3) and done.error, done


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
