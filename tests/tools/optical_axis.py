"""The direction of a camera, computed only from the angles of its motors.

A motor with a positive angle turns what it carries: pitch with the front down, yaw to the right, roll
with the right side down. The motor of yaw carries that of roll, which carries that of pitch.
"""

from __future__ import annotations

from math import asin, atan2, cos, degrees, radians, sin
from typing import NamedTuple


class Vector(NamedTuple):
    """In the coordinates of the frame."""

    right: float
    forward: float
    up: float


def in_frame(of_camera: Vector, motors: tuple[float, float, float]) -> Vector:
    """Returns a direction of the camera, such as its optical axis."""
    roll, pitch, yaw = (radians(angle) for angle in motors)
    right, forward, up = of_camera
    forward, up = forward * cos(pitch) + up * sin(pitch), up * cos(pitch) - forward * sin(pitch)
    right, up = right * cos(roll) + up * sin(roll), up * cos(roll) - right * sin(roll)
    right, forward = right * cos(yaw) + forward * sin(yaw), forward * cos(yaw) - right * sin(yaw)
    return Vector(right, forward, up)


def optical_axis(motors: tuple[float, float, float]) -> Vector:
    return in_frame(Vector(0, 1, 0), motors)


def degrees_down(motors: tuple[float, float, float]) -> float:
    """Returns how far below the horizon the camera looks."""
    return -degrees(asin(optical_axis(motors).up))


def degrees_right(motors: tuple[float, float, float]) -> float:
    """Returns how far to the right of the front of its frame the camera looks."""
    right, forward, _ = optical_axis(motors)
    return degrees(atan2(right, forward))


def right_side_down(motors: tuple[float, float, float]) -> float:
    """Returns how many degrees the right side of the camera is below its middle."""
    return -degrees(asin(in_frame(Vector(1, 0, 0), motors).up))
