"""A scripted autopilot and ground station over UDP, beside an emulated gimbal and the program."""

from __future__ import annotations

import os
import re
import socket
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from math import cos, nan, radians, sin
from threading import Timer
from typing import Any, Optional

from optical_axis import degrees_down, degrees_right

import sbgc
from sbgc import msg
from sbgc.mavlink.codec import Codec, Message
from sbgc.mavlink.vehicle import WANTED

NAMES = WANTED | {
    *("GIMBAL_DEVICE_INFORMATION", "GIMBAL_DEVICE_ATTITUDE_STATUS", "COMPONENT_INFORMATION_BASIC"),
    *("COMMAND_ACK", "PARAM_VALUE"),
}
NO_Q = [nan] * 4
STATUS = "GIMBAL_DEVICE_ATTITUDE_STATUS"
FOLLOW, LOCK = 0, 28  # what ArduPilot sends
SLOW = 6.0  # seconds in which a busy machine still turns a camera to its place


def aircraft(roll: float = 0, pitch: float = 0, yaw: float = 0) -> list[float]:
    """The quaternion of an aircraft's angles in degrees: right side down, nose up, to the right."""
    halves = ((sin(radians(a) / 2), cos(radians(a) / 2)) for a in (roll, pitch, yaw))
    (sr, cr), (sp, cp), (sy, cy) = halves
    w, x = cr * cp * cy + sr * sp * sy, sr * cp * cy - cr * sp * sy
    return [w, x, cr * sp * cy + sr * cp * sy, cr * cp * sy - sr * sp * cy]


class Station:
    """An autopilot (component 1), or somebody else, with a socket of its own."""

    def __init__(self, system: int = 1, component: int = 1, key: Optional[bytes] = None) -> None:
        self.sender, self.sequence = (system, component), 0
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", 0))
        self.port: int = self.socket.getsockname()[1]
        self.peer: Any = None
        self.counters: Counter[str] = Counter()
        self.codec = Codec(NAMES, key, self.counters)
        self.got: list[Message] = []
        self.heading: Callable[[], Optional[float]] = lambda: 0.0
        self.began = self.beat = time.monotonic()

    def __del__(self) -> None:
        self.socket.close()

    def encode(self, name: str, **fields: Any) -> bytes:
        data = self.codec.encode(name, self.sender, self.sequence, **fields)
        self.sequence = (self.sequence + 1) % 256
        return data

    def put(self, data: bytes) -> bytes:
        if self.peer:
            self.socket.sendto(data, self.peer)
        return data

    def listen(self, seconds: float) -> None:
        until = time.monotonic() + seconds
        while (left := until - time.monotonic()) > 0:
            self.socket.settimeout(left)
            try:
                data, self.peer = self.socket.recvfrom(4096)
            except TimeoutError:
                return
            self.got += self.codec.decode(data, True)

    def fly(self, seconds: float, each: Callable[[], object] = lambda: None) -> None:
        """Send heartbeats, the state, and what `each` sends, 50 times a second."""
        until = time.monotonic() + seconds
        while time.monotonic() < until:
            is_autopilot, heading = self.sender[1] == 1, self.heading()
            if time.monotonic() >= self.beat:
                self.beat = time.monotonic() + 1
                who = {"type": 2, "autopilot": 3} if is_autopilot else {"type": 6, "autopilot": 8}
                rest = {"base_mode": 0, "custom_mode": 0, "system_status": 4, "mavlink_version": 3}
                self.put(self.encode("HEARTBEAT", **who, **rest))
            if heading is not None and is_autopilot:
                self.put(self.state(heading))
            each()
            self.listen(0.02)

    def until(self, found: Callable[[], Any], each: Callable[[], object] = lambda: None) -> Any:
        """Fly until something is true."""
        end = time.monotonic() + 20
        while not (result := found()):
            assert time.monotonic() < end, "it never happens"
            self.fly(0.04, each)
        return result

    def state(self, heading: float, **other: Any) -> bytes:
        fields: dict[str, Any] = {"time_boot_us": int((time.monotonic() - self.began) * 1e6)}
        fields.update(target_system=self.sender[0], target_component=0, q=aircraft(yaw=heading))
        fields.update(q_estimated_delay_us=0, vx=0, vy=0, vz=0, v_estimated_delay_us=0)
        fields.update(feed_forward_angular_velocity_z=nan, angular_velocity_z=nan)
        fields.update({"estimator_status": 41791, "landed_state": 0, **other})
        return self.encode("AUTOPILOT_STATE_FOR_GIMBAL_DEVICE", **fields)

    def attitude(
        self, q: Any = NO_Q, rates: Any = (nan, nan, nan), flags: int = FOLLOW, to: Any = None
    ) -> bytes:
        """GIMBAL_DEVICE_SET_ATTITUDE."""
        fields: dict[str, Any] = {f"angular_velocity_{a}": rate for a, rate in zip("xyz", rates)}
        fields["target_system"], fields["target_component"] = to or (self.sender[0], 154)
        return self.encode("GIMBAL_DEVICE_SET_ATTITUDE", q=q, flags=flags, **fields)

    def aim(self, *given: Any, **named: Any) -> Callable[[], bytes]:
        """What sends SET_ATTITUDE, for fly()."""
        return lambda: self.put(self.attitude(*given, **named))

    def command(
        self, number: int, *values: float, to: Any = (1, 154), is_int: bool = False
    ) -> Optional[int]:
        """Send a command, and return the result of its answer; None if there is none for a second."""
        given: list[Any] = [*values, *[0.0] * (7 - len(values))]
        names = [f"param{number}" for number in range(1, 8)]
        rest = {"target_system": to[0], "target_component": to[1], "command": number}
        if is_int:
            names[4:], given[4:6] = ["x", "y", "z"], map(int, given[4:6])
            rest.update(frame=0, current=0, autocontinue=0)
        else:
            rest["confirmation"] = 0
        seen, name = len(self.got), "COMMAND_INT" if is_int else "COMMAND_LONG"
        self.put(self.encode(name, **dict(zip(names, given)), **rest))
        end = time.monotonic() + 1
        while time.monotonic() < end:
            self.fly(0.02)
            for one in self.got[seen:]:
                if one.name == "COMMAND_ACK" and one.values.command == number:
                    return int(one.values.result)
        return None

    def all(self, name: str) -> list[Message]:
        return [one for one in self.got if one.name == name]

    def last(self, name: str) -> Any:
        return self.all(name)[-1].values


class Gimbal:
    """An emulated gimbal, seen by another host on its line."""

    def __init__(self, *options: str, port: str = "0") -> None:
        command = [os.environ["SBGC"], "emulate", "--tcp", port, *options]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        assert self.process.stdout is not None
        found = re.match(r"emulated gimbal 1: (\S+)", self.process.stdout.readline())
        assert found
        self.address = found[1]
        self.host = sbgc.connect(self.address)

    def close(self) -> None:
        self.host.close()
        if self.process.poll() is None:
            self.process.kill()
            self.process.communicate()

    def data(self) -> msg.RealtimeData4:
        return self.host.call(msg.RealtimeData4Request())

    def joints(self) -> tuple[float, float, float]:
        roll, pitch, yaw = self.data().rotor_angle
        return roll, pitch, yaw

    @property
    def up(self) -> float:
        return -degrees_down(self.joints())

    @property
    def right(self) -> float:
        return degrees_right(self.joints())

    def is_still(self, seconds: float = 0.3) -> bool:
        before = self.joints()
        time.sleep(seconds)
        return all(abs(a - b) < 0.3 for a, b in zip(self.joints(), before))


@contextmanager
def program(*arguments: str) -> Iterator[subprocess.Popen[str]]:
    command = [sys.executable, "-W", "error", "-m", "sbgc.mavlink", *arguments]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
        try:
            yield process
        finally:
            process.terminate()
            alarm = Timer(10, process.kill)
            alarm.start()
            said = process.communicate()[1]
            alarm.cancel()
            print(said)
            assert process.returncode in (0, -9) and "Traceback" not in said, said


@dataclass
class Rig:
    """A gimbal, whose motors are on, the program, and an autopilot that the program has heard."""

    gimbal: Gimbal
    autopilot: Station
    process: subprocess.Popen[str]


@contextmanager
def started(
    *arguments: str,
    emulator: tuple[str, ...] = (),
    motors: bool = True,
    key: Optional[bytes] = None,
    north: float = 0,
) -> Iterator[Rig]:
    """`north` is the heading of the vehicle while its frame has a yaw of 0."""
    with ExitStack() as stack:
        gimbal, autopilot = Gimbal(*emulator), Station(key=key)
        if emulator:
            autopilot.heading = lambda: gimbal.data().frame_imu_angle.yaw + north
        stack.callback(gimbal.close)
        if not motors:
            gimbal.host.motors_off()
        line = f"--line=udpout:127.0.0.1:{autopilot.port}"
        process = stack.enter_context(program(gimbal.address, line, *arguments))
        autopilot.until(lambda: autopilot.all(STATUS))
        yield Rig(gimbal, autopilot, process)
