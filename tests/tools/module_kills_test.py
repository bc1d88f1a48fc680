"""Loading the firmware of a module, ended by kill -9 and by faults of the line at any part.

Whatever ends it, no part reaches the board twice or out of turn, and the next run starts again. SBGC_KILLS is
the number of runs; `./dev test crash --long` makes 200.
"""

from __future__ import annotations

import os
import random
import re
import shlex
import subprocess
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from relay import frames_in, relay_to
from sbgc_command import PROGRAM, run

RUNS = int(os.environ.get("SBGC_KILLS", "8"))
PARTS = 24
START, WRITE = 78, 81


class Line:
    """The traffic from hosts to the board, with one fault."""

    def __init__(self) -> None:
        self.changed = threading.Condition()
        self.parts: list[tuple[int, int]] = []  # of a run, since its start
        self.fault = ""
        self.at = PARTS

    def to_board(self, data: bytes) -> bytes:
        with self.changed:
            copies = 1
            for command, body in frames_in(data):
                if command == START:
                    self.parts = []
                if command == WRITE:
                    self.parts.append((body[1], int.from_bytes(body[2:6], "little")))
                    if len(self.parts) == self.at:
                        copies = {"loses a part": 0, "repeats a part": 2}.get(self.fault, 1)
            self.changed.notify_all()
        return data * copies

    def to_host(self, data: bytes) -> bytes:
        is_lost = self.fault == "loses a confirmation" and len(self.parts) == self.at
        return b"" if is_lost else data

    def wait_for_parts(self) -> None:
        with self.changed:
            assert self.changed.wait_for(lambda: len(self.parts) >= self.at, timeout=60)

    def check(self) -> None:
        """Each part that a run has sent is the one after the part before."""
        with self.changed:
            assert self.parts == [(i, 128 * i) for i in range(len(self.parts))]


@pytest.fixture(name="gimbal", scope="module")
def one_gimbal() -> Iterator[EmulatedGimbal]:
    with emulated_gimbal("--board", "3.6", "--firmware", "2.74.5") as gimbal:
        yield gimbal


def test_no_part_is_repeated_or_skipped(gimbal: EmulatedGimbal, tmp_path: Path) -> None:
    file = tmp_path / "a driver.bin"
    numbers = random.Random(38)
    file.write_bytes(numbers.randbytes(128 * PARTS))
    line = Line()
    with relay_to(gimbal.address, line.to_board, line.to_host) as address:
        flash = ["module", "flash", str(file), "--module", "CAN_DRV1", "-p", address]
        faults = ["repeats a part", "loses a part", "loses a confirmation"]
        for number in range(RUNS):
            line.parts = []
            line.at = numbers.randint(1, PARTS)
            # Each lost frame costs a timeout.
            line.fault = "" if number % 4 else faults[number // 4 % 3]
            if not line.fault:
                with subprocess.Popen([PROGRAM, *flash, "--yes"], stderr=subprocess.DEVNULL) as one:
                    line.wait_for_parts()
                    one.kill()
                assert one.returncode in (0, -9)
                line.check()
                continue
            failed = run(*flash, "--yes")
            line.check()
            text = " ".join(failed.error.split())
            if line.fault == "repeats a part" and failed.status == 0:
                continue  # the refusal of the copy came between two parts
            assert failed.status == 1, (line.fault, line.at, text)
            assert len(line.parts) <= line.at + 1
            last = re.search(r"part (\d+) was confirmed last|no part was confirmed", text)
            assert last and int(last[1] or 0) in (line.at - 2, line.at - 1, 0), (line.at, text)
            hint = re.search(r"`sbgc (.*)`", text)
            assert hint and shlex.split(hint[1]) == flash, text
        line.fault = ""
        done = run(*flash, "--yes")
        assert done.status == 0, done
        line.check()
        assert len(line.parts) == PARTS
