"""Frames made from the vendor's code of 2026 (tests/data/vendor_2026.json), by the reference codec."""

from __future__ import annotations

import json
from typing import Any

import pytest

from sbgcgen.model import Layout
from sbgcgen.oracle.decoding import decode
from sbgcgen.oracle.encoding import encode
from sbgcgen.oracle.frames import choose_message, forms_of, read_frames
from support import PROJECT, project_layout

FRAMES: list[dict[str, Any]] = json.loads(
    (PROJECT / "tests" / "data" / "vendor_2026.json").read_text(encoding="utf-8")
)
# Meanings of the frames that the model does not decode yet.
OPEN = {
    "CONTROL_QUAT_STATUS answer with a 16-bit DATA_SET echo",
}


def parameters() -> list[Any]:
    return [
        pytest.param(
            frame,
            id=frame["meaning"],
            marks=[pytest.mark.xfail(strict=True)] if frame["meaning"] in OPEN else [],
        )
        for frame in FRAMES
    ]


@pytest.fixture(scope="module")
def layout() -> Layout:
    return project_layout()


@pytest.mark.parametrize("frame", parameters())
def test_the_body_decodes(frame: dict[str, Any], layout: Layout) -> None:
    (found,) = read_frames(layout.framings, bytes.fromhex(frame["hex"]))
    message = choose_message(forms_of(layout), frame["direction"], found.id, len(found.body))
    fields = decode(message, found.body)
    assert encode(message, fields) == found.body
    assert "tail" not in fields
    for leaf in message.leaves:
        expected = frame["fields"].get(leaf.spec_name)
        if leaf.path in fields and type(expected) in (int, float):
            assert fields[leaf.path] == expected, leaf.path
