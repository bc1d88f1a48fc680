"""The emulated board of the tests."""

from __future__ import annotations

import faulthandler
import time
from collections.abc import Iterator

import pytest

import sbgc

faulthandler.enable()


@pytest.fixture(autouse=True)
def tells_where_it_hangs() -> Iterator[None]:
    faulthandler.dump_traceback_later(120, exit=True)
    yield
    faulthandler.cancel_dump_traceback_later()


def is_still(board: sbgc.Board) -> bool:
    """True if the camera is at rest, or nearly: its motion ends after that of its target."""
    until = time.monotonic() + 0.3
    while any(abs(speed) > 2 for speed in board.speeds) and time.monotonic() < until:
        time.sleep(0.01)
    return all(abs(speed) <= 2 for speed in board.speeds)


@pytest.fixture
def board() -> Iterator[sbgc.Board]:
    with sbgc.emulator(noise=0) as made:
        yield made


@pytest.fixture
def gimbal(board: sbgc.Board) -> Iterator[sbgc.Gimbal]:
    with sbgc.connect(board) as made:
        made.call(sbgc.msg.MotorsOn())
        yield made
