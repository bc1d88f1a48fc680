"""Kills commands of sbgc with SIGKILL, many times: at every call of the system in turn, in the middle of
each, and at random moments of a run whose calls are stretched. Also lets every call in turn fail.

    kills.py [--kills 1000] [--seed 1]

The environment variables SBGC and SBGC_FAULTS name the command and the library to preload.
"""

from __future__ import annotations

import argparse
import errno
import itertools
import os
import random
import sys
import tempfile
from collections import Counter
from pathlib import Path

from emulated_gimbal import emulated_gimbal
from victims import KILLED, Backup, Bridge, Capture, ClientCapture, Restore, State, Victim

PAUSE = 2000  # microseconds that a call takes longer


def sweep(victim: Victim, mode: str, most: int) -> int:
    """Kills at each call in turn. Returns how many there are, or `most`."""
    for number in range(1, most + 1):
        status = victim.attempt(f"{mode} {number}")
        victim.check(status)
        if status != KILLED:
            assert status == 0, victim.error
            return number - 1
    return most


def let_fail(victim: Victim, calls: int, number: int) -> None:
    """Each call in turn fails, and all later ones."""
    for call in range(1, calls + 1):
        status = victim.attempt(f"fail {call} {number}")
        victim.check(status)
        assert status == 0 or os.strerror(number) in victim.error, victim.error


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kills", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    chance = random.Random(options.seed)
    kills: Counter[str] = Counter()
    calls: dict[str, int] = {}
    with tempfile.TemporaryDirectory() as name, emulated_gimbal() as gimbal:
        folder = Path(name)
        victims: dict[str, Victim] = {
            "backup": Backup(folder / "backup", gimbal, replaces=False),
            "backup --force": Backup(folder / "replaced", gimbal, replaces=True),
            "record": Capture(folder / "capture"),
            "info --capture": ClientCapture(folder / "client", gimbal),
            "emulate --state": State(folder / "state"),
            "bridge": Bridge(folder / "bridge", gimbal),
            "bridge, traffic": Bridge(folder / "traffic", gimbal, at_traffic=True),
        }
        for what, victim in victims.items():
            for mode in ("kill", "tear"):
                calls[what] = sweep(victim, mode, 40)
                kills[what] += calls[what]
            if what != "bridge, traffic":
                for number in (errno.ENOSPC, errno.EROFS, errno.EIO):
                    let_fail(victim, calls[what], number)
            print(f"{what}: every one of {calls[what]} calls", flush=True)
        # The restored board is one of its own: the others read it.
        with emulated_gimbal() as board:
            victims["restore"] = Restore(folder / "restore", board)
            calls["restore"] = sweep(victims["restore"], "kill", 100)
            kills["restore"] += calls["restore"]
            print(f"restore: every one of {calls['restore']} calls", flush=True)
            for what in itertools.cycle(victims):
                if sum(kills.values()) >= options.kills:
                    break
                longest = (calls[what] + 2) * PAUSE
                victim = victims[what]
                status = victim.attempt(f"time {chance.randrange(longest)} {PAUSE}")
                victim.check(status)
                kills[what] += status == KILLED
        for victim in victims.values():
            victim.end()
    for what, number in kills.items():
        print(f"{number:5} {what}")
    print(f"{sum(kills.values()):5} kills, nothing torn")


if __name__ == "__main__":
    sys.exit(main())
