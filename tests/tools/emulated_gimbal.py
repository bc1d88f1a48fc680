"""Emulated gimbals for the tests of the sbgc command."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from sbgc_command import Running


class EmulatedGimbal:
    """A running `sbgc emulate`, on a TCP port of its own unless the options say otherwise."""

    def __init__(self, *options: str) -> None:
        places = ("--tcp", "--udp", "--pty", "--link")
        where = () if any(option in places for option in options) else ("--tcp", "0")
        self.process = Running("emulate", *where, *options, stderr=None)
        self.address = self.process.address()

    @property
    def address_with_rate(self) -> str:
        """Detection finds a slower rate on a busy machine: a pseudo-terminal works at any."""
        is_terminal = self.address.startswith("/dev/")
        return f"serial:{self.address}?baud=115200" if is_terminal else self.address

    def kill(self) -> None:
        if self.process.poll() is None:
            self.process.kill()
            self.process.communicate()


@contextmanager
def emulated_gimbal(*options: str) -> Iterator[EmulatedGimbal]:
    gimbal = EmulatedGimbal(*options)
    try:
        yield gimbal
    finally:
        gimbal.kill()
