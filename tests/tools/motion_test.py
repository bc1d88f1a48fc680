"""Moving the camera with the sbgc command."""

from __future__ import annotations

import os
import pty
import re
import resource
import signal
import struct
import subprocess
import termios
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from board_command import Terminal, Watched
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from gimbal_observer import Observer, observer_of
from optical_axis import degrees_down, degrees_right, right_side_down
from relay import relay_to
from sbgc_command import MODEL, PROGRAM, frame, run

SPEED_STEP = 0.1220740379
"""Degrees per second of a unit of speed."""

READING = {
    message["id"]
    for message in MODEL["messages"]
    if (message["effect"] or {}).get("does") == ["reads"]
}
"""Commands that change nothing."""

CONTROL = 67


@pytest.fixture(name="gimbal", scope="module")
def one_gimbal() -> Iterator[EmulatedGimbal]:
    with emulated_gimbal() as gimbal:
        yield gimbal


@pytest.fixture(name="observer", scope="module")
def one_observer(gimbal: EmulatedGimbal) -> Iterator[Observer]:
    with observer_of(gimbal) as observer:
        yield observer


def test_the_camera_goes_where_the_question_said() -> None:
    """And a relative way past two turns wraps, as the angles of boards do."""
    with emulated_gimbal() as gimbal:
        there = ("--speed", "500", "--wait", "--yes", "-p", gimbal.address)
        assert run("move", "--yaw", "710", *there).status == 0
        result = run("move", "--yaw", "20", "--relative", *there)
        assert result.status == 0, result
        asked = re.search(r"to ([\d.]+) deg left \(now ([\d.]+) right: right by 20\)", result.error)
        ended = re.search(r"The camera is at ([\d.]+) deg left", result.error)
        assert asked and ended and float(ended[1]) == pytest.approx(float(asked[1]), abs=0.6)


@pytest.mark.parametrize("firmware", ["2.43b9", "2.70b0"])
def test_a_speed_lasts_for_its_time(firmware: str) -> None:
    with emulated_gimbal("--firmware", firmware) as gimbal, observer_of(gimbal) as observer:
        before = observer.angles()[2]
        result = run("speed", "--yaw", "5", "--for", "1s", "--yes", "-p", gimbal.address)
        assert result.status == 0, result
        assert not observer.is_turning()
        assert observer.angles()[2] == pytest.approx(before + 5, abs=2)
        assert "The camera has stopped" in result.error


def test_a_camera_whose_line_is_lost_while_it_stops_may_still_turn() -> None:
    with emulated_gimbal() as gimbal:
        arguments = ("speed", "--yaw", "5", "--for", "200ms", "--yes", "-p", gimbal.address)
        turning = Watched(*arguments)
        turning.wait_for("CMD_CONTROL ")
        gimbal.process.send_signal(signal.SIGSTOP)
        turning.wait_for("MODE_SPEED\n")  # with speed 0
        gimbal.kill()
        ended = turning.end()
        assert ended.status == 1, ended
        assert "the camera may still turn" in ended.error
        assert "The camera has stopped" not in ended.error


def test_stop_needs_no_arming(gimbal: EmulatedGimbal, observer: Observer) -> None:
    arguments = ("move", "--yaw", "200", "--speed", "20", "--yes")
    assert run(*arguments, "-p", gimbal.address).status == 0
    assert observer.is_turning()
    assert run("stop", "-p", gimbal.address).status == 0
    assert not observer.is_turning()
    assert observer.angles()[2] < 100


def test_stop_notices_that_something_else_turns_the_camera() -> None:
    with emulated_gimbal() as gimbal, emulated_speed(gimbal):
        result = run("stop", "-p", gimbal.address)
        assert result.status == 1 and re.search(r"yaw at \d\.\d+ deg/s", result.error)


def test_a_move_that_something_else_prevents_ends() -> None:
    """With 10 seconds more than the way takes."""
    with emulated_gimbal() as gimbal, emulated_speed(gimbal):
        arguments = ("move", "--yaw", "-20", "--speed", "200", "--wait", "--yes")
        result = run(*arguments, "-p", gimbal.address)
        assert result.status == 1
        time_given = re.search(r"the camera did not arrive within (\d+) ms: yaw is", result.error)
        assert time_given and 10_000 < int(time_given[1]) < 12_000, result.error


@contextmanager
def emulated_speed(gimbal: EmulatedGimbal) -> Iterator[None]:
    """Another program that turns the camera all the time, without a look."""
    control = frame(CONTROL, struct.pack("<B6h", 1, 0, 0, 0, 0, 41, 0))  # 5 deg/s
    is_over = threading.Event()
    with observer_of(gimbal) as other, observer_of(gimbal) as observer:

        def turn() -> None:
            while not is_over.wait(0.05):
                other.line.sendall(control)

        thread = threading.Thread(target=turn)
        thread.start()
        try:
            observer.await_motion()
            yield
        finally:
            is_over.set()
            thread.join()


def test_a_signal_but_ctrl_c_interrupts_a_speed_without_a_time() -> None:
    with emulated_gimbal() as gimbal, observer_of(gimbal) as observer:
        terminal = Terminal("speed", "--yaw", "5", "--yes", "-p", gimbal.address)
        observer.await_motion()
        os.kill(terminal.process, signal.SIGTERM)
        assert terminal.status() == 130


def test_ctrl_c_ends_jog_with_its_status() -> None:
    with emulated_gimbal() as gimbal:
        terminal = Terminal("jog", "--yes", "-p", gimbal.address)
        terminal.await_text(b"q: quit")
        terminal.press(b"\x03")
        assert terminal.status() == 130


def test_reset_waits_for_a_port_that_disappears(tmp_path: Path) -> None:
    link = tmp_path / "gimbal"
    with emulated_gimbal("--link", str(link)) as gimbal:
        before = processor_time_of_children()
        resetting = Watched("reset", "--yes", "-p", str(link))
        resetting.wait_for("line: 115200", 2)  # it connects again
        gimbal.kill()
        link.unlink()  # as an adapter without power
    time.sleep(2)
    with emulated_gimbal("--link", str(link)):
        ended = resetting.end()
        assert ended.status == 0 and "The board is back" in ended.error
        assert processor_time_of_children() - before < 1


def test_a_reset_that_the_board_does_not_confirm_is_an_error(gimbal: EmulatedGimbal) -> None:
    def lose_reset(data: bytes) -> bytes:
        return b"" if data[1] == 114 else data

    with relay_to(gimbal.address, lose_reset) as address:
        result = run("reset", "--yes", "-p", address)
    assert result.status == 1 and "back" not in result.error
    assert "the board has not confirmed that it restarts: no response to CMD_RESET" in result.error


def processor_time_of_children() -> float:
    """Seconds, of those that have ended."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


@pytest.mark.parametrize(
    "arguments",
    [
        ("move", "--pitch", "5"),
        ("speed", "--yaw", "5", "--for", "1s"),
        ("motors", "on"),
        ("motors", "off"),
        ("menu", "profile1"),
        ("menu", "calib_gyro"),
        ("reset",),
    ],
)
def test_nothing_happens_unarmed(gimbal: EmulatedGimbal, arguments: tuple[str, ...]) -> None:
    """Without a terminal to ask on, the board is only read."""
    sent: set[int] = set()

    def note(data: bytes) -> bytes:
        sent.add(data[1])
        return data

    with relay_to(gimbal.address, note) as address:
        result = run(*arguments, "-p", address)
    assert result.status == 1
    assert "add --yes" in result.error
    # Motors off need no answer to be asked for.
    assert sent <= READING and (sent or arguments == ("motors", "off"))


# The keyboard


def test_jog_turns_while_a_key_is_held() -> None:
    with emulated_gimbal() as gimbal, observer_of(gimbal) as observer:
        terminal = Terminal("jog", "-p", gimbal.address)
        before = termios.tcgetattr(terminal.screen)
        terminal.await_text(b"[y/N]")
        assert terminal.shown.startswith(
            b"Up looks up, and down looks down: the reverse of sbgc 0.1"
        )
        terminal.press(b"y\n")
        terminal.await_text(b"q: quit")
        terminal.await_text(b"speed 10 deg/s")
        assert not termios.tcgetattr(terminal.screen)[3] & (termios.ICANON | termios.ECHO)
        terminal.hold((b"\033[C", b"d"), lambda: observer.angles()[2] > 12)
        assert observer.stands_still_within(10), "the key is no longer held"
        terminal.press(b"+")
        terminal.await_text(b"speed 20 deg/s")
        terminal.hold((b"w",), observer.is_turning)
        terminal.press(b" ")
        assert observer.stands_still_within(10)
        assert degrees_down(observer.motors()) < 0, "w turns it up"
        terminal.press(b"q")
        terminal.await_text(b"The camera has stopped")
        after = termios.tcgetattr(terminal.screen)
        assert after[:4] == before[:4], "the terminal is restored"
        assert terminal.status() == 0


def test_every_key_of_jog_turns_the_camera_where_it_says(tmp_path: Path) -> None:
    """By the motors' angles: with a level frame, the optical axis."""
    capture = tmp_path / "jog.sbgcap"
    keys = [
        (b"w", degrees_down, -1),
        (b"d", degrees_right, 1),
        (b"c", right_side_down, 1),
        (b"s", degrees_down, 1),
        (b"a", degrees_right, -1),
        (b"z", right_side_down, -1),
        (b"\033[A", degrees_down, -1),
        (b"\033[C", degrees_right, 1),
        (b"\033[B", degrees_down, 1),
        (b"\033[D", degrees_right, -1),
    ]
    with emulated_gimbal() as gimbal, observer_of(gimbal) as observer:
        terminal = Terminal("jog", "--yes", "-p", gimbal.address, "--capture", str(capture))
        terminal.await_text(b"speed 10 deg/s")
        for key, direction, sign in keys:
            before = direction(observer.motors())
            terminal.hold((key,), lambda: abs(direction(observer.motors()) - before) > 1)
            assert (direction(observer.motors()) - before) * sign > 0, key
            terminal.press(b" ")
        terminal.press(b"q")
        assert terminal.status() == 0
    speeds = {angle["speed"] for angle in commanded(capture)}
    assert speeds == {0, round(10 / SPEED_STEP)}


def test_space_stops_a_jog_before_it_turns(tmp_path: Path) -> None:
    capture = tmp_path / "jog.sbgcap"
    with emulated_gimbal() as gimbal:
        terminal = Terminal("jog", "--yes", "-p", gimbal.address, "--capture", str(capture))
        terminal.await_text(b"speed 10 deg/s")
        terminal.press(b"w +")
        terminal.await_text(b"speed 20 deg/s")
        terminal.press(b"q")
        assert terminal.status() == 0
    assert {angle["speed"] for angle in commanded(capture)} <= {0}


def commanded(capture: Path) -> list[dict[str, int]]:
    """The speeds and angles of each axis in what a capture commands."""
    sent = run("decode", "--format", "jsonl", "-m", "Control", str(capture)).objects
    return [axis for frame in sent for axis in frame["fields"]["axes"].values()]


def test_jog_ends_with_its_terminal() -> None:
    with emulated_gimbal() as gimbal, observer_of(gimbal) as observer:
        terminal = Terminal("jog", "--yes", "-p", gimbal.address)
        terminal.await_text(b"q: quit")
        terminal.hold((b"d",), observer.is_turning)
        terminal.press(b"d" * 20)
        os.close(terminal.screen)
        assert observer.stands_still_within(2)
        status = os.waitstatus_to_exitcode(os.waitpid(terminal.process, 0)[1])
        assert status in (0, 130)


def test_jog_needs_a_terminal() -> None:
    outside, inside = pty.openpty()
    arguments = [PROGRAM, "jog", "--yes", "-p", "tcp:127.0.0.1:1"]
    unseen = subprocess.run(
        arguments, stdin=inside, stderr=subprocess.PIPE, timeout=60, check=False
    )
    os.close(inside)
    os.close(outside)
    assert unseen.returncode == 1 and b"jog needs a terminal" in unseen.stderr


@pytest.mark.parametrize("command", ["move --pitch 5 --wait", "speed --yaw 5 --for 1s", "jog"])
def test_ctrl_c_at_the_question_moves_nothing(
    gimbal: EmulatedGimbal, observer: Observer, command: str
) -> None:
    terminal = Terminal(*command.split(), "-p", gimbal.address)
    terminal.await_text(b"[y/N]")
    terminal.press(b"\x03")
    assert terminal.status() == -signal.SIGINT
    assert not observer.is_turning()


def test_jog_asks_nothing_while_the_motors_are_off() -> None:
    with emulated_gimbal() as gimbal:
        assert run("motors", "off", "--yes", "-p", gimbal.address).status == 0
        terminal = Terminal("jog", "-p", gimbal.address)
        assert terminal.status() == 1
        assert b"the motors are off" in terminal.shown and b"[y/N]" not in terminal.shown
