"""Runs commands that talk to a board: in a terminal, and interrupted at a certain frame."""

from __future__ import annotations

import os
import pty
import resource
import signal
import subprocess
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from sbgc_command import PROGRAM


@dataclass(frozen=True)
class Ended:
    status: int
    out: str
    error: str


def limit_files(size: int) -> None:
    """Limits the files that this process can write."""
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))


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


class Terminal:
    """A terminal in which the command runs."""

    def __init__(self, *arguments: str) -> None:
        self.process, self.screen = pty.fork()
        if self.process == 0:
            os.execv(PROGRAM, [PROGRAM, *arguments])
        self.shown = b""

    def await_text(self, text: bytes) -> None:
        deadline = time.monotonic() + 30
        while text not in self.shown:
            assert time.monotonic() < deadline, self.shown
            try:
                self.shown += os.read(self.screen, 4096)
            except OSError:
                raise AssertionError(f"the command has ended: {self.shown!r}") from None

    def press(self, keys: bytes) -> None:
        os.write(self.screen, keys)

    def hold(self, keys: tuple[bytes, ...], is_done: Callable[[], bool]) -> None:
        """Repeats the key as if it were held."""
        deadline = time.monotonic() + 30
        while not is_done():
            assert time.monotonic() < deadline, self.shown
            for key in keys:
                self.press(key)
            time.sleep(0.03)

    def status(self) -> int:
        """Waits for the end; the screen must be read meanwhile."""
        try:
            while part := os.read(self.screen, 4096):
                self.shown += part
        except OSError:
            pass  # the other side is closed
        return os.waitstatus_to_exitcode(os.waitpid(self.process, 0)[1])


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

    def interrupt(self) -> Ended:
        self.process.send_signal(signal.SIGINT)
        return self.end()

    def end(self) -> Ended:
        out, error = self.process.communicate(timeout=60)
        return Ended(self.process.returncode, out, self.seen + error)
