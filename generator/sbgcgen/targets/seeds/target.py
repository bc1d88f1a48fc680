"""Seeds and a dictionary for the fuzzers, so that they start with valid input.

fuzz/ defines the input formats: for `messages`, a byte for the direction (0 is to the board), the id,
and the body; for `framing`, `session` and `board`, steps of an opcode and its operands; for `json`,
lines as `sbgc encode` reads them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

from sbgcgen.model import Field, Layout, Message, all_fields
from sbgcgen.oracle.codec import CodecError, scalar_of
from sbgcgen.oracle.compose import Choice, Places, compose, first_that_fits, full_context
from sbgcgen.oracle.decoding import decode
from sbgcgen.oracle.edges import counting
from sbgcgen.oracle.encoding import encode
from sbgcgen.oracle.frames import header_of, write_frame
from sbgcgen.oracle.json_values import plain, to_json
from sbgcgen.oracle.vectors import cases_of, typical_vector
from sbgcgen.targets import Target

_WRITE_FRAME = 240
_FLUSH = 250
_FEED_ALL = 255
_LARGEST_CHUNK = 239
_LARGEST_STREAM = 2000


class Seeds(Target):
    """The seed corpora of the fuzzers, and their dictionary. Not committed: the build makes them."""

    committed = False
    help = "write the seeds of the fuzzers; they are not part of generated/"
    mark = "sbgc.dict"

    def files(self, layout: Layout, project: Path) -> Iterator[tuple[str, bytes]]:
        yield "sbgc.dict", _dictionary(layout).encode()
        bodies = {id(message): _bodies(message) for message in layout.messages}
        for message in layout.messages:
            head = bytes((message.direction == "from_board", message.id))
            name = f"messages/{message.direction}_{message.identifier}"
            for number, body in enumerate(bodies[id(message)]):
                yield f"{name}_{number}", head + body
        for family in layout.families:
            for framing in layout.framings if family.messages else ():
                frames = [
                    write_frame(framing, message.id, bodies[id(message)][0])
                    for message in family.messages
                ]
                stream = b"".join(frames)[:_LARGEST_STREAM]
                name = f"framing/{family.name}_{framing.name}"
                yield f"{name}_whole", bytes((_FEED_ALL,)) + stream
                yield f"{name}_cut", b"".join(_cut(stream))
                yield f"{name}_noise", b"".join(_cut(_noisy(layout, frames)))
            if family.messages:
                requests = [
                    (message.id, body)
                    for message in family.messages
                    if message.direction != "from_board"
                    for body in dict.fromkeys([*bodies[id(message)], *_various(message)])
                ]
                yield f"session/{family.name}", b"".join(_session(requests))
                for name, options in _BOARDS.items():
                    yield f"board/{family.name}_{name}", b"".join(_board(options, requests))
                lines = [_line(m, body) for m in family.messages for body in bodies[id(m)][:2]]
                yield f"json/{family.name}", "".join(lines).encode()
        yield "eeprom/variables", b"".join(_variables(layout))
        for name, text in _hostile_json().items():
            yield f"json/{name}", text.encode()
        yield "framing/written", b"".join(_written(layout))
        yield "framing/no_frames", b"".join(_no_frames(layout))


def _bodies(message: Message) -> list[bytes]:
    """A body with all optional parts, a minimal one, one for each condition on a field, and surplus."""
    places = Places()
    short = Choice(places, short=True)
    full = Choice(places, round=1, context=full_context(message))
    bodies = [first_that_fits(message, full, short)]
    bodies.append(first_that_fits(message, short))
    for case in cases_of(message):
        if "forced" in case:
            try:
                bodies.append(encode(message, compose(message, Choice(places, round=1, **case))))
            except CodecError:
                pass
    if message.takes_surplus:
        bodies.append(bodies[0].ljust(message.max_size + 1, b"\x5a"))
    return list(dict.fromkeys(bodies))


_MOST_ROUNDS = 4
_SMALL = 12  # bytes, which may be the values of a few enums


def _various(message: Message) -> Iterator[bytes]:
    """A typical body, and bodies with edge values: in a small message, with each enum value."""
    if not message.max_size:
        return
    typical = typical_vector(message).body
    if typical is not None:
        yield typical
    yield b"\xff" * message.min_size
    first = Choice(Places(), short=True, context=full_context(message))
    compose(message, first)
    rounds: list[tuple[int, int | None]] = [(n, None) for n in range(first.rounds["free"])]
    rounds += [(number, number) for number in sorted(first.numbers["free"])]
    most = len(rounds) if message.max_size <= _SMALL else _MOST_ROUNDS
    for round, named in rounds[:most]:
        choice = Choice(first.places, round, named, first.context, short=True)
        try:
            yield encode(message, compose(message, choice))
        except CodecError:
            pass


# Conversations


_Requests = Iterable[tuple[int, bytes]]

# The options of a session: without pacing.
_UNPACED = 8
# Steps of a session; those from 64 on poll.
_REQUEST, _FIRST_RESPONSE, _LAST_RESPONSE, _CONFIRMATION, _WAIT = 120, 76, 136, 66, 68
_EXPECT_CONFIRMATION = 1
# The options of boards: an old one, and the newest, with instantaneous calibrations.
_BOARDS = {"old": 1 + 64, "new": 3 + 64}
# Steps of a board, which sends pending data; in a frame of the first or the last framing.
_FRAMES, _MILLISECONDS, _NEXT = (135, 195), 128, 130


def _session(requests: _Requests) -> Iterator[bytes]:
    """Each request with its first response, its last one, or a confirmation."""
    yield bytes((_UNPACED,))
    for id, body in requests:
        for flags, answer in (
            (0, (_FIRST_RESPONSE,)),
            (_EXPECT_CONFIRMATION, (_LAST_RESPONSE,)),
            (_EXPECT_CONFIRMATION, (_CONFIRMATION, id)),
        ):
            yield bytes((_REQUEST, id, flags, len(body))) + body
            yield bytes(answer)
        yield bytes((_WAIT, 22))  # 2^22 us


def _board(options: int, requests: _Requests) -> Iterator[bytes]:
    """Each request, and time to handle it."""
    yield bytes((options,))
    for number, (id, body) in enumerate(requests):
        yield bytes((_FRAMES[number % len(_FRAMES)], id, len(body))) + body
        yield bytes((_MILLISECONDS, 10, _NEXT))


_SET_VARIABLE = 6


def _variables(layout: Layout) -> Iterator[bytes]:
    """Steps that set each adjustable variable to its limits."""
    for variable in layout.variables:
        for value in (variable.minimum, variable.maximum):
            yield bytes((_SET_VARIABLE, variable.id)) + (value % (1 << 32)).to_bytes(4, "big")


# JSON


def _line(message: Message, body: bytes) -> str:
    """The line for a body, with the project's own names."""
    try:
        fields = decode(message, body, full_context(message))
    except CodecError:
        fields = decode(message, body)  # a minimal one
    return to_json({"message": message.name, "fields": plain(fields)})


def _hostile_json() -> dict[str, str]:
    """Lines that are nested deeper or wider than any message."""
    deep = 70
    wide = ",".join(f'"k{number}":{number}' for number in range(300))
    return {
        "deep_lists": "[" * deep + "]" * deep,
        "deep_objects": '{"a":' * deep + "1" + "}" * deep,
        "wide_list": "[" + ",".join(["0"] * 1000) + "]",
        "wide_object": "{" + wide + "}",
        "repeated_key": "{" + wide + ',"k7":0}',
    }


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
        for field in all_fields(message.fields):
            words.update(_words_of(field))
    unique: dict[bytes, str] = {}
    for name, word in words.items():
        unique.setdefault(word, name)
    escaped = {name: "".join(f"\\x{byte:02X}" for byte in word) for word, name in unique.items()}
    return "".join(f'{name}="{text}"\n' for name, text in escaped.items())


def _words_of(field: Field) -> Iterator[tuple[str, bytes]]:
    """Special values of a field, and the values in its condition."""
    for special in field.special:
        scalar = scalar_of(field.type)
        value = special.value % (1 << 8 * scalar.size)
        yield f"{field.name}_{special.value}", value.to_bytes(scalar.size, "little")
    tests = field.when.tests if field.when else ()
    for when in (one for test in tests for one in dict(test.elements).values() or (test,)):
        size = when.enum.scalar.size if when.enum else 0
        for named in (*when.values, *when.flags, *when.any_flags, *when.no_flags):
            yield named.identifier, (named.value % (1 << 8 * size)).to_bytes(size, "little")
