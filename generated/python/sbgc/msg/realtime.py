# Generated from spec/ by generator/: edit those, then run ./dev generate.
"""Live data from the sensors and the controller."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, ClassVar, Optional, Union

from sbgc.fields import BYTES, RAW, REAL, TEXT, Axes, AxesOf, Elements, Field, GroupOf, ListOf
from sbgc.fields import Structure, ValueOf, Xyz
from sbgc.message import Message, Request
from sbgc.msg.enums import *
from sbgc.msg.imu import *
from sbgc.msg.packed import *
from sbgc.values import UNSET

if TYPE_CHECKING:
    from sbgc.msg import Confirm

__all__ = [
    "AxisSensors",
    "CanDrvState",
    "CanDrvStateRequest",
    "CanDrvTelemetry",
    "CommErrors",
    "DataStreamInterval",
    "MainImuState",
    "Motor4Control",
    "MotorPowerState",
    "PinStates",
    "RealtimeData",
    "RealtimeData3",
    "RealtimeData3Request",
    "RealtimeData4",
    "RealtimeData4Request",
    "RealtimeDataCanDrv",
    "RealtimeDataCanDrvRequest",
    "RealtimeDataCustom",
    "RealtimeDataCustom2",
    "RealtimeDataCustom2Request",
    "RealtimeDataCustomRequest",
    "SoftLimitDistances",
    "StreamConfig",
    "SystemPowerState",
    "SystemStatus",
]

Bytes = Union[bytes, bytearray, memoryview]


class AxisSensors(Structure):
    """Sensors of each axis."""

    __slots__ = ()
    _home = ("RealtimeData3", "axes.roll")

    acc_data: Field[float, float] = Field(REAL)
    """Accelerometer. Unit: g."""
    acc_data_raw: Field[int, int] = Field(RAW, of="acc_data")
    """The number on the wire for acc_data."""
    gyro_data: Field[float, float] = Field(REAL)
    """Gyroscope. Unit: deg/s."""
    gyro_data_raw: Field[int, int] = Field(RAW, of="gyro_data")
    """The number on the wire for gyro_data."""

    def __init__(
        self,
        *,
        acc_data: float = UNSET,
        acc_data_raw: int = UNSET,
        gyro_data: float = UNSET,
        gyro_data_raw: int = UNSET,
    ) -> None:
        self._start(
            acc_data=acc_data,
            acc_data_raw=acc_data_raw,
            gyro_data=gyro_data,
            gyro_data_raw=gyro_data_raw,
        )


class Motor4Control(Structure):
    """Control of a fourth motor."""

    __slots__ = ()
    _home = ("RealtimeDataCustom", "motor4_control")

    ff_speed: Field[float, float] = Field(REAL)
    """Feed-forward speed. Unit: deg/s. Positive pitch is down, negative up; positive yaw is right,
    negative left; for roll it is not known.
    """
    ff_speed_raw: Field[int, int] = Field(RAW, of="ff_speed")
    """The number on the wire for ff_speed."""
    angle_error: Field[float, float] = Field(REAL)
    """Error of the angle. Unit: deg. Positive pitch is down, negative up; positive yaw is right,
    negative left; for roll it is not known.
    """
    angle_error_raw: Field[int, int] = Field(RAW, of="angle_error")
    """The number on the wire for angle_error."""
    pid_out: Field[float, float] = Field(REAL)
    """Output of the PID controller."""

    def __init__(
        self,
        *,
        ff_speed: float = UNSET,
        ff_speed_raw: int = UNSET,
        angle_error: float = UNSET,
        angle_error_raw: int = UNSET,
        pid_out: float = UNSET,
    ) -> None:
        self._start(
            ff_speed=ff_speed,
            ff_speed_raw=ff_speed_raw,
            angle_error=angle_error,
            angle_error_raw=angle_error_raw,
            pid_out=pid_out,
        )


class MotorPowerState(Structure):
    """State of each motor."""

    __slots__ = ()
    _home = ("RealtimeDataCustom", "system_power_state.motors.roll")

    mot_power: Field[int, int] = Field(RAW)
    """Output of the motor; 10000 is full power. Range: -10000 to 10000."""
    mot_current: Field[float, float] = Field(REAL)
    """Current of the motor. Unit: mA."""
    mot_current_raw: Field[int, int] = Field(RAW, of="mot_current")
    """The number on the wire for mot_current."""
    mot_temp: Field[float, float] = Field(REAL)
    """Temperature of the motor. Unit: degC."""
    mot_temp_raw: Field[int, int] = Field(RAW, of="mot_temp")
    """The number on the wire for mot_temp."""
    mot_flags: Field[MotorPowerFlags, MotorPowerFlags] = Field(ValueOf(MotorPowerFlags))
    """State of the motor."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        mot_power: int = UNSET,
        mot_current: float = UNSET,
        mot_current_raw: int = UNSET,
        mot_temp: float = UNSET,
        mot_temp_raw: int = UNSET,
        mot_flags: MotorPowerFlags = UNSET,
        reserved: Bytes = UNSET,
    ) -> None:
        self._start(
            mot_power=mot_power,
            mot_current=mot_current,
            mot_current_raw=mot_current_raw,
            mot_temp=mot_temp,
            mot_temp_raw=mot_temp_raw,
            mot_flags=mot_flags,
            reserved=reserved,
        )


class SystemPowerState(Structure):
    """State of the motors and of the supply."""

    __slots__ = ()
    _home = ("RealtimeDataCustom", "system_power_state")

    motors: Field[Axes[MotorPowerState], Axes[MotorPowerState]] = Field(
        AxesOf(GroupOf(MotorPowerState)),
    )
    """State of each motor."""
    state: Field[PowerState, PowerState] = Field(ValueOf(PowerState))
    """State of the motor power."""
    battery_voltage: Field[float, float] = Field(REAL)
    """Battery voltage. Unit: V."""
    battery_voltage_raw: Field[int, int] = Field(RAW, of="battery_voltage")
    """The number on the wire for battery_voltage."""
    total_current: Field[float, float] = Field(REAL)
    """Current of the whole system. Unit: mA."""
    total_current_raw: Field[int, int] = Field(RAW, of="total_current")
    """The number on the wire for total_current."""
    system_flags: Field[SystemPowerFlags, SystemPowerFlags] = Field(ValueOf(SystemPowerFlags))
    """Problems with the motors or their drivers."""

    def __init__(
        self,
        *,
        motors: Axes[MotorPowerState] = UNSET,
        state: PowerState = UNSET,
        battery_voltage: float = UNSET,
        battery_voltage_raw: int = UNSET,
        total_current: float = UNSET,
        total_current_raw: int = UNSET,
        system_flags: SystemPowerFlags = UNSET,
    ) -> None:
        self._start(
            motors=motors,
            state=state,
            battery_voltage=battery_voltage,
            battery_voltage_raw=battery_voltage_raw,
            total_current=total_current,
            total_current_raw=total_current_raw,
            system_flags=system_flags,
        )


class CommErrors(Structure):
    """Counters of communication errors."""

    __slots__ = ()
    _home = ("RealtimeDataCustom", "comm_errors")

    i2c_errors: Field[int, int] = Field(RAW)
    """Number of errors on the I2C bus."""
    serial_errors: Field[int, int] = Field(RAW)
    """Number of errors on the serial line."""
    can_errors: Field[int, int] = Field(RAW)
    """Number of errors on the CAN bus."""
    can_err_flags: Field[CanErrorFlags, CanErrorFlags] = Field(ValueOf(CanErrorFlags))
    """State of the CAN bus."""

    def __init__(
        self,
        *,
        i2c_errors: int = UNSET,
        serial_errors: int = UNSET,
        can_errors: int = UNSET,
        can_err_flags: CanErrorFlags = UNSET,
    ) -> None:
        self._start(
            i2c_errors=i2c_errors,
            serial_errors=serial_errors,
            can_errors=can_errors,
            can_err_flags=can_err_flags,
        )


class SystemStatus(Structure):
    """State of the system."""

    __slots__ = ()
    _home = ("RealtimeDataCustom", "system_state")

    flags: Field[StateFlags, StateFlags] = Field(ValueOf(StateFlags))
    """State of the system."""
    calib_mode: Field[CalibMode, CalibMode] = Field(ValueOf(CalibMode))
    """Calibration or other task that is running."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        flags: StateFlags = UNSET,
        calib_mode: CalibMode = UNSET,
        reserved: Bytes = UNSET,
    ) -> None:
        self._start(flags=flags, calib_mode=calib_mode, reserved=reserved)


class SoftLimitDistances(Structure):
    """Distances to the software limits, in Euler axes or, in servo mode, in those of the motors;
    imprecise for large angles.
    """

    __slots__ = ()
    _home = ("RealtimeDataCustom", "sw_limits_dist.roll")

    UNKNOWN_DISTANCE: ClassVar[int] = 32767
    """For dist, as raw value: not set or unknown."""
    dist: Field[Elements[float], Iterable[float]] = Field(ListOf(REAL))
    """Distances to the lower and the upper limit: positive inside, negative outside of it. Unit:
    deg. Raw value 32767: not set or unknown.
    """
    dist_raw: Field[Elements[int], Iterable[int]] = Field(ListOf(RAW), of="dist")
    """The number on the wire for dist."""

    def __init__(self, *, dist: Iterable[float] = UNSET, dist_raw: Iterable[int] = UNSET) -> None:
        self._start(dist=dist, dist_raw=dist_raw)


class MainImuState(Structure):
    """State of the main IMU."""

    __slots__ = ()
    _home = ("RealtimeDataCustom", "main_imu_state")

    g_ref_error: Field[float, float] = Field(REAL)
    """Angle between the estimated and the reference gravity vector. Unit: deg. Unconfirmed."""
    g_ref_error_raw: Field[int, int] = Field(RAW, of="g_ref_error")
    """The number on the wire for g_ref_error."""
    h_ref_error: Field[float, float] = Field(REAL)
    """Angle between the estimated and the reference heading vector. Unit: deg. Unconfirmed."""
    h_ref_error_raw: Field[int, int] = Field(RAW, of="h_ref_error")
    """The number on the wire for h_ref_error."""
    flags: Field[int, int] = Field(RAW)
    """Flags that no source explains."""
    ext_sensor_error: Field[int, int] = Field(RAW)
    """Errors of an external sensor."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        g_ref_error: float = UNSET,
        g_ref_error_raw: int = UNSET,
        h_ref_error: float = UNSET,
        h_ref_error_raw: int = UNSET,
        flags: int = UNSET,
        ext_sensor_error: int = UNSET,
        reserved: Bytes = UNSET,
    ) -> None:
        self._start(
            g_ref_error=g_ref_error,
            g_ref_error_raw=g_ref_error_raw,
            h_ref_error=h_ref_error,
            h_ref_error_raw=h_ref_error_raw,
            flags=flags,
            ext_sensor_error=ext_sensor_error,
            reserved=reserved,
        )


class PinStates(Structure):
    """State of the inputs."""

    __slots__ = ()
    _home = ("RealtimeDataCustom2", "pin_state")

    extra_buttons_state: Field[InputStates, int] = Field(ValueOf(InputStates))
    """State of additional buttons."""
    pin_state: Field[InputStates, int] = Field(ValueOf(InputStates))
    """State of the pins."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        extra_buttons_state: int = UNSET,
        pin_state: int = UNSET,
        reserved: Bytes = UNSET,
    ) -> None:
        self._start(extra_buttons_state=extra_buttons_state, pin_state=pin_state, reserved=reserved)


class StreamConfig(Structure):
    """Options of the message; unused bytes are 0."""

    __slots__ = ()
    _home = ("DataStreamInterval", "config")

    flags: Field[Optional[RealtimeDataCustomFlags], Optional[RealtimeDataCustomFlags]] = Field(
        ValueOf(RealtimeDataCustomFlags),
        optional=True,
    )
    """Blocks to send. Present if cmd_id is CMD_REALTIME_DATA_CUSTOM."""
    imu_type: Field[Optional[ImuIndex], Optional[ImuIndex]] = Field(
        ValueOf(ImuIndex),
        optional=True,
    )
    """IMU whose attitude to send. Present if cmd_id is CMD_AHRS_HELPER. Unconfirmed."""
    event_id: Field[Optional[EventId], Optional[EventId]] = Field(ValueOf(EventId), optional=True)
    """Event to report. Present if cmd_id is CMD_EVENT."""
    event_type: Field[Optional[EventTypes], Optional[EventTypes]] = Field(
        ValueOf(EventTypes),
        optional=True,
    )
    """Kinds of the event to report. Present if cmd_id is CMD_EVENT."""
    telemetry_flags: Field[Optional[CanDrvTelemetryFlags], Optional[CanDrvTelemetryFlags]] = Field(
        ValueOf(CanDrvTelemetryFlags),
        optional=True,
    )
    """Data to send. Present if cmd_id is CMD_CAN_DRV_TELEMETRY."""
    drv_id: Field[Optional[int], Optional[int]] = Field(RAW, optional=True)
    """CAN motor driver whose data to send. Range: 0 to 6. Present if cmd_id is
    CMD_CAN_DRV_TELEMETRY.
    """
    motor: Field[Optional[int], Optional[int]] = Field(RAW, optional=True)
    """External motor whose state to send. Present if cmd_id is CMD_EXT_MOTORS_STATE."""
    data_set: Field[Optional[ExtMotorsStateFields], Optional[ExtMotorsStateFields]] = Field(
        ValueOf(ExtMotorsStateFields),
        optional=True,
    )
    """Data to send. Present if cmd_id is CMD_EXT_MOTORS_STATE."""
    custom2_flags: Field[Optional[RealtimeDataCustom2Flags], Optional[RealtimeDataCustom2Flags]] = Field(
        ValueOf(RealtimeDataCustom2Flags),
        optional=True,
    )
    """Blocks to send. Present if cmd_id is CMD_REALTIME_DATA_CUSTOM2."""
    rest: Field[bytes, Bytes] = Field(BYTES)
    """What is not used of the 8 bytes; filled up with zeros."""

    def __init__(
        self,
        *,
        flags: Optional[RealtimeDataCustomFlags] = UNSET,
        imu_type: Optional[ImuIndex] = UNSET,
        event_id: Optional[EventId] = UNSET,
        event_type: Optional[EventTypes] = UNSET,
        telemetry_flags: Optional[CanDrvTelemetryFlags] = UNSET,
        drv_id: Optional[int] = UNSET,
        motor: Optional[int] = UNSET,
        data_set: Optional[ExtMotorsStateFields] = UNSET,
        custom2_flags: Optional[RealtimeDataCustom2Flags] = UNSET,
        rest: Bytes = UNSET,
    ) -> None:
        self._start(
            flags=flags,
            imu_type=imu_type,
            event_id=event_id,
            event_type=event_type,
            telemetry_flags=telemetry_flags,
            drv_id=drv_id,
            motor=motor,
            data_set=data_set,
            custom2_flags=custom2_flags,
            rest=rest,
        )


class RealtimeData(Request["RealtimeData3"]):
    """Request live data, with the older id.

    CMD_REALTIME_DATA (68), to the board; 0 bytes. Effect: reads. Source: Outgoing commands
    L615-L617.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class RealtimeData3(Message):
    """Live data.

    CMD_REALTIME_DATA_3 (23), from the board; 63 bytes, and later firmware may append more.
    Since board 3.0. Source: Incoming commands L361-L396; Variables L1117-L1135.
    """

    __slots__ = ()

    NO_SIGNAL: ClassVar[int] = -10000
    """For rc and rc_cmd and ext_fc_roll and ext_fc_pitch, as raw value: no signal."""
    EXT_FC_UNUSED: ClassVar[int] = 0
    """For ext_fc_roll and ext_fc_pitch, as raw value: the input serves RC control or commands."""
    axes: Field[Axes[AxisSensors], Axes[AxisSensors]] = Field(AxesOf(GroupOf(AxisSensors)))
    """Sensors of each axis."""
    serial_error_cnt: Field[int, int] = Field(RAW)
    """Number of errors on the serial line."""
    system_error: Field[SystemErrors, SystemErrors] = Field(ValueOf(SystemErrors))
    """Current errors; 0 if there are none."""
    system_sub_error: Field[SystemSubError, SystemSubError] = Field(ValueOf(SystemSubError))
    """Reason for an emergency stop."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""
    rc: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """RC channels of the axes. Range: 1000 to 2000 us. Raw value -10000: no signal."""
    rc_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="rc")
    """The number on the wire for rc."""
    rc_cmd: Field[float, float] = Field(REAL)
    """RC command channel. Range: 1000 to 2000 us. Raw value -10000: no signal."""
    rc_cmd_raw: Field[int, int] = Field(RAW, of="rc_cmd")
    """The number on the wire for rc_cmd."""
    ext_fc_roll: Field[float, float] = Field(REAL)
    """Roll signal of an external flight controller. Range: 1000 to 2000 us. Raw value 0: the input
    serves RC control or commands. Raw value -10000: no signal.
    """
    ext_fc_roll_raw: Field[int, int] = Field(RAW, of="ext_fc_roll")
    """The number on the wire for ext_fc_roll."""
    ext_fc_pitch: Field[float, float] = Field(REAL)
    """Pitch signal of an external flight controller. Range: 1000 to 2000 us. Raw value 0: the input
    serves RC control or commands. Raw value -10000: no signal.
    """
    ext_fc_pitch_raw: Field[int, int] = Field(RAW, of="ext_fc_pitch")
    """The number on the wire for ext_fc_pitch."""
    angle: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Camera angles. Unit: deg. Positive pitch is down, negative up; positive yaw is right,
    negative left; for roll it is not known.
    """
    angle_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="angle")
    """The number on the wire for angle."""
    frame_imu_angle: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Frame angles, from the second IMU if present. Unit: deg. Positive pitch is down, negative up;
    positive yaw is right, negative left; for roll it is not known.
    """
    frame_imu_angle_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="frame_imu_angle")
    """The number on the wire for frame_imu_angle."""
    rc_angle: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Target angles from RC. Unit: deg. Positive pitch is down, negative up; positive yaw is right,
    negative left; for roll it is not known.
    """
    rc_angle_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="rc_angle")
    """The number on the wire for rc_angle."""
    cycle_time: Field[float, float] = Field(REAL)
    """Duration of one control cycle. Unit: us."""
    cycle_time_raw: Field[int, int] = Field(RAW, of="cycle_time")
    """The number on the wire for cycle_time."""
    i2c_error_count: Field[int, int] = Field(RAW)
    """Number of errors on the I2C bus."""
    error_code: Field[int, int] = Field(RAW)
    """Predecessor of SYSTEM_ERROR. Deprecated: use SYSTEM_ERROR."""
    bat_level: Field[float, float] = Field(REAL)
    """Battery voltage. Unit: V."""
    bat_level_raw: Field[int, int] = Field(RAW, of="bat_level")
    """The number on the wire for bat_level."""
    other_flags: Field[OtherFlags, OtherFlags] = Field(ValueOf(OtherFlags))
    """State of the motors."""
    cur_imu: Field[SelectedImu, SelectedImu] = Field(ValueOf(SelectedImu))
    """Selected IMU. Since board 3.0."""
    cur_profile: Field[int, int] = Field(RAW)
    """Active profile. Range: 0 to 4."""
    motor_power: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Power of each motor."""

    def __init__(
        self,
        *,
        axes: Axes[AxisSensors] = UNSET,
        serial_error_cnt: int = UNSET,
        system_error: SystemErrors = UNSET,
        system_sub_error: SystemSubError = UNSET,
        reserved: Bytes = UNSET,
        rc: Axes[float] = UNSET,
        rc_raw: Axes[int] = UNSET,
        rc_cmd: float = UNSET,
        rc_cmd_raw: int = UNSET,
        ext_fc_roll: float = UNSET,
        ext_fc_roll_raw: int = UNSET,
        ext_fc_pitch: float = UNSET,
        ext_fc_pitch_raw: int = UNSET,
        angle: Axes[float] = UNSET,
        angle_raw: Axes[int] = UNSET,
        frame_imu_angle: Axes[float] = UNSET,
        frame_imu_angle_raw: Axes[int] = UNSET,
        rc_angle: Axes[float] = UNSET,
        rc_angle_raw: Axes[int] = UNSET,
        cycle_time: float = UNSET,
        cycle_time_raw: int = UNSET,
        i2c_error_count: int = UNSET,
        error_code: int = UNSET,
        bat_level: float = UNSET,
        bat_level_raw: int = UNSET,
        other_flags: OtherFlags = UNSET,
        cur_imu: SelectedImu = UNSET,
        cur_profile: int = UNSET,
        motor_power: Axes[int] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            axes=axes,
            serial_error_cnt=serial_error_cnt,
            system_error=system_error,
            system_sub_error=system_sub_error,
            reserved=reserved,
            rc=rc,
            rc_raw=rc_raw,
            rc_cmd=rc_cmd,
            rc_cmd_raw=rc_cmd_raw,
            ext_fc_roll=ext_fc_roll,
            ext_fc_roll_raw=ext_fc_roll_raw,
            ext_fc_pitch=ext_fc_pitch,
            ext_fc_pitch_raw=ext_fc_pitch_raw,
            angle=angle,
            angle_raw=angle_raw,
            frame_imu_angle=frame_imu_angle,
            frame_imu_angle_raw=frame_imu_angle_raw,
            rc_angle=rc_angle,
            rc_angle_raw=rc_angle_raw,
            cycle_time=cycle_time,
            cycle_time_raw=cycle_time_raw,
            i2c_error_count=i2c_error_count,
            error_code=error_code,
            bat_level=bat_level,
            bat_level_raw=bat_level_raw,
            other_flags=other_flags,
            cur_imu=cur_imu,
            cur_profile=cur_profile,
            motor_power=motor_power,
            tail=tail,
        )


class RealtimeData3Request(Request["RealtimeData3"]):
    """Request live data.

    CMD_REALTIME_DATA_3 (23), to the board; 0 bytes. Effect: reads. Since board 3.0. Source:
    Outgoing commands L615-L617.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class RealtimeData4(Message):
    """Live data with joint angles, currents and temperatures.

    CMD_REALTIME_DATA_4 (25), from the board; 124 bytes, and later firmware may append more.
    Since board 3.0. Source: Incoming commands L398-L410; Variables L1136-L1146.
    """

    __slots__ = ()

    NO_SIGNAL: ClassVar[int] = -10000
    """For rc and rc_cmd and ext_fc_roll and ext_fc_pitch, as raw value: no signal."""
    EXT_FC_UNUSED: ClassVar[int] = 0
    """For ext_fc_roll and ext_fc_pitch, as raw value: the input serves RC control or commands."""
    axes: Field[Axes[AxisSensors], Axes[AxisSensors]] = Field(AxesOf(GroupOf(AxisSensors)))
    """Sensors of each axis."""
    serial_error_cnt: Field[int, int] = Field(RAW)
    """Number of errors on the serial line."""
    system_error: Field[SystemErrors, SystemErrors] = Field(ValueOf(SystemErrors))
    """Current errors; 0 if there are none."""
    system_sub_error: Field[SystemSubError, SystemSubError] = Field(ValueOf(SystemSubError))
    """Reason for an emergency stop."""
    reserved_1: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""
    rc: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """RC channels of the axes. Range: 1000 to 2000 us. Raw value -10000: no signal."""
    rc_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="rc")
    """The number on the wire for rc."""
    rc_cmd: Field[float, float] = Field(REAL)
    """RC command channel. Range: 1000 to 2000 us. Raw value -10000: no signal."""
    rc_cmd_raw: Field[int, int] = Field(RAW, of="rc_cmd")
    """The number on the wire for rc_cmd."""
    ext_fc_roll: Field[float, float] = Field(REAL)
    """Roll signal of an external flight controller. Range: 1000 to 2000 us. Raw value 0: the input
    serves RC control or commands. Raw value -10000: no signal.
    """
    ext_fc_roll_raw: Field[int, int] = Field(RAW, of="ext_fc_roll")
    """The number on the wire for ext_fc_roll."""
    ext_fc_pitch: Field[float, float] = Field(REAL)
    """Pitch signal of an external flight controller. Range: 1000 to 2000 us. Raw value 0: the input
    serves RC control or commands. Raw value -10000: no signal.
    """
    ext_fc_pitch_raw: Field[int, int] = Field(RAW, of="ext_fc_pitch")
    """The number on the wire for ext_fc_pitch."""
    angle: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Camera angles. Unit: deg. Positive pitch is down, negative up; positive yaw is right,
    negative left; for roll it is not known.
    """
    angle_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="angle")
    """The number on the wire for angle."""
    frame_imu_angle: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Frame angles, from the second IMU if present. Unit: deg. Positive pitch is down, negative up;
    positive yaw is right, negative left; for roll it is not known.
    """
    frame_imu_angle_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="frame_imu_angle")
    """The number on the wire for frame_imu_angle."""
    rc_angle: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Target angles from RC. Unit: deg. Positive pitch is down, negative up; positive yaw is right,
    negative left; for roll it is not known.
    """
    rc_angle_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="rc_angle")
    """The number on the wire for rc_angle."""
    cycle_time: Field[float, float] = Field(REAL)
    """Duration of one control cycle. Unit: us."""
    cycle_time_raw: Field[int, int] = Field(RAW, of="cycle_time")
    """The number on the wire for cycle_time."""
    i2c_error_count: Field[int, int] = Field(RAW)
    """Number of errors on the I2C bus."""
    error_code: Field[int, int] = Field(RAW)
    """Predecessor of SYSTEM_ERROR. Deprecated: use SYSTEM_ERROR."""
    bat_level: Field[float, float] = Field(REAL)
    """Battery voltage. Unit: V."""
    bat_level_raw: Field[int, int] = Field(RAW, of="bat_level")
    """The number on the wire for bat_level."""
    other_flags: Field[OtherFlags, OtherFlags] = Field(ValueOf(OtherFlags))
    """State of the motors."""
    cur_imu: Field[SelectedImu, SelectedImu] = Field(ValueOf(SelectedImu))
    """Selected IMU. Since board 3.0."""
    cur_profile: Field[int, int] = Field(RAW)
    """Active profile. Range: 0 to 4."""
    motor_power: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Power of each motor."""
    rotor_angle: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Angle of each joint, from an encoder, the second IMU or an estimate; 0 in the normal
    position. Unit: deg. Positive pitch is down, negative up; positive yaw is right, negative
    left; for roll it is not known.
    """
    rotor_angle_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="rotor_angle")
    """The number on the wire for rotor_angle."""
    reserved_2: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""
    balance_error: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Motor power lost to imbalance. Range: -100 to 100 %."""
    balance_error_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="balance_error")
    """The number on the wire for balance_error."""
    current: Field[float, float] = Field(REAL)
    """Current drawn by the board. Unit: mA."""
    current_raw: Field[int, int] = Field(RAW, of="current")
    """The number on the wire for current."""
    mag_data: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Raw magnetometer data."""
    imu_temperature: Field[float, float] = Field(REAL)
    """Temperature of the main IMU. Range: -127 to 127 degC."""
    imu_temperature_raw: Field[int, int] = Field(RAW, of="imu_temperature")
    """The number on the wire for imu_temperature."""
    frame_imu_temperature: Field[float, float] = Field(REAL)
    """Temperature of the frame IMU. Range: -127 to 127 degC."""
    frame_imu_temperature_raw: Field[int, int] = Field(RAW, of="frame_imu_temperature")
    """The number on the wire for frame_imu_temperature."""
    imu_g_err: Field[float, float] = Field(REAL)
    """Angle between the estimated and the reference gravity vector. Unit: deg."""
    imu_g_err_raw: Field[int, int] = Field(RAW, of="imu_g_err")
    """The number on the wire for imu_g_err."""
    imu_h_err: Field[float, float] = Field(REAL)
    """Angle between the estimated and the reference heading vector. Unit: deg."""
    imu_h_err_raw: Field[int, int] = Field(RAW, of="imu_h_err")
    """The number on the wire for imu_h_err."""
    motor_out: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Output of each motor; 10000 is full power. Range: -10000 to 10000. Since firmware 2.61."""
    calib_mode: Field[CalibMode, CalibMode] = Field(ValueOf(CalibMode))
    """Calibration or other task that is running. Since firmware 2.61."""
    can_imu_ext_sens_err: Field[int, int] = Field(RAW)
    """Errors of the external sensor of a CAN IMU. Since firmware 2.61."""
    actual_angle: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Actual angles of the camera. Unit: deg. Positive pitch is down, negative up; positive yaw is
    right, negative left; for roll it is not known. Since firmware 2.72.
    """
    actual_angle_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="actual_angle")
    """The number on the wire for actual_angle."""
    system_state_flags: Field[StateFlags, StateFlags] = Field(ValueOf(StateFlags))
    """State of the system. Since firmware 2.73."""
    reserved_3: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        axes: Axes[AxisSensors] = UNSET,
        serial_error_cnt: int = UNSET,
        system_error: SystemErrors = UNSET,
        system_sub_error: SystemSubError = UNSET,
        reserved_1: Bytes = UNSET,
        rc: Axes[float] = UNSET,
        rc_raw: Axes[int] = UNSET,
        rc_cmd: float = UNSET,
        rc_cmd_raw: int = UNSET,
        ext_fc_roll: float = UNSET,
        ext_fc_roll_raw: int = UNSET,
        ext_fc_pitch: float = UNSET,
        ext_fc_pitch_raw: int = UNSET,
        angle: Axes[float] = UNSET,
        angle_raw: Axes[int] = UNSET,
        frame_imu_angle: Axes[float] = UNSET,
        frame_imu_angle_raw: Axes[int] = UNSET,
        rc_angle: Axes[float] = UNSET,
        rc_angle_raw: Axes[int] = UNSET,
        cycle_time: float = UNSET,
        cycle_time_raw: int = UNSET,
        i2c_error_count: int = UNSET,
        error_code: int = UNSET,
        bat_level: float = UNSET,
        bat_level_raw: int = UNSET,
        other_flags: OtherFlags = UNSET,
        cur_imu: SelectedImu = UNSET,
        cur_profile: int = UNSET,
        motor_power: Axes[int] = UNSET,
        rotor_angle: Axes[float] = UNSET,
        rotor_angle_raw: Axes[int] = UNSET,
        reserved_2: Bytes = UNSET,
        balance_error: Axes[float] = UNSET,
        balance_error_raw: Axes[int] = UNSET,
        current: float = UNSET,
        current_raw: int = UNSET,
        mag_data: Axes[int] = UNSET,
        imu_temperature: float = UNSET,
        imu_temperature_raw: int = UNSET,
        frame_imu_temperature: float = UNSET,
        frame_imu_temperature_raw: int = UNSET,
        imu_g_err: float = UNSET,
        imu_g_err_raw: int = UNSET,
        imu_h_err: float = UNSET,
        imu_h_err_raw: int = UNSET,
        motor_out: Axes[int] = UNSET,
        calib_mode: CalibMode = UNSET,
        can_imu_ext_sens_err: int = UNSET,
        actual_angle: Axes[float] = UNSET,
        actual_angle_raw: Axes[int] = UNSET,
        system_state_flags: StateFlags = UNSET,
        reserved_3: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            axes=axes,
            serial_error_cnt=serial_error_cnt,
            system_error=system_error,
            system_sub_error=system_sub_error,
            reserved_1=reserved_1,
            rc=rc,
            rc_raw=rc_raw,
            rc_cmd=rc_cmd,
            rc_cmd_raw=rc_cmd_raw,
            ext_fc_roll=ext_fc_roll,
            ext_fc_roll_raw=ext_fc_roll_raw,
            ext_fc_pitch=ext_fc_pitch,
            ext_fc_pitch_raw=ext_fc_pitch_raw,
            angle=angle,
            angle_raw=angle_raw,
            frame_imu_angle=frame_imu_angle,
            frame_imu_angle_raw=frame_imu_angle_raw,
            rc_angle=rc_angle,
            rc_angle_raw=rc_angle_raw,
            cycle_time=cycle_time,
            cycle_time_raw=cycle_time_raw,
            i2c_error_count=i2c_error_count,
            error_code=error_code,
            bat_level=bat_level,
            bat_level_raw=bat_level_raw,
            other_flags=other_flags,
            cur_imu=cur_imu,
            cur_profile=cur_profile,
            motor_power=motor_power,
            rotor_angle=rotor_angle,
            rotor_angle_raw=rotor_angle_raw,
            reserved_2=reserved_2,
            balance_error=balance_error,
            balance_error_raw=balance_error_raw,
            current=current,
            current_raw=current_raw,
            mag_data=mag_data,
            imu_temperature=imu_temperature,
            imu_temperature_raw=imu_temperature_raw,
            frame_imu_temperature=frame_imu_temperature,
            frame_imu_temperature_raw=frame_imu_temperature_raw,
            imu_g_err=imu_g_err,
            imu_g_err_raw=imu_g_err_raw,
            imu_h_err=imu_h_err,
            imu_h_err_raw=imu_h_err_raw,
            motor_out=motor_out,
            calib_mode=calib_mode,
            can_imu_ext_sens_err=can_imu_ext_sens_err,
            actual_angle=actual_angle,
            actual_angle_raw=actual_angle_raw,
            system_state_flags=system_state_flags,
            reserved_3=reserved_3,
            tail=tail,
        )


class RealtimeData4Request(Request["RealtimeData4"]):
    """Request the longer live data.

    CMD_REALTIME_DATA_4 (25), to the board; 0 bytes. Effect: reads. Since board 3.0. Source:
    Outgoing commands L619.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class RealtimeDataCustom(Message):
    """Live data of the requested blocks.

    CMD_REALTIME_DATA_CUSTOM (88), from the board; 2 to 255 bytes, and later firmware may append
    more. Since firmware 2.59, board 3.0. Source: Incoming commands L587-L590; Variables
    L1210-L1220.
    """

    __slots__ = ()

    UNDEFINED: ClassVar[int] = -32768
    """For rc_data and rc_channels, as raw value: undefined."""
    timestamp_ms: Field[float, float] = Field(REAL)
    """Time of the sample. Unit: ms."""
    timestamp_ms_raw: Field[int, int] = Field(RAW, of="timestamp_ms")
    """The number on the wire for timestamp_ms."""
    flags: Field[Optional[RealtimeDataCustomFlags], Optional[RealtimeDataCustomFlags]] = Field(
        ValueOf(RealtimeDataCustomFlags),
        optional=True,
    )
    """FLAGS of the request. Present if flags has INCLUDE_FLAGS."""
    imu_angles: Field[Optional[Axes[float]], Optional[Axes[float]]] = Field(
        AxesOf(REAL),
        optional=True,
    )
    """Angles of the main IMU (Euler). Unit: deg. Positive pitch is down, negative up; positive yaw
    is right, negative left; for roll it is not known. Present if flags has IMU_ANGLES.
    """
    imu_angles_raw: Field[Optional[Axes[int]], Optional[Axes[int]]] = Field(
        AxesOf(RAW),
        optional=True,
        of="imu_angles",
    )
    """The number on the wire for imu_angles."""
    target_angles: Field[Optional[Axes[float]], Optional[Axes[float]]] = Field(
        AxesOf(REAL),
        optional=True,
    )
    """Target angles (Euler). Unit: deg. Positive pitch is down, negative up; positive yaw is right,
    negative left; for roll it is not known. Present if flags has TARGET_ANGLES.
    """
    target_angles_raw: Field[Optional[Axes[int]], Optional[Axes[int]]] = Field(
        AxesOf(RAW),
        optional=True,
        of="target_angles",
    )
    """The number on the wire for target_angles."""
    target_speed: Field[Optional[Axes[float]], Optional[Axes[float]]] = Field(
        AxesOf(REAL),
        optional=True,
    )
    """Target speeds over the Euler axes. Unit: deg/s. Positive pitch is down, negative up; positive
    yaw is right, negative left; for roll it is not known. Present if flags has TARGET_SPEED.
    """
    target_speed_raw: Field[Optional[Axes[int]], Optional[Axes[int]]] = Field(
        AxesOf(RAW),
        optional=True,
        of="target_speed",
    )
    """The number on the wire for target_speed."""
    stator_rotor_angle: Field[Optional[Axes[float]], Optional[Axes[float]]] = Field(
        AxesOf(REAL),
        optional=True,
    )
    """Joint angles. Unit: deg. Positive pitch is down, negative up; positive yaw is right, negative
    left; for roll it is not known. Present if flags has STATOR_ROTOR_ANGLE.
    """
    stator_rotor_angle_raw: Field[Optional[Axes[int]], Optional[Axes[int]]] = Field(
        AxesOf(RAW),
        optional=True,
        of="stator_rotor_angle",
    )
    """The number on the wire for stator_rotor_angle."""
    gyro_data: Field[Optional[Axes[float]], Optional[Axes[float]]] = Field(
        AxesOf(REAL),
        optional=True,
    )
    """Gyroscope after calibration. Unit: deg/s. Present if flags has GYRO_DATA."""
    gyro_data_raw: Field[Optional[Axes[int]], Optional[Axes[int]]] = Field(
        AxesOf(RAW),
        optional=True,
        of="gyro_data",
    )
    """The number on the wire for gyro_data."""
    rc_data: Field[Optional[Elements[float]], Optional[Iterable[float]]] = Field(
        ListOf(REAL),
        optional=True,
    )
    """RC signals of the inputs ROLL, PITCH, YAW, CMD, FC_ROLL, FC_PITCH. Range: -1 to 1. Raw value
    -32768: undefined. Present if flags has RC_DATA.
    """
    rc_data_raw: Field[Optional[Elements[int]], Optional[Iterable[int]]] = Field(
        ListOf(RAW),
        optional=True,
        of="rc_data",
    )
    """The number on the wire for rc_data."""
    z1_vector: Field[Optional[Xyz[float]], Optional[Xyz[float]]] = Field(
        AxesOf(REAL, Xyz),
        optional=True,
    )
    """Gravity row of the rotation matrix. Range: -1 to 1. Present if flags has Z1_H1_VECTORS."""
    h1_vector: Field[Optional[Xyz[float]], Optional[Xyz[float]]] = Field(
        AxesOf(REAL, Xyz),
        optional=True,
    )
    """Heading row of the rotation matrix; the cross product of both rows is the third. Range: -1 to
    1. Present if flags has Z1_H1_VECTORS.
    """
    rc_channels: Field[Optional[Elements[float]], Optional[Iterable[float]]] = Field(
        ListOf(REAL),
        optional=True,
    )
    """All captured RC channels. Range: -1 to 1. Raw value -32768: undefined. Present if flags has
    RC_CHANNELS.
    """
    rc_channels_raw: Field[Optional[Elements[int]], Optional[Iterable[int]]] = Field(
        ListOf(RAW),
        optional=True,
        of="rc_channels",
    )
    """The number on the wire for rc_channels."""
    acc_data: Field[Optional[Axes[float]], Optional[Axes[float]]] = Field(
        AxesOf(REAL),
        optional=True,
    )
    """Accelerometer after calibration. Unit: g. Present if flags has ACC_DATA."""
    acc_data_raw: Field[Optional[Axes[int]], Optional[Axes[int]]] = Field(
        AxesOf(RAW),
        optional=True,
        of="acc_data",
    )
    """The number on the wire for acc_data."""
    motor4_control: Field[Optional[Motor4Control], Optional[Motor4Control]] = Field(
        GroupOf(Motor4Control),
        optional=True,
    )
    """Control of a fourth motor. Present if flags has MOTOR4_CONTROL."""
    ahrs_debug_info: Field[Optional[AhrsDebugInfo], Optional[AhrsDebugInfo]] = Field(
        GroupOf(AhrsDebugInfo),
        optional=True,
    )
    """State of the attitude estimation. Present if flags has AHRS_DEBUG_INFO."""
    encoder_raw24: Field[Optional[Axes[int]], Optional[Axes[int]]] = Field(
        AxesOf(RAW),
        optional=True,
    )
    """Raw values of the encoders. Present if flags has ENCODER_RAW24. Unconfirmed."""
    imu_angles_rad: Field[Optional[Axes[float]], Optional[Axes[float]]] = Field(
        AxesOf(REAL),
        optional=True,
    )
    """Angles of the main IMU (Euler), in radians. Unit: rad. Positive pitch is down, negative up;
    positive yaw is right, negative left; for roll it is not known. Present if flags has
    IMU_ANGLES_RAD.
    """
    imu_angles_rad_raw: Field[Optional[Axes[float]], Optional[Axes[float]]] = Field(
        AxesOf(RAW),
        optional=True,
        of="imu_angles_rad",
    )
    """The number on the wire for imu_angles_rad."""
    script_vars_float: Field[Optional[Elements[float]], Optional[Iterable[float]]] = Field(
        ListOf(REAL),
        optional=True,
    )
    """Floating-point variables of the script. Present if flags has SCRIPT_VARS_FLOAT."""
    script_vars_int16: Field[Optional[Elements[int]], Optional[Iterable[int]]] = Field(
        ListOf(RAW),
        optional=True,
    )
    """Integer variables of the script. Present if flags has SCRIPT_VARS_INT16."""
    system_power_state: Field[Optional[SystemPowerState], Optional[SystemPowerState]] = Field(
        GroupOf(SystemPowerState),
        optional=True,
    )
    """State of the motors and of the supply. Present if flags has SYSTEM_POWER_STATE."""
    frame_cam_rate: Field[Optional[Axes[float]], Optional[Axes[float]]] = Field(
        AxesOf(REAL),
        optional=True,
    )
    """Speed of the camera relative to the frame. Unit: deg/s. Present if flags has FRAME_CAM_RATE.
    """
    frame_cam_rate_raw: Field[Optional[Axes[int]], Optional[Axes[int]]] = Field(
        AxesOf(RAW),
        optional=True,
        of="frame_cam_rate",
    )
    """The number on the wire for frame_cam_rate."""
    imu_angles_20: Field[Optional[Axes[float]], Optional[Axes[float]]] = Field(
        AxesOf(REAL),
        optional=True,
    )
    """Angles of the main IMU (Euler), in high resolution. Unit: deg. Positive pitch is down,
    negative up; positive yaw is right, negative left; for roll it is not known. Present if
    flags has IMU_ANGLES_20.
    """
    imu_angles_20_raw: Field[Optional[Axes[int]], Optional[Axes[int]]] = Field(
        AxesOf(RAW),
        optional=True,
        of="imu_angles_20",
    )
    """The number on the wire for imu_angles_20."""
    target_angles_20: Field[Optional[Axes[float]], Optional[Axes[float]]] = Field(
        AxesOf(REAL),
        optional=True,
    )
    """Target angles (Euler), in high resolution. Unit: deg. Positive pitch is down, negative up;
    positive yaw is right, negative left; for roll it is not known. Present if flags has
    TARGET_ANGLES_20.
    """
    target_angles_20_raw: Field[Optional[Axes[int]], Optional[Axes[int]]] = Field(
        AxesOf(RAW),
        optional=True,
        of="target_angles_20",
    )
    """The number on the wire for target_angles_20."""
    comm_errors: Field[Optional[CommErrors], Optional[CommErrors]] = Field(
        GroupOf(CommErrors),
        optional=True,
    )
    """Counters of communication errors. Present if flags has COMM_ERRORS."""
    system_state: Field[Optional[SystemStatus], Optional[SystemStatus]] = Field(
        GroupOf(SystemStatus),
        optional=True,
    )
    """State of the system. Present if flags has SYSTEM_STATE."""
    imu_quat: Field[Optional[PackedQuaternion], Optional[int]] = Field(
        ValueOf(PackedQuaternion),
        optional=True,
    )
    """Attitude of the main IMU. Present if flags has IMU_QUAT."""
    target_quat: Field[Optional[PackedQuaternion], Optional[int]] = Field(
        ValueOf(PackedQuaternion),
        optional=True,
    )
    """Target attitude; only of Extended boards that CMD_CONTROL_QUAT controls. Present if flags has
    TARGET_QUAT.
    """
    imu_to_frame_quat: Field[Optional[PackedQuaternion], Optional[int]] = Field(
        ValueOf(PackedQuaternion),
        optional=True,
    )
    """Rotation from the main IMU to the frame. Present if flags has IMU_TO_FRAME_QUAT."""
    adc_ch_raw: Field[Optional[Elements[int]], Optional[Iterable[int]]] = Field(
        ListOf(RAW),
        optional=True,
    )
    """Raw values of the analog inputs, averaged over 8 ms. Range: 0 to 4096. Present if flags has
    ADC_CH_RAW.
    """
    sw_limits_dist: Field[Optional[Axes[SoftLimitDistances]], Optional[Axes[SoftLimitDistances]]] = Field(
        AxesOf(GroupOf(SoftLimitDistances)),
        optional=True,
    )
    """Distances to the software limits, in Euler axes or, in servo mode, in those of the motors;
    imprecise for large angles. Present if flags has SW_LIMITS_DIST.
    """
    follow_dist: Field[Optional[Axes[float]], Optional[Axes[float]]] = Field(
        AxesOf(REAL),
        optional=True,
    )
    """Distance to the neutral point of the follow mode, or 0 without it. Unit: deg. Present if
    flags has FOLLOW_DIST.
    """
    follow_dist_raw: Field[Optional[Axes[int]], Optional[Axes[int]]] = Field(
        AxesOf(RAW),
        optional=True,
        of="follow_dist",
    )
    """The number on the wire for follow_dist."""
    ext_target_limit_min: Field[Optional[Axes[float]], Optional[Axes[float]]] = Field(
        AxesOf(REAL),
        optional=True,
    )
    """Lower limits of an external target, such as an angle of CMD_CONTROL, in follow mode as well;
    if both are 0, there are none. Unit: deg. Positive pitch is down, negative up; positive
    yaw is right, negative left; for roll it is not known. Present if flags has
    EXT_TARGET_LIMIT. Unconfirmed.
    """
    ext_target_limit_min_raw: Field[Optional[Axes[int]], Optional[Axes[int]]] = Field(
        AxesOf(RAW),
        optional=True,
        of="ext_target_limit_min",
    )
    """The number on the wire for ext_target_limit_min."""
    ext_target_limit_max: Field[Optional[Axes[float]], Optional[Axes[float]]] = Field(
        AxesOf(REAL),
        optional=True,
    )
    """Upper limits of an external target. Unit: deg. Positive pitch is down, negative up; positive
    yaw is right, negative left; for roll it is not known. Present if flags has
    EXT_TARGET_LIMIT. Unconfirmed.
    """
    ext_target_limit_max_raw: Field[Optional[Axes[int]], Optional[Axes[int]]] = Field(
        AxesOf(RAW),
        optional=True,
        of="ext_target_limit_max",
    )
    """The number on the wire for ext_target_limit_max."""
    frame_cam_angle_20: Field[Optional[Axes[float]], Optional[Axes[float]]] = Field(
        AxesOf(REAL),
        optional=True,
    )
    """Joint angles, in high resolution. Unit: deg. Positive pitch is down, negative up; positive
    yaw is right, negative left; for roll it is not known. Present if flags has
    FRAME_CAM_ANGLE_20.
    """
    frame_cam_angle_20_raw: Field[Optional[Axes[int]], Optional[Axes[int]]] = Field(
        AxesOf(RAW),
        optional=True,
        of="frame_cam_angle_20",
    )
    """The number on the wire for frame_cam_angle_20."""
    main_imu_state: Field[Optional[MainImuState], Optional[MainImuState]] = Field(
        GroupOf(MainImuState),
        optional=True,
    )
    """State of the main IMU. Present if flags has MAIN_IMU_STATE."""

    def __init__(
        self,
        *,
        timestamp_ms: float = UNSET,
        timestamp_ms_raw: int = UNSET,
        flags: Optional[RealtimeDataCustomFlags] = UNSET,
        imu_angles: Optional[Axes[float]] = UNSET,
        imu_angles_raw: Optional[Axes[int]] = UNSET,
        target_angles: Optional[Axes[float]] = UNSET,
        target_angles_raw: Optional[Axes[int]] = UNSET,
        target_speed: Optional[Axes[float]] = UNSET,
        target_speed_raw: Optional[Axes[int]] = UNSET,
        stator_rotor_angle: Optional[Axes[float]] = UNSET,
        stator_rotor_angle_raw: Optional[Axes[int]] = UNSET,
        gyro_data: Optional[Axes[float]] = UNSET,
        gyro_data_raw: Optional[Axes[int]] = UNSET,
        rc_data: Optional[Iterable[float]] = UNSET,
        rc_data_raw: Optional[Iterable[int]] = UNSET,
        z1_vector: Optional[Xyz[float]] = UNSET,
        h1_vector: Optional[Xyz[float]] = UNSET,
        rc_channels: Optional[Iterable[float]] = UNSET,
        rc_channels_raw: Optional[Iterable[int]] = UNSET,
        acc_data: Optional[Axes[float]] = UNSET,
        acc_data_raw: Optional[Axes[int]] = UNSET,
        motor4_control: Optional[Motor4Control] = UNSET,
        ahrs_debug_info: Optional[AhrsDebugInfo] = UNSET,
        encoder_raw24: Optional[Axes[int]] = UNSET,
        imu_angles_rad: Optional[Axes[float]] = UNSET,
        imu_angles_rad_raw: Optional[Axes[float]] = UNSET,
        script_vars_float: Optional[Iterable[float]] = UNSET,
        script_vars_int16: Optional[Iterable[int]] = UNSET,
        system_power_state: Optional[SystemPowerState] = UNSET,
        frame_cam_rate: Optional[Axes[float]] = UNSET,
        frame_cam_rate_raw: Optional[Axes[int]] = UNSET,
        imu_angles_20: Optional[Axes[float]] = UNSET,
        imu_angles_20_raw: Optional[Axes[int]] = UNSET,
        target_angles_20: Optional[Axes[float]] = UNSET,
        target_angles_20_raw: Optional[Axes[int]] = UNSET,
        comm_errors: Optional[CommErrors] = UNSET,
        system_state: Optional[SystemStatus] = UNSET,
        imu_quat: Optional[int] = UNSET,
        target_quat: Optional[int] = UNSET,
        imu_to_frame_quat: Optional[int] = UNSET,
        adc_ch_raw: Optional[Iterable[int]] = UNSET,
        sw_limits_dist: Optional[Axes[SoftLimitDistances]] = UNSET,
        follow_dist: Optional[Axes[float]] = UNSET,
        follow_dist_raw: Optional[Axes[int]] = UNSET,
        ext_target_limit_min: Optional[Axes[float]] = UNSET,
        ext_target_limit_min_raw: Optional[Axes[int]] = UNSET,
        ext_target_limit_max: Optional[Axes[float]] = UNSET,
        ext_target_limit_max_raw: Optional[Axes[int]] = UNSET,
        frame_cam_angle_20: Optional[Axes[float]] = UNSET,
        frame_cam_angle_20_raw: Optional[Axes[int]] = UNSET,
        main_imu_state: Optional[MainImuState] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            timestamp_ms=timestamp_ms,
            timestamp_ms_raw=timestamp_ms_raw,
            flags=flags,
            imu_angles=imu_angles,
            imu_angles_raw=imu_angles_raw,
            target_angles=target_angles,
            target_angles_raw=target_angles_raw,
            target_speed=target_speed,
            target_speed_raw=target_speed_raw,
            stator_rotor_angle=stator_rotor_angle,
            stator_rotor_angle_raw=stator_rotor_angle_raw,
            gyro_data=gyro_data,
            gyro_data_raw=gyro_data_raw,
            rc_data=rc_data,
            rc_data_raw=rc_data_raw,
            z1_vector=z1_vector,
            h1_vector=h1_vector,
            rc_channels=rc_channels,
            rc_channels_raw=rc_channels_raw,
            acc_data=acc_data,
            acc_data_raw=acc_data_raw,
            motor4_control=motor4_control,
            ahrs_debug_info=ahrs_debug_info,
            encoder_raw24=encoder_raw24,
            imu_angles_rad=imu_angles_rad,
            imu_angles_rad_raw=imu_angles_rad_raw,
            script_vars_float=script_vars_float,
            script_vars_int16=script_vars_int16,
            system_power_state=system_power_state,
            frame_cam_rate=frame_cam_rate,
            frame_cam_rate_raw=frame_cam_rate_raw,
            imu_angles_20=imu_angles_20,
            imu_angles_20_raw=imu_angles_20_raw,
            target_angles_20=target_angles_20,
            target_angles_20_raw=target_angles_20_raw,
            comm_errors=comm_errors,
            system_state=system_state,
            imu_quat=imu_quat,
            target_quat=target_quat,
            imu_to_frame_quat=imu_to_frame_quat,
            adc_ch_raw=adc_ch_raw,
            sw_limits_dist=sw_limits_dist,
            follow_dist=follow_dist,
            follow_dist_raw=follow_dist_raw,
            ext_target_limit_min=ext_target_limit_min,
            ext_target_limit_min_raw=ext_target_limit_min_raw,
            ext_target_limit_max=ext_target_limit_max,
            ext_target_limit_max_raw=ext_target_limit_max_raw,
            frame_cam_angle_20=frame_cam_angle_20,
            frame_cam_angle_20_raw=frame_cam_angle_20_raw,
            main_imu_state=main_imu_state,
            tail=tail,
        )


class RealtimeDataCustomRequest(Request["RealtimeDataCustom"]):
    """Request live data of the blocks in FLAGS.

    The requested blocks must fit into one body of 255 bytes; all of them do not.

    CMD_REALTIME_DATA_CUSTOM (88), to the board; 10 bytes. Effect: reads. Since firmware 2.59,
    board 3.0. Source: Outgoing commands L980-L983; Variables L1208-L1209.
    """

    __slots__ = ()

    flags: Field[RealtimeDataCustomFlags, RealtimeDataCustomFlags] = Field(
        ValueOf(RealtimeDataCustomFlags),
    )
    """Blocks to send."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        flags: RealtimeDataCustomFlags = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(flags=flags, reserved=reserved, tail=tail)


class RealtimeDataCustom2(Message):
    """More live data of the requested blocks.

    CMD_REALTIME_DATA_CUSTOM2 (139), from the board; 2 to 52 bytes, and later firmware may
    append more. Since firmware 2.74.2. Source: Vendor's code of 2026.
    """

    __slots__ = ()

    timestamp_ms: Field[float, float] = Field(REAL)
    """Time of the sample. Unit: ms."""
    timestamp_ms_raw: Field[int, int] = Field(RAW, of="timestamp_ms")
    """The number on the wire for timestamp_ms."""
    flags: Field[Optional[RealtimeDataCustom2Flags], Optional[RealtimeDataCustom2Flags]] = Field(
        ValueOf(RealtimeDataCustom2Flags),
        optional=True,
    )
    """FLAGS of the request. Present if flags has INCLUDE_FLAGS."""
    frame_imu_angles: Field[Optional[Axes[float]], Optional[Axes[float]]] = Field(
        AxesOf(REAL),
        optional=True,
    )
    """Angles of the frame IMU (Euler). Unit: deg. Positive pitch is down, negative up; positive yaw
    is right, negative left; for roll it is not known. Present if flags has FRAME_IMU_ANGLES.
    """
    frame_imu_angles_raw: Field[Optional[Axes[int]], Optional[Axes[int]]] = Field(
        AxesOf(RAW),
        optional=True,
        of="frame_imu_angles",
    )
    """The number on the wire for frame_imu_angles."""
    frame_gyro: Field[Optional[Axes[float]], Optional[Axes[float]]] = Field(
        AxesOf(REAL),
        optional=True,
    )
    """Gyroscope of the frame IMU. Unit: deg/s. Present if flags has FRAME_GYRO."""
    frame_gyro_raw: Field[Optional[Axes[int]], Optional[Axes[int]]] = Field(
        AxesOf(RAW),
        optional=True,
        of="frame_gyro",
    )
    """The number on the wire for frame_gyro."""
    frame_acc: Field[Optional[Axes[float]], Optional[Axes[float]]] = Field(
        AxesOf(REAL),
        optional=True,
    )
    """Accelerometer of the frame IMU. Unit: g. Present if flags has FRAME_ACC."""
    frame_acc_raw: Field[Optional[Axes[int]], Optional[Axes[int]]] = Field(
        AxesOf(RAW),
        optional=True,
        of="frame_acc",
    )
    """The number on the wire for frame_acc."""
    debug: Field[Optional[Elements[int]], Optional[Iterable[int]]] = Field(
        ListOf(RAW),
        optional=True,
    )
    """Values for debugging. Present if flags has DEBUG."""
    mag_sens_data: Field[Optional[Axes[int]], Optional[Axes[int]]] = Field(
        AxesOf(RAW),
        optional=True,
    )
    """Raw magnetometer data. Present if flags has MAG_SENS_DATA."""
    pin_state: Field[Optional[PinStates], Optional[PinStates]] = Field(
        GroupOf(PinStates),
        optional=True,
    )
    """State of the inputs. Present if flags has PIN_STATE."""
    stab_err_ampl: Field[Optional[Axes[float]], Optional[Axes[float]]] = Field(
        AxesOf(REAL),
        optional=True,
    )
    """Amplitude of the stabilization error. Unit: deg. Present if flags has STAB_ERR_AMPL."""
    stab_err_ampl_raw: Field[Optional[Axes[int]], Optional[Axes[int]]] = Field(
        AxesOf(RAW),
        optional=True,
        of="stab_err_ampl",
    )
    """The number on the wire for stab_err_ampl."""

    def __init__(
        self,
        *,
        timestamp_ms: float = UNSET,
        timestamp_ms_raw: int = UNSET,
        flags: Optional[RealtimeDataCustom2Flags] = UNSET,
        frame_imu_angles: Optional[Axes[float]] = UNSET,
        frame_imu_angles_raw: Optional[Axes[int]] = UNSET,
        frame_gyro: Optional[Axes[float]] = UNSET,
        frame_gyro_raw: Optional[Axes[int]] = UNSET,
        frame_acc: Optional[Axes[float]] = UNSET,
        frame_acc_raw: Optional[Axes[int]] = UNSET,
        debug: Optional[Iterable[int]] = UNSET,
        mag_sens_data: Optional[Axes[int]] = UNSET,
        pin_state: Optional[PinStates] = UNSET,
        stab_err_ampl: Optional[Axes[float]] = UNSET,
        stab_err_ampl_raw: Optional[Axes[int]] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            timestamp_ms=timestamp_ms,
            timestamp_ms_raw=timestamp_ms_raw,
            flags=flags,
            frame_imu_angles=frame_imu_angles,
            frame_imu_angles_raw=frame_imu_angles_raw,
            frame_gyro=frame_gyro,
            frame_gyro_raw=frame_gyro_raw,
            frame_acc=frame_acc,
            frame_acc_raw=frame_acc_raw,
            debug=debug,
            mag_sens_data=mag_sens_data,
            pin_state=pin_state,
            stab_err_ampl=stab_err_ampl,
            stab_err_ampl_raw=stab_err_ampl_raw,
            tail=tail,
        )


class RealtimeDataCustom2Request(Request["RealtimeDataCustom2"]):
    """Request live data of the blocks in FLAGS.

    CMD_REALTIME_DATA_CUSTOM2 (139), to the board; 10 bytes. Effect: reads. Since firmware
    2.74.2. Source: Vendor's code of 2026.
    """

    __slots__ = ()

    flags: Field[RealtimeDataCustom2Flags, RealtimeDataCustom2Flags] = Field(
        ValueOf(RealtimeDataCustom2Flags),
    )
    """Blocks to send."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        flags: RealtimeDataCustom2Flags = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(flags=flags, reserved=reserved, tail=tail)


class DataStreamInterval(Request["Confirm"]):
    """Start, change or end a data stream: messages that the board sends at a fixed rate.

    CMD_ID and CONFIG together identify the stream on this port; a second request with the same
    values changes its interval. Each sample is within 1 ms of its time, and the average rate is
    exact. Samples that exceed the capacity of the port are dropped. With SYNC_TO_DATA,
    INTERVAL_MS is a divider: the number of events for each sample.

    CMD_DATA_STREAM_INTERVAL (85), to the board; 21 bytes. Effect: sets. Since firmware 2.59,
    board 3.0. Source: Outgoing commands L963-L978; Variables L1202-L1207.
    """

    __slots__ = ()

    END_STREAM: ClassVar[int] = 0
    """For interval_ms, as raw value: ends the stream."""
    EVERY_CYCLE: ClassVar[int] = 1
    """For interval_ms, as raw value: a sample in every cycle, 0.8 ms."""
    cmd_id: Field[CommandFromBoard, CommandFromBoard] = Field(ValueOf(CommandFromBoard))
    """Message to send."""
    interval_ms: Field[float, float] = Field(REAL)
    """Time between samples; a divider with SYNC_TO_DATA. Unit: ms. Raw value 0: ends the stream.
    Raw value 1: a sample in every cycle, 0.8 ms.
    """
    interval_ms_raw: Field[int, int] = Field(RAW, of="interval_ms")
    """The number on the wire for interval_ms."""
    config: Field[StreamConfig, StreamConfig] = Field(GroupOf(StreamConfig))
    """Options of the message; unused bytes are 0."""
    sync_to_data: Field[StreamSync, StreamSync] = Field(ValueOf(StreamSync))
    """Event that triggers the samples. Since firmware 2.70b1."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        cmd_id: CommandFromBoard = UNSET,
        interval_ms: float = UNSET,
        interval_ms_raw: int = UNSET,
        config: StreamConfig = UNSET,
        sync_to_data: StreamSync = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            cmd_id=cmd_id,
            interval_ms=interval_ms,
            interval_ms_raw=interval_ms_raw,
            config=config,
            sync_to_data=sync_to_data,
            reserved=reserved,
            tail=tail,
        )


class CanDrvTelemetry(Message):
    """Live data of a CAN motor driver.

    The board sends it only as a stream that CMD_DATA_STREAM_INTERVAL starts.

    CMD_CAN_DRV_TELEMETRY (127), from the board; 3 to 35 bytes, and later firmware may append
    more. Since firmware 2.72, board 3.6. Unconfirmed. Source: Later firmware.
    """

    __slots__ = ()

    drv_id: Field[int, int] = Field(RAW)
    """The driver. Range: 0 to 6."""
    timestamp_ms: Field[float, float] = Field(REAL)
    """Time of the sample. Unit: ms."""
    timestamp_ms_raw: Field[int, int] = Field(RAW, of="timestamp_ms")
    """The number on the wire for timestamp_ms."""
    can_bus_flags: Field[Optional[int], Optional[int]] = Field(RAW, optional=True)
    """State of the CAN bus; its bits are not documented. Present if flags has CAN_BUS_FLAGS."""
    can_bus_err_cnt: Field[Optional[int], Optional[int]] = Field(RAW, optional=True)
    """Number of errors on the CAN bus. Present if flags has CAN_BUS_ERR_CNT."""
    temp_board: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Temperature of the driver. Unit: degC. Present if flags has TEMP_BOARD."""
    temp_board_raw: Field[Optional[int], Optional[int]] = Field(RAW, optional=True, of="temp_board")
    """The number on the wire for temp_board."""
    temp_motor: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Temperature of the motor. Unit: degC. Present if flags has TEMP_MOTOR."""
    temp_motor_raw: Field[Optional[int], Optional[int]] = Field(RAW, optional=True, of="temp_motor")
    """The number on the wire for temp_motor."""
    avg_current: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Average current. Unit: mA. Present if flags has AVG_CURRENT."""
    avg_current_raw: Field[Optional[int], Optional[int]] = Field(
        RAW,
        optional=True,
        of="avg_current",
    )
    """The number on the wire for avg_current."""
    bus_voltage: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Supply voltage. Unit: V. Present if flags has BUS_VOLTAGE."""
    bus_voltage_raw: Field[Optional[int], Optional[int]] = Field(
        RAW,
        optional=True,
        of="bus_voltage",
    )
    """The number on the wire for bus_voltage."""
    pin_state: Field[Optional[CanDrvPins], Optional[CanDrvPins]] = Field(
        ValueOf(CanDrvPins),
        optional=True,
    )
    """State of the pins. Present if flags has PIN_STATE."""
    phase_current: Field[Optional[Elements[float]], Optional[Iterable[float]]] = Field(
        ListOf(REAL),
        optional=True,
    )
    """Current of each phase. Unit: mA. Present if flags has PHASE_CURRENT."""
    phase_current_raw: Field[Optional[Elements[int]], Optional[Iterable[int]]] = Field(
        ListOf(RAW),
        optional=True,
        of="phase_current",
    )
    """The number on the wire for phase_current."""
    encoder_error_cnt: Field[Optional[int], Optional[int]] = Field(RAW, optional=True)
    """Number of errors of the encoder. Present if flags has ENCODER_ERROR_CNT."""
    iq_current: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Current that makes torque. Unit: mA. Present if flags has IQ_ID_CURRENT."""
    iq_current_raw: Field[Optional[int], Optional[int]] = Field(RAW, optional=True, of="iq_current")
    """The number on the wire for iq_current."""
    id_current: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Current that makes the field. Unit: mA. Present if flags has IQ_ID_CURRENT."""
    id_current_raw: Field[Optional[int], Optional[int]] = Field(RAW, optional=True, of="id_current")
    """The number on the wire for id_current."""
    motor_speed: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Speed of the motor. Unit: rpm. Positive pitch is down, negative up; positive yaw is right,
    negative left; for roll it is not known. Present if flags has MOTOR_SPEED.
    """
    motor_speed_raw: Field[Optional[int], Optional[int]] = Field(
        RAW,
        optional=True,
        of="motor_speed",
    )
    """The number on the wire for motor_speed."""
    pid_pos_err: Field[Optional[int], Optional[int]] = Field(RAW, optional=True)
    """Error of the position controller. Present if flags has PID_POS_ERR."""
    pid_speed_err: Field[Optional[int], Optional[int]] = Field(RAW, optional=True)
    """Error of the speed controller. Present if flags has PID_SPEED_ERR."""
    iq_ref: Field[Optional[float], Optional[float]] = Field(REAL, optional=True)
    """Target of the torque current. Unit: %. Present if flags has IQ_REF."""
    iq_ref_raw: Field[Optional[int], Optional[int]] = Field(RAW, optional=True, of="iq_ref")
    """The number on the wire for iq_ref."""
    pid_current_err: Field[Optional[int], Optional[int]] = Field(RAW, optional=True)
    """Error of the current controller. Present if flags has PID_CURRENT_ERR."""

    def __init__(
        self,
        *,
        drv_id: int = UNSET,
        timestamp_ms: float = UNSET,
        timestamp_ms_raw: int = UNSET,
        can_bus_flags: Optional[int] = UNSET,
        can_bus_err_cnt: Optional[int] = UNSET,
        temp_board: Optional[float] = UNSET,
        temp_board_raw: Optional[int] = UNSET,
        temp_motor: Optional[float] = UNSET,
        temp_motor_raw: Optional[int] = UNSET,
        avg_current: Optional[float] = UNSET,
        avg_current_raw: Optional[int] = UNSET,
        bus_voltage: Optional[float] = UNSET,
        bus_voltage_raw: Optional[int] = UNSET,
        pin_state: Optional[CanDrvPins] = UNSET,
        phase_current: Optional[Iterable[float]] = UNSET,
        phase_current_raw: Optional[Iterable[int]] = UNSET,
        encoder_error_cnt: Optional[int] = UNSET,
        iq_current: Optional[float] = UNSET,
        iq_current_raw: Optional[int] = UNSET,
        id_current: Optional[float] = UNSET,
        id_current_raw: Optional[int] = UNSET,
        motor_speed: Optional[float] = UNSET,
        motor_speed_raw: Optional[int] = UNSET,
        pid_pos_err: Optional[int] = UNSET,
        pid_speed_err: Optional[int] = UNSET,
        iq_ref: Optional[float] = UNSET,
        iq_ref_raw: Optional[int] = UNSET,
        pid_current_err: Optional[int] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            drv_id=drv_id,
            timestamp_ms=timestamp_ms,
            timestamp_ms_raw=timestamp_ms_raw,
            can_bus_flags=can_bus_flags,
            can_bus_err_cnt=can_bus_err_cnt,
            temp_board=temp_board,
            temp_board_raw=temp_board_raw,
            temp_motor=temp_motor,
            temp_motor_raw=temp_motor_raw,
            avg_current=avg_current,
            avg_current_raw=avg_current_raw,
            bus_voltage=bus_voltage,
            bus_voltage_raw=bus_voltage_raw,
            pin_state=pin_state,
            phase_current=phase_current,
            phase_current_raw=phase_current_raw,
            encoder_error_cnt=encoder_error_cnt,
            iq_current=iq_current,
            iq_current_raw=iq_current_raw,
            id_current=id_current,
            id_current_raw=id_current_raw,
            motor_speed=motor_speed,
            motor_speed_raw=motor_speed_raw,
            pid_pos_err=pid_pos_err,
            pid_speed_err=pid_speed_err,
            iq_ref=iq_ref,
            iq_ref_raw=iq_ref_raw,
            pid_current_err=pid_current_err,
            tail=tail,
        )


class CanDrvState(Message):
    """Undocumented body from the board.

    CMD_CAN_DRV_STATE (98), from the board; 0 to 255 bytes. Since firmware 2.60. Source: Later
    firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class CanDrvStateRequest(Request["Optional[Confirm]"]):
    """Undocumented body to the board.

    CMD_CAN_DRV_STATE (98), to the board; 0 to 255 bytes. Effect: unknown. Since firmware 2.60.
    Source: Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class RealtimeDataCanDrv(Message):
    """Undocumented body from the board.

    CMD_REALTIME_DATA_CAN_DRV (101), from the board; 0 to 255 bytes. Since firmware 2.60.
    Source: Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class RealtimeDataCanDrvRequest(Request["Optional[Confirm]"]):
    """Undocumented body to the board.

    CMD_REALTIME_DATA_CAN_DRV (101), to the board; 0 to 255 bytes. Effect: unknown. Since
    firmware 2.60. Source: Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)
