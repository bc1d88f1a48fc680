"""Tests that no text of a board, and no name of a port, a gimbal or a file controls the terminal, whatever the
output, and that JSON keeps it."""

from __future__ import annotations

import csv
import io
import os
import re
import subprocess
import sys
import unicodedata
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

import pytest

from emulated_gimbal import emulated_gimbal
from sbgc_command import PROGRAM, Result, frame, run

DIRECTIONS = {"LRE", "RLE", "LRO", "RLO", "PDF", "LRI", "RLI", "FSI", "PDI"}
MARKS = {"\u061c", "\u200e", "\u200f"}
"""They change the direction of text, too, but have the class of letters."""

HOSTILE = {
    c
    for c in map(chr, range(sys.maxunicode + 1))
    if unicodedata.category(c) in ("Cc", "Zl", "Zp")
    or unicodedata.bidirectional(c) in DIRECTIONS
    or c in MARKS | {"\ufffe", "\uffff"}
}
"""Characters that a terminal obeys instead of showing, according to Unicode, or that XML forbids."""

STRAY = [bytes([byte]) for byte in range(0x80, 0x100)]
"""Bytes that are not UTF-8; terminals of 8 bits obey the first 32 of them."""

NEIGHBORS = "~\u00a0\u061b\u061d\u200d\u2010\u2027\u202f\u2065\u206a\u00e4\u05d0\U0001f3a5"
"""Characters that stay as they are, many of them next to hostile ones."""

READ_PROFILE_NAMES, NAMES, NAME_SIZE = 28, 5, 48


def frame_with(*texts: bytes) -> bytes:
    names = [text.ljust(NAME_SIZE, b"\0") for text in texts]
    return frame(READ_PROFILE_NAMES, b"".join(names).ljust(NAMES * NAME_SIZE, b"\0"))


def frames_with_everything() -> Iterator[bytes]:
    """No text ends with NUL, which would end it before."""
    texts = [b"<" + c.encode() + b"31m>" for c in sorted(HOSTILE)]
    texts += [b"<" + byte + b"31m>" for byte in STRAY]
    for at in range(0, len(texts), NAMES):
        yield frame_with(*texts[at : at + NAMES])


EVERYTHING = b"".join(frames_with_everything())


def decode(data: bytes, *options: str) -> Result:
    result = run("decode", "--raw", "--from", "board", *options, stdin=data)
    assert result.status == 0, result
    return result


def assert_harmless(output: bytes) -> None:
    text = output.decode(errors="surrogateescape")
    stray = {byte.decode(errors="surrogateescape") for byte in STRAY[:32]}
    found = (HOSTILE | stray) & set(text) - {"\n"}
    assert not found, found


def cell(text: bytes) -> str:
    """Returns the cell of the first profile name in CSV."""
    table = decode(frame_with(text), "--format", "csv").out
    _, line = csv.reader(io.StringIO(table.decode()))
    return line[1]


@pytest.mark.parametrize("options", [["text"], ["csv"], ["jsonl"], ["jsonl", "--real"]])
def test_decoded(options: list[str]) -> None:
    assert_harmless(decode(EVERYTHING, "--format", *options).out)


def test_json_keeps_every_byte() -> None:
    lines = decode(EVERYTHING, "--format", "jsonl").out
    assert run("encode", stdin=lines).out == EVERYTHING


def test_csv_shows_what_it_escapes() -> None:
    assert cell(b"\x1b[31m\x7f") == r"\x1b[31m\x7f"
    assert cell("\u009b31m\u202e".encode()) == r"\u009b31m\u202e"
    assert cell(b"\x9b31m\xe9") == "\uf79b31m\uf7e9", "as in JSON"
    assert cell(b'"\x9b, ') == '"\uf79b, '


def test_other_characters_stay() -> None:
    for name in (NEIGHBORS, 'a "quoted", name'):
        data = frame_with(name.encode())
        assert cell(name.encode()) == name
        quoted = name.replace('"', r"\"")
        for form in ("text", "jsonl"):
            assert f'"{quoted}"' in decode(data, "--format", form).text


def test_of_a_board(tmp_path: Path) -> None:
    name = "\u009b31m\u202e\x1b\x7f\u2028"
    with emulated_gimbal() as gimbal:
        at = ("-p", gimbal.address)
        backup = tmp_path / "backup"
        for command in (
            ["params", "rename", "1", name, "--yes"],
            ["params", "rename", "1", name + "2", "--yes"],
            ["params", "profiles"],
            ["params", "profiles", "--format", "json"],
            ["send", "CMD_READ_PROFILE_NAMES", "--verbose"],
            ["send", "CMD_READ_PROFILE_NAMES", "--format", "jsonl"],
            ["params", "backup", str(backup)],
        ):
            result = run(*command, *at)
            assert result.status == 0, result
            assert_harmless(result.out)
            assert_harmless(result.error.encode())
        assert_harmless(backup.read_bytes())


# Every command that takes a file, with each of its forms of output, meets files with hostile names and contents.

PIECES = [c.encode() for c in sorted(HOSTILE - {"\0"})] + STRAY + [b"\xed\xa0\x80", b"<&>\"'"]
HEADS = [b"".join(PIECES[at::8]) for at in range(8)]
CONTENTS = {
    "table": b"time,"
    + b",".join(re.sub(rb"[\r\n\"]", b"", head) for head in HEADS[:7])
    + b"\n0"
    + b",1" * 7
    + b"\n1"
    + b",2" * 7
    + b"\n",
    "bode": b"%sbgc_test_data;70;0;1;3000;6;200\n" + b"1;2\n2;1\n3;5\n4;2\n" * 500,
    "capture": EVERYTHING,
    "json": b'{"format": "' + re.sub(rb'[\0-\x1f"\\\\]', b"", b"".join(PIECES)) + b'"}',
}


def help_of(path: tuple[str, ...]) -> str:
    return run(*path, "--help").text


def leaves(path: tuple[str, ...] = ()) -> Iterator[tuple[str, ...]]:
    """All commands that do something, as the help names them."""
    text = help_of(path)
    if "] COMMAND\n" not in text:
        yield path
        return
    for name in re.findall(r"^  ([a-z]+)  ", text, re.MULTILINE):
        yield from leaves((*path, name))


def forms(text: str, picture: bytes) -> list[list[bytes]]:
    """The ways of output that a help offers."""
    formats = re.search(r"^  --format ([a-z|]+)", text, re.MULTILINE)
    found = [[b"--format", name.encode()] for name in formats[1].split("|")] if formats else [[]]
    found += [[flag.encode()] for flag in ("--table", "--ascii", "--real") if f"  {flag} " in text]
    return found + ([[b"--svg", picture]] if "  --svg FILE" in text else [])


def assert_readable(output: bytes) -> None:
    if b"\0" not in output:  # no frames or captures
        assert_harmless(output)
        output.decode()


def test_every_writer_of_foreign_text(tmp_path: Path) -> None:
    folder = os.fsencode(tmp_path)
    pictures = 0
    with emulated_gimbal() as gimbal:
        for path in leaves():
            text = help_of(path)
            slots = [[b"%s"]] if re.search(r"^  \[?FILE", text, re.MULTILINE) else []
            for option in re.findall(r"^  (?:-\w,)?(--[a-z-]+) FILE", text, re.MULTILINE):
                if option != "--svg":
                    slots += [[option.encode(), b"%s"], [option.encode(), b"%s"] * 2]
            port = [b"-p", gimbal.address.encode()] if "-p ADDRESS" in text else []
            runs = [
                (slot, form, content)
                for slot in slots
                for form in forms(text, folder + b"/picture.svg")
                for content in CONTENTS.values()
            ]
            for number, (slot, form, content) in enumerate(runs):
                names = [
                    folder + b"/" + head.replace(b"/", b"") for head in HEADS[number % 8 :][:2]
                ]
                names = (names * 2)[:2]
                for name in names:
                    Path(os.fsdecode(name)).write_bytes(content)
                words = [names.pop() if word == b"%s" else word for word in slot]
                try:
                    done = subprocess.run(
                        [PROGRAM, *path, *words, *form, *port],
                        stdin=subprocess.DEVNULL,
                        capture_output=True,
                        timeout=5,
                        check=False,
                    )
                except subprocess.TimeoutExpired as over:
                    assert_readable((over.stdout or b"") + (over.stderr or b""))
                    break  # it serves
                assert_readable(done.stdout)
                assert_readable(done.stderr)
                picture = tmp_path / "picture.svg"
                if picture.exists():
                    pictures += 1
                    assert_readable(picture.read_bytes())
                    ElementTree.fromstring(picture.read_bytes())
                    picture.unlink()
    assert pictures >= 3


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
