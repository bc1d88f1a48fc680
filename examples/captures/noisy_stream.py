"""Generates noisy_stream.bin: frames of real boards between noise, text and truncated frames."""

from __future__ import annotations

import re
from pathlib import Path

HERE = Path(__file__).resolve().parent


def frames(name: str) -> list[bytes]:
    """Returns the frames of a hex capture, one per block after a comment line."""
    text = (HERE / name).read_text(encoding="utf-8")
    blocks = re.split(r"^#.*\n", text, flags=re.MULTILINE)
    hexes = (re.sub(r"#.*|\s", "", block) for block in blocks)
    return [bytes.fromhex(digits) for digits in hexes if digits]


def noise(seed: int, size: int) -> bytes:
    """Returns pseudorandom bytes that depend only on the seed."""
    result = bytearray()
    for _ in range(size):
        seed = (seed * 1103515245 + 12345) & 0x7FFFFFFF
        result.append(seed >> 16 & 0xFF)
    return bytes(result)


def stream() -> bytes:
    """Returns the stream: each round contains every frame once, with other bytes before it."""
    request, info = frames("board_info.hex")
    (angles,) = frames("angles.hex")
    broken = frames("broken.hex")
    result = bytearray()
    for i in range(12):
        result += noise(i, 5 * i) + request
        result += b"gimbal: temperature 41\r\n" + info
        result += angles[: 7 + 4 * i] + angles  # a truncated frame, then a complete one
        result += broken[i % len(broken)] + b">>>" + angles
    return bytes(result)


if __name__ == "__main__":
    (HERE / "noisy_stream.bin").write_bytes(stream())
