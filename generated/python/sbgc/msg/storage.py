# Generated from spec/ by generator/: edit those, then run ./dev generate.
"""The board's memory: EEPROM, user data and files."""

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
    "EepromRead",
    "EepromReadRequest",
    "EepromWrite",
    "FsClearAll",
    "ReadExternalData",
    "ReadExternalDataRequest",
    "ReadFile",
    "ReadFileError",
    "ReadFileRequest",
    "WriteExternalData",
    "WriteFile",
]

Bytes = Union[bytes, bytearray, memoryview]


class EepromWrite(Request["Confirm"]):
    """Write a block to the EEPROM.

    The EEPROM holds parameters and calibrations. Write only what you read from the same address
    of the same board: anything else may make the board unusable or move the camera. The example
    writes back what the example of CMD_EEPROM_READ reads.

    CMD_EEPROM_WRITE (47), to the board; 4 to 196 bytes. Effect: stores, moves. Since board 3.0.
    Source: Outgoing commands L877-L882.
    """

    __slots__ = ()

    addr: Field[int, int] = Field(RAW)
    """Address to write to. A multiple of 64."""
    data: Field[bytes, Bytes] = Field(BYTES)
    """Data to write. At most 192. A multiple of 64."""

    def __init__(self, *, addr: int = UNSET, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(addr=addr, data=data, tail=tail)


class ReadFile(Message):
    """Part of a file.

    CMD_READ_FILE (53), from the board, success form; 4 to 255 bytes. Since board 3.0. Source:
    Incoming commands L565-L575; Outgoing commands L916-L928.
    """

    __slots__ = ()

    file_size: Field[float, float] = Field(REAL)
    """Size of the whole file. Unit: byte."""
    file_size_raw: Field[int, int] = Field(RAW, of="file_size")
    """The number on the wire for file_size."""
    page_offset: Field[float, float] = Field(REAL)
    """Offset of the data in the file, as in the request. Unit: byte."""
    page_offset_raw: Field[int, int] = Field(RAW, of="page_offset")
    """The number on the wire for page_offset."""
    data: Field[bytes, Bytes] = Field(BYTES)
    """As many bytes as requested, or fewer at the end of the file. At most 251."""

    def __init__(
        self,
        *,
        file_size: float = UNSET,
        file_size_raw: int = UNSET,
        page_offset: float = UNSET,
        page_offset_raw: int = UNSET,
        data: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            file_size=file_size,
            file_size_raw=file_size_raw,
            page_offset=page_offset,
            page_offset_raw=page_offset_raw,
            data=data,
            tail=tail,
        )


class ReadFileError(Message):
    """Why a file could not be read.

    CMD_READ_FILE (53), from the board, error form; 1 byte. Since board 3.0. Source: Incoming
    commands L565-L575; Outgoing commands L916-L928.
    """

    __slots__ = ()

    err_code: Field[FileError, FileError] = Field(ValueOf(FileError))
    """Error code."""

    def __init__(self, *, err_code: FileError = UNSET, tail: Bytes = UNSET) -> None:
        self._start(err_code=err_code, tail=tail)


class ReadFileRequest(Request["ReadFile"]):
    """Read part of a file.

    CMD_READ_FILE (53), to the board; 20 bytes. Effect: reads. Since board 3.0. Source: Outgoing
    commands L898-L905.
    """

    __slots__ = ()

    file_id: Field[int, int] = Field(RAW)
    """File id."""
    page_offset: Field[float, float] = Field(REAL)
    """Start of the block. Unit: byte."""
    page_offset_raw: Field[int, int] = Field(RAW, of="page_offset")
    """The number on the wire for page_offset."""
    max_data_size: Field[float, float] = Field(REAL)
    """Maximum number of bytes to read; they must fit into one message. Range: 0 to 251 byte."""
    max_data_size_raw: Field[int, int] = Field(RAW, of="max_data_size")
    """The number on the wire for max_data_size."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        file_id: int = UNSET,
        page_offset: float = UNSET,
        page_offset_raw: int = UNSET,
        max_data_size: float = UNSET,
        max_data_size_raw: int = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            file_id=file_id,
            page_offset=page_offset,
            page_offset_raw=page_offset_raw,
            max_data_size=max_data_size,
            max_data_size_raw=max_data_size_raw,
            reserved=reserved,
            tail=tail,
        )


class WriteFile(Request["Confirm"]):
    """Write part of a file; without data, delete it.

    CMD_WRITE_FILE (54), to the board; 6 to 255 bytes. Effect: stores, erases. Since board 3.0.
    Source: Outgoing commands L907-L928.
    """

    __slots__ = ()

    file_id: Field[int, int] = Field(RAW)
    """File id; a missing file is created."""
    file_size: Field[float, float] = Field(REAL)
    """Size of the whole file. Unit: byte."""
    file_size_raw: Field[int, int] = Field(RAW, of="file_size")
    """The number on the wire for file_size."""
    page_offset: Field[float, float] = Field(REAL)
    """Start of the block. Unit: byte."""
    page_offset_raw: Field[int, int] = Field(RAW, of="page_offset")
    """The number on the wire for page_offset."""
    data: Field[bytes, Bytes] = Field(BYTES)
    """Data to write; empty deletes the file. At most 249."""

    def __init__(
        self,
        *,
        file_id: int = UNSET,
        file_size: float = UNSET,
        file_size_raw: int = UNSET,
        page_offset: float = UNSET,
        page_offset_raw: int = UNSET,
        data: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            file_id=file_id,
            file_size=file_size,
            file_size_raw=file_size_raw,
            page_offset=page_offset,
            page_offset_raw=page_offset_raw,
            data=data,
            tail=tail,
        )


class FsClearAll(Request["Confirm"]):
    """Delete all files.

    CMD_FS_CLEAR_ALL (55), to the board; 0 bytes. Effect: erases. Since board 3.0. Source:
    Outgoing commands L930-L932.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class EepromRead(Message):
    """A block of the EEPROM.

    CMD_EEPROM_READ (48), from the board; 4 to 196 bytes. Since board 3.0. Source: Incoming
    commands L541-L544.
    """

    __slots__ = ()

    addr: Field[int, int] = Field(RAW)
    """Address of the block. A multiple of 64."""
    data: Field[bytes, Bytes] = Field(BYTES)
    """Content of the block, as many bytes as requested. At most 192."""

    def __init__(self, *, addr: int = UNSET, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(addr=addr, data=data, tail=tail)


class EepromReadRequest(Request["EepromRead"]):
    """Read a block of the EEPROM.

    CMD_EEPROM_READ (48), to the board; 6 bytes. Effect: reads. Since board 3.0. Source:
    Outgoing commands L884-L889.
    """

    __slots__ = ()

    addr: Field[int, int] = Field(RAW)
    """Start of the block. A multiple of 64."""
    size: Field[float, float] = Field(REAL)
    """Number of bytes to read; they must fit into one message. Range: 0 to 192 byte. A multiple of
    64.
    """
    size_raw: Field[int, int] = Field(RAW, of="size")
    """The number on the wire for size."""

    def __init__(
        self,
        *,
        addr: int = UNSET,
        size: float = UNSET,
        size_raw: int = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(addr=addr, size=size, size_raw=size_raw, tail=tail)


class ReadExternalData(Message):
    """User data in the EEPROM.

    CMD_READ_EXTERNAL_DATA (42), from the board; 128 bytes, and later firmware may append more.
    Since board 3.0. Source: Incoming commands L501-L503.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """The user data."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class ReadExternalDataRequest(Request["ReadExternalData"]):
    """Request the user data in the EEPROM.

    CMD_READ_EXTERNAL_DATA (42), to the board; 0 bytes. Effect: reads. Since board 3.0. Source:
    Outgoing commands L855-L857.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class WriteExternalData(ReadExternalData, Request["Optional[Confirm]"]):
    """Store user data in the EEPROM.

    CMD_WRITE_EXTERNAL_DATA (41), to the board; 128 bytes, and later firmware may append more.
    Effect: stores. Since board 3.0. Source: Outgoing commands L851-L853.
    """

    __slots__ = ()
