"""A second host of an emulated gimbal, which watches what the camera does."""

from __future__ import annotations

import socket
import struct
import time

from emulated_gimbal import EmulatedGimbal
from optical_axis import Vector
from sbgc_command import frame

REALTIME_DATA_3 = 23
GET_ANGLES_EXT = 61
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
        values = struct.unpack("<9h", self.answer(GET_ANGLES, 18))
        roll, pitch, yaw = (value * 360 / 16384 for value in values[::3])
        return roll, pitch, yaw

    def motors(self) -> tuple[float, float, float]:
        """Returns the angles between rotor and stator in degrees: roll, pitch, yaw."""
        values = struct.unpack("<" + "4xi10x" * 3, self.answer(GET_ANGLES_EXT, 54))
        roll, pitch, yaw = (value * 360 / 16384 for value in values)
        return roll, pitch, yaw

    def acceleration(self) -> Vector:
        """Returns what the accelerometer of the camera measures, in g; it points up at rest. The
        sensor of each axis measures along its axle: roll forward, pitch to the right, yaw up.
        """
        values = struct.unpack_from("<" + "h2x" * 3, self.answer(REALTIME_DATA_3, 63))
        forward, right, up = (value / 512 for value in values)
        return Vector(right, forward, up)

    def answer(self, command: int, size: int) -> bytes:
        """Returns the body, of `size` bytes, of the answer to a request without a body."""
        self.line.sendall(frame(command))
        answer = b""
        while len(answer) < 4 + size + 1:
            part = self.line.recv(4 + size + 1 - len(answer))
            assert part, "the gimbal has left"
            answer += part
        assert answer[1] == command, answer
        return answer[4:-1]

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
