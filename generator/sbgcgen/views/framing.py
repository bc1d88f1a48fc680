"""Describes the parts of a frame."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from sbgcgen.model import BODY, ID, SIZE, START, Crc, Framing

_KINDS = {
    "sum8": "the sum of {}, modulo 256",
    "sum16": "the sum of {}, modulo 65536, the low byte first",
    "xor8": "the exclusive or of {}",
    "crc8": "CRC-8 of {}",
    "crc16": "CRC-16 of {}",
    "crc32": "CRC-32 of {}",
}
_ALL_BYTES = "all bytes of the body"


@dataclass(frozen=True)
class FramePart:
    """A part of a frame: offset, name, size and description, as text."""

    at: str
    name: str
    size: str
    text: str


def frame_parts(framing: Framing) -> list[FramePart]:
    """The parts of a frame in wire order."""
    after_body = f"{framing.header_size} + size"
    parts = [_part(framing, part, str(framing.place(part))) for part in framing.header]
    most = framing.max_body
    parts.append(
        FramePart(str(framing.header_size), BODY, f"0 to {most} bytes", "Content of the message.")
    )
    for part in framing.trailer:
        offset = framing.place(part)
        parts.append(_part(framing, part, f"{after_body} + {offset}" if offset else after_body))
    return parts


def checksum_text(framing: Framing, name: str) -> str:
    """The definition of a checksum: "the sum of id and size, modulo 256"."""
    checksum = framing.checksum(name)
    assert checksum is not None
    covers = [_ALL_BYTES if part == BODY else part_name(part) for part in checksum.covers]
    words = " and ".join(filter(None, [", ".join(covers[:-1]), covers[-1]]))
    return _KINDS[checksum.kind].format(words)


def crc_text(crc: Crc) -> str:
    """The definition of a cyclic redundancy check, in the terms of catalogues."""
    order = {True: "least", False: "most"}
    digits = crc.width // 4
    words = [
        f"CRC-{crc.width} with the polynomial 0x{crc.polynomial:0{digits}X}",
        f"initial value 0x{crc.initial:0{digits}X}",
        f"bytes {order[crc.reflect_in]} significant bit first",
        f"result {'' if crc.reflect_out else 'not '}reflected",
        f"final XOR 0x{crc.final_xor:0{digits}X}",
    ]
    check = crc.check if crc.check is not None else crc.value(b"123456789")
    return f"{', '.join(words)}; the check value of \"123456789\" is 0x{check:0{digits}X}"


def part_name(part: str) -> str:
    """header_checksum -> header checksum."""
    return part.replace("_", " ")


def _part(framing: Framing, part: str, at: str) -> FramePart:
    size = framing.size_of(part)
    words = {
        START: f"Always 0x{framing.start:02X}, the character {framing.start:c}.",
        ID: "Command id, 1 to 255.",
        SIZE: f"Size of the body in bytes, 0 to {framing.max_body}.",
    }
    if part not in words:
        checksum = checksum_text(framing, part)
        words[part] = f"{checksum[0].upper()}{checksum[1:]}."
    return FramePart(at, part_name(part), f"{size} byte{'s' if size > 1 else ''}", words[part])


def sums_in(frame: bytes, framing: Framing) -> Iterator[tuple[str, bytes, int]]:
    """The name of each checksum in a frame, the bytes that it covers, and its value."""
    body_end = len(frame) - framing.trailer_size
    parts = {BODY: frame[framing.header_size : body_end]}
    for part in (*framing.header, *framing.trailer):
        begin = framing.place(part) + (0 if part in framing.header else body_end)
        parts[part] = frame[begin : begin + framing.size_of(part)]
    for checksum in framing.checksums:
        covered = b"".join(parts[part] for part in checksum.covers)
        yield part_name(checksum.name), covered, int.from_bytes(parts[checksum.name], "little")
