"""An emulated gimbal for tests with pytest.

In conftest.py:

    pytest_plugins = ["sbgc.testing"]

A test uses `gimbal`, a client whose board is `gimbal_board`, in virtual time and without noise. To
change the options, define a fixture `emulator_options`:

    @pytest.fixture
    def emulator_options():
        return {"firmware": "2.74", "motion": "handheld", "lost": 0.001}
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from sbgc.client import Gimbal, connect
from sbgc.emulator import Board, emulator


@pytest.fixture
def emulator_options() -> dict[str, Any]:
    """Arguments of sbgc.emulator()."""
    return {}


@pytest.fixture
def gimbal_board(emulator_options: dict[str, Any]) -> Iterator[Board]:
    """An emulated board."""
    options: dict[str, Any] = {"virtual_time": True, "noise": 0.0, **emulator_options}
    with emulator(**options) as board:
        yield board


@pytest.fixture
def gimbal(gimbal_board: Board) -> Iterator[Gimbal]:
    """A client of the emulated board."""
    with connect(gimbal_board) as client:
        yield client
