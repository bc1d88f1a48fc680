"""Attitudes: quaternions (w, x, y, z) and angles in degrees, with the directions of MAVLink.

Roll is positive to the right, pitch up, yaw to the right. The angles are those of a gimbal: its motor of yaw
carries that of roll, which carries that of pitch, so that straight down is no special attitude. Without roll,
they are also the angles of an aircraft.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import asin, atan2, cos, degrees, hypot, isfinite, isnan, radians, remainder, sin
from typing import Optional

from sbgc.emulator import Angles

Quaternion = tuple[float, float, float, float]


def wrapped(angle: float) -> float:
    """The same direction within half a turn, from -180 to 180 degrees."""
    return remainder(angle, 360)


def quaternion_of(angles: Angles) -> Quaternion:
    (sr, cr), (sp, cp), (sy, cy) = ((sin(radians(a) / 2), cos(radians(a) / 2)) for a in angles)
    return (
        cy * cr * cp - sy * sr * sp,
        cy * sr * cp - sy * cr * sp,
        cy * cr * sp + sy * sr * cp,
        cy * sr * sp + sy * cr * cp,
    )


def angles_of(q: Quaternion) -> Angles:
    w, x, y, z = q
    return Angles(
        degrees(asin(max(-1.0, min(1.0, 2 * (y * z + w * x))))),
        degrees(atan2(2 * (w * y - x * z), 1 - 2 * (x * x + y * y))),
        degrees(atan2(2 * (w * z - x * y), 1 - 2 * (x * x + z * z))),
    )


def heading_of(q: Quaternion) -> float:
    """The direction of the nose of an aircraft, in degrees from north to the right."""
    w, x, y, z = q
    return degrees(atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)))


def rotation_of(values: Sequence[float]) -> Optional[Quaternion]:
    """The rotation of a message: None if all four numbers are NaN. Raises ValueError if it is none."""
    if all(isnan(value) for value in values):
        return None
    length = hypot(*values)
    if not all(isfinite(value) for value in values) or abs(length - 1) > 0.01:
        raise ValueError("quaternion")
    w, x, y, z = (value / length for value in values)
    return w, x, y, z
