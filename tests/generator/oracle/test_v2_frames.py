"""Frames of framing v2 from outside: their checksums, found independently, and their bodies."""

from __future__ import annotations

import json
from typing import Any

import pytest

from sbgcgen.model import Layout
from sbgcgen.oracle.decoding import decode
from sbgcgen.oracle.encoding import encode
from sbgcgen.oracle.frames import choose_message, forms_of, read_frames, write_frame
from support import PROJECT, project_layout

FRAMES: list[dict[str, Any]] = json.loads(
    (PROJECT / "tests" / "data" / "v2_frames.json").read_text(encoding="utf-8")
)
MEANINGS = [frame["meaning"] for frame in FRAMES]
HEADER, TRAILER = 4, 2


def crc16(data: bytes) -> int:
    """A CRC-16, bit by bit: polynomial 0x8005, initially 0, bits of each byte from the lowest."""
    register = 0
    for byte in data:
        for bit in range(8):
            top = register >> 15 ^ byte >> bit & 1
            register = register << 1 & 0xFFFF ^ (0x8005 if top else 0)
    return register


@pytest.fixture(scope="module")
def layout() -> Layout:
    return project_layout()


def test_the_checksum_is_that_of_the_catalogue() -> None:
    assert crc16(b"123456789") == 0xBCDD
    assert crc16(b"") == 0


@pytest.mark.parametrize("frame", FRAMES, ids=MEANINGS)
def test_the_parts_of_a_frame(frame: dict[str, Any]) -> None:
    data = bytes.fromhex(frame["hex"])
    start, id_, size, check = data[:HEADER]
    assert start == ord("$")
    assert check == (id_ + size) % 256
    assert len(data) == HEADER + size + TRAILER
    assert int.from_bytes(data[-TRAILER:], "little") == crc16(data[1:-TRAILER])


@pytest.mark.parametrize("frame", FRAMES, ids=MEANINGS)
def test_the_body_of_a_frame(frame: dict[str, Any], layout: Layout) -> None:
    data = bytes.fromhex(frame["hex"])
    id_, body = data[1], data[HEADER:-TRAILER]
    message = choose_message(forms_of(layout), frame["direction"], id_, len(body))
    assert message.command == frame["command"]
    assert decode(message, body) == frame["fields"]
    assert encode(message, frame["fields"]) == body


@pytest.mark.parametrize("frame", FRAMES, ids=MEANINGS)
def test_the_spec_describes_the_framing(frame: dict[str, Any], layout: Layout) -> None:
    data = bytes.fromhex(frame["hex"])
    framing = next(f for f in layout.framings if f.start == data[0])
    assert write_frame(framing, data[1], data[HEADER:-TRAILER]) == data
    (found,) = read_frames(layout.framings, b"\x24" + data + b"\x00")
    assert (found.offset, found.id, found.body) == (1, data[1], data[HEADER:-TRAILER])
    for at in range(1, len(data)):
        for bit in range(8):
            damaged = bytearray(data)
            damaged[at] ^= 1 << bit
            assert not list(read_frames([framing], bytes(damaged))), f"bit {bit} of byte {at}"
