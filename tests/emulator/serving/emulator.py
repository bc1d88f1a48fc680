"""Runs sbgc emulate for the tests, and communicates with the emulated boards."""

from __future__ import annotations

import os
import select
import signal
import socket
import subprocess
import termios
import time
import tty
from pathlib import Path
from types import TracebackType
from typing import Optional, Type

from sbgc_command import CRASH, PROGRAM, frame, run

BOARD_INFO = 86
BOARD_INFO_3 = 20
READ_EXTERNAL_DATA = 42
WRITE_EXTERNAL_DATA = 41
CONFIRM = 67
ERROR = 255
DATA_STREAM_INTERVAL = 85
REALTIME_DATA_4 = 25

PATIENCE = 60.0  # seconds; an upper limit that waiting rarely reaches


def stream(milliseconds: int) -> bytes:
    return bytes([REALTIME_DATA_4]) + milliseconds.to_bytes(2, "little") + bytes(18)


def refused(*arguments: str) -> str:
    """Returns the error message of an emulator that cannot start."""
    result = run("emulate", *arguments)
    assert result.status == 1, result
    return result.error


def talk(requests: bytes, *arguments: str) -> bytes:
    """Returns what an emulator on standard output answers to its standard input."""
    done = subprocess.run(
        [PROGRAM, "emulate", "--stdio", *arguments],
        input=requests,
        capture_output=True,
        timeout=PATIENCE,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def restore_sighup() -> None:
    """Restores the default handling of SIGHUP, in case the tests run under nohup."""
    signal.signal(signal.SIGHUP, signal.SIG_DFL)


class Emulator:
    """sbgc emulate, running until the with block ends. `places` are the addresses of its boards."""

    def __init__(
        self, *arguments: str, boards: int = 1, places: int = 1, stderr: Optional[str] = None
    ) -> None:
        with open(stderr or os.devnull, "w", encoding="utf-8") as error:
            self.process = subprocess.Popen(
                [PROGRAM, "emulate", *arguments],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=error if stderr else subprocess.PIPE,
                preexec_fn=restore_sighup,
            )
        assert self.process.stdout is not None
        self.places: list[str] = []
        self.lines: list[Line] = []
        self.error = ""
        for _ in range(boards * places):
            line = self.process.stdout.readline().decode()
            if not line:
                break
            heading, _, place = line.rstrip("\n").partition(": ")
            assert heading.startswith("emulated gimbal "), line
            self.places.append(place)

    def __enter__(self) -> Emulator:
        if not self.places:
            self.end()
            raise AssertionError(self.error)
        return self

    def host(self, place: int = 0) -> Connection:
        """Connects a host, until the with block ends."""
        line = Connection(self.places[place])
        self.lines.append(line)
        return line

    def __exit__(
        self,
        kind: Optional[Type[BaseException]],
        error: Optional[BaseException],
        trace: Optional[TracebackType],
    ) -> None:
        for line in self.lines:
            line.close()
        if self.process.poll() is None:
            status = self.end()
            assert kind is not None or status == 0, self.error

    def end(self, number: int = signal.SIGTERM) -> int:
        """Sends a signal, waits and returns the exit status."""
        if self.process.poll() is None:
            self.process.send_signal(number)
        return self.wait()

    def wait(self) -> int:
        out, error = self.process.communicate(timeout=PATIENCE)
        self.rest = out.decode()
        self.error = (error or b"").decode()
        assert not CRASH.search(self.error), self.error
        return self.process.returncode


class Line:
    """A conversation over a file descriptor."""

    def __init__(self, fd: int) -> None:
        self.fd = fd
        self.heard = b""

    def close(self) -> None:
        raise NotImplementedError

    def send(self, command: int, body: bytes = b"") -> None:
        os.write(self.fd, frame(command, body))

    def receive(self, seconds: float) -> bool:
        """Returns True if data arrives within `seconds`."""
        if not select.select([self.fd], [], [], seconds)[0]:
            return False
        try:
            data = os.read(self.fd, 65536)
        except ConnectionResetError:
            return False
        self.heard += data
        return bool(data)

    def body(self, command: int, seconds: float = PATIENCE) -> bytes:
        """Returns the body of the next frame of that command; fails on timeout."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            start = self.heard.find(bytes([0x3E, command]))
            if start >= 0 and len(self.heard) > start + 4:
                size = self.heard[start + 2]
                if len(self.heard) >= start + size + 5:
                    body = self.heard[start + 4 : start + 4 + size]
                    self.heard = self.heard[start + size + 5 :]
                    return body
            self.receive(max(0.0, end - time.monotonic()))
        raise AssertionError(f"no frame {command}; heard {self.heard.hex()}")

    def ask(self, command: int, body: bytes = b"", answer: Optional[int] = None) -> bytes:
        self.heard = b""
        self.send(command, body)
        return self.body(command if answer is None else answer)


class Terminal(Line):
    """The host's end of a pseudo-terminal, in raw mode, at a given rate."""

    def __init__(self, path: str, rate: int = termios.B115200) -> None:
        super().__init__(os.open(path, os.O_RDWR | os.O_NOCTTY))
        tty.setraw(self.fd)
        self.set_rate(rate)

    def set_rate(self, rate: int) -> None:
        settings = termios.tcgetattr(self.fd)
        settings[4] = settings[5] = rate
        termios.tcsetattr(self.fd, termios.TCSANOW, settings)
        termios.tcflush(self.fd, termios.TCIFLUSH)
        self.heard = b""

    def close(self) -> None:
        os.close(self.fd)


class Connection(Line):
    """A socket connected to a place such as "tcp:127.0.0.1:5000"."""

    def __init__(self, place: str) -> None:
        protocol, host, port = place.split(":")
        kind = socket.SOCK_STREAM if protocol == "tcp" else socket.SOCK_DGRAM
        self.socket = socket.socket(socket.AF_INET, kind)
        self.socket.connect((host, int(port)))
        super().__init__(self.socket.fileno())

    def close(self) -> None:
        self.socket.close()

    def is_refused(self) -> bool:
        """Returns True if the other side closes the connection without a byte."""
        self.socket.settimeout(PATIENCE)
        return self.socket.recv(1) == b""


def terminal_of(place: str) -> Path:
    return Path(place.split(" ")[0])
