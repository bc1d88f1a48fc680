"""Tests of sbgc tune."""

from __future__ import annotations

import json
import os
import signal
import time
from pathlib import Path
from typing import Any

import pytest

from board_command import Watched
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from sbgc_command import run
from screens import terminal

QUICK = ("--firmware", "2.70b0", "--board", "3.6", "--calibration-time", "10")
SLOW = ("--firmware", "2.70b0", "--board", "3.6")


def gains(gimbal: EmulatedGimbal) -> dict[str, Any]:
    result = run("params", "show", "--format", "json", "-p", gimbal.address)
    assert result.status == 0
    found: dict[str, Any] = json.loads(result.out)
    return found


@pytest.mark.parametrize("options", [QUICK, ("--calibration-time", "10")], ids=["new", "old"])
def test_what_it_shows_is_on_the_board(options: tuple[str, ...]) -> None:
    with emulated_gimbal(*options) as gimbal:
        before = gains(gimbal)
        result = run("tune", "pitch", "--yes", "-p", gimbal.address)
        after = gains(gimbal)
    assert result.status == 0, result.error
    assert "The new values are kept." in result.error
    assert before != after
    rows = dict((line.split()[0], line.split()[1:]) for line in result.text.splitlines())
    assert rows.pop("parameter") == ["old", "new"]
    assert rows and all(name.startswith("axes.pitch.") for name in rows), "only this axis"
    old, new = json.dumps(before), json.dumps(after)
    for value_before, value_after in rows.values():
        assert value_before in old and value_after in new


def test_a_silent_line_is_no_end_of_the_tuning() -> None:
    slower = ("--firmware", "2.70b0", "--board", "3.6", "--calibration-time", "60")
    with emulated_gimbal(*slower, "--silence", "3:2") as gimbal:
        result = run("tune", "pitch", "--yes", "-p", gimbal.address)
    assert result.status == 0, result.error
    assert "axes.pitch." in result.text, "it waits for the new values"


def test_no_puts_the_old_values_back(tmp_path: Path) -> None:
    with emulated_gimbal(*QUICK) as gimbal:
        before = gains(gimbal)
        with terminal(tmp_path, 100, 30) as shell:
            shell.run("tune", "roll", "-p", gimbal.address)
            shell.wait("Continue")
            shell.type("y")
            shell.press("Enter")
            shell.wait("Keep the new values")
            assert gains(gimbal) != before
            shell.type("n")
            shell.press("Enter")
            shell.wait("not kept; the old values are back")
        assert gains(gimbal) == before


def test_ctrl_c_ends_the_tuning_and_nothing_changes() -> None:
    with emulated_gimbal(*SLOW) as gimbal:
        before = gains(gimbal)
        tuning = Watched("tune", "--yes", "-p", gimbal.address)
        tuning.wait_for("CMD_AUTO_PID (35)  board to host")
        tuning.process.send_signal(signal.SIGINT)
        ended = tuning.end()
        assert ended.status == 130
        text = ended.error
        assert "The old values are on the board." in text
        assert text.rstrip().endswith("interrupted; the camera has stopped")
        assert gains(gimbal) == before
        data = json.loads(
            run(*"send CMD_REALTIME_DATA_4 --format jsonl -p".split(), gimbal.address).out
        )
        assert data["fields"]["calib_mode"] == 0


def wait_for_end_of_tuning(gimbal: EmulatedGimbal, before: dict[str, Any]) -> None:
    """Waits until a guard has ended the tuning and put the gains back."""
    deadline = time.monotonic() + 60
    while time.monotonic() < deadline:
        result = run(*"send CMD_REALTIME_DATA_4 --format jsonl -p".split(), gimbal.address)
        if result.status == 0 and json.loads(result.out)["fields"]["calib_mode"] == 0:
            if gains(gimbal) == before:
                return
    raise AssertionError("the board still tunes, or has other gains")


def test_a_guard_ends_the_tuning_of_a_dead_command() -> None:
    with emulated_gimbal(*SLOW) as gimbal:
        before = gains(gimbal)
        tuning = Watched("tune", "--yes", "-p", gimbal.address)
        tuning.wait_for("CMD_AUTO_PID (35)  board to host")
        tuning.process.kill()
        wait_for_end_of_tuning(gimbal, before)


def test_a_guard_puts_the_old_values_back_if_the_command_dies_at_the_question(
    tmp_path: Path,
) -> None:
    with emulated_gimbal(*QUICK) as gimbal:
        before = gains(gimbal)
        with terminal(tmp_path, 100, 30) as shell:
            shell.run("tune", "roll", "-p", gimbal.address)
            shell.wait("Continue")
            shell.type("y")
            shell.press("Enter")
            shell.wait("Keep the new values")
            assert gains(gimbal) != before
            os.kill(shell.process(), signal.SIGKILL)
            wait_for_end_of_tuning(gimbal, before)
