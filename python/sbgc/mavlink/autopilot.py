"""What the autopilot tells about the vehicle: its heading, and where it is."""

from __future__ import annotations

import time
from math import degrees, isfinite, nan
from typing import Any, Optional

from sbgc.mavlink.geometry import heading_of, rotation_of, wrapped
from sbgc.mavlink.steering import Sample

FRESH = 1.0  # seconds for which a heading is known after the last state
DRIFT_TIME, UNUSED_TIME = 5.0, 0.5
"""Seconds in which two thirds of a difference between both yaws are corrected."""


class Autopilot:
    """The newest state, and the north that follows from it.

    A board without a magnetometer counts yaw from where it began, and drifts. The camera's heading is that of
    the vehicle plus the joint of yaw; this is exact while the vehicle is level, and 1 degree off at worst while
    it is tilted by 15. `north`, the heading where the board's yaw is 0, follows the difference slowly.
    """

    def __init__(self) -> None:
        self.turn = 0.0
        """How quickly the vehicle turns to the right, degrees per second."""
        self.north: Optional[float] = None
        self._heading, self._at, self._time = nan, -1e9, 0
        self._corrected = 0.0

    @property
    def is_fresh(self) -> bool:
        return time.monotonic() - self._at < FRESH

    @property
    def heading(self) -> float:
        """Degrees from north to the right; NaN if not known."""
        return self._heading if self.is_fresh else nan

    def take(self, values: Any) -> None:
        """Take AUTOPILOT_STATE_FOR_GIMBAL_DEVICE. Raises ValueError if it is wrong or old."""
        if self.is_fresh and values.time_boot_us < self._time:
            raise ValueError("late")
        q = rotation_of(values.q)
        if q is None:
            return
        self._heading, self._at, self._time = heading_of(q), time.monotonic(), values.time_boot_us
        rate = degrees(values.angular_velocity_z or values.feed_forward_angular_velocity_z)
        self.turn = max(-360.0, min(360.0, rate)) if isfinite(rate) else 0.0

    def correct(self, sample: Sample, is_held: bool) -> None:
        """Correct north by what the board has measured: slowly if an axis is held by it."""
        if not self.is_fresh:
            return
        now = time.monotonic()
        north = self._heading + sample.joints.yaw - sample.angles.yaw
        share = min(1.0, (now - self._corrected) / (DRIFT_TIME if is_held else UNUSED_TIME))
        self._corrected = now
        if self.north is None:
            self.north = north
        self.north = wrapped(self.north + share * wrapped(north - self.north))
