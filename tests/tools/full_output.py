"""Outputs that are full: a write waits until somebody reads."""

from __future__ import annotations

import os
import pty
import termios
from collections.abc import Iterator
from contextlib import contextmanager

KINDS = ("pipe", "unread terminal", "stopped terminal", "terminal stopped later")


class Output:
    """The output of a program, and the other end of it."""

    def __init__(self, kind: str) -> None:
        self.kind = kind
        self.reader, self.descriptor = os.pipe() if kind == "pipe" else pty.openpty()
        if kind in ("pipe", "unread terminal"):
            self._fill()
        if kind == "stopped terminal":
            self._stop()

    def _fill(self) -> None:
        os.set_blocking(self.descriptor, False)
        for size in (4096, 1):
            try:
                while True:
                    os.write(self.descriptor, b"\n" * size)
            except BlockingIOError:
                pass
        os.set_blocking(self.descriptor, True)

    def _stop(self) -> None:
        termios.tcflow(self.descriptor, termios.TCOOFF)  # as Ctrl-S does

    def lose_reader(self) -> None:
        """Lets writes fail from now on."""
        nothing = os.open(os.devnull, os.O_RDONLY)
        os.dup2(nothing, self.reader)
        os.close(nothing)

    def become_full(self) -> None:
        if self.kind == "terminal stopped later":
            self._stop()


@contextmanager
def full_output(kind: str) -> Iterator[Output]:
    output = Output(kind)
    try:
        yield output
    finally:
        os.close(output.descriptor)
        os.close(output.reader)
