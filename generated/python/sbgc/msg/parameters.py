# Generated from spec/ by generator/: edit those, then run ./dev generate.
"""Parameters of the board and of its five profiles."""

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
    "AxisNotches",
    "AxisPid",
    "AxisRc",
    "MavChannel",
    "ProfileSet",
    "RcCalibration",
    "ReadParams",
    "ReadParams3",
    "ReadParams3Request",
    "ReadParamsAnswer",
    "ReadParamsExt",
    "ReadParamsExt2",
    "ReadParamsExt2Request",
    "ReadParamsExtRequest",
    "ReadProfileNames",
    "ReadProfileNamesRequest",
    "SaveParams3",
    "StepSignal",
    "UseDefaults",
    "WriteParams",
    "WriteParams3",
    "WriteParamsExt",
    "WriteParamsExt2",
    "WriteParamsSet",
    "WriteProfileNames",
]

Bytes = Union[bytes, bytearray, memoryview]


class AxisPid(Structure):
    """Controller and motor of each axis."""

    __slots__ = ()
    _home = ("ReadParams3", "axes.roll")

    p: Field[int, int] = Field(RAW)
    """Proportional gain."""
    i: Field[float, float] = Field(REAL)
    """Integral gain."""
    i_raw: Field[int, int] = Field(RAW, of="i")
    """The number on the wire for i."""
    d: Field[int, int] = Field(RAW)
    """Derivative gain."""
    power: Field[int, int] = Field(RAW)
    """Power of the motor."""
    invert: Field[int, int] = Field(RAW)
    """1 inverts the motor's direction. Range: 0 to 1."""
    poles: Field[int, int] = Field(RAW)
    """Number of motor poles."""

    def __init__(
        self,
        *,
        p: int = UNSET,
        i: float = UNSET,
        i_raw: int = UNSET,
        d: int = UNSET,
        power: int = UNSET,
        invert: int = UNSET,
        poles: int = UNSET,
    ) -> None:
        self._start(p=p, i=i, i_raw=i_raw, d=d, power=power, invert=invert, poles=poles)


class AxisRc(Structure):
    """Remote control of an axis."""

    __slots__ = ()
    _home = ("ReadParams3", "rc.roll")

    rc_min_angle: Field[float, float] = Field(REAL)
    """Angle at the lowest signal. Range: -720 to 720 deg. Positive pitch is down, negative up;
    positive yaw is right, negative left; for roll it is not known.
    """
    rc_min_angle_raw: Field[int, int] = Field(RAW, of="rc_min_angle")
    """The number on the wire for rc_min_angle."""
    rc_max_angle: Field[float, float] = Field(REAL)
    """Angle at the highest signal. Range: -720 to 720 deg. Positive pitch is down, negative up;
    positive yaw is right, negative left; for roll it is not known.
    """
    rc_max_angle_raw: Field[int, int] = Field(RAW, of="rc_max_angle")
    """The number on the wire for rc_max_angle."""
    rc_mode: Field[RcMode, int] = Field(ValueOf(RcMode))
    """What the signal controls."""
    rc_lpf: Field[int, int] = Field(RAW)
    """Low-pass filter of the signal; up to 255 only with LPF_EXTENDED_RANGE."""
    rc_speed: Field[int, int] = Field(RAW)
    """Control speed."""
    rc_follow: Field[int, int] = Field(RAW)
    """Roll and pitch: how much to follow the flight controller. Yaw: any value but 0 follows the
    motor. Range: -127 to 127.
    """

    def __init__(
        self,
        *,
        rc_min_angle: float = UNSET,
        rc_min_angle_raw: int = UNSET,
        rc_max_angle: float = UNSET,
        rc_max_angle_raw: int = UNSET,
        rc_mode: int = UNSET,
        rc_lpf: int = UNSET,
        rc_speed: int = UNSET,
        rc_follow: int = UNSET,
    ) -> None:
        self._start(
            rc_min_angle=rc_min_angle,
            rc_min_angle_raw=rc_min_angle_raw,
            rc_max_angle=rc_max_angle,
            rc_max_angle_raw=rc_max_angle_raw,
            rc_mode=rc_mode,
            rc_lpf=rc_lpf,
            rc_speed=rc_speed,
            rc_follow=rc_follow,
        )


class AxisNotches(Structure):
    """Notch filters of each axis."""

    __slots__ = ()
    _home = ("ReadParamsExt", "notches.roll")

    notch_freq: Field[Elements[float], Iterable[float]] = Field(ListOf(REAL))
    """Center frequency of each of the three filters. Unit: Hz."""
    notch_freq_raw: Field[Elements[int], Iterable[int]] = Field(ListOf(RAW), of="notch_freq")
    """The number on the wire for notch_freq."""
    notch_width: Field[Elements[float], Iterable[float]] = Field(ListOf(REAL))
    """Width of each filter, between its -3 dB points. Unit: Hz."""
    notch_width_raw: Field[Elements[int], Iterable[int]] = Field(ListOf(RAW), of="notch_width")
    """The number on the wire for notch_width."""

    def __init__(
        self,
        *,
        notch_freq: Iterable[float] = UNSET,
        notch_freq_raw: Iterable[int] = UNSET,
        notch_width: Iterable[float] = UNSET,
        notch_width_raw: Iterable[int] = UNSET,
    ) -> None:
        self._start(
            notch_freq=notch_freq,
            notch_freq_raw=notch_freq_raw,
            notch_width=notch_width,
            notch_width_raw=notch_width_raw,
        )


class MavChannel(Structure):
    """MAVLink channels."""

    __slots__ = ()
    _home = ("ReadParamsExt2", "mav_channels[0]")

    mav_src: Field[BoardPort, BoardPort] = Field(ValueOf(BoardPort))
    """Serial port of the channel."""
    mav_sys_id: Field[int, int] = Field(RAW)
    """MAVLink system id of the channel."""
    mav_comp_id: Field[int, int] = Field(RAW)
    """MAVLink component id of the channel."""
    mav_cfg_flags: Field[MavConfig, int] = Field(ValueOf(MavConfig))
    """Settings of the channel."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        mav_src: BoardPort = UNSET,
        mav_sys_id: int = UNSET,
        mav_comp_id: int = UNSET,
        mav_cfg_flags: int = UNSET,
        reserved: Bytes = UNSET,
    ) -> None:
        self._start(
            mav_src=mav_src,
            mav_sys_id=mav_sys_id,
            mav_comp_id=mav_comp_id,
            mav_cfg_flags=mav_cfg_flags,
            reserved=reserved,
        )


class StepSignal(Structure):
    """Step signals: each counts how often an RC signal reaches a level."""

    __slots__ = ()
    _home = ("ReadParamsExt2", "step_signals[0]")

    step_signal_src: Field[RcMap, int] = Field(ValueOf(RcMap))
    """RC signal that triggers the steps."""
    step_signal_cfg: Field[StepSignalConfig, int] = Field(ValueOf(StepSignalConfig))
    """Number of steps and how to trigger them."""

    def __init__(self, *, step_signal_src: int = UNSET, step_signal_cfg: int = UNSET) -> None:
        self._start(step_signal_src=step_signal_src, step_signal_cfg=step_signal_cfg)


class RcCalibration(Structure):
    """Calibrations of RC signals: an offset is added, then a factor is applied."""

    __slots__ = ()
    _home = ("ReadParamsExt2", "rc_calibrations[0]")

    rc_calib_src: Field[RcMap, int] = Field(ValueOf(RcMap))
    """Calibrated signal."""
    rc_calib_offset: Field[float, float] = Field(REAL)
    """Offset of the signal."""
    rc_calib_offset_raw: Field[int, int] = Field(RAW, of="rc_calib_offset")
    """The number on the wire for rc_calib_offset."""
    rc_calib_neg_scale: Field[float, float] = Field(REAL)
    """Factor below the center. Unit: %."""
    rc_calib_neg_scale_raw: Field[int, int] = Field(RAW, of="rc_calib_neg_scale")
    """The number on the wire for rc_calib_neg_scale."""
    rc_calib_pos_scale: Field[float, float] = Field(REAL)
    """Factor above the center. Unit: %."""
    rc_calib_pos_scale_raw: Field[int, int] = Field(RAW, of="rc_calib_pos_scale")
    """The number on the wire for rc_calib_pos_scale."""

    def __init__(
        self,
        *,
        rc_calib_src: int = UNSET,
        rc_calib_offset: float = UNSET,
        rc_calib_offset_raw: int = UNSET,
        rc_calib_neg_scale: float = UNSET,
        rc_calib_neg_scale_raw: int = UNSET,
        rc_calib_pos_scale: float = UNSET,
        rc_calib_pos_scale_raw: int = UNSET,
    ) -> None:
        self._start(
            rc_calib_src=rc_calib_src,
            rc_calib_offset=rc_calib_offset,
            rc_calib_offset_raw=rc_calib_offset_raw,
            rc_calib_neg_scale=rc_calib_neg_scale,
            rc_calib_neg_scale_raw=rc_calib_neg_scale_raw,
            rc_calib_pos_scale=rc_calib_pos_scale,
            rc_calib_pos_scale_raw=rc_calib_pos_scale_raw,
        )


class ReadParams3(Message):
    """Parameters of one profile and general parameters.

    CMD_READ_PARAMS_3 (21), from the board; 134 bytes, and later firmware may append more. Since
    board 3.0. Rules: rc.rc_min_angle <= rc.rc_max_angle. Source: Incoming commands L180-L310;
    Variables L1010-L1079.
    """

    __slots__ = ()

    ACTIVE_PROFILE: ClassVar[int] = 255
    """For profile_id, as raw value: the active profile."""
    ACC_LIMITER_DISABLED: ClassVar[int] = 0
    """For acc_limiter_all, as raw value: disabled."""
    SERVO_DISABLED: ClassVar[int] = 0
    """For servo_out, as raw value: disabled."""
    profile_id: Field[int, int] = Field(RAW)
    """Profile of the parameters. Range: 0 to 4. Value 255: the active profile."""
    axes: Field[Axes[AxisPid], Axes[AxisPid]] = Field(AxesOf(GroupOf(AxisPid)))
    """Controller and motor of each axis."""
    acc_limiter_all: Field[float, float] = Field(REAL)
    """Acceleration limit of all axes. Unit: deg/s^2. Raw value 0: disabled. Deprecated since
    firmware 2.59: use ACC_LIMITER3 of CMD_READ_PARAMS_EXT2.
    """
    acc_limiter_all_raw: Field[int, int] = Field(RAW, of="acc_limiter_all")
    """The number on the wire for acc_limiter_all."""
    ext_fc_gain_roll: Field[int, int] = Field(RAW)
    """Gain of the flight controller's roll signal. Range: -127 to 127."""
    ext_fc_gain_pitch: Field[int, int] = Field(RAW)
    """Gain of the flight controller's pitch signal. Range: -127 to 127."""
    rc: Field[Axes[AxisRc], Axes[AxisRc]] = Field(AxesOf(GroupOf(AxisRc)))
    """Remote control of each axis."""
    gyro_trust: Field[int, int] = Field(RAW)
    """Trust in the gyroscope relative to the accelerometer."""
    use_model: Field[int, int] = Field(RAW)
    """1 enables the motor model. Range: 0 to 1."""
    pwm_freq: Field[PwmFrequency, PwmFrequency] = Field(ValueOf(PwmFrequency))
    """PWM frequency of the motors."""
    serial_speed: Field[SerialSpeed, SerialSpeed] = Field(ValueOf(SerialSpeed))
    """Baud rate of the serial port. The same in all copies."""
    rc_trim: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Trim of the RC signals. Range: -127 to 127."""
    rc_deadband: Field[int, int] = Field(RAW)
    """Dead band around the center of the RC signals."""
    rc_expo_rate: Field[int, int] = Field(RAW)
    """Expo rate of the RC signals. Range: 0 to 100."""
    rc_virt_mode: Field[RcVirtualMode, RcVirtualMode] = Field(ValueOf(RcVirtualMode))
    """Signal at the RC_ROLL pin."""
    rc_map: Field[Axes[RcMap], Axes[RcMap]] = Field(AxesOf(ValueOf(RcMap)))
    """Control source of each axis."""
    rc_map_cmd: Field[RcMap, int] = Field(ValueOf(RcMap))
    """Source of the command channel."""
    rc_map_fc_roll: Field[RcMap, int] = Field(ValueOf(RcMap))
    """Source of the flight controller's roll signal."""
    rc_map_fc_pitch: Field[RcMap, int] = Field(ValueOf(RcMap))
    """Source of the flight controller's pitch signal."""
    rc_mix_fc_roll: Field[RcMix, int] = Field(ValueOf(RcMix))
    """Mix of the flight controller's roll signal."""
    rc_mix_fc_pitch: Field[RcMix, int] = Field(ValueOf(RcMix))
    """Mix of the flight controller's pitch signal."""
    follow_mode: Field[FollowMode, FollowMode] = Field(ValueOf(FollowMode))
    """What the camera follows."""
    follow_deadband: Field[int, int] = Field(RAW)
    """Dead band of the follow mode."""
    follow_expo_rate: Field[int, int] = Field(RAW)
    """Expo rate of the follow mode. Range: 0 to 100."""
    follow_offset: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Offset of the follow mode. Range: -127 to 127. Deprecated since firmware 2.70: use
    FOLLOW_OFFSET_EXT of CMD_READ_PARAMS_EXT3.
    """
    axis_top: Field[SensorAxis, SensorAxis] = Field(ValueOf(SensorAxis))
    """Axis of the main IMU that points up. The same in all copies."""
    axis_right: Field[SensorAxis, SensorAxis] = Field(ValueOf(SensorAxis))
    """Axis of the main IMU that points right. The same in all copies."""
    frame_axis_top: Field[SensorAxis, SensorAxis] = Field(ValueOf(SensorAxis))
    """Axis of the frame IMU that points up. The same in all copies."""
    frame_axis_right: Field[SensorAxis, SensorAxis] = Field(ValueOf(SensorAxis))
    """Axis of the frame IMU that points right. The same in all copies."""
    frame_imu_pos: Field[FrameImuPosition, FrameImuPosition] = Field(ValueOf(FrameImuPosition))
    """Location of the frame IMU. The same in all copies."""
    gyro_deadband: Field[float, float] = Field(REAL)
    """Dead band of the gyroscope. Unit: gyro unit."""
    gyro_deadband_raw: Field[int, int] = Field(RAW, of="gyro_deadband")
    """The number on the wire for gyro_deadband."""
    gyro_sens: Field[int, int] = Field(RAW)
    """Sensitivity of the gyroscope. Deprecated."""
    i2c_internal_pullups: Field[int, int] = Field(RAW)
    """1 enables the controller's I2C pull-ups; in later firmware, an I2C clock of 800 kHz instead
    of 400 kHz. Range: 0 to 1.
    """
    skip_gyro_calib: Field[SkipGyroCalibration, SkipGyroCalibration] = Field(
        ValueOf(SkipGyroCalibration),
    )
    """Gyroscope calibration at start-up."""
    rc_cmd_low: Field[MenuCommand, MenuCommand] = Field(ValueOf(MenuCommand))
    """Action for a low signal on the command channel."""
    rc_cmd_mid: Field[MenuCommand, MenuCommand] = Field(ValueOf(MenuCommand))
    """Action for a middle signal on the command channel."""
    rc_cmd_high: Field[MenuCommand, MenuCommand] = Field(ValueOf(MenuCommand))
    """Action for a high signal on the command channel."""
    menu_cmd: Field[Elements[MenuCommand], Iterable[MenuCommand]] = Field(
        ListOf(ValueOf(MenuCommand)),
    )
    """Actions for 1 to 5 presses of the menu button."""
    menu_cmd_long: Field[MenuCommand, MenuCommand] = Field(ValueOf(MenuCommand))
    """Action for a long press of the menu button."""
    output: Field[Axes[MotorOutput], Axes[MotorOutput]] = Field(AxesOf(ValueOf(MotorOutput)))
    """Motor output of each axis."""
    bat_threshold_alarm: Field[float, float] = Field(REAL)
    """Battery voltage that triggers the alarm; negative disables it. Range: -30 to 30 V."""
    bat_threshold_alarm_raw: Field[int, int] = Field(RAW, of="bat_threshold_alarm")
    """The number on the wire for bat_threshold_alarm."""
    bat_threshold_motors: Field[float, float] = Field(REAL)
    """Battery voltage that stops the motors; negative disables it. Range: -30 to 30 V."""
    bat_threshold_motors_raw: Field[int, int] = Field(RAW, of="bat_threshold_motors")
    """The number on the wire for bat_threshold_motors."""
    bat_comp_ref: Field[float, float] = Field(REAL)
    """Reference voltage of the motor power compensation; negative disables it. Range: -30 to 30 V.
    """
    bat_comp_ref_raw: Field[int, int] = Field(RAW, of="bat_comp_ref")
    """The number on the wire for bat_comp_ref."""
    beeper_modes: Field[BeeperModes, BeeperModes] = Field(ValueOf(BeeperModes))
    """When the board makes a sound."""
    follow_roll_mix_start: Field[float, float] = Field(REAL)
    """Angle at which pitch starts to follow roll. Range: 0 to 90 deg."""
    follow_roll_mix_start_raw: Field[int, int] = Field(RAW, of="follow_roll_mix_start")
    """The number on the wire for follow_roll_mix_start."""
    follow_roll_mix_range: Field[float, float] = Field(REAL)
    """Angle over which pitch continues to follow roll. Range: 0 to 90 deg."""
    follow_roll_mix_range_raw: Field[int, int] = Field(RAW, of="follow_roll_mix_range")
    """The number on the wire for follow_roll_mix_range."""
    booster_power: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Additional power to recover lost synchronization."""
    follow_speed: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Speed of the follow mode."""
    frame_angle_from_motors: Field[int, int] = Field(RAW)
    """1 estimates the frame angle from the motors. Range: 0 to 1."""
    rc_memory: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Angle at start-up. Unit: deg. Positive pitch is down, negative up; positive yaw is right,
    negative left; for roll it is not known.
    """
    rc_memory_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="rc_memory")
    """The number on the wire for rc_memory."""
    servo_out: Field[Elements[int], Iterable[int]] = Field(ListOf(RAW))
    """Virtual channel on each servo pin. Range: 1 to 32. Value 0: disabled."""
    servo_rate: Field[float, float] = Field(REAL)
    """PWM frequency of the servo outputs. Range: 50 to 400 Hz."""
    servo_rate_raw: Field[int, int] = Field(RAW, of="servo_rate")
    """The number on the wire for servo_rate."""
    adaptive_pid_enabled: Field[AdaptivePidAxes, AdaptivePidAxes] = Field(ValueOf(AdaptivePidAxes))
    """Axes with adaptive control."""
    adaptive_pid_threshold: Field[int, int] = Field(RAW)
    """Vibration level that starts the adaptation."""
    adaptive_pid_rate: Field[int, int] = Field(RAW)
    """Speed of the adaptation. Range: 1 to 255."""
    adaptive_pid_recovery_factor: Field[int, int] = Field(RAW)
    """How slowly the gains recover. Range: 0 to 10."""
    follow_lpf: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Low-pass filter of the follow mode. Range: 0 to 16."""
    general_flags1: Field[GeneralFlags, GeneralFlags] = Field(ValueOf(GeneralFlags))
    """Options of the whole board. The same in all copies."""
    profile_flags1: Field[ProfileFlags, ProfileFlags] = Field(ValueOf(ProfileFlags))
    """Options of the profile."""
    spektrum_mode: Field[SpektrumMode, SpektrumMode] = Field(ValueOf(SpektrumMode))
    """Protocol of a Spektrum satellite."""
    order_of_axes: Field[AxisOrder, AxisOrder] = Field(ValueOf(AxisOrder))
    """Order of the motors. The same in all copies."""
    euler_order: Field[EulerOrderSetting, int] = Field(ValueOf(EulerOrderSetting))
    """Order of the Euler angles."""
    cur_imu: Field[SelectedImu, SelectedImu] = Field(ValueOf(SelectedImu))
    """Selected IMU; write it back unchanged."""
    cur_profile_id: Field[int, int] = Field(RAW)
    """Active profile; write it back unchanged. Range: 0 to 4."""

    def __init__(
        self,
        *,
        profile_id: int = UNSET,
        axes: Axes[AxisPid] = UNSET,
        acc_limiter_all: float = UNSET,
        acc_limiter_all_raw: int = UNSET,
        ext_fc_gain_roll: int = UNSET,
        ext_fc_gain_pitch: int = UNSET,
        rc: Axes[AxisRc] = UNSET,
        gyro_trust: int = UNSET,
        use_model: int = UNSET,
        pwm_freq: PwmFrequency = UNSET,
        serial_speed: SerialSpeed = UNSET,
        rc_trim: Axes[int] = UNSET,
        rc_deadband: int = UNSET,
        rc_expo_rate: int = UNSET,
        rc_virt_mode: RcVirtualMode = UNSET,
        rc_map: Axes[RcMap] = UNSET,
        rc_map_cmd: int = UNSET,
        rc_map_fc_roll: int = UNSET,
        rc_map_fc_pitch: int = UNSET,
        rc_mix_fc_roll: int = UNSET,
        rc_mix_fc_pitch: int = UNSET,
        follow_mode: FollowMode = UNSET,
        follow_deadband: int = UNSET,
        follow_expo_rate: int = UNSET,
        follow_offset: Axes[int] = UNSET,
        axis_top: SensorAxis = UNSET,
        axis_right: SensorAxis = UNSET,
        frame_axis_top: SensorAxis = UNSET,
        frame_axis_right: SensorAxis = UNSET,
        frame_imu_pos: FrameImuPosition = UNSET,
        gyro_deadband: float = UNSET,
        gyro_deadband_raw: int = UNSET,
        gyro_sens: int = UNSET,
        i2c_internal_pullups: int = UNSET,
        skip_gyro_calib: SkipGyroCalibration = UNSET,
        rc_cmd_low: MenuCommand = UNSET,
        rc_cmd_mid: MenuCommand = UNSET,
        rc_cmd_high: MenuCommand = UNSET,
        menu_cmd: Iterable[MenuCommand] = UNSET,
        menu_cmd_long: MenuCommand = UNSET,
        output: Axes[MotorOutput] = UNSET,
        bat_threshold_alarm: float = UNSET,
        bat_threshold_alarm_raw: int = UNSET,
        bat_threshold_motors: float = UNSET,
        bat_threshold_motors_raw: int = UNSET,
        bat_comp_ref: float = UNSET,
        bat_comp_ref_raw: int = UNSET,
        beeper_modes: BeeperModes = UNSET,
        follow_roll_mix_start: float = UNSET,
        follow_roll_mix_start_raw: int = UNSET,
        follow_roll_mix_range: float = UNSET,
        follow_roll_mix_range_raw: int = UNSET,
        booster_power: Axes[int] = UNSET,
        follow_speed: Axes[int] = UNSET,
        frame_angle_from_motors: int = UNSET,
        rc_memory: Axes[float] = UNSET,
        rc_memory_raw: Axes[int] = UNSET,
        servo_out: Iterable[int] = UNSET,
        servo_rate: float = UNSET,
        servo_rate_raw: int = UNSET,
        adaptive_pid_enabled: AdaptivePidAxes = UNSET,
        adaptive_pid_threshold: int = UNSET,
        adaptive_pid_rate: int = UNSET,
        adaptive_pid_recovery_factor: int = UNSET,
        follow_lpf: Axes[int] = UNSET,
        general_flags1: GeneralFlags = UNSET,
        profile_flags1: ProfileFlags = UNSET,
        spektrum_mode: SpektrumMode = UNSET,
        order_of_axes: AxisOrder = UNSET,
        euler_order: int = UNSET,
        cur_imu: SelectedImu = UNSET,
        cur_profile_id: int = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            profile_id=profile_id,
            axes=axes,
            acc_limiter_all=acc_limiter_all,
            acc_limiter_all_raw=acc_limiter_all_raw,
            ext_fc_gain_roll=ext_fc_gain_roll,
            ext_fc_gain_pitch=ext_fc_gain_pitch,
            rc=rc,
            gyro_trust=gyro_trust,
            use_model=use_model,
            pwm_freq=pwm_freq,
            serial_speed=serial_speed,
            rc_trim=rc_trim,
            rc_deadband=rc_deadband,
            rc_expo_rate=rc_expo_rate,
            rc_virt_mode=rc_virt_mode,
            rc_map=rc_map,
            rc_map_cmd=rc_map_cmd,
            rc_map_fc_roll=rc_map_fc_roll,
            rc_map_fc_pitch=rc_map_fc_pitch,
            rc_mix_fc_roll=rc_mix_fc_roll,
            rc_mix_fc_pitch=rc_mix_fc_pitch,
            follow_mode=follow_mode,
            follow_deadband=follow_deadband,
            follow_expo_rate=follow_expo_rate,
            follow_offset=follow_offset,
            axis_top=axis_top,
            axis_right=axis_right,
            frame_axis_top=frame_axis_top,
            frame_axis_right=frame_axis_right,
            frame_imu_pos=frame_imu_pos,
            gyro_deadband=gyro_deadband,
            gyro_deadband_raw=gyro_deadband_raw,
            gyro_sens=gyro_sens,
            i2c_internal_pullups=i2c_internal_pullups,
            skip_gyro_calib=skip_gyro_calib,
            rc_cmd_low=rc_cmd_low,
            rc_cmd_mid=rc_cmd_mid,
            rc_cmd_high=rc_cmd_high,
            menu_cmd=menu_cmd,
            menu_cmd_long=menu_cmd_long,
            output=output,
            bat_threshold_alarm=bat_threshold_alarm,
            bat_threshold_alarm_raw=bat_threshold_alarm_raw,
            bat_threshold_motors=bat_threshold_motors,
            bat_threshold_motors_raw=bat_threshold_motors_raw,
            bat_comp_ref=bat_comp_ref,
            bat_comp_ref_raw=bat_comp_ref_raw,
            beeper_modes=beeper_modes,
            follow_roll_mix_start=follow_roll_mix_start,
            follow_roll_mix_start_raw=follow_roll_mix_start_raw,
            follow_roll_mix_range=follow_roll_mix_range,
            follow_roll_mix_range_raw=follow_roll_mix_range_raw,
            booster_power=booster_power,
            follow_speed=follow_speed,
            frame_angle_from_motors=frame_angle_from_motors,
            rc_memory=rc_memory,
            rc_memory_raw=rc_memory_raw,
            servo_out=servo_out,
            servo_rate=servo_rate,
            servo_rate_raw=servo_rate_raw,
            adaptive_pid_enabled=adaptive_pid_enabled,
            adaptive_pid_threshold=adaptive_pid_threshold,
            adaptive_pid_rate=adaptive_pid_rate,
            adaptive_pid_recovery_factor=adaptive_pid_recovery_factor,
            follow_lpf=follow_lpf,
            general_flags1=general_flags1,
            profile_flags1=profile_flags1,
            spektrum_mode=spektrum_mode,
            order_of_axes=order_of_axes,
            euler_order=euler_order,
            cur_imu=cur_imu,
            cur_profile_id=cur_profile_id,
            tail=tail,
        )


class ReadParams3Request(Request["ReadParams3"]):
    """Request the parameters of one profile.

    CMD_READ_PARAMS_3 (21), to the board; 1 byte. Effect: reads. Since board 3.0. Source:
    Outgoing commands L652-L660.
    """

    __slots__ = ()

    ACTIVE_PROFILE: ClassVar[int] = 255
    """For profile_id, as raw value: the active profile."""
    profile_id: Field[int, int] = Field(RAW)
    """Profile to read. Range: 0 to 4. Value 255: the active profile."""

    def __init__(self, *, profile_id: int = UNSET, tail: Bytes = UNSET) -> None:
        self._start(profile_id=profile_id, tail=tail)


class ReadParams(Request["ReadParamsAnswer"]):
    """Request the parameters of one profile, with the older id.

    CMD_READ_PARAMS (82), to the board; 1 byte. Effect: reads. Deprecated: use
    CMD_READ_PARAMS_3. Source: Outgoing commands L652-L660.
    """

    __slots__ = ()

    ACTIVE_PROFILE: ClassVar[int] = 255
    """For profile_id, as raw value: the active profile."""
    profile_id: Field[int, int] = Field(RAW)
    """Profile to read. Range: 0 to 4. Value 255: the active profile."""

    def __init__(self, *, profile_id: int = UNSET, tail: Bytes = UNSET) -> None:
        self._start(profile_id=profile_id, tail=tail)


class ReadParamsExt(Message):
    """More parameters of one profile: filters, encoders, magnetometer.

    CMD_READ_PARAMS_EXT (33), from the board; 104 bytes, and later firmware may append more.
    Since board 3.0. Rules: encoder_limit_min <= encoder_limit_max. Source: Incoming commands
    L312-L348; Variables L1080-L1108.
    """

    __slots__ = ()

    ACTIVE_PROFILE: ClassVar[int] = 255
    """For profile_id, as raw value: the active profile."""
    profile_id: Field[int, int] = Field(RAW)
    """Profile of the parameters. Range: 0 to 4. Value 255: the active profile."""
    notches: Field[Axes[AxisNotches], Axes[AxisNotches]] = Field(AxesOf(GroupOf(AxisNotches)))
    """Notch filters of each axis."""
    lpf_freq: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Low-pass cut-off of each axis, at its -3 dB point. Range: 0 to 1000 Hz."""
    lpf_freq_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="lpf_freq")
    """The number on the wire for lpf_freq."""
    filters_en: Field[Axes[FilterSwitches], Axes[FilterSwitches]] = Field(
        AxesOf(ValueOf(FilterSwitches)),
    )
    """Enabled filters."""
    encoder_offset: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Encoder angle in the zero position. Unit: deg."""
    encoder_offset_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="encoder_offset")
    """The number on the wire for encoder_offset."""
    encoder_fld_offset: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Angle between the encoder and the motor's magnetic field. Unit: deg."""
    encoder_fld_offset_raw: Field[Axes[int], Axes[int]] = Field(
        AxesOf(RAW),
        of="encoder_fld_offset",
    )
    """The number on the wire for encoder_fld_offset."""
    encoder_manual_set_time: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Time to set the encoder by hand. Unit: ms."""
    encoder_manual_set_time_raw: Field[Axes[int], Axes[int]] = Field(
        AxesOf(RAW),
        of="encoder_manual_set_time",
    )
    """The number on the wire for encoder_manual_set_time."""
    motor_heating_factor: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Heating factor of the motor temperature model."""
    motor_cooling_factor: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Cooling factor of the motor temperature model."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""
    follow_inside_deadband: Field[int, int] = Field(RAW)
    """How much to follow inside the follow mode's dead band."""
    motor_mag_link: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Magnetic linkage of the motor. Deprecated: use MOTOR_MAG_LINK_FINE of CMD_READ_PARAMS_EXT2.
    """
    motor_gearing: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Ratio of the gear after the motor."""
    motor_gearing_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="motor_gearing")
    """The number on the wire for motor_gearing."""
    encoder_limit_min: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Lowest angle of the joint. Range: -381 to 381 deg. Positive pitch is down, negative up;
    positive yaw is right, negative left; for roll it is not known. Deprecated since firmware
    2.61: use FRAME_CAM_ANGLE_MIN of CMD_READ_PARAMS_EXT2.
    """
    encoder_limit_min_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="encoder_limit_min")
    """The number on the wire for encoder_limit_min."""
    encoder_limit_max: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Highest angle of the joint. Range: -381 to 381 deg. Positive pitch is down, negative up;
    positive yaw is right, negative left; for roll it is not known. Deprecated since firmware
    2.61: use FRAME_CAM_ANGLE_MAX of CMD_READ_PARAMS_EXT2.
    """
    encoder_limit_max_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="encoder_limit_max")
    """The number on the wire for encoder_limit_max."""
    notch1_gain: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Depth of the first notch filter; a negative value makes a peak filter. Range: -100 to 100 dB.
    """
    notch1_gain_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="notch1_gain")
    """The number on the wire for notch1_gain."""
    notch2_gain: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Depth of the second notch filter; a negative value makes a peak filter. Range: -100 to 100
    dB.
    """
    notch2_gain_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="notch2_gain")
    """The number on the wire for notch2_gain."""
    notch3_gain: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Depth of the third notch filter; a negative value makes a peak filter. Range: -100 to 100 dB.
    """
    notch3_gain_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="notch3_gain")
    """The number on the wire for notch3_gain."""
    beeper_volume: Field[int, int] = Field(RAW)
    """Sound volume."""
    encoder_gear_ratio: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Ratio of the gear between motor and encoder."""
    encoder_gear_ratio_raw: Field[Axes[int], Axes[int]] = Field(
        AxesOf(RAW),
        of="encoder_gear_ratio",
    )
    """The number on the wire for encoder_gear_ratio."""
    encoder_type: Field[Axes[EncoderType], Axes[EncoderType]] = Field(AxesOf(ValueOf(EncoderType)))
    """Kind and options of the encoder."""
    encoder_cfg: Field[Axes[EncoderConfig], Axes[EncoderConfig]] = Field(
        AxesOf(ValueOf(EncoderConfig)),
    )
    """SPI clock, or the kind of encoder in an I2C driver."""
    outer_p: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Proportional gain of the outer loop."""
    outer_i: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Integral gain of the outer loop."""
    mag_axis_top: Field[SensorAxis, SensorAxis] = Field(ValueOf(SensorAxis))
    """Axis of the magnetometer that points up."""
    mag_axis_right: Field[SensorAxis, SensorAxis] = Field(ValueOf(SensorAxis))
    """Axis of the magnetometer that points right."""
    mag_trust: Field[int, int] = Field(RAW)
    """Trust in the magnetometer."""
    mag_declination: Field[float, float] = Field(REAL)
    """Magnetic declination. Range: -127 to 127 deg. Positive pitch is down, negative up; positive
    yaw is right, negative left; for roll it is not known.
    """
    mag_declination_raw: Field[int, int] = Field(RAW, of="mag_declination")
    """The number on the wire for mag_declination."""
    acc_lpf_freq: Field[float, float] = Field(REAL)
    """Low-pass filter of the accelerometer. Range: 0 to 10 Hz."""
    acc_lpf_freq_raw: Field[int, int] = Field(RAW, of="acc_lpf_freq")
    """The number on the wire for acc_lpf_freq."""
    d_term_lpf_freq: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Low-pass filter of the derivative term. Range: 0 to 600 Hz."""
    d_term_lpf_freq_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="d_term_lpf_freq")
    """The number on the wire for d_term_lpf_freq."""

    def __init__(
        self,
        *,
        profile_id: int = UNSET,
        notches: Axes[AxisNotches] = UNSET,
        lpf_freq: Axes[float] = UNSET,
        lpf_freq_raw: Axes[int] = UNSET,
        filters_en: Axes[FilterSwitches] = UNSET,
        encoder_offset: Axes[float] = UNSET,
        encoder_offset_raw: Axes[int] = UNSET,
        encoder_fld_offset: Axes[float] = UNSET,
        encoder_fld_offset_raw: Axes[int] = UNSET,
        encoder_manual_set_time: Axes[float] = UNSET,
        encoder_manual_set_time_raw: Axes[int] = UNSET,
        motor_heating_factor: Axes[int] = UNSET,
        motor_cooling_factor: Axes[int] = UNSET,
        reserved: Bytes = UNSET,
        follow_inside_deadband: int = UNSET,
        motor_mag_link: Axes[int] = UNSET,
        motor_gearing: Axes[float] = UNSET,
        motor_gearing_raw: Axes[int] = UNSET,
        encoder_limit_min: Axes[float] = UNSET,
        encoder_limit_min_raw: Axes[int] = UNSET,
        encoder_limit_max: Axes[float] = UNSET,
        encoder_limit_max_raw: Axes[int] = UNSET,
        notch1_gain: Axes[float] = UNSET,
        notch1_gain_raw: Axes[int] = UNSET,
        notch2_gain: Axes[float] = UNSET,
        notch2_gain_raw: Axes[int] = UNSET,
        notch3_gain: Axes[float] = UNSET,
        notch3_gain_raw: Axes[int] = UNSET,
        beeper_volume: int = UNSET,
        encoder_gear_ratio: Axes[float] = UNSET,
        encoder_gear_ratio_raw: Axes[int] = UNSET,
        encoder_type: Axes[EncoderType] = UNSET,
        encoder_cfg: Axes[EncoderConfig] = UNSET,
        outer_p: Axes[int] = UNSET,
        outer_i: Axes[int] = UNSET,
        mag_axis_top: SensorAxis = UNSET,
        mag_axis_right: SensorAxis = UNSET,
        mag_trust: int = UNSET,
        mag_declination: float = UNSET,
        mag_declination_raw: int = UNSET,
        acc_lpf_freq: float = UNSET,
        acc_lpf_freq_raw: int = UNSET,
        d_term_lpf_freq: Axes[float] = UNSET,
        d_term_lpf_freq_raw: Axes[int] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            profile_id=profile_id,
            notches=notches,
            lpf_freq=lpf_freq,
            lpf_freq_raw=lpf_freq_raw,
            filters_en=filters_en,
            encoder_offset=encoder_offset,
            encoder_offset_raw=encoder_offset_raw,
            encoder_fld_offset=encoder_fld_offset,
            encoder_fld_offset_raw=encoder_fld_offset_raw,
            encoder_manual_set_time=encoder_manual_set_time,
            encoder_manual_set_time_raw=encoder_manual_set_time_raw,
            motor_heating_factor=motor_heating_factor,
            motor_cooling_factor=motor_cooling_factor,
            reserved=reserved,
            follow_inside_deadband=follow_inside_deadband,
            motor_mag_link=motor_mag_link,
            motor_gearing=motor_gearing,
            motor_gearing_raw=motor_gearing_raw,
            encoder_limit_min=encoder_limit_min,
            encoder_limit_min_raw=encoder_limit_min_raw,
            encoder_limit_max=encoder_limit_max,
            encoder_limit_max_raw=encoder_limit_max_raw,
            notch1_gain=notch1_gain,
            notch1_gain_raw=notch1_gain_raw,
            notch2_gain=notch2_gain,
            notch2_gain_raw=notch2_gain_raw,
            notch3_gain=notch3_gain,
            notch3_gain_raw=notch3_gain_raw,
            beeper_volume=beeper_volume,
            encoder_gear_ratio=encoder_gear_ratio,
            encoder_gear_ratio_raw=encoder_gear_ratio_raw,
            encoder_type=encoder_type,
            encoder_cfg=encoder_cfg,
            outer_p=outer_p,
            outer_i=outer_i,
            mag_axis_top=mag_axis_top,
            mag_axis_right=mag_axis_right,
            mag_trust=mag_trust,
            mag_declination=mag_declination,
            mag_declination_raw=mag_declination_raw,
            acc_lpf_freq=acc_lpf_freq,
            acc_lpf_freq_raw=acc_lpf_freq_raw,
            d_term_lpf_freq=d_term_lpf_freq,
            d_term_lpf_freq_raw=d_term_lpf_freq_raw,
            tail=tail,
        )


class ReadParamsExtRequest(Request["ReadParamsExt"]):
    """Request more parameters of one profile.

    CMD_READ_PARAMS_EXT (33), to the board; 1 byte. Effect: reads. Since board 3.0. Source:
    Outgoing commands L652-L660.
    """

    __slots__ = ()

    ACTIVE_PROFILE: ClassVar[int] = 255
    """For profile_id, as raw value: the active profile."""
    profile_id: Field[int, int] = Field(RAW)
    """Profile to read. Range: 0 to 4. Value 255: the active profile."""

    def __init__(self, *, profile_id: int = UNSET, tail: Bytes = UNSET) -> None:
        self._start(profile_id=profile_id, tail=tail)


class ReadParamsExt2(Message):
    """The third set of parameters of one profile.

    CMD_READ_PARAMS_EXT2 (62), from the board; 151 bytes, and later firmware may append more.
    Since board 3.0. Rules: frame_cam_angle_min <= frame_cam_angle_max. Source: Incoming
    commands L350-L359; Variables L1110-L1116.
    """

    __slots__ = ()

    ACTIVE_PROFILE: ClassVar[int] = 255
    """For profile_id, as raw value: the active profile."""
    ACC_LIMITER3_DISABLED: ClassVar[int] = 0
    """For acc_limiter3, as raw value: disabled."""
    profile_id: Field[int, int] = Field(RAW)
    """Profile of the parameters. Range: 0 to 4. Value 255: the active profile."""
    mav_channels: Field[Elements[MavChannel], Iterable[MavChannel]] = Field(
        ListOf(GroupOf(MavChannel)),
    )
    """MAVLink channels. Since firmware 2.60."""
    motor_mag_link_fine: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Magnetic linkage of the motor."""
    motor_mag_link_fine_raw: Field[Axes[int], Axes[int]] = Field(
        AxesOf(RAW),
        of="motor_mag_link_fine",
    )
    """The number on the wire for motor_mag_link_fine."""
    acc_limiter3: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Acceleration limit of each axis. Range: 0 to 1000 deg/s^2. Raw value 0: disabled. Since
    firmware 2.59.
    """
    acc_limiter3_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="acc_limiter3")
    """The number on the wire for acc_limiter3."""
    pid_gain: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Factor for P, I and D of each axis."""
    pid_gain_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="pid_gain")
    """The number on the wire for pid_gain."""
    frame_imu_lpf_freq: Field[float, float] = Field(REAL)
    """Low-pass filter of the frame IMU. Unit: Hz."""
    frame_imu_lpf_freq_raw: Field[int, int] = Field(RAW, of="frame_imu_lpf_freq")
    """The number on the wire for frame_imu_lpf_freq."""
    auto_pid_cfg: Field[AutoPidFlags, AutoPidFlags] = Field(ValueOf(AutoPidFlags))
    """CFG_FLAGS for CMD_AUTO_PID."""
    auto_pid_gain: Field[int, int] = Field(RAW)
    """GAIN_VS_STABILITY for CMD_AUTO_PID."""
    frame_cam_angle_min: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Lowest angle of the joint. Unit: deg. Positive pitch is down, negative up; positive yaw is
    right, negative left; for roll it is not known. Since firmware 2.61.
    """
    frame_cam_angle_min_raw: Field[Axes[int], Axes[int]] = Field(
        AxesOf(RAW),
        of="frame_cam_angle_min",
    )
    """The number on the wire for frame_cam_angle_min."""
    frame_cam_angle_max: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Highest angle of the joint. Unit: deg. Positive pitch is down, negative up; positive yaw is
    right, negative left; for roll it is not known. Since firmware 2.61.
    """
    frame_cam_angle_max_raw: Field[Axes[int], Axes[int]] = Field(
        AxesOf(RAW),
        of="frame_cam_angle_max",
    )
    """The number on the wire for frame_cam_angle_max."""
    general_flags2: Field[GeneralFlags2, GeneralFlags2] = Field(ValueOf(GeneralFlags2))
    """More options of the whole board. The same in all copies. Since firmware 2.61."""
    auto_speed: Field[int, int] = Field(RAW)
    """Speed of automatic motions. Range: 1 to 255. Value 0: not set. Since firmware 2.61."""
    auto_acc_limiter: Field[float, float] = Field(REAL)
    """Acceleration limit of automatic motions. Unit: deg/s^2. Since firmware 2.61."""
    auto_acc_limiter_raw: Field[int, int] = Field(RAW, of="auto_acc_limiter")
    """The number on the wire for auto_acc_limiter."""
    imu_orientation_corr: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Correction of the orientation of the main IMU. Unit: deg. Since firmware 2.61."""
    imu_orientation_corr_raw: Field[Axes[int], Axes[int]] = Field(
        AxesOf(RAW),
        of="imu_orientation_corr",
    )
    """The number on the wire for imu_orientation_corr."""
    timelapse_time: Field[float, float] = Field(REAL)
    """Duration of a time lapse. Unit: ms. Since firmware 2.60."""
    timelapse_time_raw: Field[int, int] = Field(RAW, of="timelapse_time")
    """The number on the wire for timelapse_time."""
    emergency_stop_restart_delay: Field[float, float] = Field(REAL)
    """Delay between an emergency stop and the restart. Unit: ms. Since firmware 2.61."""
    emergency_stop_restart_delay_raw: Field[int, int] = Field(
        RAW,
        of="emergency_stop_restart_delay",
    )
    """The number on the wire for emergency_stop_restart_delay."""
    timelapse_acc_part: Field[float, float] = Field(REAL)
    """Share of a time lapse in which the speed changes. Range: 0 to 50 %. Since firmware 2.61."""
    timelapse_acc_part_raw: Field[int, int] = Field(RAW, of="timelapse_acc_part")
    """The number on the wire for timelapse_acc_part."""
    momentum: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Moment of inertia of the axis. Since firmware 2.62b7."""
    momentum_calib_stimulus: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Stimulus for the calibration of the momentum. Range: 1 to 255. Value 0: not set. Since
    firmware 2.62b7.
    """
    momentum_ellipticity: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """How much the momentum depends on the angle. Since firmware 2.62b7."""
    momentum_ellipticity_raw: Field[Axes[int], Axes[int]] = Field(
        AxesOf(RAW),
        of="momentum_ellipticity",
    )
    """The number on the wire for momentum_ellipticity."""
    follow_range: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Range of the follow mode. Range: 1 to 180. Value 0: not set. Since firmware 2.62b7."""
    stab_axis: Field[Axes[StabAxis], Axes[StabAxis]] = Field(AxesOf(ValueOf(StabAxis)))
    """Axis that the motor stabilizes. Since firmware 2.62b7."""
    outer_mot_tilt_angle: Field[float, float] = Field(REAL)
    """Tilt of the outer motor. Range: -90 to 90 deg. Positive pitch is down, negative up; positive
    yaw is right, negative left; for roll it is not known. The same in all copies. Since
    firmware 2.62b7.
    """
    outer_mot_tilt_angle_raw: Field[int, int] = Field(RAW, of="outer_mot_tilt_angle")
    """The number on the wire for outer_mot_tilt_angle."""
    startup_action: Field[Elements[StartupAction], Iterable[int]] = Field(
        ListOf(ValueOf(StartupAction)),
    )
    """Actions at start-up. Since firmware 2.66."""
    startup_action_src: Field[Elements[RcMap], Iterable[int]] = Field(ListOf(ValueOf(RcMap)))
    """RC signals that are conditions of the actions: a first one for each, then a second one. Since
    firmware 2.66.
    """
    startup_action_threshold: Field[Elements[int], Iterable[int]] = Field(ListOf(RAW))
    """Thresholds of these signals, in steps of 10. Since firmware 2.66."""
    force_position_cfg: Field[Axes[ForcePositionConfig], Axes[ForcePositionConfig]] = Field(
        AxesOf(ValueOf(ForcePositionConfig)),
    )
    """When and how the axis snaps to a fixed position. Since firmware 2.66."""
    step_signals: Field[Elements[StepSignal], Iterable[StepSignal]] = Field(
        ListOf(GroupOf(StepSignal)),
    )
    """Step signals: each counts how often an RC signal reaches a level. Since firmware 2.66."""
    rc_calibrations: Field[Elements[RcCalibration], Iterable[RcCalibration]] = Field(
        ListOf(GroupOf(RcCalibration)),
    )
    """Calibrations of RC signals: an offset is added, then a factor is applied. Since firmware
    2.66.
    """
    parking_pos_cfg: Field[ParkingBorders, ParkingBorders] = Field(ValueOf(ParkingBorders))
    """Limits at which the axes park. Since firmware 2.66."""
    ext_led_pin_id: Field[OutputPin, OutputPin] = Field(ValueOf(OutputPin))
    """Pin that repeats the signals of the LED. The same in all copies. Since firmware 2.66."""
    interrupt_cfg: Field[InterruptConfig, int] = Field(ValueOf(InterruptConfig))
    """Pin that signals an event to other devices. The same in all copies. Since firmware 2.66."""
    overload_time: Field[float, float] = Field(REAL)
    """How long the motors may be overloaded. Unit: ms. Since firmware 2.66."""
    overload_time_raw: Field[int, int] = Field(RAW, of="overload_time")
    """The number on the wire for overload_time."""
    auto_pid_momentum: Field[int, int] = Field(RAW)
    """MOMENTUM for CMD_AUTO_PID. Value 0: automatic. Since firmware 2.66."""
    jerk_slope: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """How slowly the acceleration changes. Since firmware 2.66."""
    mav_ctrl_mode: Field[MavControlMode, MavControlMode] = Field(ValueOf(MavControlMode))
    """Axes that a MAVLink host controls. Since firmware 2.66."""
    rc_serial_speed: Field[SerialSpeed, SerialSpeed] = Field(ValueOf(SerialSpeed))
    """Baud rate of the serial RC input. The same in all copies. Since firmware 2.66."""
    uart2_speed: Field[SerialSpeed, SerialSpeed] = Field(ValueOf(SerialSpeed))
    """Baud rate of UART 2. The same in all copies. Since firmware 2.66."""
    motor_res: Field[Axes[float], Axes[float]] = Field(AxesOf(REAL))
    """Resistance of one phase of the motor. Unit: ohm. Since firmware 2.66."""
    motor_res_raw: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW), of="motor_res")
    """The number on the wire for motor_res."""
    current_limit: Field[float, float] = Field(REAL)
    """Limit of the total current. Unit: mA. Since firmware 2.66."""
    current_limit_raw: Field[int, int] = Field(RAW, of="current_limit")
    """The number on the wire for current_limit."""
    middle_mot_tilt_angle: Field[float, float] = Field(REAL)
    """Tilt of the middle motor. Range: -90 to 90 deg. Positive pitch is down, negative up; positive
    yaw is right, negative left; for roll it is not known. The same in all copies. Since
    firmware 2.67.
    """
    middle_mot_tilt_angle_raw: Field[int, int] = Field(RAW, of="middle_mot_tilt_angle")
    """The number on the wire for middle_mot_tilt_angle."""

    def __init__(
        self,
        *,
        profile_id: int = UNSET,
        mav_channels: Iterable[MavChannel] = UNSET,
        motor_mag_link_fine: Axes[float] = UNSET,
        motor_mag_link_fine_raw: Axes[int] = UNSET,
        acc_limiter3: Axes[float] = UNSET,
        acc_limiter3_raw: Axes[int] = UNSET,
        pid_gain: Axes[float] = UNSET,
        pid_gain_raw: Axes[int] = UNSET,
        frame_imu_lpf_freq: float = UNSET,
        frame_imu_lpf_freq_raw: int = UNSET,
        auto_pid_cfg: AutoPidFlags = UNSET,
        auto_pid_gain: int = UNSET,
        frame_cam_angle_min: Axes[float] = UNSET,
        frame_cam_angle_min_raw: Axes[int] = UNSET,
        frame_cam_angle_max: Axes[float] = UNSET,
        frame_cam_angle_max_raw: Axes[int] = UNSET,
        general_flags2: GeneralFlags2 = UNSET,
        auto_speed: int = UNSET,
        auto_acc_limiter: float = UNSET,
        auto_acc_limiter_raw: int = UNSET,
        imu_orientation_corr: Axes[float] = UNSET,
        imu_orientation_corr_raw: Axes[int] = UNSET,
        timelapse_time: float = UNSET,
        timelapse_time_raw: int = UNSET,
        emergency_stop_restart_delay: float = UNSET,
        emergency_stop_restart_delay_raw: int = UNSET,
        timelapse_acc_part: float = UNSET,
        timelapse_acc_part_raw: int = UNSET,
        momentum: Axes[int] = UNSET,
        momentum_calib_stimulus: Axes[int] = UNSET,
        momentum_ellipticity: Axes[float] = UNSET,
        momentum_ellipticity_raw: Axes[int] = UNSET,
        follow_range: Axes[int] = UNSET,
        stab_axis: Axes[StabAxis] = UNSET,
        outer_mot_tilt_angle: float = UNSET,
        outer_mot_tilt_angle_raw: int = UNSET,
        startup_action: Iterable[int] = UNSET,
        startup_action_src: Iterable[int] = UNSET,
        startup_action_threshold: Iterable[int] = UNSET,
        force_position_cfg: Axes[ForcePositionConfig] = UNSET,
        step_signals: Iterable[StepSignal] = UNSET,
        rc_calibrations: Iterable[RcCalibration] = UNSET,
        parking_pos_cfg: ParkingBorders = UNSET,
        ext_led_pin_id: OutputPin = UNSET,
        interrupt_cfg: int = UNSET,
        overload_time: float = UNSET,
        overload_time_raw: int = UNSET,
        auto_pid_momentum: int = UNSET,
        jerk_slope: Axes[int] = UNSET,
        mav_ctrl_mode: MavControlMode = UNSET,
        rc_serial_speed: SerialSpeed = UNSET,
        uart2_speed: SerialSpeed = UNSET,
        motor_res: Axes[float] = UNSET,
        motor_res_raw: Axes[int] = UNSET,
        current_limit: float = UNSET,
        current_limit_raw: int = UNSET,
        middle_mot_tilt_angle: float = UNSET,
        middle_mot_tilt_angle_raw: int = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            profile_id=profile_id,
            mav_channels=mav_channels,
            motor_mag_link_fine=motor_mag_link_fine,
            motor_mag_link_fine_raw=motor_mag_link_fine_raw,
            acc_limiter3=acc_limiter3,
            acc_limiter3_raw=acc_limiter3_raw,
            pid_gain=pid_gain,
            pid_gain_raw=pid_gain_raw,
            frame_imu_lpf_freq=frame_imu_lpf_freq,
            frame_imu_lpf_freq_raw=frame_imu_lpf_freq_raw,
            auto_pid_cfg=auto_pid_cfg,
            auto_pid_gain=auto_pid_gain,
            frame_cam_angle_min=frame_cam_angle_min,
            frame_cam_angle_min_raw=frame_cam_angle_min_raw,
            frame_cam_angle_max=frame_cam_angle_max,
            frame_cam_angle_max_raw=frame_cam_angle_max_raw,
            general_flags2=general_flags2,
            auto_speed=auto_speed,
            auto_acc_limiter=auto_acc_limiter,
            auto_acc_limiter_raw=auto_acc_limiter_raw,
            imu_orientation_corr=imu_orientation_corr,
            imu_orientation_corr_raw=imu_orientation_corr_raw,
            timelapse_time=timelapse_time,
            timelapse_time_raw=timelapse_time_raw,
            emergency_stop_restart_delay=emergency_stop_restart_delay,
            emergency_stop_restart_delay_raw=emergency_stop_restart_delay_raw,
            timelapse_acc_part=timelapse_acc_part,
            timelapse_acc_part_raw=timelapse_acc_part_raw,
            momentum=momentum,
            momentum_calib_stimulus=momentum_calib_stimulus,
            momentum_ellipticity=momentum_ellipticity,
            momentum_ellipticity_raw=momentum_ellipticity_raw,
            follow_range=follow_range,
            stab_axis=stab_axis,
            outer_mot_tilt_angle=outer_mot_tilt_angle,
            outer_mot_tilt_angle_raw=outer_mot_tilt_angle_raw,
            startup_action=startup_action,
            startup_action_src=startup_action_src,
            startup_action_threshold=startup_action_threshold,
            force_position_cfg=force_position_cfg,
            step_signals=step_signals,
            rc_calibrations=rc_calibrations,
            parking_pos_cfg=parking_pos_cfg,
            ext_led_pin_id=ext_led_pin_id,
            interrupt_cfg=interrupt_cfg,
            overload_time=overload_time,
            overload_time_raw=overload_time_raw,
            auto_pid_momentum=auto_pid_momentum,
            jerk_slope=jerk_slope,
            mav_ctrl_mode=mav_ctrl_mode,
            rc_serial_speed=rc_serial_speed,
            uart2_speed=uart2_speed,
            motor_res=motor_res,
            motor_res_raw=motor_res_raw,
            current_limit=current_limit,
            current_limit_raw=current_limit_raw,
            middle_mot_tilt_angle=middle_mot_tilt_angle,
            middle_mot_tilt_angle_raw=middle_mot_tilt_angle_raw,
            tail=tail,
        )


class ReadParamsExt2Request(Request["ReadParamsExt2"]):
    """Request the third set of parameters of one profile.

    CMD_READ_PARAMS_EXT2 (62), to the board; 1 byte. Effect: reads. Since board 3.0. Source:
    Outgoing commands L658-L660.
    """

    __slots__ = ()

    ACTIVE_PROFILE: ClassVar[int] = 255
    """For profile_id, as raw value: the active profile."""
    profile_id: Field[int, int] = Field(RAW)
    """Profile to read. Range: 0 to 4. Value 255: the active profile."""

    def __init__(self, *, profile_id: int = UNSET, tail: Bytes = UNSET) -> None:
        self._start(profile_id=profile_id, tail=tail)


class WriteParamsSet(Request["Confirm"]):
    """Begin or end a series of commands that store parameters.

    Between the two, the board is in a state for configuration. At the end it may restart to
    apply the parameters.

    CMD_WRITE_PARAMS_SET (119), to the board; 1 byte. Effect: sets, moves, restarts. Since
    firmware 2.70b4. Source: Later firmware.
    """

    __slots__ = ()

    action: Field[WriteParamsAction, WriteParamsAction] = Field(ValueOf(WriteParamsAction))
    """Whether the series begins or ends."""

    def __init__(self, *, action: WriteParamsAction = UNSET, tail: Bytes = UNSET) -> None:
        self._start(action=action, tail=tail)


class ReadProfileNames(Message):
    """Profile names.

    CMD_READ_PROFILE_NAMES (28), from the board; 240 bytes, and later firmware may append more.
    Since board 3.0. Source: Incoming commands L445-L453.
    """

    __slots__ = ()

    profile_name: Field[Elements[str], Iterable[str]] = Field(ListOf(TEXT))
    """Name of each profile."""

    def __init__(self, *, profile_name: Iterable[str] = UNSET, tail: Bytes = UNSET) -> None:
        self._start(profile_name=profile_name, tail=tail)


class ReadProfileNamesRequest(Request["ReadProfileNames"]):
    """Request the profile names.

    CMD_READ_PROFILE_NAMES (28), to the board; 0 bytes. Effect: reads. Since board 3.0. Source:
    Outgoing commands L761.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class ProfileSet(Request["Confirm"]):
    """Save, clear or load a profile set.

    CMD_PROFILE_SET (95), to the board; 10 bytes. Effect: stores, moves, erases. Since firmware
    2.65. Source: Later firmware.
    """

    __slots__ = ()

    BACKUP_SLOT: ClassVar[int] = 6
    """For slot, as raw value: the backup."""
    slot: Field[int, int] = Field(RAW)
    """Place of the profile set. Range: 1 to 5. Value 6: the backup."""
    action: Field[ProfileSetAction, ProfileSetAction] = Field(ValueOf(ProfileSetAction))
    """Operation."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        slot: int = UNSET,
        action: ProfileSetAction = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(slot=slot, action=action, reserved=reserved, tail=tail)


class SaveParams3(Request["Optional[Confirm]"]):
    """Save the parameters in use, with all changes to adjustable variables, to the active profile.

    CMD_SAVE_PARAMS_3 (32), to the board; 0 to 255 bytes. Effect: stores. Since board 3.0.
    Source: Outgoing commands L804.
    """

    __slots__ = ()

    param_id: Field[Elements[VariableId], Iterable[VariableId]] = Field(ListOf(ValueOf(VariableId)))
    """Variables to save; none stands for all. Since firmware 2.68b9."""

    def __init__(self, *, param_id: Iterable[VariableId] = UNSET, tail: Bytes = UNSET) -> None:
        self._start(param_id=param_id, tail=tail)


class UseDefaults(Request["Optional[Confirm]"]):
    """Restore the factory defaults.

    The parameters of the profile are lost; 253 erases the whole EEPROM. Back up the parameters
    first.

    CMD_USE_DEFAULTS (70), to the board; 1 byte. Effect: stores, moves, erases. Source: Outgoing
    commands L644-L648.
    """

    __slots__ = ()

    ERASE_EEPROM: ClassVar[int] = 253
    """For profile_id, as raw value: erases the EEPROM."""
    RESET_ACTIVE: ClassVar[int] = 254
    """For profile_id, as raw value: resets the active profile."""
    profile_id: Field[int, int] = Field(RAW)
    """Profile to reset. Range: 0 to 4. Value 253: erases the EEPROM. Value 254: resets the active
    profile.
    """

    def __init__(self, *, profile_id: int = UNSET, tail: Bytes = UNSET) -> None:
        self._start(profile_id=profile_id, tail=tail)


class WriteParams3(ReadParams3, Request["Confirm"]):
    """Store the parameters of one profile and the general parameters.

    Also saves to the EEPROM. Write back what you read and change only what you need: unknown
    bytes are parameters too.

    CMD_WRITE_PARAMS_3 (22), to the board; 134 bytes, and later firmware may append more.
    Effect: stores, moves. Since board 3.0. Rules: rc.rc_min_angle <= rc.rc_max_angle. Source:
    Outgoing commands L662-L668; Variables L1010-L1079.
    """

    __slots__ = ()


class ReadParamsAnswer(ReadParams3):
    """Parameters of one profile and general parameters, with the older id.

    CMD_READ_PARAMS (82), from the board; 134 bytes, and later firmware may append more.
    Deprecated: use CMD_READ_PARAMS_3. Rules: rc.rc_min_angle <= rc.rc_max_angle. Source:
    Outgoing commands L652-L660.
    """

    __slots__ = ()


class WriteParams(ReadParams3, Request["Confirm"]):
    """Store the parameters of one profile and the general parameters, with the older id.

    CMD_WRITE_PARAMS (87), to the board; 134 bytes, and later firmware may append more. Effect:
    stores, moves. Deprecated: use CMD_WRITE_PARAMS_3. Rules: rc.rc_min_angle <=
    rc.rc_max_angle. Source: Outgoing commands L662-L668.
    """

    __slots__ = ()


class WriteParamsExt(ReadParamsExt, Request["Confirm"]):
    """Store more parameters of one profile.

    CMD_WRITE_PARAMS_EXT (34), to the board; 104 bytes, and later firmware may append more.
    Effect: stores, moves. Since board 3.0. Rules: encoder_limit_min <= encoder_limit_max.
    Source: Outgoing commands L662-L668; Variables L1080-L1108.
    """

    __slots__ = ()


class WriteParamsExt2(ReadParamsExt2, Request["Confirm"]):
    """Store the third set of parameters of one profile.

    CMD_WRITE_PARAMS_EXT2 (63), to the board; 151 bytes, and later firmware may append more.
    Effect: stores, moves. Since board 3.0. Rules: frame_cam_angle_min <= frame_cam_angle_max.
    Source: Outgoing commands L668; Variables L1110-L1116.
    """

    __slots__ = ()


class WriteProfileNames(ReadProfileNames, Request["Optional[Confirm]"]):
    """Store the profile names.

    CMD_WRITE_PROFILE_NAMES (29), to the board; 240 bytes, and later firmware may append more.
    Effect: stores. Since board 3.0. Source: Outgoing commands L763-L772.
    """

    __slots__ = ()
