"""Numbers of MAVLink, from common.xml."""

from __future__ import annotations

from enum import IntEnum, IntFlag

Ids = tuple[int, int]
"""A system and a component."""
AUTOPILOT = 1  # the component of the autopilot
GIMBALS = (154, 171, 172, 173, 174, 175)  # the components of gimbals: at most six in one system
MANAGES_GIMBALS = 0x40000  # the capability COMPONENT_IMPLEMENTS_GIMBAL_MANAGER
ONE_COMPONENT = 1  # the gimbal_device_id of a gimbal that is one component with its manager
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


class Failure(IntEnum):
    """GIMBAL_DEVICE_ERROR_FLAGS; 1, 2 and 4 are axes at their limits."""

    POWER_ERROR, MOTOR_ERROR, SOFTWARE_ERROR, COMMS_ERROR = 16, 32, 64, 128
    CALIBRATION_RUNNING, NO_MANAGER = 256, 512


class Result(IntEnum):
    """MAV_RESULT."""

    ACCEPTED, TEMPORARILY_REJECTED, DENIED, UNSUPPORTED, FAILED = range(5)


class Command(IntEnum):
    """MAV_CMD."""

    SET_MESSAGE_INTERVAL, REQUEST_MESSAGE = 511, 512
    MANAGER_PITCHYAW, MANAGER_CONFIGURE = 1000, 1001


class Number(IntEnum):
    """The numbers of messages."""

    HEARTBEAT, MANAGER_INFORMATION, MANAGER_STATUS = 0, 280, 281
    DEVICE_INFORMATION, DEVICE_STATUS, COMPONENT_INFORMATION_BASIC = 283, 285, 396
