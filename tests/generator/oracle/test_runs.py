"""Tests that the codec finds the same whether or not it takes consecutive integers at once."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, Union

import pytest

from sbgcgen.build import load_protocol
from sbgcgen.model import Message
from sbgcgen.model.runs import Run
from sbgcgen.oracle import decoding, encoding
from sbgcgen.oracle.codec import CodecError
from sbgcgen.oracle.vectors import Vector, vectors_of
from support import PROJECT

Outcome = Union[bytes, dict[str, Any], tuple[str, str, int]]


def outcome(codec: Callable[[], Any]) -> Outcome:
    """What a codec returns, or its error."""
    try:
        return codec()  # type: ignore[no-any-return]
    except CodecError as error:
        return error.code, error.field, error.offset
    except KeyError as error:  # the bits that count the elements of a list are missing
        return "no value", str(error), 0


def encodings(message: Message, fields: dict[str, Any]) -> Iterator[Outcome]:
    """Encodings into less space, and with a number that is missing or too large."""
    for limit in (255, message.max_size - 1, message.max_size // 2, 1):
        yield outcome(lambda: encoding.encode(message, fields, limit))
    for field in message.fields:
        if field.scalar and field.dim == "one":
            rest = {name: value for name, value in fields.items() if name != field.name}
            for other in (rest, {**rest, field.name: 1 << 70}):
                yield outcome(lambda: encoding.encode(message, other))


def outcomes(vectors: list[Vector]) -> Iterator[Outcome]:
    """What the codec finds in bodies that end anywhere, and in their fields."""
    for vector in vectors:
        body = vector.body or b""
        for size in range(len(body) + 1):
            part = body[:size]
            yield outcome(lambda: decoding.decode(vector.message, part, vector.context))
        if vector.fields is not None:
            yield from encodings(vector.message, vector.fields)


def test_runs_change_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    layout = load_protocol(PROJECT / "spec").layout
    vectors = [v for message in layout.messages for v in vectors_of(message)[:4]]
    at_once = list(outcomes(vectors))
    monkeypatch.setattr(Run, "format", property(lambda run: None), raising=False)
    for module in (decoding, encoding):
        monkeypatch.setattr(module, "array_format", lambda name, count: None)
    one_by_one = list(outcomes(vectors))
    assert len(at_once) > 10_000
    assert at_once == one_by_one
