"""The asynchronous client: the same calls as Gimbal, to await.

    async with sbgc.aio.connect("/dev/ttyUSB0") as gimbal:
        await gimbal.move_to(pitch=20, speed=10)

A call that is cancelled stops a camera that it moves before the cancellation goes on.
"""

from __future__ import annotations

import asyncio
from collections.abc import Generator, Iterable
from typing import Any, Optional, Union

from sbgc.aio import client
from sbgc.aio.client import Gimbal, Stream
from sbgc.aio.waiting import SpeedBlock
from sbgc.emulator import Board
from sbgc.link import Path
from sbgc.search import Found
from sbgc.search import find as find_blocking

__all__ = ["Connecting", "Gimbal", "Stream", "connect", "find"]


class Connecting:
    """A client that is being connected: to await, or for `async with`."""

    def __init__(
        self, place: Union[Path, Board], timeout: float, capture: Optional[Path], reconnect: bool
    ) -> None:
        self._place, self._timeout = place, timeout
        self._capture, self._reconnect = capture, reconnect
        self._gimbal: Optional[Gimbal] = None

    def __await__(self) -> Generator[Any, None, Gimbal]:
        return client.connect(
            self._place, timeout=self._timeout, capture=self._capture, reconnect=self._reconnect
        ).__await__()

    async def __aenter__(self) -> Gimbal:
        self._gimbal = await self
        return self._gimbal

    async def __aexit__(self, *error: object) -> None:
        if self._gimbal is not None:
            await self._gimbal.close()


def connect(
    place: Union[Path, Board],
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
    places: Optional[Iterable[Union[Path, Board]]] = None, *, timeout: float = 5.0
) -> list[Found]:
    """Search for gimbals, as sbgc.find()."""
    return await asyncio.to_thread(find_blocking, places, timeout=timeout)
