"""Calibrations with the sbgc command."""

from __future__ import annotations

import os
import pty
import re
import signal
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from sbgc_command import MODEL, PROGRAM, Result, run
from screens import terminal


@pytest.fixture(name="gimbal", scope="module")
def one_gimbal() -> Iterator[EmulatedGimbal]:
    with emulated_gimbal("--board", "3.6", "--firmware", "2.70b0") as gimbal:
        yield gimbal


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
    process, screen = pty.fork()
    if process == 0:
        short = ("imu_idx=MAIN", "time_ms=2500")
        os.execv(PROGRAM, [PROGRAM, "calibrate", "gyro", *short, "--yes", "-p", gimbal.address])
    shown = b""
    try:
        while part := os.read(screen, 4096):
            shown += part
    except OSError:
        pass  # the other side is closed
    assert os.waitstatus_to_exitcode(os.waitpid(process, 0)[1]) == 0
    percents = [int(text) for text in re.findall(rb"s: (\d+) %", shown)]
    assert percents == sorted(percents) and len(set(percents)) > 2, shown


def test_ctrl_c_says_that_the_board_goes_on() -> None:
    arguments = ("calibrate", "gyro", "--imu", "frame", "--yes", "-v")
    with emulated_gimbal() as gimbal:
        with subprocess.Popen(
            [PROGRAM, *arguments, "-p", gimbal.address], stderr=subprocess.PIPE
        ) as process:
            assert process.stderr is not None
            for line in process.stderr:  # the frames are printed
                if b"CMD_CONFIRM" in line:
                    break
            process.send_signal(signal.SIGINT)
            error = process.stderr.read().decode()
            assert process.wait(30) == 130
        assert "no command stops a calibration: the board goes on" in " ".join(error.split())
        busy = calibrate(gimbal, "mag", "--yes")
        assert busy.status == 1 and "WRONG_STATE" in busy.error, "it does go on"


def test_the_progress_is_that_of_the_chosen_sensor(gimbal: EmulatedGimbal) -> None:
    for imu in ("main", "frame"):
        result = calibrate(gimbal, "gyro", "--imu", imu, "time_ms=500", "--yes", "-v")
        assert result.status == 0, result
        (seen,) = set(re.findall(r"^ +imu_type +\d+ +IMU_TYPE_(\w+)$", result.error, re.M))
        assert seen == imu.upper()


def test_a_calibration_that_does_not_report_its_end(gimbal: EmulatedGimbal) -> None:
    result = calibrate(gimbal, "battery", "--voltage", "12.6V", "--yes")
    assert result.status == 0
    assert "it does not report the end" in result.error


def test_one_that_moves_the_motors_says_so(gimbal: EmulatedGimbal) -> None:
    result = calibrate(gimbal, "poles")
    text = " ".join(result.error.split())
    assert result.status == 1 and "add --yes" in text
    assert "The camera can move" in text and "fasten the frame" in text


def test_other_actions_say_what_they_do(gimbal: EmulatedGimbal) -> None:
    result = calibrate(gimbal, "gyro", "imu_idx=MAIN", "action=RESET")
    text = " ".join(result.error.split())
    assert result.status == 1
    assert "The board restarts" in text and "It deletes stored data" in text


def test_the_list() -> None:
    names = [line.split()[0] for line in run("calibrate", "--list").text.splitlines()]
    assert {"gyro", "acc", "mag", "encoders", "poles", "battery"} < set(names)


@pytest.mark.parametrize(
    "arguments, words",
    [
        ((), "calibrate --list"),
        (("gyr",), "did you mean 'gyro'?"),
        (("gyro", "--imu", "left", "--yes"), "left"),
        (("battery", "--yes"), "FIELD=VALUE"),
        (("battery", "--voltage", "12.6A", "--yes"), "'A' is not its unit"),
        (("poles", "--imu", "main", "--yes"), "imu_idx"),
        (("cogging", "axes=ROLL", "--yes"), "iterations_num: 0 is below 2"),
    ],
)
def test_wrong_usage(arguments: tuple[str, ...], words: str) -> None:
    result = run("calibrate", *arguments, "-p", "tcp:127.0.0.1:1")
    assert result.status == 2
    assert words in " ".join(result.error.split())


@pytest.mark.parametrize("value", ["time_ms=soon", "nonsense=1"])
def test_wrong_values_say_once_where_the_fields_are_explained(value: str) -> None:
    result = run("calibrate", "gyro", value, "--yes", "-p", "tcp:127.0.0.1:1")
    assert result.status == 2
    assert result.error.count("`sbgc describe CMD_CALIB_GYRO`") == 1


def test_the_status_names_what_is_calibrated(gimbal: EmulatedGimbal) -> None:
    before = run("calibrate", "--status", "-p", gimbal.address)
    assert before.status == 0
    assert "accelerometer: none, not +X, -X, +Y, -Y, +Z, -Z" in " ".join(before.text.split())
    assert calibrate(gimbal, "acc", "--yes").status == 0
    after = run("calibrate", "--status", "-p", gimbal.address)
    assert "accelerometer: +Z, not +X, -X, +Y, -Y, -Z" in " ".join(after.text.split())


def test_motors_that_are_on() -> None:
    with emulated_gimbal("--calibration-time", "5") as gimbal:
        warned = calibrate(gimbal, "gyro", "--yes")
        assert warned.status == 0 and "the motors are on; --motors-off turns" in warned.error
        assert "--motors-off" not in calibrate(gimbal, "gyro", "--yes", "--no-check").error
        assert calibrate(gimbal, "gyro", "--yes", "--motors-off").status == 0
        assert re.search(r"^motors +off$", calibrate(gimbal, "--status").text, re.MULTILINE)
        assert "the motors are on" not in calibrate(gimbal, "gyro", "--yes").error


def test_a_camera_that_moves_is_not_calibrated() -> None:
    with emulated_gimbal("--motion", "vehicle") as shaking:
        assert run("motors", "off", "--yes", "-p", shaking.address).status == 0
        result = calibrate(shaking, "gyro", "--yes", "-v")
        assert result.status == 1 and "the camera is not still" in result.error
        assert "CMD_CALIB_GYRO (103)" not in result.error, "nothing was sent"


def test_the_six_positions_are_offered_one_after_another(tmp_path: Path) -> None:
    with emulated_gimbal("--calibration-time", "5") as gimbal, terminal(tmp_path, 100, 30) as shell:
        shell.run("calibrate", "acc", "-p", gimbal.address)
        for question in ("Continue", "The motors are on", "Turn another"):
            shell.wait(question)
            shell.wait(lambda lines: "".join(lines).rstrip().endswith("[y/N]"))
            shell.type("y")
            shell.press("Enter")
        shell.wait(lambda lines: sum("is done" in line for line in lines) == 2)
        assert any("not +X, -X, +Y, -Y, -Z" in line for line in shell.lines())
