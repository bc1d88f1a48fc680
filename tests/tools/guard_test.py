"""The gimbal stops, whatever ends the command that turns it."""

from __future__ import annotations

import os
import signal
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from board_command import Terminal
from emulated_gimbal import emulated_gimbal
from gimbal_observer import Observer, observer_of
from sbgc_command import CRASH, PROGRAM, run

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
