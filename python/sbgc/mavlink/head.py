"""A gimbal behind its serial line: what it measures, and what it is told."""

from __future__ import annotations

import asyncio
import logging
import re
import time
from collections import Counter, deque
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from math import nan
from typing import Optional, Union

from sbgc import aio
from sbgc.emulator import Angles, Board
from sbgc.errors import Error, GimbalDisconnected, GimbalTimeout
from sbgc.link import Identity
from sbgc.mavlink.steering import UNLIMITED, Goal, Range, Sample, Setpoint, Steering
from sbgc.fields import Axes
from sbgc.msg import (
    BoardFeatures,
    ControlAxis,
    ControlExt,
    ControlMode,
    ControlModeKind,
    OtherFlags,
    RealtimeData4,
)
from sbgc.parameters import Profile

LOG = logging.getLogger("sbgc.mavlink")
INTERVAL = 0.05  # seconds between samples, and between repetitions for an axis that follows
PACE = 0.02  # a board takes 50 commands a second
STALE = 0.5
AGAIN = 2.0
FASTEST = 2000.0  # degrees per second; no gimbal is faster


@dataclass(frozen=True)
class Signs:
    """1, or -1 if an axis counts the other way round than in MAVLink.

    The protocol does not say which way a board counts roll; `--check` shows it.
    """

    roll: int = 1
    pitch: int = -1
    yaw: int = 1

    def of(self, roll: float, pitch: float, yaw: float) -> Angles:
        return Angles(self.roll * roll, self.pitch * pitch, self.yaw * yaw)


class Head:
    """Drives one gimbal. `aim()` takes setpoints; nothing moves while its motors are off.

    With `may_arm`, a setpoint turns the motors on, once. `counters` counts setpoints that had no effect.
    """

    def __init__(
        self,
        place: Union[str, Board],
        signs: Signs,
        steering: Steering,
        counters: Counter[str],
        may_arm: bool = False,
    ) -> None:
        self.sample: Optional[Sample] = None
        self.identity: Optional[Identity] = None
        self.steering = steering
        self.north: Callable[[], Optional[float]] = lambda: None
        """The heading where the board's yaw is 0, if somebody knows it."""
        self.turn = 0.0
        """How quickly the vehicle turns, degrees per second."""
        self._place, self._signs, self._may_arm = place, signs, may_arm
        self._counters = counters
        self._changed = asyncio.Event()
        self._history: deque[Sample] = deque(maxlen=4)
        self._tried_arming = -AGAIN

    @property
    def is_alive(self) -> bool:
        """True while the board reports."""
        return self.sample is not None and time.monotonic() - self.sample.at < STALE

    @property
    def has_yaw(self) -> bool:
        """True if the board has three axes."""
        if self.identity is None:
            return False
        return bool(self.identity.info.board_features & BoardFeatures.BOARD_FEATURE_3AXIS)

    @property
    def rates(self) -> Angles:
        """How quickly the angles change, degrees per second; NaN if not known."""
        if len(self._history) < 2:
            return Angles(nan, nan, nan)
        old, new = self._history[0], self._history[-1]
        change = zip(new.angles, old.angles)
        return Angles(*((b - a) / max(new.at - old.at, INTERVAL) for b, a in change))

    def aim(self, setpoint: Setpoint) -> bool:
        """Take a setpoint; False if nothing can come of it, because of the line or the motors."""
        sample = self.sample
        if sample is None or not self.is_alive:
            self._counters["no_gimbal"] += 1
            return False
        if not sample.are_motors_on and not self._may_arm:
            self._counters["motors_off"] += 1
            return False
        self.steering.set(setpoint, sample, time.monotonic())
        self._changed.set()
        return True

    async def run(self) -> None:
        """Serve the gimbal for ever; one that is lost is searched for."""
        said = ""
        while True:
            try:
                async with aio.connect(self._place, reconnect=True) as gimbal:
                    said = ""
                    await self._serve(gimbal)
            except (Error, OSError) as error:
                if str(error) != said:
                    LOG.warning("%s: %s; trying again", self._place, error)
                said = str(error)
            self.steering.clear()
            await asyncio.sleep(AGAIN)

    async def _serve(self, gimbal: aio.Gimbal) -> None:
        self.identity = gimbal.identity
        profile = await gimbal.read_profile(await gimbal.active_profile())
        self.steering.limits = limits_of(profile, self._signs)
        LOG.info("%s: roll, pitch and yaw within %s", self._place, self.steering.limits)
        driving = asyncio.create_task(self._drive(gimbal))
        try:
            async with await gimbal.stream(RealtimeData4, INTERVAL, timeout=STALE) as samples:
                while not driving.done():
                    try:
                        self._take(await samples.__anext__())
                    except (GimbalTimeout, GimbalDisconnected):
                        self.steering.clear()  # what was wanted before is old when the line is back
                        self._history.clear()
                        if gimbal._is_closed:
                            raise
                        await asyncio.sleep(INTERVAL)  # on a lost line, it raises at once
            driving.result()
        finally:
            driving.cancel()
            if self.steering.is_turning(time.monotonic()) and gimbal.is_connected:
                with suppress(Error):  # which would take the place of a cancellation
                    await gimbal.stop()

    def _take(self, found: RealtimeData4) -> None:
        angles, joints = (self._signs.of(*found.angle), self._signs.of(*found.rotor_angle))
        self.sample = Sample(
            time.monotonic(),
            angles,
            joints,
            bool(found.other_flags & OtherFlags.MOTORS_ON),
            int(found.system_error),
            int(found.calib_mode) != 0,
        )
        self._history.append(self.sample)
        if self.sample.are_motors_on:
            self._may_arm = False  # who turns them off later wants them off
        elif not self._may_arm:
            self.steering.clear()

    async def _drive(self, gimbal: aio.Gimbal) -> None:
        loop, said = asyncio.get_running_loop(), ""
        while True:
            alarm = None
            if self.steering.needs_repetition:
                alarm = loop.call_later(INTERVAL, self._changed.set)
            await self._changed.wait()
            self._changed.clear()
            if alarm:
                alarm.cancel()
            begin = loop.time()
            try:
                await self._send(gimbal)
                said = ""
            except Error as error:
                self._counters["failed"] += 1
                if str(error) != said:
                    LOG.warning("%s: %s", self._place, error)
                said = str(error)
            await asyncio.sleep(max(0.0, begin + PACE - loop.time()))

    async def _send(self, gimbal: aio.Gimbal) -> None:
        sample = self.sample
        if sample is None or not self.is_alive:
            return
        if not sample.are_motors_on:
            await self._arm(gimbal)
            return
        goals = self.steering.goals(sample, self.north(), self.turn)
        if goals is not None:
            request = control_of(goals, self._signs)
            await gimbal.call(request, timeout=STALE, retries=0)

    async def _arm(self, gimbal: aio.Gimbal) -> None:
        now = time.monotonic()
        if self._may_arm and self.steering.frames and now - self._tried_arming >= AGAIN:
            self._tried_arming = now
            LOG.warning("%s: turning the motors on", self._place)
            await gimbal.motors_on()


def control_of(goals: list[Goal], signs: Signs) -> ControlExt:
    """The command of the board."""
    modes, targets = [], []
    for goal, sign in zip(goals, (signs.roll, signs.pitch, signs.yaw)):
        kind = (
            ControlModeKind.MODE_ANGLE_REL_FRAME if goal.is_relative else ControlModeKind.MODE_ANGLE
        )
        modes.append(ControlMode(kind))
        target = ControlAxis(speed=min(goal.speed, FASTEST), angle=sign * goal.angle)
        if goal.speed and not target.speed_raw:
            target.speed_raw = 1  # the slowest; 0 would be the speed of the parameters
        targets.append(target)
    return ControlExt(control_mode=Axes(*modes), axes=Axes(*targets))


def limits_of(profile: Profile, signs: Signs) -> tuple[Range, Range, Range]:
    """The limits of the axes: those of RC, and those of the joints where they are set."""
    found = []
    for axis in ("roll", "pitch", "yaw"):
        names = [f"rc.{axis}.rc_{end}_angle" for end in ("min", "max")]
        names += [
            f"{k}_{end}.{axis}"
            for k in ("encoder_limit", "frame_cam_angle")
            for end in ("min", "max")
        ]
        values = [float(profile.get(name, 0)) for name in names]  # type: ignore[arg-type]
        ranges = [pair for pair in zip(values[::2], values[1::2]) if pair[0] < pair[1]]
        low = max((pair[0] for pair in ranges), default=UNLIMITED[0])
        high = min((pair[1] for pair in ranges), default=UNLIMITED[1])
        ends = sorted((getattr(signs, axis) * low, getattr(signs, axis) * high))
        found.append((ends[0], ends[1]))
    roll, pitch, yaw = found
    return roll, pitch, yaw


def version_of(text: str) -> int:
    """A version such as 2.59, 2.74.5 or 2.43b9 as MAVLink has it: dev, patch, minor, major."""
    found = re.match(r"(\d+)\.(\d+)(?:\.(\d+))?(?:b(\d+))?", text)
    if found is None:
        return 0
    major, minor, patch, beta = (min(int(part or 0), 255) for part in found.groups())
    return beta << 24 | patch << 16 | minor << 8 | major
