"""Lines that carry MAVLink, named as pymavlink names them; asyncio serves them.

    udpin:0.0.0.0:14550     waits for datagrams, and answers whoever has sent some (udp: is the same)
    udpout:10.0.0.2:14550   sends datagrams there
    tcp:10.0.0.2:5760       connects
    tcpin:0.0.0.0:5760      waits for connections
    /dev/ttyAMA0,921600     a serial port; 115200 if no rate is named
"""

from __future__ import annotations

import asyncio
import logging
import os
import termios
import tty
from collections.abc import Awaitable, Callable
from contextlib import suppress
from typing import Any

from sbgc.mavlink.vehicle import Channel, Vehicle

LOG = logging.getLogger("sbgc.mavlink")
WAIT = 1.0  # seconds until a lost line is opened again
PEERS = 8  # how many senders of datagrams are answered: the last ones
QUEUE = 16384
"""Bytes that may wait; what does not fit is dropped, because it would be old when it leaves."""


def line_of(address: str) -> Callable[[Vehicle], Awaitable[None]]:
    """What opens a line and serves it until it is lost. Raises ValueError if the address is none."""
    kind, _, place = address.partition(":")
    if kind in KINDS:
        host, _, port = place.rpartition(":")
        if not host or not port.isdigit() or not 0 < int(port) < 65536:
            raise ValueError(f"{address!r}: {kind}:HOST:PORT is needed")
        return lambda vehicle: KINDS[kind](vehicle, host.strip("[]"), int(port))
    path, _, rate = address.partition(",")
    speed: int = getattr(termios, f"B{rate or 115200}", -1)
    if not path.startswith("/") or speed < 0:
        raise ValueError(f"{address!r}: {', '.join(KINDS)} or /dev/PORT,RATE is needed")
    return lambda vehicle: _serial(vehicle, path, speed)


async def serve(address: str, vehicle: Vehicle) -> None:
    """Serve a line for ever: one that is lost is opened again."""
    line, said = line_of(address), ""
    while True:
        problem = "it has ended"
        try:
            await line(vehicle)
        except OSError as error:
            problem = str(error)
        if problem != said:
            LOG.warning("%s: %s; trying again", address, problem)
        said = problem
        await asyncio.sleep(WAIT)


class _Datagrams(asyncio.DatagramProtocol):
    def __init__(self, vehicle: Vehicle) -> None:
        self._vehicle, self._peers = vehicle, dict[Any, Channel]()
        self.is_lost = asyncio.get_running_loop().create_future()

    def connection_made(self, transport: Any) -> None:
        self._transport = transport
        if transport.get_extra_info("peername"):
            self._channel_of(None)  # speaks first

    def _channel_of(self, peer: Any) -> Channel:
        channel = self._peers.pop(peer, None)
        if channel is None:
            send = self._transport.sendto
            channel = self._vehicle.join(lambda data: send(data, peer), True)
            if len(self._peers) >= PEERS:  # the one that has been silent for longest
                self._vehicle.leave(self._peers.pop(next(iter(self._peers))))
        self._peers[peer] = channel
        return channel

    def datagram_received(self, data: bytes, addr: Any) -> None:
        is_connected = self._transport.get_extra_info("peername")
        self._channel_of(None if is_connected else addr).receive(data)

    def error_received(self, exc: Exception) -> None:
        """Nobody listens there yet."""

    def connection_lost(self, exc: object) -> None:
        for channel in self._peers.values():
            self._vehicle.leave(channel)
        if not self.is_lost.done():
            self.is_lost.set_result(None)


async def _udp(vehicle: Vehicle, **places: tuple[str, int]) -> None:
    make = asyncio.get_running_loop().create_datagram_endpoint
    transport, protocol = await make(lambda: _Datagrams(vehicle), **places)  # type: ignore[arg-type]
    try:
        await protocol.is_lost
    finally:
        transport.close()


async def _udp_in(vehicle: Vehicle, host: str, port: int) -> None:
    await _udp(vehicle, local_addr=(host, port))


async def _udp_out(vehicle: Vehicle, host: str, port: int) -> None:
    await _udp(vehicle, remote_addr=(host, port))


async def _tcp(vehicle: Vehicle, host: str, port: int) -> None:
    reader, writer = await asyncio.open_connection(host, port)
    await _stream(vehicle, reader, writer.transport)


async def _tcp_in(vehicle: Vehicle, host: str, port: int) -> None:
    async def accept(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        with suppress(OSError):
            await _stream(vehicle, reader, writer.transport)

    async with await asyncio.start_server(accept, host, port) as server:
        await server.serve_forever()


async def _serial(vehicle: Vehicle, path: str, speed: int) -> None:
    loop, reader = asyncio.get_running_loop(), asyncio.StreamReader()
    port = os.open(path, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
    source, target = (os.fdopen(one, mode, 0) for one, mode in ((port, "rb"), (os.dup(port), "wb")))
    with source, target:
        try:
            tty.setraw(port)
            settings = termios.tcgetattr(port)
            settings[4] = settings[5] = speed
            termios.tcsetattr(port, termios.TCSANOW, settings)
        except termios.error as error:
            raise OSError(f"no serial port: {error}") from None
        protocol = asyncio.StreamReaderProtocol(reader)
        reading, _ = await loop.connect_read_pipe(lambda: protocol, source)
        try:
            writing, _ = await loop.connect_write_pipe(asyncio.BaseProtocol, target)
            await _stream(vehicle, reader, writing)
        finally:
            reading.close()


async def _stream(
    vehicle: Vehicle, reader: asyncio.StreamReader, transport: asyncio.WriteTransport
) -> None:
    def write(data: bytes) -> None:
        if not transport.is_closing() and transport.get_write_buffer_size() < QUEUE:
            transport.write(data)

    channel = vehicle.join(write, False)
    try:
        while data := await reader.read(4096):
            channel.receive(data)
    finally:
        vehicle.leave(channel)
        transport.abort()


KINDS: dict[str, Callable[[Vehicle, str, int], Awaitable[None]]] = {
    "udp": _udp_in,
    "udpin": _udp_in,
    "udpout": _udp_out,
    "tcp": _tcp,
    "tcpin": _tcp_in,
}
