# Generated from spec/ by generator/: edit those, then run ./dev generate.
"""Additional motors, up to seven, on drivers of their own."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, ClassVar, Optional, Union

from sbgc.fields import BYTES, RAW, REAL, TEXT, Axes, AxesOf, Elements, Field, GroupOf, ListOf
from sbgc.fields import Structure, ValueOf, Xyz
from sbgc.message import Message, Request
from sbgc.msg.enums import *
from sbgc.msg.packed import *
from sbgc.values import UNSET

if TYPE_CHECKING:
    from sbgc.msg import Confirm

__all__ = [
    "ExtMotorsAction",
    "ExtMotorsControl",
    "ExtMotorsControlConfig",
    "ExtMotorsState",
    "ExtMotorsStateRequest",
    "ExtMotorTarget16",
    "ExtMotorTarget16Param32",
    "ExtMotorTarget32",
    "ExtMotorTarget32Param16",
]

Bytes = Union[bytes, bytearray, memoryview]


class ExtMotorTarget16(Structure):
    """Targets of 16 bits, parameters of 16 bits."""

    __slots__ = ()
    _home = ("ExtMotorsControl", "setpoint16_param16[0]")

    setpoint: Field[int, int] = Field(RAW)
    """Target."""
    param1: Field[int, int] = Field(RAW)
    """Angle or speed limit."""

    def __init__(self, *, setpoint: int = UNSET, param1: int = UNSET) -> None:
        self._start(setpoint=setpoint, param1=param1)


class ExtMotorTarget16Param32(Structure):
    """Targets of 16 bits, parameters of 32 bits."""

    __slots__ = ()
    _home = ("ExtMotorsControl", "setpoint16_param32[0]")

    setpoint: Field[int, int] = Field(RAW)
    """Target."""
    param1: Field[int, int] = Field(RAW)
    """Angle or speed limit."""

    def __init__(self, *, setpoint: int = UNSET, param1: int = UNSET) -> None:
        self._start(setpoint=setpoint, param1=param1)


class ExtMotorTarget32Param16(Structure):
    """Targets of 32 bits, parameters of 16 bits."""

    __slots__ = ()
    _home = ("ExtMotorsControl", "setpoint32_param16[0]")

    setpoint: Field[int, int] = Field(RAW)
    """Target."""
    param1: Field[int, int] = Field(RAW)
    """Angle or speed limit."""

    def __init__(self, *, setpoint: int = UNSET, param1: int = UNSET) -> None:
        self._start(setpoint=setpoint, param1=param1)


class ExtMotorTarget32(Structure):
    """Targets of 32 bits, parameters of 32 bits."""

    __slots__ = ()
    _home = ("ExtMotorsControl", "setpoint32_param32[0]")

    setpoint: Field[int, int] = Field(RAW)
    """Target."""
    param1: Field[int, int] = Field(RAW)
    """Angle or speed limit."""

    def __init__(self, *, setpoint: int = UNSET, param1: int = UNSET) -> None:
        self._start(setpoint=setpoint, param1=param1)


class ExtMotorsAction(Request["Optional[Confirm]"]):
    """Turn external motors on or off, or move them to their home position.

    CMD_EXT_MOTORS_ACTION (128), to the board; 2 to 255 bytes. Effect: moves. Since firmware
    2.73. Source: Later firmware.
    """

    __slots__ = ()

    for_motors: Field[ExtMotorTargets, ExtMotorTargets] = Field(ValueOf(ExtMotorTargets))
    """The motors, and whether to confirm."""
    action: Field[ExtMotorActionKind, ExtMotorActionKind] = Field(ValueOf(ExtMotorActionKind))
    """What they do."""
    args: Field[bytes, Bytes] = Field(BYTES)
    """Arguments of later actions; send it empty."""

    def __init__(
        self,
        *,
        for_motors: ExtMotorTargets = UNSET,
        action: ExtMotorActionKind = UNSET,
        args: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(for_motors=for_motors, action=action, args=args, tail=tail)


class ExtMotorsControl(Request["Optional[Confirm]"]):
    """Set targets of external motors.

    One of the lists is present, with one element for each motor in FOR_MOTORS. The mode of a
    motor determines the meaning of its setpoint. Torque: 32767 is all that the driver can
    provide; 16 bits only. Speed: 4000/32767 deg/s, with an optional angle as PARAM1. Position:
    16384 counts per turn, with an optional speed limit as PARAM1; 16 bits may wrap.

    CMD_EXT_MOTORS_CONTROL (129), to the board; 2 to 58 bytes. Effect: moves. Since firmware
    2.73. Source: Later firmware.
    """

    __slots__ = ()

    for_motors: Field[ExtMotors, ExtMotors] = Field(ValueOf(ExtMotors))
    """The motors."""
    data_set: Field[ExtMotorsControlFields, ExtMotorsControlFields] = Field(
        ValueOf(ExtMotorsControlFields),
    )
    """Format of the targets."""
    setpoint16: Field[Optional[Elements[int]], Optional[Iterable[int]]] = Field(
        ListOf(RAW),
        optional=True,
    )
    """Targets, 16 bits. Present if data_set lacks SETPOINT_32BIT and PARAM1_16BIT and PARAM1_32BIT.
    """
    setpoint32: Field[Optional[Elements[int]], Optional[Iterable[int]]] = Field(
        ListOf(RAW),
        optional=True,
    )
    """Targets, 32 bits. Present if data_set has SETPOINT_32BIT, and lacks PARAM1_16BIT and
    PARAM1_32BIT.
    """
    setpoint16_param16: Field[Optional[Elements[ExtMotorTarget16]], Optional[Iterable[ExtMotorTarget16]]] = Field(
        ListOf(GroupOf(ExtMotorTarget16)),
        optional=True,
    )
    """Targets of 16 bits, parameters of 16 bits. Present if data_set has PARAM1_16BIT, and lacks
    SETPOINT_32BIT.
    """
    setpoint16_param32: Field[Optional[Elements[ExtMotorTarget16Param32]], Optional[Iterable[ExtMotorTarget16Param32]]] = Field(
        ListOf(GroupOf(ExtMotorTarget16Param32)),
        optional=True,
    )
    """Targets of 16 bits, parameters of 32 bits. Present if data_set has PARAM1_32BIT, and lacks
    SETPOINT_32BIT and PARAM1_16BIT.
    """
    setpoint32_param16: Field[Optional[Elements[ExtMotorTarget32Param16]], Optional[Iterable[ExtMotorTarget32Param16]]] = Field(
        ListOf(GroupOf(ExtMotorTarget32Param16)),
        optional=True,
    )
    """Targets of 32 bits, parameters of 16 bits. Present if data_set has SETPOINT_32BIT and
    PARAM1_16BIT.
    """
    setpoint32_param32: Field[Optional[Elements[ExtMotorTarget32]], Optional[Iterable[ExtMotorTarget32]]] = Field(
        ListOf(GroupOf(ExtMotorTarget32)),
        optional=True,
    )
    """Targets of 32 bits, parameters of 32 bits. Present if data_set has SETPOINT_32BIT and
    PARAM1_32BIT, and lacks PARAM1_16BIT.
    """

    def __init__(
        self,
        *,
        for_motors: ExtMotors = UNSET,
        data_set: ExtMotorsControlFields = UNSET,
        setpoint16: Optional[Iterable[int]] = UNSET,
        setpoint32: Optional[Iterable[int]] = UNSET,
        setpoint16_param16: Optional[Iterable[ExtMotorTarget16]] = UNSET,
        setpoint16_param32: Optional[Iterable[ExtMotorTarget16Param32]] = UNSET,
        setpoint32_param16: Optional[Iterable[ExtMotorTarget32Param16]] = UNSET,
        setpoint32_param32: Optional[Iterable[ExtMotorTarget32]] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            for_motors=for_motors,
            data_set=data_set,
            setpoint16=setpoint16,
            setpoint32=setpoint32,
            setpoint16_param16=setpoint16_param16,
            setpoint16_param32=setpoint16_param32,
            setpoint32_param16=setpoint32_param16,
            setpoint32_param32=setpoint32_param32,
            tail=tail,
        )


class ExtMotorsControlConfig(Request["Optional[Confirm]"]):
    """Configure external motors.

    CMD_EXT_MOTORS_CONTROL_CONFIG (130), to the board; 3 to 12 bytes. Effect: sets. Since
    firmware 2.73. Source: Later firmware.
    """

    __slots__ = ()

    for_motors: Field[ExtMotorTargets, ExtMotorTargets] = Field(ValueOf(ExtMotorTargets))
    """The motors, and whether to confirm."""
    data_set: Field[ExtMotorsControlConfigFields, ExtMotorsControlConfigFields] = Field(
        ValueOf(ExtMotorsControlConfigFields),
    )
    """Which of the following fields are present."""
    mode: Field[Optional[ExtMotorMode], Optional[ExtMotorMode]] = Field(
        ValueOf(ExtMotorMode),
        optional=True,
    )
    """What their setpoints control. Present if data_set has MODE."""
    max_speed: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Speed limit in all modes. Unit: deg/s. Present if data_set has MAX_SPEED."""
    max_speed_raw: Field[Optional[int], Optional[int]] = Field(RAW, optional=True, of="max_speed")
    """The number on the wire for max_speed."""
    max_acceleration: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Acceleration limit in the modes SPEED and POSITION. Unit: deg/s^2. Present if data_set has
    MAX_ACCELERATION.
    """
    max_acceleration_raw: Field[Optional[int], Optional[int]] = Field(
        RAW,
        optional=True,
        of="max_acceleration",
    )
    """The number on the wire for max_acceleration."""
    jerk_slope: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Time in which the acceleration rises to its limit in the modes SPEED and POSITION. Unit: ms.
    Present if data_set has JERK_SLOPE.
    """
    jerk_slope_raw: Field[Optional[int], Optional[int]] = Field(RAW, optional=True, of="jerk_slope")
    """The number on the wire for jerk_slope."""
    max_torque: Field[Optional[int], Optional[int]] = Field(RAW, optional=True)
    """Torque limit in all modes; 65535 is all that the driver can provide. Present if data_set has
    MAX_TORQUE.
    """

    def __init__(
        self,
        *,
        for_motors: ExtMotorTargets = UNSET,
        data_set: ExtMotorsControlConfigFields = UNSET,
        mode: Optional[ExtMotorMode] = UNSET,
        max_speed: Optional[float] = UNSET,
        max_speed_raw: Optional[int] = UNSET,
        max_acceleration: Optional[float] = UNSET,
        max_acceleration_raw: Optional[int] = UNSET,
        jerk_slope: Optional[float] = UNSET,
        jerk_slope_raw: Optional[int] = UNSET,
        max_torque: Optional[int] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            for_motors=for_motors,
            data_set=data_set,
            mode=mode,
            max_speed=max_speed,
            max_speed_raw=max_speed_raw,
            max_acceleration=max_acceleration,
            max_acceleration_raw=max_acceleration_raw,
            jerk_slope=jerk_slope,
            jerk_slope_raw=jerk_slope_raw,
            max_torque=max_torque,
            tail=tail,
        )


class ExtMotorsState(Message):
    """State of an external motor.

    CMD_EXT_MOTORS_STATE (131), from the board; 5 to 50 bytes, and later firmware may append
    more. Since firmware 2.73. Source: Later firmware.
    """

    __slots__ = ()

    motor_id: Field[int, int] = Field(RAW)
    """The motor, counted from 0. Range: 0 to 6."""
    data_set: Field[ExtMotorsStateFields, ExtMotorsStateFields] = Field(
        ValueOf(ExtMotorsStateFields),
    )
    """Which of the following fields are present."""
    control_mode: Field[Optional[ExtMotorMode], Optional[ExtMotorMode]] = Field(
        ValueOf(ExtMotorMode),
        optional=True,
    )
    """What its setpoint controls. Present if data_set has CONTROL_MODE."""
    torque: Field[Optional[int], Optional[int]] = Field(RAW, optional=True)
    """Torque; 32767 is all that the driver can provide. Present if data_set has TORQUE."""
    torque_setpoint: Field[Optional[int], Optional[int]] = Field(RAW, optional=True)
    """Target torque. Present if data_set has TORQUE_SETPOINT."""
    speed16: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Speed. Unit: deg/s. Positive pitch is down, negative up; positive yaw is right, negative
    left; for roll it is not known. Present if data_set has SPEED16.
    """
    speed16_raw: Field[Optional[int], Optional[int]] = Field(RAW, optional=True, of="speed16")
    """The number on the wire for speed16."""
    speed16_setpoint: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Target speed. Unit: deg/s. Positive pitch is down, negative up; positive yaw is right,
    negative left; for roll it is not known. Present if data_set has SPEED16_SETPOINT.
    """
    speed16_setpoint_raw: Field[Optional[int], Optional[int]] = Field(
        RAW,
        optional=True,
        of="speed16_setpoint",
    )
    """The number on the wire for speed16_setpoint."""
    speed32: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Speed. Unit: rad/s. Positive pitch is down, negative up; positive yaw is right, negative
    left; for roll it is not known. Present if data_set has SPEED32.
    """
    speed32_raw: Field[Optional[int], Optional[int]] = Field(RAW, optional=True, of="speed32")
    """The number on the wire for speed32."""
    speed32_setpoint: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Target speed. Unit: rad/s. Positive pitch is down, negative up; positive yaw is right,
    negative left; for roll it is not known. Present if data_set has SPEED32_SETPOINT.
    """
    speed32_setpoint_raw: Field[Optional[int], Optional[int]] = Field(
        RAW,
        optional=True,
        of="speed32_setpoint",
    )
    """The number on the wire for speed32_setpoint."""
    angle16: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Angle. Unit: deg. Positive pitch is down, negative up; positive yaw is right, negative left;
    for roll it is not known. Present if data_set has ANGLE16.
    """
    angle16_raw: Field[Optional[int], Optional[int]] = Field(RAW, optional=True, of="angle16")
    """The number on the wire for angle16."""
    angle16_setpoint: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Target angle. Unit: deg. Positive pitch is down, negative up; positive yaw is right, negative
    left; for roll it is not known. Present if data_set has ANGLE16_SETPOINT.
    """
    angle16_setpoint_raw: Field[Optional[int], Optional[int]] = Field(
        RAW,
        optional=True,
        of="angle16_setpoint",
    )
    """The number on the wire for angle16_setpoint."""
    angle32: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Angle. Unit: deg. Positive pitch is down, negative up; positive yaw is right, negative left;
    for roll it is not known. Present if data_set has ANGLE32.
    """
    angle32_raw: Field[Optional[int], Optional[int]] = Field(RAW, optional=True, of="angle32")
    """The number on the wire for angle32."""
    angle32_setpoint: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Target angle. Unit: deg. Positive pitch is down, negative up; positive yaw is right, negative
    left; for roll it is not known. Present if data_set has ANGLE32_SETPOINT.
    """
    angle32_setpoint_raw: Field[Optional[int], Optional[int]] = Field(
        RAW,
        optional=True,
        of="angle32_setpoint",
    )
    """The number on the wire for angle32_setpoint."""
    state_flags: Field[Optional[ExtMotorStatus], Optional[int]] = Field(
        ValueOf(ExtMotorStatus),
        optional=True,
    )
    """State of the motor. Present if data_set has STATE_FLAGS."""
    max_speed: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Speed limit. Unit: deg/s. Present if data_set has MAX_SPEED."""
    max_speed_raw: Field[Optional[int], Optional[int]] = Field(RAW, optional=True, of="max_speed")
    """The number on the wire for max_speed."""
    max_acceleration: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Acceleration limit. Unit: deg/s^2. Present if data_set has MAX_ACCELERATION."""
    max_acceleration_raw: Field[Optional[int], Optional[int]] = Field(
        RAW,
        optional=True,
        of="max_acceleration",
    )
    """The number on the wire for max_acceleration."""
    jerk_slope: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Time in which the acceleration rises to its limit. Unit: ms. Present if data_set has
    JERK_SLOPE.
    """
    jerk_slope_raw: Field[Optional[int], Optional[int]] = Field(RAW, optional=True, of="jerk_slope")
    """The number on the wire for jerk_slope."""
    max_torque: Field[Optional[int], Optional[int]] = Field(RAW, optional=True)
    """Torque limit. Present if data_set has MAX_TORQUE."""
    current: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Current. Unit: mA. Present if data_set has CURRENT."""
    current_raw: Field[Optional[int], Optional[int]] = Field(RAW, optional=True, of="current")
    """The number on the wire for current."""
    battery_voltage: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Supply voltage. Unit: V. Present if data_set has BATTERY_VOLTAGE."""
    battery_voltage_raw: Field[Optional[int], Optional[int]] = Field(
        RAW,
        optional=True,
        of="battery_voltage",
    )
    """The number on the wire for battery_voltage."""
    motor_temperature: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Temperature of the motor. Unit: degC. Present if data_set has MOTOR_TEMPERATURE."""
    motor_temperature_raw: Field[Optional[int], Optional[int]] = Field(
        RAW,
        optional=True,
        of="motor_temperature",
    )
    """The number on the wire for motor_temperature."""
    driver_temperature: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Temperature of the driver. Unit: degC. Present if data_set has DRIVER_TEMPERATURE."""
    driver_temperature_raw: Field[Optional[int], Optional[int]] = Field(
        RAW,
        optional=True,
        of="driver_temperature",
    )
    """The number on the wire for driver_temperature."""

    def __init__(
        self,
        *,
        motor_id: int = UNSET,
        data_set: ExtMotorsStateFields = UNSET,
        control_mode: Optional[ExtMotorMode] = UNSET,
        torque: Optional[int] = UNSET,
        torque_setpoint: Optional[int] = UNSET,
        speed16: Optional[float] = UNSET,
        speed16_raw: Optional[int] = UNSET,
        speed16_setpoint: Optional[float] = UNSET,
        speed16_setpoint_raw: Optional[int] = UNSET,
        speed32: Optional[float] = UNSET,
        speed32_raw: Optional[int] = UNSET,
        speed32_setpoint: Optional[float] = UNSET,
        speed32_setpoint_raw: Optional[int] = UNSET,
        angle16: Optional[float] = UNSET,
        angle16_raw: Optional[int] = UNSET,
        angle16_setpoint: Optional[float] = UNSET,
        angle16_setpoint_raw: Optional[int] = UNSET,
        angle32: Optional[float] = UNSET,
        angle32_raw: Optional[int] = UNSET,
        angle32_setpoint: Optional[float] = UNSET,
        angle32_setpoint_raw: Optional[int] = UNSET,
        state_flags: Optional[int] = UNSET,
        max_speed: Optional[float] = UNSET,
        max_speed_raw: Optional[int] = UNSET,
        max_acceleration: Optional[float] = UNSET,
        max_acceleration_raw: Optional[int] = UNSET,
        jerk_slope: Optional[float] = UNSET,
        jerk_slope_raw: Optional[int] = UNSET,
        max_torque: Optional[int] = UNSET,
        current: Optional[float] = UNSET,
        current_raw: Optional[int] = UNSET,
        battery_voltage: Optional[float] = UNSET,
        battery_voltage_raw: Optional[int] = UNSET,
        motor_temperature: Optional[float] = UNSET,
        motor_temperature_raw: Optional[int] = UNSET,
        driver_temperature: Optional[float] = UNSET,
        driver_temperature_raw: Optional[int] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            motor_id=motor_id,
            data_set=data_set,
            control_mode=control_mode,
            torque=torque,
            torque_setpoint=torque_setpoint,
            speed16=speed16,
            speed16_raw=speed16_raw,
            speed16_setpoint=speed16_setpoint,
            speed16_setpoint_raw=speed16_setpoint_raw,
            speed32=speed32,
            speed32_raw=speed32_raw,
            speed32_setpoint=speed32_setpoint,
            speed32_setpoint_raw=speed32_setpoint_raw,
            angle16=angle16,
            angle16_raw=angle16_raw,
            angle16_setpoint=angle16_setpoint,
            angle16_setpoint_raw=angle16_setpoint_raw,
            angle32=angle32,
            angle32_raw=angle32_raw,
            angle32_setpoint=angle32_setpoint,
            angle32_setpoint_raw=angle32_setpoint_raw,
            state_flags=state_flags,
            max_speed=max_speed,
            max_speed_raw=max_speed_raw,
            max_acceleration=max_acceleration,
            max_acceleration_raw=max_acceleration_raw,
            jerk_slope=jerk_slope,
            jerk_slope_raw=jerk_slope_raw,
            max_torque=max_torque,
            current=current,
            current_raw=current_raw,
            battery_voltage=battery_voltage,
            battery_voltage_raw=battery_voltage_raw,
            motor_temperature=motor_temperature,
            motor_temperature_raw=motor_temperature_raw,
            driver_temperature=driver_temperature,
            driver_temperature_raw=driver_temperature_raw,
            tail=tail,
        )


class ExtMotorsStateRequest(Request["ExtMotorsState"]):
    """Request the state of external motors.

    The board answers once for each motor.

    CMD_EXT_MOTORS_STATE (131), to the board; 5 bytes. Effect: reads. Since firmware 2.73.
    Source: Later firmware.
    """

    __slots__ = ()

    for_motors: Field[ExtMotors, ExtMotors] = Field(ValueOf(ExtMotors))
    """The motors."""
    data_set: Field[ExtMotorsStateFields, ExtMotorsStateFields] = Field(
        ValueOf(ExtMotorsStateFields),
    )
    """Data to send."""

    def __init__(
        self,
        *,
        for_motors: ExtMotors = UNSET,
        data_set: ExtMotorsStateFields = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(for_motors=for_motors, data_set=data_set, tail=tail)
