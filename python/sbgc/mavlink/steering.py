"""Conversion of a manager's setpoints to commands of the board: angles only, also for rates.

A rate becomes an angle that is always ahead of the camera, by the turn within the timeout of a rate. So
the board ends a rate by itself, whatever fails: it stops at that angle.

All angles are in degrees and have the signs of MAVLink: pitch up, yaw right, roll right.
"""

from __future__ import annotations

import time
from argparse import Namespace
from math import isnan, nan, remainder
from typing import NamedTuple, Optional

from sbgc.emulator import Angles
from sbgc.fields import Axes
from sbgc.mavlink.geometry import Autopilot
from sbgc.msg import ControlAxis, ControlExt, ControlMode, ControlModeKind, RealtimeData4

Range = tuple[float, float]
UNLIMITED: Range = (-1e9, 1e9)
YAW = 2
LARGEST = 719.0  # the protocol of the board has no larger angles
SLOWEST = 4000 / 32767  # degrees per second: one step of the protocol
NEAR = 3.0  # degrees around a goal that count as there
STOP = 0.15  # seconds that a camera takes to stop


class Wish(NamedTuple):
    """The order for an axis: turn to an angle, or with a rate. Without either, it holds still."""

    follows: bool  # the frame of the gimbal; else it is stabilized, yaw from where the board began
    angle: float = nan  # where a rate began, if it has
    rate: float = nan
    is_north: bool = False  # yaw counts from north, which the autopilot knows
    at: float = 0.0  # when it began


class Sample(NamedTuple):
    """The measurements of the board."""

    at: float  # time.monotonic()
    angles: Angles  # the camera: to the horizon, yaw to where the board began
    joints: Angles  # the motors: 0 when the camera is aligned with the frame
    are_motors_on: bool
    data: RealtimeData4


class Steering:
    """Keeps the newest setpoint of a gimbal, with the options of argparse."""

    def __init__(self, given: Namespace) -> None:
        self.signs = Angles(given.roll_sign, given.pitch_sign, given.yaw_sign)
        self._rate_timeout: float = given.rate_timeout
        self._speed: float = given.speed
        self.limits = [UNLIMITED] * 3
        self.clear()

    def clear(self) -> None:
        self.wishes: list[Wish] = []  # for roll, pitch and yaw
        self.limited = [False] * 3  # the axes whose goals are beyond their limits

    @property
    def needs_repetition(self) -> bool:
        """True if the board needs repeated targets, because an axis follows something."""
        return any(wish.follows or wish.is_north for wish in self.wishes)

    @property
    def is_turning(self) -> bool:
        """True while a rate has not ended."""
        ended = time.monotonic() - self._rate_timeout
        return any(wish.rate and wish.at > ended for wish in self.wishes)

    def set(self, wishes: list[Wish], sample: Sample) -> None:
        old = self.wishes or (None, None, None)
        self.wishes = [self._begun(n, wish, old[n], sample) for n, wish in enumerate(wishes)]

    def _begun(self, number: int, wish: Wish, old: Optional[Wish], sample: Sample) -> Wish:
        now, rate = time.monotonic(), 0.0 if isnan(wish.rate) else wish.rate
        if not isnan(wish.angle):
            return wish._replace(rate=0.0, at=now)
        start = (sample.joints if wish.follows else sample.angles)[number]
        if old is not None and old.follows == wish.follows and not old.is_north:
            led = old.rate * min(now - old.at, self._rate_timeout)
            off = remainder(old.angle + led - start, 360)
            if old.rate:  # not ahead of a camera that is held, and not on when it stops
                slack = abs(old.rate) * (self._rate_timeout if rate else STOP) + NEAR
                start += max(-slack, min(slack, off))
            elif abs(off) < NEAR:
                start += off
        return Wish(wish.follows, start, rate, at=now)

    def control(self, sample: Sample, autopilot: Autopilot) -> ControlExt:
        """Return the next order for the board."""
        modes, targets = [], []
        for number, wish in enumerate(self.wishes):
            speed = abs(wish.rate) or self._speed
            if number == YAW and speed and wish.follows:  # it has to keep up with the vehicle
                speed += abs(autopilot.turn)
            angle = self.signs[number] * self._goal(number, wish, sample, autopilot.north)
            if speed:  # 0 would be the speed of the parameters
                speed = max(speed, SLOWEST)
            kinds = ControlModeKind.MODE_ANGLE, ControlModeKind.MODE_ANGLE_REL_FRAME
            modes.append(ControlMode(kinds[wish.follows]))
            targets.append(ControlAxis(speed=speed, angle=angle))
        return ControlExt(control_mode=Axes(*modes), axes=Axes(*targets))

    def _goal(self, number: int, wish: Wish, sample: Sample, north: float) -> float:
        angle, offset = wish.angle + wish.rate * self._rate_timeout, 0.0
        if number == YAW and not wish.follows:  # its limits are those of the joint
            offset = sample.angles.yaw - sample.joints.yaw
            angle -= offset + (north if wish.is_north else 0.0)
        low, high = self.limits[number]
        if number == YAW and not wish.rate:  # the shortest way within the limits
            near = sample.joints.yaw + remainder(angle - sample.joints.yaw, 360)
            ways = [way for way in (near, near - 360, near + 360) if low <= way <= high]
            angle = min(ways, key=lambda way: abs(way - sample.joints.yaw), default=near)
        within = max(low, min(high, angle))
        self.limited[number] = abs(within - angle) > 0.5
        return max(-LARGEST, min(LARGEST, within + offset))
