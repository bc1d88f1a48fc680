"""100,000 damaged frames and 100 MB: no error of Lua, enough speed, little memory. Minutes: see ./dev test --long."""

from __future__ import annotations

import json
import random
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

from line import DISSECTOR, ROOT, Packet, line, tshark
from sbgc_command import frame

MEGABYTE = 1_000_000
LEAST_SPEED = 5 * MEGABYTE  # bytes of a file per second of the processor
MOST_MEMORY = 100 * MEGABYTE  # above that of tshark alone


def frames() -> list[tuple[int, bytes]]:
    """The direction and frame of every vector."""
    found = []
    for path in sorted((ROOT / "generated" / "vectors").glob("*.jsonl")):
        for vector in map(json.loads, path.read_text("utf-8").splitlines()):
            if "hex" in vector:
                body = bytes.fromhex(vector["hex"])
                found.append(
                    (1 if vector["direction"] == "from_board" else 2, frame(vector["id"], body))
                )
    return found


def damaged(count: int) -> Iterator[Packet]:
    """Frames with other bodies and checksums that fit, and frames with anything wrong."""
    chance = random.Random(count)
    good = frames()
    for _ in range(count):
        direction, whole = chance.choice(good)
        data = bytearray(whole)
        for _ in range(chance.randint(1, 4)):
            data[chance.randrange(len(data))] = chance.randrange(256)
        if chance.random() < 0.7:  # a body that is not as it should be
            data = bytearray(frame(whole[1], bytes(data[4:-1])[: chance.randint(0, 255)]))
        yield Packet(bytes(data), chance.choice((direction, direction, 3 - direction)))


def cost(*command: str) -> tuple[float, int]:
    """Seconds of the processor, and bytes of memory."""
    program = (
        "import resource, subprocess, sys; subprocess.run(sys.argv[1:], check=True, "
        "stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL); "
        "u = resource.getrusage(resource.RUSAGE_CHILDREN); print(u.ru_utime + u.ru_stime, u.ru_maxrss)"
    )
    out = subprocess.run(
        [sys.executable, "-c", program, *command], stdout=subprocess.PIPE, check=True
    )
    seconds, kilobytes = out.stdout.split()
    return float(seconds), int(kilobytes) * 1024


def check_damaged(folder: Path) -> None:
    file = folder / "damaged"
    file.write_bytes(line(damaged(100_000)))
    for options in (["-V"], ["-2"], ["-Y", "sbgc.expert.range"]):
        tshark(file, *options)
        print(f"no error of Lua in 100,000 damaged frames: tshark {' '.join(options)}", flush=True)


def check_speed(folder: Path) -> None:
    file, chance = folder / "large", random.Random(1)
    samples = [
        whole for way, whole in frames() if way == 1 and len(whole) == 129 and whole[1] == 25
    ]
    file.write_bytes(line(Packet(chance.choice(samples)) for _ in range(100 * MEGABYTE // 172)))
    alone = cost("tshark", "-n", "-r", str(file))
    both = cost("tshark", "-n", "-X", f"lua_script:{DISSECTOR}", "-r", str(file))
    speed = file.stat().st_size / (both[0] - alone[0])
    memory = both[1] - alone[1]
    print(f"{speed / MEGABYTE:.1f} MB/s, {memory / MEGABYTE:.0f} MB above tshark alone")
    assert speed >= LEAST_SPEED and memory <= MOST_MEMORY


if __name__ == "__main__":
    with TemporaryDirectory() as name:
        check_damaged(Path(name))
        check_speed(Path(name))
