"""Runs commands that talk to a board: with a terminal, and interrupted at a certain frame."""

from __future__ import annotations

import os
import pty
import subprocess
from dataclasses import dataclass
from pathlib import Path

from sbgc_command import PROGRAM


@dataclass(frozen=True)
class Ended:
    status: int
    out: str
    error: str


def answer_on_terminal(answer: str, *arguments: str) -> Ended:
    """Runs the program on a pseudo-terminal and answers its question."""
    master, slave = pty.openpty()
    with subprocess.Popen(
        [PROGRAM, *arguments], stdin=slave, stdout=subprocess.PIPE, stderr=slave
    ) as process:
        os.close(slave)
        shown = b""
        is_answered = False
        while True:
            try:
                block = os.read(master, 4096)
            except OSError:  # the program has closed it
                break
            shown += block
            if b"[y/N]" in shown and not is_answered:
                is_answered = True
                os.write(master, answer.encode() + b"\n")
        assert process.stdout is not None
        out = process.stdout.read().decode()
    os.close(master)
    assert is_answered, shown
    return Ended(process.returncode, out, shown.decode())


class Watched:
    """A running program that prints its frames (--verbose)."""

    def __init__(self, *arguments: str, cwd: Path | None = None) -> None:
        self.process = subprocess.Popen(
            [PROGRAM, *arguments, "--verbose"],
            cwd=cwd,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        self.seen = ""

    def wait_for(self, word: str, count: int = 1) -> None:
        """Waits until the word has been printed on standard error so often."""
        assert self.process.stderr is not None
        while self.seen.count(word) < count:
            line = self.process.stderr.readline()
            assert line, self.seen
            self.seen += line

    def end(self) -> Ended:
        out, error = self.process.communicate(timeout=60)
        return Ended(self.process.returncode, out, self.seen + error)
