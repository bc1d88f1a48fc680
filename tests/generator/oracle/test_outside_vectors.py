"""Byte sequences from public sources (tests/data/vectors.json), by the reference codec."""

from __future__ import annotations

import json
from typing import Any

import pytest

from sbgcgen.model import Layout
from sbgcgen.oracle.codec import CodecError, Fields
from sbgcgen.oracle.decoding import decode
from sbgcgen.oracle.encoding import encode
from sbgcgen.oracle.frames import choose_message, forms_of, read_frames
from support import PROJECT, project_layout

VECTORS: list[dict[str, Any]] = json.loads(
    (PROJECT / "tests" / "data" / "vectors.json").read_text(encoding="utf-8")
)
NAMES = [f"{number}-{vector['meaning'][:40]}" for number, vector in enumerate(VECTORS)]


@pytest.fixture(scope="module")
def layout() -> Layout:
    return project_layout()


def values_of(value: Any) -> list[Any]:
    """Returns the numbers and texts of a field, whatever its shape."""
    if isinstance(value, dict):
        return [one for inner in value.values() for one in values_of(inner)]
    if isinstance(value, list):
        return [one for inner in value for one in values_of(inner)]
    return [value]


def values_named(layout: Layout, id_: int, direction: str, body: bytes, name: str) -> list[Any]:
    """Returns what a body has under a name of the protocol."""
    message = choose_message(forms_of(layout), direction, id_, len(body))
    fields: Fields = decode(message, body)
    paths = [
        leaf.path for leaf in message.leaves if leaf.spec_name == name and "[]" not in leaf.path
    ]
    found = []
    for path in paths:
        value: Any = fields
        for step in path.replace("[", ".").replace("]", "").split("."):
            value = value[int(step)] if isinstance(value, list) else value.get(step)
        found += values_of(value)
    return found


@pytest.mark.parametrize("vector", VECTORS, ids=NAMES)
def test_the_reference_codec_agrees(vector: dict[str, Any], layout: Layout) -> None:
    data = bytes.fromhex(vector["hex"])
    direction = vector["direction"]
    if vector["kind"] == "payload":
        bodies = [(vector["command_id"], data)]
    else:
        bodies = [(frame.id, frame.body) for frame in read_frames([layout.framing], data)]
        assert len(bodies) == (1 if vector["expect"] == "valid" else 0)
    for id_, body in bodies:
        message = choose_message(forms_of(layout), direction, id_, len(body))
        try:
            fields = decode(message, body)
        except CodecError as error:
            pytest.fail(f"{message.name}: {error}")
        assert encode(message, fields) == body
        for name, value in vector.get("fields", {}).items():
            assert values_named(layout, id_, direction, body, name) == values_of(value), name
