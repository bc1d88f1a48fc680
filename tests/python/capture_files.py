"""Writes captures as runtime/io/include/sbgc/io/capture.hpp describes them."""

from __future__ import annotations

import struct
import zlib
from pathlib import Path

FROM_BOARD, TO_BOARD, NOTE = 1, 2, 3


def _summed(data: bytes) -> bytes:
    return data + struct.pack("<I", zlib.crc32(data))


def session(start: int = 0) -> bytes:
    return _summed(b"\x89SBGC\r\n\x1a" + struct.pack("<HHQ", 1, 0, start))


def record(kind: int, time: int, data: bytes) -> bytes:
    return _summed(struct.pack("<BBHQ", 0xA5, kind, len(data), time) + data)


def frame(id: int, body: bytes) -> bytes:
    head = bytes([id, len(body), (id + len(body)) % 256])
    return b">" + head + body + bytes([sum(body) % 256])


def write(path: Path, *parts: bytes) -> Path:
    path.write_bytes(b"".join(parts))
    return path
