"""An emulated gimbal in this process."""

from __future__ import annotations

import time
from collections.abc import Iterable
from typing import NamedTuple, Optional

from sbgc import _core

_SLICE = 1.0


class Angles(NamedTuple):
    """A number for each axis, in degrees or degrees per second."""

    roll: float
    pitch: float
    yaw: float


class Board:
    """An emulated board; see emulator(). Connect with `sbgc.connect(board)`."""

    def __init__(self, board: _core.Emulation) -> None:
        self._board = board

    def __repr__(self) -> str:
        return f"<sbgc.Board, emulated in {'virtual' if self.has_virtual_time else 'real'} time>"

    def __enter__(self) -> Board:
        return self

    def __exit__(self, *error: object) -> None:
        self.unplug()

    @property
    def angles(self) -> Angles:
        """The angles of the camera."""
        return Angles(*self._board.sample()[0])

    @property
    def speeds(self) -> Angles:
        """The speeds of the camera."""
        return Angles(*self._board.sample()[1])

    @property
    def time(self) -> float:
        """Seconds since the start of the board."""
        return self._board.now()

    @property
    def has_virtual_time(self) -> bool:
        """True if time passes only in calls of the client, and in sleep()."""
        return self._board.has_virtual_time

    def sleep(self, seconds: float) -> None:
        """Wait in the time of the board."""
        if not self.has_virtual_time:
            time.sleep(seconds)
            return
        until = self.time + seconds
        while (left := until - self.time) > 1e-6:
            self._board.pass_time(min(left, _SLICE))  # Ctrl-C counts between two of them

    def restart(self) -> None:
        """Restart the board, like a power cycle."""
        self._board.restart()

    def unplug(self) -> None:
        """Cut the lines of all hosts."""
        self._board.unplug()


def emulator(
    firmware: str = "",
    *,
    board: str = "",
    motion: str = "rest",
    seed: int = 1,
    noise: float = 1.0,
    virtual_time: bool = False,
    baud_rate: int = 0,
    bit_errors: float = 0.0,
    lost: float = 0.0,
    duplicated: float = 0.0,
    delayed: float = 0.0,
    delay: float = 0.02,
    text_every: float = 0.0,
    silences: Iterable[tuple[float, float]] = (),
    input_buffer: int = 0,
    strict: bool = False,
    restart_at: Optional[float] = None,
) -> Board:
    """Make an emulated board, by default with the firmware "2.59".

    `motion` is the motion of the frame: "rest", "handheld", "drone", "vehicle", or a file name.

    In `virtual_time`, time passes only while a call of the blocking client waits, and in sleep():
    calls return at once, and deterministically.

    The other arguments are those of `sbgc emulate`; times are in seconds since the start of the
    board. With a `baud_rate`, bytes take time. Faults are shares of `bit_errors`, and of `lost`,
    `duplicated` and `delayed` bytes, 0 to 1; `delay` is the delay of the latter; `text_every` the
    interval of text between frames; `silences` are start times and durations of silence. Requests
    that exceed an `input_buffer` of this many bytes are lost; a `strict` board rejects requests with
    more bytes than it knows; `restart_at` is the time of a restart.
    """
    faults = _core.Faults(bit_errors, lost, duplicated, delayed, delay, text_every, list(silences))
    made = _core.Emulation(
        firmware,
        board,
        motion,
        seed,
        noise,
        faults,
        baud_rate,
        input_buffer,
        strict,
        restart_at,
        virtual_time,
    )
    return Board(made)
