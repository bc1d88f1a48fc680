# Generated from spec/ by generator/: edit those, then run ./dev generate.
"""Board identity, statistics, confirmations, errors and restarts."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, ClassVar, Optional, Union

from sbgc.fields import BYTES, RAW, REAL, TEXT, Axes, AxesOf, Elements, Field, GroupOf, ListOf
from sbgc.fields import Structure, ValueOf, Xyz
from sbgc.message import Message, Request
from sbgc.msg.enums import *
from sbgc.msg.packed import *
from sbgc.values import UNSET

__all__ = [
    "BoardInfo",
    "BoardInfo3",
    "BoardInfo3Request",
    "BoardInfoRequest",
    "BoardInfoRequestExt",
    "BoardInfoRequestOneByte",
    "BootMode3",
    "BootMode3Ext",
    "Confirm",
    "Error",
    "ErrorExt",
    "ExtLicenseInfo",
    "ExtLicenseInfoRequest",
    "MavlinkDebug",
    "MavlinkDebugRequest",
    "MavlinkInfo",
    "MavlinkInfoRequest",
    "PassProtectRead",
    "PassProtectReadRequest",
    "PassProtectWrite",
    "QueueParamsInfo3",
    "QueueParamsInfo3Request",
    "ReadStateVars",
    "ReadStateVarsRequest",
    "Reset",
    "ResetRequest",
    "ResetRequestExt",
    "SignMessage",
    "SignMessageRequest",
    "SystemState",
    "SystemStateRequest",
    "WriteStateVars",
]

Bytes = Union[bytes, bytearray, memoryview]


class BoardInfo(Message):
    """Board version and features.

    CMD_BOARD_INFO (86), from the board; 18 bytes, and later firmware may append more. Source:
    Incoming commands L158-L166; Variables L1005-L1009.
    """

    __slots__ = ()

    UNKNOWN_FIRMWARE: ClassVar[int] = 0
    """For firmware_ver, as raw value: unknown; the sensors are often unplugged."""
    board_ver: Field[BoardVersion, int] = Field(ValueOf(BoardVersion))
    """Hardware version."""
    firmware_ver: Field[FirmwareVersion, int] = Field(ValueOf(FirmwareVersion))
    """Firmware version. Value 0: unknown; the sensors are often unplugged."""
    debug_mode: Field[BoardStateFlags, BoardStateFlags] = Field(ValueOf(BoardStateFlags))
    """State of the board; before later firmware, only whether debug output is enabled."""
    board_features: Field[BoardFeatures, BoardFeatures] = Field(ValueOf(BoardFeatures))
    """Features of the board."""
    connection_flags: Field[ConnectionFlags, ConnectionFlags] = Field(ValueOf(ConnectionFlags))
    """How this host is connected."""
    frw_extra_id: Field[int, int] = Field(RAW)
    """Identifies special firmware builds."""
    board_features_ext: Field[BoardFeaturesExt, BoardFeaturesExt] = Field(ValueOf(BoardFeaturesExt))
    """More features of the board."""
    main_imu_sens_model: Field[int, int] = Field(RAW)
    """Model of the main IMU's sensor."""
    frame_imu_sens_model: Field[int, int] = Field(RAW)
    """Model of the frame IMU's sensor."""
    build_number: Field[int, int] = Field(RAW)
    """Build of the firmware version."""
    base_frw_ver: Field[FirmwareVersion, int] = Field(ValueOf(FirmwareVersion))
    """Main version on which an experimental version is based."""

    def __init__(
        self,
        *,
        board_ver: int = UNSET,
        firmware_ver: int = UNSET,
        debug_mode: BoardStateFlags = UNSET,
        board_features: BoardFeatures = UNSET,
        connection_flags: ConnectionFlags = UNSET,
        frw_extra_id: int = UNSET,
        board_features_ext: BoardFeaturesExt = UNSET,
        main_imu_sens_model: int = UNSET,
        frame_imu_sens_model: int = UNSET,
        build_number: int = UNSET,
        base_frw_ver: int = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            board_ver=board_ver,
            firmware_ver=firmware_ver,
            debug_mode=debug_mode,
            board_features=board_features,
            connection_flags=connection_flags,
            frw_extra_id=frw_extra_id,
            board_features_ext=board_features_ext,
            main_imu_sens_model=main_imu_sens_model,
            frame_imu_sens_model=frame_imu_sens_model,
            build_number=build_number,
            base_frw_ver=base_frw_ver,
            tail=tail,
        )


class BoardInfoRequest(Request["BoardInfo"]):
    """Request the board and firmware version.

    CMD_BOARD_INFO (86), to the board, simple form; 0 bytes. Effect: reads. Source: Outgoing
    commands L602-L611.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class BoardInfoRequestOneByte(Request["BoardInfo"]):
    """Request the board and firmware version, with a byte that has no meaning.

    CMD_BOARD_INFO (86), to the board, one_byte form; 1 byte. Effect: reads. Source: Outgoing
    commands L602-L611.
    """

    __slots__ = ()

    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(self, *, reserved: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(reserved=reserved, tail=tail)


class BoardInfoRequestExt(Request["BoardInfo"]):
    """Request the board and firmware version, and configure this serial port.

    On a port with a password, nothing else is answered before a request with it.

    CMD_BOARD_INFO (86), to the board, extended form; 2 to 255 bytes. Effect: sets. Source:
    Outgoing commands L602-L611.
    """

    __slots__ = ()

    cfg: Field[float, float] = Field(REAL)
    """On a UART, the pause between the 20-byte packets of a Bluetooth LE link; no meaning on USB.
    Unit: ms.
    """
    cfg_raw: Field[int, int] = Field(RAW, of="cfg")
    """The number on the wire for cfg."""
    password: Field[Optional[str], Optional[str]] = Field(TEXT, optional=True)
    """Opens a port with a password, from firmware 2.73.6 on."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        cfg: float = UNSET,
        cfg_raw: int = UNSET,
        password: Optional[str] = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(cfg=cfg, cfg_raw=cfg_raw, password=password, reserved=reserved, tail=tail)


class Confirm(Message):
    """The board executed a command.

    CMD_CONFIRM (67), from the board; 1 to 6 bytes. Source: Incoming commands L412-L419.
    """

    __slots__ = ()

    PIN_UNAVAILABLE: ClassVar[int] = -1
    """For pin_state, as raw value: the pin is unavailable."""
    cmd: Field[CommandToBoard, CommandToBoard] = Field(ValueOf(CommandToBoard))
    """The confirmed command."""
    addr: Field[Optional[int], Optional[int]] = Field(RAW, optional=True)
    """Address of the written block. Present if cmd is CMD_EEPROM_WRITE."""
    err_code: Field[Optional[FileError], Optional[FileError]] = Field(
        ValueOf(FileError),
        optional=True,
    )
    """Result of the file operation. Present if cmd is CMD_WRITE_FILE or CMD_FS_CLEAR_ALL."""
    pin_id: Field[Optional[OutputPin], Optional[OutputPin]] = Field(
        ValueOf(OutputPin),
        optional=True,
    )
    """The pin that became an input. Present if cmd is CMD_TRIGGER_PIN."""
    pin_state: Field[Optional[int], Optional[int]] = Field(RAW, optional=True)
    """Its level. Range: 0 to 1. Value -1: the pin is unavailable. Present if cmd is
    CMD_TRIGGER_PIN.
    """
    data: Field[bytes, Bytes] = Field(BYTES)
    """Data of other commands; usually empty, or 0 for success. At most 5."""

    def __init__(
        self,
        *,
        cmd: CommandToBoard = UNSET,
        addr: Optional[int] = UNSET,
        err_code: Optional[FileError] = UNSET,
        pin_id: Optional[OutputPin] = UNSET,
        pin_state: Optional[int] = UNSET,
        data: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            cmd=cmd,
            addr=addr,
            err_code=err_code,
            pin_id=pin_id,
            pin_state=pin_state,
            data=data,
            tail=tail,
        )


class Error(Message):
    """An error as the specification describes it.

    CMD_ERROR (255), from the board, simple form; 5 bytes. Since board 3.0. Source: Incoming
    commands L421-L426.
    """

    __slots__ = ()

    error_code: Field[BoardErrorCode, BoardErrorCode] = Field(ValueOf(BoardErrorCode))
    """Error code."""
    error_data: Field[bytes, Bytes] = Field(BYTES)
    """Details that depend on the code."""

    def __init__(
        self,
        *,
        error_code: BoardErrorCode = UNSET,
        error_data: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(error_code=error_code, error_data=error_data, tail=tail)


class ErrorExt(Message):
    """An error as real boards send it, with the failed command.

    CMD_ERROR (255), from the board, extended form; 6 bytes, and later firmware may append more.
    Since board 3.0. Source: Incoming commands L421-L426.
    """

    __slots__ = ()

    cmd_id: Field[CommandToBoard, CommandToBoard] = Field(ValueOf(CommandToBoard))
    """The failed command."""
    error_code: Field[BoardErrorCode, BoardErrorCode] = Field(ValueOf(BoardErrorCode))
    """Error code."""
    error_data: Field[bytes, Bytes] = Field(BYTES)
    """Details that depend on the code."""

    def __init__(
        self,
        *,
        cmd_id: CommandToBoard = UNSET,
        error_code: BoardErrorCode = UNSET,
        error_data: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(cmd_id=cmd_id, error_code=error_code, error_data=error_data, tail=tail)


class BoardInfo3(Message):
    """Serial numbers, memory and scripts of the board.

    CMD_BOARD_INFO_3 (20), from the board; 69 bytes, and later firmware may append more. Since
    board 3.0. Source: Incoming commands L168-L178.
    """

    __slots__ = ()

    EMPTY_SLOT: ClassVar[int] = 0
    """For script_slot_size and script_slot_6_to_10_size, as raw value: the slot is empty."""
    NO_PROFILE_SET: ClassVar[int] = 0
    """For profile_set_cur, as raw value: earlier firmware has no profile sets."""
    device_id: Field[bytes, Bytes] = Field(BYTES)
    """Identifies the board."""
    mcu_id: Field[bytes, Bytes] = Field(BYTES)
    """Identifies the microcontroller."""
    eeprom_size: Field[float, float] = Field(REAL)
    """Size of the EEPROM. Unit: byte."""
    eeprom_size_raw: Field[int, int] = Field(RAW, of="eeprom_size")
    """The number on the wire for eeprom_size."""
    script_slot_size: Field[Elements[float], Iterable[float]] = Field(ListOf(REAL))
    """Size of the user script in each slot. Unit: byte. Raw value 0: the slot is empty."""
    script_slot_size_raw: Field[Elements[int], Iterable[int]] = Field(
        ListOf(RAW),
        of="script_slot_size",
    )
    """The number on the wire for script_slot_size."""
    profile_set_slots: Field[StoredProfileSets, StoredProfileSets] = Field(
        ValueOf(StoredProfileSets),
    )
    """Profile sets in memory."""
    profile_set_cur: Field[int, int] = Field(RAW)
    """Selected profile set; 6 is the backup. Range: 1 to 6. Value 0: earlier firmware has no
    profile sets.
    """
    flash_size: Field[float, float] = Field(REAL)
    """Size of the flash memory. Unit: byte."""
    flash_size_raw: Field[int, int] = Field(RAW, of="flash_size")
    """The number on the wire for flash_size."""
    imu_calib_info: Field[bytes, Bytes] = Field(BYTES)
    """Information about the calibrations of the IMUs."""
    script_slot_6_to_10_size: Field[Elements[float], Iterable[float]] = Field(ListOf(REAL))
    """Size of the user script in each of slots 6 to 10. Unit: byte. Raw value 0: the slot is empty.
    """
    script_slot_6_to_10_size_raw: Field[Elements[int], Iterable[int]] = Field(
        ListOf(RAW),
        of="script_slot_6_to_10_size",
    )
    """The number on the wire for script_slot_6_to_10_size."""
    hw_flags: Field[HardwareFlags, HardwareFlags] = Field(ValueOf(HardwareFlags))
    """Hardware on the board."""
    board_features_ext2: Field[BoardFeaturesExt2, BoardFeaturesExt2] = Field(
        ValueOf(BoardFeaturesExt2),
    )
    """More features of the board. Since firmware 2.73."""
    can_drv_main_limit: Field[int, int] = Field(RAW)
    """Number of licensed CAN motor drivers for the main axes. Since firmware 2.72b3."""
    can_drv_aux_limit: Field[int, int] = Field(RAW)
    """Number of licensed CAN motor drivers for auxiliary motors. Since firmware 2.72b3."""
    adj_vars_total_num: Field[int, int] = Field(RAW)
    """Number of adjustable variables. Since firmware 2.73."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        device_id: Bytes = UNSET,
        mcu_id: Bytes = UNSET,
        eeprom_size: float = UNSET,
        eeprom_size_raw: int = UNSET,
        script_slot_size: Iterable[float] = UNSET,
        script_slot_size_raw: Iterable[int] = UNSET,
        profile_set_slots: StoredProfileSets = UNSET,
        profile_set_cur: int = UNSET,
        flash_size: float = UNSET,
        flash_size_raw: int = UNSET,
        imu_calib_info: Bytes = UNSET,
        script_slot_6_to_10_size: Iterable[float] = UNSET,
        script_slot_6_to_10_size_raw: Iterable[int] = UNSET,
        hw_flags: HardwareFlags = UNSET,
        board_features_ext2: BoardFeaturesExt2 = UNSET,
        can_drv_main_limit: int = UNSET,
        can_drv_aux_limit: int = UNSET,
        adj_vars_total_num: int = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            device_id=device_id,
            mcu_id=mcu_id,
            eeprom_size=eeprom_size,
            eeprom_size_raw=eeprom_size_raw,
            script_slot_size=script_slot_size,
            script_slot_size_raw=script_slot_size_raw,
            profile_set_slots=profile_set_slots,
            profile_set_cur=profile_set_cur,
            flash_size=flash_size,
            flash_size_raw=flash_size_raw,
            imu_calib_info=imu_calib_info,
            script_slot_6_to_10_size=script_slot_6_to_10_size,
            script_slot_6_to_10_size_raw=script_slot_6_to_10_size_raw,
            hw_flags=hw_flags,
            board_features_ext2=board_features_ext2,
            can_drv_main_limit=can_drv_main_limit,
            can_drv_aux_limit=can_drv_aux_limit,
            adj_vars_total_num=adj_vars_total_num,
            reserved=reserved,
            tail=tail,
        )


class BoardInfo3Request(Request["BoardInfo3"]):
    """Request serial numbers, memory and scripts of the board.

    CMD_BOARD_INFO_3 (20), to the board; 0 bytes. Effect: reads. Since board 3.0. Source:
    Outgoing commands L613.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class Reset(Message):
    """The board is about to restart.

    Leaves time to close the serial port: the board restarts 1000 ms later, or after the
    DELAY_MS of the host that requested the restart. It responds again about 5 s later.

    CMD_RESET (114), from the board; 0 bytes, and later firmware may append more. Source:
    Incoming commands L537-L539.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class ResetRequest(Request["None"]):
    """Restart immediately, without notification.

    CMD_RESET (114), to the board, simple form; 0 bytes. Effect: restarts. Source: Outgoing
    commands L670-L677.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class ResetRequestExt(Request["Optional[Reset]"]):
    """Restart after a delay, with an optional notification.

    CMD_RESET (114), to the board, extended form; 3 bytes. Effect: restarts. Source: Outgoing
    commands L670-L677.
    """

    __slots__ = ()

    confirm: Field[ResetOptions, ResetOptions] = Field(ValueOf(ResetOptions))
    """Whether CMD_RESET is sent back first."""
    delay_ms: Field[float, float] = Field(REAL)
    """Delay before the restart. Unit: ms."""
    delay_ms_raw: Field[int, int] = Field(RAW, of="delay_ms")
    """The number on the wire for delay_ms."""

    def __init__(
        self,
        *,
        confirm: ResetOptions = UNSET,
        delay_ms: float = UNSET,
        delay_ms_raw: int = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(confirm=confirm, delay_ms=delay_ms, delay_ms_raw=delay_ms_raw, tail=tail)


class BootMode3(Request["None"]):
    """Enter the bootloader immediately, without notification.

    The bootloader accepts new firmware and none of these commands, and the motors have no
    power. The board may not return on its own: send this only with new firmware at hand.

    CMD_BOOT_MODE_3 (51), to the board, simple form; 0 bytes. Effect: restarts, disconnects.
    Since board 3.0. Source: Outgoing commands L679-L686.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class BootMode3Ext(Request["Optional[Reset]"]):
    """Enter the bootloader after a delay, with an optional notification.

    The bootloader accepts new firmware and none of these commands, and the motors have no
    power. The board may not return on its own: send this only with new firmware at hand.

    CMD_BOOT_MODE_3 (51), to the board, extended form; 3 bytes. Effect: restarts, disconnects.
    Since board 3.0. Source: Outgoing commands L679-L686.
    """

    __slots__ = ()

    confirm: Field[ResetOptions, ResetOptions] = Field(ValueOf(ResetOptions))
    """Whether CMD_RESET is sent back first."""
    delay_ms: Field[float, float] = Field(REAL)
    """Delay before the bootloader starts. Unit: ms."""
    delay_ms_raw: Field[int, int] = Field(RAW, of="delay_ms")
    """The number on the wire for delay_ms."""

    def __init__(
        self,
        *,
        confirm: ResetOptions = UNSET,
        delay_ms: float = UNSET,
        delay_ms_raw: int = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(confirm=confirm, delay_ms=delay_ms, delay_ms_raw=delay_ms_raw, tail=tail)


class ReadStateVars(Message):
    """Statistics of the board's whole life.

    CMD_READ_STATE_VARS (111), from the board; 192 bytes, and later firmware may append more.
    Since firmware 2.68b7, board 3.6. Source: Later firmware.
    """

    __slots__ = ()

    step_signal_val: Field[Elements[int], Iterable[int]] = Field(ListOf(RAW))
    """Current value of each step signal."""
    sub_error: Field[SystemSubError, SystemSubError] = Field(ValueOf(SystemSubError))
    """Reason for the last emergency stop."""
    max_acc: Field[float, float] = Field(REAL)
    """Highest acceleration. Unit: g."""
    max_acc_raw: Field[int, int] = Field(RAW, of="max_acc")
    """The number on the wire for max_acc."""
    work_time: Field[float, float] = Field(REAL)
    """Time in operation. Unit: ms."""
    work_time_raw: Field[int, int] = Field(RAW, of="work_time")
    """The number on the wire for work_time."""
    startup_cnt: Field[int, int] = Field(RAW)
    """Number of starts."""
    max_current: Field[float, float] = Field(REAL)
    """Highest current. Unit: mA."""
    max_current_raw: Field[int, int] = Field(RAW, of="max_current")
    """The number on the wire for max_current."""
    imu_temp_min: Field[float, float] = Field(REAL)
    """Lowest temperature of the IMU. Unit: degC."""
    imu_temp_min_raw: Field[int, int] = Field(RAW, of="imu_temp_min")
    """The number on the wire for imu_temp_min."""
    imu_temp_max: Field[float, float] = Field(REAL)
    """Highest temperature of the IMU. Unit: degC."""
    imu_temp_max_raw: Field[int, int] = Field(RAW, of="imu_temp_max")
    """The number on the wire for imu_temp_max."""
    mcu_temp_min: Field[float, float] = Field(REAL)
    """Lowest temperature of the microcontroller. Unit: degC."""
    mcu_temp_min_raw: Field[int, int] = Field(RAW, of="mcu_temp_min")
    """The number on the wire for mcu_temp_min."""
    mcu_temp_max: Field[float, float] = Field(REAL)
    """Highest temperature of the microcontroller. Unit: degC."""
    mcu_temp_max_raw: Field[int, int] = Field(RAW, of="mcu_temp_max")
    """The number on the wire for mcu_temp_max."""
    shock_cnt: Field[Elements[int], Iterable[int]] = Field(ListOf(RAW))
    """Numbers of shocks."""
    energy_time: Field[float, float] = Field(REAL)
    """Time over which ENERGY is counted. Unit: ms."""
    energy_time_raw: Field[int, int] = Field(RAW, of="energy_time")
    """The number on the wire for energy_time."""
    energy: Field[float, float] = Field(REAL)
    """Energy used. Unit: Wh."""
    energy_raw: Field[float, float] = Field(RAW, of="energy")
    """The number on the wire for energy."""
    avg_current_time: Field[float, float] = Field(REAL)
    """Time over which AVG_CURRENT is averaged. Unit: ms."""
    avg_current_time_raw: Field[int, int] = Field(RAW, of="avg_current_time")
    """The number on the wire for avg_current_time."""
    avg_current: Field[float, float] = Field(REAL)
    """Average current. Unit: mA."""
    avg_current_raw: Field[float, float] = Field(RAW, of="avg_current")
    """The number on the wire for avg_current."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        step_signal_val: Iterable[int] = UNSET,
        sub_error: SystemSubError = UNSET,
        max_acc: float = UNSET,
        max_acc_raw: int = UNSET,
        work_time: float = UNSET,
        work_time_raw: int = UNSET,
        startup_cnt: int = UNSET,
        max_current: float = UNSET,
        max_current_raw: int = UNSET,
        imu_temp_min: float = UNSET,
        imu_temp_min_raw: int = UNSET,
        imu_temp_max: float = UNSET,
        imu_temp_max_raw: int = UNSET,
        mcu_temp_min: float = UNSET,
        mcu_temp_min_raw: int = UNSET,
        mcu_temp_max: float = UNSET,
        mcu_temp_max_raw: int = UNSET,
        shock_cnt: Iterable[int] = UNSET,
        energy_time: float = UNSET,
        energy_time_raw: int = UNSET,
        energy: float = UNSET,
        energy_raw: float = UNSET,
        avg_current_time: float = UNSET,
        avg_current_time_raw: int = UNSET,
        avg_current: float = UNSET,
        avg_current_raw: float = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            step_signal_val=step_signal_val,
            sub_error=sub_error,
            max_acc=max_acc,
            max_acc_raw=max_acc_raw,
            work_time=work_time,
            work_time_raw=work_time_raw,
            startup_cnt=startup_cnt,
            max_current=max_current,
            max_current_raw=max_current_raw,
            imu_temp_min=imu_temp_min,
            imu_temp_min_raw=imu_temp_min_raw,
            imu_temp_max=imu_temp_max,
            imu_temp_max_raw=imu_temp_max_raw,
            mcu_temp_min=mcu_temp_min,
            mcu_temp_min_raw=mcu_temp_min_raw,
            mcu_temp_max=mcu_temp_max,
            mcu_temp_max_raw=mcu_temp_max_raw,
            shock_cnt=shock_cnt,
            energy_time=energy_time,
            energy_time_raw=energy_time_raw,
            energy=energy,
            energy_raw=energy_raw,
            avg_current_time=avg_current_time,
            avg_current_time_raw=avg_current_time_raw,
            avg_current=avg_current,
            avg_current_raw=avg_current_raw,
            reserved=reserved,
            tail=tail,
        )


class ReadStateVarsRequest(Request["ReadStateVars"]):
    """Request the statistics of the board's whole life.

    CMD_READ_STATE_VARS (111), to the board; 0 bytes. Effect: reads. Since firmware 2.68b7,
    board 3.6. Source: Later firmware.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class SignMessage(Message):
    """Signature of a message.

    CMD_SIGN_MESSAGE (50), from the board; 32 bytes, and later firmware may append more. Since
    firmware 2.50, board 3.0. Source: Later firmware.
    """

    __slots__ = ()

    signature: Field[bytes, Bytes] = Field(BYTES)
    """The signature."""

    def __init__(self, *, signature: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(signature=signature, tail=tail)


class SignMessageRequest(Request["SignMessage"]):
    """Sign a message with the keys of the board.

    CMD_SIGN_MESSAGE (50), to the board; 33 bytes. Effect: reads. Since firmware 2.50, board
    3.0. Source: Later firmware.
    """

    __slots__ = ()

    sign_type: Field[int, int] = Field(RAW)
    """Set of keys."""
    message: Field[bytes, Bytes] = Field(BYTES)
    """The message."""

    def __init__(
        self,
        *,
        sign_type: int = UNSET,
        message: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(sign_type=sign_type, message=message, tail=tail)


class PassProtectRead(Message):
    """What a password protects.

    CMD_PASS_PROTECT_READ (136), from the board; 8 bytes, and later firmware may append more.
    Since firmware 2.73.6. Source: Vendor's code of 2026.
    """

    __slots__ = ()

    flags: Field[PassProtectFlags, PassProtectFlags] = Field(ValueOf(PassProtectFlags))
    """What is protected."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        flags: PassProtectFlags = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(flags=flags, reserved=reserved, tail=tail)


class PassProtectReadRequest(Request["PassProtectRead"]):
    """Request what a password protects.

    CMD_PASS_PROTECT_READ (136), to the board; 0 bytes. Effect: reads. Since firmware 2.73.6.
    Source: Vendor's code of 2026.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class PassProtectWrite(Request["Confirm"]):
    """Choose what a password protects.

    CMD_PASS_PROTECT_WRITE (137), to the board; 9 to 41 bytes. Effect: stores. Since firmware
    2.73.6. Source: Vendor's code of 2026.
    """

    __slots__ = ()

    flags: Field[PassProtectFlags, PassProtectFlags] = Field(ValueOf(PassProtectFlags))
    """What is protected."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""
    new_password: Field[str, str] = Field(TEXT)
    """The new password; empty keeps the present one."""

    def __init__(
        self,
        *,
        flags: PassProtectFlags = UNSET,
        reserved: Bytes = UNSET,
        new_password: str = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(flags=flags, reserved=reserved, new_password=new_password, tail=tail)


class QueueParamsInfo3(Message):
    """Undocumented body from the board.

    CMD_QUEUE_PARAMS_INFO_3 (30), from the board; 0 to 255 bytes. Since board 3.0. Source:
    Command ID definitions L108.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class QueueParamsInfo3Request(Request["Optional[Confirm]"]):
    """Undocumented body to the board.

    CMD_QUEUE_PARAMS_INFO_3 (30), to the board; 0 to 255 bytes. Effect: unknown. Since board
    3.0. Source: Command ID definitions L108.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class SystemState(Message):
    """Undocumented body from the board.

    CMD_SYSTEM_STATE (52), from the board; 0 to 255 bytes. Since board 3.0. Source: Command ID
    definitions L130.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class SystemStateRequest(Request["Optional[Confirm]"]):
    """Undocumented body to the board.

    CMD_SYSTEM_STATE (52), to the board; 0 to 255 bytes. Effect: unknown. Since board 3.0.
    Source: Command ID definitions L130.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class MavlinkInfo(Message):
    """Undocumented body from the board.

    CMD_MAVLINK_INFO (250), from the board; 0 to 255 bytes. Since board 3.0. Source: Command ID
    definitions L149.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class MavlinkInfoRequest(Request["Optional[Confirm]"]):
    """Undocumented body to the board.

    CMD_MAVLINK_INFO (250), to the board; 0 to 255 bytes. Effect: unknown. Since board 3.0.
    Source: Command ID definitions L149.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class MavlinkDebug(Message):
    """Undocumented body from the board.

    CMD_MAVLINK_DEBUG (251), from the board; 0 to 255 bytes. Since board 3.0. Source: Command ID
    definitions L150.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class MavlinkDebugRequest(Request["Optional[Confirm]"]):
    """Undocumented body to the board.

    CMD_MAVLINK_DEBUG (251), to the board; 0 to 255 bytes. Effect: unknown. Since board 3.0.
    Source: Command ID definitions L150.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class ExtLicenseInfo(Message):
    """Undocumented body from the board.

    CMD_EXT_LICENSE_INFO (124), from the board; 0 to 255 bytes. Since firmware 2.60.
    Unconfirmed. Source: Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class ExtLicenseInfoRequest(Request["Optional[Confirm]"]):
    """Undocumented body to the board.

    CMD_EXT_LICENSE_INFO (124), to the board; 0 to 255 bytes. Effect: unknown. Since firmware
    2.60. Unconfirmed. Source: Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class WriteStateVars(ReadStateVars, Request["Confirm"]):
    """Store the statistics of the board's whole life.

    Write back what you read, and change only what you need.

    CMD_WRITE_STATE_VARS (112), to the board; 192 bytes, and later firmware may append more.
    Effect: stores. Since firmware 2.68b7, board 3.6. Source: Later firmware.
    """

    __slots__ = ()
