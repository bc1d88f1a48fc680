"""The tour of the command shows what the command prints."""

from __future__ import annotations

import os

import pytest
import tour


@pytest.mark.skipif("SBGC" not in os.environ, reason="SBGC does not name the sbgc command")
def test_the_tour_is_what_the_command_prints() -> None:
    page = tour.TOUR.read_text(encoding="utf-8")
    assert len(tour.BLOCK.findall(page)) >= 10
    # To accept a change: SBGC=... generator/python tests/docs/tour.py --write
    new: list[str] = tour.BLOCK.findall(tour.rendered(page))
    old: list[str] = tour.BLOCK.findall(page)
    assert [block.splitlines() for block in new] == [block.splitlines() for block in old]


def test_only_numbers_may_differ() -> None:
    assert tour.text_of("pitch -20.0 deg") == tour.text_of("pitch 3 deg")
    assert tour.text_of("pitch -20.0 deg") != tour.text_of("yaw -20.0 deg")
    assert tour.text_of("a  b") == tour.text_of("a b")
    assert tour.text_of("time\n 0.1, 2\n 0.2, 3\n") == tour.text_of("time\n 0.1, 2\n")
    assert tour.text_of("time\n 0.1, 2\n") != tour.text_of("time\n")
