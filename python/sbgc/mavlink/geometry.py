"""Attitudes of camera and vehicle: quaternions (w, x, y, z) and angles in degrees, as MAVLink defines them.

The angles are those of a gimbal: its yaw motor carries the roll motor, which carries the pitch motor, so that
straight down is not singular. Without roll, they are also the angles of an aircraft.
"""

from __future__ import annotations

import time
from math import asin, atan2, cos, degrees, hypot, inf, isfinite, isnan, nan, radians, remainder
from math import sin
from typing import Any, Optional

from sbgc.emulator import Angles

FRESH = 1.0  # seconds for which a heading is known after the last state
DRIFT_TIME, UNUSED_TIME = 5.0, 0.5  # seconds in which two thirds of a difference are corrected


def quaternion_of(angles: Angles) -> list[float]:
    (sr, cr), (sp, cp), (sy, cy) = ((sin(radians(a) / 2), cos(radians(a) / 2)) for a in angles)
    return [
        cy * cr * cp - sy * sr * sp,
        cy * sr * cp - sy * cr * sp,
        cy * cr * sp + sy * sr * cp,
        cy * sr * sp + sy * cr * cp,
    ]


def angles_of(q: list[float]) -> Angles:
    w, x, y, z = q
    return Angles(
        degrees(asin(max(-1.0, min(1.0, 2 * (y * z + w * x))))),
        degrees(atan2(2 * (w * y - x * z), 1 - 2 * (x * x + y * y))),
        degrees(atan2(2 * (w * z - x * y), 1 - 2 * (x * x + z * z))),
    )


def rotation_of(values: list[float]) -> Optional[list[float]]:
    """Return the rotation of a message: None if all are NaN. Raises ValueError if it is invalid."""
    if all(isnan(value) for value in values):
        return None
    length = hypot(*values)
    if not all(isfinite(value) for value in values) or abs(length - 1) > 0.01:
        raise ValueError("quaternion")
    return [value / length for value in values]


class Autopilot:
    """The newest state, and the direction of north derived from it.

    A board without a magnetometer counts yaw from its initial direction, and drifts. The camera's heading is
    the vehicle's plus the yaw joint; this is exact while the vehicle is level, and off by at most 1 degree
    while it is tilted by 15. `north`, the heading at the board's yaw 0, follows the difference slowly.
    """

    def __init__(self) -> None:
        self.turn = 0.0  # how quickly the vehicle turns to the right, degrees per second
        self.north = self._heading = nan
        self._at = self._corrected = -inf

    @property
    def heading(self) -> float:
        """The heading in degrees from north to the right; NaN if unknown."""
        return self._heading if time.monotonic() - self._at < FRESH else nan

    def take(self, values: Any) -> None:
        """Process AUTOPILOT_STATE_FOR_GIMBAL_DEVICE. Raises ValueError if it is invalid."""
        if (q := rotation_of(values.q)) is None:
            return
        w, x, y, z = q
        self._heading = degrees(atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)))
        self._at = time.monotonic()
        rate = degrees(values.angular_velocity_z or values.feed_forward_angular_velocity_z)
        self.turn = max(-360.0, min(360.0, rate)) if isfinite(rate) else 0.0

    def correct(self, offset: float, is_held: bool) -> None:
        """Correct north by the amount that the joint's yaw exceeds the board's: slowly if it holds yaw."""
        if isnan(found := self.heading + offset):
            return
        now, north = time.monotonic(), found if isnan(self.north) else self.north
        share = min(1.0, (now - self._corrected) / (DRIFT_TIME if is_held else UNUSED_TIME))
        self.north, self._corrected = north + share * remainder(found - north, 360), now
