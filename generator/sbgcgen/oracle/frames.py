"""Which message a body is, and how bodies stand in frames."""

from __future__ import annotations

from collections.abc import Iterator

from sbgcgen.model import Framing, Layout, Message
from sbgcgen.oracle.codec import CodecError

Forms = dict[tuple[str, int], list[Message]]


def forms_of(layout: Layout) -> Forms:
    """The messages of each direction and id."""
    forms: Forms = {}
    for message in layout.messages:
        forms.setdefault((message.direction, message.id), []).append(message)
    return forms


def choose_message(forms: Forms, direction: str, id: int, size: int) -> Message:
    """The message that a body of `size` bytes is.

    A command with one form is always that; of several forms the one that allows the size.
    """
    candidates = forms.get((direction, id), [])
    if not candidates:
        raise CodecError("unknown_command")
    if len(candidates) == 1:
        return candidates[0]
    for message in candidates:
        if message.min_size <= size and (message.is_open or size <= message.max_size):
            return message
    raise CodecError("unknown_form")


def write_frame(framing: Framing, id: int, body: bytes) -> bytes:
    """A body in its frame."""
    if id == 0:
        raise CodecError("invalid_id")
    if len(body) > framing.max_body:
        raise CodecError("too_long", "", framing.max_body)
    header = bytes((framing.start, id, len(body), (id + len(body)) % 256))
    return header + body + bytes((sum(body) % 256,))


def read_frames(framing: Framing, stream: bytes) -> Iterator[tuple[int, int, bytes]]:
    """The frames in a stream: position, id and body of each, by the rule of the design."""
    at = 0
    while at < len(stream):
        frame = _frame_at(framing, stream[at:])
        if frame is None:
            at += 1
        else:
            yield at, frame[0], frame[1]
            at += framing.header_size + len(frame[1]) + framing.trailer_size


def _frame_at(framing: Framing, data: bytes) -> tuple[int, bytes] | None:
    if len(data) < framing.header_size or data[0] != framing.start or data[1] == 0:
        return None
    if (data[1] + data[2]) % 256 != data[3]:
        return None
    body = data[framing.header_size :][: data[2]]
    trailer = data[framing.header_size + data[2] :][: framing.trailer_size]
    if len(body) != data[2] or not trailer or trailer[0] != sum(body) % 256:
        return None
    return data[1], body
