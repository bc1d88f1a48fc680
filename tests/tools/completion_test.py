"""Tests of names that a shell would obey: completed and entered, they are arguments only."""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from interactive_shell import START, Shell, interactive_shell
from sbgc_command import PROGRAM

# Whatever runs one of them makes the file P.
NAMES = [
    *("x$(touch${IFS}P)", "x`touch P`", "x;touch P;", "x\\;touch P;", "x&&touch P|touch P&"),
    *("x<(touch P)>P", "x=$(touch P):~root=~", "x';touch P;'", 'x";touch P;"', "x  two  spaces "),
    *("x'", 'x"', "x\\", "x\\'\\\"$", "x$HOME${HOME}", "x!!!sbgc", "x!", "x*?[a-z]{a,b}", "x~"),
    *("x@y#^%(P)[", "x\u00e4\u00f6 \u20ac", "$(touch P)", "`touch P`", ";touch P", "~root", "=ls"),
    *("#x", "-x", "!!", " x", "'", '"', "\\", "*", "{a,b}", "\u00e4", "%1", "&"),
]  # fmt: skip


@pytest.fixture(scope="module", params=START)
def shell(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Shell]:
    with interactive_shell(request.param, tmp_path_factory.mktemp(request.param)) as result:
        yield result


def write_ports(folder: Path, *ports: dict[str, str]) -> None:
    lists = {"format": "sbgc-ports", "version": 1, "ports": ports}
    (folder / "ports.json").write_text(json.dumps(lists))


def typed(first: str) -> list[str]:
    """Returns the ways to type the first character of a name."""
    if first.isalnum():
        return [first, f"'{first}", f'"{first}', f"'{first}'", f"''{first}"]
    return [f"\\{first}", *([] if first in "'\\" else [f"'{first}"])]


@pytest.mark.parametrize("name", NAMES)
def test_a_completed_name_is_one_argument(shell: Shell, name: str) -> None:
    write_ports(shell.folder, {"name": name})
    for way in typed(name[0]):
        arguments = shell.press(f"sbgc info -p {way}\t")
        assert arguments == ["info", "-p", name], (way, shell.shown)
        assert not (shell.folder / "P").exists()


def test_a_common_beginning_of_names_is_completed(shell: Shell) -> None:
    write_ports(shell.folder, {"name": "x$(touch P)'a b"}, {"name": "x$(touch P)'a c"})
    for way in ["x", "'x", '"x']:
        keys = {"'": "c'", '"': 'c"'}.get(way[0], "c")
        arguments = shell.press(f"sbgc info -p {way}\t{keys}")
        assert arguments == ["info", "-p", "x$(touch P)'a c"], shell.shown
    assert not (shell.folder / "P").exists()


@pytest.mark.parametrize(
    "name", ["x$(touch${IFS}P)", "x`touch P`", "x; touch P", "x'y\"z", "x\\y", "x!!", "x*{a,b}"]
)
def test_a_completed_file_is_one_argument(shell: Shell, name: str) -> None:
    (shell.folder / name).touch()
    # zsh itself does not close a quote that the name of a file contains.
    ways = [way for way in ["x", "'x", '"x'] if way[0] == "x" or way[0] not in name]
    got = [shell.press(f"sbgc decode {way}\t") for way in ways]
    (shell.folder / name).unlink()
    assert got == [["decode", name]] * len(ways), shell.shown
    assert not (shell.folder / "P").exists()


def completed(*words: str, **environment: str) -> list[bytes]:
    done = subprocess.run(
        [PROGRAM, "__complete", "--", *words],
        env={**os.environ, **environment},
        capture_output=True,
        check=True,
    )
    return done.stdout.splitlines()


def test_control_characters_and_other_bytes_are_not_offered(tmp_path: Path) -> None:
    others = ["\n", "\t", "\r", "\0", "\x1b[31m", "\x7f", "\x9b", "\x85"]
    write_ports(
        tmp_path,
        *({"name": f"x{other}y"} for other in others),
        *({"name": f"z{i}", "description": f"a{other}b"} for i, other in enumerate(others)),
    )
    lines = completed("info", "-p", "", SBGC_PORTS=str(tmp_path / "ports.json"))
    assert [line for line in lines if line.startswith((b"x", b"z"))] == [
        b"z0\ta",
        *(f"z{i}\ta?{'[31m' if i == 4 else ''}b".encode() for i in range(1, len(others))),
    ]
    file = tmp_path / "config.toml"
    file.write_text(
        '[gimbal."x\\u001bz"]\nport="a"\n[gimbal."x\\u009b"]\nport="a"\n'
        '[gimbal."x$(touch P)"]\nport="\\u001b[31m\\u009b"\n'
    )
    assert completed("info", "-g", "", SBGC_CONFIG=str(file)) == [b"x$(touch P)\t?[31m?"]
    assert completed("stream", "RealtimeData4", "--fields", "\x1b[31m,") == []
