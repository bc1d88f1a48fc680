"""A typed wrapper of pymavlink's codec, which has no types.

It checks length, CRC and signature, and cuts or pads payloads of other versions.
"""

from __future__ import annotations

import time
from collections import Counter
from hashlib import sha256
from hmac import compare_digest
from importlib import import_module
from struct import Struct
from typing import Any, NamedTuple, Optional

mav: Any = import_module("pymavlink.dialects.v20.common")  # messages and numbers of common.xml
mav.MAVLINK_IGNORE_CRC = False  # an environment variable sets it
REFUSED = {"Bad prefix": "noise", "Invalid signature": "signature"}
SIGNING_BEGIN, SIGNING_STEPS = 1420070400, 100_000  # signatures count 10 us from 2015 on
Ids = tuple[int, int]  # a system and a component


class Constants:
    """The values of an enumeration of common.xml, without the enumeration's prefix in their names."""

    def __init__(self, name: str) -> None:
        values = mav.enums[name].items()
        self.__dict__.update({one.name[len(name) + 1 :]: value for value, one in values})

    def __getattr__(self, name: str) -> int:
        raise AttributeError(name)


Flags = Constants("GIMBAL_DEVICE_FLAGS")  # those of managers have the same values
Result = Constants("MAV_RESULT")


class Message(NamedTuple):
    """A message with a valid checksum, and with a key a valid signature; nothing else is checked."""

    name: str
    sender: Ids
    sequence: int
    values: Any  # has the fields of common.xml as attributes


class _Basic(mav.MAVLink_message):  # type: ignore[misc]
    """COMPONENT_INFORMATION_BASIC of development.xml, which pymavlink 2.4.50 lacks."""

    id, msgname, crc_extra = 396, "COMPONENT_INFORMATION_BASIC", 50
    fieldnames = """capabilities time_boot_ms time_manufacture_s vendor_name model_name
        software_version hardware_version serial_number""".split()
    orders, lengths, unpacker = list(range(8)), [1] * 8, Struct("<QII32s32s24s24s32s")

    def __init__(self, *values: Any, **fields: Any) -> None:
        super().__init__(self.id, self.msgname)
        self.__dict__.update(zip(self.fieldnames, values), **fields)

    def pack(self, mav: Any, force_mavlink1: bool = False) -> Any:
        values = [getattr(self, name) for name in self.fieldnames]
        return self._pack(mav, self.crc_extra, self.unpacker.pack(*values), force_mavlink1)


mav.mavlink_map.setdefault(_Basic.id, _Basic)
TYPES = {one.msgname: one for one in mav.mavlink_map.values()}


class Codec(mav.MAVLink):  # type: ignore[misc]
    """Encodes and decodes the messages of one line, or of one sender of datagrams.

    `key` is the secret key of signing, 32 bytes: with it, messages that are unsigned, or older than others of
    their sender, are rejected. `counters` counts rejections.
    """

    def __init__(self, key: Optional[bytes], counters: Counter[str]) -> None:
        super().__init__(None)
        self.robust_parsing, self.buf_index, self._counters = True, 0, counters
        if key is not None:
            self.signing.secret_key, self.signing.sign_outgoing = key, True
            self.signing.timestamp = int((time.time() - SIGNING_BEGIN) * SIGNING_STEPS)

    def to_bytes(self, name: str, sender: Ids, sequence: int, **fields: Any) -> bytes:
        """Encode a message. Omitted numbers are 0; a text is bytes."""
        self.srcSystem, self.srcComponent, self.seq = *sender, sequence
        kind = TYPES[name]
        return bytes(kind(**{**dict.fromkeys(kind.fieldnames, 0), **fields}).pack(self))

    def messages(self, data: bytes, is_datagram: bool = False) -> list[Message]:
        """Process bytes from the line, and return the messages that they complete.

        Incomplete data at the end of a datagram are dropped. Messages of other dialects are skipped.
        """
        found = []
        while (one := self.parse_char(data)) is not None or is_datagram and self.buf_len():
            data, is_frame = b"", True
            if one is None:  # incomplete: it must not hide others
                self._counters["truncated"] += 1
                self.buf_index += 1
            elif isinstance(one, mav.MAVLink_bad_data):
                kind = REFUSED.get(one.reason, "damaged")
                self._counters[kind] += 1
                is_frame = kind != "damaged"
            elif isinstance(one, mav.MAVLink_unknown):
                is_frame = self.buf[self.buf_index :][:1] in (b"", b"\xfd", b"\xfe")
            else:
                sender = one.get_srcSystem(), one.get_srcComponent()
                found.append(Message(one.get_type(), sender, one.get_seq(), one))
            if one and not is_frame:  # a false start may hide the frames behind it
                self.buf[: self.buf_index], self.buf_index = one.data[1:], 0
        del self.buf[: self.buf_index]
        self.buf_index = 0
        return found

    def check_signature(self, msgbuf: bytearray, srcSystem: int, srcComponent: int) -> bool:
        """A forged signature must not change the stored timestamps, as it does in pymavlink."""
        digest = sha256(self.signing.secret_key + msgbuf[:-6]).digest()[:6]
        is_genuine = compare_digest(digest, bytes(msgbuf[-6:]))
        return is_genuine and bool(super().check_signature(msgbuf, srcSystem, srcComponent))
