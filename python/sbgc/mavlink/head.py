"""A gimbal on a serial line: its measurements and its setpoints."""

from __future__ import annotations

import asyncio
import time
from argparse import Namespace
from collections import Counter, deque
from contextlib import suppress
from math import nan
from typing import Optional

from sbgc import aio
from sbgc.emulator import Angles
from sbgc.errors import Error
from sbgc.link import Identity
from sbgc.mavlink import LOG
from sbgc.mavlink.geometry import Autopilot
from sbgc.mavlink.steering import UNLIMITED, Range, Sample, Steering, Wish
from sbgc.msg import OtherFlags, RealtimeData4
from sbgc.parameters import Profile

INTERVAL = 0.05  # seconds between samples, and between repetitions for an axis that follows
PACE = 0.02  # a board takes 50 commands a second
STALE, LOST, AGAIN = 0.5, 2.0, 2.0  # seconds without a sample, and until the next try


class Head:
    """Drives one gimbal. `aim()` takes setpoints; nothing moves while its motors are off.

    With the option `arm`, it turns them on, once. `counters` counts setpoints that had no effect.
    """

    def __init__(self, given: Namespace, counters: Counter[str]) -> None:
        self.identity: Optional[Identity] = None
        self.steering, self.autopilot = Steering(given), Autopilot()
        self._counters = counters
        self._place, self._may_arm = given.port, given.arm
        self._changed, self._tried_arming = asyncio.Event(), -AGAIN
        self._due = 0.0  # when the next command is, at this pace
        self._samples: deque[Sample] = deque(maxlen=4)

    @property
    def sample(self) -> Optional[Sample]:
        """The newest sample; None while the board does not report."""
        is_alive = self._samples and time.monotonic() - self._samples[-1].at < STALE
        return self._samples[-1] if is_alive else None

    @property
    def rates(self) -> Angles:
        """Return the angular rates, in degrees per second; NaN if unknown."""
        old, new = self._samples[0], self._samples[-1]
        seconds = max(new.at - old.at, INTERVAL) if new is not old else nan
        return Angles(*((b - a) / seconds for a, b in zip(old.angles, new.angles)))

    def aim(self, wishes: list[Wish]) -> bool:
        """Accept a setpoint; returns False if line or motors keep it from having an effect."""
        sample = self.sample
        if sample is None or not (sample.are_motors_on or self._may_arm):
            self._counters["no_gimbal" if sample is None else "motors_off"] += 1
            return False
        self.steering.set(wishes, sample)
        self._changed.set()
        return True

    async def run(self) -> None:
        """Serve the gimbal forever; search for it when it is lost."""
        while True:
            try:
                async with aio.connect(self._place) as gimbal:
                    await self._serve(gimbal)
            except (Error, OSError) as error:
                LOG.warning("%s: %s; trying again", self._place, error)
            self.steering.clear()
            await asyncio.sleep(AGAIN)

    async def _serve(self, gimbal: aio.Gimbal) -> None:
        self.identity = gimbal.identity
        profile = await gimbal.read_profile(await gimbal.active_profile())
        axes = zip(Angles._fields, self.steering.signs)
        self.steering.limits = [limits_of(profile, axis, sign) for axis, sign in axes]
        LOG.info("%s: roll, pitch and yaw within %s", self._place, self.steering.limits)
        driving = asyncio.create_task(self._drive(gimbal))
        try:
            async with await gimbal.stream(RealtimeData4, INTERVAL, timeout=LOST) as samples:
                async for data in samples:
                    self._take(data)
                    if driving.done():
                        driving.result()
        finally:
            driving.cancel()
            if self.steering.is_turning and gimbal.is_connected:
                with suppress(Error):  # which would take the place of a cancellation
                    await gimbal.stop()

    def _take(self, data: RealtimeData4) -> None:
        angles, joints = (
            Angles(*(sign * angle for sign, angle in zip(self.steering.signs, measured)))
            for measured in (data.angle, data.rotor_angle)
        )
        if self.sample is None:  # what was wanted before is old
            self.steering.clear()
            self._samples.clear()
        are_motors_on = bool(data.other_flags & OtherFlags.MOTORS_ON)
        self._samples.append(Sample(time.monotonic(), angles, joints, are_motors_on, data))
        is_held = any(wish.is_north for wish in self.steering.wishes)
        self.autopilot.correct(joints.yaw - angles.yaw, is_held)
        if are_motors_on:
            self._may_arm = False  # who turns them off later wants them off
        elif not self._may_arm:
            self.steering.clear()
        if self.steering.needs_repetition and time.monotonic() > self._due + PACE:
            self._changed.set()

    async def _drive(self, gimbal: aio.Gimbal) -> None:
        while True:
            await self._changed.wait()
            self._changed.clear()
            self._due, sample = max(self._due, time.monotonic()) + PACE, self.sample
            try:
                if sample is not None and self.steering.wishes:
                    await self._send(gimbal, sample)
            except Error as error:
                self._counters["failed"] += 1
                LOG.warning("%s: %s", self._place, error)
            await asyncio.sleep(self._due - 2 * PACE - time.monotonic())  # two may be early

    async def _send(self, gimbal: aio.Gimbal, sample: Sample) -> None:
        now = time.monotonic()
        if sample.are_motors_on:
            request = self.steering.control(sample, self.autopilot)
            await gimbal.call(request, timeout=STALE, retries=0)
        elif self._may_arm and now - self._tried_arming >= AGAIN:
            self._tried_arming = now
            LOG.warning("%s: turning the motors on", self._place)
            await gimbal.motors_on()


def limits_of(profile: Profile, axis: str, sign: float) -> Range:
    """Return the limits of an axis: those of RC, and those of the joint where they are set."""
    names = f"rc.{axis}.rc_%s_angle", f"encoder_limit_%s.{axis}", f"frame_cam_angle_%s.{axis}"
    found = [UNLIMITED]
    for name in names:
        low, high = (float(str(profile.get(name % end, 0))) for end in ("min", "max"))
        found += [(low, high)] if low < high else []
    low, high = max(low for low, _ in found), min(high for _, high in found)
    return (low, high) if sign > 0 else (-high, -low)
