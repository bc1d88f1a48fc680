"""A second host of an emulated gimbal, which watches what the camera does."""

from __future__ import annotations

import socket
import struct
import time

from emulated_gimbal import EmulatedGimbal
from sbgc_command import frame

GET_ANGLES = 73
NOISE = 0.15
"""Degrees that the angles of a camera at rest may differ."""


class Observer:
    def __init__(self, address: str) -> None:
        host, port = address.removeprefix("tcp:").rsplit(":", 1)
        self.line = socket.create_connection((host, int(port)), timeout=30)

    def __enter__(self) -> Observer:
        return self

    def __exit__(self, *_: object) -> None:
        self.line.close()

    def angles(self) -> tuple[float, float, float]:
        """Returns the measured angles in degrees: roll, pitch, yaw."""
        self.line.sendall(frame(GET_ANGLES))
        size = 4 + 18 + 1
        answer = b""
        while len(answer) < size:
            part = self.line.recv(size - len(answer))
            assert part, "the gimbal has left"
            answer += part
        assert answer[1] == GET_ANGLES, answer
        values = struct.unpack_from("<9h", answer, 4)
        roll, pitch, yaw = (value * 360 / 16384 for value in values[::3])
        return roll, pitch, yaw

    def is_turning(self) -> bool:
        before = self.angles()
        time.sleep(0.15)
        return any(abs(a - b) > NOISE for a, b in zip(before, self.angles()))

    def await_motion(self) -> None:
        deadline = time.monotonic() + 30
        while not self.is_turning():
            assert time.monotonic() < deadline, "the camera does not turn"

    def stands_still_within(self, seconds: float) -> bool:
        deadline = time.monotonic() + seconds
        while self.is_turning():
            if time.monotonic() > deadline:
                return False
        return True


def observer_of(gimbal: EmulatedGimbal) -> Observer:
    """Connects to a gimbal on TCP, or to one whose second address is on TCP."""
    if gimbal.address.startswith("tcp:"):
        return Observer(gimbal.address)
    assert gimbal.process.stdout is not None
    return Observer(gimbal.process.stdout.readline().split(": ", 1)[1].split()[0])
