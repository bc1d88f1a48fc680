"""A terminal closes under each command that writes or moves: what must be finished is finished."""

from __future__ import annotations

import ctypes
import json
import os
import pty
import re
import select
import signal
import socket
import subprocess
import tempfile
import threading
import time
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from board_command import Watched
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from gimbal_observer import observer_of
from module_kills_test import frames_in
from relay import relay_to
from sbgc_command import MODEL, PROGRAM, run

PATIENCE = 40.0
ANY = {0, 130, -signal.SIGHUP, -signal.SIGTERM, 128 + signal.SIGHUP, 128 + signal.SIGTERM}
DONE = {0, 130}


# The line is so slow that a command does not end before the terminal does.
SLOW = ("--delay", "0.001:100")


@dataclass(frozen=True)
class Case:
    arguments: str
    ends: set[int]
    stands: bool = False  # the camera, before the command has ended
    keeps: bool = False  # the parameters are those from before
    firmware: str = "2.70b0"
    options: tuple[str, ...] = ()  # of the emulated gimbal


CASES = {
    "move": Case("--yaw 300 --speed 20 --wait", {130}, stands=True),
    "speed": Case("--yaw 20 --for 100s", {130}, stands=True),
    "jog": Case("", {130}, stands=True),
    "bode": Case("yaw --gain 1000 --from 6 --to 200 --table", {130}, stands=True),
    "tune": Case("pitch", {130}, stands=True, keeps=True),
    "params diff": Case("--defaults", {130}, keeps=True, options=SLOW),
    "params restore": Case("{folder}/backup --save-to {folder}/saved", DONE),
    "params reset": Case("--profile 2 --save-to {folder}/saved", DONE),
    "params set": Case("gyro_trust=12", DONE),
    "vars set": Case("P_PITCH=+10% --save", DONE),
    "eeprom write": Case("{folder}/image", DONE),
    "files put": Case("1 {folder}/bytes", DONE),
    "module flash": Case("{folder}/bytes --module CAN_DRV1", DONE, firmware="2.74.5"),
    # They send one request, and the board does the rest.
    "motors": Case("on", ANY),
    "menu": Case("home_position", ANY),
    "calibrate": Case("gyro --no-check", ANY),
    "reset": Case("", ANY),
    "send": Case("CMD_MOTORS_ON", ANY),
    "files delete": Case("--all", ANY),
    "script start": Case("1", ANY),
    "script stop": Case("1", ANY),
    "params rename": Case("1 studio", ANY),
    "stop": Case("", ANY, stands=True),
}
ASKS_NOTHING = {"stop", "script stop"}


def changing_commands() -> set[int]:
    """The commands no form of which only reads or sets, by the effects of the model."""
    effects: dict[int, set[str]] = {}
    for message in MODEL["messages"]:
        if message["direction"] == "to_board":
            effects.setdefault(message["id"], set()).update(message["effect"]["does"])
    return {
        command
        for command, does in effects.items()
        if "reads" not in does and does & {"moves", "stores", "erases", "restarts"}
    }


CHANGING = changing_commands()


def test_all_commands_that_ask_are_here(tmp_path: Path) -> None:
    assert run("manual", "--folder", str(tmp_path)).status == 0
    asking = set()
    for page in tmp_path.glob("sbgc-*.1"):
        command = page.stem.removeprefix("sbgc-")
        for line in page.read_text(encoding="utf-8").splitlines():
            if line.startswith(".SS sbgc "):
                command = line.removeprefix(".SS sbgc ").replace("\\-", "-")
            if r"\-\-yes\fR" in line:
                asking.add(command)
    assert asking == set(CASES) - ASKS_NOTHING


@pytest.fixture(name="orphans", scope="module")
def orphans_come_here() -> Iterator[None]:
    """The commands, whose parents die, become children of this process."""
    set_child_subreaper = 36
    assert ctypes.CDLL(None).prctl(set_child_subreaper, 1, 0, 0, 0) == 0
    yield
    ctypes.CDLL(None).prctl(set_child_subreaper, 0, 0, 0, 0)


class Terminal:
    """A small shell that runs a command in a terminal."""

    def __init__(self, *arguments: str) -> None:
        with tempfile.NamedTemporaryFile("r") as process:
            own = f'echo $$ >{process.name}; exec "$@"'
            self.shell, self.screen = pty.fork()
            if self.shell == 0:
                words = ["sh", "-c", '"$@"; exit $?', "sh", "sh", "-c", own, "sh", PROGRAM]
                os.execv("/bin/sh", [*words, *arguments])
            deadline = time.monotonic() + PATIENCE
            while not (line := process.read()).endswith("\n"):
                assert time.monotonic() < deadline
                process.seek(0)
                time.sleep(0.01)
        self.command = int(line)

    def await_text(self, text: bytes) -> None:
        shown = b""
        while text not in shown:
            shown += os.read(self.screen, 4096)

    def read_until(self, event: threading.Event, keys: bytes = b"") -> None:
        deadline = time.monotonic() + PATIENCE
        shown = b""
        while not event.wait(0.02):
            assert time.monotonic() < deadline, shown
            if select.select([self.screen], [], [], 0)[0]:
                try:
                    shown += os.read(self.screen, 4096)
                except OSError:
                    raise AssertionError(f"the command has ended: {shown!r}") from None
            if keys:
                os.write(self.screen, keys)

    def close(self) -> int:
        """Closes it as window managers and shells do, and returns how the command ends."""
        os.close(self.screen)
        for number in (signal.SIGHUP, signal.SIGHUP, signal.SIGTERM, signal.SIGHUP):
            with suppress(ProcessLookupError):
                os.kill(self.command, number)
            time.sleep(0.01)
        status = os.waitpid(self.shell, 0)[1]
        if os.WIFEXITED(status):
            return os.WEXITSTATUS(status)  # that of the command, which has ended before
        deadline = time.monotonic() + PATIENCE
        while True:
            try:
                process, status = os.waitpid(self.command, os.WNOHANG)
            except ChildProcessError:
                return 0  # it was the child of the shell until its end
            if process != 0:
                return os.waitstatus_to_exitcode(status)
            assert time.monotonic() < deadline, "the command does not end"
            time.sleep(0.02)


def parameters(gimbal: EmulatedGimbal, file: Path) -> Any:
    saved = run("params", "backup", str(file), "--force", "-p", gimbal.address)
    assert saved.status == 0, saved
    return {**json.loads(file.read_text()), "created": "", "checksum": ""}


def prepare(name: str, gimbal: EmulatedGimbal, folder: Path) -> None:
    def done(*command: str) -> None:
        result = run(*command, "-p", gimbal.address)
        assert result.status == 0, result

    (folder / "bytes").write_bytes(bytes(2048))
    if name == "eeprom write":
        done("eeprom", "read", str(folder / "image"), "--size", "2048")
    if name == "script start":
        (folder / "script").write_text("wait 1\n")
        done("files", "put", "0", str(folder / "script"), "--yes")
    if name.startswith("params"):
        done("params", "backup", str(folder / "backup"))
        done("params", "set", "gyro_trust=11", "--yes")


class Changes(threading.Event):
    """Set as soon as a frame with such an effect is on the line."""

    def look(self, data: bytes) -> bytes:
        if any(command in CHANGING for command, _ in frames_in(data)):
            self.set()
        return data


@pytest.mark.parametrize("name", CASES)
def test_the_terminal_closes(
    name: str, tmp_path: Path, orphans: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    case = CASES[name]
    monkeypatch.chdir(tmp_path)
    changes = Changes()
    board = ("--board", "3.6", "--firmware", case.firmware, *case.options)
    with emulated_gimbal(*board) as gimbal, relay_to(gimbal.address, changes.look) as address:
        prepare(name, gimbal, tmp_path)
        before = parameters(gimbal, tmp_path / "before") if case.keeps else None
        words = [*name.split(), *case.arguments.format(folder=tmp_path).split()]
        agreed = () if name in ASKS_NOTHING else ("--yes",)
        terminal = Terminal(*words, *agreed, "-p", address)
        terminal.read_until(changes, b"d" if name == "jog" else b"")
        assert terminal.close() in case.ends
        if case.stands:
            with observer_of(gimbal) as observer:
                assert not observer.is_turning()
        if case.keeps:
            assert parameters(gimbal, tmp_path / "after") == before


def test_the_terminal_of_the_shell_closes(
    tmp_path: Path, orphans: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its command goes on as long as it must, because the line is that of the shell."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    changes = Changes()
    with emulated_gimbal() as gimbal, relay_to(gimbal.address, changes.look) as address:
        before = parameters(gimbal, tmp_path / "before")
        terminal = Terminal("shell", "-p", address)
        terminal.await_text(b"sbgc> ")
        os.write(terminal.screen, b"params diff --defaults --yes\n")
        terminal.read_until(changes)
        assert terminal.close() == 130
        assert parameters(gimbal, tmp_path / "after") == before


def test_a_second_ctrl_c_says_what_is_not_restored(tmp_path: Path) -> None:
    with emulated_gimbal("--delay", "1:40") as gimbal:
        comparing = Watched(
            "params", "diff", "--defaults", "--yes", "-p", gimbal.address, cwd=tmp_path
        )
        comparing.wait_for("CMD_USE_DEFAULTS")
        for _ in range(2):
            comparing.process.send_signal(signal.SIGINT)
            time.sleep(0.6)
        ended = comparing.end()
    assert ended.status == 130
    text = " ".join(ended.error.split())
    assert re.search(r"these parameters are not restored: ReadParams\w+ .*; restore", text), text


def ignore_hangup() -> None:
    signal.signal(signal.SIGHUP, signal.SIG_IGN)


@pytest.mark.parametrize(
    "what",
    ["bridge {board} --tcp 0", "record {board} c", "stream -p {board}", "emulate --tcp 0"],
)
def test_nohup_goes_on(what: str, tmp_path: Path) -> None:
    with emulated_gimbal() as gimbal:
        words = [PROGRAM, *what.format(board=gimbal.address).split()]
        with subprocess.Popen(
            words, cwd=tmp_path, stdout=subprocess.PIPE, preexec_fn=ignore_hangup
        ) as process:
            assert process.stdout is not None and process.stdout.readline()
            process.send_signal(signal.SIGHUP)
            with pytest.raises(subprocess.TimeoutExpired):
                process.communicate(timeout=0.5)
            process.terminate()
            process.communicate()
            assert process.returncode == 0


@pytest.fixture(name="flood", scope="module")
def address_of_a_flood() -> Iterator[str]:
    """Sends bytes without being asked."""
    with socket.create_server(("127.0.0.1", 0)) as server:

        def serve() -> None:
            with suppress(OSError):
                while True:
                    host, _ = server.accept()
                    with suppress(OSError):
                        while True:
                            host.sendall(bytes(4096))

        threading.Thread(target=serve, daemon=True).start()
        yield f"tcp:127.0.0.1:{server.getsockname()[1]}"
        server.shutdown(socket.SHUT_RDWR)


def fill(writer: int) -> None:
    own = os.open(f"/proc/self/fd/{writer}", os.O_WRONLY | os.O_NONBLOCK)
    for size in (4096, 1):
        with suppress(BlockingIOError):
            while True:
                os.write(own, b"\n" * size)
    os.close(own)


@pytest.mark.parametrize("end", ["--for", "a signal"])
@pytest.mark.parametrize(
    "what",
    [
        "stream --rate 200 -p {board}",
        "record --stream RealtimeData3 --rate 200 - -p {board}",
        "record {flood} -",
    ],
)
def test_a_reader_that_has_stopped(what: str, end: str, flood: str) -> None:
    reader, writer = os.pipe()
    with emulated_gimbal() as gimbal:
        words = what.format(board=gimbal.address, flood=flood).split()
        words += ["--for", "2s"] if end == "--for" else []
        with subprocess.Popen([PROGRAM, *words], stdout=writer, stderr=subprocess.PIPE) as process:
            size = 0
            while size < 5000:  # not the connecting any more
                size += len(os.read(reader, 4096))
            fill(writer)
            time.sleep(1)  # so that it has more to write
            if end == "a signal":
                process.terminate()
            _, error = process.communicate(timeout=PATIENCE)
    os.close(reader)
    os.close(writer)
    text = " ".join(error.decode().split())
    assert process.returncode == 1, text
    assert "nobody reads the output" in text or "reader has stopped reading" in text
