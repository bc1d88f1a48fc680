"""Nothing is torn by kill -9, a full disk or a read-only one. `./dev test crash --long` kills 1,000 times."""

from __future__ import annotations

import errno
import os
from collections.abc import Iterator
from pathlib import Path

import pytest

from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from sbgc_command import run
from victims import KILLED, Backup, Bridge, Capture, ClientCapture, State, Victim

MOST_CALLS = 100  # more than any of these makes


@pytest.fixture(scope="module", name="gimbal")
def gimbal_() -> Iterator[EmulatedGimbal]:
    with emulated_gimbal() as running:
        yield running


@pytest.fixture(
    name="victim", params=["backup", "replaced", "capture", "client", "state", "bridge"]
)
def victim_(request: pytest.FixtureRequest, gimbal: EmulatedGimbal, tmp_path: Path) -> Victim:
    folder = tmp_path / "f"
    make = {
        "backup": lambda: Backup(folder, gimbal, replaces=False),
        "replaced": lambda: Backup(folder, gimbal, replaces=True),
        "capture": lambda: Capture(folder),
        "client": lambda: ClientCapture(folder, gimbal),
        "state": lambda: State(folder),
        "bridge": lambda: Bridge(folder, gimbal),
    }
    return make[request.param]()


# Others than these are in the long run.
STEPS = {Backup: 2, Capture: 2, ClientCapture: 2, State: 6, Bridge: 1}


def test_a_kill_at_a_call_tears_nothing(victim: Victim) -> None:
    kills = 0
    for number in range(1, MOST_CALLS, STEPS[type(victim)]):
        status = victim.attempt(f"{('kill', 'tear')[kills % 2]} {number}")
        victim.check(status)
        if status != KILLED:
            assert status == 0, victim.error
            break
        kills += 1
    assert kills >= 1
    assert status == 0
    victim.end()


@pytest.mark.parametrize("number", [errno.ENOSPC, errno.EROFS], ids=errno.errorcode.get)
def test_a_disk_that_takes_nothing_is_reported(victim: Victim, number: int) -> None:
    assert victim.attempt(f"fail 1 {number}") == 1
    assert os.strerror(number) in victim.error
    victim.check(1)
    victim.end()


def test_a_disk_that_becomes_full_is_reported(victim: Victim) -> None:
    failures = 0
    for call in range(1, MOST_CALLS, STEPS[type(victim)]):
        status = victim.attempt(f"fail {call} {errno.ENOSPC}")
        victim.check(status)
        if status == 0:
            break
        assert status == 1
        assert os.strerror(errno.ENOSPC) in victim.error
        failures += 1
    assert failures >= 1
    assert status == 0
    victim.end()


def test_the_configuration_is_only_read(
    gimbal: EmulatedGimbal, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "config.toml"
    file.write_text(f'[gimbal.front]\nport = "{gimbal.address}"\n')
    before = file.stat()
    monkeypatch.setenv("SBGC_CONFIG", str(file))
    victim = Victim(tmp_path / "f")
    for fault in ("kill 1", f"fail 1 {errno.EROFS}"):
        assert victim.run(fault, tmp_path, "info", "-g", "front") == 0
    assert (file.stat().st_mtime_ns, file.stat().st_ino) == (before.st_mtime_ns, before.st_ino)


@pytest.mark.parametrize("device", ["/dev/zero", "/dev/null"])
def test_a_device_is_no_configuration(monkeypatch: pytest.MonkeyPatch, device: str) -> None:
    """One of them would fill the memory."""
    monkeypatch.setenv("SBGC_CONFIG", device)
    result = run("info", "-g", "front")
    assert result.status == 1 and f"{device} is not a regular file" in result.error


def test_a_capture_without_its_first_header(tmp_path: Path) -> None:
    """A full disk can leave a part of it, to which nothing can be appended."""
    victim = Capture(tmp_path / "f")
    for size in (1, 7, 8, 23):
        victim.file.write_bytes(victim.source.read_bytes()[:size])
        victim.end()
    victim.file.write_bytes(b"\x89SBX")
    assert run(*victim.command()).status == 1
    assert victim.file.read_bytes() == b"\x89SBX"


def test_a_link_of_a_killed_bridge_is_replaced(gimbal: EmulatedGimbal, tmp_path: Path) -> None:
    victim = Bridge(tmp_path / "f", gimbal)
    for name in ("gimbal", "gimbal.sbgc-new"):
        victim.link.with_name(name).symlink_to("/dev/pts/999999")
    victim.check(0)
