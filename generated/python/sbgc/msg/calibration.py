# Generated from spec/ by generator/: edit those, then run ./dev generate.
"""Calibration of sensors, motors and encoders, and tuning of the controller."""

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
    "AutoPid",
    "AutoPid2",
    "AutoPid2Config",
    "AutoPidRequest",
    "AxisTuning",
    "AxisTuningConfig",
    "BodeSample",
    "BodeTestData",
    "BodeTestStartStop",
    "BodeTestStartStopRequest",
    "CalibAcc",
    "CalibAccExt",
    "CalibAccExtRef",
    "CalibBat",
    "CalibCogging",
    "CalibCurSens",
    "CalibCurSensRequest",
    "CalibEncoderLut",
    "CalibEncoderLutRequest",
    "CalibEncoderLutRes",
    "CalibEncoderLutResRequest",
    "CalibExtGain",
    "CalibGyro",
    "CalibGyroExt",
    "CalibInfo",
    "CalibInfoRequest",
    "CalibMag",
    "CalibMagExt",
    "CalibMotorMagLink",
    "CalibMotorMagLinkRequest",
    "CalibOffset",
    "CalibOrientCorr",
    "CalibPoles",
    "CanDrvCalibrate",
    "CanDrvCalibrateRequest",
    "CanDrvHardParams",
    "CanDrvHardParamsRequest",
    "CoggingCalibInfo",
    "CoggingCalibInfoRequest",
    "CoggingMotor",
    "EncIntCalib",
    "EncIntCalibRequest",
    "EncodersCalibFldOffset4",
    "EncodersCalibOffset4",
    "VibrationTestData",
    "VibrationTestDataRequest",
    "VibrationTestStartStop",
    "VibrationTestStartStopRequest",
]

Bytes = Union[bytes, bytearray, memoryview]


class AxisTuning(Structure):
    """Current result of each axis."""

    __slots__ = ()
    _home = ("AutoPid", "axes.roll")

    tracking_error: Field[float, float] = Field(REAL)
    """Tracking error of the axis."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(self, *, tracking_error: float = UNSET, reserved: Bytes = UNSET) -> None:
        self._start(tracking_error=tracking_error, reserved=reserved)


class AxisTuningConfig(Structure):
    """How to tune each axis."""

    __slots__ = ()
    _home = ("AutoPid2", "config.axes.roll")

    axis_flags: Field[AxisTuningOptions, int] = Field(ValueOf(AxisTuningOptions))
    """What to tune."""
    gain: Field[int, int] = Field(RAW)
    """Gain to aim for."""
    stimulus_gain: Field[int, int] = Field(RAW)
    """Strength of the test signal."""
    effective_freq: Field[float, float] = Field(REAL)
    """Effective frequency. Unit: Hz."""
    effective_freq_raw: Field[int, int] = Field(RAW, of="effective_freq")
    """The number on the wire for effective_freq."""
    problem_freq: Field[float, float] = Field(REAL)
    """Frequency of a known problem. Unit: Hz."""
    problem_freq_raw: Field[int, int] = Field(RAW, of="problem_freq")
    """The number on the wire for problem_freq."""
    problem_margin: Field[float, float] = Field(REAL)
    """Margin at that frequency. Unit: dB."""
    problem_margin_raw: Field[int, int] = Field(RAW, of="problem_margin")
    """The number on the wire for problem_margin."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        axis_flags: int = UNSET,
        gain: int = UNSET,
        stimulus_gain: int = UNSET,
        effective_freq: float = UNSET,
        effective_freq_raw: int = UNSET,
        problem_freq: float = UNSET,
        problem_freq_raw: int = UNSET,
        problem_margin: float = UNSET,
        problem_margin_raw: int = UNSET,
        reserved: Bytes = UNSET,
    ) -> None:
        self._start(
            axis_flags=axis_flags,
            gain=gain,
            stimulus_gain=stimulus_gain,
            effective_freq=effective_freq,
            effective_freq_raw=effective_freq_raw,
            problem_freq=problem_freq,
            problem_freq_raw=problem_freq_raw,
            problem_margin=problem_margin,
            problem_margin_raw=problem_margin_raw,
            reserved=reserved,
        )


class AutoPid2Config(Structure):
    """How to tune."""

    __slots__ = ()
    _home = ("AutoPid2", "config")

    cfg_version: Field[int, int] = Field(RAW)
    """Version of the configuration. Always 1."""
    axes: Field[Axes[AxisTuningConfig], Axes[AxisTuningConfig]] = Field(
        AxesOf(GroupOf(AxisTuningConfig)),
    )
    """How to tune each axis."""
    general_flags: Field[AutoPid2Flags, AutoPid2Flags] = Field(ValueOf(AutoPid2Flags))
    """Options."""
    reserved_1: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""
    test_freq_from: Field[float, float] = Field(REAL)
    """Lowest frequency of the test signal. Unit: Hz."""
    test_freq_from_raw: Field[int, int] = Field(RAW, of="test_freq_from")
    """The number on the wire for test_freq_from."""
    test_freq_to: Field[float, float] = Field(REAL)
    """Highest frequency of the test signal. Unit: Hz."""
    test_freq_to_raw: Field[int, int] = Field(RAW, of="test_freq_to")
    """The number on the wire for test_freq_to."""
    multi_pos_flag: Field[TuningPositions, TuningPositions] = Field(ValueOf(TuningPositions))
    """Positions in which to tune."""
    multi_pos_angle: Field[Elements[float], Iterable[float]] = Field(ListOf(REAL))
    """Angle of each position. Unit: deg. Positive pitch is down, negative up; positive yaw is
    right, negative left; for roll it is not known.
    """
    multi_pos_angle_raw: Field[Elements[int], Iterable[int]] = Field(
        ListOf(RAW),
        of="multi_pos_angle",
    )
    """The number on the wire for multi_pos_angle."""
    reserved_2: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        cfg_version: int = UNSET,
        axes: Axes[AxisTuningConfig] = UNSET,
        general_flags: AutoPid2Flags = UNSET,
        reserved_1: Bytes = UNSET,
        test_freq_from: float = UNSET,
        test_freq_from_raw: int = UNSET,
        test_freq_to: float = UNSET,
        test_freq_to_raw: int = UNSET,
        multi_pos_flag: TuningPositions = UNSET,
        multi_pos_angle: Iterable[float] = UNSET,
        multi_pos_angle_raw: Iterable[int] = UNSET,
        reserved_2: Bytes = UNSET,
    ) -> None:
        self._start(
            cfg_version=cfg_version,
            axes=axes,
            general_flags=general_flags,
            reserved_1=reserved_1,
            test_freq_from=test_freq_from,
            test_freq_from_raw=test_freq_from_raw,
            test_freq_to=test_freq_to,
            test_freq_to_raw=test_freq_to_raw,
            multi_pos_flag=multi_pos_flag,
            multi_pos_angle=multi_pos_angle,
            multi_pos_angle_raw=multi_pos_angle_raw,
            reserved_2=reserved_2,
        )


class CoggingMotor(Structure):
    """How to calibrate each motor."""

    __slots__ = ()
    _home = ("CalibCogging", "motors.roll")

    AUTOMATIC_PERIOD: ClassVar[int] = 0
    """For period, as raw value: automatic."""
    angle: Field[float, float] = Field(REAL)
    """Angle by which the motor turns. Range: 20 to 360 deg."""
    angle_raw: Field[int, int] = Field(RAW, of="angle")
    """The number on the wire for angle."""
    smooth: Field[float, float] = Field(REAL)
    """Smoothing of the result. Range: 0 to 100 %."""
    smooth_raw: Field[int, int] = Field(RAW, of="smooth")
    """The number on the wire for smooth."""
    speed: Field[int, int] = Field(RAW)
    """Speed of the motion; relative."""
    period: Field[float, float] = Field(REAL)
    """Angle after which the cogging repeats. Unit: deg. Raw value 0: automatic."""
    period_raw: Field[int, int] = Field(RAW, of="period")
    """The number on the wire for period."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        angle: float = UNSET,
        angle_raw: int = UNSET,
        smooth: float = UNSET,
        smooth_raw: int = UNSET,
        speed: int = UNSET,
        period: float = UNSET,
        period_raw: int = UNSET,
        reserved: Bytes = UNSET,
    ) -> None:
        self._start(
            angle=angle,
            angle_raw=angle_raw,
            smooth=smooth,
            smooth_raw=smooth_raw,
            speed=speed,
            period=period,
            period_raw=period_raw,
            reserved=reserved,
        )


class BodeSample(Structure):
    """The samples."""

    __slots__ = ()
    _home = ("BodeTestData", "samples[0]")

    input: Field[int, int] = Field(RAW)
    """Input. Range: 0 to 65534."""
    output: Field[int, int] = Field(RAW)
    """Output. Range: 0 to 65534."""

    def __init__(self, *, input: int = UNSET, output: int = UNSET) -> None:
        self._start(input=input, output=output)


class CalibAcc(Request["Confirm"]):
    """Calibrate the accelerometer of the active IMU.

    Confirmed on reception and again at the end; not at all if a parameter is wrong.

    Before: Place the camera so that the sensor is exactly level, on something that does not
    move, and turn the motors off. To calibrate the other directions as well, repeat it with
    each side of the sensor upwards; CMD_CALIB_INFO shows which ones are done.

    CMD_CALIB_ACC (65), to the board, simple form; 0 bytes. Effect: stores. Source: Outgoing
    commands L621-L640.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class CalibAccExt(Request["Confirm"]):
    """Calibrate the accelerometer of an IMU, or manage its calibrations.

    Confirmed on reception and again at the end; not at all if a parameter is wrong.

    Before: Place the camera so that the sensor is exactly level, on something that does not
    move, and turn the motors off. To calibrate the other directions as well, repeat it with
    each side of the sensor upwards; CMD_CALIB_INFO shows which ones are done. For TEMPERATURE,
    cool the sensor down first; it is calibrated while it warms up by itself.

    CMD_CALIB_ACC (65), to the board, extended form; 12 bytes. Effect: stores, restarts, erases.
    Source: Outgoing commands L621-L640.
    """

    __slots__ = ()

    imu_idx: Field[CalibImu, CalibImu] = Field(ValueOf(CalibImu))
    """The IMU."""
    action: Field[CalibAction, CalibAction] = Field(ValueOf(CalibAction))
    """Operation."""
    time_ms: Field[float, float] = Field(REAL)
    """Without meaning here; the duration of the calibration of a gyroscope. Unit: ms. Since
    firmware 2.60.
    """
    time_ms_raw: Field[int, int] = Field(RAW, of="time_ms")
    """The number on the wire for time_ms."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        imu_idx: CalibImu = UNSET,
        action: CalibAction = UNSET,
        time_ms: float = UNSET,
        time_ms_raw: int = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            imu_idx=imu_idx,
            action=action,
            time_ms=time_ms,
            time_ms_raw=time_ms_raw,
            reserved=reserved,
            tail=tail,
        )


class CalibGyro(Request["Confirm"]):
    """Calibrate the gyroscope of the active IMU.

    Confirmed on reception and again at the end; not at all if a parameter is wrong.

    Before: Leave the camera completely still, in any position, and turn the motors off; do not
    touch it until the end.

    CMD_CALIB_GYRO (103), to the board, simple form; 0 bytes. Effect: stores. Source: Outgoing
    commands L621-L640.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class CalibGyroExt(Request["Confirm"]):
    """Calibrate the gyroscope of an IMU, or manage its calibrations.

    Confirmed on reception and again at the end; not at all if a parameter is wrong.

    Before: Leave the camera completely still, in any position, and turn the motors off; do not
    touch it until the end. For TEMPERATURE, cool the sensor down first; it is calibrated while
    it warms up by itself.

    CMD_CALIB_GYRO (103), to the board, extended form; 12 bytes. Effect: stores, restarts,
    erases. Source: Outgoing commands L621-L640.
    """

    __slots__ = ()

    DEFAULT_TIME: ClassVar[int] = 0
    """For time_ms, as raw value: about 4 s."""
    imu_idx: Field[CalibImu, CalibImu] = Field(ValueOf(CalibImu))
    """The IMU."""
    action: Field[CalibAction, CalibAction] = Field(ValueOf(CalibAction))
    """Operation."""
    time_ms: Field[float, float] = Field(REAL)
    """Duration of the calibration of a gyroscope. Unit: ms. Raw value 0: about 4 s. Since firmware
    2.60.
    """
    time_ms_raw: Field[int, int] = Field(RAW, of="time_ms")
    """The number on the wire for time_ms."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        imu_idx: CalibImu = UNSET,
        action: CalibAction = UNSET,
        time_ms: float = UNSET,
        time_ms_raw: int = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            imu_idx=imu_idx,
            action=action,
            time_ms=time_ms,
            time_ms_raw=time_ms_raw,
            reserved=reserved,
            tail=tail,
        )


class CalibMag(Request["Optional[Confirm]"]):
    """Calibrate the magnetometer.

    Before: Take the gimbal away from steel and from other motors, and turn the motors off.
    While the calibration runs, turn the sensor slowly about all its axes, until every side has
    pointed in every direction.

    CMD_CALIB_MAG (59), to the board, simple form; 0 bytes. Effect: stores. Since board 3.0.
    Source: Outgoing commands L940-L944.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class CalibMagExt(Request["Optional[Confirm]"]):
    """Calibrate the magnetometer of an IMU, or manage its calibrations.

    Before: Take the gimbal away from steel and from other motors, and turn the motors off.
    While the calibration runs, turn the sensor slowly about all its axes, until every side has
    pointed in every direction.

    CMD_CALIB_MAG (59), to the board, extended form; 12 bytes. Effect: stores, restarts, erases.
    Since board 3.0. Source: Later firmware.
    """

    __slots__ = ()

    imu_idx: Field[CalibImu, CalibImu] = Field(ValueOf(CalibImu))
    """The IMU."""
    action: Field[CalibAction, CalibAction] = Field(ValueOf(CalibAction))
    """Operation."""
    time_ms: Field[float, float] = Field(REAL)
    """Without meaning here; the duration of the calibration of a gyroscope. Unit: ms."""
    time_ms_raw: Field[int, int] = Field(RAW, of="time_ms")
    """The number on the wire for time_ms."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        imu_idx: CalibImu = UNSET,
        action: CalibAction = UNSET,
        time_ms: float = UNSET,
        time_ms_raw: int = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            imu_idx=imu_idx,
            action=action,
            time_ms=time_ms,
            time_ms_raw=time_ms_raw,
            reserved=reserved,
            tail=tail,
        )


class CalibExtGain(Request["Confirm"]):
    """Calibrate the gains of a flight controller's signals.

    Before: Connect the flight controller and level the camera. While the calibration runs, tilt
    the frame smoothly by 20 to 40 degrees to both sides, in roll and in pitch.

    CMD_CALIB_EXT_GAIN (71), to the board; 0 bytes. Effect: stores, moves. Source: Outgoing
    commands L642.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class CalibPoles(Request["Confirm"]):
    """Detect the poles and the direction of the motors.

    Before: Balance the camera, fasten the frame, and make sure that all axes turn freely: the
    motors turn the camera. Their power must be set high enough to hold it.

    CMD_CALIB_POLES (80), to the board; 0 bytes. Effect: stores, moves. Source: Outgoing
    commands L650.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class CalibOffset(Request["Optional[Confirm]"]):
    """Calibrate the follow mode offset.

    Before: Level the frame, and turn the camera to the position, relative to the frame, that it
    should have in follow mode.

    CMD_CALIB_OFFSET (79), to the board; 0 bytes. Effect: stores, moves. Source: Outgoing
    commands L688.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class CalibBat(Request["Optional[Confirm]"]):
    """Calibrate the battery voltage measurement.

    Before: Measure the voltage of the battery with a voltmeter, at the connector of the board,
    while the board is on.

    CMD_CALIB_BAT (66), to the board; 2 bytes. Effect: stores. Source: Outgoing commands
    L690-L692.
    """

    __slots__ = ()

    actual_voltage: Field[float, float] = Field(REAL)
    """Actual voltage, measured externally. Unit: V."""
    actual_voltage_raw: Field[int, int] = Field(RAW, of="actual_voltage")
    """The number on the wire for actual_voltage."""

    def __init__(
        self,
        *,
        actual_voltage: float = UNSET,
        actual_voltage_raw: int = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(actual_voltage=actual_voltage, actual_voltage_raw=actual_voltage_raw, tail=tail)


class CalibInfo(Message):
    """Calibration status for display.

    CMD_CALIB_INFO (49), from the board; 33 bytes, and later firmware may append more. Since
    board 3.0. Source: Incoming commands L546-L563; Variables L1233-L1246.
    """

    __slots__ = ()

    progress: Field[float, float] = Field(REAL)
    """Progress of the calibration. Range: 0 to 100 %."""
    progress_raw: Field[int, int] = Field(RAW, of="progress")
    """The number on the wire for progress."""
    imu_type: Field[SelectedImu, SelectedImu] = Field(ValueOf(SelectedImu))
    """The IMU."""
    acc_data: Field[Xyz[float], Xyz[float]] = Field(AxesOf(REAL, Xyz))
    """Accelerometer, as in CMD_REALTIME_DATA_3. Unit: g. Positive pitch is down, negative up;
    positive yaw is right, negative left; for roll it is not known.
    """
    acc_data_raw: Field[Xyz[int], Xyz[int]] = Field(AxesOf(RAW, Xyz), of="acc_data")
    """The number on the wire for acc_data."""
    gyro_abs_val: Field[int, int] = Field(RAW)
    """Magnitude of the gyroscope signal."""
    acc_cur_axis: Field[int, int] = Field(RAW)
    """Accelerometer axis to calibrate next. Range: 0 to 2."""
    acc_limits_info: Field[CalibratedLimits, CalibratedLimits] = Field(ValueOf(CalibratedLimits))
    """Calibrated directions of the accelerometer."""
    imu_temp_cels: Field[float, float] = Field(REAL)
    """Temperature of the IMU. Range: -127 to 127 degC."""
    imu_temp_cels_raw: Field[int, int] = Field(RAW, of="imu_temp_cels")
    """The number on the wire for imu_temp_cels."""
    temp_calib_gyro_enabled: Field[int, int] = Field(RAW)
    """1 if the gyroscope's calibration over temperature is enabled. Range: 0 to 1."""
    temp_calib_gyro_t_min_cels: Field[float, float] = Field(REAL)
    """Lowest temperature of the gyroscope's calibration. Range: -127 to 127 degC."""
    temp_calib_gyro_t_min_cels_raw: Field[int, int] = Field(RAW, of="temp_calib_gyro_t_min_cels")
    """The number on the wire for temp_calib_gyro_t_min_cels."""
    temp_calib_gyro_t_max_cels: Field[float, float] = Field(REAL)
    """Highest temperature of the gyroscope's calibration. Range: -127 to 127 degC."""
    temp_calib_gyro_t_max_cels_raw: Field[int, int] = Field(RAW, of="temp_calib_gyro_t_max_cels")
    """The number on the wire for temp_calib_gyro_t_max_cels."""
    temp_calib_acc_enabled: Field[int, int] = Field(RAW)
    """1 if the accelerometer's calibration over temperature is enabled. Range: 0 to 1."""
    temp_calib_acc_slot_num: Field[Elements[int], Iterable[int]] = Field(ListOf(RAW))
    """Number of calibrated temperatures of the accelerometer in the directions +X, +Y, +Z, -X, -Y,
    -Z. Range: 0 to 3.
    """
    temp_calib_acc_t_min_cels: Field[float, float] = Field(REAL)
    """Lowest temperature of the accelerometer's calibration. Range: -127 to 127 degC."""
    temp_calib_acc_t_min_cels_raw: Field[int, int] = Field(RAW, of="temp_calib_acc_t_min_cels")
    """The number on the wire for temp_calib_acc_t_min_cels."""
    temp_calib_acc_t_max_cels: Field[float, float] = Field(REAL)
    """Highest temperature of the accelerometer's calibration. Range: -127 to 127 degC."""
    temp_calib_acc_t_max_cels_raw: Field[int, int] = Field(RAW, of="temp_calib_acc_t_max_cels")
    """The number on the wire for temp_calib_acc_t_max_cels."""
    h1_err_length: Field[float, float] = Field(REAL)
    """Length of the difference between the estimated and the reference heading vector, both of
    length 1.
    """
    h1_err_length_raw: Field[int, int] = Field(RAW, of="h1_err_length")
    """The number on the wire for h1_err_length."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        progress: float = UNSET,
        progress_raw: int = UNSET,
        imu_type: SelectedImu = UNSET,
        acc_data: Xyz[float] = UNSET,
        acc_data_raw: Xyz[int] = UNSET,
        gyro_abs_val: int = UNSET,
        acc_cur_axis: int = UNSET,
        acc_limits_info: CalibratedLimits = UNSET,
        imu_temp_cels: float = UNSET,
        imu_temp_cels_raw: int = UNSET,
        temp_calib_gyro_enabled: int = UNSET,
        temp_calib_gyro_t_min_cels: float = UNSET,
        temp_calib_gyro_t_min_cels_raw: int = UNSET,
        temp_calib_gyro_t_max_cels: float = UNSET,
        temp_calib_gyro_t_max_cels_raw: int = UNSET,
        temp_calib_acc_enabled: int = UNSET,
        temp_calib_acc_slot_num: Iterable[int] = UNSET,
        temp_calib_acc_t_min_cels: float = UNSET,
        temp_calib_acc_t_min_cels_raw: int = UNSET,
        temp_calib_acc_t_max_cels: float = UNSET,
        temp_calib_acc_t_max_cels_raw: int = UNSET,
        h1_err_length: float = UNSET,
        h1_err_length_raw: int = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            progress=progress,
            progress_raw=progress_raw,
            imu_type=imu_type,
            acc_data=acc_data,
            acc_data_raw=acc_data_raw,
            gyro_abs_val=gyro_abs_val,
            acc_cur_axis=acc_cur_axis,
            acc_limits_info=acc_limits_info,
            imu_temp_cels=imu_temp_cels,
            imu_temp_cels_raw=imu_temp_cels_raw,
            temp_calib_gyro_enabled=temp_calib_gyro_enabled,
            temp_calib_gyro_t_min_cels=temp_calib_gyro_t_min_cels,
            temp_calib_gyro_t_min_cels_raw=temp_calib_gyro_t_min_cels_raw,
            temp_calib_gyro_t_max_cels=temp_calib_gyro_t_max_cels,
            temp_calib_gyro_t_max_cels_raw=temp_calib_gyro_t_max_cels_raw,
            temp_calib_acc_enabled=temp_calib_acc_enabled,
            temp_calib_acc_slot_num=temp_calib_acc_slot_num,
            temp_calib_acc_t_min_cels=temp_calib_acc_t_min_cels,
            temp_calib_acc_t_min_cels_raw=temp_calib_acc_t_min_cels_raw,
            temp_calib_acc_t_max_cels=temp_calib_acc_t_max_cels,
            temp_calib_acc_t_max_cels_raw=temp_calib_acc_t_max_cels_raw,
            h1_err_length=h1_err_length,
            h1_err_length_raw=h1_err_length_raw,
            reserved=reserved,
            tail=tail,
        )


class CalibInfoRequest(Request["CalibInfo"]):
    """Request the calibration status.

    CMD_CALIB_INFO (49), to the board; 12 bytes. Effect: reads. Since board 3.0. Source:
    Outgoing commands L891-L896.
    """

    __slots__ = ()

    imu_type: Field[SelectedImu, SelectedImu] = Field(ValueOf(SelectedImu))
    """The IMU."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        imu_type: SelectedImu = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(imu_type=imu_type, reserved=reserved, tail=tail)


class CalibMotorMagLink(Message):
    """Undocumented body from the board.

    CMD_CALIB_MOTOR_MAG_LINK (74), from the board; 0 to 255 bytes. Since board 3.0. Source:
    Command ID definitions L142.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class CalibMotorMagLinkRequest(Request["Optional[Confirm]"]):
    """Undocumented body to the board.

    CMD_CALIB_MOTOR_MAG_LINK (74), to the board; 0 to 255 bytes. Effect: unknown. Since board
    3.0. Source: Command ID definitions L142.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class EncodersCalibOffset4(Request["Optional[Confirm]"]):
    """Calibrate the offsets of the encoders.

    Before: Turn the motors off, and turn the camera by hand to the position in which all motor
    angles are zero: level, and straight to the frame.

    CMD_ENCODERS_CALIB_OFFSET_4 (26), to the board; 0 or 1 byte. Effect: stores. Since board
    3.0. Source: Outgoing commands L993.
    """

    __slots__ = ()

    for_motor: Field[Optional[CalibMotor], Optional[CalibMotor]] = Field(
        ValueOf(CalibMotor),
        optional=True,
    )
    """Motor whose encoder to calibrate. Since firmware 2.68b7; before, the body ends here."""

    def __init__(self, *, for_motor: Optional[CalibMotor] = UNSET, tail: Bytes = UNSET) -> None:
        self._start(for_motor=for_motor, tail=tail)


class EncodersCalibFldOffset4(Request["Optional[Confirm]"]):
    """Calibrate the offsets between encoders and the motors' magnetic fields.

    Before: Balance the camera, fasten the frame, and make sure that all axes turn freely: the
    motors turn the camera back and forth.

    CMD_ENCODERS_CALIB_FLD_OFFSET_4 (27), to the board; 0 to 14 bytes. Effect: stores, moves.
    Since board 3.0. Source: Outgoing commands L995.
    """

    __slots__ = ()

    calib_angle: Field[Optional[Axes[float]], Optional[Axes[float]]] = Field(
        AxesOf(REAL),
        optional=True,
    )
    """Angle by which each motor turns; 40 degrees if omitted. Unit: deg. Since firmware 2.62b6;
    before, the body ends here.
    """
    calib_angle_raw: Field[Optional[Axes[int]], Optional[Axes[int]]] = Field(
        AxesOf(RAW),
        optional=True,
        of="calib_angle",
    )
    """The number on the wire for calib_angle."""
    calib_speed: Field[Optional[Axes[float]], Optional[Axes[float]]] = Field(
        AxesOf(REAL),
        optional=True,
    )
    """Speed at which each motor turns. Unit: deg/s. Since firmware 2.71b1; before, the body ends
    here.
    """
    calib_speed_raw: Field[Optional[Axes[int]], Optional[Axes[int]]] = Field(
        AxesOf(RAW),
        optional=True,
        of="calib_speed",
    )
    """The number on the wire for calib_speed."""
    calib_flags: Field[Optional[FieldOffsetFlags], Optional[FieldOffsetFlags]] = Field(
        ValueOf(FieldOffsetFlags),
        optional=True,
    )
    """Checks to omit. Since firmware 2.70b8; before, the body ends here."""

    def __init__(
        self,
        *,
        calib_angle: Optional[Axes[float]] = UNSET,
        calib_angle_raw: Optional[Axes[int]] = UNSET,
        calib_speed: Optional[Axes[float]] = UNSET,
        calib_speed_raw: Optional[Axes[int]] = UNSET,
        calib_flags: Optional[FieldOffsetFlags] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            calib_angle=calib_angle,
            calib_angle_raw=calib_angle_raw,
            calib_speed=calib_speed,
            calib_speed_raw=calib_speed_raw,
            calib_flags=calib_flags,
            tail=tail,
        )


class AutoPid(Message):
    """Progress of the automatic tuning.

    CMD_AUTO_PID (35), from the board; 57 bytes, and later firmware may append more. Since board
    3.0. Source: Incoming commands L462-L474.
    """

    __slots__ = ()

    p: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Proportional gain of each axis."""
    i: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Integral gain of each axis, as stored."""
    d: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Derivative gain of each axis."""
    lpf_freq: Field[Axes[int], Axes[int]] = Field(AxesOf(RAW))
    """Low-pass filter of each axis, as stored."""
    iter_num: Field[int, int] = Field(RAW)
    """Number of completed iterations."""
    axes: Field[Axes[AxisTuning], Axes[AxisTuning]] = Field(AxesOf(GroupOf(AxisTuning)))
    """Current result of each axis."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        p: Axes[int] = UNSET,
        i: Axes[int] = UNSET,
        d: Axes[int] = UNSET,
        lpf_freq: Axes[int] = UNSET,
        iter_num: int = UNSET,
        axes: Axes[AxisTuning] = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            p=p,
            i=i,
            d=d,
            lpf_freq=lpf_freq,
            iter_num=iter_num,
            axes=axes,
            reserved=reserved,
            tail=tail,
        )


class AutoPidRequest(Request["Optional[Confirm]"]):
    """Start or stop the automatic tuning.

    With AUTO_PID_CFG_SEND_GUI the board sends CMD_AUTO_PID repeatedly while it tunes. Later
    firmware has CMD_AUTO_PID2.

    CMD_AUTO_PID (35), to the board; 19 bytes. Effect: stores, moves. Since board 3.0. Firmware
    2.73 and later no longer accepts it. Source: Outgoing commands L806-L811; Variables
    L1177-L1182.
    """

    __slots__ = ()

    STOP_TUNING: ClassVar[int] = 0
    """For cfg_flags, as raw value: stops the tuning."""
    AUTOMATIC_MOMENTUM: ClassVar[int] = 0
    """For momentum, as raw value: automatic."""
    START_TUNING: ClassVar[int] = 0
    """For action, as raw value: starts the tuning."""
    profile_id: Field[int, int] = Field(RAW)
    """Profile to switch to first. Range: 0 to 4."""
    cfg_flags: Field[AutoPidFlags, AutoPidFlags] = Field(ValueOf(AutoPidFlags))
    """What to tune, and options. Value 0: stops the tuning."""
    gain_vs_stability: Field[int, int] = Field(RAW)
    """Preference for high gains at the cost of stability."""
    momentum: Field[int, int] = Field(RAW)
    """Moment of inertia. Value 0: automatic. Since firmware 2.60."""
    action: Field[int, int] = Field(RAW)
    """Operation; only one is documented. Value 0: starts the tuning. Since firmware 2.60."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        profile_id: int = UNSET,
        cfg_flags: AutoPidFlags = UNSET,
        gain_vs_stability: int = UNSET,
        momentum: int = UNSET,
        action: int = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            profile_id=profile_id,
            cfg_flags=cfg_flags,
            gain_vs_stability=gain_vs_stability,
            momentum=momentum,
            action=action,
            reserved=reserved,
            tail=tail,
        )


class AutoPid2(Request["Confirm"]):
    """Tune the PID controllers automatically, in later firmware.

    The configuration is part of the requests that start the tuning or save it. After the end,
    the board sends the tuned parameters.

    CMD_AUTO_PID2 (108), to the board; 11 to 73 bytes. Effect: stores, moves. Since firmware
    2.73. Source: Later firmware.
    """

    __slots__ = ()

    action: Field[AutoPid2Action, AutoPid2Action] = Field(ValueOf(AutoPid2Action))
    """Operation."""
    cmd_flags: Field[AutoPid2CommandFlags, AutoPid2CommandFlags] = Field(
        ValueOf(AutoPid2CommandFlags),
    )
    """Options of this request."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""
    config: Field[Optional[AutoPid2Config], Optional[AutoPid2Config]] = Field(
        GroupOf(AutoPid2Config),
        optional=True,
    )
    """How to tune. Present if action is START or START_SAVE or SAVE."""

    def __init__(
        self,
        *,
        action: AutoPid2Action = UNSET,
        cmd_flags: AutoPid2CommandFlags = UNSET,
        reserved: Bytes = UNSET,
        config: Optional[AutoPid2Config] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(action=action, cmd_flags=cmd_flags, reserved=reserved, config=config, tail=tail)


class CalibOrientCorr(Request["Confirm"]):
    """Calibrate the orientation of the IMU.

    According to one source, the board later also sends CMD_READ_PARAMS_EXT2, which holds the
    result.

    Before: Balance the camera, fasten the frame, and make sure that all axes turn freely: the
    motors turn the camera. Calibrate the gyroscope and the accelerometer first.

    CMD_CALIB_ORIENT_CORR (91), to the board; 16 bytes. Effect: stores, moves. Since firmware
    2.61. Source: Later firmware.
    """

    __slots__ = ()

    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(self, *, reserved: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(reserved=reserved, tail=tail)


class CalibCogging(Request["Confirm"]):
    """Calibrate the cogging of the motors, or delete this calibration.

    Before: Balance the camera, fasten the frame, and make sure that the chosen axes turn
    freely: the motors turn the camera slowly, several times.

    CMD_CALIB_COGGING (93), to the board; 57 bytes. Effect: stores, moves, erases. Since
    firmware 2.60. Source: Later firmware.
    """

    __slots__ = ()

    action: Field[CoggingAction, CoggingAction] = Field(ValueOf(CoggingAction))
    """Operation."""
    axes: Field[CoggingAxes, CoggingAxes] = Field(ValueOf(CoggingAxes))
    """The motors."""
    motors: Field[Axes[CoggingMotor], Axes[CoggingMotor]] = Field(AxesOf(GroupOf(CoggingMotor)))
    """How to calibrate each motor. Used if action is not DELETE and axes has {AXIS}."""
    iterations_num: Field[int, int] = Field(RAW)
    """Number of repetitions. Range: 2 to 255. Used if action is not DELETE."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        action: CoggingAction = UNSET,
        axes: CoggingAxes = UNSET,
        motors: Axes[CoggingMotor] = UNSET,
        iterations_num: int = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            action=action,
            axes=axes,
            motors=motors,
            iterations_num=iterations_num,
            reserved=reserved,
            tail=tail,
        )


class CalibAccExtRef(Request["Confirm"]):
    """Calibrate the accelerometer with an external reference.

    Before: Leave the camera completely still, and determine the direction of gravity in the
    coordinates of the sensor with another instrument.

    CMD_CALIB_ACC_EXT_REF (94), to the board; 20 bytes. Effect: stores. Since firmware 2.62b7.
    Source: Later firmware.
    """

    __slots__ = ()

    acc_ref: Field[Xyz[float], Xyz[float]] = Field(AxesOf(REAL, Xyz))
    """Actual acceleration. Unit: g. Positive pitch is down, negative up; positive yaw is right,
    negative left; for roll it is not known.
    """
    acc_ref_raw: Field[Xyz[int], Xyz[int]] = Field(AxesOf(RAW, Xyz), of="acc_ref")
    """The number on the wire for acc_ref."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        acc_ref: Xyz[float] = UNSET,
        acc_ref_raw: Xyz[int] = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(acc_ref=acc_ref, acc_ref_raw=acc_ref_raw, reserved=reserved, tail=tail)


class BodeTestStartStop(Message):
    """End of the recording.

    CMD_BODE_TEST_START_STOP (37), from the board; 22 bytes, and later firmware may append more.
    Since firmware 2.50, board 3.0. Source: Vendor's code of 2026.
    """

    __slots__ = ()

    BODE_SUCCESS: ClassVar[int] = 0
    """For error_code, as raw value: success."""
    samples_count: Field[int, int] = Field(RAW)
    """Number of samples; some firmware sends the index of the last one."""
    error_code: Field[int, int] = Field(RAW)
    """Reason of the end. Value 0: success."""
    mode: Field[int, int] = Field(RAW)
    """MODE of the request."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        samples_count: int = UNSET,
        error_code: int = UNSET,
        mode: int = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            samples_count=samples_count,
            error_code=error_code,
            mode=mode,
            reserved=reserved,
            tail=tail,
        )


class BodeTestStartStopRequest(Request["BodeTestStartStop"]):
    """Start the recording of a frequency response.

    The board moves the axis with a stimulus and sends CMD_BODE_TEST_DATA until the end, which
    this command from the board reports. Data may come before the confirmation, which some
    firmware omits. No source says how to stop a recording: CMD_MOTORS_OFF ends the motion. The
    messages do not say to which recording they belong, so there is one at a time.

    CMD_BODE_TEST_START_STOP (37), to the board; 30 bytes. Effect: moves. Since firmware 2.50,
    board 3.0. Rules: start_freq <= end_freq. Source: Vendor's code of 2026.
    """

    __slots__ = ()

    axis: Field[BodeAxis, BodeAxis] = Field(ValueOf(BodeAxis))
    """The axis."""
    stimulus_type: Field[BodeStimulus, BodeStimulus] = Field(ValueOf(BodeStimulus))
    """Kind of stimulus."""
    stimulus_gain: Field[int, int] = Field(RAW)
    """Strength of the stimulus. Range: 1 to 65535."""
    end_freq: Field[float, float] = Field(REAL)
    """Highest frequency. Unit: Hz."""
    end_freq_raw: Field[int, int] = Field(RAW, of="end_freq")
    """The number on the wire for end_freq."""
    system: Field[BodeSystem, BodeSystem] = Field(ValueOf(BodeSystem))
    """What is measured."""
    samples_num: Field[int, int] = Field(RAW)
    """Number of samples, each of 0.8 ms."""
    mode: Field[int, int] = Field(RAW)
    """Reserved. Always 0."""
    start_freq: Field[float, float] = Field(REAL)
    """Lowest frequency. Unit: Hz."""
    start_freq_raw: Field[int, int] = Field(RAW, of="start_freq")
    """The number on the wire for start_freq."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        axis: BodeAxis = UNSET,
        stimulus_type: BodeStimulus = UNSET,
        stimulus_gain: int = UNSET,
        end_freq: float = UNSET,
        end_freq_raw: int = UNSET,
        system: BodeSystem = UNSET,
        samples_num: int = UNSET,
        mode: int = UNSET,
        start_freq: float = UNSET,
        start_freq_raw: int = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            axis=axis,
            stimulus_type=stimulus_type,
            stimulus_gain=stimulus_gain,
            end_freq=end_freq,
            end_freq_raw=end_freq_raw,
            system=system,
            samples_num=samples_num,
            mode=mode,
            start_freq=start_freq,
            start_freq_raw=start_freq_raw,
            reserved=reserved,
            tail=tail,
        )


class BodeTestData(Message):
    """Samples of a recording that runs.

    A value is MIN + raw * (MAX - MIN) / 65534, with the limits of its signal in the same
    message.

    CMD_BODE_TEST_DATA (38), from the board; 17 to 97 bytes. Since firmware 2.50, board 3.0.
    Source: Vendor's code of 2026.
    """

    __slots__ = ()

    sample_counter: Field[int, int] = Field(RAW)
    """Index of the first sample, modulo 256; the next message begins where this one ends, unless
    samples are lost.
    """
    input_min: Field[float, float] = Field(REAL)
    """Input of raw value 0."""
    output_min: Field[float, float] = Field(REAL)
    """Output of raw value 0."""
    input_max: Field[float, float] = Field(REAL)
    """Input of raw value 65534."""
    output_max: Field[float, float] = Field(REAL)
    """Output of raw value 65534."""
    samples: Field[Elements[BodeSample], Iterable[BodeSample]] = Field(ListOf(GroupOf(BodeSample)))
    """The samples. At most 20."""

    def __init__(
        self,
        *,
        sample_counter: int = UNSET,
        input_min: float = UNSET,
        output_min: float = UNSET,
        input_max: float = UNSET,
        output_max: float = UNSET,
        samples: Iterable[BodeSample] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            sample_counter=sample_counter,
            input_min=input_min,
            output_min=output_min,
            input_max=input_max,
            output_max=output_max,
            samples=samples,
            tail=tail,
        )


class CoggingCalibInfo(Message):
    """Undocumented body from the board.

    CMD_COGGING_CALIB_INFO (92), from the board; 0 to 255 bytes. Since firmware 2.60. Source:
    Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class CoggingCalibInfoRequest(Request["Optional[Confirm]"]):
    """Undocumented body to the board.

    CMD_COGGING_CALIB_INFO (92), to the board; 0 to 255 bytes. Effect: unknown. Since firmware
    2.60. Source: Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class CanDrvHardParams(Message):
    """Undocumented body from the board.

    CMD_CAN_DRV_HARD_PARAMS (97), from the board; 0 to 255 bytes. Since firmware 2.60. Source:
    Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class CanDrvHardParamsRequest(Request["Optional[Confirm]"]):
    """Undocumented body to the board.

    CMD_CAN_DRV_HARD_PARAMS (97), to the board; 0 to 255 bytes. Effect: unknown. Since firmware
    2.60. Source: Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class CanDrvCalibrate(Message):
    """Undocumented body from the board.

    CMD_CAN_DRV_CALIBRATE (99), from the board; 0 to 255 bytes. Since firmware 2.60. Source:
    Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class CanDrvCalibrateRequest(Request["Optional[Confirm]"]):
    """Undocumented body to the board.

    CMD_CAN_DRV_CALIBRATE (99), to the board; 0 to 255 bytes. Effect: unknown. Since firmware
    2.60. Source: Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class CalibEncoderLut(Message):
    """Undocumented body from the board.

    CMD_CALIB_ENCODER_LUT (117), from the board; 0 to 255 bytes. Since firmware 2.60. Source:
    Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class CalibEncoderLutRequest(Request["Optional[Confirm]"]):
    """Undocumented body to the board.

    CMD_CALIB_ENCODER_LUT (117), to the board; 0 to 255 bytes. Effect: unknown. Since firmware
    2.60. Source: Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class CalibEncoderLutRes(Message):
    """Undocumented body from the board.

    CMD_CALIB_ENCODER_LUT_RES (118), from the board; 0 to 255 bytes. Since firmware 2.60.
    Source: Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class CalibEncoderLutResRequest(Request["Optional[Confirm]"]):
    """Undocumented body to the board.

    CMD_CALIB_ENCODER_LUT_RES (118), to the board; 0 to 255 bytes. Effect: unknown. Since
    firmware 2.60. Source: Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class CalibCurSens(Message):
    """Undocumented body from the board.

    CMD_CALIB_CUR_SENS (120), from the board; 0 to 255 bytes. Since firmware 2.60. Source: Later
    firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class CalibCurSensRequest(Request["Optional[Confirm]"]):
    """Undocumented body to the board.

    CMD_CALIB_CUR_SENS (120), to the board; 0 to 255 bytes. Effect: unknown. Since firmware
    2.60. Source: Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class EncIntCalib(Message):
    """Undocumented body from the board.

    CMD_ENC_INT_CALIB (122), from the board; 0 to 255 bytes. Since firmware 2.60. Unconfirmed.
    Source: Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class EncIntCalibRequest(Request["Optional[Confirm]"]):
    """Undocumented body to the board.

    CMD_ENC_INT_CALIB (122), to the board; 0 to 255 bytes. Effect: unknown. Since firmware 2.60.
    Unconfirmed. Source: Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class VibrationTestStartStop(Message):
    """Undocumented body from the board.

    CMD_VIBRATION_TEST_START_STOP (125), from the board; 0 to 255 bytes. Since firmware 2.60.
    Unconfirmed. Source: Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class VibrationTestStartStopRequest(Request["Optional[Confirm]"]):
    """Undocumented body to the board.

    CMD_VIBRATION_TEST_START_STOP (125), to the board; 0 to 255 bytes. Effect: unknown. Since
    firmware 2.60. Unconfirmed. Source: Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class VibrationTestData(Message):
    """Undocumented body from the board.

    CMD_VIBRATION_TEST_DATA (126), from the board; 0 to 255 bytes. Since firmware 2.60.
    Unconfirmed. Source: Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class VibrationTestDataRequest(Request["Optional[Confirm]"]):
    """Undocumented body to the board.

    CMD_VIBRATION_TEST_DATA (126), to the board; 0 to 255 bytes. Effect: unknown. Since firmware
    2.60. Unconfirmed. Source: Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)
