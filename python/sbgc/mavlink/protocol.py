"""Numbers of MAVLink, from common.xml."""

from __future__ import annotations

from enum import IntEnum, IntFlag

Ids = tuple[int, int]
"""A system and a component."""
AUTOPILOT = 1
"""The component of the autopilot."""
GIMBALS = (154, 171, 172, 173, 174, 175)
"""The components of gimbals: at most six in one system."""
MANAGES_GIMBALS = 0x40000
"""The capability COMPONENT_IMPLEMENTS_GIMBAL_MANAGER."""
ONE_COMPONENT = 1
"""The gimbal_device_id of a gimbal that is one component with its manager."""
CAPABILITIES, OF_YAW = 0x17FE, 0x1700
"""GIMBAL_DEVICE_CAP_FLAGS: neutral; axis, follow and lock of roll, pitch and yaw; yaw of the earth."""


class Flags(IntFlag):
    """GIMBAL_DEVICE_FLAGS, and GIMBAL_MANAGER_FLAGS, which have the same values."""

    RETRACT = 1
    NEUTRAL = 2
    ROLL_LOCK = 4
    PITCH_LOCK = 8
    YAW_LOCK = 16
    YAW_IN_VEHICLE_FRAME = 32
    YAW_IN_EARTH_FRAME = 64
    ACCEPTS_YAW_IN_EARTH_FRAME = 128


LOCKS = Flags.ROLL_LOCK, Flags.PITCH_LOCK, Flags.YAW_LOCK
LEVEL = Flags.ROLL_LOCK | Flags.PITCH_LOCK


class Failure(IntFlag):
    """GIMBAL_DEVICE_ERROR_FLAGS; the first three are axes at their limits."""

    POWER_ERROR = 16
    MOTOR_ERROR = 32
    SOFTWARE_ERROR = 64
    COMMS_ERROR = 128
    CALIBRATION_RUNNING = 256
    NO_MANAGER = 512


class Result(IntEnum):
    """MAV_RESULT."""

    ACCEPTED = 0
    TEMPORARILY_REJECTED = 1
    DENIED = 2
    UNSUPPORTED = 3
    FAILED = 4


class Command(IntEnum):
    """MAV_CMD."""

    SET_MESSAGE_INTERVAL = 511
    REQUEST_MESSAGE = 512
    MANAGER_PITCHYAW = 1000
    MANAGER_CONFIGURE = 1001


class Number(IntEnum):
    """The numbers of messages."""

    HEARTBEAT = 0
    MANAGER_INFORMATION = 280
    MANAGER_STATUS = 281
    DEVICE_INFORMATION = 283
    DEVICE_STATUS = 285
    COMPONENT_INFORMATION_BASIC = 396
