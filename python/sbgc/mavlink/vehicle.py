"""The system that gimbals belong to, and its lines: filtering and routing of messages."""

from __future__ import annotations

import asyncio
import time
from argparse import Namespace
from collections import Counter
from collections.abc import Callable
from math import inf
from typing import Any

from sbgc.mavlink import LOG
from sbgc.mavlink.codec import Codec, Ids, Message, mav
from sbgc.mavlink.options import key_of

SEQUENCES = 256
PEERS = 8  # how many senders of datagrams are answered: the last ones
QUEUE = 16384  # bytes that may wait; what does not fit would be old when it leaves
AUTOPILOT = 1  # its component, and its system if nobody has changed it
GROUND_STATION, NONE = mav.MAV_TYPE_GCS, mav.MAV_AUTOPILOT_INVALID
SILENCE, REPORT = 5.0, 60.0  # seconds after which somebody is gone, and between reports


class Vehicle:
    """A MAVLink system. Its id is that of the first autopilot heard, unless one is given.

    `counters` counts rejected messages by reason: noise, damaged, truncated, signature, late, echo,
    for_others, and rejections by the gimbals.
    """

    def __init__(self, name: str, given: Namespace) -> None:
        self.name, self.system, self.key = name or "vehicle", given.system, key_of(given.key_file)
        self.counters: Counter[str] = Counter()
        self.lines: list[Line] = []
        self.has_had_a_line = asyncio.Event()
        # Handles the messages for a component. Raises ValueError with the reason of a rejection.
        self.devices: dict[int, Callable[[Message], None]] = {}
        self._is_given = bool(given.system)
        self._sequences: Counter[int] = Counter()
        self._heard: dict[Ids, float] = {}
        self._encoder = Codec(self.key, self.counters)

    async def report(self) -> None:
        """Log now and then how many messages have been rejected."""
        while True:
            await asyncio.sleep(REPORT)
            if self.counters:
                LOG.info("%s: refused in the last minute: %s", self.name, dict(self.counters))
            self.counters.clear()

    def hears(self, sender: Ids) -> bool:
        """True unless this component has been silent for five seconds."""
        return time.monotonic() - self._heard.get(sender, -inf) < SILENCE

    def send(self, component: int, name: str, **fields: Any) -> None:
        """Send a message on all lines; before the system is known, only heartbeats, to wake peers."""
        lines = [line for line in self.lines if self.system or line.is_new and name == "HEARTBEAT"]
        sender, sequence = (self.system or AUTOPILOT, component), self._sequences[component]
        self._sequences[component] = (sequence + 1) % SEQUENCES
        data = self._encoder.to_bytes(name, sender, sequence, **fields)
        for line in lines:
            line.write(data)

    def take(self, message: Message) -> None:
        """Pass a message to the devices that it addresses."""
        (system, component), values = message.sender, message.values
        if system == self.system and component in self.devices:
            self.counters["echo"] += 1
            return
        self._heard[message.sender] = time.monotonic()
        if message.name == "HEARTBEAT" and component == AUTOPILOT and not self._is_given:
            is_one = values.type != GROUND_STATION and values.autopilot != NONE
            if is_one and system != self.system and not self.hears((self.system, AUTOPILOT)):
                LOG.info("%s: the autopilot is system %d", self.name, system)
                self.system = system
        if not self.system:
            return
        to = getattr(values, "target_component", 0)
        is_near = getattr(values, "target_system", 0) in (0, self.system)
        if not is_near or to and to not in self.devices:
            self.counters["for_others"] += 1
            return
        for take in [self.devices[to]] if to else self.devices.values():
            try:
                take(message)
            except ValueError as error:
                self.counters[str(error)] += 1


class Line(asyncio.Protocol, asyncio.DatagramProtocol):
    """One connection, or the datagrams of several peers."""

    transport: Any = None

    def __init__(self, vehicle: Vehicle, kind: str = "") -> None:
        self.lost, self.is_new = asyncio.get_running_loop().create_future(), True
        self._vehicle, self._codec = vehicle, Codec(vehicle.key, vehicle.counters)
        self._is_datagram, self._is_open = kind.startswith("udp"), kind in ("udp", "udpin")
        # Has the last sequence number of each sender, and its arrival time.
        self._peers: dict[Any, dict[Ids, tuple[int, float]]] = {} if self._is_open else {None: {}}

    def connection_made(self, transport: Any) -> None:
        self.transport = self.transport or transport  # a serial port has one for each direction
        self._vehicle.lines.append(self)
        self._vehicle.has_had_a_line.set()

    def connection_lost(self, exc: object) -> None:
        self._vehicle.lines.remove(self)
        if not self.lost.done():
            self.lost.set_result(None)

    def write(self, data: bytes) -> None:
        if self._is_datagram:
            for peer in self._peers:
                self.transport.sendto(data, peer)
        elif self.transport.get_write_buffer_size() < QUEUE:
            self.transport.write(data)

    def datagram_received(self, data: bytes, addr: Any) -> None:
        self.data_received(data, addr if self._is_open else None)

    def data_received(self, data: bytes, peer: Any = None) -> None:
        self.is_new = False
        self._peers[peer] = last = self._peers.pop(peer, {})
        if len(self._peers) > PEERS:  # the one that has been silent for longest
            del self._peers[next(iter(self._peers))]
        for message in self._codec.messages(data, self._is_datagram):
            now = time.monotonic()
            sequence, at = last.get(message.sender, (0, -inf))
            behind = (sequence - message.sequence) % SEQUENCES
            # A sender that restarts begins at 0; its messages count as late for at most a second.
            if behind < SEQUENCES // 2 and now - at < 1:
                self._vehicle.counters["late"] += 1
                continue
            last[message.sender] = message.sequence, now
            self._vehicle.take(message)
