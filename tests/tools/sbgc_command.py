"""Runs the sbgc command for the tests. The environment variable SBGC names the program, and SBGC_SYSTEM
the system that it was built for.
"""

from __future__ import annotations

import json
import os
import random
import re
import socket
import subprocess
import threading
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Optional

PROGRAM = os.environ.get("SBGC", "sbgc")
ON_WINDOWS = os.environ.get("SBGC_SYSTEM") == "Windows"
ROOT = Path(__file__).resolve().parents[2]
MODEL = json.loads((ROOT / "generated" / "simplebgc.json").read_text(encoding="utf-8"))
VECTORS = json.loads((ROOT / "tests" / "data" / "vectors.json").read_text(encoding="utf-8"))

CRASH = re.compile(r"terminate called|what\(\)|Assertion|core dumped|Sanitizer|runtime error", re.I)


@dataclass(frozen=True)
class Result:
    status: int
    out: bytes
    error: str

    @property
    def text(self) -> str:
        return self.out.decode()

    @property
    def objects(self) -> list[Any]:
        return [json.loads(line) for line in self.text.splitlines()]


def run(
    *arguments: str, stdin: bytes | str = b"", stdout: Optional[int] = None, **options: Any
) -> Result:
    """Runs the program; it must exit by itself, for every input, and never by a signal."""
    done = subprocess.run(
        [PROGRAM, *arguments],
        input=stdin.encode() if isinstance(stdin, str) else stdin,
        stdout=subprocess.PIPE if stdout is None else stdout,
        stderr=subprocess.PIPE,
        timeout=60,
        check=False,
        **options,
    )
    result = Result(done.returncode, done.stdout or b"", done.stderr.decode())
    assert result.status in (0, 1, 2, 3), result
    assert not CRASH.search(result.error), result
    assert result.status != 2 or result.error, result
    # Commands for a board also report progress there.
    if arguments and arguments[0] in ("decode", "encode", "ports"):
        is_explained = result.error.count("\n") <= 1 if result.status == 0 else result.error
        assert is_explained, result  # a note at most, or why it failed
    return result


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


def two_free_ports() -> int:
    """Returns the first of two free consecutive ports, below the system's ephemeral range."""
    while True:
        port = random.randrange(10000, 30000)
        try:
            with socket.socket() as first, socket.socket() as second:
                first.bind(("127.0.0.1", port))
                second.bind(("127.0.0.1", port + 1))
                return port
        except OSError:
            pass


class Running(subprocess.Popen[str]):
    """The program while it runs; its lines can be read."""

    def __init__(self, *arguments: str, **options: Any) -> None:
        pipes: dict[str, Any] = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
        super().__init__([PROGRAM, *arguments], text=True, **pipes | options)

    def line(self) -> str:
        assert self.stdout is not None
        return self.stdout.readline()

    def address(self) -> str:
        """Returns that in the next line: "emulated gimbal 1: tcp:127.0.0.1:5000 (also ...)"."""
        return self.line().split(": ", 1)[1].split()[0]

    def wait_for(self, words: str) -> list[str]:
        """Returns what it has reported up to a line with these words."""
        assert self.stderr is not None
        deadline = threading.Timer(60, self.kill)
        deadline.start()
        lines = [""]
        try:
            while words not in lines[-1]:
                lines.append(self.stderr.readline())
                assert lines[-1], (words, lines)
        finally:
            deadline.cancel()
        return lines[1:]


def decode(stdin: bytes | str, *options: str) -> list[Any]:
    """Returns the objects of `sbgc decode --format jsonl`, which must succeed."""
    result = run("decode", "--format", "jsonl", *options, stdin=stdin)
    assert result.status == 0, result
    return result.objects


def decode_one(stdin: bytes | str, *options: str) -> Any:
    (line,) = decode(stdin, *options)
    return line


def frame(command: int, body: bytes = b"") -> bytes:
    header = bytes([command, len(body)])
    return b">" + header + bytes([sum(header) % 256]) + body + bytes([sum(body) % 256])


def valid_frames() -> list[dict[str, Any]]:
    """Returns the intact frames from public sources, with their bytes; plain bodies are framed."""
    result = []
    for vector in VECTORS:
        if vector["expect"] != "valid":
            continue
        data = bytes.fromhex(vector["hex"])
        if vector["kind"] == "payload":
            data = frame(vector["command_id"], data)
        result.append({**vector, "bytes": data})
    return result
