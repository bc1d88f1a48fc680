"""Tests of stops that are repeated until they are done, on a line that carries nothing for a while."""

from __future__ import annotations

import random
import signal
import socket
import subprocess
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager

import pytest

from bridge import Host, bridge_to
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from gimbal_observer import Observer, observer_of
from relay import relay_to
from sbgc_command import PROGRAM, frame, run

CONTROL = 67
TURN = bytes([1] * 3) + bytes(8) + bytes([40, 0, 0, 0])  # yaw, 4.9 deg/s
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
        other.sendall(frame(CONTROL, TURN))
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
        host.socket.sendall(frame(CONTROL, TURN))
        time.sleep(0.2)
        host.close()
        time.sleep(1)
        assert observer.is_turning()
