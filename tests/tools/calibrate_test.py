"""Calibrations and automatic tuning with the sbgc command."""

from __future__ import annotations

import json
import os
import re
import signal
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from board_command import Terminal, Watched
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from sbgc_command import MODEL, Result, run
from screens import terminal


@pytest.fixture(name="gimbal", scope="module")
def one_gimbal() -> Iterator[EmulatedGimbal]:
    with emulated_gimbal("--board", "3.6", "--firmware", "2.70b0") as gimbal:
        turn_motors_off(gimbal)
        yield gimbal


def turn_motors_off(gimbal: EmulatedGimbal) -> None:
    assert run("motors", "off", "--yes", "-p", gimbal.address).status == 0


def calibrate(gimbal: EmulatedGimbal, *arguments: str) -> Result:
    return run("calibrate", *arguments, "-p", gimbal.address)


def test_the_gyroscope(gimbal: EmulatedGimbal) -> None:
    result = calibrate(gimbal, "gyro", "--yes")
    assert (result.status, result.out) == (0, b"")
    text = " ".join(result.error.split())
    request = next(m for m in MODEL["messages"] if m["name"] == "CalibGyro")
    assert request["preparation"] in text, "how to hold the camera"
    assert "the change survives a restart" in text
    assert "restarts" not in text and "deletes" not in text
    assert text.endswith("The calibration is done.")


def test_progress_on_a_terminal(gimbal: EmulatedGimbal) -> None:
    short = ("imu_idx=MAIN", "time_ms=2500")
    screen = Terminal("calibrate", "gyro", *short, "--yes", "-p", gimbal.address)
    assert screen.status() == 0
    percents = [int(text) for text in re.findall(rb"s: (\d+) %", screen.shown)]
    assert percents == sorted(percents) and len(set(percents)) > 2, screen.shown


def test_ctrl_c_says_that_the_board_goes_on() -> None:
    arguments = ("calibrate", "gyro", "--imu", "frame", "--yes")
    with emulated_gimbal() as gimbal:
        turn_motors_off(gimbal)
        calibrating = Watched(*arguments, "-p", gimbal.address)
        calibrating.wait_for("CMD_CONFIRM")
        ended = calibrating.interrupt()
        assert ended.status == 130
        assert "no command stops a calibration: the board goes on" in " ".join(ended.error.split())
        busy = calibrate(gimbal, "mag", "--yes")
        assert busy.status == 1 and "WRONG_STATE" in busy.error, "it does go on"


def test_the_progress_is_that_of_the_chosen_sensor(gimbal: EmulatedGimbal) -> None:
    for imu in ("main", "frame"):
        result = calibrate(gimbal, "gyro", "--imu", imu, "time_ms=500", "--yes", "-v")
        assert result.status == 0, result
        (seen,) = set(re.findall(r"^ +imu_type +\d+ +IMU_TYPE_(\w+)$", result.error, re.M))
        assert seen == imu.upper()


def test_the_status_names_what_is_calibrated() -> None:
    with emulated_gimbal("--fault", "calib-acc") as gimbal:
        turn_motors_off(gimbal)
        before = run("calibrate", "--status", "-p", gimbal.address)
        assert before.status == 0
        assert "accelerometer: none, not +X, -X, +Y, -Y, +Z, -Z" in " ".join(before.text.split())
        assert calibrate(gimbal, "acc", "--yes").status == 0
        after = run("calibrate", "--status", "-p", gimbal.address)
    assert "accelerometer: +Z, not +X, -X, +Y, -Y, -Z" in " ".join(after.text.split())


def refused(gimbal: EmulatedGimbal, *arguments: str) -> str:
    """Returns why a calibration is refused. Nothing was sent that starts it."""
    result = calibrate(gimbal, *arguments, "--yes", "-v")
    assert result.status == 1, result.error
    assert not re.search(r"host to board.*CALIB_(?!INFO)|CMD_CALIB_(?!INFO)\w+ \(", result.error)
    return result.error.strip().splitlines()[-1]


def test_motors_that_are_on() -> None:
    with emulated_gimbal("--calibration-time", "5") as gimbal:
        said = ("imu_idx=MAIN", "action=REGULAR")
        for words in (("gyro",), ("acc",), ("mag",), ("encoders",), ("gyro", *said)):
            assert "the motors are on: turn them off with --motors-off" in refused(gimbal, *words)
        assert calibrate(gimbal, "gyro", "--yes", "--no-check").status == 0
        assert re.search(r"^motors +on$", calibrate(gimbal, "--status").text, re.MULTILINE)
        assert calibrate(gimbal, "gyro", "--yes", "--motors-off").status == 0
        assert re.search(r"^motors +off$", calibrate(gimbal, "--status").text, re.MULTILINE)
        assert calibrate(gimbal, "gyro", "--yes").status == 0


def test_a_drone_that_hovers_holds_its_camera_but_not_its_frame() -> None:
    # Its motors are on, which is why only this calibration shows the difference.
    with emulated_gimbal("--motion", "vehicle", "--calibration-time", "5") as gimbal:
        result = calibrate(gimbal, "follow-offset", "--yes")
        assert result.status == 0, "the motors hold the camera still"


def test_an_even_turn_is_no_rest(tmp_path: Path) -> None:
    turning = ("--fault", "drift=2", "--calibration-time", "5")
    with emulated_gimbal(*turning) as gimbal, terminal(tmp_path, 100, 30) as shell:
        turn_motors_off(gimbal)
        assert re.search(r"the camera turns evenly by [12]\.\d deg/s", refused(gimbal, "gyro"))
        # A user who sees that it is still can say so, because this calibration mends the offset.
        for answer, end in (("n", "the camera is not still$"), ("y", "is done")):
            shell.run("calibrate", "gyro", "-p", gimbal.address)
            for question, reply in (("Continue", "y"), ("Is it still", answer)):
                shell.wait(question)
                shell.wait(lambda lines: "".join(lines).rstrip().endswith("[y/N]"))
                shell.enter(reply)
            shell.wait(end)
            shell.enter("clear")
            shell.wait(lambda lines: "Continue" not in "".join(lines))


def test_the_six_positions_are_offered_one_after_another(tmp_path: Path) -> None:
    options = ("--calibration-time", "5", "--fault", "calib-acc")
    with emulated_gimbal(*options) as gimbal, terminal(tmp_path, 100, 30) as shell:
        shell.run("calibrate", "acc", "-p", gimbal.address)
        for question in ("Continue", "The motors are on", "Turn another"):
            shell.wait(question)
            shell.wait(lambda lines: "".join(lines).rstrip().endswith("[y/N]"))
            shell.enter("y")
        shell.wait("this side of the sensor was up before; turn another one upwards")
        lines = shell.lines()
        assert any("not +X, -X, +Y, -Y, -Z" in line for line in lines)
        assert sum("is done" in line for line in lines) == 1


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
            shell.enter("y")
            shell.wait("Keep the new values")
            assert gains(gimbal) != before
            shell.enter("n")
            shell.wait("not kept; the old values are back")
        assert gains(gimbal) == before


def test_ctrl_c_ends_the_tuning_and_nothing_changes() -> None:
    with emulated_gimbal(*SLOW) as gimbal:
        before = gains(gimbal)
        tuning = Watched("tune", "--yes", "-p", gimbal.address)
        tuning.wait_for("CMD_AUTO_PID (35)  board to host")
        ended = tuning.interrupt()
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
            shell.enter("y")
            shell.wait("Keep the new values")
            assert gains(gimbal) != before
            os.kill(shell.process(), signal.SIGKILL)
            wait_for_end_of_tuning(gimbal, before)
