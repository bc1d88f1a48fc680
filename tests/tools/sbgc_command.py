"""Runs the sbgc command for the tests. The environment variable SBGC names the program, and SBGC_SYSTEM
the system that it was built for.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
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


def run(*arguments: str, stdin: bytes | str = b"", stdout: Optional[int] = None) -> Result:
    """Runs the program; it must exit by itself, for every input, and never by a signal."""
    done = subprocess.run(
        [PROGRAM, *arguments],
        input=stdin.encode() if isinstance(stdin, str) else stdin,
        stdout=subprocess.PIPE if stdout is None else stdout,
        stderr=subprocess.PIPE,
        timeout=60,
        check=False,
    )
    result = Result(done.returncode, done.stdout or b"", done.stderr.decode())
    assert result.status in (0, 1, 2, 3), result
    assert not CRASH.search(result.error), result
    assert result.status != 2 or result.error, result
    # Commands for a board also report progress there.
    if arguments and arguments[0] in ("decode", "encode", "ports"):
        note = "sbgc: none of the frames is selected\n"
        assert (result.status == 0) == (result.error in ("", note)), result
    return result


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
