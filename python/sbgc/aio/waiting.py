"""The waits of the calls of the asynchronous client, until the client's thread rings."""

from __future__ import annotations

import asyncio
import weakref
from collections.abc import Awaitable, Callable, Generator
from typing import Any, Optional, TypeVar

from sbgc import _core
from sbgc.link import STOP, Link, SpeedControl, closed, out_of_time, seconds_of

T = TypeVar("T")


class _Done:
    """An awaitable that is done."""

    def __await__(self) -> Generator[Any, None, None]:
        yield from ()


class Waiting(Link):
    def __init__(self) -> None:
        self._loop = asyncio.get_running_loop()
        super().__init__()
        self._rung = asyncio.Event()
        self._has_ended = False
        self._closing: Awaitable[None] = _Done()
        # The client's thread rings; nothing of it runs Python. The loop must not keep this object.
        reference: weakref.ref[Waiting] = weakref.ref(self)
        self._loop.add_reader(self._link.descriptor, _ring, reference)

    def __del__(self) -> None:
        super().__del__()
        if not self._is_closed and not self._loop.is_closed():
            self._loop.call_soon_threadsafe(_forget, self._loop, self._link)

    def _wake(self) -> None:
        self._link.drain()
        self._rung.set()
        self._rung = asyncio.Event()

    def _require_loop(self) -> None:
        """Raise RuntimeError in another loop than that in which the client was made."""
        if asyncio.get_running_loop() is not self._loop:
            raise RuntimeError("the client belongs to another event loop")

    def close(self) -> Awaitable[None]:
        """Stop a camera that a call moves, end all calls, and close the line.

        It begins at once; awaiting the result waits until it is done.
        """
        if self._is_closed:
            return self._closing
        try:
            loop = asyncio.get_running_loop()
        except RuntimeError:
            self._is_closed = True
            self._link.close(STOP)
            if not self._loop.is_closed():
                self._loop.call_soon_threadsafe(self._end_waits)
            return self._closing
        if loop is not self._loop and not self._loop.is_closed():
            raise RuntimeError("the client belongs to another event loop")
        self._is_closed = True
        self._link.begin_close()
        self._closing = loop.create_task(self._close_line())
        return self._closing

    async def _close_line(self) -> None:
        try:
            await self._wait(lambda _: self._link.is_still(), STOP)
        except TimeoutError:
            pass  # the line is lost
        finally:
            self._link.close(0)
            self._end_waits()

    def _end_waits(self) -> None:
        self._log()
        self._has_ended = True
        self._loop.remove_reader(self._link.descriptor)
        self._wake()

    async def wait_until_connected(self, *, timeout: float = 60.0) -> None:
        """Wait until the board is connected again; see the argument `reconnect` of connect()."""
        self._require_loop()

        def ask(_: float) -> bool:
            if not self.is_connected:
                self._link.require()  # raises if it is closed
            return self.is_connected

        await self._wait(ask, timeout)

    async def _wait(
        self,
        ask: Callable[[float], Optional[T]],
        timeout: Optional[float],
        problem: Callable[[float], Exception] = out_of_time,
    ) -> T:
        """Ask whenever something has happened, until the answer is true."""
        seconds = seconds_of(timeout)
        until = self._loop.time() + seconds
        while True:
            rung = self._rung  # before the question: what happens after it rings this one
            if found := ask(0):
                return found
            if self._has_ended:
                raise closed()
            if self._loop.time() >= until:
                raise problem(seconds)
            alarm = None if timeout is None else self._loop.call_at(until, self._wake)
            try:
                await rung.wait()
            finally:
                if alarm is not None:
                    alarm.cancel()

    async def _end(self, operation: _core.Operation[Any]) -> None:
        """Cancel an operation, and wait until it is over, even if the task is cancelled again."""
        operation.cancel()
        until = self._loop.time() + STOP
        again: Optional[asyncio.CancelledError] = None
        while operation.is_running() and not self._has_ended:
            try:
                await self._wait(operation.wait, max(until - self._loop.time(), 0))
            except TimeoutError:
                break
            except asyncio.CancelledError as error:
                again = error
        if again is not None:
            raise again

    async def _pause(self, seconds: float) -> None:
        await asyncio.sleep(seconds)


class SpeedBlock:
    """The block of a SpeedControl, at whose end the camera stops."""

    def __init__(self, gimbal: Any, silence: float) -> None:
        self._gimbal = gimbal
        self._held = _core.HeldSpeed(gimbal._link, silence)
        self._control = SpeedControl(self._held)

    async def __aenter__(self) -> SpeedControl:
        self._gimbal._require_loop()
        return self._control

    async def __aexit__(self, *error: object) -> None:
        if error[0] is None:
            self._held.warn_of_silence(2)
        await self._gimbal._finish(self._held.close())


def _ring(reference: weakref.ref[Waiting]) -> None:
    waiting = reference()
    if waiting is not None:
        waiting._wake()


def _forget(loop: asyncio.AbstractEventLoop, link: _core.Link) -> None:
    """End a client that nobody has closed; until then, its descriptor stays open."""
    loop.remove_reader(link.descriptor)
