"""Count instructions with Callgrind, and compare them with the committed figures.

usage: instructions.py [--accept] PROGRAM SBGC

Unlike times, instructions do not depend on the load of the machine. Only the functions of the program
itself count: those of libraries, such as memcpy, depend on the processor. PROGRAM does the work of
instructions.cpp. SBGC is the command, whose decoding is counted, too. Fails if a figure exceeds the one in
figures.json, next to this script, by over 5 %; --accept writes that file.
"""

from __future__ import annotations

import itertools
import json
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

FIGURES = Path(__file__).with_name("figures.json")
VECTORS = Path(__file__).resolve().parents[2] / "generated/vectors/realtime.jsonl"
TOLERANCE = 1.05

STREAM_SIZE = 256 << 10
REALTIME_DATA_4 = 25
BODY_SIZE = 124


def callgrind(folder: Path, *command: str) -> str:
    """Runs a command in Callgrind, which writes its dumps to the folder; returns the output."""
    options = ["--tool=callgrind", f"--callgrind-out-file={folder}/out", "--quiet"]
    done = subprocess.run(
        ["valgrind", *options, *command], check=True, capture_output=True, text=True
    )
    return done.stdout


def own_cost(dump: str, program: Path) -> int:
    """Returns the cost of the functions of `program` in a dump, without those that they call."""
    names: dict[str, str] = {}
    total = 0
    is_own = is_call = False
    for line in dump.splitlines():
        if line.startswith("ob="):
            number, _, name = line[3:].partition(" ")
            is_own = names.setdefault(number, name) == str(program)
        elif line.startswith("cob="):
            number, _, name = line[4:].partition(" ")
            names.setdefault(number, name)
        elif line.startswith("calls="):
            is_call = True  # the next line has the cost of the callee
        elif re.match(r"[+*\-\d]", line):
            if is_own and not is_call:
                total += int(line.split()[1])
            is_call = False
    return total


def count_core(program: Path) -> dict[str, float]:
    """Returns the instructions per byte or message of each case of the program."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        options = ["--collect-atstart=no", "--instr-atstart=no"]
        output = callgrind(folder, *options, str(program))
        units = {case: int(number) for case, number in map(str.split, output.splitlines())}
        costs = {}
        for path in folder.iterdir():
            dump = path.read_text(encoding="utf-8")
            found = re.search(r"^desc: Trigger: Client Request: (.*)$", dump, re.MULTILINE)
            if found:
                costs[found[1]] = own_cost(dump, program)
        return {case: costs[case] / number for case, number in units.items()}


def random_bodies() -> Iterator[bytes]:
    value = 1
    while True:
        body = bytearray()
        for _ in range(BODY_SIZE):
            value = value * 1103515245 + 12345 & 0x7FFFFFFF
            body.append(value >> 16 & 255)
        yield bytes(body)


def typical_bodies() -> Iterator[bytes]:
    """The bodies with typical values of the test vectors, repeated."""
    lines = VECTORS.read_text(encoding="utf-8").splitlines()
    vectors = [vector for vector in map(json.loads, lines) if vector["why"] == "typical values"]
    bodies = [bytes.fromhex(v["hex"]) for v in vectors if v["message"] == "RealtimeData4"]
    return itertools.cycle(body for body in bodies if len(body) == BODY_SIZE)


def frames(bodies: Iterator[bytes]) -> bytes:
    """A stream of CMD_REALTIME_DATA_4."""
    stream = bytearray()
    while len(stream) < STREAM_SIZE:
        body = next(bodies)
        header = REALTIME_DATA_4 + BODY_SIZE & 255
        stream += bytes([0x3E, REALTIME_DATA_4, BODY_SIZE, header])
        stream += body + bytes([sum(body) & 255])
    return bytes(stream)


# Typical values, and random ones, of which many need a remark.
DECODED = {"": typical_bodies, "_random": random_bodies}


def count_decode(sbgc: Path, output_format: str, stream: bytes) -> float:
    """Returns the instructions per byte of `sbgc decode`, without those to start it."""
    start = decode_cost(sbgc, output_format, b"")
    return (decode_cost(sbgc, output_format, stream) - start) / len(stream)


def decode_cost(sbgc: Path, output_format: str, stream: bytes) -> int:
    """Returns the instructions of `sbgc decode`."""
    with tempfile.TemporaryDirectory() as name:
        capture = Path(name) / "capture.bin"
        capture.write_bytes(stream)
        folder = Path(name) / "dumps"
        folder.mkdir()
        command = [str(sbgc), "decode", "--from", "board", "--format", output_format, str(capture)]
        callgrind(folder, *command)
        dump = (folder / "out").read_text(encoding="utf-8")
        return own_cost(dump, sbgc)


def compare(figures: dict[str, float], accepted: dict[str, float]) -> list[str]:
    """Prints the figures; returns the cases that got worse or are not accepted."""
    worse = []
    print(f"{'instructions per byte or message':<34} {'accepted':>10} {'now':>10}")
    for case, figure in figures.items():
        before = accepted.get(case)
        is_worse = before is None or figure > before * TOLERANCE
        change = "new" if before is None else f"{(figure / before - 1) * 100:+.1f} %"
        shown = "" if before is None else f"{before:.2f}"
        print(f"  {case:<32} {shown:>10} {figure:>10.2f}  {change}{'  WORSE' if is_worse else ''}")
        if is_worse:
            worse.append(case)
    return worse + [f"{case} (missing)" for case in accepted if case not in figures]


def main(arguments: list[str]) -> int:
    accept = arguments[:1] == ["--accept"]
    programs = [Path(path).resolve() for path in arguments[accept:]]
    if len(programs) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    figures = count_core(programs[0])
    accepted = json.loads(FIGURES.read_text(encoding="utf-8")) if FIGURES.exists() else {}
    for output_format, (kind, bodies) in itertools.product(("jsonl", "text"), DECODED.items()):
        case = f"decode/{output_format}{kind}"
        figures[case] = count_decode(programs[1], output_format, frames(bodies()))
    worse = compare(figures, accepted)
    if accept:
        rounded = {case: round(figure, 3) for case, figure in figures.items()}
        FIGURES.write_text(json.dumps(rounded, indent=2) + "\n", encoding="utf-8")
        return 0
    if worse:
        print(f"instructions: worse by over 5 %: {', '.join(worse)}", file=sys.stderr)
        print("./dev bench --accept accepts the figures, if there is a reason", file=sys.stderr)
    return 1 if worse else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
