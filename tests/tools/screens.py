"""Terminals of a certain size, in which the tests run full-screen programs (tmux)."""

from __future__ import annotations

import os
import re
import subprocess
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from sbgc_command import PROGRAM


class Terminal:
    """A shell in a terminal."""

    def __init__(
        self,
        folder: Path,
        width: int,
        height: int,
        locale: str = "C.UTF-8",
        environment: Mapping[str, str] = os.environ,
    ) -> None:
        self.socket = str(folder / "tmux")
        self.saved = 0
        environment = {**environment, "LC_ALL": locale, "TERM": "screen", "PS1": "> "}
        size = ["-x", str(width), "-y", str(height)]
        subprocess.run(
            ["tmux", "-u", "-f", "/dev/null", "-S", self.socket, "new-session", "-d", *size]
            + ["bash", "--norc"],
            env=environment,
            check=True,
        )
        self.tmux("set", "-g", "status", "off")
        self.resize(width, height)

    def tmux(self, *command: str) -> str:
        done = subprocess.run(
            ["tmux", "-S", self.socket, *command], capture_output=True, text=True, check=True
        )
        return done.stdout

    def resize(self, width: int, height: int) -> None:
        self.tmux("resize-window", "-x", str(width), "-y", str(height))

    def type(self, text: str) -> None:
        self.tmux("send-keys", "-l", text)

    def press(self, key: str) -> None:
        self.tmux("send-keys", key)

    def enter(self, line: str) -> None:
        self.type(line)
        self.press("Enter")

    def run(self, *arguments: str) -> None:
        """Enters a command line of sbgc."""
        self.enter(" ".join([PROGRAM, *arguments]))

    def lines(self) -> list[str]:
        return self.tmux("capture-pane", "-p").split("\n")[:-1]

    def marked(self, row: int) -> list[str]:
        """Returns the texts of a row that have a background."""
        line = self.tmux("capture-pane", "-p", "-e").split("\n")[row]
        return [text.strip() for text in re.findall(r"\x1b\[4[0-7]m([^\x1b]*)", line)]

    def wait(self, found: str | Callable[[list[str]], bool], seconds: float = 20) -> list[str]:
        """Waits for a regular expression, or a condition, on the screen."""
        end = time.monotonic() + seconds
        times = 0
        while time.monotonic() < end:
            lines = self.lines()
            is_found = (
                re.search(found, "\n".join(lines), re.MULTILINE)
                if isinstance(found, str)
                else found(lines)
            )
            # The first screen may be half drawn.
            times = times + 1 if is_found else 0
            if times == 2:
                return lines
            time.sleep(0.05)
        raise AssertionError(f"{found} is not on the screen:\n" + "\n".join(self.lines()))

    def state(self) -> str:
        """Returns the settings of the terminal, which the shell prints."""
        self.saved += 1
        self.enter(f"stty -g > state; echo sa''ved {self.saved}")
        self.wait(f"^saved {self.saved}")
        return (Path(self.socket).parent / "state").read_text()

    def process(self) -> int:
        """Returns the process in the foreground."""
        shell = self.tmux("display-message", "-p", "#{pane_pid}").strip()
        children = Path(f"/proc/{shell}/task/{shell}/children").read_text().split()
        return int(children[0])


@contextmanager
def terminal(
    folder: Path,
    width: int = 80,
    height: int = 24,
    locale: str = "C.UTF-8",
    environment: Mapping[str, str] = os.environ,
) -> Iterator[Terminal]:
    result = Terminal(folder, width, height, locale, environment)
    result.enter(f"cd {folder}; PS1='$ '; clear")
    try:
        # Text that is typed before the first prompt is echoed twice.
        result.wait(lambda lines: lines[0].rstrip() == "$")
        yield result
    finally:
        result.tmux("kill-server")
