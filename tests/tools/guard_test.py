"""The gimbal stops, whatever ends the command that turns it, and the stop is repeated until it is done, on a
line that carries nothing for a while."""

from __future__ import annotations

import os
import random
import signal
import socket
import subprocess
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from board_command import Terminal
from bridge import Host, bridge_to
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from gimbal_observer import Observer, observer_of
from relay import relay_to
from sbgc_command import CRASH, PROGRAM, frame, run

SOON = 2.5
"""Seconds until the camera stands still. At 20 deg/s, without any stop, it would turn for 100 s."""

TURN = ("speed", "--yaw", "20", "--for", "100s", "--yes")


@contextmanager
def turning(
    address: str, *arguments: str, observer: Observer, **options: Any
) -> Iterator[subprocess.Popen[bytes]]:
    """Runs a command that turns the camera."""
    process = subprocess.Popen(
        [PROGRAM, *(arguments or TURN), "-p", address], stderr=subprocess.PIPE, **options
    )
    try:
        observer.await_motion()
        yield process
    finally:
        process.kill()
        process.communicate()


def guard_of(process: subprocess.Popen[bytes]) -> int:
    """Returns the process id of the guard."""
    children = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
    (guard,) = [int(child) for child in children]
    return guard


def command_line(process: int) -> list[str]:
    return Path(f"/proc/{process}/cmdline").read_bytes().decode().split("\0")


def is_running(process: int) -> bool:
    try:
        state = Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()[0]
    except FileNotFoundError:
        return False
    return state != "Z"


def await_end(process: int) -> None:
    deadline = time.monotonic() + 30
    while is_running(process):
        assert time.monotonic() < deadline
        time.sleep(0.02)


def end_of(process: subprocess.Popen[bytes]) -> tuple[int, str]:
    assert process.stderr is not None
    status = process.wait(30)
    error = process.stderr.read().decode()
    assert not CRASH.search(error)
    return status, error


@pytest.mark.parametrize("line", ["pty", "tcp", "udp"])
def test_the_command_is_killed(line: str) -> None:
    places = {"pty": ("--pty", "--tcp", "0"), "tcp": (), "udp": ("--udp", "0", "--tcp", "0")}
    with emulated_gimbal(*places[line]) as gimbal:
        # On UDP, the line of TCP is announced first.
        address = gimbal.address
        if line == "udp":
            assert gimbal.process.stdout is not None
            address = gimbal.process.stdout.readline().split(": ", 1)[1].strip()
        with observer_of(gimbal) as observer, turning(address, observer=observer) as process:
            guard = guard_of(process)
            process.kill()
            assert observer.stands_still_within(SOON)
            await_end(guard)
            assert process.wait(30) == -signal.SIGKILL
            assert not observer.is_turning()
            # The line is free again.
            assert run("stop", "-p", address).status == 0


def test_with_later_firmware_rc_does_not_take_over() -> None:
    """The guard removes the timeout of serial control that the command had set."""
    with emulated_gimbal("--firmware", "2.70b0", "--verbose") as gimbal:
        with observer_of(gimbal) as observer:
            with turning(gimbal.address, observer=observer) as process:
                guard = guard_of(process)
                process.kill()
                assert observer.stands_still_within(SOON)
                await_end(guard)
        gimbal.process.terminate()
        assert gimbal.process.stdout is not None
        frames = gimbal.process.stdout.read()
    requests = [line.split()[4] for line in frames.splitlines() if " > CMD_CONTROL" in line]
    # Set, turned and stopped by two processes, removed before it is over, stopped.
    assert requests[0] == requests[-2] == "CMD_CONTROL_CONFIG", requests
    assert requests.count("CMD_CONTROL_CONFIG") == 2


def test_the_whole_group_of_processes_is_killed() -> None:
    with emulated_gimbal() as gimbal, observer_of(gimbal) as observer:
        with turning(gimbal.address, observer=observer, start_new_session=True) as process:
            os.killpg(process.pid, signal.SIGKILL)
            assert observer.stands_still_within(SOON)


def test_a_move_is_killed() -> None:
    move = ("move", "--yaw", "300", "--speed", "20", "--wait", "--yes")
    with emulated_gimbal() as gimbal, observer_of(gimbal) as observer:
        with turning(gimbal.address, *move, observer=observer) as process:
            process.kill()
            assert observer.stands_still_within(SOON)
            assert observer.angles()[2] < 150


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
@pytest.mark.parametrize("command", ["move", "speed"])
def test_a_signal_stops_the_motion_first(command: str, how: signal.Signals) -> None:
    move = ("move", "--yaw", "300", "--speed", "20", "--wait", "--yes")
    arguments = move if command == "move" else TURN
    with emulated_gimbal() as gimbal, observer_of(gimbal) as observer:
        with turning(gimbal.address, *arguments, observer=observer) as process:
            process.send_signal(how)
            status, error = end_of(process)
            assert not observer.is_turning(), "it had stopped before the command ended"
            assert status == 130
            assert "interrupted; the camera has stopped" in error


def test_the_terminal_disappears() -> None:
    with emulated_gimbal() as gimbal, observer_of(gimbal) as observer:
        terminal = Terminal(*TURN, "-p", gimbal.address)
        observer.await_motion()
        os.close(terminal.screen)
        assert observer.stands_still_within(SOON)
        _, status = os.waitpid(terminal.process, 0)
        assert os.waitstatus_to_exitcode(status) == 130


def test_the_terminal_disappears_with_all_its_processes() -> None:
    with emulated_gimbal() as gimbal, observer_of(gimbal) as observer:
        terminal = Terminal(*TURN, "-p", gimbal.address)
        observer.await_motion()
        os.killpg(terminal.process, signal.SIGKILL)
        os.close(terminal.screen)
        assert observer.stands_still_within(SOON)
        os.waitpid(terminal.process, 0)


def test_the_guard_is_killed() -> None:
    with emulated_gimbal() as gimbal, observer_of(gimbal) as observer:
        with turning(gimbal.address, observer=observer) as process:
            os.kill(guard_of(process), signal.SIGKILL)
            status, error = end_of(process)
            assert not observer.is_turning()
            assert status == 1
            assert "the guard process" in error and "the camera has stopped" in error


def test_the_command_is_suspended() -> None:
    """With older firmware, the camera stops at the last angle by itself."""
    with emulated_gimbal() as gimbal, observer_of(gimbal) as observer:
        with turning(gimbal.address, observer=observer) as process:
            process.send_signal(signal.SIGTSTP)  # Ctrl-Z: ignored
            assert observer.is_turning()
            process.send_signal(signal.SIGSTOP)
            assert observer.stands_still_within(SOON)


def test_the_guard_outlives_what_ends_the_command() -> None:
    with emulated_gimbal() as gimbal, observer_of(gimbal) as observer:
        with turning(gimbal.address, observer=observer) as process:
            guard = guard_of(process)
            assert command_line(guard)[:2] == [
                "sbgc-guard",
                f"stops the gimbal if process {process.pid} dies",
            ]
            assert Path(f"/proc/{guard}/comm").read_text() == "sbgc-guard\n"
            assert os.getsid(guard) == guard
            files = {os.readlink(fd) for fd in Path(f"/proc/{guard}/fd").iterdir()}
            assert "/dev/null" in files and all(
                file == "/dev/null" or file.startswith("socket:") for file in files
            )
            for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT):
                os.kill(guard, number)
            process.kill()
            assert observer.stands_still_within(SOON)
            await_end(guard)


def test_no_guard_remains() -> None:
    with emulated_gimbal() as gimbal:
        arguments = ("speed", "--yaw", "20", "--for", "200ms", "--yes", "-p", gimbal.address)
        with subprocess.Popen([PROGRAM, *arguments], stderr=subprocess.DEVNULL) as process:
            assert process.wait(30) == 0
        purpose = f"stops the gimbal if process {process.pid} dies".encode()
        for path in Path("/proc").glob("[0-9]*/cmdline"):
            try:
                assert purpose not in path.read_bytes()
            except (FileNotFoundError, ProcessLookupError):
                pass  # another process has ended meanwhile


def test_a_line_that_no_guard_can_hold_moves_nothing(tmp_path: Path) -> None:
    with emulated_gimbal() as gimbal:
        capture = tmp_path / "capture"
        assert run("info", "-p", gimbal.address, "--capture", str(capture)).status == 0
    result = run("speed", "--yaw", "5", "--for", "1s", "--yes", "-p", f"capture:{capture}")
    assert result.status == 1
    assert "no guard process can hold it" in result.error


CONTROL = 67
OWED_TURN = bytes([1] * 3) + bytes(8) + bytes([40, 0, 0, 0])  # yaw, 4.9 deg/s
REST = bytes([1] * 3) + bytes(12)


class Line:
    """A line that can carry nothing, and stays open; or that loses a share of its bytes."""

    def __init__(self) -> None:
        self.flows = True
        self.loss = 0.0
        self.random = random.Random(1)

    def change(self, data: bytes) -> bytes:
        if not self.flows:
            return b""
        return bytes(byte for byte in data if self.random.random() >= self.loss)


@contextmanager
def turning_gimbal() -> Iterator[tuple[EmulatedGimbal, Observer, Line, str]]:
    """Yields a gimbal whose camera turns, and the address of a line to it."""
    line = Line()
    with (
        emulated_gimbal("--firmware", "2.59") as gimbal,
        observer_of(gimbal) as observer,
        relay_to(gimbal.address, line.change, line.change) as address,
    ):
        turn(gimbal, observer)
        yield gimbal, observer, line, address


def turn(gimbal: EmulatedGimbal, observer: Observer) -> None:
    _, place, port = gimbal.address.split(":")
    with socket.create_connection((place, int(port))) as other:
        other.sendall(frame(CONTROL, OWED_TURN))
        other.recv(1)
    observer.await_motion()


def start(*arguments: str) -> subprocess.Popen[str]:
    return subprocess.Popen([PROGRAM, *arguments], stderr=subprocess.PIPE, text=True)


def test_a_stop_is_repeated_over_silence() -> None:
    with turning_gimbal() as (_, observer, line, address):
        line.flows = False
        threading.Timer(3, setattr, (line, "flows", True)).start()
        result = run("stop", "-p", address, "--for", "1m")
        assert result.status == 0 and "The camera has stopped" in result.error
        assert "sbgc: not stopped yet: " in result.error
        assert not observer.is_turning()


def test_a_stop_that_does_not_succeed_says_so() -> None:
    with turning_gimbal() as (_, observer, line, address):
        line.flows = False
        begun = time.monotonic()
        result = run("stop", "-p", address, "--for", "2s")
        assert result.status == 1 and result.error.count("not stopped yet") >= 1
        assert time.monotonic() - begun < 10
        assert observer.is_turning()


def test_motors_off_is_repeated_over_silence() -> None:
    with turning_gimbal() as (_, _, line, address):
        line.flows = False
        threading.Timer(2, setattr, (line, "flows", True)).start()
        result = run("motors", "off", "--yes", "-p", address, "--for", "1m")
        assert result.status == 0 and "The motors are off" in result.error
        assert run("stop", "-p", address).error.endswith("its motors are off.\n")


def test_stops_succeed_on_a_line_that_loses_bytes() -> None:
    with turning_gimbal() as (_, observer, line, address):
        line.loss = 0.02
        assert run("stop", "-p", address, "--for", "1m").status == 0
        assert not observer.is_turning()


@pytest.mark.parametrize("command", [("stop",), ("motors", "off", "--yes")])
def test_a_port_that_vanishes_is_awaited(command: tuple[str, ...], tmp_path: Path) -> None:
    link = tmp_path / "gimbal"
    link.symlink_to("/dev/ptmx")  # a port that never answers
    with start(*command, "-p", str(link), "--for", "1m") as process:
        assert process.stderr is not None
        while "not stopped yet" not in process.stderr.readline():
            assert process.poll() is None
        link.unlink()
        while "not stopped yet: There is no port" not in process.stderr.readline():
            assert process.poll() is None
        with emulated_gimbal("--pty", "--link", str(link)):
            assert process.wait(60) == 0


@pytest.mark.parametrize("address", ["tcp:127.0.0.1", "/dev/does-not-exist"])
def test_what_cannot_succeed_ends_at_once(address: str) -> None:
    begun = time.monotonic()
    assert run("stop", "-p", address, "--for", "1m").status != 0
    assert time.monotonic() - begun < 30


def test_ctrl_c_says_that_the_camera_may_turn() -> None:
    with turning_gimbal() as (_, _, line, address):
        line.flows = False
        with start("stop", "-p", address) as process:
            assert process.stderr is not None
            assert "not stopped yet" in process.stderr.readline()
            process.send_signal(signal.SIGHUP)
            assert "not stopped yet" in process.stderr.readline()
            process.send_signal(signal.SIGINT)
            rest = process.stderr.read()
        assert process.returncode == 130 and "the camera may still turn" in rest


def test_a_bridge_goes_on_with_the_stop_of_a_program_that_leaves() -> None:
    with turning_gimbal() as (_, observer, line, address), bridge_to(address) as bridge:
        host = Host(bridge.address)
        line.flows = False
        host.socket.sendall(frame(CONTROL, REST))
        time.sleep(0.2)
        host.close()
        time.sleep(1)
        line.flows = True
        assert observer.stands_still_within(20)


def test_a_program_that_leaves_a_bridge_stops_nothing_by_itself() -> None:
    with turning_gimbal() as (_, observer, _, address), bridge_to(address) as bridge:
        host = Host(bridge.address)
        host.socket.sendall(frame(CONTROL, OWED_TURN))
        time.sleep(0.2)
        host.close()
        time.sleep(1)
        assert observer.is_turning()
