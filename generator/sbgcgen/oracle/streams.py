"""Test vectors for framing: byte streams, and the frames in them.

A line is {"stream", "frames", "why"}: the stream in hex, and "offset", "id" and "body" of each
frame. With "written", the stream is exactly the frame that a writer makes from the id and body.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

from sbgcgen.model import Framing, Layout
from sbgcgen.oracle.edges import counting
from sbgcgen.oracle.frames import header_of, read_frames, write_frame
from sbgcgen.oracle.vectors import typical_vector


def stream_lines(layout: Layout) -> Iterator[str]:
    """The lines of the vector file for a protocol's framing."""
    framing = layout.framing
    for message in layout.definitions:
        vector = typical_vector(message)
        if vector.body is not None and message.id:
            frame = write_frame(framing, message.id, vector.body)
            yield _line(framing, frame, f"a frame of {message.name}", written=True)
    for size in (0, 1, 15, 16, 17, framing.max_body):
        frame = write_frame(framing, 1, counting(size))
        yield _line(framing, frame, f"a body of {size} bytes", written=True)
    for stream, why in _broken(framing):
        yield _line(framing, stream, why)


def _broken(framing: Framing) -> Iterator[tuple[bytes, str]]:
    """Streams with noise and damaged frames, mostly followed by a valid frame."""
    start = bytes((framing.start,))
    good = write_frame(framing, 86, counting(5))
    yield b"", "no bytes"
    yield good + good, "two frames"
    yield b"\x00\xff" + good + b"\x7f", "noise around a frame"
    for count in range(1, framing.header_size + 1):
        yield start * count + good, f"{count} start bytes before a frame"
    for at in range(len(good)):
        damaged = bytearray(good)
        damaged[at] = (damaged[at] + 1) % 256
        yield bytes(damaged) + good, f"byte {at} is wrong"
    for count in range(1, len(good)):
        yield good[:count] + good, f"only {count} bytes of the first frame"
    yield good[:-1], "the last byte is missing"
    yield header_of(framing, 0, 0) + bytes(framing.trailer_size) + good, "no command has the id 0"
    yield header_of(framing, 1, framing.max_body) + good, "a header without its body, then a frame"
    inner = write_frame(framing, 2, good)
    yield inner, "a frame as the body of another"
    yield inner[:-1] + bytes(((inner[-1] + 1) % 256,)), "a frame in the body of a broken one"


def _line(framing: Framing, stream: bytes, why: str, written: bool = False) -> str:
    frames = [
        {"offset": at, "id": id, "body": body.hex()}
        for at, id, body in read_frames(framing, stream)
    ]
    result: dict[str, Any] = {"stream": stream.hex(), "frames": frames}
    if written:
        result["written"] = True
    result["why"] = why
    return json.dumps(result, separators=(",", ":")) + "\n"
