"""Selects the message of a body, and reads and writes frames."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from sbgcgen.model import BODY, ID, SIZE, START, Framing, Message
from sbgcgen.oracle.codec import CodecError

Forms = Mapping[tuple[str, int], Sequence[Message]]


def choose_message(forms: Forms, direction: str, id: int, size: int) -> Message:
    """The message of a body with `size` bytes.

    Of several forms of a command, the one that allows the size. A request may have surplus.
    """
    candidates = forms.get((direction, id), ())
    if not candidates:
        raise CodecError("unknown_command")
    if len(candidates) == 1:
        return candidates[0]
    for message in candidates:
        may_be_longer = message.is_open or message.takes_surplus
        if message.min_size <= size and (may_be_longer or size <= message.max_size):
            return message
    raise CodecError("unknown_form")


def write_frame(framing: Framing, id: int, body: bytes) -> bytes:
    if id == 0:
        raise CodecError("invalid_id")
    if len(body) > framing.max_body:
        raise CodecError("too_long", "", framing.max_body)
    parts = _header(framing, id, len(body)) | {BODY: body}
    for part in framing.trailer:
        parts[part] = _checksum(framing, part, parts)
    return b"".join(parts[part] for part in (*framing.header, BODY, *framing.trailer))


def header_of(framing: Framing, id: int, size: int) -> bytes:
    """The header of a frame with `size` bytes of body."""
    return b"".join(_header(framing, id, size).values())


@dataclass(frozen=True)
class FoundFrame:
    """A frame in a stream, at `offset`."""

    offset: int
    framing: Framing
    id: int
    body: bytes


def read_frames(framings: Sequence[Framing], stream: bytes) -> Iterator[FoundFrame]:
    """The frames in a stream that begin with the start byte of one of the framings.

    The start byte of a candidate selects its framing. If the candidate is invalid, the search
    continues with the next byte.
    """
    at = 0
    while at < len(stream):
        framing = next((f for f in framings if f.start == stream[at]), None)
        frame = _frame_at(framing, stream[at:]) if framing else None
        if framing is None or frame is None:
            at += 1
        else:
            yield FoundFrame(at, framing, *frame)
            at += framing.frame_size(len(frame[1]))


def _frame_at(framing: Framing, data: bytes) -> tuple[int, bytes] | None:
    """Id and body of the frame at the start of `data`; None if these bytes are not a frame."""
    header = data[: framing.header_size]
    if len(header) < framing.header_size:
        return None
    id, size = header[framing.place(ID)], header[framing.place(SIZE)]
    if id == 0 or size > framing.max_body or header != header_of(framing, id, size):
        return None
    body = data[framing.header_size :][:size]
    frame = write_frame(framing, id, body)
    return (id, body) if len(body) == size and data.startswith(frame) else None


def _header(framing: Framing, id: int, size: int) -> dict[str, bytes]:
    parts: dict[str, bytes] = {}
    known = {START: bytes((framing.start,)), ID: bytes((id,)), SIZE: bytes((size,))}
    for part in framing.header:
        parts[part] = known[part] if part in known else _checksum(framing, part, parts)
    return parts


def _checksum(framing: Framing, name: str, parts: dict[str, bytes]) -> bytes:
    """A checksum over the parts that it covers, all of which precede it."""
    checksum = framing.checksum(name)
    assert checksum is not None
    covered = b"".join(parts[part] for part in checksum.covers)
    return checksum.value(covered).to_bytes(checksum.size, "little")
