"""Captures, built from the description of the format, not by the library."""

from __future__ import annotations

import struct
import zlib
from typing import Any

from sbgc_command import frame

FROM_BOARD, TO_BOARD, NOTE = 1, 2, 3
ANGLES_REQUEST = frame(73)
ANGLES = frame(73, struct.pack("<9h", *range(9)))


def session(start: float = 0.0) -> bytes:
    head = b"\x89SBGC\r\n\x1a" + struct.pack("<HHQ", 1, 0, int(start * 1e6))
    return head + struct.pack("<I", zlib.crc32(head))


def record(kind: int, seconds: float, data: bytes) -> bytes:
    head = struct.pack("<BBHQ", 0xA5, kind, len(data), round(seconds * 1e6)) + data
    return head + struct.pack("<I", zlib.crc32(head))


def records(capture: bytes) -> list[tuple[int, bytes]]:
    """Returns kind and bytes of the records of a capture with one session."""
    assert capture[:8] == session()[:8]
    assert zlib.crc32(capture[:20]) == struct.unpack_from("<I", capture, 20)[0]
    result = []
    at = 24
    while at < len(capture):
        mark, kind, size, _ = struct.unpack_from("<BBHQ", capture, at)
        end = at + 12 + size
        assert mark == 0xA5
        assert zlib.crc32(capture[at:end]) == struct.unpack_from("<I", capture, end)[0]
        result.append((kind, capture[at + 12 : end]))
        at = end + 4
    return result


CAPTURE = (
    session(1_700_000_000)
    + record(NOTE, 0, b"serial port /dev/ttyUSB0, 115200 8N1")
    + record(TO_BOARD, 0.25, ANGLES_REQUEST)
    + record(FROM_BOARD, 0.5, b"??" + ANGLES[:10])
    + record(TO_BOARD, 0.625, ANGLES_REQUEST)
    + record(FROM_BOARD, 1.75, ANGLES[10:] + ANGLES)
)


def keys(lines: list[Any], *names: str) -> list[Any]:
    return [tuple(line[name] for name in names) for line in lines]
