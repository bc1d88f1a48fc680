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
from contextlib import closing, contextmanager
from dataclasses import dataclass
from math import cos, nan, radians, sin
from threading import Timer
from typing import Any, Optional

from optical_axis import degrees_down, degrees_right

import sbgc
from sbgc import msg
from sbgc.mavlink.codec import TYPES, Codec, Message

NO_Q = [nan] * 4
STATUS = "GIMBAL_DEVICE_ATTITUDE_STATUS"
FOLLOW, LOCK = 0, 28  # what ArduPilot sends
Aim = Callable[[], object]  # sends something


def aircraft(roll: float = 0, pitch: float = 0, yaw: float = 0) -> list[float]:
    """The quaternion of an aircraft's angles in degrees: right side down, nose up, to the right."""
    halves = ((sin(radians(a) / 2), cos(radians(a) / 2)) for a in (roll, pitch, yaw))
    (sr, cr), (sp, cp), (sy, cy) = halves
    w, x = cr * cp * cy + sr * sp * sy, sr * cp * cy - cr * sp * sy
    return [w, x, cr * sp * cy + sr * cp * sy, cr * cp * sy - sr * sp * cy]


class Station:
    """An autopilot (component 1), or somebody else, with a socket of its own."""

    def __init__(
        self, system: int = 1, component: int = 1, key: Optional[bytes] = None, line: Any = None
    ) -> None:
        """`line` is another station, whose line it uses."""
        self.sender, self.sequence = (system, component), 0
        self.socket = line.socket.dup() if line else socket.socket(type=socket.SOCK_DGRAM)
        self.peer = line.peer if line else None
        if not line:
            self.socket.bind(("127.0.0.1", 0))
        self.port: int = self.socket.getsockname()[1]
        self.period = 0.02  # that of ArduPilot
        self.counters: Counter[str] = Counter()
        self.codec = Codec(key, self.counters)
        self.got: list[Message] = []
        self.heading: Callable[[], Optional[float]] = lambda: 0.0
        self.began = self.beat = time.monotonic()

    def __del__(self) -> None:
        self.socket.close()

    def encode(self, name: str, **fields: Any) -> bytes:
        """Make a message, without rates that are not given."""
        rates = [one for one in TYPES[name].fieldnames if "rate" in one or "velocity" in one]
        fields = {**dict.fromkeys(rates, nan), **fields}
        data = self.codec.to_bytes(name, self.sender, self.sequence, **fields)
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
            self.got += self.codec.messages(data, True)

    def fly(self, seconds: float, each: Aim = lambda: None) -> None:
        """Send heartbeats, and in each period the state and what `each` sends."""
        until = time.monotonic() + seconds
        while time.monotonic() < until:
            is_autopilot, heading = self.sender[1] == 1, self.heading()
            if self.peer and time.monotonic() >= self.beat:
                self.beat = time.monotonic() + 1
                who = {"type": 2, "autopilot": 3} if is_autopilot else {"type": 6, "autopilot": 8}
                self.put(self.encode("HEARTBEAT", system_status=4, mavlink_version=3, **who))
            if heading is not None and is_autopilot:
                self.put(self.state(heading))
            each()
            self.listen(self.period)

    def until(self, found: Callable[[], Any], each: Aim = lambda: None) -> Any:
        """Fly until something is true."""
        end = time.monotonic() + 20
        while not (result := found()):
            assert time.monotonic() < end, "it never happens"
            self.fly(0.04, each)
        return result

    def state(self, heading: float) -> bytes:
        fields: dict[str, Any] = {"time_boot_us": int((time.monotonic() - self.began) * 1e6)}
        fields.update(target_system=self.sender[0], q=aircraft(yaw=heading), estimator_status=41791)
        return self.encode("AUTOPILOT_STATE_FOR_GIMBAL_DEVICE", **fields)

    def attitude(self, q: Any = NO_Q, rates: Any = (), flags: int = 0, to: Any = None) -> bytes:
        """GIMBAL_DEVICE_SET_ATTITUDE."""
        fields: dict[str, Any] = {f"angular_velocity_{a}": rate for a, rate in zip("xyz", rates)}
        fields["target_system"], fields["target_component"] = to or (self.sender[0], 154)
        return self.encode("GIMBAL_DEVICE_SET_ATTITUDE", q=q, flags=flags, **fields)

    def aim(self, *given: Any, **named: Any) -> Aim:
        """Returns a function that sends SET_ATTITUDE, for fly()."""
        return lambda: self.put(self.attitude(*given, **named))

    def command(
        self,
        number: int,
        *values: float,
        to: Any = (1, 154),
        is_int: bool = False,
        patience: float = 20,
    ) -> Optional[int]:
        """Send a command, and return the result of its answer; None if there is none in time."""
        name = "COMMAND_INT" if is_int else "COMMAND_LONG"
        fields: dict[str, Any] = dict(zip(TYPES[name].fieldnames[-7:], values))
        fields.update(target_system=to[0], target_component=to[1], command=number)
        seen, end = len(self.got), time.monotonic() + patience
        self.put(self.encode(name, **fields))
        while time.monotonic() < end:
            self.fly(0.02)
            for one in self.got[seen:]:
                if one.name == "COMMAND_ACK" and one.values.command == number:
                    return int(one.values.result)
        return None

    def all(self, name: str) -> list[Message]:
        return [one for one in self.got if one.name == name]

    def interval(self, name: str, count: int) -> float:
        """The mean interval of the next messages by the sender's clock, in ms."""
        before = len(self.all(name))
        self.until(lambda: len(self.all(name)) > before + count)
        times = [one.values.time_boot_ms for one in self.all(name)[before:]]
        return float(times[-1] - times[0]) / (len(times) - 1)

    def last(self, name: str) -> Any:
        return self.all(name)[-1].values


class Gimbal:
    """An emulated gimbal, seen by another host on its line."""

    def __init__(self, *options: str) -> None:
        self.port, self._options = "0", options
        self.open()

    def open(self) -> None:
        """Start it, again at the same port."""
        command = [os.environ["SBGC"], "emulate", "--tcp", self.port, *self._options]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        assert self.process.stdout is not None
        found = re.match(r"emulated gimbal 1: (\S+:(\d+))", self.process.stdout.readline())
        assert found
        self.address, self.port = found[1], found[2]
        self.host = sbgc.connect(self.address)

    def close(self) -> None:
        self.host.close()
        if self.process.poll() is None:
            self.process.kill()
            self.process.communicate()

    def data(self) -> msg.RealtimeData4:
        return self.host.call(msg.RealtimeData4Request())

    def joints(self) -> sbgc.Angles:
        return sbgc.Angles(*self.data().rotor_angle)

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
    system: int = 1,
    key: Optional[bytes] = None,
    north: float = 0,
    limit: float = 0,
) -> Iterator[Rig]:
    """`north` is the heading of the vehicle while its frame has a yaw of 0, `limit` that of yaw."""
    autopilot = Station(system, key=key)
    with closing(Gimbal(*emulator)) as gimbal:
        if emulator:
            autopilot.heading = lambda: gimbal.data().frame_imu_angle.yaw + north
        if not motors:
            gimbal.host.motors_off()
        if limit:
            with gimbal.host.edit_profile(1) as profile:
                profile["rc.yaw.rc_min_angle"], profile["rc.yaw.rc_max_angle"] = -limit, limit
        line = f"--line=udpout:127.0.0.1:{autopilot.port}"
        with program(gimbal.address, line, *arguments) as process:
            autopilot.until(lambda: autopilot.all(STATUS))
            yield Rig(gimbal, autopilot, process)
