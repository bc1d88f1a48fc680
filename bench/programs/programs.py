"""Measure whole programs: `sbgc decode`, the generator, and the compiler on the headers.

usage: programs.py [--quick] BUILD_FOLDER SBGC    (writes the format of Google Benchmark)

SBGC is the command. Times are those of the processor, user and system.
"""

from __future__ import annotations

import json
import os
import sys
import tempfile
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "bench/instructions"))

import instructions  # noqa: E402  # the streams to decode are the same

# Programs of users: one needs one message as JSON, the other one family of messages.
SOURCES = {
    "json_of_one_message": """
#include <sbgc/json.hpp>
#include <sbgc/meta/realtime.hpp>

std::string write(const sbgc::msg::RealtimeData4& message) { return sbgc::to_json(message); }

bool read(std::string_view text, sbgc::msg::RealtimeData4& message) {
  return static_cast<bool>(sbgc::from_json(text, message));
}
""",
    "one_family": """
#include <sbgc/message.hpp>
#include <sbgc/messages/control.hpp>

sbgc::WriteResult write(const sbgc::msg::ControlExt& control, std::span<std::uint8_t> frame) {
  return sbgc::encode_frame(control, frame);
}
""",
}


def run(*command: str) -> tuple[float, int]:
    """Runs a command without its output; returns its processor time and peak memory in kilobytes."""
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)  # keep the default: the second run is faster
    child = os.fork()
    if child == 0:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        os.execvp(command[0], command)
    _, status, usage = os.wait4(child, 0)
    if status != 0:
        raise SystemExit(f"programs: {' '.join(command)} failed")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss


def entry(name: str, seconds: float, **more: float) -> dict[str, Any]:
    return {"name": name, "cpu_time": seconds, "time_unit": "s", **more}


def decode(sbgc: str, folder: Path, megabytes: int, repetitions: int) -> list[dict[str, Any]]:
    entries = []
    capture = folder / "capture.bin"
    for kind, bodies in instructions.DECODED.items():
        once = instructions.frames(bodies())
        with capture.open("wb") as file:
            for _ in range(megabytes * 1_000_000 // len(once)):
                file.write(once)
        size = capture.stat().st_size
        for output_format in ("jsonl", "text"):
            command = (sbgc, "decode", "--from", "board", "--format", output_format, str(capture))
            for _ in range(repetitions):
                seconds, memory = run(*command)
                measured = entry(
                    f"decode/{output_format}{kind}",
                    seconds,
                    bytes_per_second=size / seconds,
                    peak_megabytes=memory / 1000,
                )
                entries.append(measured)
    capture.unlink()
    return entries


def generator(folder: Path, repetitions: int) -> list[dict[str, Any]]:
    entries = []
    for repetition in range(repetitions):
        output = folder / f"generated{repetition}"
        command = (
            str(ROOT / "generator" / "python"),
            *("-m", "sbgcgen", "generate", "--root", str(ROOT), "--output", str(output)),
        )
        entries.append(entry("generator/all", run(*command)[0]))
        entries.append(entry("generator/unchanged", run(*command)[0]))
    return entries


def compiler(folder: Path, repetitions: int) -> list[dict[str, Any]]:
    include = (f"-I{ROOT}/runtime/core/include", f"-I{ROOT}/generated/include")
    entries = []
    for name, text in SOURCES.items():
        source = folder / f"{name}.cpp"
        source.write_text(text, encoding="utf-8")
        command = ("g++", "-std=c++20", "-O2", *include, "-c", str(source), "-o", f"{folder}/out.o")
        entries += [entry(f"compile/{name}", run(*command)[0]) for _ in range(repetitions)]
    return entries


def main(arguments: list[str]) -> int:
    quick = arguments[:1] == ["--quick"]
    if len(arguments[quick:]) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    build, sbgc = arguments[quick:]
    repetitions = 1 if quick else 3
    with tempfile.TemporaryDirectory(dir=build) as name:
        folder = Path(name)
        entries = [
            *generator(folder, repetitions),
            *compiler(folder, repetitions),
            *decode(sbgc, folder, 5 if quick else 100, repetitions),
        ]
    json.dump({"benchmarks": entries}, sys.stdout, indent=1)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
