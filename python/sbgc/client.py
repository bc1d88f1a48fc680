"""The client: talks to a gimbal, and waits for it."""

from __future__ import annotations

import atexit
import os
import time
import weakref
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from numbers import Real
from typing import Any, Generic, Literal, Optional, TypeVar, Union

from sbgc import _core
from sbgc.bode import BodeRecording, recording_of
from sbgc.emulator import Angles, Board
from sbgc.errors import GimbalError, GimbalTimeout
from sbgc.fields import limited
from sbgc.message import Message, of_library, wrap
from sbgc.msg import (
    BoardInfo,
    BoardInfo3,
    BodeTestStartStopRequest,
    CalibInfo,
    RunScript,
    ScriptMode,
)
from sbgc.parameters import Edit, Profile, profile_index

M = TypeVar("M", bound=Message)
Path = Union[str, "os.PathLike[str]"]
Bytes = Union[bytes, bytearray, memoryview]
# Called with what is done, the total, and the next step.
Progress = Callable[[int, int, str], object]
# The board has reported the end, has accepted it and does not report the end, or not even that.
CalibrationEnd = Literal["finished", "accepted"]

# How long a wait lasts before the interpreter may handle signals, and how long a camera that has to
# stop may take.
_SLICE, _STOP = 0.05, 1.0


@dataclass(frozen=True)
class Move:
    """The state of a move: measured angles, and degrees that remain."""

    angles: Angles
    remaining: Angles
    is_close: bool
    elapsed: float


@dataclass(frozen=True)
class Identity:
    """What the board has said about itself."""

    board: str
    firmware: str
    serial_number: str
    info: BoardInfo
    details: Optional[BoardInfo3]
    firmware_problem: str  # "" unless the firmware is no real version, such as 0.00
    """Only of boards that have serial numbers."""


@dataclass(frozen=True)
class Calibration:
    """The state of a calibration. `state` is what the board reports, if it can."""

    has_started: bool
    elapsed: float
    state: Optional[CalibInfo]


def move_of(found: tuple[Any, ...]) -> Move:
    angles, remaining, is_close, elapsed = found
    return Move(Angles(*angles), Angles(*remaining), is_close, elapsed)


def calibration_of(found: tuple[Any, ...]) -> Calibration:
    has_started, elapsed, state = found
    return Calibration(has_started, elapsed, None if state is None else _as(CalibInfo, state))


def _as(type_: type[M], message: _core.AnyMessage) -> M:
    found = wrap(message)
    assert isinstance(found, type_)
    return found


def finish(
    operation: _core.Operation,
    progress: Optional[Callable[..., object]] = None,
    timeout: Optional[float] = None,
) -> Any:
    """Wait for an operation. Whatever ends the wait cancels it, which stops a moving camera."""
    until = operation.now() + seconds_of(timeout)
    try:
        while not operation.wait(_SLICE):
            report(operation, progress)
            if operation.now() > until:
                raise out_of_time(timeout)
        report(operation, progress)
    except BaseException:
        operation.cancel()
        operation.wait(_STOP)
        raise
    return operation.result()


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


def pairs_of(values: Mapping[str, float]) -> list[tuple[str, float]]:
    if not isinstance(values, Mapping):
        raise TypeError(f"values: a dict of names and numbers is needed, not {values!r}")
    return list(values.items())


def out_of_time(timeout: Optional[float]) -> GimbalTimeout:
    return GimbalTimeout(f"it took more than {timeout:g} s", "timeout", 0)


def report(operation: _core.Operation, progress: Optional[Callable[..., object]]) -> None:
    if progress is not None and (found := operation.progress()) is not None:
        progress(*found)


class Stream(Generic[M]):
    """The samples of a data stream. It ends with its `with` block, or with close()."""

    def __init__(self, queue: _core.SampleQueue, link: _core.Link, timeout: float) -> None:
        self._queue, self._link, self._timeout = queue, link, timeout
        self._is_open = True

    def __enter__(self) -> Stream[M]:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def __iter__(self) -> Iterator[M]:
        return self

    def __next__(self) -> M:
        """Wait for the next sample. Raises TimeoutError if none comes."""
        until = self._link.now() + self._timeout
        while self._is_open:
            sample = self._queue.take(_SLICE)
            if sample is not None:
                return wrap(sample)  # type: ignore[return-value]
            self._link.description()  # raises if the line is closed
            if self._link.now() > until:
                raise TimeoutError(f"no sample for {self._timeout:g} seconds")
        raise StopIteration

    @property
    def missed(self) -> int:
        """How many samples were dropped because nobody took them."""
        return self._queue.missed

    def close(self) -> None:
        """End the stream."""
        self._is_open = False
        self._queue.cancel()


class SpeedControl:
    """Holds speeds as long as they are refreshed; stops the camera otherwise, and at the end."""

    def __init__(self, held: _core.HeldSpeed) -> None:
        self._held = held

    def set(self, *, roll: float = 0.0, pitch: float = 0.0, yaw: float = 0.0) -> None:
        """Turn with these speeds in degrees per second. Axes without one hold still."""
        require_numbers(roll=roll, pitch=pitch, yaw=yaw)
        self._held.set(roll, pitch, yaw)

    def refresh(self) -> None:
        """Keep the speeds. Raises GimbalError if the camera has been stopped."""
        self._held.refresh()

    def stop(self) -> None:
        """Stop the camera."""
        self._held.stop()


class Link:
    """What the blocking and the asynchronous client have in common."""

    def __init__(self) -> None:
        self._link = _core.Link()
        _open.add(self)

    @property
    def identity(self) -> Identity:
        """What the board reported about itself on connecting."""
        board, firmware, serial_number, info, details, problem = self._link.identity()
        more = None if details is None else _as(BoardInfo3, details)
        return Identity(board, firmware, serial_number, _as(BoardInfo, info), more, problem)

    @property
    def description(self) -> str:
        """The line: "serial port /dev/ttyUSB0, 115200 8N1"."""
        return self._link.description()

    @property
    def is_connected(self) -> bool:
        """False while the line is lost; see the argument `reconnect` of connect()."""
        return self._link.is_connected()

    @property
    def scripts(self) -> list[int]:
        """The sizes of the scripts by slot, 0 for an empty slot; [] if the board does not tell."""
        details = self.identity.details
        if details is None:
            return []
        slots = [*details.script_slot_size_raw, *details.script_slot_6_to_10_size_raw]
        return [int(size) for size in slots]

    def _move(
        self,
        roll: Optional[float],
        pitch: Optional[float],
        yaw: Optional[float],
        speed: float,
        timeout: float,
        tolerance: float,
        waits: bool,
    ) -> _core.Operation:
        require_numbers(roll=roll, pitch=pitch, yaw=yaw, speed=speed, tolerance=tolerance)
        require_numbers(timeout=timeout)
        return self._link.move_to(roll, pitch, yaw, speed, timeout, tolerance, waits)

    def _script(self, slot: int, mode: ScriptMode) -> _core.Operation:
        if not isinstance(slot, int) or not 1 <= slot <= 255:
            raise ValueError(f"slot: 1 to 255 are possible, not {slot!r}")
        sizes = self.scripts
        if mode == ScriptMode.START and sizes and (slot > len(sizes) or sizes[slot - 1] == 0):
            raise GimbalError(f"there is no script in slot {slot}", "not_found", 0)
        request = RunScript(mode=mode, slot=slot - 1)
        return self._link.confirm(request._message)

    def _write_eeprom(
        self, address: int, data: Bytes, yes: bool, timeout: float
    ) -> _core.Operation:
        require_numbers(address=address)
        size = memoryview(data).nbytes
        room = self._rest_of_eeprom(address)
        if room is not None and size > room:
            raise ValueError(
                f"data: {size} bytes do not fit: the EEPROM has {room} from address {address} on"
            )
        if not yes:
            raise ValueError(
                f"{size} bytes of the EEPROM would be overwritten, from address {address} on. It also"
                " holds the parameters: wrong bytes can make the board unusable. Pass yes=True."
            )
        return self._link.upload_eeprom(address, data, timeout)

    def _read_eeprom(self, address: int, size: Optional[int], timeout: float) -> _core.Operation:
        require_numbers(address=address, size=size)
        wanted = self._rest_of_eeprom(address) if size is None else size
        if wanted is None:
            raise ValueError("size: the board does not tell the size of its EEPROM")
        return self._link.download_eeprom(address, wanted, timeout)

    def _rest_of_eeprom(self, address: int) -> Optional[int]:
        """The number of bytes from the address to the end; None if the board does not tell it."""
        details = self.identity.details
        size = 0 if details is None else details.eeprom_size_raw
        if size == 0:
            return None
        if not 0 <= address < size:
            raise ValueError(f"address: {address} is not in the EEPROM, which has {size} bytes")
        return size - address

    def close(self) -> None:
        """Stop a camera that a call moves, end all calls, and close the line."""
        self._link.close()


_open: weakref.WeakSet[Link] = weakref.WeakSet()


@atexit.register
def _close_all() -> None:
    for link in list(_open):
        link.close()


class Gimbal(Link):
    """A connected board; see connect(). Calls may come from several threads.

    Every call has a timeout, in seconds. Ctrl-C and other exceptions during a call that moves the
    camera stop it before they go on. A process that is killed stops nothing: see docs/2-safety.md.
    """

    def __enter__(self) -> Gimbal:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def call(
        self,
        request: Message,
        *,
        timeout: Optional[float] = None,
        retries: Optional[int] = None,
        validates: bool = True,
        expects_confirmation: bool = False,
    ) -> Optional[Message]:
        """Send a request and return its response or confirmation; None if the protocol has none.

        With `expects_confirmation`, wait for one that the board may leave out, and raise a
        GimbalError with the code "unconfirmed" if none comes.
        """
        found = finish(
            self._link.call(of_library(request), timeout, retries, validates, expects_confirmation)
        )
        return None if found is None else wrap(found)

    def move_to(
        self,
        *,
        roll: Optional[float] = None,
        pitch: Optional[float] = None,
        yaw: Optional[float] = None,
        speed: float = 0.0,
        timeout: float = 30.0,
        tolerance: float = 0.5,
        progress: Optional[Callable[[Move], object]] = None,
    ) -> Move:
        """Move the camera to these angles, in degrees, and wait until it is there.

        Axes without an angle stay under RC control. Speed 0 is that of the parameters.

        Raises a GimbalError with the code "superseded" if a later command of this client stops the
        camera or moves it, and "interrupted" if another program, RC or a limit has changed the
        target. In both cases it sends nothing more.
        """
        operation = self._move(roll, pitch, yaw, speed, timeout, tolerance, True)
        tell = None if progress is None else (lambda *found: progress(move_of(found)))
        return move_of(finish(operation, tell))

    def begin_move(
        self,
        *,
        roll: Optional[float] = None,
        pitch: Optional[float] = None,
        yaw: Optional[float] = None,
        speed: float = 0.0,
        timeout: float = 30.0,
    ) -> Move:
        """The same, but return as soon as the camera moves. It stops at the target by itself."""
        return move_of(finish(self._move(roll, pitch, yaw, speed, timeout, 0.5, False)))

    def stop(self, *, timeout: float = 4.0) -> None:
        """Stop the camera, and wait until it has stood still for half a second.

        It ends every motion of this client that began before: these raise a GimbalError with the
        code "superseded", a held speed at its next set(). A motion that begins later ends the wait.
        """
        finish(self._link.stop(), timeout=timeout)

    def release(self, *, timeout: float = 10.0) -> None:
        """End serial control: the camera obeys RC again."""
        finish(self._link.release(), timeout=timeout)

    def set_control_timeout(self, seconds: float, *, timeout: float = 10.0) -> None:
        """Make the board end serial control if it receives no command for this time; 0: never.

        RC takes over then, which is not a stop. It holds until the board restarts, for all ports.
        """
        finish(self._link.set_control_timeout(seconds), timeout=timeout)

    @contextmanager
    def speed_control(self, silence: float = 0.5) -> Iterator[SpeedControl]:
        """Turn with speeds, which set() chooses. The camera stops at the end of the block.

        It also stops if nobody calls set() or refresh() for the time of `silence`.
        """
        held = _core.HeldSpeed(self._link, silence)
        try:
            yield SpeedControl(held)
        finally:
            finish(held.close())

    def stream(
        self,
        message: type[M],
        interval: float,
        *,
        request: Optional[Message] = None,
        timeout: float = 5.0,
    ) -> Stream[M]:
        """Make the board send a message every `interval` seconds.

        A `request` has the configuration of the stream, for those that need one. Iterating raises
        TimeoutError if no sample comes for the time of `timeout`.
        """
        seconds_of(timeout)
        given = None if request is None else of_library(request)
        queue = finish(self._link.stream(name_of(message), interval, given, None))
        return Stream(queue, self._link, timeout)

    def calibrate(
        self,
        request: Message,
        *,
        timeout: Optional[float] = None,
        progress: Optional[Callable[[Calibration], object]] = None,
    ) -> CalibrationEnd:
        """Calibrate, for example `msg.CalibGyro()`, and wait for the end. It replaces what is stored.

        The docstring of the request says how to hold the camera. The protocol cannot stop a
        calibration: an exception ends only the wait, and the board goes on.
        """
        tell = None if progress is None else (lambda *found: progress(calibration_of(found)))
        end: CalibrationEnd = finish(self._link.calibrate(of_library(request), timeout), tell)
        return end

    def record_bode(
        self,
        request: BodeTestStartStopRequest,
        *,
        progress: Optional[Progress] = None,
        timeout: Optional[float] = None,
    ) -> BodeRecording:
        """Record a frequency response. It shakes the camera, and no command ends it.

        An exception ends only the wait: the board goes on until its end, or until the motors are off.
        Without a timeout, it waits twice as long as the recording takes, and 10 s.
        """
        recorded = finish(self._link.record_bode(of_library(request)), progress, timeout=timeout)
        return recording_of(recorded)

    def active_profile(self, *, timeout: float = 10.0) -> int:
        """The profile that the board works with, from 1."""
        found: int = finish(self._link.active_profile(), timeout=timeout)
        return found + 1

    def profile_names(self, *, timeout: float = 10.0) -> list[str]:
        """The names of the profiles."""
        found: list[str] = finish(self._link.profile_names(), timeout=timeout)
        return found

    def rename_profile(self, profile: int, name: str, *, timeout: float = 10.0) -> None:
        """Rename a profile, from 1, and verify it."""
        finish(self._link.rename_profile(profile_index(profile), name), timeout=timeout)

    def rename_profiles(self, names: Sequence[str], *, timeout: float = 10.0) -> None:
        """Rename all profiles, and verify the names."""
        finish(self._link.rename_profiles(limited(names)), timeout=timeout)

    def read_profile(self, profile: int, *, timeout: float = 60.0) -> Profile:
        """Read the parameters of a profile, from 1, and those of the whole board."""
        index = profile_index(profile)
        return Edit(finish(self._link.read_parameters(index, timeout)), index).profile

    @contextmanager
    def edit_profile(self, profile: int, *, timeout: float = 120.0) -> Iterator[Profile]:
        """Read a profile, from 1; write what the block has changed at its end, once.

        What is written is read back and compared. If the block raises, nothing is written.
        """
        index = profile_index(profile)
        edit = Edit(finish(self._link.read_parameters(index, timeout)), index)
        yield edit.begin()
        changed = edit.end()
        if changed:
            finish(self._link.write_parameters(changed, timeout))

    def get_variables(self, *names: str, timeout: float = 10.0) -> list[float]:
        """The values of adjustable variables, in their units."""
        found: list[float] = finish(self._link.get_variables(list(names)), timeout=timeout)
        return found

    def get_variable(self, name: str, *, timeout: float = 10.0) -> float:
        """The value of an adjustable variable, in its unit."""
        return self.get_variables(name, timeout=timeout)[0]

    def set_variables(self, values: Mapping[str, float], *, timeout: float = 10.0) -> None:
        """Set adjustable variables until the board restarts, or until they are saved."""
        finish(self._link.set_variables(pairs_of(values)), timeout=timeout)

    def save_variables(self, *, timeout: float = 10.0) -> None:
        """Save the parameters that the board works with to the active profile."""
        finish(self._link.save_variables(), timeout=timeout)

    def backup(self, *, timeout: float = 60.0, progress: Optional[Progress] = None) -> str:
        """All parameters of the board, as the text of a backup file."""
        found: str = finish(self._link.make_backup(timeout), progress)
        return found

    def restore(
        self,
        backup: str,
        save_current: Optional[Path] = None,
        *,
        dry_run: bool = False,
        allow_other_model: bool = False,
        allow_other_firmware: bool = False,
        allow_partial: bool = False,
        timeout: float = 180.0,
        progress: Optional[Progress] = None,
    ) -> str:
        """Set the parameters to those of a backup; return a report.

        The present ones are saved to the new file `save_current` first. A `dry_run`, which needs no
        file, only reports what would change.
        """
        file = None if save_current is None else os.fspath(save_current)
        allowed = allow_other_model, allow_other_firmware, allow_partial
        operation = self._link.restore(backup, file, dry_run, *allowed, timeout)
        found: str = finish(operation, progress)
        return found

    def read_eeprom(
        self,
        address: int = 0,
        size: Optional[int] = None,
        *,
        timeout: float = 120.0,
        progress: Optional[Progress] = None,
    ) -> bytes:
        """Read a part of the EEPROM; without a size, up to its end."""
        found: bytes = finish(self._read_eeprom(address, size, timeout), progress)
        return found

    def write_eeprom(
        self,
        address: int,
        data: Bytes,
        *,
        yes: bool = False,
        timeout: float = 120.0,
        progress: Optional[Progress] = None,
    ) -> None:
        """Write a part of the EEPROM, read it back and compare.

        It also holds the parameters: wrong bytes can make the board unusable. Without `yes`, nothing
        is written.
        """
        finish(self._write_eeprom(address, data, yes, timeout), progress)

    def file_size(self, file: int, *, timeout: float = 10.0) -> int:
        """The size of a file of the board in bytes."""
        found: int = finish(self._link.file_size(file), timeout=timeout)
        return found

    def read_file(
        self, file: int, *, timeout: float = 120.0, progress: Optional[Progress] = None
    ) -> bytes:
        """Read a file of the board."""
        found: bytes = finish(self._link.download_file(file, timeout), progress)
        return found

    def write_file(
        self,
        file: int,
        data: Bytes,
        *,
        timeout: float = 120.0,
        progress: Optional[Progress] = None,
    ) -> None:
        """Write a file of the board, and verify it. A script is a file as well."""
        finish(self._link.upload_file(file, data, timeout), progress)

    def delete_file(self, file: int, *, timeout: float = 10.0) -> None:
        """Delete a file of the board."""
        finish(self._link.delete_file(file), timeout=timeout)

    def delete_all_files(self, *, timeout: float = 10.0) -> None:
        """Delete all files of the board."""
        finish(self._link.delete_all_files(), timeout=timeout)

    def read_user_data(self, *, timeout: float = 10.0) -> bytes:
        """Read the area that the board reserves for user data."""
        found: bytes = finish(self._link.download_user_data(), timeout=timeout)
        return found

    def write_user_data(self, offset: int, data: Bytes, *, timeout: float = 10.0) -> None:
        """Write to this area and verify it; other bytes stay as they are."""
        finish(self._link.upload_user_data(offset, data), timeout=timeout)

    def run_script(self, slot: int, *, timeout: float = 10.0) -> None:
        """Start the script in a slot, from 1. It goes on after this call, also if the line is lost."""
        finish(self._script(slot, ScriptMode.START), timeout=timeout)

    def stop_script(self, slot: int, *, timeout: float = 10.0) -> None:
        """Stop the script in a slot. What it has set in motion goes on until stop()."""
        finish(self._script(slot, ScriptMode.STOP), timeout=timeout)

    def wait_until_connected(self, *, timeout: float = 60.0) -> None:
        """Wait until the board is connected again; see the argument `reconnect` of connect()."""
        until = time.monotonic() + seconds_of(timeout)
        while not self.is_connected:
            if time.monotonic() > until:
                raise out_of_time(timeout)
            time.sleep(_SLICE)


def target_of(place: Union[str, Board]) -> Union[str, _core.Emulation]:
    if isinstance(place, Board):
        return place._board
    if not isinstance(place, str):
        raise TypeError(f"place: an address or an emulated board is needed, not {place!r}")
    return place


def connect(
    place: Union[str, Board],
    *,
    timeout: float = 20.0,
    capture: Optional[Path] = None,
    reconnect: bool = False,
) -> Gimbal:
    """Connect to a board: an address such as "/dev/ttyUSB0" or "tcp:host:port", or emulator().

    With a `capture`, record the traffic to this file. With `reconnect`, a lost line is searched for
    until it is found: a USB adapter also under another name, and only the same board. Streams go on
    then; calls meanwhile raise GimbalDisconnected.
    """
    gimbal = Gimbal()
    file = None if capture is None else os.fspath(capture)
    finish(gimbal._link.connect(target_of(place), timeout, file, reconnect))
    return gimbal


def diff(before: str, after: str) -> str:
    """The differences of two backups, as text; "" if there are none."""
    return _core.diff(before, after)
