"""A scripted autopilot and ground station over UDP, beside an emulated gimbal and the program."""

from __future__ import annotations

import os
import re
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from math import cos, nan, radians, sin
from typing import Any, Optional

import sbgc
from sbgc import msg
from sbgc.mavlink.codec import Codec, Message, _dialect

NAMES = frozenset(one.msgname for one in _dialect().mavlink_map.values())
NAN_Q = [nan] * 4


def aircraft(roll: float = 0, pitch: float = 0, yaw: float = 0) -> list[float]:
    """The quaternion of an aircraft's angles in degrees; nose up, to the right."""
    (sr, cr), (sp, cp), (sy, cy) = (
        (sin(radians(a) / 2), cos(radians(a) / 2)) for a in (roll, pitch, yaw)
    )
    return [
        cr * cp * cy + sr * sp * sy,
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
    ]


class Station:
    """Somebody who speaks MAVLink over a socket of its own: an autopilot, or a ground station."""

    def __init__(self, system: int = 1, component: int = 1, key: Optional[bytes] = None) -> None:
        self.sender, self.sequence = (system, component), 0
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", 0))
        self.port = self.socket.getsockname()[1]
        self.peer: Any = None
        self.codec = Codec(NAMES, key, __import__("collections").Counter())
        self.got: list[Message] = []
        self.heading: Optional[float] = 0.0  # None: no state
        self.beats = True
        self.began = self.beat = time.monotonic()

    def encode(self, name: str, **fields: Any) -> bytes:
        data = self.codec.encode(name, self.sender, self.sequence, **fields)
        self.sequence = (self.sequence + 1) % 256
        return data

    def send(self, name: str, **fields: Any) -> bytes:
        data = self.encode(name, **fields)
        self.put(data)
        return data

    def put(self, data: bytes) -> None:
        if self.peer:
            self.socket.sendto(data, self.peer)

    def listen(self, seconds: float) -> None:
        until = time.monotonic() + seconds
        while (left := until - time.monotonic()) > 0:
            self.socket.settimeout(left)
            try:
                data, self.peer = self.socket.recvfrom(4096)
            except TimeoutError:
                return
            self.got += self.codec.decode(data, True)

    def fly(
        self, seconds: float, each: Optional[Callable[[], object]] = None, rate: float = 50
    ) -> None:
        """Send heartbeats, the state, and what `each` sends, as an autopilot does."""
        until = time.monotonic() + seconds
        while time.monotonic() < until:
            now = time.monotonic()
            if self.beats and now >= self.beat:
                self.beat = now + 1
                is_autopilot = self.sender[1] == 1
                self.send(
                    "HEARTBEAT",
                    type=2 if is_autopilot else 6,
                    autopilot=3 if is_autopilot else 8,
                    base_mode=0,
                    custom_mode=0,
                    system_status=4,
                    mavlink_version=3,
                )
            if self.heading is not None and self.sender[1] == 1:
                self.state(self.heading)
            if each:
                each()
            self.listen(1 / rate)

    def state(self, heading: float, **other: Any) -> bytes:
        fields: dict[str, Any] = dict(
            target_system=self.sender[0],
            target_component=0,
            time_boot_us=int((time.monotonic() - self.began) * 1e6),
            q=aircraft(yaw=heading),
            q_estimated_delay_us=0,
            vx=0,
            vy=0,
            vz=0,
            v_estimated_delay_us=0,
            feed_forward_angular_velocity_z=nan,
            estimator_status=41791,
            landed_state=0,
            angular_velocity_z=nan,
        )
        return self.send("AUTOPILOT_STATE_FOR_GIMBAL_DEVICE", **{**fields, **other})

    def attitude(
        self, q: Any = NAN_Q, rates: Any = (nan, nan, nan), flags: int = 0, to: Any = None
    ) -> bytes:
        system, component = to or (self.sender[0], 154)
        x, y, z = rates
        return self.send(
            "GIMBAL_DEVICE_SET_ATTITUDE",
            target_system=system,
            target_component=component,
            flags=flags,
            q=q,
            angular_velocity_x=x,
            angular_velocity_y=y,
            angular_velocity_z=z,
        )

    def command(
        self, number: int, *values: float, to: Any = None, is_int: bool = False
    ) -> Optional[int]:
        """Send a command, and return the result of its answer."""
        given = [*values, *[0.0] * (7 - len(values))]
        names = (
            "param1 param2 param3 param4 x y z"
            if is_int
            else "param1 param2 param3 param4 param5 param6 param7"
        )
        fields: dict[str, Any] = dict(zip(names.split(), given))
        fields.update(dict(frame=0, current=0, autocontinue=0) if is_int else dict(confirmation=0))
        if is_int:
            fields.update(x=int(given[4]), y=int(given[5]))
        system, component = to or (1, 154)
        seen = len(self.got)
        self.send(
            "COMMAND_INT" if is_int else "COMMAND_LONG",
            target_system=system,
            target_component=component,
            command=number,
            **fields,
        )
        for _ in range(25):
            self.fly(0.04)
            for one in self.got[seen:]:
                if one.name == "COMMAND_ACK" and one.values.command == number:
                    return int(one.values.result)
        return None

    def last(self, name: str) -> Any:
        return next(one.values for one in reversed(self.got) if one.name == name)

    def all(self, name: str) -> list[Message]:
        return [one for one in self.got if one.name == name]


class Gimbal:
    """An emulated gimbal, seen by another host on its line."""

    def __init__(self, address: str, process: subprocess.Popen[str]) -> None:
        self.address, self.process = address, process
        self.host = sbgc.connect(address)

    def motors_on(self) -> None:
        self.host.motors_on()
        time.sleep(0.2)

    def joints(self) -> tuple[float, float, float]:
        roll, pitch, yaw = self.host.call(msg.RealtimeData4Request()).rotor_angle
        return roll, pitch, yaw

    def speed(self) -> float:
        """Degrees per second of the fastest axis, over a tenth of a second."""
        before = self.joints()
        time.sleep(0.1)
        return max(abs(a - b) for a, b in zip(self.joints(), before)) / 0.1


@contextmanager
def emulated(*options: str) -> Iterator[Gimbal]:
    with subprocess.Popen(
        [os.environ["SBGC"], "emulate", "--tcp", "0", *options], stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None
        found = re.match(r"emulated gimbal 1: (\S+)", process.stdout.readline())
        assert found
        gimbal = Gimbal(found[1], process)
        try:
            yield gimbal
        finally:
            gimbal.host.close()
            process.kill()


@contextmanager
def program(*arguments: str) -> Iterator[subprocess.Popen[bytes]]:
    with subprocess.Popen([sys.executable, "-m", "sbgc.mavlink", *arguments]) as process:
        try:
            yield process
        finally:
            process.terminate()
            assert process.wait(10) in (0, -9)
