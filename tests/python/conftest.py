"""The emulated board of the tests."""

from __future__ import annotations

import faulthandler
from collections.abc import Iterator

import pytest

import sbgc

faulthandler.enable()
faulthandler.dump_traceback_later(120, exit=True)


@pytest.fixture
def board() -> Iterator[sbgc.Board]:
    with sbgc.emulator(noise=0) as made:
        yield made


@pytest.fixture
def gimbal(board: sbgc.Board) -> Iterator[sbgc.Gimbal]:
    with sbgc.connect(board) as made:
        made.call(sbgc.msg.MotorsOn())
        yield made
