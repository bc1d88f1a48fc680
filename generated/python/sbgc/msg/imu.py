# Generated from spec/ by generator/: edit those, then run ./dev generate.
"""Selecting, correcting and replacing the board's sensors."""

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
    "AhrsDebugInfo",
    "AhrsHelper",
    "AhrsHelperRequest",
    "AhrsHelperRequestExt",
    "AhrsHelperRequestExtWide",
    "AhrsHelperRequestWide",
    "ExtImuCmd",
    "ExtImuDebugInfo",
    "ExtImuDebugInfoRequest",
    "ExtSensCmd",
    "ExtSensCmdRequest",
    "GyroCorrection",
    "ImuAdvancedCalib",
    "ImuAdvancedCalibRequest",
    "SelectImu3",
    "SelectImu3Calibrate",
    "SelectImu3CalibrateShort",
    "SelectImu3Ext",
]

Bytes = Union[bytes, bytearray, memoryview]


class AhrsDebugInfo(Structure):
    """State of the attitude estimation."""

    __slots__ = ()
    _home = ("RealtimeDataCustom", "ahrs_debug_info")

    main_imu_ref_src: Field[AhrsReferences, int] = Field(ValueOf(AhrsReferences))
    """What corrects the attitude of the main IMU."""
    frame_imu_ref_src: Field[AhrsReferences, int] = Field(ValueOf(AhrsReferences))
    """What corrects the attitude of the frame IMU."""
    main_z_err: Field[float, float] = Field(REAL)
    """Error of the main IMU's gravity vector. Unit: deg."""
    main_z_err_raw: Field[int, int] = Field(RAW, of="main_z_err")
    """The number on the wire for main_z_err."""
    main_h_err: Field[float, float] = Field(REAL)
    """Error of the main IMU's heading vector. Unit: deg."""
    main_h_err_raw: Field[int, int] = Field(RAW, of="main_h_err")
    """The number on the wire for main_h_err."""
    frame_z_err: Field[float, float] = Field(REAL)
    """Error of the frame IMU's gravity vector. Unit: deg."""
    frame_z_err_raw: Field[int, int] = Field(RAW, of="frame_z_err")
    """The number on the wire for frame_z_err."""
    frame_h_err: Field[float, float] = Field(REAL)
    """Error of the frame IMU's heading vector. Unit: deg."""
    frame_h_err_raw: Field[int, int] = Field(RAW, of="frame_h_err")
    """The number on the wire for frame_h_err."""
    ext_imu_status: Field[ExtImuStatus, int] = Field(ValueOf(ExtImuStatus))
    """State of the external IMU."""
    ext_imu_packets: Field[int, int] = Field(RAW)
    """Number of packets from the external IMU."""
    ext_imu_parse_err: Field[int, int] = Field(RAW)
    """Number of damaged packets from the external IMU."""
    ext_corr_h_err: Field[float, float] = Field(REAL)
    """Error of the external heading correction. Unit: deg."""
    ext_corr_h_err_raw: Field[int, int] = Field(RAW, of="ext_corr_h_err")
    """The number on the wire for ext_corr_h_err."""
    ext_corr_z_err: Field[float, float] = Field(REAL)
    """Error of the external gravity correction. Unit: deg."""
    ext_corr_z_err_raw: Field[int, int] = Field(RAW, of="ext_corr_z_err")
    """The number on the wire for ext_corr_z_err."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        main_imu_ref_src: int = UNSET,
        frame_imu_ref_src: int = UNSET,
        main_z_err: float = UNSET,
        main_z_err_raw: int = UNSET,
        main_h_err: float = UNSET,
        main_h_err_raw: int = UNSET,
        frame_z_err: float = UNSET,
        frame_z_err_raw: int = UNSET,
        frame_h_err: float = UNSET,
        frame_h_err_raw: int = UNSET,
        ext_imu_status: int = UNSET,
        ext_imu_packets: int = UNSET,
        ext_imu_parse_err: int = UNSET,
        ext_corr_h_err: float = UNSET,
        ext_corr_h_err_raw: int = UNSET,
        ext_corr_z_err: float = UNSET,
        ext_corr_z_err_raw: int = UNSET,
        reserved: Bytes = UNSET,
    ) -> None:
        self._start(
            main_imu_ref_src=main_imu_ref_src,
            frame_imu_ref_src=frame_imu_ref_src,
            main_z_err=main_z_err,
            main_z_err_raw=main_z_err_raw,
            main_h_err=main_h_err,
            main_h_err_raw=main_h_err_raw,
            frame_z_err=frame_z_err,
            frame_z_err_raw=frame_z_err_raw,
            frame_h_err=frame_h_err,
            frame_h_err_raw=frame_h_err_raw,
            ext_imu_status=ext_imu_status,
            ext_imu_packets=ext_imu_packets,
            ext_imu_parse_err=ext_imu_parse_err,
            ext_corr_h_err=ext_corr_h_err,
            ext_corr_h_err_raw=ext_corr_h_err_raw,
            ext_corr_z_err=ext_corr_z_err,
            ext_corr_z_err_raw=ext_corr_z_err_raw,
            reserved=reserved,
        )


class SelectImu3(Request["Optional[Confirm]"]):
    """Select the IMU to configure and calibrate.

    CMD_SELECT_IMU_3 (24), to the board, simple form; 1 byte. Effect: sets. Since board 3.0.
    Source: Outgoing commands L757-L759; Variables L1168-L1169.
    """

    __slots__ = ()

    imu_type: Field[SelectedImu, SelectedImu] = Field(ValueOf(SelectedImu))
    """The IMU."""

    def __init__(self, *, imu_type: SelectedImu = UNSET, tail: Bytes = UNSET) -> None:
        self._start(imu_type=imu_type, tail=tail)


class SelectImu3Ext(Request["Optional[Confirm]"]):
    """Select an IMU, with parameters that no source describes.

    CMD_SELECT_IMU_3 (24), to the board, extended form; 2 to 10 bytes. Effect: sets. Since
    firmware 2.60. Unconfirmed. Source: Outgoing commands L757-L759; Variables L1168-L1169.
    """

    __slots__ = ()

    imu_type: Field[SelectedImu, SelectedImu] = Field(ValueOf(SelectedImu))
    """The IMU."""
    param: Field[int, int] = Field(RAW)
    """Undocumented."""
    params: Field[bytes, Bytes] = Field(BYTES)
    """Further undocumented parameters. At most 8."""

    def __init__(
        self,
        *,
        imu_type: SelectedImu = UNSET,
        param: int = UNSET,
        params: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(imu_type=imu_type, param=param, params=params, tail=tail)


class SelectImu3CalibrateShort(Request["Optional[Confirm]"]):
    """The same, with one byte less.

    CMD_SELECT_IMU_3 (24), to the board, calibrate_short form; 11 bytes. Effect: stores,
    restarts, erases. Since firmware 2.60. Unconfirmed. Source: Vendor's code of 2026.
    """

    __slots__ = ()

    imu_type: Field[CalibImu, CalibImu] = Field(ValueOf(CalibImu))
    """The IMU."""
    action: Field[CalibAction, CalibAction] = Field(ValueOf(CalibAction))
    """Operation."""
    time_ms: Field[float, float] = Field(REAL)
    """Duration of the operation. Unit: ms."""
    time_ms_raw: Field[int, int] = Field(RAW, of="time_ms")
    """The number on the wire for time_ms."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        imu_type: CalibImu = UNSET,
        action: CalibAction = UNSET,
        time_ms: float = UNSET,
        time_ms_raw: int = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            imu_type=imu_type,
            action=action,
            time_ms=time_ms,
            time_ms_raw=time_ms_raw,
            reserved=reserved,
            tail=tail,
        )


class SelectImu3Calibrate(Request["Optional[Confirm]"]):
    """Select an IMU and calibrate it, or manage its calibrations.

    CMD_SELECT_IMU_3 (24), to the board, calibrate form; 12 bytes. Effect: stores, restarts,
    erases. Since firmware 2.60. Source: Later firmware.
    """

    __slots__ = ()

    imu_type: Field[CalibImu, CalibImu] = Field(ValueOf(CalibImu))
    """The IMU."""
    action: Field[CalibAction, CalibAction] = Field(ValueOf(CalibAction))
    """Operation."""
    time_ms: Field[float, float] = Field(REAL)
    """Duration of the operation. Unit: ms."""
    time_ms_raw: Field[int, int] = Field(RAW, of="time_ms")
    """The number on the wire for time_ms."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        imu_type: CalibImu = UNSET,
        action: CalibAction = UNSET,
        time_ms: float = UNSET,
        time_ms_raw: int = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            imu_type=imu_type,
            action=action,
            time_ms=time_ms,
            time_ms_raw=time_ms_raw,
            reserved=reserved,
            tail=tail,
        )


class AhrsHelper(Message):
    """Attitude of an IMU as two unit vectors.

    CMD_AHRS_HELPER (56), from the board; 24 bytes, and later firmware may append more. Since
    board 3.0. Source: Incoming commands L582-L585; Variables L1192, L1196-L1197.
    """

    __slots__ = ()

    z1_vector: Field[Xyz[float], Xyz[float]] = Field(AxesOf(REAL, Xyz))
    """Unit vector that points up (the Z axis in the normal position); down according to later
    sources. Range: -1 to 1. Unconfirmed.
    """
    h1_vector: Field[Xyz[float], Xyz[float]] = Field(AxesOf(REAL, Xyz))
    """Unit vector that points north (the Y axis in the normal position). Range: -1 to 1."""

    def __init__(
        self,
        *,
        z1_vector: Xyz[float] = UNSET,
        h1_vector: Xyz[float] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(z1_vector=z1_vector, h1_vector=h1_vector, tail=tail)


class AhrsHelperRequest(Request["AhrsHelper"]):
    """Query the attitude of an IMU.

    MODE 0 queries the main IMU, 2 the frame IMU.

    CMD_AHRS_HELPER (56), to the board, simple form; 1 byte. Effect: reads. Since board 3.0.
    Firmware 2.69b5 and later accepts AhrsHelperRequestWide instead. Source: Outgoing commands
    L946-L953; Variables L1192-L1197.
    """

    __slots__ = ()

    mode: Field[AhrsHelperMode, AhrsHelperMode] = Field(ValueOf(AhrsHelperMode))
    """The IMU to query; without SET."""

    def __init__(self, *, mode: AhrsHelperMode = UNSET, tail: Bytes = UNSET) -> None:
        self._start(mode=mode, tail=tail)


class AhrsHelperRequestWide(Request["AhrsHelper"]):
    """Query the attitude of an IMU, with a two-byte mode.

    MODE 0 queries the main IMU, 2 the frame IMU.

    CMD_AHRS_HELPER (56), to the board, wide form; 2 bytes. Effect: reads. Since firmware
    2.69b5. Source: Outgoing commands L946-L953; Variables L1192-L1197.
    """

    __slots__ = ()

    mode: Field[AhrsHelperWideMode, AhrsHelperWideMode] = Field(ValueOf(AhrsHelperWideMode))
    """The IMU to query; without SET."""

    def __init__(self, *, mode: AhrsHelperWideMode = UNSET, tail: Bytes = UNSET) -> None:
        self._start(mode=mode, tail=tail)


class AhrsHelperRequestExt(Request["Optional[Union[Confirm, AhrsHelper]]"]):
    """Query or set the attitude of an IMU.

    A higher-grade IMU can replace or correct the board's own: send 50 to 100 of these messages
    per second. For a sensor on the camera, MODE 1 replaces the camera's attitude and 5 corrects
    it. For a sensor on the frame, 3 replaces the attitude of the frame and 7 corrects it; 11
    replaces it and corrects that of the camera; 15 corrects both. Z1_ONLY and H1_ONLY may be
    added to each. MODE 0 queries the main IMU, 2 the frame IMU.

    CMD_AHRS_HELPER (56), to the board, extended form; 25 bytes. Effect: moves. Since board 3.0.
    Firmware 2.69b5 and later accepts AhrsHelperRequestExtWide instead. Source: Outgoing
    commands L946-L953; Variables L1192-L1197.
    """

    __slots__ = ()

    mode: Field[AhrsHelperMode, AhrsHelperMode] = Field(ValueOf(AhrsHelperMode))
    """Operation."""
    z1_vector: Field[Xyz[float], Xyz[float]] = Field(AxesOf(REAL, Xyz))
    """Unit vector that points up (the Z axis in the normal position), or down according to later
    sources; unused in a query. Range: -1 to 1.
    """
    h1_vector: Field[Xyz[float], Xyz[float]] = Field(AxesOf(REAL, Xyz))
    """Unit vector that points north (the Y axis in the normal position); unused in a query. Range:
    -1 to 1.
    """

    def __init__(
        self,
        *,
        mode: AhrsHelperMode = UNSET,
        z1_vector: Xyz[float] = UNSET,
        h1_vector: Xyz[float] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(mode=mode, z1_vector=z1_vector, h1_vector=h1_vector, tail=tail)


class AhrsHelperRequestExtWide(Request["Optional[Union[Confirm, AhrsHelper]]"]):
    """Query or set the attitude of an IMU, with a two-byte mode.

    The useful values of MODE are those of AhrsHelperRequestExt.

    CMD_AHRS_HELPER (56), to the board, extended_wide form; 26 bytes. Effect: moves. Since
    firmware 2.69b5. Source: Outgoing commands L946-L953; Variables L1192-L1197.
    """

    __slots__ = ()

    mode: Field[AhrsHelperWideMode, AhrsHelperWideMode] = Field(ValueOf(AhrsHelperWideMode))
    """Operation."""
    z1_vector: Field[Xyz[float], Xyz[float]] = Field(AxesOf(REAL, Xyz))
    """Unit vector that points up (the Z axis in the normal position), or down according to later
    sources; unused in a query. Range: -1 to 1.
    """
    h1_vector: Field[Xyz[float], Xyz[float]] = Field(AxesOf(REAL, Xyz))
    """Unit vector that points north (the Y axis in the normal position); unused in a query. Range:
    -1 to 1.
    """

    def __init__(
        self,
        *,
        mode: AhrsHelperWideMode = UNSET,
        z1_vector: Xyz[float] = UNSET,
        h1_vector: Xyz[float] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(mode=mode, z1_vector=z1_vector, h1_vector=h1_vector, tail=tail)


class GyroCorrection(Request["Optional[Confirm]"]):
    """Correct the zero of a gyroscope manually; the camera drifts if the correction is wrong.

    CMD_GYRO_CORRECTION (75), to the board; 9 bytes. Effect: stores, moves. Since board 3.0.
    Source: Outgoing commands L955-L961; Variables L1198-L1201.
    """

    __slots__ = ()

    imu_type: Field[ImuIndex, ImuIndex] = Field(ValueOf(ImuIndex))
    """The IMU."""
    gyro_zero_corr: Field[Xyz[float], Xyz[float]] = Field(AxesOf(REAL, Xyz))
    """Zero offset of each axis. Unit: gyro unit. Positive pitch is down, negative up; positive yaw
    is right, negative left; for roll it is not known.
    """
    gyro_zero_corr_raw: Field[Xyz[int], Xyz[int]] = Field(AxesOf(RAW, Xyz), of="gyro_zero_corr")
    """The number on the wire for gyro_zero_corr."""
    gyro_zero_heading_corr: Field[float, float] = Field(REAL)
    """Offset of the rotation about the vertical, to correct the heading; the board distributes it
    over the axes. Unit: gyro unit. Positive pitch is down, negative up; positive yaw is
    right, negative left; for roll it is not known.
    """
    gyro_zero_heading_corr_raw: Field[int, int] = Field(RAW, of="gyro_zero_heading_corr")
    """The number on the wire for gyro_zero_heading_corr."""

    def __init__(
        self,
        *,
        imu_type: ImuIndex = UNSET,
        gyro_zero_corr: Xyz[float] = UNSET,
        gyro_zero_corr_raw: Xyz[int] = UNSET,
        gyro_zero_heading_corr: float = UNSET,
        gyro_zero_heading_corr_raw: int = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            imu_type=imu_type,
            gyro_zero_corr=gyro_zero_corr,
            gyro_zero_corr_raw=gyro_zero_corr_raw,
            gyro_zero_heading_corr=gyro_zero_heading_corr,
            gyro_zero_heading_corr_raw=gyro_zero_heading_corr_raw,
            tail=tail,
        )


class ExtImuDebugInfo(Message):
    """State of the attitude estimation and of the external IMU.

    CMD_EXT_IMU_DEBUG_INFO (106), from the board; 74 bytes, and later firmware may append more.
    Since firmware 2.66. Source: Later firmware.
    """

    __slots__ = ()

    ahrs_debug_info: Field[AhrsDebugInfo, AhrsDebugInfo] = Field(GroupOf(AhrsDebugInfo))
    """State of the attitude estimation."""
    dcm: Field[Elements[float], Iterable[float]] = Field(ListOf(REAL))
    """Attitude as a rotation matrix, row by row."""
    acc_body: Field[Elements[float], Iterable[float]] = Field(ListOf(REAL))
    """Acceleration of the sensor."""

    def __init__(
        self,
        *,
        ahrs_debug_info: AhrsDebugInfo = UNSET,
        dcm: Iterable[float] = UNSET,
        acc_body: Iterable[float] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(ahrs_debug_info=ahrs_debug_info, dcm=dcm, acc_body=acc_body, tail=tail)


class ExtImuDebugInfoRequest(Request["ExtImuDebugInfo"]):
    """Request the state of the attitude estimation and of the external IMU.

    CMD_EXT_IMU_DEBUG_INFO (106), to the board; 0 bytes. Effect: reads. Since firmware 2.66.
    Source: Later firmware.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class ExtImuCmd(Request["Optional[Confirm]"]):
    """A message of the external IMU.

    CMD_EXT_IMU_CMD (110), in both directions; 1 to 255 bytes. Since firmware 2.60. Source:
    Later firmware.
    """

    __slots__ = ()

    cmd_id: Field[int, int] = Field(RAW)
    """Command of the external IMU."""
    data: Field[bytes, Bytes] = Field(BYTES)
    """Body of the command."""

    def __init__(self, *, cmd_id: int = UNSET, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(cmd_id=cmd_id, data=data, tail=tail)


class ExtSensCmd(Message):
    """A message of the external sensor.

    CMD_EXT_SENS_CMD (150), from the board; 1 to 255 bytes. Since firmware 2.68b7, board 3.6.
    Unconfirmed. Source: Later firmware.
    """

    __slots__ = ()

    cmd_id: Field[ExtSensCommand, ExtSensCommand] = Field(ValueOf(ExtSensCommand))
    """Command of the sensor."""
    data: Field[bytes, Bytes] = Field(BYTES)
    """Body of the command."""

    def __init__(
        self,
        *,
        cmd_id: ExtSensCommand = UNSET,
        data: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(cmd_id=cmd_id, data=data, tail=tail)


class ExtSensCmdRequest(Request["Optional[Confirm]"]):
    """Forward a command to an external sensor.

    CMD_EXT_SENS_CMD (150), to the board; 2 to 255 bytes. Effect: sets, stores, moves. Since
    firmware 2.68b7, board 3.6. Source: Later firmware.
    """

    __slots__ = ()

    flags: Field[ExtSensOptions, ExtSensOptions] = Field(ValueOf(ExtSensOptions))
    """Options."""
    cmd_id: Field[ExtSensCommand, ExtSensCommand] = Field(ValueOf(ExtSensCommand))
    """Command of the sensor."""
    data: Field[bytes, Bytes] = Field(BYTES)
    """Body of the command."""

    def __init__(
        self,
        *,
        flags: ExtSensOptions = UNSET,
        cmd_id: ExtSensCommand = UNSET,
        data: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(flags=flags, cmd_id=cmd_id, data=data, tail=tail)


class ImuAdvancedCalib(Message):
    """Undocumented body from the board.

    CMD_IMU_ADVANCED_CALIB (115), from the board; 0 to 255 bytes. Since firmware 2.60. Source:
    Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class ImuAdvancedCalibRequest(Request["Optional[Confirm]"]):
    """Undocumented body to the board.

    CMD_IMU_ADVANCED_CALIB (115), to the board; 0 to 255 bytes. Effect: unknown. Since firmware
    2.60. Source: Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)
