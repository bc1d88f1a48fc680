"""Bridges of emulated gimbals, and programs that use them, for the tests."""

from __future__ import annotations

import signal
import socket
import struct
from collections.abc import Iterator
from contextlib import contextmanager

from emulated_gimbal import emulated_gimbal
from sbgc_command import Running, frame
from screens import Terminal

GET_ANGLES = 73
BOARD_INFO = 86
RESET = 114
DATA_STREAM_INTERVAL = 85
REALTIME_DATA_3 = 23
TOKEN = "correct-horse"
PLACES = ("--tcp", "--udp", "--pty", "--ws", "--link")


def stream_request(interval: int) -> bytes:
    return struct.pack("<BH18x", REALTIME_DATA_3, interval)


class Bridge:
    """A running `sbgc bridge`."""

    def __init__(self, address: str, *places: str) -> None:
        self.process = Running("bridge", address, *places)
        count = sum(place in PLACES for place in places)
        self.addresses = [self.process.address() for _ in range(count)]
        self.address = self.addresses[0]
        self.wait_for = self.process.wait_for

    def stop(self) -> None:
        self.process.send_signal(signal.SIGINT)
        self.process.communicate(timeout=20)
        assert self.process.returncode == 0


@contextmanager
def bridge_to(address: str, *places: str) -> Iterator[Bridge]:
    bridge = Bridge(address, *(places or ("--tcp", "0")))
    try:
        yield bridge
    finally:
        bridge.stop()


@contextmanager
def shared_gimbal(*places: str) -> Iterator[Bridge]:
    """A bridge of an emulated gimbal."""
    with emulated_gimbal() as gimbal, bridge_to(gimbal.address, *places) as bridge:
        yield bridge


class Host:
    """A program at the bridge."""

    def __init__(self, address: str) -> None:
        _, host, port = address.split(":")
        self.socket = socket.create_connection((host, int(port)), timeout=20)
        self.stream = self.socket.makefile("rb")

    def send(self, command: int, body: bytes = b"") -> None:
        self.socket.sendall(frame(command, body))

    def receive(self) -> tuple[int, bytes]:
        header = self.stream.read(4)
        assert header[0:1] == b">"
        body = self.stream.read(header[2])
        checksum = self.stream.read(1)
        assert checksum == bytes([sum(body) % 256])
        return header[1], body

    def receive_samples(self, count: int) -> None:
        while count:
            count -= self.receive()[0] == REALTIME_DATA_3

    def ask(self, command: int, body: bytes = b"") -> bytes:
        self.send(command, body)
        answer, data = self.receive()
        assert answer == command
        return data

    def close(self) -> None:
        self.stream.close()
        self.socket.close()


def host_of_bridge_in(shell: Terminal, gimbal: str) -> Host:
    """Starts a bridge in a terminal, and returns its only host, which has asked once."""
    shell.run("bridge", gimbal, "--tcp", "0")
    lines = shell.wait(r"^connected, 0 hosts$")
    (address,) = [line.split()[1] for line in lines if line.startswith("bridge: ")]
    host = Host(address)
    assert host.ask(BOARD_INFO)
    shell.wait(r"^connected, 1 host \| 0: 1 in, 1 out$")
    return host
