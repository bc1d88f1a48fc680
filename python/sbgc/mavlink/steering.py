"""From what a manager wants to what the board is told: angles only, also for rates.

A rate becomes an angle that is always ahead of the camera, by what it turns in the time after which a rate
ends. So the board ends a rate by itself, whoever dies: it stops where that angle is.

All angles are degrees and count as in MAVLink: pitch up, yaw right, roll right.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum
from math import isnan, nan
from typing import NamedTuple, Optional

from sbgc.emulator import Angles
from sbgc.mavlink.geometry import wrapped

Range = tuple[float, float]
UNLIMITED: Range = (-1e9, 1e9)
YAW = 2
LARGEST = 719.0  # the protocol of the board has no larger angles
NEAR, STOP = 3.0, 0.15
"""Degrees around a goal that count as there; seconds that a camera takes to stop."""


class Frame(Enum):
    """What an angle is relative to."""

    HORIZON = "horizon"
    """Stabilized: roll and pitch to the horizon, yaw to where the board began."""
    VEHICLE = "vehicle"
    """Follows the frame of the gimbal."""
    NORTH = "north"
    """Only yaw; what the board needs is known from the autopilot."""


@dataclass(frozen=True)
class Wish:
    """What an axis shall do: an angle, or a rate. Neither: it holds still."""

    frame: Frame
    angle: float = nan
    rate: float = nan
    """Degrees per second."""


Setpoint = tuple[Wish, Wish, Wish]
"""Roll, pitch, yaw."""


@dataclass(frozen=True)
class Sample:
    """What the board has measured."""

    at: float
    """time.monotonic()."""
    angles: Angles
    """The camera: to the horizon, yaw to where the board began."""
    joints: Angles
    """The motors: 0 when the camera is aligned with the frame."""
    are_motors_on: bool
    errors: int = 0
    """SYSTEM_ERROR of the board."""
    is_calibrating: bool = False


class Goal(NamedTuple):
    """What the board is told about an axis."""

    is_relative: bool
    """The angle is one of the motor."""
    angle: float
    speed: float
    """Degrees per second; 0 is that of the parameters."""


@dataclass
class _Axis:
    frame: Frame
    goal: float
    speed: float = 0.0
    rate: float = 0.0
    at: float = 0.0
    is_direction: bool = False
    """The goal is a direction, which may be reached over other turns."""


@dataclass
class Steering:
    """Keeps the newest setpoint of a gimbal. Has no clock."""

    rate_timeout: float = 0.5
    """Seconds from the last setpoint with a rate until the camera stops."""
    speed: float = 0.0
    """Degrees per second towards an angle; 0 is that of the parameters."""
    limits: tuple[Range, Range, Range] = (UNLIMITED, UNLIMITED, UNLIMITED)
    limited: list[bool] = field(default_factory=lambda: [False, False, False])
    """The axes whose goals are beyond their limits."""
    _axes: Optional[list[_Axis]] = None

    def clear(self) -> None:
        self._axes = None
        self.limited = [False, False, False]

    @property
    def frames(self) -> Optional[list[Frame]]:
        return None if self._axes is None else [axis.frame for axis in self._axes]

    @property
    def needs_repetition(self) -> bool:
        """True if the board has to be told again where an axis belongs that follows something."""
        return self.frames is not None and any(one is not Frame.HORIZON for one in self.frames)

    def is_turning(self, now: float) -> bool:
        """True while a rate has not ended."""
        axes = self._axes or []
        return any(axis.rate and now - axis.at < self.rate_timeout for axis in axes)

    def set(self, setpoint: Setpoint, sample: Sample, now: float) -> None:
        before: list[Optional[_Axis]] = [None] * 3 if self._axes is None else [*self._axes]
        self._axes = [
            self._axis(number, wish, before[number], sample, now)
            for number, wish in enumerate(setpoint)
        ]

    def _axis(
        self, number: int, wish: Wish, before: Optional[_Axis], sample: Sample, now: float
    ) -> _Axis:
        if not isnan(wish.angle):
            return _Axis(wish.frame, wish.angle, self.speed, 0.0, now, number == YAW)
        rate = 0.0 if isnan(wish.rate) else wish.rate
        frame = Frame.HORIZON if wish.frame is Frame.NORTH else wish.frame
        measured = (sample.joints if frame is Frame.VEHICLE else sample.angles)[number]
        start = measured
        if before is not None and before.frame is frame:
            led = before.goal + before.rate * min(now - before.at, self.rate_timeout)
            off = wrapped(led - measured) if before.is_direction else led - measured
            if (
                before.rate
            ):  # it may not get ahead of a camera that is held, and not run on when it stops
                slack = abs(before.rate) * (self.rate_timeout if rate else STOP) + NEAR
                start = measured + max(-slack, min(slack, off))
            elif abs(off) < NEAR:
                start = measured + off
        return _Axis(frame, start, abs(rate), rate, now)

    def goals(
        self, sample: Sample, north: Optional[float], turn: float = 0.0
    ) -> Optional[list[Goal]]:
        """What the board shall be told now; None if nothing.

        `north` is the heading where the board's yaw is 0, if known; `turn` is the rate of the vehicle,
        which an axis that follows it has to keep up with.
        """
        if self._axes is None:
            return None
        return [
            self._goal(number, axis, sample, north, turn) for number, axis in enumerate(self._axes)
        ]

    def _goal(
        self, number: int, axis: _Axis, sample: Sample, north: Optional[float], turn: float
    ) -> Goal:
        is_relative = axis.frame is Frame.VEHICLE
        wanted = axis.goal + axis.rate * self.rate_timeout
        if number != YAW:
            angle = self._within(number, wanted)
            return Goal(is_relative, max(-LARGEST, min(LARGEST, angle)), axis.speed)
        # The joint has the limits.
        joint = sample.joints.yaw
        offset = 0.0 if is_relative else sample.angles.yaw - joint
        if axis.frame is Frame.NORTH and north is not None:
            wanted -= north
        target = wanted - offset
        if axis.is_direction:
            target = self._nearest(target, joint)
        angle = self._within(YAW, target) + offset
        speed = axis.speed + abs(turn) if axis.speed and is_relative else axis.speed
        return Goal(is_relative, max(-LARGEST, min(LARGEST, angle)), speed)

    def _within(self, number: int, angle: float) -> float:
        low, high = self.limits[number]
        found = max(low, min(high, angle))
        self.limited[number] = abs(found - angle) > 0.5
        return found

    def _nearest(self, angle: float, joint: float) -> float:
        """The shortest way within the limits."""
        low, high = self.limits[YAW]
        near = joint + wrapped(angle - joint)
        ways = [way for way in (near, near - 360, near + 360) if low <= way <= high]
        return min(ways, key=lambda way: abs(way - joint)) if ways else near
