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
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from sbgc_command import PROGRAM, Result, run

SHORT = ("--gain", "1000", "--from", "6", "--to", "200", "--seconds", "1")


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
    options = ("--gain", "3000", "--from", "6", "--to", "200", "--seconds", "2.5")
    result = bode(gimbal, "roll", *options, "-o", str(csv), "--svg", str(svg), "--table")
    assert result.status == 0, result
    assert "The roll axis shakes for 2.5 s" in " ".join(result.error.split())
    lines = csv.read_text().splitlines()
    assert lines[0] == "%sbgc_test_data;70;0;1;3000;6;200"
    assert len(lines) == 1 + 3125
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
    assert "turns to 2 positions before" in " ".join(result.error.split())
    names = sorted(path.name for path in folder.iterdir())
    assert [re.sub(r"Y-?\d+", "Y", name) for name in names] == [
        "PITCH_R0_P-4_Y.csv",
        "PITCH_R3_P0_Y.csv",
    ]
    assert all(len((folder / name).read_text().splitlines()) == 1251 for name in names)


def interrupted(
    gimbal: EmulatedGimbal, file: Path, *options: str, signals: int, number: int = signal.SIGINT
) -> tuple[int, str, float]:
    """Sends signals while the camera shakes. Returns status, remarks, and seconds until the end."""
    short = ("--gain", "1000", "--from", "6", "--to", "200", "--seconds", "3", "-v")
    command = ["bode", "yaw", *short, "-o", str(file), *options, "--yes", "-p", gimbal.address]
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
    assert (status, seconds > 1.5) == (130, True), text
    assert "the recording is complete" in text
    assert len(file.read_text().splitlines()) == 3751


def test_the_second_ctrl_c_turns_the_motors_off(tmp_path: Path) -> None:
    file = tmp_path / "yaw.csv"
    with emulated_gimbal() as gimbal:
        run("motors", "on", "--yes", "-p", gimbal.address)
        status, text, seconds = interrupted(gimbal, file, signals=2)
        assert (status, seconds < 2.5) == (130, True), text
        assert "interrupted; the motors are off" in text
        assert not file.exists()
        refused = bode(gimbal, "yaw", *SHORT, "--table")
        assert refused.status == 1 and "motors are off" in refused.error


def test_on_cancel_motors_off_needs_one(tmp_path: Path) -> None:
    with emulated_gimbal() as gimbal:
        run("motors", "on", "--yes", "-p", gimbal.address)
        off = ("--on-cancel", "motors-off")
        status, text, seconds = interrupted(gimbal, tmp_path / "yaw.csv", *off, signals=1)
        assert (status, seconds < 2.5) == (130, True), text
        assert "interrupted; the motors are off" in text


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


@pytest.mark.parametrize(
    "arguments, words",
    [
        (("roll", *SHORT), "-o, --table or --svg"),
        (SHORT + ("--table",), "say the axis"),
        (("roll", "--table"), "say --gain, --from and --to"),
        (("roll", *SHORT[2:], "--gain", "10001", "--table"), "10001"),
        (("roll", *SHORT[:-2], "--seconds", "61", "--table"), "61"),
        (
            ("roll", "--gain", "1", "--from", "9", "--to", "8", "--table"),
            "--from 9 is above --to 8",
        ),
        (("roll", *SHORT, "--table", "--at", "5"), "'5' is not ROLL,PITCH"),
        (("roll", *SHORT, "--table", "--at", "5,x"), "'5,x' is not ROLL,PITCH"),
        (("roll", *SHORT, "--table", "--at", "181,0"), "'181,0' is not ROLL,PITCH"),
        (("roll", "--read", "x", "--table"), "takes no axis"),
        (("roll", *SHORT, "--table", "--system", "plant"), "is none of CONTROLLER, OPEN_LOOP"),
    ],
)
def test_wrong_usage(arguments: tuple[str, ...], words: str) -> None:
    result = run("bode", *arguments, "-p", "tcp:127.0.0.1:1")
    assert result.status == 2 and words in " ".join(result.error.split())


def test_streams_that_run_are_paused_and_go_on(tmp_path: Path) -> None:
    """Those of the same port: another host has left them there."""
    with emulated_gimbal("--pty", "--link", f"{tmp_path}/gimbal") as gimbal:
        address = gimbal.address_with_rate
        assert run("motors", "on", "--yes", "-p", address).status == 0
        start = ("send", "CMD_DATA_STREAM_INTERVAL", "--yes", "-p", address)
        assert run(*start, "cmd_id=CMD_REALTIME_DATA_4", "interval_ms=40").status == 0
        file = tmp_path / "roll.csv"
        result = run("bode", "roll", *SHORT, "-o", str(file), "--yes", "-v", "-p", address)
        assert result.status == 0, result
        samples = [line for line in result.error.splitlines() if "CMD_" in line]
        begin = next(i for i, line in enumerate(samples) if "CMD_BODE_TEST_DATA" in line)
        end = max(i for i, line in enumerate(samples) if "CMD_BODE_TEST_DATA" in line)
        assert any("CMD_REALTIME_DATA_4" in line for line in samples[:begin])
        assert not any("CMD_REALTIME_DATA_4" in line for line in samples[begin:end])
        again = [line for line in result.error.splitlines() if "interval_ms" in line]
        assert re.search(r"(39|40|41)", again[-1]), again


def test_it_asks_first(gimbal: EmulatedGimbal) -> None:
    result = run("bode", "roll", *SHORT, "--table", "-p", gimbal.address)
    assert result.status == 1 and "add --yes" in " ".join(result.error.split())


def test_existing_files_are_kept(tmp_path: Path) -> None:
    file = tmp_path / "roll.csv"
    file.write_text("mine")
    result = run("bode", "roll", *SHORT, "-o", str(file), "--yes", "-p", "tcp:127.0.0.1:1")
    assert result.status == 1 and "--force" in result.error
    assert file.read_text() == "mine"
