"""Commands that are killed or get system errors, and the checks of the state afterwards.

faults.cpp, which is preloaded, dies or fails at a chosen call. Each class runs one command with such a
fault (`attempt`) and then checks that nothing is torn, and that the next run works (`check`).
"""

from __future__ import annotations

import json
import os
import re
import signal
import socket
import subprocess
from pathlib import Path
from typing import Any, Optional

from captures import CAPTURE
from emulated_gimbal import EmulatedGimbal
from emulator import CONFIRM, ERROR, READ_EXTERNAL_DATA, WRITE_EXTERNAL_DATA, Connection, Emulator
from sbgc_command import CRASH, PROGRAM, run

LIBRARY = os.environ["SBGC_FAULTS"]
KILLED = -signal.SIGKILL
TEMPORARY = re.compile(r".+\.[0-9]+-[0-9]+\.sbgc-tmp")
PATIENCE = 60


def with_fault(fault: str, place: str | Path) -> dict[str, str]:
    """The environment of a program with a fault at paths that begin with `place`."""
    return {
        **os.environ,
        "LD_PRELOAD": LIBRARY,
        "SBGC_FAULT": fault,
        "SBGC_FAULT_AT": str(place),
    }


class Victim:
    """A command that is killed or gets errors, again and again, in a folder of its own."""

    def __init__(self, folder: Path) -> None:
        folder.mkdir()
        self.folder = folder
        self.error = ""  # what the last attempt said

    def attempt(self, fault: str) -> int:
        """Runs the command with a fault, and returns its status."""
        raise NotImplementedError

    def check(self, status: int) -> None:
        """Asserts that nothing is torn, whatever the status of the attempt was."""
        raise NotImplementedError

    def end(self) -> None:
        """Asserts that a run without fault leaves nothing but its file."""

    def run(self, fault: str, place: str | Path, *arguments: str) -> int:
        done = subprocess.run(
            [PROGRAM, *arguments],
            env=with_fault(fault, place),
            capture_output=True,
            timeout=PATIENCE,
            check=False,
        )
        self.error = done.stderr.decode()
        assert not CRASH.search(self.error), self.error
        assert done.returncode in (0, 1, KILLED), (done.returncode, self.error)
        return done.returncode

    def strangers(self, *known: str) -> list[str]:
        """The files besides the known ones. There is at most one temporary file: they do not accumulate."""
        names = [path.name for path in self.folder.iterdir() if path.name not in known]
        assert len([name for name in names if TEMPORARY.fullmatch(name)]) <= 1, names
        return [name for name in names if not TEMPORARY.fullmatch(name)]


class Backup(Victim):
    """A backup, which replaces an old file or not."""

    OLD = "the old file\n"

    def __init__(self, folder: Path, gimbal: EmulatedGimbal, replaces: bool) -> None:
        super().__init__(folder)
        self.file = folder / "b.json"
        self.options = ["--force"] if replaces else []
        self.command = ["params", "backup", str(self.file), "-p", gimbal.address]
        self.replaces = replaces
        assert run(*self.command).status == 0
        self.right = self.content()

    def content(self) -> dict[str, Any]:
        content: dict[str, Any] = json.loads(self.file.read_text(encoding="utf-8"))
        return {**content, "created": ""}

    def attempt(self, fault: str) -> int:
        self.file.unlink(missing_ok=True)
        if self.replaces:
            self.file.write_text(self.OLD, encoding="utf-8")
        return self.run(fault, self.folder, *self.command, *self.options)

    def check(self, status: int) -> None:
        assert not self.strangers(self.file.name)
        if status == 1:
            assert not self.strangers_of_a_failure(), self.error
        is_old = self.file.read_text(encoding="utf-8") == self.OLD if self.file.exists() else True
        if is_old:
            assert status != 0
            assert self.file.exists() == self.replaces
        else:
            assert self.content() == self.right

    def strangers_of_a_failure(self) -> list[str]:
        """A program that is not killed removes its temporary file."""
        return [path.name for path in self.folder.iterdir() if path != self.file]

    def end(self) -> None:
        assert run(*self.command, "--force").status == 0
        assert list(self.folder.iterdir()) == [self.file]
        assert self.content() == self.right


class Capture(Victim):
    """A capture, to which every attempt appends."""

    def __init__(self, folder: Path) -> None:
        super().__init__(folder)
        self.file = folder / "capture"
        self.source = folder.parent / f"{folder.name}-source"
        self.source.write_bytes(CAPTURE)
        self.before: list[Any] = []

    def command(self) -> list[str]:
        return ["record", f"capture:{self.source}", str(self.file)]

    def frames(self) -> list[Any]:
        """The frames of the file. What damage there is shows on standard error."""
        if not self.file.exists():
            return []
        done = run("decode", "--format", "jsonl", str(self.file))
        assert done.status in (0, 1), done
        frames = [line for line in done.objects if "message" in line]
        return [(line["message"], line.get("fields")) for line in frames]

    def attempt(self, fault: str) -> int:
        if self.file.exists() and self.file.stat().st_size > 20_000:
            self.file.unlink()
        self.before = self.frames()
        return self.run(fault, self.folder, *self.command())

    def check(self, status: int) -> None:
        assert not self.strangers(self.file.name)
        now = self.frames()
        assert now[: len(self.before)] == self.before
        if status == 0:
            assert len(now) > len(self.before)

    def end(self) -> None:
        self.before = self.frames()
        assert run(*self.command()).status == 0
        self.check(0)


class ClientCapture(Capture):
    """The capture of a command that talks to a board."""

    def __init__(self, folder: Path, gimbal: EmulatedGimbal) -> None:
        super().__init__(folder)
        self.address = gimbal.address

    def command(self) -> list[str]:
        return ["info", "-p", self.address, "--capture", str(self.file)]


class State(Victim):
    """The memory of an emulated board."""

    def __init__(self, folder: Path) -> None:
        super().__init__(folder)
        self.file = folder / "state"
        self.options = ["--tcp", "0", "--state", str(self.file)]
        self.number = 0
        self.confirmed = b"\xff" * 128
        self.sent = self.confirmed

    def attempt(self, fault: str) -> int:
        self.number += 1
        self.sent = self.number.to_bytes(2, "little") * 64
        process = subprocess.Popen(
            [PROGRAM, "emulate", *self.options],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            env=with_fault(fault, self.folder),
        )
        assert process.stdout is not None
        line = process.stdout.readline().decode()
        if line:
            self.converse(line.split(": ", 1)[1].strip())
            if process.poll() is None:
                process.send_signal(signal.SIGTERM)
        self.error = process.communicate(timeout=PATIENCE)[1].decode()
        assert not CRASH.search(self.error), self.error
        assert process.returncode in (0, 1, KILLED), (process.returncode, self.error)
        return process.returncode

    def converse(self, place: str) -> None:
        """Changes the memory. A board that dies confirms nothing."""
        try:
            host = Connection(place)
        except ConnectionError:
            return
        try:
            host.send(WRITE_EXTERNAL_DATA, self.sent)
            while not any(bytes([0x3E, id]) in host.heard for id in (CONFIRM, ERROR)):
                if not host.receive(PATIENCE):
                    return
            if bytes([0x3E, CONFIRM]) in host.heard:
                self.confirmed = self.sent
        except ConnectionError:
            pass
        finally:
            host.close()

    def check(self, status: int) -> None:
        assert not self.strangers("state", "state.sbgc-lock")
        with Emulator(*self.options) as board:
            host = Connection(board.places[0])
            now = host.ask(READ_EXTERNAL_DATA)
            host.close()
        assert now in (self.confirmed, self.sent)
        self.confirmed = now
        assert list(self.folder.iterdir()) == [self.file]


class Bridge(Victim):
    """A bridge with a link and a port, which the next one needs."""

    def __init__(self, folder: Path, gimbal: EmulatedGimbal, at_traffic: bool = False) -> None:
        super().__init__(folder)
        self.link = folder / "gimbal"
        with socket.create_server(("127.0.0.1", 0)) as free:
            self.address = f"tcp:127.0.0.1:{free.getsockname()[1]}"
        places = ["--link", str(self.link), "--tcp", self.address.rsplit(":", 1)[1]]
        self.command = ["bridge", gimbal.address, *places]
        self.place: str | Path = "socket:" if at_traffic else folder

    def start(self, fault: str) -> Optional[subprocess.Popen[bytes]]:
        """Starts a bridge; None if it ends before its places are open."""
        self.forget_terminal()
        process = subprocess.Popen(
            [PROGRAM, *self.command],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            env=with_fault(fault, self.place) if fault else None,
        )
        assert process.stdout is not None
        lines = [process.stdout.readline() for _ in range(2)]
        if all(lines):
            return process
        self.error = process.communicate(timeout=PATIENCE)[1].decode()
        self.status = process.returncode
        assert not CRASH.search(self.error), self.error
        return None

    def forget_terminal(self) -> None:
        """Points the links of a killed bridge to a terminal that never exists: another program may get
        the number of the old one, even while the next bridge starts, which would then refuse the link.
        """
        for link in (self.link, self.link.with_name("gimbal.sbgc-new")):
            if link.is_symlink():
                link.unlink()
                link.symlink_to("/dev/pts/999999")

    def attempt(self, fault: str) -> int:
        process = self.start(fault)
        if process is None:
            return self.status
        run("info", "-p", self.address, "--timeout", "2")
        if process.poll() is None:
            process.send_signal(signal.SIGINT)
        self.error = process.communicate(timeout=PATIENCE)[1].decode()
        assert not CRASH.search(self.error), self.error
        return process.returncode

    def check(self, status: int) -> None:
        assert status in (0, 1, KILLED), (status, self.error)
        process = self.start("")
        assert process is not None, self.error
        for address in (self.address, str(self.link)):
            assert run("info", "-p", address).status == 0
        assert list(self.folder.iterdir()) == [self.link]
        process.kill()  # so that the next one finds its link
        process.communicate()

    def end(self) -> None:
        self.link.unlink(missing_ok=True)


class Restore(Victim):
    """A board whose parameters are restored: each set of them is the old or the new one."""

    def __init__(self, folder: Path, gimbal: EmulatedGimbal) -> None:
        super().__init__(folder)
        self.address = gimbal.address
        self.new_file, self.old_file = (
            folder / "new.json",
            folder.parent / f"{folder.name}-old.json",
        )
        assert run("params", "backup", str(self.old_file), "-p", self.address).status == 0
        document = json.loads(self.old_file.read_text(encoding="utf-8"))
        for one in document["settings"]:
            if one["message"] == "ReadParams3":
                body = bytearray.fromhex(one["body"])
                body[1] = 77  # axes.roll.p
                one.update(body=body.hex(), fields={})
        self.new_file.write_text(json.dumps(document), encoding="utf-8")
        self.old, self.new = self.sets(self.old_file), self.sets(self.new_file)

    @staticmethod
    def sets(file: Path) -> dict[tuple[str, int], str]:
        settings = json.loads(file.read_text(encoding="utf-8"))["settings"]
        return {(one["message"], one["copy"]): one["body"] for one in settings}

    def attempt(self, fault: str) -> int:
        return self.run(
            fault, "socket:", "params", "restore", str(self.new_file), "--yes", "-p", self.address
        )

    def check(self, status: int) -> None:
        now_file = self.folder.parent / f"{self.folder.name}-now.json"
        assert run("params", "backup", "--force", str(now_file), "-p", self.address).status == 0
        now = self.sets(now_file)
        for name, body in now.items():
            assert body in (self.old[name], self.new[name]), name
        safety = self.strangers(self.new_file.name)
        if now != self.old:
            (name,) = safety
            assert self.sets(self.folder / name) == self.old
        for name in safety:
            (self.folder / name).unlink()
        back = run("params", "restore", str(self.old_file), "--yes", "-p", self.address)
        assert back.status == 0, back
        for path in self.folder.parent.glob(f"{self.folder.name}-old.before-restore-*"):
            path.unlink()
