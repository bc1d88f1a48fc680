"""Calibrations with the sbgc command."""

from __future__ import annotations

import os
import pty
import re
import signal
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from sbgc_command import MODEL, PROGRAM, Result, run
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
        turn_motors_off(gimbal)
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
    result = calibrate(gimbal, "battery", "--voltage", "16.2V", "--yes")
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


def test_a_camera_that_moves_is_not_calibrated() -> None:
    with emulated_gimbal("--motion", "vehicle") as shaking:
        turn_motors_off(shaking)
        for name in ("gyro", "acc", "poles"):
            assert "the camera is not still: it turns by" in refused(shaking, name)


@pytest.mark.parametrize("firmware", ["2.59", "2.74.3"])
def test_the_imu_of_the_frame_has_its_own_motion(firmware: str) -> None:
    with emulated_gimbal("--motion", "vehicle", "--firmware", firmware) as gimbal:
        turn_motors_off(gimbal)
        for name in ("gyro", "acc"):
            assert "the frame is not still" in refused(gimbal, name, "--imu", "frame")


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
                shell.type(reply)
                shell.press("Enter")
            shell.wait(end)
            shell.type("clear")
            shell.press("Enter")
            shell.wait(lambda lines: "Continue" not in "".join(lines))


def test_a_camera_that_is_tilted() -> None:
    with emulated_gimbal("--calibration-time", "5") as gimbal:
        tilt = ("move", "--roll", "30", "--speed", "90", "--wait", "--yes")
        assert run(*tilt, "-p", gimbal.address).status == 0
        assert "the camera is not level: its roll angle is 30 deg" in refused(
            gimbal, "flight-controller"
        )
        turn_motors_off(gimbal)
        assert "not level: its roll angle" in refused(gimbal, "encoders")
        assert re.search(
            r"no side of the sensor points up: the nearest one is (29|30|31) deg off",
            refused(gimbal, "acc"),
        )
        assert calibrate(gimbal, "acc", "--yes", "--no-check").status == 0


@pytest.mark.parametrize("name", ["poles", "encoder-field", "orientation", "cogging"])
@pytest.mark.parametrize(
    "fault, words",
    [
        ("imbalance=0.3:pitch", "the pitch axis is out of balance: "),
        ("emergency-stop", "the board reports ERR_EMERGENCY_STOP, with which the motors do not"),
    ],
)
def test_motors_that_could_not_turn_the_camera(name: str, fault: str, words: str) -> None:
    with emulated_gimbal("--firmware", "2.70", "--fault", fault) as gimbal:
        motors = [f"motors.{axis}.angle=90" for axis in ("roll", "pitch", "yaw")]
        values = ("action=CALIBRATE", "axes=ROLL", "iterations_num=2", *motors)
        time.sleep(3)  # the board measures the balance
        assert words in refused(gimbal, name, *(values if name == "cogging" else ()))


def test_motors_without_power(gimbal: EmulatedGimbal) -> None:
    powers = [f"axes.{axis}.power" for axis in ("roll", "pitch", "yaw")]
    for power in ("0", "100"):
        changes = [f"{path}={power}" for path in powers]
        assert run("params", "set", *changes, "--yes", "-p", gimbal.address).status == 0
        if power == "0":
            assert "the power of all motors is 0" in refused(gimbal, "poles")


@pytest.mark.parametrize("voltage", ["126V", "1.64V"])
def test_a_voltage_that_is_mistyped(gimbal: EmulatedGimbal, voltage: str) -> None:
    problem = refused(gimbal, "battery", "--voltage", voltage)
    assert re.search(rf"measures 16\.\d\d V, which is far from {voltage[:-1]}", problem)


def test_the_six_positions_are_offered_one_after_another(tmp_path: Path) -> None:
    options = ("--calibration-time", "5", "--fault", "calib-acc")
    with emulated_gimbal(*options) as gimbal, terminal(tmp_path, 100, 30) as shell:
        shell.run("calibrate", "acc", "-p", gimbal.address)
        for question in ("Continue", "The motors are on", "Turn another"):
            shell.wait(question)
            shell.wait(lambda lines: "".join(lines).rstrip().endswith("[y/N]"))
            shell.type("y")
            shell.press("Enter")
        shell.wait("this side of the sensor was up before; turn another one upwards")
        lines = shell.lines()
        assert any("not +X, -X, +Y, -Y, -Z" in line for line in lines)
        assert sum("is done" in line for line in lines) == 1
