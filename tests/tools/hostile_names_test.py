"""Tests that the names of ports, gimbals and files do not control the terminal."""

from __future__ import annotations

import os
import re
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from emulated_gimbal import emulated_gimbal
from sbgc_command import PROGRAM

NAME = b"x\x1b[31m\a\xc2\x9b31m\xe2\x80\xae\xff"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """A folder with a gimbal, a backup and its changed copy, whose names begin with NAME."""
    path = tmp_path_factory.mktemp("hostile")
    with emulated_gimbal("--link", f"{path}/gimbal"):
        os.rename(path / "gimbal", bytes(path) + b"/" + NAME)
        yield path


def run_in(folder: Path, *words: bytes | str) -> subprocess.CompletedProcess[bytes]:
    return subprocess.run([PROGRAM, *words], cwd=folder, capture_output=True, check=False)


def check(done: subprocess.CompletedProcess[bytes], status: int = 0) -> None:
    assert done.returncode == status, done
    assert b"x?[31m??31m??" in done.stdout + done.stderr, done
    for text in (done.stdout.decode(), done.stderr.decode()):
        assert not re.search(r"[\0-\x09\x0b-\x1f\x7f-\x9f\u2028-\u202e]", text), text


def test_names_of_ports(folder: Path) -> None:
    port = b"serial:" + bytes(folder) + b"/" + NAME + b"?baud=115200"
    check(run_in(folder, "info", "-p", port))
    check(run_in(folder, "record", "-p", port, "out", "--for", "0.1s"))
    check(run_in(folder, "info", "-p", port.replace(b"?", b"2?"), "--timeout", "0.1s"), 1)


def test_names_of_files(folder: Path) -> None:
    port = b"serial:" + bytes(folder) + b"/" + NAME + b"?baud=115200"
    for name in (NAME + b".json", NAME + b"2.json"):
        check(run_in(folder, "params", "backup", "-p", port, name))
        assert run_in(folder, "params", "set", "-p", port, "-y", "pitch.p=7").returncode == 0
    check(run_in(folder, "params", "diff", NAME + b".json", NAME + b"2.json"), 1)
    check(run_in(folder, "params", "diff", "-p", port, NAME + b".json"), 1)
    check(run_in(folder, "params", "restore", "-p", port, NAME + b".json", "-y"))
    check(run_in(folder, "params", "restore", "-p", port, NAME + b".json"))
    check(run_in(folder, "eeprom", "read", "-p", port, NAME + b".bin"))
    check(run_in(folder, "decode", NAME + b".bin2"), 1)


def test_names_of_gimbals(folder: Path) -> None:
    with emulated_gimbal() as gimbal:
        file = folder / "config.toml"
        characters = NAME.decode(errors="ignore") + "\u202e"
        name = "".join(f"\\u{ord(one):04x}" for one in characters)
        file.write_text(f"[gimbal.\"{name}\"]\nport='{gimbal.address}'\n")
        done = subprocess.run(
            [PROGRAM, "info", "-g", "none"], env={"SBGC_CONFIG": str(file)}, capture_output=True
        )
        check(done, 2)
