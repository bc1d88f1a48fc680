"""Test vectors for framing: byte streams, and the frames in them.

A line is {"stream", "framings", "frames", "why"}: the stream in hex, the names of the framings that
the parser accepts, and "offset", "framing", "id" and "body" of each frame. With "written", the
stream is exactly the frame that a writer makes from framing, id and body.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from sbgcgen.model import Framing, Layout
from sbgcgen.oracle.edges import counting
from sbgcgen.oracle.frames import header_of, read_frames, write_frame
from sbgcgen.oracle.json_values import to_json
from sbgcgen.oracle.vectors import typical_vector


def stream_lines(layout: Layout) -> Iterator[str]:
    """The lines of the vector file for the framings of a protocol."""
    for message in layout.definitions:
        vector = typical_vector(message)
        if vector.body is not None and message.id:
            yield _written(layout.framing, message.id, vector.body, f"a frame of {message.name}")
    for framing in layout.framings:
        sizes = (0, 1, 2, 7, 8, 9, 15, 16, 17)
        for size in (*(size for size in sizes if size < framing.max_body), framing.max_body):
            yield _written(framing, 1, counting(size), f"a body of {size} bytes")
        for stream, why in _broken(framing):
            yield _line([framing], stream, why)
    if len(layout.framings) > 1:
        for stream, why in _mixed(layout.framings):
            for framings in (layout.framings, *([f] for f in layout.framings)):
                yield _line(framings, stream, why)


def _mixed(framings: Sequence[Framing]) -> Iterator[tuple[bytes, str]]:
    good = [_short_frame(framing) for framing in framings]
    yield b"".join(good), "a frame of each framing"
    yield b"".join(bytes((f.start,)) for f in framings) + b"".join(
        good
    ), "start bytes before frames"
    for one, other in zip(framings, (*framings[1:], framings[0])):
        frame = _short_frame(other)
        if len(frame) <= one.max_body:
            inner = write_frame(one, 2, frame)
            yield inner, f"a frame of {other.name} as the body of one of {one.name}"
            broken = inner[:-1] + bytes(((inner[-1] + 1) % 256,))
            yield broken, f"a frame of {other.name} in the body of a broken one of {one.name}"
        yield frame[:-1] + write_frame(one, 1, b""), f"{other.name} without its last byte"
        swapped = bytes((one.start,)) + frame[1:]
        yield swapped + frame, f"a frame of {other.name} with the start byte of {one.name}"


def _broken(framing: Framing) -> Iterator[tuple[bytes, str]]:
    """Streams with noise and damaged frames, mostly followed by a valid frame."""
    start = bytes((framing.start,))
    good = _short_frame(framing)
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
    if len(good) <= framing.max_body:
        inner = write_frame(framing, 2, good)
        yield inner, "a frame as the body of another"
        yield inner[:-1] + bytes(((inner[-1] + 1) % 256,)), "a frame in the body of a broken one"


def _short_frame(framing: Framing) -> bytes:
    return write_frame(framing, 86, counting(min(5, framing.max_body)))


def _written(framing: Framing, id: int, body: bytes, why: str) -> str:
    return _line([framing], write_frame(framing, id, body), why, written=True)


def _line(framings: Sequence[Framing], stream: bytes, why: str, written: bool = False) -> str:
    result: dict[str, Any] = {
        "stream": stream.hex(),
        "framings": [framing.name for framing in framings],
        "frames": [
            {
                "offset": frame.offset,
                "framing": frame.framing.name,
                "id": frame.id,
                "body": frame.body.hex(),
            }
            for frame in read_frames(framings, stream)
        ],
    }
    if written:
        result["written"] = True
    result["why"] = why
    return to_json(result)
