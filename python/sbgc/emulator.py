"""An emulated gimbal in this process."""

from __future__ import annotations

from typing import NamedTuple

from sbgc import _core


class Angles(NamedTuple):
    """A number for each axis: degrees, or degrees per second."""

    roll: float
    pitch: float
    yaw: float


class Board:
    """An emulated board, in real time; see emulator(). Connect with `sbgc.connect(board)`."""

    def __init__(self, board: _core.Emulation) -> None:
        self._board = board

    def __enter__(self) -> Board:
        return self

    def __exit__(self, *error: object) -> None:
        self.unplug()

    @property
    def angles(self) -> Angles:
        """The angles of the camera."""
        return Angles(*self._board.angles())

    @property
    def speeds(self) -> Angles:
        """The speeds of the camera."""
        return Angles(*self._board.speeds())

    def restart(self) -> None:
        """Restart the board, as by a power cycle."""
        self._board.restart()

    def unplug(self) -> None:
        """Cut the lines of all hosts."""
        self._board.unplug()


def emulator(
    firmware: str = "",
    *,
    motion: str = "rest",
    seed: int = 1,
    noise: float = 1.0,
    bit_errors: float = 0.0,
    lost: float = 0.0,
    duplicated: float = 0.0,
    baud_rate: int = 0,
) -> Board:
    """Make an emulated board, with the firmware "2.59" if none is named.

    `motion` is that of the frame: "rest", "handheld", "drone", "vehicle", or the name of a file.
    Shares of `bit_errors`, and of `lost` and `duplicated` bytes, are 0 to 1. With a `baud_rate`,
    bytes take time.
    """
    made = _core.Emulation(firmware, motion, seed, noise, bit_errors, lost, duplicated, baud_rate)
    return Board(made)
