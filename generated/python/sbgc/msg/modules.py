# Generated from spec/ by generator/: edit those, then run ./dev generate.
"""Modules on the board's CAN bus, and connections through the board."""

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
    "CanDevice",
    "CanDeviceScan",
    "CanDeviceScanRequest",
    "ModuleFlashFinish",
    "ModuleFlashStart",
    "ModuleFlashWrite",
    "ModuleInfo",
    "ModuleList",
    "ModuleListRequest",
    "SerialProxy",
    "SerialProxyRequest",
    "SetDeviceAddr",
    "SetDeviceAddrRequest",
    "SetTranspProxy",
    "TransparentSapi",
    "TransparentSapiRequest",
    "UartBypass",
    "UartBypassRequest",
    "UdrvDeviceScan",
]

Bytes = Union[bytes, bytearray, memoryview]


class ModuleInfo(Structure):
    """The modules."""

    __slots__ = ()
    _home = ("ModuleList", "modules[0]")

    id: Field[ModuleId, ModuleId] = Field(ValueOf(ModuleId))
    """The module."""
    board_ver: Field[ModuleVersion, int] = Field(ValueOf(ModuleVersion))
    """Hardware version."""
    bootloader_ver: Field[ModuleVersion, int] = Field(ValueOf(ModuleVersion))
    """Version of the bootloader."""
    firmware_ver: Field[ModuleVersion, int] = Field(ValueOf(ModuleVersion))
    """Firmware version."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        id: ModuleId = UNSET,
        board_ver: int = UNSET,
        bootloader_ver: int = UNSET,
        firmware_ver: int = UNSET,
        reserved: Bytes = UNSET,
    ) -> None:
        self._start(
            id=id,
            board_ver=board_ver,
            bootloader_ver=bootloader_ver,
            firmware_ver=firmware_ver,
            reserved=reserved,
        )


class CanDevice(Structure):
    """The devices."""

    __slots__ = ()
    _home = ("CanDeviceScan", "devices[0]")

    uid: Field[bytes, Bytes] = Field(BYTES)
    """Identifies the device."""
    id: Field[CanDeviceId, CanDeviceId] = Field(ValueOf(CanDeviceId))
    """Id assigned to the device."""
    type: Field[CanDeviceType, int] = Field(ValueOf(CanDeviceType))
    """Kind of the device."""

    def __init__(self, *, uid: Bytes = UNSET, id: CanDeviceId = UNSET, type: int = UNSET) -> None:
        self._start(uid=uid, id=id, type=type)


class ModuleList(Message):
    """Modules connected to the board.

    CMD_MODULE_LIST (76), from the board; 1 to 222 bytes, and later firmware may append more.
    Since firmware 2.60. Source: Later firmware.
    """

    __slots__ = ()

    modules: Field[Elements[ModuleInfo], Iterable[ModuleInfo]] = Field(ListOf(GroupOf(ModuleInfo)))
    """The modules."""

    def __init__(self, *, modules: Iterable[ModuleInfo] = UNSET, tail: Bytes = UNSET) -> None:
        self._start(modules=modules, tail=tail)


class ModuleListRequest(Request["ModuleList"]):
    """Request the list of the modules connected to the board.

    CMD_MODULE_LIST (76), to the board; 0 bytes. Effect: reads. Since firmware 2.60. Source:
    Later firmware.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class CanDeviceScan(Message):
    """Devices on the CAN bus.

    CMD_CAN_DEVICE_SCAN (96), from the board; 0 to 252 bytes. Since firmware 2.60. Source: Later
    firmware.
    """

    __slots__ = ()

    devices: Field[Elements[CanDevice], Iterable[CanDevice]] = Field(ListOf(GroupOf(CanDevice)))
    """The devices. At most 18."""

    def __init__(self, *, devices: Iterable[CanDevice] = UNSET, tail: Bytes = UNSET) -> None:
        self._start(devices=devices, tail=tail)


class CanDeviceScanRequest(Request["CanDeviceScan"]):
    """Search for devices on the CAN bus.

    Without devices the answer is empty.

    CMD_CAN_DEVICE_SCAN (96), to the board; 0 bytes. Effect: reads. Since firmware 2.60. Source:
    Later firmware.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class TransparentSapi(Message):
    """Data from a serial port of a device on the CAN bus.

    CMD_TRANSPARENT_SAPI (151), from the board; 1 to 255 bytes. Since firmware 2.72, board 3.6.
    Source: Later firmware.
    """

    __slots__ = ()

    target: Field[TransparentTarget, int] = Field(ValueOf(TransparentTarget))
    """Device and port that sent the data. Unconfirmed."""
    payload: Field[bytes, Bytes] = Field(BYTES)
    """The data."""

    def __init__(self, *, target: int = UNSET, payload: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(target=target, payload=payload, tail=tail)


class TransparentSapiRequest(Request["None"]):
    """Send data to a serial port of a device on the CAN bus.

    The effect is that of the data. The device's own data come at any time.

    CMD_TRANSPARENT_SAPI (151), to the board; 1 to 255 bytes. Effect: sets, stores, moves,
    restarts, erases. Since firmware 2.72, board 3.6. Source: Later firmware.
    """

    __slots__ = ()

    target: Field[TransparentTarget, int] = Field(ValueOf(TransparentTarget))
    """Device and port that receive the data. Unconfirmed."""
    payload: Field[bytes, Bytes] = Field(BYTES)
    """The data."""

    def __init__(self, *, target: int = UNSET, payload: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(target=target, payload=payload, tail=tail)


class ModuleFlashStart(Request["Confirm"]):
    """Begin to load new firmware into a module.

    It is the module that restarts, to take its firmware; what it drives has no power meanwhile.
    CMD_MODULE_FLASH_WRITE and CMD_MODULE_FLASH_FINISH follow. Errors of the three commands
    carry the module and the packet, two u16, in ERROR_DATA.

    CMD_MODULE_FLASH_START (78), to the board; 5 bytes. Effect: restarts, erases. Since firmware
    2.74.5. Source: Vendor's code of 2026.
    """

    __slots__ = ()

    device_id: Field[ModuleId, ModuleId] = Field(ValueOf(ModuleId))
    """The module."""
    firmware_size: Field[float, float] = Field(REAL)
    """Size of the file. Range: 4 to 1.71799e+10 byte."""
    firmware_size_raw: Field[int, int] = Field(RAW, of="firmware_size")
    """The number on the wire for firmware_size."""

    def __init__(
        self,
        *,
        device_id: ModuleId = UNSET,
        firmware_size: float = UNSET,
        firmware_size_raw: int = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            device_id=device_id,
            firmware_size=firmware_size,
            firmware_size_raw=firmware_size_raw,
            tail=tail,
        )


class ModuleFlashWrite(Request["Confirm"]):
    """Load a part of new firmware into a module.

    A host waits for the confirmation before the next part, and never repeats a part.

    CMD_MODULE_FLASH_WRITE (81), to the board; 14 to 138 bytes. Effect: stores. Since firmware
    2.74.5. Source: Vendor's code of 2026.
    """

    __slots__ = ()

    device_id: Field[ModuleId, ModuleId] = Field(ValueOf(ModuleId))
    """The module."""
    packet_id: Field[int, int] = Field(RAW)
    """Number of the part from 0, modulo 256."""
    address: Field[int, int] = Field(RAW)
    """Offset of the part in the file. A multiple of 4."""
    data_crc32: Field[int, int] = Field(RAW)
    """CRC-32/ISO-HDLC of DATA, as in a zip file."""
    data: Field[bytes, Bytes] = Field(BYTES)
    """The part. At least 4. At most 128. A multiple of 4."""

    def __init__(
        self,
        *,
        device_id: ModuleId = UNSET,
        packet_id: int = UNSET,
        address: int = UNSET,
        data_crc32: int = UNSET,
        data: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            device_id=device_id,
            packet_id=packet_id,
            address=address,
            data_crc32=data_crc32,
            data=data,
            tail=tail,
        )


class ModuleFlashFinish(Request["Confirm"]):
    """End the loading of firmware into a module.

    CMD_MODULE_FLASH_FINISH (83), to the board; 5 bytes. Effect: stores. Since firmware 2.74.5.
    Source: Vendor's code of 2026.
    """

    __slots__ = ()

    device_id: Field[ModuleId, ModuleId] = Field(ValueOf(ModuleId))
    """The module."""
    file_crc32: Field[int, int] = Field(RAW)
    """CRC-32/ISO-HDLC of the whole file."""

    def __init__(
        self,
        *,
        device_id: ModuleId = UNSET,
        file_crc32: int = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(device_id=device_id, file_crc32=file_crc32, tail=tail)


class UdrvDeviceScan(Request["CanDeviceScan"]):
    """Search for uDrv modules and give them ids.

    The board detects the connection of the IMU and stores the ids that it assigns.

    CMD_UDRV_DEVICE_SCAN (144), to the board; 0 bytes. Effect: stores. Since firmware 2.74.5.
    Source: Vendor's code of 2026.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class SetTranspProxy(Request["None"]):
    """Connect two serial ports of the board.

    Afterwards each port passes its bytes to the other one and no longer speaks this protocol.
    No source says how to end that. There is no response; an error is possible. The ports must
    differ, and be enabled for this protocol.

    CMD_SET_TRANSP_PROXY (143), to the board; 2 bytes. Effect: sets, disconnects. Since firmware
    2.74.5. Source: Vendor's code of 2026.
    """

    __slots__ = ()

    THIS_PORT: ClassVar[int] = 0
    """For port1 and port2, as raw value: the port of this request."""
    port1: Field[int, int] = Field(RAW)
    """A port; the first is 1. Value 0: the port of this request."""
    port2: Field[int, int] = Field(RAW)
    """Another port. Value 0: the port of this request."""

    def __init__(self, *, port1: int = UNSET, port2: int = UNSET, tail: Bytes = UNSET) -> None:
        self._start(port1=port1, port2=port2, tail=tail)


class UartBypass(Message):
    """Undocumented body from the board.

    CMD_UART_BYPASS (60), from the board; 0 to 255 bytes. Since firmware 2.50, board 3.0.
    Unconfirmed. Source: Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class UartBypassRequest(Request["Optional[Confirm]"]):
    """Undocumented body to the board.

    CMD_UART_BYPASS (60), to the board; 0 to 255 bytes. Effect: unknown. Since firmware 2.50,
    board 3.0. Unconfirmed. Source: Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class SetDeviceAddr(Message):
    """Undocumented body from the board.

    CMD_SET_DEVICE_ADDR (107), from the board; 0 to 255 bytes. Since firmware 2.60. Source:
    Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class SetDeviceAddrRequest(Request["Optional[Confirm]"]):
    """Undocumented body to the board.

    CMD_SET_DEVICE_ADDR (107), to the board; 0 to 255 bytes. Effect: unknown. Since firmware
    2.60. Source: Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class SerialProxy(Message):
    """Undocumented body from the board.

    CMD_SERIAL_PROXY (113), from the board; 0 to 255 bytes. Since firmware 2.60. Source: Later
    firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class SerialProxyRequest(Request["Optional[Confirm]"]):
    """Undocumented body to the board.

    CMD_SERIAL_PROXY (113), to the board; 0 to 255 bytes. Effect: unknown. Since firmware 2.60.
    Source: Later firmware.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """Undocumented content."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)
