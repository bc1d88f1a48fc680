"""Byte sequences from public sources and from the vendor's code of 2026, by the reference codec."""

from __future__ import annotations

import json
from typing import Any

import pytest

from sbgcgen.model import Layout
from sbgcgen.oracle.codec import CodecError, Fields
from sbgcgen.oracle.decoding import decode
from sbgcgen.oracle.encoding import encode
from sbgcgen.oracle.frames import choose_message, read_frames, write_frame
from support import PROJECT, project_layout

Vector = dict[str, Any]


def vectors_of(name: str) -> list[Vector]:
    text = (PROJECT / "tests/data" / f"{name}.json").read_text(encoding="utf-8")
    found: list[Vector] = json.loads(text)
    return found


VECTORS = vectors_of("vectors")
FRAMES = vectors_of("v2_frames")
VENDOR = vectors_of("vendor_2026")
HEADER, TRAILER = 4, 2


def meaning_of(vector: Vector) -> str:
    return str(vector["meaning"])


@pytest.fixture(scope="module")
def layout() -> Layout:
    return project_layout()


def values_of(value: Any) -> list[Any]:
    """Returns the numbers and texts of a field, whatever its shape."""
    if isinstance(value, dict):
        return [one for inner in value.values() for one in values_of(inner)]
    if isinstance(value, list):
        return [one for inner in value for one in values_of(inner)]
    return [value]


def values_named(layout: Layout, id_: int, direction: str, body: bytes, name: str) -> list[Any]:
    """Returns what a body has under a name of the protocol."""
    message = choose_message(layout.messages_by_id, direction, id_, len(body))
    fields: Fields = decode(message, body)
    paths = [
        leaf.path for leaf in message.leaves if leaf.spec_name == name and "[]" not in leaf.path
    ]
    found = []
    for path in paths:
        value: Any = fields
        for step in path.replace("[", ".").replace("]", "").split("."):
            value = value[int(step)] if isinstance(value, list) else value.get(step)
        found += values_of(value)
    return found


@pytest.mark.parametrize("vector", VECTORS, ids=meaning_of)
def test_the_reference_codec_agrees(vector: Vector, layout: Layout) -> None:
    data = bytes.fromhex(vector["hex"])
    direction = vector["direction"]
    if vector["kind"] == "payload":
        bodies = [(vector["command_id"], data)]
    else:
        bodies = [(frame.id, frame.body) for frame in read_frames([layout.framing], data)]
        assert len(bodies) == (1 if vector["expect"] == "valid" else 0)
    for id_, body in bodies:
        message = choose_message(layout.messages_by_id, direction, id_, len(body))
        try:
            fields = decode(message, body)
        except CodecError as error:
            pytest.fail(f"{message.name}: {error}")
        assert encode(message, fields) == body
        for name, value in vector.get("fields", {}).items():
            assert values_named(layout, id_, direction, body, name) == values_of(value), name


@pytest.mark.parametrize("frame", VENDOR, ids=meaning_of)
def test_the_body_of_the_vendor_decodes(frame: Vector, layout: Layout) -> None:
    (found,) = read_frames(layout.framings, bytes.fromhex(frame["hex"]))
    message = choose_message(layout.messages_by_id, frame["direction"], found.id, len(found.body))
    fields = decode(message, found.body)
    assert encode(message, fields) == found.body
    assert "tail" not in fields
    for leaf in message.leaves:
        expected = frame["fields"].get(leaf.spec_name)
        if leaf.path in fields and type(expected) in (int, float):
            assert fields[leaf.path] == expected, leaf.path


def crc16(data: bytes) -> int:
    """A CRC-16, bit by bit: polynomial 0x8005, initially 0, bits of each byte from the lowest."""
    register = 0
    for byte in data:
        for bit in range(8):
            top = register >> 15 ^ byte >> bit & 1
            register = register << 1 & 0xFFFF ^ (0x8005 if top else 0)
    return register


@pytest.mark.parametrize("frame", FRAMES, ids=meaning_of)
def test_a_frame_of_v2_and_its_body(frame: Vector, layout: Layout) -> None:
    data = bytes.fromhex(frame["hex"])
    start, id_, size, check = data[:HEADER]
    body = data[HEADER:-TRAILER]
    assert (start, check, len(body)) == (ord("$"), (id_ + size) % 256, size)
    assert int.from_bytes(data[-TRAILER:], "little") == crc16(data[1:-TRAILER])
    message = choose_message(layout.messages_by_id, frame["direction"], id_, size)
    assert message.command == frame["command"]
    assert decode(message, body) == frame["fields"]
    assert encode(message, frame["fields"]) == body
    framing = next(f for f in layout.framings if f.start == start)
    assert write_frame(framing, id_, body) == data
    (found,) = read_frames(layout.framings, b"\x24" + data + b"\x00")
    assert (found.offset, found.id, found.body) == (1, id_, body)
    for at in range(1, len(data)):
        for bit in range(8):
            damaged = bytearray(data)
            damaged[at] ^= 1 << bit
            assert not list(read_frames([framing], bytes(damaged))), f"bit {bit} of byte {at}"
