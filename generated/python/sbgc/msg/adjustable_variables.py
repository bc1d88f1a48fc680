# Generated from spec/ by generator/: edit those, then run ./dev generate.
"""Parameters that can be changed on the fly, without saving them."""

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
    "AdjVarFloat",
    "AdjVarInfo",
    "AdjVarsInfo",
    "AdjVarsInfoRequest",
    "AdjVarsInfoRequestAll",
    "AdjVarsState",
    "AdjVarsStateExt",
    "AdjVarsStateRequest",
    "AdjVarsStateRequestExt",
    "AdjVarValue",
    "AnalogSlot",
    "GetAdjVarsVal",
    "GetAdjVarsValF",
    "ReadAdjVarsCfg",
    "ReadAdjVarsCfgRequest",
    "SetAdjVarsVal",
    "SetAdjVarsValF",
    "TriggerSlot",
    "WriteAdjVarsCfg",
]

Bytes = Union[bytes, bytearray, memoryview]


class AdjVarValue(Structure):
    """One adjustable variable and its value."""

    __slots__ = ()
    _home = ("SetAdjVarsVal", "params[0]")

    param_id: Field[VariableId, VariableId] = Field(ValueOf(VariableId))
    """The variable (Appendix B)."""
    param_value: Field[float, float] = Field(REAL)
    """The value, extended to 32 bits whatever the type of the variable."""
    param_value_raw: Field[int, int] = Field(RAW, of="param_value")
    """The number on the wire for param_value."""

    def __init__(
        self,
        *,
        param_id: VariableId = UNSET,
        param_value: float = UNSET,
        param_value_raw: int = UNSET,
    ) -> None:
        self._start(param_id=param_id, param_value=param_value, param_value_raw=param_value_raw)


class TriggerSlot(Structure):
    """RC signals that trigger actions; the range of a signal is split into five levels."""

    __slots__ = ()
    _home = ("ReadAdjVarsCfg", "trigger_slots[0]")

    src_ch: Field[RcMap, int] = Field(ValueOf(RcMap))
    """RC signal."""
    action: Field[Elements[MenuCommand], Iterable[MenuCommand]] = Field(
        ListOf(ValueOf(MenuCommand)),
    )
    """Action of each signal level."""

    def __init__(self, *, src_ch: int = UNSET, action: Iterable[MenuCommand] = UNSET) -> None:
        self._start(src_ch=src_ch, action=action)


class AnalogSlot(Structure):
    """RC signals that change adjustable variables."""

    __slots__ = ()
    _home = ("ReadAdjVarsCfg", "analog_slots[0]")

    src_ch: Field[RcMap, int] = Field(ValueOf(RcMap))
    """RC signal."""
    param_id: Field[VariableId, VariableId] = Field(ValueOf(VariableId))
    """Variable to change (Appendix B)."""
    min_val: Field[int, int] = Field(RAW)
    """Start of the working range, as a fraction of the variable's range."""
    max_val: Field[int, int] = Field(RAW)
    """End of the working range, as a fraction of the variable's range."""

    def __init__(
        self,
        *,
        src_ch: int = UNSET,
        param_id: VariableId = UNSET,
        min_val: int = UNSET,
        max_val: int = UNSET,
    ) -> None:
        self._start(src_ch=src_ch, param_id=param_id, min_val=min_val, max_val=max_val)


class AdjVarInfo(Structure):
    """Name, range and value of one adjustable variable."""

    __slots__ = ()
    _home = ("AdjVarsInfo", "vars[0]")

    var_id: Field[VariableId, VariableId] = Field(ValueOf(VariableId))
    """The variable."""
    name: Field[str, str] = Field(TEXT)
    """Its name, at most 16 characters."""
    range_min: Field[int, int] = Field(RAW)
    """Its lowest value."""
    range_max: Field[int, int] = Field(RAW)
    """Its highest value."""
    value: Field[float, float] = Field(REAL)
    """Its value."""
    value_raw: Field[int, int] = Field(RAW, of="value")
    """The number on the wire for value."""

    def __init__(
        self,
        *,
        var_id: VariableId = UNSET,
        name: str = UNSET,
        range_min: int = UNSET,
        range_max: int = UNSET,
        value: float = UNSET,
        value_raw: int = UNSET,
    ) -> None:
        self._start(
            var_id=var_id,
            name=name,
            range_min=range_min,
            range_max=range_max,
            value=value,
            value_raw=value_raw,
        )


class AdjVarFloat(Structure):
    """One adjustable variable and its value in floating point."""

    __slots__ = ()
    _home = ("SetAdjVarsValF", "params[0]")

    id: Field[VariableId, VariableId] = Field(ValueOf(VariableId))
    """The variable (Appendix B)."""
    value: Field[float, float] = Field(REAL)
    """The value."""

    def __init__(self, *, id: VariableId = UNSET, value: float = UNSET) -> None:
        self._start(id=id, value=value)


class SetAdjVarsVal(Request["Confirm"]):
    """Values of adjustable variables.

    CMD_SET_ADJ_VARS_VAL (31), in both directions; 1 to 201 bytes, and later firmware may append
    more. Since board 3.0. Source: Incoming commands L505-L507.
    """

    __slots__ = ()

    params: Field[Elements[AdjVarValue], Iterable[AdjVarValue]] = Field(
        ListOf(GroupOf(AdjVarValue)),
    )
    """The variables."""

    def __init__(self, *, params: Iterable[AdjVarValue] = UNSET, tail: Bytes = UNSET) -> None:
        self._start(params=params, tail=tail)


class GetAdjVarsVal(Request["SetAdjVarsVal"]):
    """Request the values of adjustable variables.

    CMD_GET_ADJ_VARS_VAL (64), to the board; 1 to 41 bytes. Effect: reads. Since board 3.0.
    Source: Outgoing commands L793-L802; Variables L1174-L1176.
    """

    __slots__ = ()

    param_id: Field[Elements[VariableId], Iterable[VariableId]] = Field(ListOf(ValueOf(VariableId)))
    """The variables (Appendix B)."""

    def __init__(self, *, param_id: Iterable[VariableId] = UNSET, tail: Bytes = UNSET) -> None:
        self._start(param_id=param_id, tail=tail)


class ReadAdjVarsCfg(Message):
    """RC signals that trigger actions or change adjustable variables.

    CMD_READ_ADJ_VARS_CFG (43), from the board; 128 bytes, and later firmware may append more.
    Since board 3.0. Source: Incoming commands L509-L535.
    """

    __slots__ = ()

    trigger_slots: Field[Elements[TriggerSlot], Iterable[TriggerSlot]] = Field(
        ListOf(GroupOf(TriggerSlot)),
    )
    """RC signals that trigger actions; the range of a signal is split into five levels."""
    analog_slots: Field[Elements[AnalogSlot], Iterable[AnalogSlot]] = Field(
        ListOf(GroupOf(AnalogSlot)),
    )
    """RC signals that change adjustable variables."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        trigger_slots: Iterable[TriggerSlot] = UNSET,
        analog_slots: Iterable[AnalogSlot] = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            trigger_slots=trigger_slots,
            analog_slots=analog_slots,
            reserved=reserved,
            tail=tail,
        )


class ReadAdjVarsCfgRequest(Request["ReadAdjVarsCfg"]):
    """Request the RC signals that trigger actions or change adjustable variables.

    CMD_READ_ADJ_VARS_CFG (43), to the board; 0 bytes. Effect: reads. Since board 3.0. Source:
    Outgoing commands L867-L869.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class AdjVarsState(Message):
    """Current state of one trigger slot and one analog slot.

    The response to the 2-byte request. That to the 7-byte request has the same size: the
    request decides.

    CMD_ADJ_VARS_STATE (46), from the board, simple form; 15 bytes, and later firmware may
    append more. Since board 3.0. Source: Incoming commands L592-L598; Variables L1228-L1232.
    """

    __slots__ = ()

    trigger_rc_data: Field[float, float] = Field(REAL)
    """RC signal of the trigger slot. Range: -1 to 1."""
    trigger_rc_data_raw: Field[int, int] = Field(RAW, of="trigger_rc_data")
    """The number on the wire for trigger_rc_data."""
    trigger_action: Field[MenuCommand, MenuCommand] = Field(ValueOf(MenuCommand))
    """Action that the slot triggered."""
    analog_rc_data: Field[float, float] = Field(REAL)
    """RC signal of the analog slot. Range: -1 to 1."""
    analog_rc_data_raw: Field[int, int] = Field(RAW, of="analog_rc_data")
    """The number on the wire for analog_rc_data."""
    analog_value: Field[int, int] = Field(RAW)
    """Value of the variable, in its own units."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        trigger_rc_data: float = UNSET,
        trigger_rc_data_raw: int = UNSET,
        trigger_action: MenuCommand = UNSET,
        analog_rc_data: float = UNSET,
        analog_rc_data_raw: int = UNSET,
        analog_value: int = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            trigger_rc_data=trigger_rc_data,
            trigger_rc_data_raw=trigger_rc_data_raw,
            trigger_action=trigger_action,
            analog_rc_data=analog_rc_data,
            analog_rc_data_raw=analog_rc_data_raw,
            analog_value=analog_value,
            reserved=reserved,
            tail=tail,
        )


class AdjVarsStateExt(Message):
    """Current state of a trigger slot, two RC signals and two variables.

    The response to the 7-byte request. That to the 2-byte request has the same size: the
    request decides.

    CMD_ADJ_VARS_STATE (46), from the board, extended form; 15 bytes, and later firmware may
    append more. Since firmware 2.62b5. Source: Later firmware.
    """

    __slots__ = ()

    trigger_rc_data: Field[float, float] = Field(REAL)
    """RC signal of the trigger slot. Range: -1 to 1."""
    trigger_rc_data_raw: Field[int, int] = Field(RAW, of="trigger_rc_data")
    """The number on the wire for trigger_rc_data."""
    trigger_action: Field[MenuCommand, MenuCommand] = Field(ValueOf(MenuCommand))
    """Action that the slot triggered."""
    analog_src_value: Field[float, float] = Field(REAL)
    """RC signal of ANALOG_SRC_ID. Range: -1 to 1."""
    analog_src_value_raw: Field[int, int] = Field(RAW, of="analog_src_value")
    """The number on the wire for analog_src_value."""
    analog_var_value: Field[float, float] = Field(REAL)
    """Value of ANALOG_VAR_ID, in its own units."""
    lut_src_value: Field[float, float] = Field(REAL)
    """RC signal of LUT_SRC_ID. Range: -1 to 1."""
    lut_src_value_raw: Field[int, int] = Field(RAW, of="lut_src_value")
    """The number on the wire for lut_src_value."""
    lut_var_value: Field[float, float] = Field(REAL)
    """Value of LUT_VAR_ID, in its own units."""

    def __init__(
        self,
        *,
        trigger_rc_data: float = UNSET,
        trigger_rc_data_raw: int = UNSET,
        trigger_action: MenuCommand = UNSET,
        analog_src_value: float = UNSET,
        analog_src_value_raw: int = UNSET,
        analog_var_value: float = UNSET,
        lut_src_value: float = UNSET,
        lut_src_value_raw: int = UNSET,
        lut_var_value: float = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            trigger_rc_data=trigger_rc_data,
            trigger_rc_data_raw=trigger_rc_data_raw,
            trigger_action=trigger_action,
            analog_src_value=analog_src_value,
            analog_src_value_raw=analog_src_value_raw,
            analog_var_value=analog_var_value,
            lut_src_value=lut_src_value,
            lut_src_value_raw=lut_src_value_raw,
            lut_var_value=lut_var_value,
            tail=tail,
        )


class AdjVarsStateRequest(Request["AdjVarsState"]):
    """Request the state of one trigger slot and one analog slot.

    CMD_ADJ_VARS_STATE (46), to the board, simple form; 2 bytes. Effect: reads. Since board 3.0.
    Source: Outgoing commands L997-L1000.
    """

    __slots__ = ()

    trigger_slot: Field[int, int] = Field(RAW)
    """Trigger slot, counted from 0."""
    analog_slot: Field[int, int] = Field(RAW)
    """Analog slot, counted from 0."""

    def __init__(
        self,
        *,
        trigger_slot: int = UNSET,
        analog_slot: int = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(trigger_slot=trigger_slot, analog_slot=analog_slot, tail=tail)


class AdjVarsStateRequestExt(Request["AdjVarsStateExt"]):
    """Request the state of a trigger slot, two RC signals and two variables.

    CMD_ADJ_VARS_STATE (46), to the board, extended form; 7 bytes. Effect: reads. Since firmware
    2.62b5. Source: Outgoing commands L997-L1000.
    """

    __slots__ = ()

    trigger_slot: Field[int, int] = Field(RAW)
    """Trigger slot, counted from 0. Range: 0 to 9."""
    analog_src_id: Field[int, int] = Field(RAW)
    """RC signal to report."""
    analog_var_id: Field[VariableId, VariableId] = Field(ValueOf(VariableId))
    """Variable to report."""
    lut_src_id: Field[int, int] = Field(RAW)
    """RC signal of a lookup table to report."""
    lut_var_id: Field[VariableId, VariableId] = Field(ValueOf(VariableId))
    """Variable of a lookup table to report."""

    def __init__(
        self,
        *,
        trigger_slot: int = UNSET,
        analog_src_id: int = UNSET,
        analog_var_id: VariableId = UNSET,
        lut_src_id: int = UNSET,
        lut_var_id: VariableId = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            trigger_slot=trigger_slot,
            analog_src_id=analog_src_id,
            analog_var_id=analog_var_id,
            lut_src_id=lut_src_id,
            lut_var_id=lut_var_id,
            tail=tail,
        )


class AdjVarsInfo(Message):
    """Names, ranges and values of adjustable variables.

    CMD_ADJ_VARS_INFO (132), from the board; 1 to 255 bytes. Since firmware 2.73. Rules:
    vars.range_min <= vars.range_max. Source: Later firmware.
    """

    __slots__ = ()

    total_number: Field[int, int] = Field(RAW)
    """Number of variables of the board, of which a message holds a part."""
    vars: Field[Elements[AdjVarInfo], Iterable[AdjVarInfo]] = Field(ListOf(GroupOf(AdjVarInfo)))
    """The variables, from START_ID on."""

    def __init__(
        self,
        *,
        total_number: int = UNSET,
        vars: Iterable[AdjVarInfo] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(total_number=total_number, vars=vars, tail=tail)


class AdjVarsInfoRequest(Request["AdjVarsInfo"]):
    """Request names, ranges and values of adjustable variables.

    CMD_ADJ_VARS_INFO (132), to the board, simple form; 1 byte. Effect: reads. Since firmware
    2.73. Source: Later firmware.
    """

    __slots__ = ()

    start_id: Field[VariableId, VariableId] = Field(ValueOf(VariableId))
    """First variable to describe; for the next page, the last one that came, plus 1. The last page
    is empty.
    """

    def __init__(self, *, start_id: VariableId = UNSET, tail: Bytes = UNSET) -> None:
        self._start(start_id=start_id, tail=tail)


class AdjVarsInfoRequestAll(Request["AdjVarsInfo"]):
    """Request names, ranges and values of adjustable variables, starting with the first.

    CMD_ADJ_VARS_INFO (132), to the board, all form; 0 bytes. Effect: reads. Since firmware
    2.73. Unconfirmed. Source: Later firmware.
    """

    __slots__ = ()


    def __init__(self, *, tail: Bytes = UNSET) -> None:
        self._start(tail=tail)


class SetAdjVarsValF(Request["Confirm"]):
    """Values of adjustable variables in floating point.

    CMD_SET_ADJ_VARS_VAL_F (134), in both directions; 1 to 201 bytes, and later firmware may
    append more. Since firmware 2.73.4. Source: Later firmware.
    """

    __slots__ = ()

    params: Field[Elements[AdjVarFloat], Iterable[AdjVarFloat]] = Field(
        ListOf(GroupOf(AdjVarFloat)),
    )
    """The variables."""

    def __init__(self, *, params: Iterable[AdjVarFloat] = UNSET, tail: Bytes = UNSET) -> None:
        self._start(params=params, tail=tail)


class GetAdjVarsValF(Request["SetAdjVarsValF"]):
    """Request the values of adjustable variables in floating point.

    CMD_GET_ADJ_VARS_VAL_F (135), to the board; 1 to 41 bytes. Effect: reads. Since firmware
    2.73.4. Source: Later firmware.
    """

    __slots__ = ()

    id: Field[Elements[VariableId], Iterable[VariableId]] = Field(ListOf(ValueOf(VariableId)))
    """The variables (Appendix B)."""

    def __init__(self, *, id: Iterable[VariableId] = UNSET, tail: Bytes = UNSET) -> None:
        self._start(id=id, tail=tail)


class WriteAdjVarsCfg(ReadAdjVarsCfg, Request["Confirm"]):
    """Store the RC signals that trigger actions or change adjustable variables.

    CMD_WRITE_ADJ_VARS_CFG (44), to the board; 128 bytes, and later firmware may append more.
    Effect: stores, moves. Since board 3.0. Source: Outgoing commands L871-L875.
    """

    __slots__ = ()
