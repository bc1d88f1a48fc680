"""Commands that move the camera or serve hosts wait for no reader of their output."""

from __future__ import annotations

import fcntl
import os
import re
import signal
import socket
import subprocess
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from pathlib import Path
from typing import Any

import pytest
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from full_output import KINDS, Output, full_output
from gimbal_observer import Observer
from relay import frames_in, relay_to
from sbgc_command import PROGRAM, frame, free_port, run

CONTROL = 67
AUTO_PID = 35
BOARD_INFO = 86
SOON = 0.1
"""Seconds from a signal to the stop at the board."""
PATIENCE = 30.0

HELD = {
    "move": ("--yaw", "300", "--speed", "20", "--wait"),
    "speed": ("--yaw", "20", "--for", "100s"),
    "jog": (),
    "tune": ("pitch",),
}
"""Commands that stop the camera after a signal."""

SENT = [
    (("move", "--yaw", "300", "--speed", "20", "--yes"), CONTROL),
    (("motors", "on", "--yes"), 77),
    (("menu", "home_position", "--yes"), 69),
    (("calibrate", "gyro", "--yes", "--no-check"), 103),
    (("reset", "--yes"), 114),
    (("send", "CMD_MOTORS_ON", "--yes"), 77),
    (("bode", "roll", "--gain", "1", "--from", "1", "--to", "9", "--table", "--yes"), 37),
    (("script", "start", "1", "--yes"), 57),
    (("script", "stop", "1"), 57),
    (("stop",), CONTROL),
]
"""Commands that only send a request, with its id."""

STORING = {"eeprom", "files", "module", "params", "vars"}
"""Commands that ask first, but only store values."""


def test_all_commands_that_move_are_here(tmp_path: Path) -> None:
    assert run("manual", "--folder", str(tmp_path)).status == 0
    asking = {
        page.stem.removeprefix("sbgc-")
        for page in tmp_path.glob("sbgc-*.1")
        if r"\-\-yes\fR" in page.read_text(encoding="utf-8")
    }
    assert asking == STORING | set(HELD) | {arguments[0] for arguments, _ in SENT} - {"stop"}


class Board:
    """An emulated gimbal, and what hosts send to it."""

    def __init__(self, gimbal: EmulatedGimbal) -> None:
        self.gimbal = gimbal
        self.address = ""
        self.arrived: list[tuple[float, int, bytes]] = []

    def add(self, data: bytes) -> bytes:
        now = time.monotonic()
        self.arrived += [(now, command, body) for command, body in frames_in(data)]
        return data

    def await_command(self, command: int) -> None:
        deadline = time.monotonic() + PATIENCE
        while all(command != one for _, one, _ in self.arrived):
            assert time.monotonic() < deadline, f"command {command} does not arrive"
            time.sleep(0.01)

    def stopped_after(self, begin: float) -> float:
        """Returns the seconds until speed 0 for all axes arrived."""
        deadline = begin + PATIENCE
        while time.monotonic() < deadline:
            for when, command, body in self.arrived:
                if when >= begin and command == CONTROL and is_stop(body):
                    return when - begin
            time.sleep(0.01)
        raise AssertionError("no stop arrives")


def is_stop(body: bytes) -> bool:
    """True for a body of CMD_CONTROL with MODE_SPEED and speed 0 on all axes."""
    mode_speed = 1
    modes, axes = body[:-12], body[-12:]
    return all(mode == mode_speed for mode in modes) and all(
        axes[at : at + 2] == b"\0\0" for at in (0, 4, 8)
    )


@contextmanager
def one_board() -> Iterator[Board]:
    with emulated_gimbal() as gimbal:
        board = Board(gimbal)
        with relay_to(gimbal.address, board.add) as board.address:
            yield board


@contextmanager
def running(*arguments: str, output: Output, **options: Any) -> Iterator[subprocess.Popen[bytes]]:
    """Runs a command all of whose output goes there."""
    to = output.descriptor
    with subprocess.Popen([PROGRAM, *arguments], stdout=to, stderr=to, **options) as process:
        try:
            yield process
        finally:
            process.kill()


@contextmanager
def held_key(keyboard: int) -> Iterator[None]:
    """Holds a key down that turns the camera in jog."""
    is_over = threading.Event()

    def press() -> None:
        while not is_over.wait(0.05):
            os.write(keyboard, b"d")

    thread = threading.Thread(target=press)
    thread.start()
    try:
        yield
    finally:
        is_over.set()
        thread.join()


@pytest.mark.parametrize(
    "how, options", [(signal.SIGINT, ()), (signal.SIGTERM, ("--verbose",))], ids=["int", "term"]
)
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("name", HELD)
def test_a_signal_stops_the_camera(
    name: str, kind: str, how: signal.Signals, options: tuple[str, ...]
) -> None:
    if name == "jog" and kind == "pipe":
        return  # it needs a terminal
    taken: list[float] = []
    while not taken or taken[-1] > SOON:  # a busy machine can delay anything, but not each time
        assert len(taken) < 5, taken
        with one_board() as board, Observer(board.gimbal.address) as observer:
            with full_output(kind) as output:
                arguments = (name, *HELD[name], "--yes", *options, "-p", board.address)
                keyboard = output.descriptor if name == "jog" else subprocess.DEVNULL
                with running(*arguments, output=output, stdin=keyboard) as process:
                    with held_key(output.reader) if name == "jog" else nullcontext():
                        if name == "tune":
                            board.await_command(AUTO_PID)
                        observer.await_motion()
                        output.become_full()
                        time.sleep(0.3)  # until the command has written something
                        begin = time.monotonic()
                        process.send_signal(how)
                        taken.append(board.stopped_after(begin))
                    assert process.wait(PATIENCE) == 130
                    assert observer.stands_still_within(1)  # a shaken camera comes to rest


@pytest.mark.parametrize("arguments, request_id", SENT)
def test_a_request_arrives(tmp_path: Path, arguments: tuple[str, ...], request_id: int) -> None:
    script = tmp_path / "script"
    script.write_text("wait 1\n")
    with one_board() as board, full_output("stopped terminal") as output:
        if "start" in arguments:
            put = run("files", "put", "0", str(script), "--yes", "-p", board.gimbal.address)
            assert put.status == 0
        with running(*arguments, "--verbose", "-p", board.address, output=output) as process:
            board.await_command(request_id)
            process.terminate()
            process.wait(PATIENCE)


def ask(host: socket.socket, times: int) -> None:
    """Sends requests, one after another; each gets its response."""
    for _ in range(times):
        host.sendall(frame(BOARD_INFO))
        answer = b""
        while len(answer) < 4 + 18 + 1:
            part = host.recv(4096)
            assert part
            answer += part
        assert answer[1] == BOARD_INFO


def connected_to(port: int) -> socket.socket:
    deadline = time.monotonic() + PATIENCE
    while True:
        try:
            return socket.create_connection(("127.0.0.1", port), timeout=PATIENCE)
        except ConnectionRefusedError:
            assert time.monotonic() < deadline, "nobody listens"
            time.sleep(0.05)


@pytest.mark.parametrize("kind", ["pipe", "stopped terminal"])
@pytest.mark.parametrize("command", ["bridge", "emulate"])
def test_hosts_are_served(command: str, kind: str) -> None:
    port = free_port()
    with emulated_gimbal() as gimbal, full_output(kind) as output:
        arguments = ("--tcp", str(port), "--verbose")
        if command == "bridge":
            arguments = (gimbal.address, *arguments)
        with running(command, *arguments, output=output) as process:
            with connected_to(port) as host:
                ask(host, 2000)
            process.terminate()
            assert process.wait(PATIENCE) == 0


@pytest.mark.parametrize("has_reader", [True, False])
def test_a_replay_serves_hosts(tmp_path: Path, has_reader: bool) -> None:
    capture = tmp_path / "capture"
    with emulated_gimbal() as gimbal:
        assert run("info", "-p", gimbal.address, "--capture", str(capture)).status == 0
    port = free_port()
    with full_output("pipe") as output:
        if not has_reader:
            output.lose_reader()
        arguments = ("replay", str(capture), "--tcp", str(port))
        with running(*arguments, output=output) as process:
            with connected_to(port) as host:
                assert host.recv(1) == b">"
            process.terminate()
            assert process.wait(PATIENCE) == 0


def test_what_was_dropped_is_counted() -> None:
    with emulated_gimbal() as gimbal, full_output("pipe") as output:
        port = free_port()
        arguments = ("bridge", gimbal.address, "--tcp", str(port), "--verbose")
        with running(*arguments, output=output) as process, connected_to(port) as host:
            ask(host, 1000)
            shown = b""
            deadline = time.monotonic() + PATIENCE
            while not (
                count := re.search(rb"^\.\.\. (\d+) lines dropped: no reader$", shown, re.M)
            ):
                assert time.monotonic() < deadline
                shown += os.read(output.reader, 65536)
            lines = shown.strip(b"\n")[: count.start()].count(b"\n")
            # Each request takes at least ten, with its response.
            assert int(count[1]) > 1000 * 10 - lines
            assert lines > 100
            ask(host, 1)
            while shown.count(b"CMD_BOARD_INFO", count.end()) < 2:
                shown += os.read(output.reader, 65536)
            process.terminate()


def test_a_slow_reader_gets_everything() -> None:
    """Also what the pipe does not hold at the end."""
    with emulated_gimbal() as gimbal:
        arguments = ("speed", "--yaw", "20", "--for", "1s", "--yes", "--verbose")
        process = subprocess.Popen(
            [PROGRAM, *arguments, "-p", gimbal.address], stderr=subprocess.PIPE
        )
        assert process.stderr is not None
        fcntl.fcntl(process.stderr, fcntl.F_SETPIPE_SZ, 4096)
        shown = b""
        while part := os.read(process.stderr.fileno(), 2000):
            time.sleep(0.01)
            shown += part
        assert process.wait(PATIENCE) == 0
        assert b"lines dropped" not in shown
        assert shown.endswith(b"The camera has stopped.\n")
