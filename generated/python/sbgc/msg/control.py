# Generated from spec/ by generator/: edit those, then run ./dev generate.
"""Moving the camera and querying its orientation."""

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
    "AxisState",
    "AxisStateExt",
    "Control",
    "ControlAxis",
    "ControlConfig",
    "ControlConfigAxis",
    "ControlExt",
    "ControlExtAxis",
    "ControlExtCommand",
    "ControlQuatAttitude",
    "ControlQuatAttitudePacked",
    "ControlQuatConfig",
    "ControlQuatDisabled",
    "ControlQuatSpeed",
    "ControlQuatSpeedAttitude",
    "ControlQuatSpeedAttitudePacked",
    "ControlQuatStatus",
    "ControlQuatStatusRequest",
    "Event",
    "ExecuteMenu",
    "ExecuteMenuExt",
    "GetAngles",
    "GetAnglesExt",
    "GetAnglesExtRequest",
    "GetAnglesRequest",
    "HelperData",
    "HelperDataExt",
    "MotorsOff",
    "MotorsOffExt",
    "MotorsOn",
    "SyncMotors",
]

Bytes = Union[bytes, bytearray, memoryview]


class ControlAxis(Structure):
    """Target of each axis."""

    __slots__ = ()
    _home = ("Control", "axes.roll")

    speed: Field[float, float] = Field(REAL)
    """Speed of the motion; the acceleration limit in the parameters may restrict it. Unit: deg/s.
    Positive pitch is down, negative up; positive yaw is right, negative left; for roll it is
    not known. Sent as FineSpeed if CONTROL_FLAG_HIGH_RES_SPEED is set.
    """
    speed_raw: Field[int, int] = Field(RAW, of="speed")
    """The number on the wire for speed."""
    angle: Field[float, float] = Field(REAL)
    """Target angle; in MODE_RC the RC signal, -500 to 500, in MODE_RC_HIGH_RES -16384 to 16384.
    Unit: deg. Positive pitch is down, negative up; positive yaw is right, negative left; for
    roll it is not known.
    """
    angle_raw: Field[int, int] = Field(RAW, of="angle")
    """The number on the wire for angle."""

    def __init__(
        self,
        *,
        speed: float = UNSET,
        speed_raw: int = UNSET,
        angle: float = UNSET,
        angle_raw: int = UNSET,
    ) -> None:
        self._start(speed=speed, speed_raw=speed_raw, angle=angle, angle_raw=angle_raw)


class ControlExtAxis(Structure):
    """Motion of each axis."""

    __slots__ = ()
    _home = ("ControlExtCommand", "axes.roll")

    mode: Field[Optional[ControlMode], Optional[int]] = Field(ValueOf(ControlMode), optional=True)
    """Mode. Present if data_set has {AXIS}_SPEED or {AXIS}_ANGLE."""
    flags: Field[Optional[ControlExtFlags], Optional[ControlExtFlags]] = Field(
        ValueOf(ControlExtFlags),
        optional=True,
    )
    """Further options. Present if data_set has {AXIS}_SPEED or {AXIS}_ANGLE."""
    speed: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Speed. Unit: deg/s. Positive pitch is down, negative up; positive yaw is right, negative
    left; for roll it is not known. Sent as FineSpeed if CONTROL_FLAG_HIGH_RES_SPEED is set.
    Present if data_set has {AXIS}_SPEED, and lacks {AXIS}_SPEED_32BIT.
    """
    speed_raw: Field[Optional[int], Optional[int]] = Field(RAW, optional=True, of="speed")
    """The number on the wire for speed."""
    speed_32: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Speed, with 32 bits. Unit: deg/s. Positive pitch is down, negative up; positive yaw is right,
    negative left; for roll it is not known. Present if data_set has {AXIS}_SPEED and
    {AXIS}_SPEED_32BIT. Unconfirmed.
    """
    speed_32_raw: Field[Optional[int], Optional[int]] = Field(RAW, optional=True, of="speed_32")
    """The number on the wire for speed_32."""
    angle: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Target angle, or an RC signal as in CMD_CONTROL. Unit: deg. Positive pitch is down, negative
    up; positive yaw is right, negative left; for roll it is not known. Present if data_set
    has {AXIS}_ANGLE, and lacks {AXIS}_ANGLE_32BIT.
    """
    angle_raw: Field[Optional[int], Optional[int]] = Field(RAW, optional=True, of="angle")
    """The number on the wire for angle."""
    angle_32: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Target angle, with 32 bits. Unit: deg. Positive pitch is down, negative up; positive yaw is
    right, negative left; for roll it is not known. Present if data_set has {AXIS}_ANGLE and
    {AXIS}_ANGLE_32BIT. Unconfirmed.
    """
    angle_32_raw: Field[Optional[int], Optional[int]] = Field(RAW, optional=True, of="angle_32")
    """The number on the wire for angle_32."""

    def __init__(
        self,
        *,
        mode: Optional[int] = UNSET,
        flags: Optional[ControlExtFlags] = UNSET,
        speed: Optional[float] = UNSET,
        speed_raw: Optional[int] = UNSET,
        speed_32: Optional[float] = UNSET,
        speed_32_raw: Optional[int] = UNSET,
        angle: Optional[float] = UNSET,
        angle_raw: Optional[int] = UNSET,
        angle_32: Optional[float] = UNSET,
        angle_32_raw: Optional[int] = UNSET,
    ) -> None:
        self._start(
            mode=mode,
            flags=flags,
            speed=speed,
            speed_raw=speed_raw,
            speed_32=speed_32,
            speed_32_raw=speed_32_raw,
            angle=angle,
            angle_raw=angle_raw,
            angle_32=angle_32,
            angle_32_raw=angle_32_raw,
        )


class ControlConfigAxis(Structure):
    """Options of each axis."""

    __slots__ = ()
    _home = ("ControlConfig", "axes.roll")

    KEEP_RC_LPF: ClassVar[int] = 0
    """For rc_lpf, as raw value: the filter does not change."""
    KEEP_ACC_LIMIT: ClassVar[int] = 0
    """For acc_limit, as raw value: the limit does not change."""
    KEEP_JERK_SLOPE: ClassVar[int] = 0
    """For jerk_slope, as raw value: the time does not change."""
    NO_JERK_SLOPE: ClassVar[int] = 1
    """For jerk_slope, as raw value: the acceleration changes at once."""
    angle_lpf: Field[int, int] = Field(RAW)
    """Low-pass filter of the angle, 0 (off) to 15."""
    speed_lpf: Field[int, int] = Field(RAW)
    """Low-pass filter of the speed, 0 (off) to 15."""
    rc_lpf: Field[int, int] = Field(RAW)
    """Low-pass filter of an RC signal. Range: 1 to 255. Value 0: the filter does not change."""
    acc_limit: Field[float, float] = Field(REAL)
    """Acceleration limit in all modes. Range: 1 to 65535 deg/s^2. Raw value 0: the limit does not
    change. Since firmware 2.70b1.
    """
    acc_limit_raw: Field[int, int] = Field(RAW, of="acc_limit")
    """The number on the wire for acc_limit."""
    jerk_slope: Field[float, float] = Field(REAL)
    """Time in which the acceleration rises to its limit. Range: 40 to 5100 ms. Raw value 0: the
    time does not change. Raw value 1: the acceleration changes at once. Since firmware
    2.70b8.
    """
    jerk_slope_raw: Field[int, int] = Field(RAW, of="jerk_slope")
    """The number on the wire for jerk_slope."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        angle_lpf: int = UNSET,
        speed_lpf: int = UNSET,
        rc_lpf: int = UNSET,
        acc_limit: float = UNSET,
        acc_limit_raw: int = UNSET,
        jerk_slope: float = UNSET,
        jerk_slope_raw: int = UNSET,
        reserved: Bytes = UNSET,
    ) -> None:
        self._start(
            angle_lpf=angle_lpf,
            speed_lpf=speed_lpf,
            rc_lpf=rc_lpf,
            acc_limit=acc_limit,
            acc_limit_raw=acc_limit_raw,
            jerk_slope=jerk_slope,
            jerk_slope_raw=jerk_slope_raw,
            reserved=reserved,
        )


class AxisState(Structure):
    """State of each axis."""

    __slots__ = ()
    _home = ("GetAngles", "axes.roll")

    imu_angle: Field[float, float] = Field(REAL)
    """Measured angle; wraps after two full turns. Unit: deg. Positive pitch is down, negative up;
    positive yaw is right, negative left; for roll it is not known.
    """
    imu_angle_raw: Field[int, int] = Field(RAW, of="imu_angle")
    """The number on the wire for imu_angle."""
    rc_target_angle: Field[float, float] = Field(REAL)
    """Target angle, set by RC or by control commands. Unit: deg. Positive pitch is down, negative
    up; positive yaw is right, negative left; for roll it is not known.
    """
    rc_target_angle_raw: Field[int, int] = Field(RAW, of="rc_target_angle")
    """The number on the wire for rc_target_angle."""
    rc_speed: Field[float, float] = Field(REAL)
    """Target speed; 0 once the target is reached. Unit: deg/s. Positive pitch is down, negative up;
    positive yaw is right, negative left; for roll it is not known.
    """
    rc_speed_raw: Field[int, int] = Field(RAW, of="rc_speed")
    """The number on the wire for rc_speed."""

    def __init__(
        self,
        *,
        imu_angle: float = UNSET,
        imu_angle_raw: int = UNSET,
        rc_target_angle: float = UNSET,
        rc_target_angle_raw: int = UNSET,
        rc_speed: float = UNSET,
        rc_speed_raw: int = UNSET,
    ) -> None:
        self._start(
            imu_angle=imu_angle,
            imu_angle_raw=imu_angle_raw,
            rc_target_angle=rc_target_angle,
            rc_target_angle_raw=rc_target_angle_raw,
            rc_speed=rc_speed,
            rc_speed_raw=rc_speed_raw,
        )


class AxisStateExt(Structure):
    """State of each axis."""

    __slots__ = ()
    _home = ("GetAnglesExt", "axes.roll")

    imu_angle: Field[float, float] = Field(REAL)
    """Measured angle; wraps after two full turns. Unit: deg. Positive pitch is down, negative up;
    positive yaw is right, negative left; for roll it is not known.
    """
    imu_angle_raw: Field[int, int] = Field(RAW, of="imu_angle")
    """The number on the wire for imu_angle."""
    rc_target_angle: Field[float, float] = Field(REAL)
    """Target angle. Unit: deg. Positive pitch is down, negative up; positive yaw is right, negative
    left; for roll it is not known.
    """
    rc_target_angle_raw: Field[int, int] = Field(RAW, of="rc_target_angle")
    """The number on the wire for rc_target_angle."""
    stator_rotor_angle: Field[float, float] = Field(REAL)
    """Angle of the joint, from an encoder or the second IMU; 0 in the normal position, accumulated
    over full turns. Unit: deg. Positive pitch is down, negative up; positive yaw is right,
    negative left; for roll it is not known.
    """
    stator_rotor_angle_raw: Field[int, int] = Field(RAW, of="stator_rotor_angle")
    """The number on the wire for stator_rotor_angle."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        imu_angle: float = UNSET,
        imu_angle_raw: int = UNSET,
        rc_target_angle: float = UNSET,
        rc_target_angle_raw: int = UNSET,
        stator_rotor_angle: float = UNSET,
        stator_rotor_angle_raw: int = UNSET,
        reserved: Bytes = UNSET,
    ) -> None:
        self._start(
            imu_angle=imu_angle,
            imu_angle_raw=imu_angle_raw,
            rc_target_angle=rc_target_angle,
            rc_target_angle_raw=rc_target_angle_raw,
            stator_rotor_angle=stator_rotor_angle,
            stator_rotor_angle_raw=stator_rotor_angle_raw,
            reserved=reserved,
        )


class Control(Request["Optional[Confirm]"]):
    """Move the camera, with one mode for all axes.

    Overrides RC until a command with MODE_NO_CONTROL and zeros. Send at most 50 per second. A
    board keeps the last speed when the link is lost; CMD_CONTROL_CONFIG can set a timeout, and
    turn confirmations off. The command sets a target or a speed, never a step, so it may be
    repeated; the last one counts.

    CMD_CONTROL (67), to the board, simple form; 13 bytes. Effect: moves. Source: Outgoing
    commands L694-L715; Variables L1147-L1152.
    """

    __slots__ = ()

    control_mode: Field[ControlMode, int] = Field(ValueOf(ControlMode))
    """Mode of all three axes."""
    axes: Field[Axes[ControlAxis], Axes[ControlAxis]] = Field(AxesOf(GroupOf(ControlAxis)))
    """Target of each axis."""

    def __init__(
        self,
        *,
        control_mode: int = UNSET,
        axes: Axes[ControlAxis] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(control_mode=control_mode, axes=axes, tail=tail)


class ControlExt(Request["Optional[Confirm]"]):
    """Move the camera, with a mode for each axis.

    Overrides RC until a command with MODE_NO_CONTROL and zeros. Send at most 50 per second. A
    board keeps the last speed when the link is lost; CMD_CONTROL_CONFIG can set a timeout, and
    turn confirmations off. The command sets a target or a speed, never a step, so it may be
    repeated; the last one counts.

    CMD_CONTROL (67), to the board, extended form; 15 bytes. Effect: moves. Since firmware
    2.55b5. Source: Outgoing commands L694-L715; Variables L1147-L1152.
    """

    __slots__ = ()

    control_mode: Field[Axes[ControlMode], Axes[ControlMode]] = Field(AxesOf(ValueOf(ControlMode)))
    """Mode of each axis."""
    axes: Field[Axes[ControlAxis], Axes[ControlAxis]] = Field(AxesOf(GroupOf(ControlAxis)))
    """Target of each axis."""

    def __init__(
        self,
        *,
        control_mode: Axes[ControlMode] = UNSET,
        axes: Axes[ControlAxis] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(control_mode=control_mode, axes=axes, tail=tail)


class ControlExtCommand(Request["Optional[Confirm]"]):
    """Move the camera, with the data that each axis needs.

    Like CMD_CONTROL, but an axis without data keeps its state, and speeds and angles may have
    32 bits.

    CMD_CONTROL_EXT (121), to the board; 2 to 32 bytes. Effect: moves. Since firmware 2.68.
    Source: Later firmware.
    """

    __slots__ = ()

    data_set: Field[ControlExtFields, ControlExtFields] = Field(ValueOf(ControlExtFields))
    """Which of the following fields are present."""
    axes: Field[Axes[ControlExtAxis], Axes[ControlExtAxis]] = Field(AxesOf(GroupOf(ControlExtAxis)))
    """Motion of each axis."""

    def __init__(
        self,
        *,
        data_set: ControlExtFields = UNSET,
        axes: Axes[ControlExtAxis] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(data_set=data_set, axes=axes, tail=tail)


class ControlConfig(Request["Optional[Confirm]"]):
    """Configure serial control until the next start.

    A control command counts only if no other port has a higher priority. All ports start with
    priority 0.

    CMD_CONTROL_CONFIG (90), to the board; 41 bytes. Effect: sets, moves. Since firmware 2.61.
    Source: Later firmware.
    """

    __slots__ = ()

    NO_TIMEOUT: ClassVar[int] = 0
    """For timeout_ms, as raw value: no timeout."""
    KEEP_PRIORITY: ClassVar[int] = 0
    """For ch_priority and this_ch_priority, as raw value: the priority does not change."""
    timeout_ms: Field[float, float] = Field(REAL)
    """Time without a control command after which serial control ends and RC takes over, which is
    not a stop. Unit: ms. Raw value 0: no timeout.
    """
    timeout_ms_raw: Field[int, int] = Field(RAW, of="timeout_ms")
    """The number on the wire for timeout_ms."""
    ch_priority: Field[Elements[int], Iterable[int]] = Field(ListOf(RAW))
    """Priority of UART1, RC_SERIAL, UART2 and USB_VCP or UART3. Range: 1 to 255. Value 0: the
    priority does not change.
    """
    this_ch_priority: Field[int, int] = Field(RAW)
    """Priority of this port. Range: 1 to 255. Value 0: the priority does not change."""
    axes: Field[Axes[ControlConfigAxis], Axes[ControlConfigAxis]] = Field(
        AxesOf(GroupOf(ControlConfigAxis)),
    )
    """Options of each axis."""
    rc_expo_rate: Field[int, int] = Field(RAW)
    """Expo rate of RC signals. Range: 0 to 100."""
    flags: Field[ControlConfigFlags, ControlConfigFlags] = Field(ValueOf(ControlConfigFlags))
    """Options."""
    euler_order: Field[EulerOrderChoice, int] = Field(ValueOf(EulerOrderChoice))
    """Order of the Euler angles. Since firmware 2.72."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        timeout_ms: float = UNSET,
        timeout_ms_raw: int = UNSET,
        ch_priority: Iterable[int] = UNSET,
        this_ch_priority: int = UNSET,
        axes: Axes[ControlConfigAxis] = UNSET,
        rc_expo_rate: int = UNSET,
        flags: ControlConfigFlags = UNSET,
        euler_order: int = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            timeout_ms=timeout_ms,
            timeout_ms_raw=timeout_ms_raw,
            ch_priority=ch_priority,
            this_ch_priority=this_ch_priority,
            axes=axes,
            rc_expo_rate=rc_expo_rate,
            flags=flags,
            euler_order=euler_order,
            reserved=reserved,
            tail=tail,
        )


class ControlQuatDisabled(Request["Optional[Confirm]"]):
    """End control with quaternions.

    Quaternions are W, X, Y, Z; X is the axis of pitch, Y of roll and Z of yaw.

    CMD_CONTROL_QUAT (140), to the board, disabled form; 2 bytes. Effect: moves. Since firmware
    2.73. Source: Later firmware.
    """

    __slots__ = ()

    mode: Field[ControlQuatMode, ControlQuatMode] = Field(ValueOf(ControlQuatMode))
    """Always DISABLED. Always 0."""
    flags: Field[ControlQuatFlags, ControlQuatFlags] = Field(ValueOf(ControlQuatFlags))
    """Options."""

    def __init__(
        self,
        *,
        mode: ControlQuatMode = UNSET,
        flags: ControlQuatFlags = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(mode=mode, flags=flags, tail=tail)


class ControlQuatSpeed(Request["Optional[Confirm]"]):
    """Turn the camera at a speed.

    Quaternions are W, X, Y, Z; X is the axis of pitch, Y of roll and Z of yaw.

    CMD_CONTROL_QUAT (140), to the board, speed form; 14 bytes. Effect: moves. Since firmware
    2.73. Source: Later firmware.
    """

    __slots__ = ()

    mode: Field[ControlQuatMode, ControlQuatMode] = Field(ValueOf(ControlQuatMode))
    """SPEED or SPEED_LIMITED."""
    flags: Field[ControlQuatFlags, ControlQuatFlags] = Field(ValueOf(ControlQuatFlags))
    """Options."""
    target_speed: Field[Xyz[float], Xyz[float]] = Field(AxesOf(REAL, Xyz))
    """Rotation vector of the motion. Unit: rad/s. Positive pitch is down, negative up; positive yaw
    is right, negative left; for roll it is not known.
    """
    target_speed_raw: Field[Xyz[float], Xyz[float]] = Field(AxesOf(RAW, Xyz), of="target_speed")
    """The number on the wire for target_speed."""

    def __init__(
        self,
        *,
        mode: ControlQuatMode = UNSET,
        flags: ControlQuatFlags = UNSET,
        target_speed: Xyz[float] = UNSET,
        target_speed_raw: Xyz[float] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            mode=mode,
            flags=flags,
            target_speed=target_speed,
            target_speed_raw=target_speed_raw,
            tail=tail,
        )


class ControlQuatAttitude(Request["Optional[Confirm]"]):
    """Turn the camera to an attitude.

    Quaternions are W, X, Y, Z; X is the axis of pitch, Y of roll and Z of yaw.

    CMD_CONTROL_QUAT (140), to the board, attitude form; 18 bytes. Effect: moves. Since firmware
    2.73. Source: Later firmware.
    """

    __slots__ = ()

    mode: Field[ControlQuatMode, ControlQuatMode] = Field(ValueOf(ControlQuatMode))
    """Always ATTITUDE. Always 2."""
    flags: Field[ControlQuatFlags, ControlQuatFlags] = Field(ValueOf(ControlQuatFlags))
    """Options."""
    target_attitude: Field[Elements[float], Iterable[float]] = Field(ListOf(REAL))
    """Quaternion of length 1: W, X, Y, Z. Range: -1 to 1."""

    def __init__(
        self,
        *,
        mode: ControlQuatMode = UNSET,
        flags: ControlQuatFlags = UNSET,
        target_attitude: Iterable[float] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(mode=mode, flags=flags, target_attitude=target_attitude, tail=tail)


class ControlQuatAttitudePacked(Request["Optional[Confirm]"]):
    """Turn the camera to an attitude, packed.

    Quaternions are W, X, Y, Z; X is the axis of pitch, Y of roll and Z of yaw.

    CMD_CONTROL_QUAT (140), to the board, attitude_packed form; 10 bytes. Effect: moves. Since
    firmware 2.73. Source: Later firmware.
    """

    __slots__ = ()

    mode: Field[ControlQuatMode, ControlQuatMode] = Field(ValueOf(ControlQuatMode))
    """Always ATTITUDE. Always 2."""
    flags: Field[ControlQuatFlags, ControlQuatFlags] = Field(ValueOf(ControlQuatFlags))
    """Options, with ATTITUDE_PACKED."""
    target_attitude: Field[PackedQuaternion, int] = Field(ValueOf(PackedQuaternion))
    """The attitude."""

    def __init__(
        self,
        *,
        mode: ControlQuatMode = UNSET,
        flags: ControlQuatFlags = UNSET,
        target_attitude: int = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(mode=mode, flags=flags, target_attitude=target_attitude, tail=tail)


class ControlQuatSpeedAttitude(Request["Optional[Confirm]"]):
    """Turn the camera at a speed and hold it to an attitude.

    Quaternions are W, X, Y, Z; X is the axis of pitch, Y of roll and Z of yaw.

    CMD_CONTROL_QUAT (140), to the board, speed_attitude form; 30 bytes. Effect: moves. Since
    firmware 2.73. Source: Later firmware.
    """

    __slots__ = ()

    mode: Field[ControlQuatMode, ControlQuatMode] = Field(ValueOf(ControlQuatMode))
    """Always SPEED_ATTITUDE. Always 5."""
    flags: Field[ControlQuatFlags, ControlQuatFlags] = Field(ValueOf(ControlQuatFlags))
    """Options."""
    target_attitude: Field[Elements[float], Iterable[float]] = Field(ListOf(REAL))
    """Quaternion of length 1: W, X, Y, Z. Range: -1 to 1."""
    target_speed: Field[Xyz[float], Xyz[float]] = Field(AxesOf(REAL, Xyz))
    """Rotation vector of the motion. Unit: rad/s. Positive pitch is down, negative up; positive yaw
    is right, negative left; for roll it is not known.
    """
    target_speed_raw: Field[Xyz[float], Xyz[float]] = Field(AxesOf(RAW, Xyz), of="target_speed")
    """The number on the wire for target_speed."""

    def __init__(
        self,
        *,
        mode: ControlQuatMode = UNSET,
        flags: ControlQuatFlags = UNSET,
        target_attitude: Iterable[float] = UNSET,
        target_speed: Xyz[float] = UNSET,
        target_speed_raw: Xyz[float] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            mode=mode,
            flags=flags,
            target_attitude=target_attitude,
            target_speed=target_speed,
            target_speed_raw=target_speed_raw,
            tail=tail,
        )


class ControlQuatSpeedAttitudePacked(Request["Optional[Confirm]"]):
    """Turn the camera at a speed and hold it to an attitude, packed.

    Quaternions are W, X, Y, Z; X is the axis of pitch, Y of roll and Z of yaw.

    CMD_CONTROL_QUAT (140), to the board, speed_attitude_packed form; 22 bytes. Effect: moves.
    Since firmware 2.73. Source: Later firmware.
    """

    __slots__ = ()

    mode: Field[ControlQuatMode, ControlQuatMode] = Field(ValueOf(ControlQuatMode))
    """Always SPEED_ATTITUDE. Always 5."""
    flags: Field[ControlQuatFlags, ControlQuatFlags] = Field(ValueOf(ControlQuatFlags))
    """Options, with ATTITUDE_PACKED."""
    target_attitude: Field[PackedQuaternion, int] = Field(ValueOf(PackedQuaternion))
    """The attitude."""
    target_speed: Field[Xyz[float], Xyz[float]] = Field(AxesOf(REAL, Xyz))
    """Rotation vector of the motion. Unit: rad/s. Positive pitch is down, negative up; positive yaw
    is right, negative left; for roll it is not known.
    """
    target_speed_raw: Field[Xyz[float], Xyz[float]] = Field(AxesOf(RAW, Xyz), of="target_speed")
    """The number on the wire for target_speed."""

    def __init__(
        self,
        *,
        mode: ControlQuatMode = UNSET,
        flags: ControlQuatFlags = UNSET,
        target_attitude: int = UNSET,
        target_speed: Xyz[float] = UNSET,
        target_speed_raw: Xyz[float] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            mode=mode,
            flags=flags,
            target_attitude=target_attitude,
            target_speed=target_speed,
            target_speed_raw=target_speed_raw,
            tail=tail,
        )


class ControlQuatStatus(Message):
    """State of the control with quaternions.

    CMD_CONTROL_QUAT_STATUS (141), from the board; 2 to 97 bytes, and later firmware may append
    more. Since firmware 2.73. Source: Later firmware.
    """

    __slots__ = ()

    data_set: Field[ControlQuatStatusFields, ControlQuatStatusFields] = Field(
        ValueOf(ControlQuatStatusFields),
    )
    """Which of the following fields are present."""
    data_set_high: Field[Optional[int], Optional[int]] = Field(RAW, optional=True)
    """The upper half of DATA_SET, if that has 32 bits. Unconfirmed."""
    mode: Field[Optional[ControlQuatMode], Optional[ControlQuatMode]] = Field(
        ValueOf(ControlQuatMode),
        optional=True,
    )
    """Mode of the last command. Present if data_set has MODE."""
    flags: Field[Optional[ControlQuatStatusFlags], Optional[ControlQuatStatusFlags]] = Field(
        ValueOf(ControlQuatStatusFlags),
        optional=True,
    )
    """Options of the last command. Present if data_set has MODE."""
    target_attitude: Field[Optional[Elements[float]], Optional[Iterable[float]]] = Field(
        ListOf(REAL),
        optional=True,
    )
    """Attitude of the last command: W, X, Y, Z. Range: -1 to 1. Present if data_set has
    TARGET_ATTITUDE.
    """
    setpoint_attitude: Field[Optional[Elements[float]], Optional[Iterable[float]]] = Field(
        ListOf(REAL),
        optional=True,
    )
    """Attitude that the board stabilizes: W, X, Y, Z. Range: -1 to 1. Present if data_set has
    SETPOINT_ATTITUDE.
    """
    actual_attitude: Field[Optional[Elements[float]], Optional[Iterable[float]]] = Field(
        ListOf(REAL),
        optional=True,
    )
    """Measured attitude: W, X, Y, Z. Range: -1 to 1. Present if data_set has ACTUAL_ATTITUDE."""
    target_speed: Field[Optional[Xyz[float]], Optional[Xyz[float]]] = Field(
        AxesOf(REAL, Xyz),
        optional=True,
    )
    """Speed of the last command. Unit: deg/s. Positive pitch is down, negative up; positive yaw is
    right, negative left; for roll it is not known. Present if data_set has TARGET_SPEED.
    """
    target_speed_raw: Field[Optional[Xyz[int]], Optional[Xyz[int]]] = Field(
        AxesOf(RAW, Xyz),
        optional=True,
        of="target_speed",
    )
    """The number on the wire for target_speed."""
    setpoint_speed: Field[Optional[Xyz[float]], Optional[Xyz[float]]] = Field(
        AxesOf(REAL, Xyz),
        optional=True,
    )
    """Speed that the board stabilizes. Unit: deg/s. Positive pitch is down, negative up; positive
    yaw is right, negative left; for roll it is not known. Present if data_set has
    SETPOINT_SPEED.
    """
    setpoint_speed_raw: Field[Optional[Xyz[int]], Optional[Xyz[int]]] = Field(
        AxesOf(RAW, Xyz),
        optional=True,
        of="setpoint_speed",
    )
    """The number on the wire for setpoint_speed."""
    actual_speed: Field[Optional[Xyz[float]], Optional[Xyz[float]]] = Field(
        AxesOf(REAL, Xyz),
        optional=True,
    )
    """Measured speed. Unit: deg/s. Positive pitch is down, negative up; positive yaw is right,
    negative left; for roll it is not known. Present if data_set has ACTUAL_SPEED.
    """
    actual_speed_raw: Field[Optional[Xyz[int]], Optional[Xyz[int]]] = Field(
        AxesOf(RAW, Xyz),
        optional=True,
        of="actual_speed",
    )
    """The number on the wire for actual_speed."""
    target_attitude_packed: Field[Optional[PackedQuaternion], Optional[int]] = Field(
        ValueOf(PackedQuaternion),
        optional=True,
    )
    """Attitude of the last command. Present if data_set has TARGET_ATTITUDE_PACKED."""
    setpoint_attitude_packed: Field[Optional[PackedQuaternion], Optional[int]] = Field(
        ValueOf(PackedQuaternion),
        optional=True,
    )
    """Attitude that the board stabilizes. Present if data_set has SETPOINT_ATTITUDE_PACKED."""
    actual_attitude_packed: Field[Optional[PackedQuaternion], Optional[int]] = Field(
        ValueOf(PackedQuaternion),
        optional=True,
    )
    """Measured attitude. Present if data_set has ACTUAL_ATTITUDE_PACKED."""

    def __init__(
        self,
        *,
        data_set: ControlQuatStatusFields = UNSET,
        data_set_high: Optional[int] = UNSET,
        mode: Optional[ControlQuatMode] = UNSET,
        flags: Optional[ControlQuatStatusFlags] = UNSET,
        target_attitude: Optional[Iterable[float]] = UNSET,
        setpoint_attitude: Optional[Iterable[float]] = UNSET,
        actual_attitude: Optional[Iterable[float]] = UNSET,
        target_speed: Optional[Xyz[float]] = UNSET,
        target_speed_raw: Optional[Xyz[int]] = UNSET,
        setpoint_speed: Optional[Xyz[float]] = UNSET,
        setpoint_speed_raw: Optional[Xyz[int]] = UNSET,
        actual_speed: Optional[Xyz[float]] = UNSET,
        actual_speed_raw: Optional[Xyz[int]] = UNSET,
        target_attitude_packed: Optional[int] = UNSET,
        setpoint_attitude_packed: Optional[int] = UNSET,
        actual_attitude_packed: Optional[int] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            data_set=data_set,
            data_set_high=data_set_high,
            mode=mode,
            flags=flags,
            target_attitude=target_attitude,
            setpoint_attitude=setpoint_attitude,
            actual_attitude=actual_attitude,
            target_speed=target_speed,
            target_speed_raw=target_speed_raw,
            setpoint_speed=setpoint_speed,
            setpoint_speed_raw=setpoint_speed_raw,
            actual_speed=actual_speed,
            actual_speed_raw=actual_speed_raw,
            target_attitude_packed=target_attitude_packed,
            setpoint_attitude_packed=setpoint_attitude_packed,
            actual_attitude_packed=actual_attitude_packed,
            tail=tail,
        )


class ControlQuatStatusRequest(Request["ControlQuatStatus"]):
    """Request the state of the control with quaternions.

    CMD_CONTROL_QUAT_STATUS (141), to the board; 4 bytes. Effect: reads. Since firmware 2.73.
    Source: Later firmware.
    """

    __slots__ = ()

    data_set: Field[ControlQuatStatusFields, ControlQuatStatusFields] = Field(
        ValueOf(ControlQuatStatusFields),
    )
    """Data to send, in 32 bits with the reserved bytes."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        data_set: ControlQuatStatusFields = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(data_set=data_set, reserved=reserved, tail=tail)


class ControlQuatConfig(Request["Confirm"]):
    """Configure the control with quaternions.

    CMD_CONTROL_QUAT_CONFIG (142), to the board; 2 to 24 bytes. Effect: sets. Since firmware
    2.73. Source: Later firmware.
    """

    __slots__ = ()

    ACC_UNLIMITED: ClassVar[int] = 0
    """For acc_limit, as raw value: no limit."""
    JERK_UNLIMITED: ClassVar[int] = 0
    """For jerk_slope, as raw value: the acceleration changes at once."""
    NO_FILTER: ClassVar[int] = 0
    """For attitude_lpf_freq and speed_lpf_freq, as raw value: no filter."""
    data_set: Field[ControlQuatConfigFields, ControlQuatConfigFields] = Field(
        ValueOf(ControlQuatConfigFields),
    )
    """Which of the following fields are present."""
    max_speed: Field[Optional[Xyz[float]], Optional[Xyz[float]]] = Field(
        AxesOf(REAL, Xyz),
        optional=True,
    )
    """Speed limit of each axis. Unit: deg/s. Present if data_set has MAX_SPEED."""
    max_speed_raw: Field[Optional[Xyz[int]], Optional[Xyz[int]]] = Field(
        AxesOf(RAW, Xyz),
        optional=True,
        of="max_speed",
    )
    """The number on the wire for max_speed."""
    acc_limit: Field[Optional[Xyz[float]], Optional[Xyz[float]]] = Field(
        AxesOf(REAL, Xyz),
        optional=True,
    )
    """Acceleration limit of each axis. Range: 1 to 65535 deg/s^2. Raw value 0: no limit. Present if
    data_set has ACC_LIMIT.
    """
    acc_limit_raw: Field[Optional[Xyz[int]], Optional[Xyz[int]]] = Field(
        AxesOf(RAW, Xyz),
        optional=True,
        of="acc_limit",
    )
    """The number on the wire for acc_limit."""
    jerk_slope: Field[Optional[Xyz[float]], Optional[Xyz[float]]] = Field(
        AxesOf(REAL, Xyz),
        optional=True,
    )
    """Time in which the acceleration of each axis rises to its limit. Range: 1 to 65535 ms. Raw
    value 0: the acceleration changes at once. Present if data_set has JERK_SLOPE.
    """
    jerk_slope_raw: Field[Optional[Xyz[int]], Optional[Xyz[int]]] = Field(
        AxesOf(RAW, Xyz),
        optional=True,
        of="jerk_slope",
    )
    """The number on the wire for jerk_slope."""
    flags: Field[Optional[ControlQuatConfigFlags], Optional[ControlQuatConfigFlags]] = Field(
        ValueOf(ControlQuatConfigFlags),
        optional=True,
    )
    """Options. Present if data_set has FLAGS."""
    attitude_lpf_freq: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Low-pass filter of the attitude. Range: 1 to 255 Hz. Raw value 0: no filter. Present if
    data_set has ATTITUDE_LPF_FREQ.
    """
    attitude_lpf_freq_raw: Field[Optional[int], Optional[int]] = Field(
        RAW,
        optional=True,
        of="attitude_lpf_freq",
    )
    """The number on the wire for attitude_lpf_freq."""
    speed_lpf_freq: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Low-pass filter of the speed. Range: 1 to 255 Hz. Raw value 0: no filter. Present if data_set
    has SPEED_LPF_FREQ.
    """
    speed_lpf_freq_raw: Field[Optional[int], Optional[int]] = Field(
        RAW,
        optional=True,
        of="speed_lpf_freq",
    )
    """The number on the wire for speed_lpf_freq."""

    def __init__(
        self,
        *,
        data_set: ControlQuatConfigFields = UNSET,
        max_speed: Optional[Xyz[float]] = UNSET,
        max_speed_raw: Optional[Xyz[int]] = UNSET,
        acc_limit: Optional[Xyz[float]] = UNSET,
        acc_limit_raw: Optional[Xyz[int]] = UNSET,
        jerk_slope: Optional[Xyz[float]] = UNSET,
        jerk_slope_raw: Optional[Xyz[int]] = UNSET,
        flags: Optional[ControlQuatConfigFlags] = UNSET,
        attitude_lpf_freq: Optional[float] = UNSET,
        attitude_lpf_freq_raw: Optional[int] = UNSET,
        speed_lpf_freq: Optional[float] = UNSET,
        speed_lpf_freq_raw: Optional[int] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            data_set=data_set,
            max_speed=max_speed,
            max_speed_raw=max_speed_raw,
            acc_limit=acc_limit,
            acc_limit_raw=acc_limit_raw,
            jerk_slope=jerk_slope,
            jerk_slope_raw=jerk_slope_raw,
            flags=flags,
            attitude_lpf_freq=attitude_lpf_freq,
            attitude_lpf_freq_raw=attitude_lpf_freq_raw,
            speed_lpf_freq=speed_lpf_freq,
            speed_lpf_freq_raw=speed_lpf_freq_raw,
            tail=tail,
        )


class GetAngles(Message):
    """Camera angles and targets.

    CMD_GET_ANGLES (73), from the board; 18 bytes, and later firmware may append more. Source:
    Incoming commands L428-L434; Variables L1156-L1161.
    """

    __slots__ = ()

    axes: Field[Axes[AxisState], Axes[AxisState]] = Field(AxesOf(GroupOf(AxisState)))
    """State of each axis."""

    def __init__(self, *, axes: Axes[AxisState] = UNSET, tail: Bytes = UNSET) -> None:
        self._start(axes=axes, tail=tail)


class GetAnglesRequest(Request["GetAngles"]):
    """Request camera angles and targets.

    CMD_GET_ANGLES (73), to the board; 0 bytes. Effect: reads. Source: Outgoing commands
    L753-L755.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class GetAnglesExt(Message):
    """Camera angles, targets and joint angles.

    CMD_GET_ANGLES_EXT (61), from the board; 54 bytes, and later firmware may append more. Since
    board 3.0. Source: Incoming commands L436-L443; Variables L1162-L1165.
    """

    __slots__ = ()

    axes: Field[Axes[AxisStateExt], Axes[AxisStateExt]] = Field(AxesOf(GroupOf(AxisStateExt)))
    """State of each axis."""

    def __init__(self, *, axes: Axes[AxisStateExt] = UNSET, tail: Bytes = UNSET) -> None:
        self._start(axes=axes, tail=tail)


class GetAnglesExtRequest(Request["GetAnglesExt"]):
    """Request angles, targets and joint angles.

    CMD_GET_ANGLES_EXT (61), to the board; 0 bytes. Effect: reads. Since board 3.0. Source:
    Outgoing commands L753-L755.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class MotorsOn(Request["Confirm"]):
    """Turn the motors on.

    CMD_MOTORS_ON (77), to the board; 0 bytes. Effect: moves. Source: Outgoing commands
    L724-L726.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class MotorsOff(Request["Confirm"]):
    """Turn the motors off.

    CMD_MOTORS_OFF (109), to the board, simple form; 0 bytes. Effect: moves. Source: Outgoing
    commands L728-L730.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class MotorsOffExt(Request["Confirm"]):
    """Turn the motors off, in one of several ways.

    CMD_MOTORS_OFF (109), to the board, extended form; 1 byte. Effect: moves. Since firmware
    2.68b7. Source: Outgoing commands L728-L730.
    """

    __slots__ = ()

    mode: Field[MotorsOffMode, MotorsOffMode] = Field(ValueOf(MotorsOffMode))
    """How to turn them off."""

    def __init__(self, *, mode: MotorsOffMode = UNSET, tail: Bytes = UNSET) -> None:
        self._start(mode=mode, tail=tail)


class SyncMotors(Request["Confirm"]):
    """Power one motor as a synchronous motor for some time, then turn the motors off.

    CMD_SYNC_MOTORS (123), to the board; 6 bytes. Effect: moves. Since firmware 2.70b9. Source:
    Later firmware.
    """

    __slots__ = ()

    HOLD: ClassVar[int] = 0
    """For angle, as raw value: the motor holds its position."""
    axis: Field[SyncMotorAxis, SyncMotorAxis] = Field(ValueOf(SyncMotorAxis))
    """The motor."""
    power: Field[int, int] = Field(RAW)
    """Power of the windings."""
    time_ms: Field[float, float] = Field(REAL)
    """How long the windings have power. Unit: ms."""
    time_ms_raw: Field[int, int] = Field(RAW, of="time_ms")
    """The number on the wire for time_ms."""
    angle: Field[int, int] = Field(RAW)
    """Angle to turn. Value 0: the motor holds its position."""

    def __init__(
        self,
        *,
        axis: SyncMotorAxis = UNSET,
        power: int = UNSET,
        time_ms: float = UNSET,
        time_ms_raw: int = UNSET,
        angle: int = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            axis=axis,
            power=power,
            time_ms=time_ms,
            time_ms_raw=time_ms_raw,
            angle=angle,
            tail=tail,
        )


class Event(Message):
    """An event, if the host has requested such events with CMD_DATA_STREAM_INTERVAL.

    CMD_EVENT (102), from the board; 4 bytes, and later firmware may append more. Since firmware
    2.65b7. Source: Later firmware.
    """

    __slots__ = ()

    event_id: Field[EventId, EventId] = Field(ValueOf(EventId))
    """What has happened."""
    event_type: Field[EventTypes, EventTypes] = Field(ValueOf(EventTypes))
    """Kind of the event."""
    param: Field[bytes, Bytes] = Field(BYTES)
    """Data that depend on the event."""

    def __init__(
        self,
        *,
        event_id: EventId = UNSET,
        event_type: EventTypes = UNSET,
        param: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(event_id=event_id, event_type=event_type, param=param, tail=tail)


class ExecuteMenu(Request["Optional[Confirm]"]):
    """Execute a menu action.

    CMD_EXECUTE_MENU (69), to the board, simple form; 1 byte. Effect: sets, stores, moves,
    restarts. Source: Outgoing commands L732-L734; Variables L1166-L1167.
    """

    __slots__ = ()

    cmd_id: Field[MenuCommand, MenuCommand] = Field(ValueOf(MenuCommand))
    """Which action."""

    def __init__(self, *, cmd_id: MenuCommand = UNSET, tail: Bytes = UNSET) -> None:
        self._start(cmd_id=cmd_id, tail=tail)


class ExecuteMenuExt(Request["Optional[Confirm]"]):
    """Execute a menu action and say when to confirm it.

    CMD_EXECUTE_MENU (69), to the board, extended form; 2 bytes. Effect: sets, stores, moves,
    restarts. Since firmware 2.73.8. Source: Outgoing commands L732-L734; Variables L1166-L1167.
    """

    __slots__ = ()

    cmd_id: Field[MenuCommand, MenuCommand] = Field(ValueOf(MenuCommand))
    """Which action."""
    param: Field[ExecuteMenuFlags, ExecuteMenuFlags] = Field(ValueOf(ExecuteMenuFlags))
    """When the board confirms the action."""

    def __init__(
        self,
        *,
        cmd_id: MenuCommand = UNSET,
        param: ExecuteMenuFlags = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(cmd_id=cmd_id, param=param, tail=tail)


class HelperData(Request["Optional[Confirm]"]):
    """Report acceleration and tilt of the frame to the board.

    CMD_HELPER_DATA (72), to the board, simple form; 10 bytes. Effect: moves. Source: Outgoing
    commands L736-L751; Variables L1247-L1251.
    """

    __slots__ = ()

    frame_acc: Field[Xyz[float], Xyz[float]] = Field(AxesOf(REAL, Xyz))
    """Linear acceleration of the frame; keeps the horizon level during acceleration. Unit: g.
    Positive pitch is down, negative up; positive yaw is right, negative left; for roll it is
    not known.
    """
    frame_acc_raw: Field[Xyz[int], Xyz[int]] = Field(AxesOf(RAW, Xyz), of="frame_acc")
    """The number on the wire for frame_acc."""
    frame_angle_roll: Field[float, float] = Field(REAL)
    """Sideways tilt of the frame. Unit: deg. Raw value 0: with FRAME_ANGLE_PITCH 0 too, not used.
    """
    frame_angle_roll_raw: Field[int, int] = Field(RAW, of="frame_angle_roll")
    """The number on the wire for frame_angle_roll."""
    frame_angle_pitch: Field[float, float] = Field(REAL)
    """Forward tilt of the frame. Unit: deg. Raw value 0: with FRAME_ANGLE_ROLL 0 too, not used."""
    frame_angle_pitch_raw: Field[int, int] = Field(RAW, of="frame_angle_pitch")
    """The number on the wire for frame_angle_pitch."""

    def __init__(
        self,
        *,
        frame_acc: Xyz[float] = UNSET,
        frame_acc_raw: Xyz[int] = UNSET,
        frame_angle_roll: float = UNSET,
        frame_angle_roll_raw: int = UNSET,
        frame_angle_pitch: float = UNSET,
        frame_angle_pitch_raw: int = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            frame_acc=frame_acc,
            frame_acc_raw=frame_acc_raw,
            frame_angle_roll=frame_angle_roll,
            frame_angle_roll_raw=frame_angle_roll_raw,
            frame_angle_pitch=frame_angle_pitch,
            frame_angle_pitch_raw=frame_angle_pitch_raw,
            tail=tail,
        )


class HelperDataExt(Request["Optional[Confirm]"]):
    """Report acceleration, tilt and rotation of the frame to the board.

    CMD_HELPER_DATA (72), to the board, extended form; 20 bytes. Effect: moves. Since firmware
    2.59. Source: Outgoing commands L736-L751; Variables L1247-L1251.
    """

    __slots__ = ()

    STOP_HEADING_CORRECTION: ClassVar[int] = 32767
    """For frame_heading, as raw value: stops the correction of the heading."""
    frame_acc: Field[Xyz[float], Xyz[float]] = Field(AxesOf(REAL, Xyz))
    """Linear acceleration of the frame; keeps the horizon level during acceleration. Unit: g.
    Positive pitch is down, negative up; positive yaw is right, negative left; for roll it is
    not known.
    """
    frame_acc_raw: Field[Xyz[int], Xyz[int]] = Field(AxesOf(RAW, Xyz), of="frame_acc")
    """The number on the wire for frame_acc."""
    frame_angle_roll: Field[float, float] = Field(REAL)
    """Sideways tilt of the frame. Unit: deg. Raw value 0: with FRAME_ANGLE_PITCH 0 too, not used.
    """
    frame_angle_roll_raw: Field[int, int] = Field(RAW, of="frame_angle_roll")
    """The number on the wire for frame_angle_roll."""
    frame_angle_pitch: Field[float, float] = Field(REAL)
    """Forward tilt of the frame. Unit: deg. Raw value 0: with FRAME_ANGLE_ROLL 0 too, not used."""
    frame_angle_pitch_raw: Field[int, int] = Field(RAW, of="frame_angle_pitch")
    """The number on the wire for frame_angle_pitch."""
    coord_sys: Field[HelperCoordinates, int] = Field(ValueOf(HelperCoordinates))
    """Coordinate system of all the vectors, and options."""
    frame_speed: Field[Xyz[float], Xyz[float]] = Field(AxesOf(REAL, Xyz))
    """Angular speed of the frame; useful without encoders and a second IMU. Unit: deg/s. Positive
    pitch is down, negative up; positive yaw is right, negative left; for roll it is not
    known. Raw value 0: with all three 0, not used.
    """
    frame_speed_raw: Field[Xyz[int], Xyz[int]] = Field(AxesOf(RAW, Xyz), of="frame_speed")
    """The number on the wire for frame_speed."""
    frame_heading: Field[float, float] = Field(REAL)
    """Heading of the frame; used with USE_FRAME_HEADING. Range: -360 to 360 deg. Positive pitch is
    down, negative up; positive yaw is right, negative left; for roll it is not known. Raw
    value 32767: stops the correction of the heading. Since firmware 2.62b7.
    """
    frame_heading_raw: Field[int, int] = Field(RAW, of="frame_heading")
    """The number on the wire for frame_heading."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        frame_acc: Xyz[float] = UNSET,
        frame_acc_raw: Xyz[int] = UNSET,
        frame_angle_roll: float = UNSET,
        frame_angle_roll_raw: int = UNSET,
        frame_angle_pitch: float = UNSET,
        frame_angle_pitch_raw: int = UNSET,
        coord_sys: int = UNSET,
        frame_speed: Xyz[float] = UNSET,
        frame_speed_raw: Xyz[int] = UNSET,
        frame_heading: float = UNSET,
        frame_heading_raw: int = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            frame_acc=frame_acc,
            frame_acc_raw=frame_acc_raw,
            frame_angle_roll=frame_angle_roll,
            frame_angle_roll_raw=frame_angle_roll_raw,
            frame_angle_pitch=frame_angle_pitch,
            frame_angle_pitch_raw=frame_angle_pitch_raw,
            coord_sys=coord_sys,
            frame_speed=frame_speed,
            frame_speed_raw=frame_speed_raw,
            frame_heading=frame_heading,
            frame_heading_raw=frame_heading_raw,
            reserved=reserved,
            tail=tail,
        )
