"""Opens MAVLink connections, with pymavlink's address syntax, and serves them with asyncio."""

from __future__ import annotations

import asyncio
import os
import re
import termios
import tty
from typing import Any

from sbgc.mavlink import LOG
from sbgc.mavlink.options import ADDRESSES
from sbgc.mavlink.vehicle import Line, Vehicle

WAIT = 1.0  # seconds until a lost line is opened again


async def serve(address: str, vehicle: Vehicle) -> None:
    """Serve a line forever; a lost one is reopened. Raises ValueError for an invalid address."""
    while True:
        try:
            await _serve(address, vehicle)
            LOG.warning("%s: it has ended; trying again", address)
        except OSError as error:
            LOG.warning("%s: %s; trying again", address, error)
        await asyncio.sleep(WAIT)


async def _serve(address: str, vehicle: Vehicle) -> None:
    internet = re.fullmatch(r"(udp|udpin|udpout|tcp|tcpin):\[?(.+?)\]?:([1-9]\d{0,4})", address)
    serial = re.fullmatch(r"(/[^,]+),?(\d*)", address)
    speed = getattr(termios, f"B{serial[2] or 115200}", None) if serial else None
    if internet and int(internet[3]) < 65536:
        await _internet(vehicle, internet[1], internet[2], int(internet[3]))
    elif serial and speed is not None:
        await _serial(vehicle, serial[1], speed)
    else:
        raise ValueError(f"{address!r}: {ADDRESSES} is needed")


async def _internet(vehicle: Vehicle, kind: str, host: str, port: int) -> None:
    loop, line = asyncio.get_running_loop(), Line(vehicle, kind)
    opened: Any
    if kind == "tcpin":  # does not end by itself
        opened = await loop.create_server(lambda: Line(vehicle), host, port)
    elif kind == "tcp":
        opened, _ = await loop.create_connection(lambda: line, host, port)
    else:
        place: dict[str, Any] = {"remote_addr" if kind == "udpout" else "local_addr": (host, port)}
        opened, _ = await loop.create_datagram_endpoint(lambda: line, **place)
    LOG.info("%s:%s:%d: open", kind, host, port)
    try:
        await line.lost
    finally:
        opened.close()


async def _serial(vehicle: Vehicle, path: str, speed: int) -> None:
    loop, line = asyncio.get_running_loop(), Line(vehicle)
    number = os.open(path, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
    with os.fdopen(number, "r+b", 0) as port:
        try:
            tty.setraw(number)
            settings = termios.tcgetattr(number)
            settings[4] = settings[5] = speed
            termios.tcsetattr(number, termios.TCSANOW, settings)
        except termios.error as error:
            raise OSError(f"no serial port: {error}") from None
        line.transport, _ = await loop.connect_write_pipe(asyncio.BaseProtocol, port)
        reading, _ = await loop.connect_read_pipe(lambda: line, port)
        LOG.info("%s: open", path)
        try:
            await line.lost
        finally:
            reading.close()
            line.transport.abort()
