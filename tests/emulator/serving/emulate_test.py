"""Tests of sbgc emulate: connections, exit, stored state and rejected arguments."""

from __future__ import annotations

import fcntl
import os
import re
import shutil
import signal
import subprocess
import termios
import time
from pathlib import Path

import pytest

from emulator import (
    BOARD_INFO,
    BOARD_INFO_3,
    DATA_STREAM_INTERVAL,
    PATIENCE,
    REALTIME_DATA_4,
    Connection,
    Emulator,
    Terminal,
    refused,
    stream,
    terminal_of,
)
from sbgc_command import PROGRAM, ROOT, Result, frame, run


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_pseudo_terminal_is_the_default(number: int) -> None:
    with Emulator() as emulator:
        (place,) = emulator.places
        assert place.startswith("/dev/pts/")
        terminal = Terminal(place)
        assert len(terminal.ask(BOARD_INFO)) == 18
        terminal.close()
        # A second program connects.
        terminal = Terminal(place)
        assert len(terminal.ask(BOARD_INFO)) == 18
        assert emulator.end(number) == 0
        assert emulator.error == ""
        terminal.close()


def test_many_boards_may_open_more_files_than_the_soft_limit() -> None:
    limited = 'ulimit -S -n 40; exec "$0" emulate --count 30 --seconds 0'
    done = subprocess.run(
        ["sh", "-c", limited, PROGRAM], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0 and "emulated gimbal 30: /dev/pts/" in done.stdout, done


@pytest.mark.parametrize("was_left_behind", [False, True])
def test_link(tmp_path: Path, was_left_behind: bool) -> None:
    link = tmp_path / "gimbal"
    if was_left_behind:
        link.symlink_to("/dev/pts/999999")
    with Emulator("--link", str(link)) as emulator:
        assert emulator.places[0].endswith(f"(also {link})")
        assert Path(os.readlink(link)) == terminal_of(emulator.places[0])
        terminal = Terminal(str(link))
        assert terminal.ask(BOARD_INFO)
        terminal.close()
    assert list(tmp_path.iterdir()) == []


def test_nothing_else_is_replaced_by_a_link(tmp_path: Path) -> None:
    taken = tmp_path / "gimbal"
    taken.write_text("mine")
    assert str(taken) in refused("--link", str(taken))
    assert taken.read_text() == "mine"

    elsewhere = tmp_path / "elsewhere"
    elsewhere.symlink_to(taken)
    assert str(taken) in refused("--link", str(elsewhere))
    assert Path(os.readlink(elsewhere)) == taken

    folder = tmp_path / "folder"
    folder.mkdir()
    refused("--link", str(folder))
    refused("--link", str(tmp_path / "missing" / "gimbal"))

    used = tmp_path / "used"
    with Emulator("--link", str(used)) as emulator:
        assert "in use" in refused("--link", str(used))
        assert Path(os.readlink(used)) == terminal_of(emulator.places[0])
        # The link is replaced by another program.
        used.unlink()
        used.symlink_to(taken)
    assert Path(os.readlink(used)) == taken


def test_many_boards(tmp_path: Path) -> None:
    link = tmp_path / "gimbal"
    options = f"--count 3 --tcp 0 --link {link} --state {tmp_path / 's'}".split()
    with Emulator(*options, boards=3, places=2) as emulator:
        names = sorted(path.name for path in tmp_path.iterdir() if path.suffix != ".sbgc-lock")
        assert names == ["gimbal-1", "gimbal-2", "gimbal-3", "s-1", "s-2", "s-3"]
        told = set()
        for place in emulator.places[1::2]:
            host = Connection(place)
            told.add(host.ask(BOARD_INFO_3)[:21])
        assert len(told) == 3
        for number, place in enumerate(emulator.places[::2]):
            assert Path(os.readlink(f"{link}-{number + 1}")) == terminal_of(place)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["s-1", "s-2", "s-3"]


def test_wrong_baud_rate_is_garbage() -> None:
    with Emulator("--baud", "115200", "--text", "0.05") as emulator:
        terminal = Terminal(emulator.places[0], termios.B57600)
        terminal.send(BOARD_INFO)
        end = time.monotonic() + PATIENCE
        while len(terminal.heard.rpartition(b"\r\n")[2]) < 100:  # several lines without an end
            assert time.monotonic() < end
            terminal.receive(1)
        assert bytes([0x3E, BOARD_INFO, 18]) not in terminal.heard
        terminal.set_rate(termios.B115200)
        assert len(terminal.ask(BOARD_INFO)) == 18
        while b"\r\n" not in terminal.heard:
            assert terminal.receive(PATIENCE)
        terminal.close()


def test_faults() -> None:
    for fault in (["--lose", "100%"], ["--silence", "0:1000"]):
        with Emulator("--tcp", "0", *fault) as emulator:
            host = emulator.host()
            host.send(BOARD_INFO)
            assert not host.receive(0.3)
    with Emulator("--tcp", "0", "--text", "0.05", "--silence", "0:0.2") as emulator:
        host = emulator.host()
        end = time.monotonic() + PATIENCE
        while b"\r\n" not in host.heard and time.monotonic() < end:
            host.receive(1)
        assert b"\r\n" in host.heard


def ends_streams(reset: float) -> bool:
    """Returns False if the first sample comes after the reset, as on a busy machine."""
    end = time.monotonic() + reset
    with Emulator("--tcp", "0", "--reset-at", str(reset)) as emulator:
        host = emulator.host()
        host.ask(DATA_STREAM_INTERVAL, stream(20), answer=REALTIME_DATA_4)
        if time.monotonic() > end:
            return False
        while host.receive(1):
            assert time.monotonic() < end + PATIENCE
        assert time.monotonic() > end and host.ask(BOARD_INFO)
    return True


def test_a_reset_at_a_given_time() -> None:
    assert any(ends_streams(reset) for reset in (2, 10, 50)), "the machine is too busy"


def test_ends_by_itself() -> None:
    begin = time.monotonic()
    with Emulator("--seconds", "0.3") as emulator:
        assert emulator.wait() == 0
    assert time.monotonic() - begin >= 0.3


WRONG = """place; --tcp; --tcp gimbal.example:5000; --udp x; --tcp 65535 --count 2; --count 0;
--stdio --count 2; --firmware 2.5; --firmware 2.75; --board three; --baud 0; --parity odd;
--bit-errors 101%; --delay 0.1:x; --text 0; --silence 5; --reset-at soon; --input-buffer -1;
--seed -1; --motion jump; --link=; --state="""


@pytest.mark.parametrize("arguments", WRONG.split(";"))
def test_wrong_usage(arguments: str) -> None:
    result = run("emulate", *arguments.split())
    assert result.status == 2, result
    assert result.out == b""


def test_motion_files(tmp_path: Path) -> None:
    motion = tmp_path / "motion.csv"
    motion.write_text("time,roll,pitch,yaw\n0,0,0,0\n1,10,0,0\n2,0,zero,0\n")
    result = run("emulate", "--motion", str(motion))
    assert result.status == 2
    assert f"{motion}:4: 'zero' is not a number" in result.error
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    assert f"{pipe} is not a regular file" in run("emulate", "--motion", str(pipe)).error
    motion.write_text("0,0,0,0\n1,10,0,0\n2,0,0,0\n")
    with Emulator("--motion", str(motion)):
        pass


def test_one_demo_at_a_time(tmp_path: Path) -> None:
    shutil.copy(ROOT / "dev", tmp_path)
    (tmp_path / "build").mkdir()
    with open(tmp_path / "build" / "demo.lock", "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        done = subprocess.run(
            [tmp_path / "dev", "demo"],
            capture_output=True,
            timeout=PATIENCE,
            check=False,
        )
    assert done.returncode == 1
    assert b"another demo is running" in done.stderr


def take_the_tour(place: str, folder: Path, *options: str, answer: str = "") -> Result:
    tour = os.environ.get("SBGC_TOUR")
    if not tour:
        pytest.skip("examples are not built")
    command = [tour, place, str(folder / "capture"), str(folder / "backup"), *options]
    done = subprocess.run(
        command, input=answer.encode(), capture_output=True, timeout=60, check=False
    )
    return Result(done.returncode, done.stdout, done.stderr.decode())


def test_the_tour(tmp_path: Path) -> None:
    """Runs the tour as ./dev demo does."""
    with Emulator("--baud", "57600", "--motion", "handheld", "--text", "1") as emulator:
        done = take_the_tour(emulator.places[0], tmp_path, "--yes")
    assert done.status == 0, done
    assert "57600" in done.text
    assert re.search("pitch is (30|29)", done.text)
    swings = {
        name: [float(number) for number in re.findall(r"\d+\.\d+", line)]
        for name, line in re.findall(r"^  (frame|camera) (.*)$", done.text, re.MULTILINE)
    }
    assert len(swings["frame"]) == len(swings["camera"]) == 3
    assert max(swings["frame"]) > 1, "a frame that is held by hand moves"
    for frame, camera in zip(swings["frame"], swings["camera"]):
        assert camera < frame, "the camera is to be steadier than the frame"


def test_the_tour_asks_before_it_moves(tmp_path: Path) -> None:
    with Emulator() as emulator:
        done = take_the_tour(emulator.places[0], tmp_path, answer="no\n")
    assert done.status == 1
    assert "nothing has been moved" in done.text
    said = run("decode", "--format", "jsonl", str(tmp_path / "capture")).objects
    commands = {line["command"] for line in said}
    assert "CMD_READ_PARAMS_3" in commands
    assert not commands & {"CMD_CONTROL", "CMD_MOTORS_ON"}
