"""Tests of the state that a board keeps in a file."""

from __future__ import annotations

import fcntl
import os
from pathlib import Path

from emulator import (
    BOARD_INFO,
    BOARD_INFO_3,
    CONFIRM,
    ERROR,
    READ_EXTERNAL_DATA,
    WRITE_EXTERNAL_DATA,
    Connection,
    Emulator,
    Line,
    Terminal,
    refused,
    terminal_of,
)


def board_of(state: Path, *options: str) -> Emulator:
    where = () if "--pty" in options else ("--tcp", "0")
    return Emulator(*where, "--state", str(state), *options)


def write(line: Line, data: bytes) -> None:
    """Writes, and waits until it is confirmed."""
    line.ask(WRITE_EXTERNAL_DATA, data, answer=CONFIRM)


def test_state_survives(tmp_path: Path) -> None:
    state = tmp_path / "state"
    data = bytes(range(128))
    with board_of(state) as emulator:
        host = emulator.host()
        serial = host.ask(BOARD_INFO_3)[:21]
        write(host, data)
        emulator.process.kill()
        emulator.wait()
    with board_of(state) as emulator:
        host = emulator.host()
        assert host.ask(READ_EXTERNAL_DATA) == data
        assert host.ask(BOARD_INFO_3)[:21] == serial
        # Changes just before the exit are saved, too.
        write(host, data[::-1])
        assert emulator.end() == 0
    with board_of(state) as emulator:
        host = emulator.host()
        assert host.ask(READ_EXTERNAL_DATA) == data[::-1]
    assert list(tmp_path.iterdir()) == [state]
    assert "firmware 2.59, not of" in refused("--state", str(state), "--firmware", "2.43b9")


def test_what_is_confirmed_is_on_the_disk(tmp_path: Path) -> None:
    state = tmp_path / "state"
    before = b"\xff" * 128
    for number in range(30):
        data = bytes([number]) * 128
        options = ["--pty"] if number % 2 == 0 else []
        with board_of(state, *options) as emulator:
            place = emulator.places[0]
            line: Line = Terminal(str(terminal_of(place))) if options else Connection(place)
            assert line.ask(READ_EXTERNAL_DATA) == before
            for value in (before[::-1], before, data):
                line.send(WRITE_EXTERNAL_DATA, value)
            for _ in range(3):
                line.body(CONFIRM)
            # It may be in the middle of saving this.
            line.send(WRITE_EXTERNAL_DATA, data)
            emulator.process.kill()
            emulator.wait()
            line.close()
        before = data
    with board_of(state):
        assert {path.name for path in tmp_path.iterdir()} == {"state", "state.sbgc-lock"}
    assert list(tmp_path.iterdir()) == [state]


def test_what_a_killed_one_leaves_is_removed(tmp_path: Path) -> None:
    state = tmp_path / "state"
    left = [tmp_path / "state.17-0.sbgc-tmp"]
    left += [tmp_path / f"backup.json.{os.getpid()}-23.sbgc-tmp"]
    names = """state.17-0.sbgc-tmp.bak state.17-x.sbgc-tmp state.17-.sbgc-tmp state.sbgc-tmp
        state.-3.sbgc-tmp state-2.sbgc-tmp state.17-0.tmp state.18-0.sbgc-tmp"""
    others = [tmp_path / name for name in names.split()]
    for file in left + others:
        file.write_text("half of it")
    (tmp_path / "state.19-0.sbgc-tmp").symlink_to("state.17-0.tmp")
    (tmp_path / "state.20-0.sbgc-tmp").mkdir()
    others += [tmp_path / "state.19-0.sbgc-tmp", tmp_path / "state.20-0.sbgc-tmp"]
    with open(tmp_path / "state.18-0.sbgc-tmp") as at_work:
        fcntl.flock(at_work, fcntl.LOCK_EX)
        with board_of(state):
            pass
    assert sorted(tmp_path.iterdir()) == sorted([state, *others])


def test_a_state_is_of_one_emulator_at_a_time(tmp_path: Path) -> None:
    state = tmp_path / "state"
    link = tmp_path / "link"
    link.symlink_to("state")
    with board_of(link):
        assert link.is_symlink() and state.is_file()
        for name in (state, link):
            assert f"{name} is in use by another emulator" in refused("--state", str(name))
    with board_of(state):
        pass
    assert sorted(tmp_path.iterdir()) == [link, state]


def test_a_file_that_has_the_name_of_the_lock_is_left_alone(tmp_path: Path) -> None:
    state = tmp_path / "state"
    lock = tmp_path / "state.sbgc-lock"
    lock.write_text("mine")
    assert f"{lock} is not a lock" in refused("--state", str(state))
    assert lock.read_text() == "mine"
    lock.unlink()
    lock.symlink_to("elsewhere")
    assert str(lock) in refused("--state", str(state))
    assert list(tmp_path.iterdir()) == [lock]
    lock.unlink()
    lock.touch()  # left behind by an emulator that was killed
    with board_of(state):
        lock.unlink()
        lock.write_text("mine")  # replaced meanwhile
    assert lock.read_text() == "mine"


def test_a_state_keeps_its_mode(tmp_path: Path) -> None:
    state = tmp_path / "state"
    for mode in (0o644, 0o600, 0o660):
        with board_of(state):
            state.chmod(mode)
        with board_of(state):  # which is written immediately
            pass
        assert state.stat().st_mode & 0o7777 == mode


def test_a_state_that_cannot_be_used(tmp_path: Path) -> None:
    damaged = tmp_path / "damaged"
    damaged.write_text("{}")
    assert str(damaged) in refused("--state", str(damaged))
    assert damaged.read_text() == "{}"
    refused("--state", str(tmp_path))
    refused("--state", str(tmp_path / "missing" / "state"))


def test_a_state_that_cannot_be_saved_any_more(tmp_path: Path) -> None:
    folder = tmp_path / "folder"
    folder.mkdir()
    with board_of(folder / "state") as emulator:
        folder.rename(tmp_path / "elsewhere")
        host = emulator.host()
        host.send(WRITE_EXTERNAL_DATA, bytes(range(128)))
        assert host.body(ERROR)[0] == WRITE_EXTERNAL_DATA
        assert emulator.process.stderr is not None
        assert b"cannot write" in emulator.process.stderr.readline()
        assert host.ask(BOARD_INFO)
        assert emulator.end() == 1
        assert emulator.error.count("cannot write") == 1  # it is retried at the end
        assert "not everything could be saved" in emulator.error


def test_board_and_firmware(tmp_path: Path) -> None:
    state = tmp_path / "state"
    # The state identifies its board. Options that are given must match it; others may be omitted.
    for model in ("--firmware 2.43b9 --board 3.1", "", "--firmware 2.43b9", "--board 3.1"):
        with board_of(state, *model.split()) as emulator:
            info = emulator.host().ask(BOARD_INFO)
            assert info[0] == 31 and int.from_bytes(info[1:3], "little") == 2439
    for model in ("--firmware 2.59", "--board 3.0", "--firmware 2.59 --board 3.1"):
        assert "firmware 2.43b9, not of" in refused("--state", str(state), *model.split())
