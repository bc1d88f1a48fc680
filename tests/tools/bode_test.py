"""sbgc bode: recordings of an emulated gimbal, and files."""

from __future__ import annotations

import cmath
import math
import random
import re
import signal
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

import pytest
from board_command import limit_files
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from sbgc_command import PROGRAM, Result, run

SHORT = ("--gain", "1000", "--from", "6", "--to", "200")
LONG = ("--seconds", "20")


@pytest.fixture(name="gimbal", scope="module")
def one_gimbal() -> Iterator[EmulatedGimbal]:
    with emulated_gimbal() as gimbal:
        assert run("motors", "on", "--yes", "-p", gimbal.address).status == 0
        yield gimbal


def bode(gimbal: EmulatedGimbal, *arguments: str) -> Result:
    return run("bode", *arguments, "--yes", "-p", gimbal.address)


def plant(frequency: float) -> complex:
    """The emulated axis: two poles at 40 Hz, damping 0.3, a delay of one sample, 0.003 at rest."""
    turn = 2 * math.pi * 40 * 0.0008
    pole = cmath.exp(turn * complex(-0.3, math.sqrt(1 - 0.09)))
    z = cmath.exp(2j * math.pi * frequency * 0.0008)
    return 0.003 * abs(1 - pole) ** 2 * z / ((z - pole) * (z - pole.conjugate()))


def rows_of(text: str) -> list[tuple[float, float, float, str]]:
    rows = [line.split() for line in text.splitlines()[1:]]
    return [(float(f), float(gain), float(phase), coherence) for f, gain, phase, coherence in rows]


def test_a_recording_shows_the_resonance(gimbal: EmulatedGimbal, tmp_path: Path) -> None:
    csv, svg = tmp_path / "roll.csv", tmp_path / "roll.svg"
    options = ("--gain", "3000", "--from", "6", "--to", "200", "--seconds", "4.5")
    result = bode(gimbal, "roll", *options, "-o", str(csv), "--svg", str(svg), "--table")
    assert result.status == 0, result
    assert "The roll axis shakes for 4.5 s" in " ".join(result.error.split())
    lines = csv.read_text().splitlines()
    assert lines[0] == "%sbgc_test_data;70;0;1;3000;6;200"
    assert len(lines) == 1 + 5625
    certain = [row for row in rows_of(result.text) if float(row[3]) > 0.99]
    assert len(certain) > 50
    close = 0
    for frequency, gain, phase, _ in certain:  # tests/client checks it more strictly
        truth = plant(frequency)
        turned = math.remainder(phase - math.degrees(cmath.phase(truth)), 360)
        close += abs(gain - 20 * math.log10(abs(truth))) < 0.7 and abs(turned) < 5
    assert close > 0.9 * len(certain)
    drawn = ElementTree.parse(svg).getroot()
    texts = {element.text for element in drawn.iter() if element.text}
    assert {"Gain in dB", "Phase in degrees", "roll", "10", "100"} < texts
    again = run("bode", "--read", str(csv), "--table")
    assert again.text == result.text


def test_several_positions_have_a_file_each(gimbal: EmulatedGimbal, tmp_path: Path) -> None:
    folder = tmp_path / "recordings"
    at = ("--at", "0,-4", "--at", "3,0")
    result = bode(gimbal, "pitch", *SHORT, *at, "-o", str(folder))
    assert result.status == 0, result
    legs = (
        r"The camera turns to roll 0 deg .*, 4 deg up \(now .*: up by [\d.]+\); "
        r"then to roll 3 deg \(from 0: by 3\), pitch 0 deg \(from 4 up: down by 4\); "
        r"then back to roll .*, at up to 20 deg/s\."
    )
    assert re.search(legs, " ".join(result.error.split())), result.error
    names = sorted(path.name for path in folder.iterdir())
    assert [re.sub(r"Y-?\d+", "Y", name) for name in names] == [
        "PITCH_R0_P-4_Y.csv",
        "PITCH_R3_P0_Y.csv",
    ]
    assert all(len((folder / name).read_text().splitlines()) == 5001 for name in names)
    again = bode(gimbal, "pitch", *SHORT, *at, "-o", str(folder), "-v")
    assert again.status == 1 and f"{names[0]} exists" in again.error
    assert "CMD_BODE_TEST" not in again.error and "CMD_CONTROL" not in again.error


def interrupted(
    gimbal: EmulatedGimbal, file: Path, *options: str, signals: int, number: int = signal.SIGINT
) -> tuple[int, str, float]:
    """Sends signals while the camera shakes. Returns status, remarks, and seconds until the end."""
    command = [
        "bode",
        "yaw",
        *SHORT,
        "-v",
        "-o",
        str(file),
        *options,
        "--yes",
        "-p",
        gimbal.address,
    ]
    with subprocess.Popen([PROGRAM, *command], stderr=subprocess.PIPE) as process:
        assert process.stderr is not None
        for line in process.stderr:  # the frames are printed
            if b"CMD_BODE_TEST_DATA" in line:
                break
        begin = time.monotonic()
        process.send_signal(number)
        for line in process.stderr:
            if signals == 1 or b"Interrupted" in line:
                break
        for _ in range(signals - 1):
            time.sleep(0.6)  # what comes sooner is no second press of a person
            process.send_signal(number)
        text = process.stderr.read().decode()
        status = process.wait(30)
    return status, " ".join(text.split()), time.monotonic() - begin


def test_a_terminal_that_closes_does_not_turn_the_motors_off(
    gimbal: EmulatedGimbal, tmp_path: Path
) -> None:
    file = tmp_path / "yaw.csv"
    status, text, _ = interrupted(gimbal, file, signals=2, number=signal.SIGHUP)
    assert status == 130 and "the recording is complete" in text
    assert "CMD_MOTORS_OFF" not in text and file.exists()


def test_the_first_ctrl_c_waits_and_saves(gimbal: EmulatedGimbal, tmp_path: Path) -> None:
    file = tmp_path / "yaw.csv"
    status, text, seconds = interrupted(gimbal, file, signals=1)
    assert (status, seconds > 2) == (130, True), text
    assert "the recording is complete" in text
    assert len(file.read_text().splitlines()) == 5001


def test_the_second_ctrl_c_turns_the_motors_off(tmp_path: Path) -> None:
    file = tmp_path / "yaw.csv"
    with emulated_gimbal() as gimbal:
        run("motors", "on", "--yes", "-p", gimbal.address)
        status, text, seconds = interrupted(gimbal, file, *LONG, signals=2)
        assert (status, seconds < 15) == (130, True), text
        assert "interrupted; the motors are off" in text
        assert not file.exists()
        refused = bode(gimbal, "yaw", *SHORT, "--table")
        assert refused.status == 1 and "motors are off" in refused.error


def test_on_cancel_motors_off_needs_one(tmp_path: Path) -> None:
    with emulated_gimbal() as gimbal:
        run("motors", "on", "--yes", "-p", gimbal.address)
        off = (*LONG, "--on-cancel", "motors-off")
        status, text, seconds = interrupted(gimbal, tmp_path / "yaw.csv", *off, signals=1)
        assert (status, seconds < 15) == (130, True), text
        assert "interrupted; the motors are off" in text


def begun(address: str, *options: str) -> subprocess.Popen[bytes]:
    """Starts a recording; returns once it sends samples."""
    command = ["bode", "yaw", *SHORT, "--table", "-v", "--yes", "-p", address, *options]
    process = subprocess.Popen([PROGRAM, *command], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert process.stderr is not None
    for line in process.stderr:
        if b"CMD_BODE_TEST_DATA" in line:
            break
    return process


def test_a_recording_that_fails_after_ctrl_c_ends_as_interrupted() -> None:
    with emulated_gimbal() as gimbal:
        assert run("motors", "on", "--yes", "-p", gimbal.address).status == 0
        with begun(gimbal.address) as process:
            process.send_signal(signal.SIGINT)
            assert run("motors", "off", "--yes", "-p", gimbal.address).status == 0
            out, error = process.communicate(timeout=30)
        text = " ".join(error.decode().split())
        assert process.returncode == 130 and not out, text
        assert "interrupted; the recording has started, but it failed" in text


def test_after_kill_9_the_recording_that_goes_on_is_not_that_of_the_next(tmp_path: Path) -> None:
    with emulated_gimbal("--pty", "--link", f"{tmp_path}/gimbal") as gimbal:
        address = gimbal.address_with_rate
        assert run("motors", "on", "--yes", "-p", address).status == 0
        with begun(address, "--seconds", "8") as process:
            process.kill()
        file = tmp_path / "yaw.csv"
        again = ("bode", "yaw", *SHORT, "-o", str(file), "--yes", "-p", address)
        end = time.monotonic() + 30
        # Its guard still stops the camera.
        while "is in use by" in (refused := run(*again)).error and time.monotonic() < end:
            continue
        text = " ".join(refused.error.split())
        assert refused.status == 1 and not file.exists(), text
        # A busy machine may delay its data, so that only the refusal tells.
        reasons = "an earlier recording, which no command ends", "WRONG_STATE; a recording of this"
        assert any(reason in text for reason in reasons), text
        assert "a recording of this command lasts at most 60 s" in text
        # A busy machine may hear nothing of it; then the board refuses, and a guard stops again.
        other = "an earlier recording|is in use by|CMD_BODE_TEST_START_STOP: the board ref"
        while (result := run(*again)).status != 0 and time.monotonic() < end:
            assert re.search(other, " ".join(result.error.split()))
        assert result.status == 0, result
        assert len(file.read_text().splitlines()) == 5001
        assert "lost" not in result.error


def test_a_file_of_the_vendor(tmp_path: Path) -> None:
    numbers = random.Random(1)
    inputs = [numbers.gauss(0, 1000) for _ in range(5000)]
    rows = "".join(f"{one};{-0.1 * one}\n" for one in inputs)
    file = tmp_path / "<&.csv"
    file.write_text("%sbgc_test_data;70;0;1;3000;6;200\n" + rows)
    picture = tmp_path / "two.svg"
    result = run("bode", "--read", str(file), str(file), "--table", "--svg", str(picture))
    assert result.status == 0
    first, second = result.text.split("\n\n")
    assert first.splitlines()[0] == str(file) and first.splitlines()[1:] == second.splitlines()[1:]
    found = rows_of("\n".join(first.splitlines()[1:]))
    assert len(found) == 159
    for _, gain, phase, coherence in found:
        assert (gain, abs(phase), coherence) == (-20, 180, "1.000")
    assert ElementTree.parse(picture).getroot().tag.endswith("svg")


def test_a_short_file_has_no_coherence(tmp_path: Path) -> None:
    file = tmp_path / "short.csv"
    rows = "".join(f"{math.sin(i * i)};{math.sin(i * i)}\n" for i in range(2000))
    file.write_text("%sbgc_test_data;70;0;1;3000;6;200\n" + rows)
    result = run("bode", "--read", str(file), "--table")
    assert result.status == 0 and "too short for the coherence" in result.error
    assert {row[3] for row in rows_of(result.text)} == {"-"}
    file.write_text("%sbgc_test_data;70;0;1;3000;6;200\n1;2\n")
    result = run("bode", "--read", str(file), "--table")
    assert result.status == 1 and "too few samples" in result.error
    file.write_text("%sbgc_test_data;70;0;1;3000;6;200\n1;2\n3\n")
    result = run("bode", "--read", str(file), "--table")
    assert result.status == 1 and "short.csv: line 3: not two numbers" in result.error


ASKED = {
    "CMD_REALTIME_DATA_3": (),
    "CMD_REALTIME_DATA_4": (),
    "CMD_REALTIME_DATA_CUSTOM": ("config.flags=IMU_ANGLES|INCLUDE_FLAGS",),
    "CMD_REALTIME_DATA_CUSTOM2": ("config.custom2_flags=DEBUG|INCLUDE_FLAGS",),
    "CMD_AHRS_HELPER": ("config.imu_type=FRAME",),
    "CMD_EXT_MOTORS_STATE": ("config.motor=2", "config.data_set=ANGLE16|SPEED16"),
}


def begin_stream(address: str, stream: str, *config: str) -> None:
    start = ("send", "CMD_DATA_STREAM_INTERVAL", "--yes", "-p", address)
    result = run(*start, f"cmd_id={stream}", "interval_ms=40", *config)
    assert result.status == 0, result


def frames(result: Result) -> list[str]:
    return [line for line in result.error.splitlines() if "CMD_" in line]


@pytest.mark.parametrize("stream", ASKED)
def test_streams_that_run_are_paused_and_go_on(stream: str, tmp_path: Path) -> None:
    """Those of the same port: another host has left them there."""
    newest = ("--board", "3.6", "--firmware", "2.74.5")
    with emulated_gimbal("--pty", "--link", f"{tmp_path}/gimbal", *newest) as gimbal:
        address = gimbal.address_with_rate
        assert run("motors", "on", "--yes", "-p", address).status == 0
        for attempt in range(5):  # the line bunches the samples while the machine is busy
            begin_stream(address, stream, *ASKED[stream])
            file = str(tmp_path / f"{attempt}.csv")
            result = run("bode", "roll", *SHORT, "-o", file, "--yes", "-v", "-p", address)
            assert result.status == 0, result
            text = " ".join(result.error.split())
            said = re.search(
                f"The data stream of {stream} is paused.* every (\\d+) ms as measured", text
            )
            assert said, text
            if int(said[1]) in range(20, 81):
                break
        assert said and int(said[1]) in range(20, 81)
        lines = frames(result)
        begin = next(i for i, line in enumerate(lines) if "CMD_BODE_TEST_DATA" in line)
        end = max(i for i, line in enumerate(lines) if "CMD_BODE_TEST_DATA" in line)
        from_board = [f"{stream} (" in line and "board to host" in line for line in lines]
        assert any(from_board[:begin]) and not any(from_board[begin:end])
        again = result.error.split("CMD_DATA_STREAM_INTERVAL (85)  host to board")[-1]
        assert re.search(f"interval_ms +{said[1]} ", again), again
        for part in ASKED[stream]:
            for word in re.findall(r"\w+", part.split("=")[1]):
                assert word in again, again


def test_a_stream_that_nobody_knows_to_end_goes_on(tmp_path: Path) -> None:
    with emulated_gimbal("--pty", "--link", f"{tmp_path}/gimbal") as gimbal:
        address = gimbal.address_with_rate
        assert run("motors", "on", "--yes", "-p", address).status == 0
        begin_stream(address, "CMD_REALTIME_DATA_CUSTOM", "config.flags=IMU_ANGLES")
        file = tmp_path / "roll.csv"
        result = run("bode", "roll", *SHORT, "-o", str(file), "--yes", "-p", address)
        assert result.status == 0 and file.exists(), result
        text = " ".join(result.error.split())
        assert "CMD_REALTIME_DATA_CUSTOM goes on, because only its host knows how to end it" in text


def test_a_full_disk_loses_no_table(gimbal: EmulatedGimbal, tmp_path: Path) -> None:
    file = tmp_path / "roll.csv"
    command = ["bode", "roll", *SHORT, "-o", str(file), "--table", "--yes", "-p", gimbal.address]
    done = run(*command, preexec_fn=lambda: limit_files(1000))
    assert done.status == 1 and not file.exists()
    assert f"cannot write {file}: File too large" in " ".join(done.error.split())
    assert len(rows_of(done.text)) == 159
