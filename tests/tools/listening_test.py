"""Programs that listen do so on this machine only, unless told otherwise: as the kernel sees it."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from captures import CAPTURE
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from sbgc_command import PROGRAM

LISTENS = "0A"
LOOPBACK = {"0100007F", "00000000000000000000000001000000"}
EVERYWHERE = "00000000"


def places_of(process: int) -> set[str]:
    """The local addresses of the process's listening TCP and unconnected UDP sockets."""
    sockets = set()
    for descriptor in Path(f"/proc/{process}/fd").iterdir():
        target = os.readlink(descriptor)
        if target.startswith("socket:["):
            sockets.add(target[8:-1])
    found = set()
    for protocol in ("tcp", "tcp6", "udp", "udp6"):
        table = Path(f"/proc/net/{protocol}")
        for line in table.read_text(encoding="utf-8").splitlines()[1:] if table.exists() else []:
            _, here, there, state, *_, inode = line.split()[:10]
            is_waiting = state == LISTENS or (protocol[:3] == "udp" and there.endswith(":0000"))
            if inode in sockets and is_waiting:
                found.add(here.rsplit(":", 1)[0])
    return found


@pytest.fixture(scope="module", name="gimbal")
def gimbal_() -> Iterator[EmulatedGimbal]:
    with emulated_gimbal() as running:
        yield running


@contextmanager
def serving(*arguments: str) -> Iterator[int]:
    """Runs a command that prints one address for each of its places; gives the process."""
    process = subprocess.Popen(
        [PROGRAM, *arguments], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL
    )
    assert process.stdout is not None
    for _ in range(sum(argument.startswith("--") for argument in arguments)):
        assert process.stdout.readline()
    try:
        yield process.pid
    finally:
        process.kill()
        process.communicate()


@pytest.mark.parametrize("address, expected", [("0", LOOPBACK), ("0.0.0.0:0", {EVERYWHERE})])
@pytest.mark.parametrize(
    "command, place",
    [
        ("emulate", "--tcp"),
        ("emulate", "--udp"),
        ("bridge", "--tcp"),
        ("bridge", "--udp"),
        ("bridge", "--ws"),
        ("replay", "--tcp"),
        ("replay", "--udp"),
    ],
)
def test_it_listens_only_where_it_is_told(
    gimbal: EmulatedGimbal,
    tmp_path: Path,
    command: str,
    place: str,
    address: str,
    expected: set[str],
) -> None:
    capture = tmp_path / "capture"
    capture.write_bytes(CAPTURE)
    source = {"emulate": [], "bridge": [gimbal.address], "replay": [str(capture)]}[command]
    with serving(command, *source, place, address) as process:
        found = places_of(process)
    assert found and found <= expected
