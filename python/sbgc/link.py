"""The common code of the blocking and the asynchronous client."""

from __future__ import annotations

import atexit
import logging
import os
import warnings
import weakref
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from numbers import Real
from typing import TYPE_CHECKING, Any, Literal, Optional, TypeVar, Union

from sbgc import _core, msg, roles
from sbgc.emulator import Angles, Board
from sbgc.errors import GimbalDisconnected, GimbalError, GimbalTimeout
from sbgc.fields import limited
from sbgc.message import Message, Request, wrap
from sbgc.msg import CalibInfo, RunScript, ScriptMode

M = TypeVar("M", bound=Message)
T = TypeVar("T")
Path = Union[str, "os.PathLike[str]"]
Bytes = Union[bytes, bytearray, memoryview]
# Called with the completed amount, the total, and the next step.
Progress = Callable[[int, int, str], object]
# "finished": the board has reported the end; "accepted": it does not report it; None: unknown.
CalibrationEnd = Literal["finished", "accepted"]

# The time limit for stopping a camera.
STOP = 1.0

LOGGER = logging.getLogger("sbgc")
LOGGER.addHandler(logging.NullHandler())


@dataclass(frozen=True)
class Move:
    """The state of a move: measured and remaining angles, in degrees."""

    angles: Angles
    remaining: Angles
    is_close: bool
    elapsed: float


@dataclass(frozen=True)
class Identity:
    """The identity that a board reports."""

    board: str
    firmware: str
    serial_number: str
    info: roles.Introduction
    details: Optional[roles.Details]
    """Only set for boards with serial numbers."""
    firmware_problem: str  # "" unless the firmware is no real version, such as 0.00


@dataclass(frozen=True)
class Calibration:
    """The state of a calibration. `state` is the board's report, if available."""

    has_started: bool
    elapsed: float
    state: Optional[CalibInfo]


def move_of(found: _core.MoveState) -> Move:
    angles, remaining, is_close, elapsed = found
    return Move(Angles(*angles), Angles(*remaining), is_close, elapsed)


def calibration_of(found: tuple[Any, ...]) -> Calibration:
    has_started, elapsed, state = found
    return Calibration(has_started, elapsed, None if state is None else _as(CalibInfo, state))


def _as(type_: type[M], message: _core.AnyMessage) -> M:
    found = wrap(message)
    assert isinstance(found, type_)
    return found


def seconds_of(timeout: Optional[float]) -> float:
    if timeout is None:
        return float("inf")
    require_numbers(timeout=timeout)
    if not timeout >= 0:
        raise ValueError(f"timeout: {timeout!r} is no number of seconds")
    return timeout


def require_numbers(**values: Optional[float]) -> None:
    for name, value in values.items():
        if value is not None and not isinstance(value, Real):
            raise TypeError(f"{name}: a number is needed, not {value!r}")


def name_of(message: type[Message]) -> str:
    if not (isinstance(message, type) and issubclass(message, Message)):
        raise TypeError(f"message: the class of a message is needed, not {message!r}")
    return message.__name__


def names_of(names: Iterable[str]) -> list[str]:
    if isinstance(names, str) or not isinstance(names, Iterable):
        raise TypeError(f"names: a list of texts is needed, not {names!r}")
    return limited(names)


def dict_of(values: Mapping[str, float]) -> dict[str, float]:
    if not isinstance(values, Mapping):
        raise TypeError(f"values: a dict of names and numbers is needed, not {values!r}")
    return dict(values)


def out_of_time(timeout: float) -> GimbalTimeout:
    return GimbalTimeout(f"it took more than {timeout:g} s", "timeout", 0)


def no_sample(timeout: float) -> GimbalTimeout:
    return GimbalTimeout(f"no sample for {timeout:g} seconds", "timeout", 0)


def closed() -> GimbalDisconnected:
    return GimbalDisconnected("the client has been closed", "not_connected", 0)


def target_of(place: Union[Path, Board]) -> Union[str, _core.Emulation]:
    if isinstance(place, Board):
        return place._board
    if not isinstance(place, (str, os.PathLike)):
        raise TypeError(f"place: an address or an emulated board is needed, not {place!r}")
    return os.fspath(place)


class SpeedControl:
    """Holds speeds as long as they are refreshed; otherwise, and at the end, stops the camera."""

    def __init__(self, held: _core.HeldSpeed) -> None:
        self._held = held

    def set(self, *, roll: float = 0.0, pitch: float = 0.0, yaw: float = 0.0) -> None:
        """Turn with these speeds in degrees per second. Omitted axes hold still, and so do
        those with less than half of the least speed that a board knows.

        If the camera has stopped because nothing was called for the time of `silence`, it turns
        again, and a RuntimeWarning is issued. If another command of this client has stopped or moved
        it, this raises GimbalSuperseded, once.
        """
        self._held.warn_of_silence(2)
        self._held.set(roll, pitch, yaw)

    def refresh(self) -> None:
        """Keep the speeds. Raises GimbalError if the camera has been stopped."""
        self._held.refresh()

    def stop(self) -> None:
        """Stop the camera."""
        self._held.stop()


class Link:
    """The common base of the blocking and the asynchronous client."""

    _is_closed = True  # until there is a client

    def __init__(self) -> None:
        self._link = _core.Link()
        self._is_closed = False
        _open.add(self)

    def __repr__(self) -> str:
        name = f"{type(self).__module__}.{type(self).__qualname__}"
        if self._is_closed:
            return f"<{name}, closed>"
        if self._link.is_forked():
            return f"<{name} of another process>"
        state = "" if self._link.is_connected() else ", not connected"
        return f"<{name} of {self._link.description()}{state}>"

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> object:
            text = f"'{type(self).__name__}' object has no attribute '{name}'{self._hint(name)}"
            raise AttributeError(text)

    def _hint(self, name: str) -> str:
        """Return the attribute that the user probably meant by this name."""
        public = [one for one in dir(type(self)) if not one.startswith("_")]
        verb, _, rest = name.partition("_")
        if verb in ("get", "read") and rest in public:
            return f"; it has {rest}"
        if name.startswith("_"):
            return ""
        words = name.replace("_", "").lower()
        requests = [one for one in vars(msg).values() if isinstance(one, type)]
        for request in requests:
            if issubclass(request, Request) and request.__name__.lower() in (
                words,
                f"{words}request",
            ):
                return f"; there is the request call(msg.{request.__name__}())"
        near = get_close_matches(name, public)
        return f"; it has {', '.join(near)}" if near else ""

    def __del__(self) -> None:
        if not self._is_closed and not self._link.is_forked():
            warnings.warn(f"{self!r} was not closed", ResourceWarning, source=self)

    @property
    def identity(self) -> Identity:
        """The identity that the board reported when the client connected."""
        board, firmware, serial_number, info, details, problem = self._link.identity()
        more = None if details is None else _as(roles.Details, details)
        return Identity(
            board, firmware, serial_number, _as(roles.Introduction, info), more, problem
        )

    @property
    def firmware(self) -> str:
        """The version of the firmware, such as "2.59"."""
        return self.identity.firmware

    @property
    def description(self) -> str:
        """The line, such as "serial port /dev/ttyUSB0, 115200 8N1"."""
        return self._link.description()

    @property
    def is_connected(self) -> bool:
        """False while the line is lost, and after close()."""
        return self._link.is_connected()

    @property
    def scripts(self) -> list[int]:
        """The sizes of the scripts by slot, 0 for an empty slot; [] if they are unknown."""
        details = self.identity.details
        if details is None:
            return []
        slots = [*details.script_slot_size_raw, *details.script_slot_6_to_10_size_raw]
        return [int(size) for size in slots]

    def _script(self, slot: int, mode: ScriptMode) -> _core.Operation[Optional[_core.AnyMessage]]:
        if not isinstance(slot, int) or not 1 <= slot <= 255:
            raise ValueError(f"slot: 1 to 255 are possible, not {slot!r}")
        sizes = self.scripts
        if mode == ScriptMode.START and sizes and (slot > len(sizes) or sizes[slot - 1] == 0):
            raise GimbalError(f"there is no script in slot {slot}", "not_found", 0)
        request = RunScript(mode=mode, slot=slot - 1)
        return self._link.confirm(request._message)

    def _rest_of_eeprom(self, address: int) -> Optional[int]:
        """Return the number of bytes from the address to the end; None if it is unknown."""
        details = self.identity.details
        size = 0 if details is None else details.eeprom_size_raw
        if size == 0:
            return None
        if not 0 <= address < size:
            raise ValueError(f"address: {address} is not in the EEPROM, which has {size} bytes")
        return size - address

    def _result(self, operation: _core.Operation[T]) -> T:
        self._log()
        try:
            return operation.result()
        except GimbalError as error:
            if error.code == "cancelled" and self._is_closed:
                raise closed() from None
            raise

    def _log(self) -> None:
        """Log the events of the connection: no thread of the client runs Python."""
        for kind, text in self._link.take_events():
            level = logging.INFO if kind in ("connected", "closed") else logging.WARNING
            LOGGER.log(level, "%s: %s", kind, text)

    def _wake(self) -> None:
        """Wake waiting calls; in a blocking client, they poll."""


_open: weakref.WeakSet[Any] = weakref.WeakSet()


@atexit.register
def _close_all() -> None:
    for link in list(_open):
        link.close()
