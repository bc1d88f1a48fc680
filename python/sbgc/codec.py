"""Conversion between messages and bytes."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import Optional, Union

from sbgc import _core
from sbgc.message import Contexts, Message, known_by, of_library, wrap
from sbgc.msg.protocol import Framing

Bytes = Union[bytes, bytearray, memoryview]


class Direction(IntEnum):
    """The direction of a message: one command id often has different messages in each direction."""

    TO_BOARD = 0
    FROM_BOARD = 1


def _is_from_board(direction: Direction) -> bool:
    if not isinstance(direction, Direction):
        raise TypeError(f"direction: a Direction is needed, not {direction!r}")
    return direction == Direction.FROM_BOARD


def encode(message: Message, framing: Framing = Framing.V1) -> bytes:
    """Return the frame of a message. Raises EncodeError."""
    return of_library(message).frame(framing)


def encode_body(message: Message) -> bytes:
    """Return the body of a message, without a frame. Raises EncodeError."""
    return of_library(message).body()


def decode(
    frame: Bytes,
    direction: Direction = Direction.FROM_BOARD,
    contexts: Optional[Contexts] = None,
) -> Message:
    """Decode one frame, in any framing. Raises DecodeError."""
    known = known_by(contexts)
    return wrap(_core.decode_frame(memoryview(frame), _is_from_board(direction), known))


def decode_body(
    id: int,
    body: Bytes,
    direction: Direction = Direction.FROM_BOARD,
    contexts: Optional[Contexts] = None,
) -> Message:
    """Decode the body of a frame with this command id. Raises DecodeError."""
    known = known_by(contexts)
    return wrap(_core.decode_body(id, memoryview(body), _is_from_board(direction), known))


@dataclass(frozen=True)
class Frame:
    """A frame found by a Parser. `offset` is the position of its first byte in the stream."""

    id: int
    body: bytes
    offset: int
    framing: Framing

    def decode(
        self,
        direction: Direction = Direction.FROM_BOARD,
        contexts: Optional[Contexts] = None,
    ) -> Message:
        """Decode the body. Raises DecodeError."""
        return decode_body(self.id, self.body, direction, contexts)


@dataclass(frozen=True)
class ParserCounters:
    """The counters of a Parser; see the parser of the C++ library."""

    frames: int
    skipped_bytes: int
    header_errors: int
    body_errors: int
    incomplete: int


class Parser:
    """Finds the frames in a stream of bytes, in one framing or in all of them.

    The result does not depend on how the stream is split into chunks.
    """

    def __init__(self, framing: Optional[Framing] = None) -> None:
        self._parser = _core.StreamParser(None if framing is None else int(framing))

    def feed(self, chunk: Bytes) -> list[Frame]:
        """Process the next bytes; return the frames that they complete."""
        return _frames(self._parser.feed(memoryview(chunk)))

    def flush(self) -> list[Frame]:
        """Discard a frame that is still incomplete; return the frames among its bytes.

        Call this when the stream has ended, or when the line has been idle.
        """
        return _frames(self._parser.flush())

    @property
    def waiting_bytes(self) -> int:
        """The number of bytes that wait for the rest of their frame."""
        return self._parser.waiting

    @property
    def counters(self) -> ParserCounters:
        return ParserCounters(*self._parser.counters)


def _frames(found: list[_core.Frame]) -> list[Frame]:
    return [Frame(one.id, one.body, one.offset, Framing(one.framing)) for one in found]


@dataclass(frozen=True)
class Violation:
    """A value that the specification does not allow.

    `value` and `limit` are raw; `rule` is "minimum", "maximum", "alignment", "count", "order",
    "firmware" or "board". The text is a sentence: "axes.roll.angle: 800 deg is above 720 deg".
    """

    field: str
    text: str
    value: float
    limit: float
    rule: str

    def __str__(self) -> str:
        return self.text


def validate(message: Message, firmware: int = 0, board: int = 0) -> list[Violation]:
    """Return the values that a board with these versions does not allow; 0 means the newest one.

    Versions are raw values: msg.FirmwareVersion, msg.BoardVersion.
    """
    return [Violation(*one) for one in of_library(message).violations(firmware, board)]


def describe(message: Message) -> str:
    """Return the text of a message: its name, and every value with its meaning."""
    of_library(message)
    return str(message)
