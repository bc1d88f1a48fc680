# Generated from spec/ by generator/: edit those, then run ./dev generate.
"""User scripts that the board runs."""

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
    "RunScript",
    "ScriptDebug",
]

Bytes = Union[bytes, bytearray, memoryview]


class RunScript(Request["Optional[Confirm]"]):
    """Start or stop a script.

    CMD_RUN_SCRIPT (57), to the board; 34 bytes. Effect: sets, stores, moves, restarts. Since
    board 3.0. Source: Outgoing commands L934-L938.
    """

    __slots__ = ()

    mode: Field[ScriptMode, ScriptMode] = Field(ValueOf(ScriptMode))
    """Operation."""
    slot: Field[int, int] = Field(RAW)
    """Script slot, counted from 0."""
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""

    def __init__(
        self,
        *,
        mode: ScriptMode = UNSET,
        slot: int = UNSET,
        reserved: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(mode=mode, slot=slot, reserved=reserved, tail=tail)


class ScriptDebug(Message):
    """Progress of a script started with debugging.

    CMD_SCRIPT_DEBUG (58), from the board; 3 bytes, and later firmware may append more. Since
    board 3.0. Source: Incoming commands L577-L580; Outgoing commands L916-L928.
    """

    __slots__ = ()

    cmd_count: Field[int, int] = Field(RAW)
    """Number of the running script command."""
    err_code: Field[FileError, FileError] = Field(ValueOf(FileError))
    """Error code; unlisted codes are possible."""

    def __init__(
        self,
        *,
        cmd_count: int = UNSET,
        err_code: FileError = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(cmd_count=cmd_count, err_code=err_code, tail=tail)
