"""Seeds and a dictionary for the fuzzers, so that they start with valid input.

fuzz/core/*_fuzz.cpp define the input formats: for `messages`, a byte for the direction (0 is to the
board), the id, and the body; for `framing`, steps of an opcode and the bytes that it feeds.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

from sbgcgen.model import Field, Layout, Message, Struct
from sbgcgen.oracle.codec import scalar_of
from sbgcgen.oracle.compose import Choice, Places, first_that_fits, full_context
from sbgcgen.oracle.edges import counting
from sbgcgen.oracle.frames import header_of, write_frame
from sbgcgen.targets import Target

_WRITE_FRAME = 240
_FLUSH = 250
_FEED_ALL = 255
_LARGEST_CHUNK = 239
_LARGEST_STREAM = 2000


class Seeds(Target):
    """The seed corpora of the fuzzers, and their dictionary."""

    def files(self, layout: Layout, project: Path) -> Iterator[tuple[str, bytes]]:
        """The seeds and the dictionary by path."""
        yield "fuzz/sbgc.dict", _dictionary(layout).encode()
        bodies = {id(message): _bodies(message) for message in layout.messages}
        for message in layout.messages:
            head = bytes((message.direction == "from_board", message.id))
            name = f"fuzz/messages/{message.direction}_{message.identifier}"
            for number, body in enumerate(bodies[id(message)]):
                yield f"{name}_{number}", head + body
        for family in layout.families:
            for framing in layout.framings if family.messages else ():
                frames = [
                    write_frame(framing, message.id, bodies[id(message)][0])
                    for message in family.messages
                ]
                stream = b"".join(frames)[:_LARGEST_STREAM]
                name = f"fuzz/framing/{family.name}_{framing.name}"
                yield f"{name}_whole", bytes((_FEED_ALL,)) + stream
                yield f"{name}_cut", b"".join(_cut(stream))
                yield f"{name}_noise", b"".join(_cut(_noisy(layout, frames)))
        yield "fuzz/framing/written", b"".join(_written(layout))
        yield "fuzz/framing/no_frames", b"".join(_no_frames(layout))


def _bodies(message: Message) -> list[bytes]:
    """A body with all optional parts, and a minimal one."""
    places = Places()
    short = Choice(places, short=True)
    full = Choice(places, round=1, context=full_context(message))
    bodies = [first_that_fits(message, full, short)]
    bodies.append(first_that_fits(message, short))
    return list(dict.fromkeys(bodies))


# Streams


def _chunk(data: bytes) -> bytes:
    return bytes((len(data),)) + data


def _cut(stream: bytes) -> Iterator[bytes]:
    """The stream in chunks of various sizes."""
    sizes = (1, 3, 4, 5, 17, 64, _LARGEST_CHUNK, 2)
    at = step = 0
    while at < len(stream):
        size = sizes[step % len(sizes)]
        yield _chunk(stream[at : at + size])
        at += size
        step += 1
    yield bytes((_FLUSH,))


def _noisy(layout: Layout, frames: Iterable[bytes]) -> bytes:
    """Frames with noise between them; some are damaged or truncated."""
    starts = bytes(framing.start for framing in layout.framings)
    noise = (b"", starts[:1], b"\x00\xff", starts * 3, counting(20))
    result = b""
    for number, frame in enumerate(frames):
        result += noise[number % len(noise)]
        if number % 3 == 1:
            result += frame[:-1] + bytes(((frame[-1] + 1) % 256,))
        elif number % 3 == 2:
            result += frame[: len(frame) // 2]
        else:
            result += frame
    return result[:_LARGEST_STREAM]


def _written(layout: Layout) -> Iterator[bytes]:
    """Steps in which the fuzzer writes a frame: id, body size and space, then the body."""
    for size in (0, 1, 15, 16, 124, 250):
        for space in (size + 4, 255):
            for framing in range(len(layout.framings)):
                id = layout.messages[0].id if layout.messages else 1
                yield bytes((_WRITE_FRAME + framing, id, size, space)) + counting(size)


def _no_frames(layout: Layout) -> Iterator[bytes]:
    """Data that begins like a frame: id 0, a header without a body, bad checksums."""
    for framing in layout.framings:
        good = header_of(framing, 1, 0)
        bad = good[:-1] + bytes(((good[-1] + 1) % 256,))
        for header in (header_of(framing, 0, 0), header_of(framing, 1, 255), good, bad):
            yield _chunk(header + b"\xff")
            yield bytes((_FLUSH,))


# The dictionary


def _dictionary(layout: Layout) -> str:
    """Words with a meaning in the protocol, in libFuzzer's format."""
    words: dict[str, bytes] = {f"start_{f.name}": bytes((f.start,)) for f in layout.framings}
    for message in layout.messages:
        size = message.min_size
        for framing in layout.framings:
            name = f"header_{framing.name}_{message.direction}_{message.identifier}"
            words[name] = header_of(framing, message.id, size)
    for message in layout.messages:
        for size in (message.min_size, message.max_size):
            words[f"size_{size}"] = bytes((size,))
        for field in _fields(message.fields):
            words.update(_words_of(field))
    unique: dict[bytes, str] = {}
    for name, word in words.items():
        unique.setdefault(word, name)
    return "".join(f'{name}="{_escaped(word)}"\n' for word, name in unique.items())


def _fields(fields: tuple[Field, ...]) -> Iterator[Field]:
    """The fields, including those of structs."""
    for field in fields:
        yield field
        if isinstance(field.type, Struct):
            yield from _fields(field.type.fields)


def _words_of(field: Field) -> Iterator[tuple[str, bytes]]:
    """Special values of a field, and the values in its condition."""
    for special in field.special:
        scalar = scalar_of(field.type)
        value = special.value % (1 << 8 * scalar.size)
        yield f"{field.name}_{special.value}", value.to_bytes(scalar.size, "little")
    if field.when and field.when.enum:
        size = field.when.enum.scalar.size
        when = field.when
        for named in (*when.values, *when.flags, *when.any_flags, *when.no_flags):
            yield named.identifier, (named.value % (1 << 8 * size)).to_bytes(size, "little")


def _escaped(word: bytes) -> str:
    return "".join(f"\\x{byte:02X}" for byte in word)
