"""The client: talks to a gimbal, and waits for it."""

from __future__ import annotations

import atexit
import os
import weakref
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Generic, Optional, TypeVar, Union

from sbgc import _core
from sbgc.emulator import Angles, Board
from sbgc.message import Message, wrap
from sbgc.msg import BoardInfo
from sbgc.parameters import Edit, Profile, profile_index

M = TypeVar("M", bound=Message)
Path = Union[str, "os.PathLike[str]"]
Progress = Callable[..., object]

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


def move_of(found: tuple[Any, ...]) -> Move:
    angles, remaining, is_close, elapsed = found
    return Move(Angles(*angles), Angles(*remaining), is_close, elapsed)


def finish(operation: _core.Operation, progress: Optional[Progress] = None) -> Any:
    """Wait for an operation. Whatever ends the wait cancels it, which stops a moving camera."""
    try:
        while not operation.wait(_SLICE):
            report(operation, progress)
        report(operation, progress)
    except BaseException:
        operation.cancel()
        operation.wait(_STOP)
        raise
    return operation.result()


def report(operation: _core.Operation, progress: Optional[Progress]) -> None:
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
        board, firmware, serial_number, info = self._link.identity()
        found = wrap(info)
        assert isinstance(found, BoardInfo)
        return Identity(board, firmware, serial_number, found)

    @property
    def description(self) -> str:
        """The line: "serial port /dev/ttyUSB0, 115200 8N1"."""
        return self._link.description()

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
    ) -> Optional[Message]:
        """Send a request and return its response or confirmation; None if the protocol has none."""
        found = finish(self._link.call(request._message, timeout, retries, validates))
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
        """
        operation = self._link.move_to(roll, pitch, yaw, speed, timeout, tolerance, True)
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
        return move_of(finish(self._link.move_to(roll, pitch, yaw, speed, timeout, 0.5, False)))

    def stop(self) -> None:
        """Stop the camera, and wait until it stands still."""
        finish(self._link.stop())

    def release(self) -> None:
        """End serial control: the camera obeys RC again."""
        finish(self._link.release())

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
        given = None if request is None else request._message
        queue = finish(self._link.stream(message.__name__, interval, given, None))
        return Stream(queue, self._link, timeout)

    def calibrate_gyroscope(
        self, *, timeout: Optional[float] = None, progress: Optional[Progress] = None
    ) -> None:
        """Calibrate the gyroscope; the camera must be still. It replaces what is stored.

        `progress(started, seconds)` is called meanwhile. The protocol cannot stop a calibration: an
        exception ends only the wait.
        """
        finish(self._link.calibrate(True, timeout), progress)

    def calibrate_accelerometer(
        self, *, timeout: Optional[float] = None, progress: Optional[Progress] = None
    ) -> None:
        """Calibrate the accelerometer; the camera must be level. As calibrate_gyroscope()."""
        finish(self._link.calibrate(False, timeout), progress)

    def active_profile(self) -> int:
        """The profile that the board works with, from 1."""
        found: int = finish(self._link.active_profile())
        return found + 1

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
        yield edit.profile
        changed = edit.changed()
        if changed:
            finish(self._link.write_parameters(changed, timeout))

    def get_variables(self, *names: str) -> list[float]:
        """The values of adjustable variables, in their units."""
        found: list[float] = finish(self._link.get_variables(list(names)))
        return found

    def get_variable(self, name: str) -> float:
        """The value of an adjustable variable, in its unit."""
        return self.get_variables(name)[0]

    def set_variables(self, values: Mapping[str, float]) -> None:
        """Set adjustable variables until the board restarts, or until they are saved."""
        finish(self._link.set_variables(list(values.items())))

    def save_variables(self) -> None:
        """Save the parameters that the board works with to the active profile."""
        finish(self._link.save_variables())

    def backup(self, *, timeout: float = 60.0, progress: Optional[Progress] = None) -> str:
        """All parameters of the board, as the text of a backup file."""
        found: str = finish(self._link.make_backup(timeout), progress)
        return found

    def restore(
        self,
        backup: str,
        save_current: Path,
        *,
        allow_other_model: bool = False,
        allow_other_firmware: bool = False,
        timeout: float = 180.0,
        progress: Optional[Progress] = None,
    ) -> str:
        """Set the parameters to those of a backup; return a report.

        The present ones are saved to the new file `save_current` first.
        """
        operation = self._link.restore(
            backup, os.fspath(save_current), allow_other_model, allow_other_firmware, timeout
        )
        found: str = finish(operation, progress)
        return found

    def read_eeprom(self, address: int, size: int) -> bytes:
        """Read a part of the EEPROM."""
        found: bytes = finish(self._link.download_eeprom(address, size))
        return found

    def read_file(self, file: int) -> bytes:
        """Read a file of the board."""
        found: bytes = finish(self._link.download_file(file))
        return found

    def write_file(self, file: int, data: Union[bytes, bytearray, memoryview]) -> None:
        """Write a file of the board, and verify it."""
        finish(self._link.upload_file(file, data))

    def delete_file(self, file: int) -> None:
        """Delete a file of the board."""
        finish(self._link.delete_file(file))


def target_of(place: Union[str, Board]) -> Union[str, _core.Emulation]:
    return place._board if isinstance(place, Board) else place


def connect(
    place: Union[str, Board], *, timeout: float = 20.0, capture: Optional[Path] = None
) -> Gimbal:
    """Connect to a board: an address such as "/dev/ttyUSB0" or "tcp:host:port", or emulator().

    With a `capture`, record the traffic to this file.
    """
    gimbal = Gimbal()
    file = None if capture is None else os.fspath(capture)
    finish(gimbal._link.connect(target_of(place), timeout, file))
    return gimbal


def diff(before: str, after: str) -> str:
    """The differences of two backups, as text; "" if there are none."""
    return _core.diff(before, after)
