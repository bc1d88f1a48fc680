"""Emulated gimbals for the tests of the sbgc command."""

from __future__ import annotations

import subprocess
from collections.abc import Iterator
from contextlib import contextmanager

from sbgc_command import PROGRAM


class EmulatedGimbal:
    """A running `sbgc emulate`, on a TCP port of its own unless the options say otherwise."""

    def __init__(self, *options: str) -> None:
        places = ("--tcp", "--udp", "--pty", "--link")
        where = () if any(option in places for option in options) else ("--tcp", "0")
        self.process = subprocess.Popen(
            [PROGRAM, "emulate", *where, *options], stdout=subprocess.PIPE, text=True
        )
        assert self.process.stdout is not None
        line = self.process.stdout.readline()
        # "emulated gimbal 1: tcp:127.0.0.1:5000", "emulated gimbal 1: /dev/pts/7 (also ...)"
        self.address = line.split(": ", 1)[1].split()[0]

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
