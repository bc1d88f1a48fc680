"""Tests of the reference codec, and of the completeness of its vectors."""

from __future__ import annotations

import json
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache
from typing import Any

import pytest

from sbgcgen.model import Announced, Blob, Checksum, Crc, Enum, Field, Framing, Layout, Leaf
from sbgcgen.model import Message, Packed, Struct
from sbgcgen.oracle.codec import CodecError
from sbgcgen.oracle.decoding import decode
from sbgcgen.oracle.encoding import encode
from sbgcgen.oracle.frames import choose_message, header_of, read_frames, write_frame
from sbgcgen.oracle.json_values import float_from_bits, float_to_bits, plain, text_from_bytes
from sbgcgen.oracle.json_values import text_to_bytes
from sbgcgen.targets import target
from support import PROJECT, layout_of, message_of, project_layout

Line = dict[str, Any]


@lru_cache(maxsize=None)
def lines() -> tuple[Line, ...]:
    """Returns every vector of the real protocol."""
    return tuple(
        json.loads(line)
        for path, content in target("vectors").files(project_layout(), PROJECT)
        if path.startswith("vectors/")
        for line in content.splitlines()
    )


@lru_cache(maxsize=None)
def messages() -> dict[tuple[str, str], Message]:
    """Returns the messages by direction and name."""
    return {(m.direction, m.name): m for m in project_layout().messages}


def message_in(line: Line) -> Message:
    """Returns the message of a vector."""
    return messages()[line["direction"], line["message"]]


# The codec

FAMILY = """
family: probe
summary: Probes.
enums:
  Kind:
    type: u8
    summary: Kinds.
    source: L1
    values:
      SMALL: {value: 1, summary: Small.}
      LARGE: {value: 2, summary: Large.}
commands:
  CMD_PROBE:
    id: 9
    summary: A probe.
    from_board:
      source: L1
      fields:
        - {name: KIND, type: Kind, summary: Kind.}
        - {name: "ANGLE[axis]", type: i16, summary: Angles.}
        - {name: SMALL_ONE, type: u16, when: {field: KIND, is: SMALL}, summary: One.}
        - {name: LARGE_ONE, type: f32, when: {field: KIND, is: LARGE, may_be_missing: true}, summary: One.}
        - {name: NAME, type: "text[4]", summary: Name.}
        - {name: NUM, type: u8, summary: Count.}
        - {name: "VALUES[NUM]", type: i16, summary: Values.}
    to_board:
      source: L1
      effect: reads
      summary: Asks.
      answer: none
      forms:
        simple:
          summary: Short.
        extended:
          summary: Long.
          fields:
            - {name: NOTE, type: string, summary: Note.}
            - {name: "DATA[]", type: u8, summary: Data.}
"""


@pytest.fixture(name="layout")
def _layout(tmp_path: Any) -> Layout:
    return layout_of(tmp_path, FAMILY)


def test_a_body_decodes_by_the_model(layout: Layout) -> None:
    probe = message_of(layout, "Probe")
    body = bytes.fromhex("01 0100 ffff 0080 3412 41ff0000 02 0500 faff 99")
    fields = decode(probe, body)
    assert fields == {
        "kind": 1,
        "angle": {"roll": 1, "pitch": -1, "yaw": -32768},
        "small_one": 0x1234,
        "name": "A\uf7ff",
        "num": 2,
        "values": [5, -6],
        "tail": "99",
    }
    assert list(fields)[:3] == ["kind", "angle", "small_one"]
    assert encode(probe, fields) == body


def test_floats_and_texts_lose_nothing() -> None:
    for bits in (0, 0x80000000, 1, 0x3F800000, 0x7F800000, 0xFF800000, 0x7FC00000, 0x7F800001):
        assert float_to_bits(float_from_bits(bits)) == bits
    for data in (b"", bytes(range(256)), "\u20ac\uf780\U0001f4f7".encode(), b"\xed\xa0\x80"):
        assert text_to_bytes(text_from_bytes(data)) == data
    wrong: Any
    for wrong in ("1", None, [], 1e39):
        with pytest.raises(ValueError):
            float_to_bits(wrong)


def frames_in(framing: Framing, stream: bytes) -> list[tuple[int, int, bytes]]:
    """Returns offset, id and body of the frames in a stream."""
    return [(f.offset, f.id, f.body) for f in read_frames([framing], stream)]


def test_frames_are_found_after_false_starts(layout: Layout) -> None:
    frame = write_frame(layout.framing, 67, b"\x01\x02")
    assert frame == bytes.fromhex("3e 43 02 45 01 02 03")
    stream = b"\x3e\x3e\x00\x00\x00" + frame + frame[:-1] + b"\x09" + frame
    found = frames_in(layout.framing, stream)
    assert found == [(5, 67, b"\x01\x02"), (19, 67, b"\x01\x02")]
    with pytest.raises(CodecError, match="invalid_id"):
        write_frame(layout.framing, 0, b"")


def test_frames_are_as_the_framing_says(layout: Layout) -> None:
    """Uses a start byte, a header order and checksums that the real protocol does not have."""
    checksums = (
        Checksum("head", "sum8", ("start", "id")),
        Checksum("size_again", "sum8", ("size",)),
        Checksum("all", "sum8", ("start", "head", "id", "size", "size_again", "body")),
    )
    framing = replace(
        layout.framing,
        start=0x24,
        header=("start", "size", "size_again", "id", "head"),
        trailer=("all",),
        checksums=checksums,
    )
    frame = write_frame(framing, 0xFF, b"\x01\x02")
    assert frame == bytes.fromhex("24 02 02 ff 23 01 02 4d")
    assert header_of(framing, 0xFF, 2) == frame[:5]
    wrong = b"\x24\x02\x03" + frame[3:]
    assert frames_in(framing, wrong + frame) == [(8, 0xFF, b"\x01\x02")]
    small = replace(framing, max_body=1)
    assert not frames_in(small, frame)


# Catalogued checks of 16 bits, with the value of "123456789".
CATALOGUE = {
    "ARC": (Crc(0x8005, 0, True, True, 0), 0xBB3D),
    "XMODEM": (Crc(0x1021, 0, False, False, 0), 0x31C3),
    "GENIBUS": (Crc(0x1021, 0xFFFF, False, False, 0xFFFF), 0xD64E),
    "MCRF4XX": (Crc(0x1021, 0xFFFF, True, True, 0), 0x6F91),
    "of the protocol": (Crc(0x8005, 0, True, False, 0), 0xBCDD),
}


@pytest.mark.parametrize("name", CATALOGUE)
def test_crc(name: str) -> None:
    crc, check = CATALOGUE[name]
    assert crc.value(b"123456789") == check


# The vectors


def test_vectors_hold_both_ways() -> None:
    for line in lines():
        if "message" not in line:
            continue
        message = message_in(line)
        if "hex" in line:
            body, context = bytes.fromhex(line["hex"]), line.get("context")
            if "error" in line:
                with pytest.raises(CodecError) as caught:
                    decode(message, body, context)
            else:
                fields = plain(decode(message, body, context))
                assert json.dumps(fields) == json.dumps(line["fields"])
                assert encode(message, line["fields"]) == body, line["why"]
        else:
            with pytest.raises(CodecError) as caught:
                encode(message, line["fields"])
        if "error" in line:
            error = caught.value
            said = {"code": error.code, "field": error.field, "offset": error.offset}
            assert line["error"] == said


def test_vectors_are_small() -> None:
    files = dict(target("vectors").files(project_layout(), PROJECT))
    assert sum(map(len, files.values())) < 3_400_000


# The ratchet


def everything_said() -> dict[int, tuple[list[Message], list[Line]]]:
    """Returns the messages of each body (some share one) and the fields of its vectors."""
    found: dict[int, tuple[list[Message], list[Line]]] = defaultdict(lambda: ([], []))
    for message in project_layout().messages:
        found[id(message.body)][0].append(message)
    for line in lines():
        if "message" in line and "fields" in line and "hex" in line:
            found[id(message_in(line).body)][1].append(line["fields"])
    return found


def all_leaves(leaves: tuple[Leaf, ...]) -> Iterator[Leaf]:
    """Yields the leaves, including the alternatives of tagged unions."""
    for leaf in leaves:
        yield leaf
        yield from all_leaves(leaf.cases)


def values_at(fields: Any, path: str) -> list[Any]:
    """Returns every value at a leaf's path in a message, for all elements of its lists."""
    found = [fields]
    for step in path.replace("[", ".[").split("."):
        found = [value for inner in found for value in step_into(inner, step)]
    return found


def step_into(value: Any, step: str) -> list[Any]:
    """Returns the values one step down a path; nothing for an absent optional member."""
    if step == "[]":
        return list(value)
    if step.startswith("["):
        index = int(step[1:-1])
        return [value[index]] if index < len(value) else []
    return [value[step]] if step in value else []


_BITS = (8, 16, 24, 32, 64)
LIMITS: dict[str, tuple[Any, ...]] = {f"u{bits}": (0, 2**bits - 1) for bits in _BITS}
LIMITS |= {f"i{bits}": (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1) for bits in _BITS}
LIMITS |= {name: ("inf", "-inf", 0.0) for name in ("f32", "f64")}


def wanted_of(field: Field, leaf: Leaf) -> Iterator[tuple[str, Any]]:
    """Yields the values that a leaf must have in some vector, each with the reason."""
    if field.is_counter:
        return  # test_nothing_is_without_a_vector checks the lengths of lists
    for number in LIMITS.get(leaf.type, ()):
        yield "limit of the type", number
    for limit in (field.minimum, field.maximum):
        if limit is not None:
            value = float_from_bits(float_to_bits(float(limit)))
            yield "limit of the range", value if leaf.type == "f32" else int(Fraction(limit))
    for special in field.special:
        yield "special value", special.value
    if isinstance(field.type, Enum) and field.type.kind == "enum":
        yield from ((named.name, named.value) for named in field.type.values)


def announced() -> set[str]:
    """Returns the types that messages may announce."""
    contexts = [context for message in project_layout().messages for context in message.contexts]
    return {name for context in contexts if context.announced for name in context.announced.types}


def missing_of(leaf: Leaf, said: list[Line]) -> Iterator[str]:
    """Yields descriptions of the values of a leaf that no vector has."""
    values = [value for fields in said for value in values_at(fields, leaf.path)]
    field = leaf.field
    if not values:
        yield f"{leaf.path}: nothing at all"
    if leaf.type in ("text", "string"):
        yield from missing_lengths(leaf, {len(text_to_bytes(value)) for value in values})
    if isinstance(field.type, (Blob, Struct)) or field.repeats_context:
        return
    lists = (value if isinstance(value, list) else [value] for value in values)
    every = [number for numbers in lists for number in numbers]
    if isinstance(field.type, Announced):
        pairs = {pair for number in every for pair in number.items()}
        missing = {(name, limit) for name in announced() for limit in LIMITS[name]} - pairs
        yield from (f"{leaf.path}: {name} {limit}" for name, limit in missing)
        return
    numbers = set(every)
    if leaf.type in ("u64", "i64"):
        numbers = {int(number) for number in numbers}
    for why, number in wanted_of(field, leaf):
        if number not in numbers:
            yield f"{leaf.path}: {why} {number}"
    for part in field.type.parts if isinstance(field.type, Packed) else ():
        bits = {number & part.bits for number in numbers}
        for value in part.enum.values if part.enum else ():
            if value.value << part.shift not in bits:
                yield f"{leaf.path}: {part.name} {value.name}"
    if isinstance(field.type, Enum) and field.type.kind == "flags":
        for flag in field.type.values:
            hits = {number & flag.value == flag.value for number in numbers}
            if hits != ({True, False} if flag.value else {True}):
                yield f"{leaf.path}: flag {flag.name} set and not set"


def missing_lengths(leaf: Leaf, lengths: set[int]) -> Iterator[str]:
    """Yields descriptions of the lengths of a text that no vector has."""
    assert isinstance(leaf.field.type, Blob)
    full = leaf.field.type.size if leaf.type == "text" else min(leaf.field.type.size or 200, 200)
    least = {1} if leaf.field.fits else {0, 1}
    if not least <= lengths or max(lengths) < (full or 0):
        yield f"{leaf.path}: a text that is empty, or of one byte, or full"


def lengths_of(field: Field, said: list[Line]) -> set[int]:
    """Returns the lengths that a list has in the vectors; for bytes, their number."""
    lists = [fields[field.name] for fields in said if field.name in fields]
    return {len(value) // 2 if isinstance(value, str) else len(value) for value in lists}


def missing_of_message(message: Message, said: list[Line]) -> Iterator[str]:
    """Yields descriptions of the variants of a message that no vector has."""
    for field in message.fields:
        present = {field.name in fields for fields in said}
        if field.when and present != {True, False}:
            yield f"{field.name}: there and not there"
        if field.dim in ("counted", "rest"):
            lengths = lengths_of(field, said)
            least = field.min_count
            short = {least, max(1, least)}
            if not short <= lengths or max(lengths) < min(field.max_count or 2, field.capacity):
                yield f"{field.name}: no list that is as short as can be, of one element, or long"
    appended = [field.name for field in message.fields if field.appended]
    there = {sum(name in fields for name in appended) for fields in said}
    if there != set(range(len(appended) + 1)):
        yield f"bodies of {len(appended) + 1} lengths"
    tails = {len(fields.get("tail", "")) for fields in said}
    is_short = 2 in tails or (message.takes_surplus and len(tails) > 1)
    if (message.keeps_tail or message.takes_surplus) and not (0 in tails and is_short):
        yield "a tail, and none"


def test_nothing_is_without_a_vector() -> None:
    missing = []
    for of_body, said in everything_said().values():
        name = of_body[0].name
        missing += [f"{name}: {m}" for m in missing_of_message(of_body[0], said)]
        for leaf in all_leaves(of_body[0].leaves):
            missing += [f"{name}.{m}" for m in missing_of(leaf, said)]
    assert not missing, "\n".join(missing)


def test_every_message_has_vectors_of_its_own() -> None:
    good = {(l["direction"], l["message"]) for l in lines() if "message" in l and "error" not in l}
    assert good == set(messages())


def test_bodies_that_are_no_message_have_vectors() -> None:
    codes = {(l["direction"], l["error"]["code"]) for l in lines() if "message" not in l}
    assert codes == {
        (direction, code)
        for direction in ("to_board", "from_board")
        for code in ("unknown_command", "unknown_form")
    }


# The seeds of the fuzzers


def test_every_message_has_a_seed_that_decodes() -> None:
    layout = project_layout()
    forms = layout.messages_by_id
    found = set()
    for name, content in target("seeds").files(layout, PROJECT):
        if name.startswith("messages/"):
            direction = "from_board" if content[0] else "to_board"
            message = choose_message(forms, direction, content[1], len(content) - 2)
            decode(message, content[2:])
            found.add((message.direction, message.name))
    asked = {(m.direction, m.name) for one in layout.asked for m in one.forms[1:]}
    assert found == set(messages()) - asked  # without a request, such a body is another message
