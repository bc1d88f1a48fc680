"""Test vectors: bodies and their fields, computed by the oracle.

`vectors/<family>.jsonl` has one vector per line (see `oracle/vector_line.py`);
`vectors/unknown.jsonl` has bodies of no known message; `frames.jsonl` has streams and their frames
(see `oracle/streams.py`).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from sbgcgen.model import Layout
from sbgcgen.oracle.codec import CodecError
from sbgcgen.oracle.frames import Forms, choose_message
from sbgcgen.oracle.json_values import to_json
from sbgcgen.oracle.streams import stream_lines
from sbgcgen.oracle.vector_line import error_words, line
from sbgcgen.oracle.vectors import vectors_of
from sbgcgen.targets import Target


class Vectors(Target):
    """A file for each family, one for unknown messages, and one for framing."""

    def files(self, layout: Layout, project: Path) -> Iterator[tuple[str, bytes]]:
        forms = layout.messages_by_id
        bodies: set[int] = set()
        for family in layout.families:
            lines = []
            for message in family.messages:
                vectors = vectors_of(message, id(message.body) in bodies)
                bodies.add(id(message.body))
                lines += [line(vector, forms) for vector in vectors]
            if lines:
                yield f"vectors/{family.name}.jsonl", "".join(lines).encode()
        yield "vectors/unknown.jsonl", "".join(_of_no_message(forms)).encode()
        yield "frames.jsonl", "".join(stream_lines(layout)).encode()


def _of_no_message(forms: Forms) -> Iterator[str]:
    """Bodies of no known message: with sizes that no form has, or unknown ids in a direction."""
    for direction in ("from_board", "to_board"):
        known = {id_ for way, id_ in forms if way == direction}
        other = {id_ for way, id_ in forms if way != direction} - known
        unused = set(range(1, 256)) - known - other
        for number in (*sorted(other)[:1], *sorted(unused)[:1], *sorted(unused)[-1:]):
            yield from _refused(forms, direction, number, [0])
        for number in sorted(known):
            if len(forms[direction, number]) > 1:
                yield from _refused(forms, direction, number, range(256))


def _refused(forms: Forms, direction: str, number: int, sizes: Iterable[int]) -> Iterator[str]:
    """The shortest and the longest body of these sizes that is not a known message."""
    refused = []
    for size in sizes:
        try:
            choose_message(forms, direction, number, size)
        except CodecError as error:
            refused.append((size, error))
    for size, refusal in refused[:1] + refused[1:][-1:]:
        result: dict[str, Any] = {"id": number, "direction": direction, "hex": bytes(size).hex()}
        result.update(error=error_words(refusal), why=f"no message of {size} bytes")
        yield to_json(result)
