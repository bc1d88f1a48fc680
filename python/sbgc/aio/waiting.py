"""How the calls of the asynchronous client wait: until the client's thread rings."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from contextlib import suppress
from typing import Any, Optional, TypeVar

from sbgc import _core
from sbgc.link import STOP, Link, out_of_time, seconds_of

T = TypeVar("T")


class Waiting(Link):
    def __init__(self) -> None:
        super().__init__()
        self._loop = asyncio.get_running_loop()
        self._rung = asyncio.Event()
        # The client's thread rings; nothing of it runs Python.
        self._loop.add_reader(self._link.descriptor, self._wake)

    def _wake(self) -> None:
        self._link.drain()
        self._rung.set()
        self._rung = asyncio.Event()

    def close(self) -> None:
        if not self._loop.is_closed():
            self._loop.remove_reader(self._link.descriptor)
        super().close()

    async def wait_until_connected(self, *, timeout: float = 60.0) -> None:
        """Wait until the board is connected again; see the argument `reconnect` of connect()."""
        seconds_of(timeout)  # raises if it is none
        await self._wait(lambda _: self.is_connected, timeout)

    async def _wait(
        self,
        ask: Callable[[float], Optional[T]],
        timeout: Optional[float],
        problem: Callable[[Optional[float]], Exception] = out_of_time,
    ) -> T:
        """Ask whenever something has happened, until the answer is true."""
        waiting = asyncio.timeout(timeout)
        try:
            async with waiting:
                while True:
                    rung = self._rung  # before the question: what happens after it rings this one
                    if found := ask(0):
                        return found
                    await rung.wait()
        except TimeoutError:
            if not waiting.expired():
                raise  # of the user's function
            raise problem(timeout) from None

    async def _let_stop(self, operation: _core.Operation[Any]) -> None:
        with suppress(TimeoutError):
            await self._wait(operation.wait, STOP)
