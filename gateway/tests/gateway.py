"""A running `sbgc gateway` for tests."""

from __future__ import annotations

import os
import re
import subprocess
import time
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TypeVar

from sbgc_command import PROGRAM

T = TypeVar("T")


def eventually(look: Callable[[], T], seconds: float = 30) -> T:
    """Returns the result of `look` as soon as it is true."""
    end = time.monotonic() + seconds
    while True:
        found = look()
        if found:
            return found
        assert time.monotonic() < end, "it did not come about in time"
        time.sleep(0.05)


class Gateway:
    """A gateway of the fleet in a text, in its own folder. If the text contains LISTEN, its metrics are at
    a free port."""

    keeps_signals = False  # that Python ignores, such as SIGXFSZ
    hangs_at_disk = False  # while the file `hang` is in its folder

    def __init__(self, folder: Path, text: str) -> None:
        self.file = folder / "fleet.toml"
        text = text.replace("LISTEN", "127.0.0.1:0")
        self.file.write_bytes(text.encode(errors="surrogateescape"))
        self.log = folder / "gateway.log"
        self.restart()

    def restart(self) -> None:
        environment = dict(os.environ)
        if self.hangs_at_disk:
            environment["SBGC_FAULT_WHILE"] = str(self.file.parent / "hang")
            environment["LD_PRELOAD"] = os.environ["SBGC_FAULTS"]
        self.process = subprocess.Popen(
            [PROGRAM, "gateway", "--config", str(self.file)],
            stdout=subprocess.DEVNULL,
            stderr=self.log.open("ab"),
            restore_signals=not self.keeps_signals,
            env=environment,
        )

    @property
    def metrics_address(self) -> str:
        pattern = re.compile(r"metrics at (http://\S+)")
        found = eventually(lambda: pattern.search(self.log.read_text()))
        return found.group(1)

    def metrics_text(self) -> str:
        with urllib.request.urlopen(self.metrics_address, timeout=20) as answer:
            return answer.read().decode()

    def metrics(self) -> dict[str, float]:
        """The values by name and labels, such as sbgc_gimbal_up{gimbal="front"}."""
        lines = [line for line in self.metrics_text().splitlines() if not line.startswith("#")]
        return {name: float(value) for name, value in (line.rsplit(" ", 1) for line in lines)}

    def metric(self, name: str) -> float | None:
        return self.metrics().get(name)

    def is_up(self, gimbal: str) -> bool:
        return self.metric(f'sbgc_gimbal_up{{gimbal="{gimbal}"}}') == 1

    def end(self) -> int:
        """Ends it like a service manager, and returns its status."""
        self.process.terminate()
        return self.process.wait(timeout=60)

    def kill(self) -> None:
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()


@contextmanager
def hanging_disk(folder: Path) -> Iterator[None]:
    """For gateways of this folder with `hangs_at_disk`, inside a `with`."""
    (folder / "hang").touch()
    try:
        yield
    finally:
        (folder / "hang").unlink(missing_ok=True)


@contextmanager
def running_gateway(folder: Path, text: str) -> Iterator[Gateway]:
    gateway = Gateway(folder, text)
    try:
        yield gateway
    except AssertionError:
        print(gateway.log.read_text())
        raise
    finally:
        gateway.kill()
