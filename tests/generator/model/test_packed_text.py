"""Tests of the text form of packed integers, using versions as the example."""

from __future__ import annotations

from functools import lru_cache

import pytest

from sbgcgen.build import load_protocol
from sbgcgen.model import Packed
from sbgcgen.model.packed_text import raw_of, text_of
from support import HERE, project_layout


@lru_cache(maxsize=None)
def packed(name: str) -> Packed:
    """Returns a packed integer of the minimal spec."""
    return next(p for p in load_protocol(HERE / "minimal").layout.packed if p.name == name)


FIRMWARE: dict[str, int | None] = {
    "2.59": 2590,
    "2.55b5": 2555,
    "2.50": 2500,
    "2.43b9": 2439,
    "0.00": 0,
}
# The first could be 2.05 or 2.50.
NO_FIRMWARE = ["2.5", "2", "2.590", "2.59b", "2.59b10", "v2.59", "2.59 ", "2,59", ""]


def test_firmware_version() -> None:
    read = {text: raw_of(packed("FirmwareVersion"), text) for text in (*FIRMWARE, *NO_FIRMWARE)}
    assert read == {**FIRMWARE, **dict.fromkeys(NO_FIRMWARE)}


@pytest.mark.parametrize(
    ("text", "value"),
    [("2.72b9", 2729), ("2.73", 2730), ("2.73.6", 2736), ("2.73b6", None), ("2.72.9", None)],
)
def test_later_versions_are_written_differently(text: str, value: int | None) -> None:
    (version,) = (p for p in project_layout().packed if p.name == "FirmwareVersion")
    assert raw_of(version, text) == value


@pytest.mark.parametrize(
    ("text", "value"),
    [("3.0", 30), ("3.6", 36), ("10.1", 101), ("3", None), ("3.10", None), ("a.b", None)],
)
def test_board_version(text: str, value: int | None) -> None:
    assert raw_of(packed("BoardVersion"), text) == value


def test_every_version_is_read_as_it_is_written() -> None:
    for name in ("FirmwareVersion", "BoardVersion"):
        type_ = packed(name)
        for raw in range(1 << 8 * type_.scalar.size):
            assert raw_of(type_, text_of(type_, raw)) == raw
