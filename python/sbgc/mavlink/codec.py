"""The codec of pymavlink, which has no types, behind some that have.

What is known of it: MAVLink.decode() checks length, CRC with CRC_EXTRA and, if there is a key, the signature,
and cuts or pads payloads of other versions. Its parser loses what follows a false start, and its check of
signatures notes the time of forged ones; both are replaced here.
"""

from __future__ import annotations

import time
from collections import Counter
from dataclasses import dataclass
from hashlib import sha256
from hmac import compare_digest
from importlib import import_module
from struct import Struct
from typing import Any, Optional, Union

from sbgc.mavlink.protocol import Ids

V1, V2 = 0xFE, 0xFD
SIGNED = 1
# Signatures count time in steps of 10 us from 2015 on.
SIGNING_BEGIN, SIGNING_STEPS = 1420070400, 100_000


@dataclass(frozen=True)
class Message:
    """A message whose checksum, and signature if there is a key, are right; nothing else is checked."""

    name: str
    system: int
    component: int
    sequence: int
    values: Any
    """Has the fields as attributes, named and measured as in common.xml."""

    @property
    def sender(self) -> Ids:
        return self.system, self.component

    @property
    def numbers(self) -> list[float]:
        """All of its numbers that are no integers."""
        found = [getattr(self.values, name) for name in self.values.get_fieldnames()]
        numbers = [one for one in found if isinstance(one, float)]
        return sum((one for one in found if isinstance(one, list)), numbers)


def _dialect() -> Any:
    dialect: Any = import_module("pymavlink.dialects.v20.common")
    dialect.MAVLINK_IGNORE_CRC = False  # an environment variable sets it
    if 396 not in dialect.mavlink_map:
        dialect.mavlink_map[396] = _component_information_basic(dialect)
    return dialect


def _component_information_basic(dialect: Any) -> Any:
    """A message of development.xml, in the order of its definition; pymavlink 2.4.50 lacks it."""
    names = "time_boot_ms capabilities time_manufacture_s vendor_name model_name software_version"
    names += " hardware_version serial_number"

    class Basic(dialect.MAVLink_message):  # type: ignore[misc]
        id, msgname, crc_extra = 396, "COMPONENT_INFORMATION_BASIC", 50
        fieldnames = names.split()
        orders, lengths = [1, 0, 2, 3, 4, 5, 6, 7], [1] * 8
        unpacker = Struct("<QII32s32s24s24s32s")

        def __init__(self, *given: Any, **named: Any) -> None:
            super().__init__(self.id, self.msgname)
            self._fieldnames = self.fieldnames
            for field, value in (*zip(self.fieldnames, given), *named.items()):
                setattr(self, field, value)

        def pack(self, mav: Any, force_mavlink1: bool = False) -> Any:
            values = [getattr(self, self.fieldnames[place]) for place in self.orders]
            return self._pack(mav, self.crc_extra, self.unpacker.pack(*values), force_mavlink1)

    return Basic


class Codec:
    """Encodes and decodes the messages of one line, or of one sender of datagrams.

    `key` is the secret key of signing, 32 bytes: with it, messages that are not signed, or were signed before
    others of their sender, are refused. `names` are the messages that are wanted; others are skipped, unchecked.
    `counters` counts what is refused.
    """

    def __init__(self, names: frozenset[str], key: Optional[bytes], counters: Counter[str]) -> None:
        self._dialect = _dialect()
        self._types = {one.msgname: one for one in self._dialect.mavlink_map.values()}
        unknown = names - self._types.keys()
        assert not unknown, unknown
        self._wanted = {self._types[name].id for name in names}
        self._counters = counters
        self._buffer = bytearray()
        self._mav = _parser(self._dialect)
        if key is not None:
            signing = self._mav.signing
            signing.secret_key, signing.sign_outgoing = key, True
            signing.timestamp = int((time.time() - SIGNING_BEGIN) * SIGNING_STEPS)

    def encode(self, name: str, sender: Ids, sequence: int, **fields: Any) -> bytes:
        """Make the bytes of a message. A text is bytes; a number must fit its field."""
        mav = self._mav
        mav.srcSystem, mav.srcComponent, mav.seq = *sender, sequence
        packed: bytes = self._types[name](**fields).pack(mav)
        return packed

    def decode(self, data: bytes, is_datagram: bool = False) -> list[Message]:
        """Take bytes from the line, and return the wanted messages that they complete.

        What a datagram does not complete is dropped. Bytes of no message are dropped and counted.
        """
        self._buffer += data
        buffer, at, found = self._buffer, 0, []
        while len(buffer) - at >= 8:
            size = self._size(at)
            if size == 0:
                at += 1
                continue
            if len(buffer) - at < size:
                break
            message = self._message(buffer[at : at + size], buffer[at + size : at + size + 1])
            if isinstance(message, Message):
                found.append(message)
            at += size if message else 1
        del buffer[:at]
        if is_datagram and buffer:
            self._counters["truncated"] += 1
            buffer.clear()
        return found

    def _size(self, at: int) -> int:
        """The size of the frame that begins here; 0 if none does."""
        first, length, flags = self._buffer[at : at + 3]
        if first == V1:
            return length + 8
        if first == V2 and not flags & ~SIGNED:
            return length + (25 if flags & SIGNED else 12)
        self._counters["noise"] += 1
        return 0

    def _message(self, frame: bytearray, rest: bytearray) -> Union[Message, bool]:
        """The message of a frame; True if the frame is good, but not wanted; False if it is none."""
        number = int.from_bytes(frame[7:10], "little") if frame[0] == V2 else frame[5]
        if number not in self._wanted:
            return not rest or rest[0] in (V1, V2)  # cheaper than its checksum
        try:
            made = self._mav.decode(frame)
        except self._dialect.MAVError as error:
            is_refused: bool = error.message == "Invalid signature"
            self._counters["signature" if is_refused else "damaged"] += 1
            return is_refused
        header = made.get_header()
        return Message(made.get_type(), header.srcSystem, header.srcComponent, header.seq, made)


def _parser(dialect: Any) -> Any:
    class Parser(dialect.MAVLink):  # type: ignore[misc]
        def check_signature(self, frame: bytearray, system: int, component: int) -> bool:
            """A forged signature must not change the times that are known."""
            digest = sha256(self.signing.secret_key + frame[:-6]).digest()[:6]
            is_genuine = compare_digest(digest, bytes(frame[-6:]))
            return is_genuine and bool(super().check_signature(frame, system, component))

    return Parser(None)
