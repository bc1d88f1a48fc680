# Generated from spec/ by generator/: edit those, then run ./dev generate.
"""Messages by their role, independent of their names."""

from __future__ import annotations

from sbgc import msg

AnglesRequest = msg.GetAnglesRequest
BatteryRequest = msg.RealtimeData3Request
Details = msg.BoardInfo3
GyroCalibration = msg.CalibGyro
Introduction = msg.BoardInfo
MotorsOff = msg.MotorsOff
MotorsOn = msg.MotorsOn


def angles_of(message: msg.GetAngles) -> list[float]:
    """The measured angles, by axis."""
    return [axis.imu_angle for axis in message.axes]


def battery_voltage_of(message: msg.RealtimeData3) -> float:
    """The voltage of the battery."""
    return message.bat_level
