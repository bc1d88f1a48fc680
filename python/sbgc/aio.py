"""The asynchronous client: the same calls as Gimbal, to await.

    async with sbgc.aio.connect("/dev/ttyUSB0") as gimbal:
        await gimbal.move_to(pitch=20, speed=10)

A call that is cancelled stops a camera that it moves before the cancellation goes on.
"""

from __future__ import annotations

import asyncio
import os
from collections.abc import AsyncIterator, Callable, Generator, Iterable, Mapping, Sequence
from contextlib import asynccontextmanager, suppress
from typing import Any, Generic, Optional, TypeVar, Union

from sbgc import _core
from sbgc.bode import BodeRecording, recording_of
from sbgc.client import (
    _STOP,
    Bytes,
    Calibration,
    CalibrationEnd,
    Link,
    Move,
    Path,
    Progress,
    SpeedControl,
    calibration_of,
    move_of,
    name_of,
    out_of_time,
    pairs_of,
    report,
    seconds_of,
    target_of,
)
from sbgc.emulator import Board
from sbgc.fields import limited
from sbgc.message import Message, of_library, wrap
from sbgc.msg import BodeTestStartStopRequest, ScriptMode
from sbgc.parameters import Edit, Profile, profile_index
from sbgc.search import Found
from sbgc.search import find as find_blocking

M = TypeVar("M", bound=Message)


class Gimbal(Link):
    """A connected board, in the event loop in which it was made; see connect()."""

    def __init__(self) -> None:
        super().__init__()
        self._loop = asyncio.get_running_loop()
        self._rung = asyncio.Event()
        # The client's thread rings; nothing of it runs Python.
        self._loop.add_reader(self._link.descriptor, self._ring)

    def _ring(self) -> None:
        self._link.drain()
        self._rung.set()
        self._rung = asyncio.Event()

    async def __aenter__(self) -> Gimbal:
        return self

    async def __aexit__(self, *error: object) -> None:
        self.close()

    def close(self) -> None:
        if not self._loop.is_closed():
            self._loop.remove_reader(self._link.descriptor)
        super().close()

    async def _finish(
        self,
        operation: _core.Operation,
        progress: Optional[Callable[..., object]] = None,
        timeout: Optional[float] = None,
    ) -> Any:
        seconds_of(timeout)  # raises if it is none
        try:
            await self._end(operation, progress, timeout)
        except BaseException:
            operation.cancel()
            with suppress(TimeoutError):
                await self._end(operation, timeout=_STOP)
            raise
        return operation.result()

    async def _end(
        self,
        operation: _core.Operation,
        progress: Optional[Callable[..., object]] = None,
        timeout: Optional[float] = None,
    ) -> None:
        waiting = asyncio.timeout(timeout)
        try:
            async with waiting:
                while True:
                    rung = self._rung  # before the question: what happens after it rings this one
                    is_over = operation.wait(0)
                    report(operation, progress)
                    if is_over:
                        return
                    await rung.wait()
        except TimeoutError:
            if not waiting.expired():
                raise  # of the user's function
            raise out_of_time(timeout) from None

    async def call(
        self,
        request: Message,
        *,
        timeout: Optional[float] = None,
        retries: Optional[int] = None,
        validates: bool = True,
        expects_confirmation: bool = False,
    ) -> Optional[Message]:
        """As Gimbal.call() of the blocking client; likewise all others."""
        found = await self._finish(
            self._link.call(of_library(request), timeout, retries, validates, expects_confirmation)
        )
        return None if found is None else wrap(found)

    async def move_to(
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
        operation = self._move(roll, pitch, yaw, speed, timeout, tolerance, True)
        tell = None if progress is None else (lambda *found: progress(move_of(found)))
        return move_of(await self._finish(operation, tell))

    async def begin_move(
        self,
        *,
        roll: Optional[float] = None,
        pitch: Optional[float] = None,
        yaw: Optional[float] = None,
        speed: float = 0.0,
        timeout: float = 30.0,
    ) -> Move:
        return move_of(await self._finish(self._move(roll, pitch, yaw, speed, timeout, 0.5, False)))

    async def stop(self, *, timeout: float = 4.0) -> None:
        await self._finish(self._link.stop(), timeout=timeout)

    async def release(self, *, timeout: float = 10.0) -> None:
        await self._finish(self._link.release(), timeout=timeout)

    async def set_control_timeout(self, seconds: float, *, timeout: float = 10.0) -> None:
        await self._finish(self._link.set_control_timeout(seconds), timeout=timeout)

    @asynccontextmanager
    async def speed_control(self, silence: float = 0.5) -> AsyncIterator[SpeedControl]:
        held = _core.HeldSpeed(self._link, silence)
        try:
            yield SpeedControl(held)
        finally:
            await self._finish(held.close())

    async def stream(
        self,
        message: type[M],
        interval: float,
        *,
        request: Optional[Message] = None,
        timeout: float = 5.0,
    ) -> Stream[M]:
        seconds_of(timeout)
        given = None if request is None else of_library(request)
        queue = await self._finish(self._link.stream(name_of(message), interval, given, None))
        return Stream(queue, self, timeout)

    async def calibrate(
        self,
        request: Message,
        *,
        timeout: Optional[float] = None,
        progress: Optional[Callable[[Calibration], object]] = None,
    ) -> CalibrationEnd:
        tell = None if progress is None else (lambda *found: progress(calibration_of(found)))
        end: CalibrationEnd = await self._finish(
            self._link.calibrate(of_library(request), timeout), tell
        )
        return end

    async def record_bode(
        self,
        request: BodeTestStartStopRequest,
        *,
        progress: Optional[Progress] = None,
        timeout: Optional[float] = None,
    ) -> BodeRecording:
        operation = self._link.record_bode(of_library(request))
        return recording_of(await self._finish(operation, progress, timeout=timeout))

    async def active_profile(self, *, timeout: float = 10.0) -> int:
        found: int = await self._finish(self._link.active_profile(), timeout=timeout)
        return found + 1

    async def profile_names(self, *, timeout: float = 10.0) -> list[str]:
        found: list[str] = await self._finish(self._link.profile_names(), timeout=timeout)
        return found

    async def rename_profile(self, profile: int, name: str, *, timeout: float = 10.0) -> None:
        await self._finish(self._link.rename_profile(profile_index(profile), name), timeout=timeout)

    async def rename_profiles(self, names: Sequence[str], *, timeout: float = 10.0) -> None:
        await self._finish(self._link.rename_profiles(limited(names)), timeout=timeout)

    async def read_profile(self, profile: int, *, timeout: float = 60.0) -> Profile:
        index = profile_index(profile)
        return Edit(await self._finish(self._link.read_parameters(index, timeout)), index).profile

    @asynccontextmanager
    async def edit_profile(self, profile: int, *, timeout: float = 120.0) -> AsyncIterator[Profile]:
        index = profile_index(profile)
        edit = Edit(await self._finish(self._link.read_parameters(index, timeout)), index)
        yield edit.begin()
        changed = edit.end()
        if changed:
            await self._finish(self._link.write_parameters(changed, timeout))

    async def get_variables(self, *names: str, timeout: float = 10.0) -> list[float]:
        found: list[float] = await self._finish(
            self._link.get_variables(list(names)), timeout=timeout
        )
        return found

    async def get_variable(self, name: str, *, timeout: float = 10.0) -> float:
        return (await self.get_variables(name, timeout=timeout))[0]

    async def set_variables(self, values: Mapping[str, float], *, timeout: float = 10.0) -> None:
        await self._finish(self._link.set_variables(pairs_of(values)), timeout=timeout)

    async def save_variables(self, *, timeout: float = 10.0) -> None:
        await self._finish(self._link.save_variables(), timeout=timeout)

    async def backup(self, *, timeout: float = 60.0, progress: Optional[Progress] = None) -> str:
        found: str = await self._finish(self._link.make_backup(timeout), progress)
        return found

    async def restore(
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
        file = None if save_current is None else os.fspath(save_current)
        allowed = allow_other_model, allow_other_firmware, allow_partial
        operation = self._link.restore(backup, file, dry_run, *allowed, timeout)
        found: str = await self._finish(operation, progress)
        return found

    async def read_eeprom(
        self,
        address: int = 0,
        size: Optional[int] = None,
        *,
        timeout: float = 120.0,
        progress: Optional[Progress] = None,
    ) -> bytes:
        found: bytes = await self._finish(self._read_eeprom(address, size, timeout), progress)
        return found

    async def write_eeprom(
        self,
        address: int,
        data: Bytes,
        *,
        yes: bool = False,
        timeout: float = 120.0,
        progress: Optional[Progress] = None,
    ) -> None:
        await self._finish(self._write_eeprom(address, data, yes, timeout), progress)

    async def file_size(self, file: int, *, timeout: float = 10.0) -> int:
        found: int = await self._finish(self._link.file_size(file), timeout=timeout)
        return found

    async def read_file(
        self, file: int, *, timeout: float = 120.0, progress: Optional[Progress] = None
    ) -> bytes:
        found: bytes = await self._finish(self._link.download_file(file, timeout), progress)
        return found

    async def write_file(
        self,
        file: int,
        data: Bytes,
        *,
        timeout: float = 120.0,
        progress: Optional[Progress] = None,
    ) -> None:
        await self._finish(self._link.upload_file(file, data, timeout), progress)

    async def delete_file(self, file: int, *, timeout: float = 10.0) -> None:
        await self._finish(self._link.delete_file(file), timeout=timeout)

    async def delete_all_files(self, *, timeout: float = 10.0) -> None:
        await self._finish(self._link.delete_all_files(), timeout=timeout)

    async def read_user_data(self, *, timeout: float = 10.0) -> bytes:
        found: bytes = await self._finish(self._link.download_user_data(), timeout=timeout)
        return found

    async def write_user_data(self, offset: int, data: Bytes, *, timeout: float = 10.0) -> None:
        await self._finish(self._link.upload_user_data(offset, data), timeout=timeout)

    async def run_script(self, slot: int, *, timeout: float = 10.0) -> None:
        await self._finish(self._script(slot, ScriptMode.START), timeout=timeout)

    async def stop_script(self, slot: int, *, timeout: float = 10.0) -> None:
        await self._finish(self._script(slot, ScriptMode.STOP), timeout=timeout)

    async def wait_until_connected(self, *, timeout: float = 60.0) -> None:
        seconds_of(timeout)  # raises if it is none
        try:
            async with asyncio.timeout(timeout):
                rung = self._rung
                while not self.is_connected:
                    await rung.wait()
                    rung = self._rung
        except TimeoutError:
            raise out_of_time(timeout) from None


class Stream(Generic[M]):
    """The samples of a data stream. It ends with its `async with` block, or with close()."""

    def __init__(self, queue: _core.SampleQueue, gimbal: Gimbal, timeout: float) -> None:
        self._queue, self._gimbal, self._timeout = queue, gimbal, timeout
        self._is_open = True

    async def __aenter__(self) -> Stream[M]:
        return self

    async def __aexit__(self, *error: object) -> None:
        self.close()

    def __aiter__(self) -> Stream[M]:
        return self

    async def __anext__(self) -> M:
        """Wait for the next sample. Raises TimeoutError if none comes."""
        async with asyncio.timeout(self._timeout):
            while self._is_open:
                rung = self._gimbal._rung
                sample = self._queue.take(0)
                if sample is not None:
                    return wrap(sample)  # type: ignore[return-value]
                await rung.wait()
                if self._is_open:
                    _ = self._gimbal.description  # raises if the line is closed
        raise StopAsyncIteration

    @property
    def missed(self) -> int:
        """How many samples were dropped because nobody took them."""
        return self._queue.missed

    def close(self) -> None:
        self._is_open = False
        self._queue.cancel()
        self._gimbal._ring()


class Connecting:
    """A client that is being connected: to await, or for `async with`."""

    def __init__(
        self, place: Union[str, Board], timeout: float, capture: Optional[Path], reconnect: bool
    ) -> None:
        self._place, self._timeout, self._reconnect = place, timeout, reconnect
        self._capture = None if capture is None else os.fspath(capture)
        self._gimbal: Optional[Gimbal] = None

    def __await__(self) -> Generator[Any, None, Gimbal]:
        return self._connect().__await__()

    async def _connect(self) -> Gimbal:
        gimbal = Gimbal()
        place = target_of(self._place)
        try:
            await gimbal._finish(
                gimbal._link.connect(place, self._timeout, self._capture, self._reconnect)
            )
        except BaseException:
            gimbal.close()
            raise
        return gimbal

    async def __aenter__(self) -> Gimbal:
        self._gimbal = await self._connect()
        return self._gimbal

    async def __aexit__(self, *error: object) -> None:
        if self._gimbal is not None:
            self._gimbal.close()


def connect(
    place: Union[str, Board],
    *,
    timeout: float = 20.0,
    capture: Optional[Path] = None,
    reconnect: bool = False,
) -> Connecting:
    """Connect to a board, as sbgc.connect(); an emulated one in real time."""
    if isinstance(place, Board) and place.has_virtual_time:
        raise ValueError("asyncio waits in real time: sbgc.connect() is for virtual time")
    return Connecting(place, timeout, capture, reconnect)


async def find(
    places: Optional[Iterable[Union[str, Board]]] = None, *, timeout: float = 5.0
) -> list[Found]:
    """Search for gimbals, as sbgc.find()."""
    return await asyncio.to_thread(find_blocking, places, timeout=timeout)
