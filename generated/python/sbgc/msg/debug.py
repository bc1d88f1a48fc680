# Generated from spec/ by generator/: edit those, then run ./dev generate.
"""Firmware variables that show the state of the system, and copies of the traffic."""

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
    "DebugVarInfo",
    "DebugVars3",
    "DebugVars3Request",
    "DebugVars3RequestSelected",
    "DebugVarsInfo3",
    "DebugVarsInfo3Request",
    "SetDebugPort",
    "SetDebugPortRequest",
]

Bytes = Union[bytes, bytearray, memoryview]


class DebugVarInfo(Structure):
    """The variables."""

    __slots__ = ()
    _home = ("DebugVarsInfo3", "vars[0]")

    var_name: Field[str, str] = Field(TEXT)
    """Name of the variable."""
    var_type: Field[DebugVarType, int] = Field(ValueOf(DebugVarType))
    """Its type."""
    arr_size: Field[int, int] = Field(RAW)
    """Number of elements; no board is known to send arrays. Value 0: a scalar. Value 1: a scalar.
    """

    def __init__(
        self,
        *,
        var_name: str = UNSET,
        var_type: int = UNSET,
        arr_size: int = UNSET,
    ) -> None:
        self._start(var_name=var_name, var_type=var_type, arr_size=arr_size)


class DebugVarsInfo3(Message):
    """Names and types of the debug variables, in the order of CMD_DEBUG_VARS_3.

    CMD_DEBUG_VARS_INFO_3 (253), from the board; 1 to 255 bytes, and later firmware may append
    more. Since board 3.0. Source: Incoming commands L476-L487; Variables L1185-L1189.
    """

    __slots__ = ()

    vars: Field[Elements[DebugVarInfo], Iterable[DebugVarInfo]] = Field(
        ListOf(GroupOf(DebugVarInfo)),
    )
    """The variables."""

    def __init__(self, *, vars: Iterable[DebugVarInfo] = UNSET, tail: Bytes = UNSET) -> None:
        self._start(vars=vars, tail=tail)


class DebugVarsInfo3Request(Request["DebugVarsInfo3"]):
    """Request the names and types of the debug variables.

    CMD_DEBUG_VARS_INFO_3 (253), to the board; 0 or 1 byte. Effect: reads. Since board 3.0.
    Source: Outgoing commands L847.
    """

    __slots__ = ()

    start_idx: Field[Optional[int], Optional[int]] = Field(RAW, optional=True)
    """First variable to describe, if there are several pages; the last one is empty. Since firmware
    2.72; before, the body ends here.
    """

    def __init__(self, *, start_idx: Optional[int] = UNSET, tail: Bytes = UNSET) -> None:
        self._start(start_idx=start_idx, tail=tail)


class DebugVars3(Message):
    """Values of the debug variables.

    CMD_DEBUG_VARS_3 (254), from the board; 0 to 255 bytes, and later firmware may append more.
    Since board 3.0. Source: Incoming commands L489-L499.
    """

    __slots__ = ()

    var_value: Field[Elements[float], Iterable[float]] = Field(ListOf(REAL))
    """The values in sequence, each with the type and the number of elements announced by
    CMD_DEBUG_VARS_INFO_3. The set of variables depends on the firmware.
    """

    def __init__(self, *, var_value: Iterable[float] = UNSET, tail: Bytes = UNSET) -> None:
        self._start(var_value=var_value, tail=tail)


class DebugVars3Request(Request["DebugVars3"]):
    """Request the values of the debug variables.

    CMD_DEBUG_VARS_3 (254), to the board, simple form; 0 bytes. Effect: reads. Since board 3.0.
    Source: Outgoing commands L849.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class DebugVars3RequestSelected(Request["None"]):
    """Request the values of selected debug variables.

    The response begins with the same masks; then come the values of the selected variables.
    Nothing in it tells it from the response with all values, so it is to be read as bytes.

    CMD_DEBUG_VARS_3 (254), to the board, selected form; 4 to 32 bytes. Effect: reads. Since
    firmware 2.72. Source: Outgoing commands L849.
    """

    __slots__ = ()

    selected_mask: Field[Elements[int], Iterable[int]] = Field(ListOf(RAW))
    """Bits of the selected variables, starting with the first variable. At least 1. At most 8."""

    def __init__(self, *, selected_mask: Iterable[int] = UNSET, tail: Bytes = UNSET) -> None:
        self._start(selected_mask=selected_mask, tail=tail)


class SetDebugPort(Message):
    """Copy of a message on another port of the board.

    CMD_SET_DEBUG_PORT (249), from the board; 4 to 255 bytes. Since firmware 2.60. Source: Later
    firmware.
    """

    __slots__ = ()

    time_ms: Field[float, float] = Field(REAL)
    """Time since the board started. Unit: ms."""
    time_ms_raw: Field[int, int] = Field(RAW, of="time_ms")
    """The number on the wire for time_ms."""
    port_and_dir: Field[DebugPortLine, int] = Field(ValueOf(DebugPortLine))
    """Port and direction of the message."""
    cmd_id: Field[int, int] = Field(RAW)
    """Command of the message."""
    payload: Field[bytes, Bytes] = Field(BYTES)
    """Body of the message."""

    def __init__(
        self,
        *,
        time_ms: float = UNSET,
        time_ms_raw: int = UNSET,
        port_and_dir: int = UNSET,
        cmd_id: int = UNSET,
        payload: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            time_ms=time_ms,
            time_ms_raw=time_ms_raw,
            port_and_dir=port_and_dir,
            cmd_id=cmd_id,
            payload=payload,
            tail=tail,
        )


class SetDebugPortRequest(Request["Confirm"]):
    """Start or stop the copies of the messages on the board's other ports.

    CMD_SET_DEBUG_PORT (249), to the board; 16 bytes. Effect: sets. Since firmware 2.60. Source:
    Later firmware.
    """

    __slots__ = ()

    action: Field[DebugPortAction, DebugPortAction] = Field(ValueOf(DebugPortAction))
    """Operation."""
    cmd_filter: Field[DebugPortCommands, DebugPortCommands] = Field(ValueOf(DebugPortCommands))
    """Messages that are not copied."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        action: DebugPortAction = UNSET,
        cmd_filter: DebugPortCommands = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(action=action, cmd_filter=cmd_filter, reserved=reserved, tail=tail)
