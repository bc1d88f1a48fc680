"""Tests of sbgc bridge on a line that stalls or loses answers: each host gets what it asked for."""

from __future__ import annotations

import random
import socket
import struct
import subprocess
import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager

import pytest

from bridge import Host, bridge_to
from emulated_gimbal import emulated_gimbal
from gimbal_observer import observer_of
from relay import relay_to
from sbgc_command import PROGRAM, frame, run

READ_PARAMS_3, WRITE_PARAMS_3 = 21, 22
GET_ADJ_VARS_VAL, SET_ADJ_VARS_VAL = 64, 31
CONFIRM = CONTROL = 67
MOTORS_ON, MOTORS_OFF = 77, 109


class Line:
    """A line to a gimbal. It can stall, and loses answers with these ids."""

    def __init__(self) -> None:
        self.requests: list[tuple[float, int, bytes]] = []
        self.begun = b""  # a frame that has not arrived as a whole
        self.lost: set[tuple[int, int]] = set()  # id, first byte of the body
        self.flows = threading.Event()
        self.flows.set()

    def note(self, data: bytes) -> bytes:
        self.begun += data
        while len(self.begun) > 2 and len(self.begun) >= self.begun[2] + 5:
            size = self.begun[2] + 5
            self.requests.append((time.monotonic(), self.begun[1], self.begun[:size]))
            self.begun = self.begun[size:]
        return data

    def answer(self, data: bytes) -> bytes:
        self.flows.wait()
        for command, first in self.lost:
            data = data.replace(frame(command, bytes([first])), b"")
        return data

    def frames(self, *commands: int) -> list[int]:
        return [command for _, command, _ in self.requests if command in commands]


@contextmanager
def hosts_at(line: Line, count: int) -> Iterator[list[Host]]:
    with emulated_gimbal() as gimbal, relay_to(gimbal.address, line.note, line.answer) as address:
        with bridge_to(address) as bridge:
            hosts = [Host(bridge.address) for _ in range(count)]
            try:
                yield hosts
            finally:
                line.flows.set()
                for host in hosts:
                    host.close()


def received(host: Host, seconds: float = 0.3) -> list[tuple[int, bytes]]:
    """Returns the frames that have arrived, or arrive in this time."""
    host.socket.settimeout(seconds)
    frames = []
    try:
        while True:
            frames.append(host.receive())
    except TimeoutError:
        return frames


def stall(line: Line, seconds: float) -> None:
    line.flows.clear()
    threading.Timer(seconds, line.flows.set).start()


@pytest.mark.parametrize("command", [GET_ADJ_VARS_VAL, READ_PARAMS_3])
def test_late_answers_go_to_those_who_asked(command: int) -> None:
    line = Line()
    with hosts_at(line, 3) as (first, second, idle):
        bodies = (b"\x01\x05", b"\x01\x09") if command == GET_ADJ_VARS_VAL else (b"\0", b"\x01")
        stall(line, 1.6)
        first.send(command, bodies[0])
        second.send(command, bodies[1])
        time.sleep(2)
        for host, body in ((first, bodies[0]), (second, bodies[1])):
            ((_, answer),) = received(host)
            assert answer[: len(body)] == body
        assert received(idle) == []


def test_motors_are_off_at_last() -> None:
    line = Line()
    with hosts_at(line, 1) as (host,):
        line.lost = {(CONFIRM, MOTORS_ON)}
        host.send(MOTORS_ON)
        time.sleep(0.5)
        host.send(MOTORS_ON)
        time.sleep(0.05)
        host.send(MOTORS_OFF)
        assert received(host, 1.5) == [(CONFIRM, bytes([MOTORS_OFF]))]
        assert line.frames(MOTORS_ON, MOTORS_OFF) == [MOTORS_ON, MOTORS_ON, MOTORS_OFF]


def test_a_read_after_two_writes_gets_the_second() -> None:
    line = Line()
    with hosts_at(line, 1) as (host,):
        line.lost = {(CONFIRM, SET_ADJ_VARS_VAL)}
        for value in (11, 22):
            host.send(SET_ADJ_VARS_VAL, struct.pack("<BBi", 1, 0, value))
        host.send(GET_ADJ_VARS_VAL, b"\x01\x00")
        ((command, answer),) = received(host, 2)
        assert (command, struct.unpack("<BBi", answer)) == (SET_ADJ_VARS_VAL, (1, 0, 22))


def test_a_host_that_sends_no_more_gets_late_confirmations() -> None:
    """Nothing waits for the confirmation of a control, but the host does."""
    line = Line()
    with hosts_at(line, 2) as (host, idle):
        stall(line, 0.4)
        host.send(CONTROL, control(5))
        host.socket.shutdown(socket.SHUT_WR)
        host.socket.settimeout(20)
        assert host.stream.read() == frame(CONFIRM, bytes([CONTROL]))
        assert received(idle) == []


def test_what_is_refused_is_refused() -> None:
    with emulated_gimbal() as gimbal, bridge_to(gimbal.address) as bridge:
        places = (gimbal.address, bridge.address)
        alone, shared = (run("script", "start", "1", "--yes", "--port", at) for at in places)
        assert alone.status == 1
        assert shared == alone


def control(speed: int) -> bytes:
    return struct.pack("<B6h", 1, 0, 0, 0, 0, speed, 0)


def test_a_stop_overtakes_queued_motion() -> None:
    line = Line()
    with hosts_at(line, 1) as (host,):
        requests = b"".join(frame(CONTROL, control(speed)) for speed in range(1, 13))
        host.socket.sendall(requests + frame(CONTROL, control(0)))
        time.sleep(0.5)
        sent = [body[12] for _, command, body in line.requests if command == CONTROL]
        assert sent[-1] == 0
        assert len(sent) < 8, "most of the motion is superseded"


@pytest.mark.parametrize("is_shared", [False, True])
@pytest.mark.parametrize(
    "motion, end",
    [
        (("move", "--pitch", "80", "--speed", "10", "--wait"), "its target is no longer 80.00"),
        (("speed", "--yaw", "10", "--for", "1m"), "the camera no longer turns"),
    ],
)
def test_a_stop_ends_the_motion_of_another_program(
    motion: tuple[str, ...], end: str, is_shared: bool
) -> None:
    with ExitStack() as stack:
        gimbal = stack.enter_context(emulated_gimbal())
        observer = stack.enter_context(observer_of(gimbal))
        place = stack.enter_context(bridge_to(gimbal.address)) if is_shared else gimbal
        command = [PROGRAM, *motion, "--yes", "-p", place.address]
        with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as moving:
            observer.await_motion()
            assert run("stop", "-p", place.address).status == 0
            stopped_at = observer.angles()
            _, error = moving.communicate(timeout=20)
        # A bridge also refuses the motion that waits to be sent when the stop comes.
        is_refused = is_shared and "WRONG_STATE; the camera has stopped" in error
        assert moving.returncode == 1 and (end in error or is_refused), error
        assert observer.angles() == pytest.approx(stopped_at, abs=0.3)


@pytest.mark.parametrize("seed", range(4))
def test_nothing_that_began_before_a_stop_moves_after_it(seed: int) -> None:
    """A random motion of a program, at a bridge or beside it, and a stop at a random time."""
    random_ = random.Random(seed)
    motions = [
        ("move", "--pitch", "60", "--speed", "10", "--wait"),
        ("move", "--yaw", "-50", "--speed", "20"),
        ("speed", "--yaw", "15", "--for", "1m"),
        ("speed", "--pitch", "-9", "--for", "1m"),
    ]
    with ExitStack() as stack:
        gimbal = stack.enter_context(emulated_gimbal())
        observer = stack.enter_context(observer_of(gimbal))
        places = [gimbal.address, stack.enter_context(bridge_to(gimbal.address)).address]
        command = [PROGRAM, *random_.choice(motions), "--yes", "-p", random_.choice(places)]
        with subprocess.Popen(command, stderr=subprocess.DEVNULL) as program:
            observer.await_motion()
            time.sleep(random_.uniform(0, 0.5))
            stopped = run("stop", "-p", random_.choice(places))
            at = observer.angles()
            assert stopped.status == 0, stopped.error
            assert program.wait(20) in (0, 1)
        assert observer.angles() == pytest.approx(at, abs=0.3)


def test_controls_that_nobody_confirms_keep_their_rate() -> None:
    """Nothing waits for confirmations. Pauses between requests permit 100 per second."""
    count = 200
    line = Line()
    with hosts_at(line, 1) as (host,):
        line.lost = {(CONFIRM, CONTROL)}
        begin = time.monotonic()
        sent = []
        for index in range(count):
            time.sleep(max(0, begin + index * 0.02 - time.monotonic()))
            sent.append(time.monotonic())
            host.send(CONTROL, control(index + 1))
        deadline = time.monotonic() + 10
        while len(line.frames(CONTROL)) < count and time.monotonic() < deadline:
            time.sleep(0.01)
        arrived = [when for when, command, _ in line.requests if command == CONTROL]
        assert len(arrived) == count
        # A busy machine delays some of them; to wait for confirmations would delay all, more and more.
        delays = [arrival - when for when, arrival in zip(sent, arrived)]
        assert min(delays[-100:]) < min(delays[:100]) + 0.05
