"""`kill -9` of a gateway on mosquitto while it executes commands: no command plays its tones twice, and none is
without a result. `kill_test.py ROUNDS` kills more often.

Each command plays a melody of a different length, which the log of the emulated gimbal shows.
"""

from __future__ import annotations

import os
import random
import re
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

from brokers import Commander, Mosquitto, Subscriber, now
from gateway import Gateway, eventually, hanging_disk
from sbgc_command import PROGRAM
from studio import fleet_of, gimbal_of

BODY_WITHOUT_NOTES = 12
NOTES = range(1, 26)
ROUNDS = 5
PLAYED = re.compile(r"> CMD_BEEP_SOUND \(89\), (\d+) bytes +executed")


class Rounds:
    def __init__(self, folder: Path, seed: int) -> None:
        self.random = random.Random(seed)
        self.log = folder / "gimbal.log"
        self.gimbal = subprocess.Popen(
            [PROGRAM, "emulate", "--tcp", "0", "--verbose"],
            stdout=self.log.open("wb"),
            stderr=subprocess.STDOUT,
        )
        first = eventually(lambda: self.log.read_text())
        address = first.split(": ", 1)[1].split()[0]
        self.broker = Mosquitto(folder / "broker")
        self.broker.start()
        self.seen = Subscriber(self.broker.port, ["sbgc/studio/reply/#", "sbgc/studio/front/state"])
        self.say = Commander(self.broker.port)
        gimbal = gimbal_of(address, "raw", 'raw-effects = ["sets"]')
        self.gateway = Gateway(folder, fleet_of(f'"127.0.0.1:{self.broker.port}"', gimbal))
        self.statuses: Counter[str] = Counter()

    def close(self) -> None:
        self.gateway.kill()
        self.seen.close()
        self.broker.kill()
        self.gimbal.kill()
        self.gimbal.wait()

    def wait_until_online(self) -> None:
        eventually(lambda: "front is online" in self.gateway.log.read_text())

    def played(self, since: int) -> Counter[int]:
        text = self.log.read_bytes()[since:].decode(errors="replace")
        return Counter((int(size) - BODY_WITHOUT_NOTES) // 2 for size in PLAYED.findall(text))

    def run(self, number: int) -> None:
        """One kill: every command has a result, none is executed twice, and results are true."""
        begin = self.log.stat().st_size
        keys = {f"{number}-{notes}": notes for notes in NOTES}
        payloads = []
        for key, notes in keys.items():
            fields: dict[str, Any] = {"mode": "BEEPER_MODE_CUSTOM_MELODY", "note_length": 1}
            fields["note_freq_hz"] = [1000] * notes
            beep = {"message": "BeepSound", "fields": fields}
            payloads.append(self.say.payload(beep, key=key, deadline=now() + 50_000))
        publishing = self.say.publish_many("sbgc/studio/front/raw", payloads)
        time.sleep(self.random.uniform(0, 0.4))
        if self.gateway.hangs_at_disk:
            with hanging_disk(self.gateway.file.parent):
                time.sleep(self.random.uniform(0, 1))
                self.gateway.kill()
        self.gateway.kill()
        publishing.wait(timeout=60)
        self.gateway.restart()
        results: dict[str, list[Any]] = {}

        def has_all() -> bool:
            results.clear()
            for one in self.seen.results():
                results.setdefault(one["key"], []).append(one)
            return all(key in results for key in keys)

        eventually(has_all, 120)
        done = {notes for key, notes in keys.items() if results[key][0]["status"] == "done"}
        # The gimbal answers before it writes its log.
        eventually(lambda: done <= set(self.played(begin)))
        played = self.played(begin)
        for key, notes in keys.items():
            first = results[key][0]["status"]
            self.statuses[first] += 1
            assert {one["status"] for one in results[key]} == {first}, results[key]
            assert played[notes] <= 1, f"{key} was carried out {played[notes]} times"
            if first == "refused":
                assert played[notes] == 0, f"{key} was carried out: {results[key]}"
        self.seen.messages.clear()


def kill(folder: Path, rounds: int, seed: int = 1) -> Counter[str]:
    running = Rounds(folder, seed)
    try:
        running.wait_until_online()
        for number in range(rounds):
            running.run(number)
    except AssertionError:
        print(running.gateway.log.read_text()[-3000:])
        raise
    finally:
        running.close()
    return running.statuses


@pytest.mark.parametrize("hangs_at_disk", [False, True])
def test_kills_of_the_gateway(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, hangs_at_disk: bool
) -> None:
    if hangs_at_disk and "SBGC_FAULTS" not in os.environ:
        pytest.skip("there is no library of faults")
    monkeypatch.setattr("gateway.Gateway.hangs_at_disk", hangs_at_disk)
    statuses = kill(tmp_path, ROUNDS)
    assert sum(statuses.values()) == ROUNDS * len(NOTES)
    assert statuses["done"] > 0


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as temporary:
        count = int(sys.argv[1]) if len(sys.argv) > 1 else 100
        print(f"{count} kills, results: {dict(kill(Path(temporary), count))}")
