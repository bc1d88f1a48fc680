# Generated from python/sbgc/aio/client.py by generator/: edit those, then run ./dev generate.
"""The client, whose calls wait for the gimbal."""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Callable, Mapping, Sequence
from contextlib import contextmanager, suppress
from typing import Any, Generic, Optional, TypeVar, Union

from sbgc import _core, roles
from sbgc.waiting import SpeedBlock, Waiting
from sbgc.bode import BodeRecording, recording_of
from sbgc.emulator import Angles, Board
from sbgc.errors import Error
from sbgc.link import (
    Bytes,
    Calibration,
    CalibrationEnd,
    Move,
    Path,
    Progress,
    calibration_of,
    dict_of,
    move_of,
    name_of,
    names_of,
    no_sample,
    require_numbers,
    seconds_of,
    target_of,
)
from sbgc.message import Message, Request, of_library, wrap
from sbgc.msg import BodeTestStartStopRequest, ScriptMode
from sbgc.parameters import Edit, Profile, profile_index

M = TypeVar("M", bound=Message)
R = TypeVar("R")
T = TypeVar("T")


class Gimbal(Waiting):
    """A connected board; see connect(). Every call has a timeout, in seconds.

    Several threads may call sbgc.Gimbal, and the event loop in which it was made sbgc.aio.Gimbal.
    Ctrl-C, the cancellation of a task and other exceptions during a call that moves the camera stop
    it before they go on. A process that is killed stops nothing: see docs/2-safety.md.
    """

    def __enter__(self) -> Gimbal:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def call(
        self,
        request: Request[R],
        *,
        timeout: Optional[float] = None,
        retries: Optional[int] = None,
        validates: bool = True,
        expects_confirmation: bool = False,
    ) -> R:
        """Send a request and return its response or confirmation; None if the protocol has none.

        With `expects_confirmation`, wait for one that the board may leave out, and raise a
        GimbalError with the code "unconfirmed" if none comes.
        """
        found = self._finish(
            self._link.call(of_library(request), timeout, retries, validates, expects_confirmation)
        )
        answer: Any = None if found is None else wrap(found)
        return answer  # type: ignore[no-any-return]

    def angles(self, *, timeout: Optional[float] = None) -> Angles:
        """The angles of the camera in degrees, as its IMU measures them."""
        return Angles(*roles.angles_of(self.call(roles.AnglesRequest(), timeout=timeout)))

    def motors_on(self, *, timeout: Optional[float] = None) -> None:
        """Turn the motors on. The camera may jump to its target."""
        self.call(roles.MotorsOn(), timeout=timeout)

    def motors_off(self, *, timeout: Optional[float] = None) -> None:
        """Turn the motors off. The camera may drop to its heavy side."""
        self.call(roles.MotorsOff(), timeout=timeout)

    def battery_voltage(self, *, timeout: Optional[float] = None) -> float:
        """The voltage of the battery in volts."""
        return roles.battery_voltage_of(self.call(roles.BatteryRequest(), timeout=timeout))

    def calibrate_gyro(
        self,
        *,
        timeout: Optional[float] = None,
        progress: Optional[Callable[[Calibration], object]] = None,
    ) -> CalibrationEnd:
        """Calibrate the gyroscope, as calibrate() does. The camera must not move."""
        return self.calibrate(roles.GyroCalibration(), timeout=timeout, progress=progress)

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

        Raises GimbalSuperseded if a later command of this client stops the camera or moves it, and
        GimbalInterrupted if another program, RC or a limit has changed the target. In both cases it
        sends nothing more.
        """
        operation = self._link.move_to(roll, pitch, yaw, speed, timeout, tolerance, True)
        tell = None if progress is None else (lambda *found: progress(move_of(found)))
        return move_of(self._finish(operation, tell))

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
        operation = self._link.move_to(roll, pitch, yaw, speed, timeout, 0.5, False)
        try:
            return move_of(self._finish(operation))
        except BaseException:
            with suppress(Error, RuntimeError):
                operation.result()  # raises unless the camera moves, which the caller would not know
                self.stop()
            raise

    def stop(self, *, timeout: float = 4.0) -> None:
        """Stop the camera, and wait until it has stood still for half a second.

        It ends every motion of this client that began before: these raise GimbalSuperseded, a held
        speed at its next set(). A motion that begins later ends the wait.
        """
        self._finish(self._link.stop(), timeout=timeout)

    def release(self, *, timeout: float = 10.0) -> None:
        """End serial control: the camera obeys RC again."""
        self._finish(self._link.release(), timeout=timeout)

    def set_control_timeout(self, seconds: float, *, timeout: float = 10.0) -> None:
        """Make the board end serial control if it receives no command for this time; 0: never.

        RC takes over then, which is not a stop. It holds until the board restarts, for all ports.
        """
        self._finish(self._link.set_control_timeout(seconds), timeout=timeout)

    def speed_control(self, silence: float = 0.5) -> SpeedBlock:
        """Turn with speeds, which set() chooses. The camera stops at the end of the block.

        It also stops if nobody calls set() or refresh() for the time of `silence`.
        """
        return SpeedBlock(self, silence)

    def turn(
        self, *, roll: float = 0.0, pitch: float = 0.0, yaw: float = 0.0, seconds: float
    ) -> None:
        """Turn with these speeds, in degrees per second, for so many seconds; then stop.

        Axes without a speed hold still. Raises FieldError for a speed that is too small, and
        GimbalSuperseded if a later command of this client stops the camera or moves it.
        """
        require_numbers(seconds=seconds)
        if not seconds >= 0:
            raise ValueError(f"seconds: {seconds!r} is no time")
        _core.require_speeds(roll, pitch, yaw)
        with self.speed_control() as control:
            until = self._link.now() + seconds
            control.set(roll=roll, pitch=pitch, yaw=yaw)
            while (left := until - self._link.now()) > 0:
                control.refresh()
                self._pause(min(left, 0.1))

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
        GimbalTimeout if no sample comes for the time of `timeout`.
        """
        seconds_of(timeout)
        given = None if request is None else of_library(request)
        queue = self._finish(self._link.stream(name_of(message), interval, given, None))
        return Stream(queue, self, message, timeout)

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
        return self._finish(self._link.calibrate(of_library(request), timeout), tell)

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
        operation = self._link.record_bode(of_library(request))
        return recording_of(self._finish(operation, progress, timeout=timeout))

    def active_profile(self, *, timeout: float = 10.0) -> int:
        """The profile that the board works with, from 1."""
        return 1 + self._finish(self._link.active_profile(), timeout=timeout)

    def profile_names(self, *, timeout: float = 10.0) -> list[str]:
        """The names of the profiles."""
        return self._finish(self._link.profile_names(), timeout=timeout)

    def rename_profile(self, profile: int, name: str, *, timeout: float = 10.0) -> None:
        """Rename a profile, from 1, and verify it."""
        self._finish(self._link.rename_profile(profile_index(profile), name), timeout=timeout)

    def rename_profiles(self, names: Sequence[str], *, timeout: float = 10.0) -> None:
        """Rename all profiles, and verify the names."""
        self._finish(self._link.rename_profiles(names_of(names)), timeout=timeout)

    def read_profile(self, profile: int, *, timeout: float = 60.0) -> Profile:
        """Read the parameters of a profile, from 1, and those of the whole board."""
        index = profile_index(profile)
        return Edit(self._finish(self._link.read_parameters(index, timeout)), index).profile

    @contextmanager
    def edit_profile(self, profile: int, *, timeout: float = 120.0) -> Iterator[Profile]:
        """Read a profile, from 1; write what the block has changed at its end, once.

        The values are read back and compared. If the block raises, nothing is written.
        """
        index = profile_index(profile)
        edit = Edit(self._finish(self._link.read_parameters(index, timeout)), index)
        yield edit.begin()
        changed = edit.end()
        if changed:
            self._finish(self._link.write_parameters(changed, timeout))

    def get_variables(self, *names: str, timeout: float = 10.0) -> list[float]:
        """The values of adjustable variables, in their units."""
        return self._finish(self._link.get_variables(list(names)), timeout=timeout)

    def get_variable(self, name: str, *, timeout: float = 10.0) -> float:
        """The value of an adjustable variable, in its unit."""
        (value,) = self.get_variables(name, timeout=timeout)
        return value

    def set_variables(self, values: Mapping[str, float], *, timeout: float = 10.0) -> None:
        """Set adjustable variables until the board restarts, or until they are saved."""
        self._finish(self._link.set_variables(dict_of(values)), timeout=timeout)

    def save_variables(self, *, timeout: float = 10.0) -> None:
        """Save the parameters that the board works with to the active profile."""
        self._finish(self._link.save_variables(), timeout=timeout)

    def backup(self, *, timeout: float = 60.0, progress: Optional[Progress] = None) -> str:
        """All parameters of the board, as the text of a backup file."""
        return self._finish(self._link.make_backup(timeout), progress)

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
        allowed = allow_other_model, allow_other_firmware, allow_partial
        operation = self._link.restore(backup, save_current, dry_run, *allowed, timeout)
        return self._finish(operation, progress)

    def read_eeprom(
        self,
        address: int = 0,
        size: Optional[int] = None,
        *,
        timeout: float = 120.0,
        progress: Optional[Progress] = None,
    ) -> bytes:
        """Read a part of the EEPROM; without a size, up to its end."""
        require_numbers(address=address, size=size)
        wanted = self._rest_of_eeprom(address) if size is None else size
        if wanted is None:
            raise ValueError("size: the board does not tell the size of its EEPROM")
        return self._finish(self._link.download_eeprom(address, wanted, timeout), progress)

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
        self._finish(self._link.upload_eeprom(address, data, timeout), progress)

    def file_size(self, file: int, *, timeout: float = 10.0) -> int:
        """The size of a file of the board in bytes."""
        return self._finish(self._link.file_size(file), timeout=timeout)

    def read_file(
        self, file: int, *, timeout: float = 120.0, progress: Optional[Progress] = None
    ) -> bytes:
        """Read a file of the board."""
        return self._finish(self._link.download_file(file, timeout), progress)

    def write_file(
        self,
        file: int,
        data: Bytes,
        *,
        timeout: float = 120.0,
        progress: Optional[Progress] = None,
    ) -> None:
        """Write a file of the board, and verify it. A script is a file as well."""
        self._finish(self._link.upload_file(file, data, timeout), progress)

    def delete_file(self, file: int, *, timeout: float = 10.0) -> None:
        """Delete a file of the board."""
        self._finish(self._link.delete_file(file), timeout=timeout)

    def delete_all_files(self, *, timeout: float = 10.0) -> None:
        """Delete all files of the board."""
        self._finish(self._link.delete_all_files(), timeout=timeout)

    def read_user_data(self, *, timeout: float = 10.0) -> bytes:
        """Read the area that the board reserves for user data."""
        return self._finish(self._link.download_user_data(), timeout=timeout)

    def write_user_data(self, offset: int, data: Bytes, *, timeout: float = 10.0) -> None:
        """Write to this area and verify it; other bytes stay as they are."""
        self._finish(self._link.upload_user_data(offset, data), timeout=timeout)

    def run_script(self, slot: int, *, timeout: float = 10.0) -> None:
        """Start the script in a slot, from 1. It goes on after this call, also if the line is lost."""
        self._finish(self._script(slot, ScriptMode.START), timeout=timeout)

    def stop_script(self, slot: int, *, timeout: float = 10.0) -> None:
        """Stop the script in a slot. What it has set in motion goes on until stop()."""
        self._finish(self._script(slot, ScriptMode.STOP), timeout=timeout)

    def _finish(
        self,
        operation: _core.Operation[T],
        progress: Optional[Callable[..., object]] = None,
        timeout: Optional[float] = None,
    ) -> T:
        """Wait for an operation. Whatever ends the wait cancels it, which stops a moving camera."""

        def is_over(seconds: float) -> bool:
            found = operation.wait(seconds)
            if progress is not None and (report := operation.progress()) is not None:
                progress(*report)
            return found

        seconds_of(timeout)  # raises if it is none
        self._require_loop()
        try:
            operation.begin()  # only here: what interrupts it before ends nothing
            self._wait(is_over, timeout)
        except BaseException:
            self._end(operation)
            raise
        return self._result(operation)


class Stream(Generic[M]):
    """The samples of a data stream. It ends with its `with` block, or with close()."""

    _is_open = False

    def __init__(
        self, queue: _core.SampleQueue, gimbal: Gimbal, message: type[M], timeout: float
    ) -> None:
        self._queue, self._gimbal, self._message = queue, gimbal, message
        self._timeout = timeout
        self._is_open = True

    def __enter__(self) -> Stream[M]:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def __iter__(self) -> Stream[M]:
        return self

    def __repr__(self) -> str:
        state = "" if self._is_open and not self._gimbal._is_closed else ", closed"
        return f"<{type(self).__module__}.Stream of {self._message.__name__}{state}>"

    def __del__(self) -> None:
        if self._is_open and not self._gimbal._is_closed:
            warnings.warn(f"{self!r} was not closed", ResourceWarning, source=self)

    def __next__(self) -> M:
        """Wait for the next sample. Raises GimbalTimeout if none comes."""
        self._gimbal._require_loop()
        sample = self._gimbal._wait(self._take, self._timeout, no_sample)
        return wrap(sample)  # type: ignore[return-value]

    def _take(self, seconds: float) -> Optional[_core.AnyMessage]:
        if not self._is_open:
            raise StopIteration
        sample = self._queue.take(seconds)
        if sample is None:
            self._gimbal._log()
            self._gimbal._link.require()  # raises if the line is closed
        return sample

    @property
    def missed(self) -> int:
        """The number of samples that were dropped because nobody took them."""
        return self._queue.missed

    def close(self) -> None:
        """End the stream."""
        self._is_open = False
        self._queue.cancel()
        self._gimbal._wake()


def connect(
    place: Union[Path, Board],
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
    try:
        gimbal._finish(gimbal._link.connect(target_of(place), timeout, capture, reconnect))
    except BaseException:
        gimbal.close()
        raise
    return gimbal
