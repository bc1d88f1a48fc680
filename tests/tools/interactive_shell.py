"""Interactive shells in a pseudo-terminal, in which the tests press keys."""

from __future__ import annotations

import os
import pty
import select
import shlex
import signal
import termios
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Optional

from sbgc_command import PROGRAM

START = {
    "bash": ["bash", "--noprofile", "--rcfile", "start", "-i"],
    "zsh": ["zsh", "-d", "-i"],
    "fish": ["fish", "--private", "--init-command", "sbgc completion fish | source", "-i"],
}
START_FILES = {
    "start": "source <(sbgc completion bash)\n",
    ".zshrc": "autoload -U compinit; compinit -u\nsetopt extended_glob\n"
    "source <(sbgc completion zsh)\n",
    # It completes, and otherwise only records its arguments.
    "bin/sbgc": "#!/bin/sh\n"
    f'case $1 in completion | __complete) exec {shlex.quote(PROGRAM)} "$@" ;; esac\n'
    "printf '%s\\0' \"$@\" >got.new && mv got.new got\n",
}


class Shell:
    """A shell with the completion of sbgc."""

    def __init__(self, name: str, folder: Path) -> None:
        self.name = name
        self.folder = folder
        (folder / "bin").mkdir(parents=True)
        for file, text in START_FILES.items():
            (folder / file).write_text(text)
        (folder / "bin/sbgc").chmod(0o755)
        self.shown = b""
        self.process, self.terminal = pty.fork()
        if self.process == 0:
            os.chdir(folder)
            os.environ.update(
                PATH=f"{folder}/bin:{os.environ['PATH']}", HOME=str(folder), ZDOTDIR=str(folder)
            )
            os.environ.update(LC_ALL="C.UTF-8", SBGC_PORTS=f"{folder}/ports.json")
            os.execvp(START[name][0], START[name])

    def wait(self, condition: Callable[[], bool], seconds: float) -> bool:
        """Waits for a condition, and reads what the shell shows meanwhile."""
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end:
                return False
            if select.select([self.terminal], [], [], 0.01)[0]:
                self.shown += os.read(self.terminal, 65536)
        return True

    def reads_keys(self) -> bool:
        """True if the shell edits a line; a terminal that runs a command has lines of its own."""
        is_canonical = termios.tcgetattr(self.terminal)[3] & termios.ICANON
        return not is_canonical and os.tcgetpgrp(self.terminal) == self.process

    def press(self, keys: str) -> Optional[list[str]]:
        """Returns the arguments of sbgc after these keys and Enter; None if it did not run."""
        got = self.folder / "got"
        got.unlink(missing_ok=True)
        self.shown = b""
        assert self.wait(self.reads_keys, 20), self.shown
        os.write(self.terminal, keys.encode() + b"\r")
        if self.wait(got.exists, 20):
            return [os.fsdecode(word) for word in got.read_bytes().split(b"\0")[:-1]]
        os.write(self.terminal, b"\x03")
        return None


@contextmanager
def interactive_shell(name: str, folder: Path) -> Iterator[Shell]:
    result = Shell(name, folder)
    try:
        yield result
    finally:
        os.kill(result.process, signal.SIGKILL)
        os.close(result.terminal)
        os.waitpid(result.process, 0)
