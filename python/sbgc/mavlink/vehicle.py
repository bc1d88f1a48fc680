"""The system that gimbals belong to: who is heard, and which messages are for whom."""

from __future__ import annotations

import logging
import time
from collections import Counter
from collections.abc import Callable
from math import isinf
from typing import TYPE_CHECKING, Any, Optional, TypeVar

from sbgc.mavlink.codec import Codec, Message
from sbgc.mavlink.protocol import AUTOPILOT, Ids

if TYPE_CHECKING:
    from sbgc.mavlink.device import Device

T = TypeVar("T")
LOG = logging.getLogger("sbgc.mavlink")
WANTED = frozenset(
    """HEARTBEAT COMMAND_LONG COMMAND_INT PARAM_REQUEST_LIST PARAM_REQUEST_READ PARAM_SET
    GIMBAL_DEVICE_SET_ATTITUDE AUTOPILOT_STATE_FOR_GIMBAL_DEVICE
    GIMBAL_MANAGER_INFORMATION GIMBAL_MANAGER_STATUS GIMBAL_MANAGER_SET_ATTITUDE
    GIMBAL_MANAGER_SET_PITCHYAW GIMBAL_MANAGER_SET_MANUAL_CONTROL""".split()
)
GROUND_STATION, NO_AUTOPILOT = 6, 8
USUAL = 1  # the system that an autopilot is if nobody has changed it
SILENCE = 5.0  # seconds without a message after which somebody is gone
MOST_SENDERS, SEQUENCES = 256, 256


class Vehicle:
    """One system of MAVLink. `system` is its id; 0 takes that of the autopilot that is heard first.

    `counters` counts, by reason, what has been refused: noise, damaged, truncated, signature, late, echo,
    not_finite, for_others, and what the gimbals refuse.
    """

    def __init__(self, name: str, system: int = 0, key: Optional[bytes] = None) -> None:
        self.name, self.system = name, system
        self.counters: Counter[str] = Counter()
        self.devices: dict[int, Device] = {}
        self._key, self._is_given = key, system != 0
        self._channels: list[Channel] = []
        self._sequences: Counter[int] = Counter()
        self._heard: dict[Ids, float] = {}
        self._began = time.monotonic()
        self._encoder = Codec(WANTED, key, self.counters)

    def join(self, write: Callable[[bytes], object], is_datagram: bool) -> Channel:
        codec = Codec(WANTED, self._key, self.counters)
        self._channels.append(Channel(self, write, codec, is_datagram))
        return self._channels[-1]

    def leave(self, channel: Channel) -> None:
        self._channels.remove(channel)

    @property
    def milliseconds(self) -> int:
        """The time that messages carry."""
        return int((time.monotonic() - self._began) * 1000) & 0xFFFFFFFF

    def hears(self, sender: Ids) -> bool:
        """True unless this component has been silent for five seconds."""
        return time.monotonic() - self._heard.get(sender, -SILENCE) < SILENCE

    def send(self, component: int, name: str, **fields: Any) -> None:
        """Send a message of a component to all lines.

        Before the system's id is known, only heartbeats, to wake those who have sent nothing.
        """
        if not self.system and name != "HEARTBEAT":
            return
        sender, sequence = (self.system or USUAL, component), self._sequences[component]
        self._sequences[component] = (sequence + 1) % SEQUENCES
        data = self._encoder.encode(name, sender, sequence, **fields)
        for channel in self._channels:
            if self.system or channel.is_new:
                channel.write(data)

    def take(self, message: Message) -> None:
        """Give a message to the devices for whom it is."""
        values, is_beat = message.values, message.name == "HEARTBEAT"
        if message.system == self.system and message.component in self.devices:
            self.counters["echo"] += 1
            return
        _note(self._heard, message.sender, time.monotonic())
        if is_beat and message.component == AUTOPILOT and values.autopilot != NO_AUTOPILOT:
            self._take_autopilot(message)
        if is_beat or not self.system:
            return
        to = getattr(values, "target_component", 0)
        if getattr(values, "target_system", 0) not in (0, self.system):
            self.counters["for_others"] += 1
        elif to and to not in self.devices:
            self.counters["for_others"] += 1
        elif any(isinf(one) for one in message.numbers):
            self.counters["not_finite"] += 1
        else:
            for device in [self.devices[to]] if to else self.devices.values():
                device.take(message)

    def _take_autopilot(self, message: Message) -> None:
        if self._is_given or message.values.type == GROUND_STATION:
            return
        if message.system != self.system and not self.hears((self.system, AUTOPILOT)):
            LOG.info("%s: the autopilot is system %d", self.name, message.system)
            self.system = message.system


class Channel:
    """One line, or one sender of datagrams."""

    def __init__(
        self, vehicle: Vehicle, write: Callable[[bytes], object], codec: Codec, is_datagram: bool
    ) -> None:
        self.write, self.is_new = write, True
        self._vehicle, self._codec, self._is_datagram = vehicle, codec, is_datagram
        self._last: dict[Ids, tuple[int, float]] = {}

    def receive(self, data: bytes) -> None:
        self.is_new = False
        for message in self._codec.decode(data, self._is_datagram):
            if self._is_late(message):
                self._vehicle.counters["late"] += 1
            else:
                self._vehicle.take(message)

    def _is_late(self, message: Message) -> bool:
        """True for a duplicate, and for what a later message of its sender has overtaken.

        A sender that restarts begins at 0; it is late for a second at most.
        """
        now = time.monotonic()
        sequence, at = self._last.get(message.sender, (0, -1e9))
        if (sequence - message.sequence) % SEQUENCES < SEQUENCES // 2 and now - at < 1:
            return True
        _note(self._last, message.sender, (message.sequence, now))
        return False


def _note(table: dict[Ids, T], sender: Ids, value: T) -> None:
    """Note what is known of a sender, and forget that of whom nothing was noted for longest."""
    if sender in table:
        del table[sender]
    elif len(table) >= MOST_SENDERS:
        del table[next(iter(table))]
    table[sender] = value
