"""EEPROM, files and scripts with the sbgc command."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import zlib
from collections.abc import Iterator
from pathlib import Path

import pytest
from board_command import answer_on_terminal
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from sbgc_command import PROGRAM, Result, run

SIZE = 32768
"""The size of the EEPROM of the emulated board."""


@pytest.fixture(name="gimbal", scope="module")
def one_gimbal() -> Iterator[EmulatedGimbal]:
    with emulated_gimbal("--board", "3.6", "--firmware", "2.70b0") as gimbal:
        yield gimbal


def sbgc(gimbal: EmulatedGimbal, *arguments: str | Path) -> Result:
    return run(*(str(word) for word in arguments), "-p", gimbal.address)


def test_the_eeprom_is_read_and_written(gimbal: EmulatedGimbal, tmp_path: Path) -> None:
    before, data, after = tmp_path / "before", tmp_path / "data", tmp_path / "after"
    assert sbgc(gimbal, "eeprom", "read", before, "--raw").status == 0
    assert before.stat().st_size == SIZE
    data.write_bytes(os.urandom(150))
    # Neither the start nor the end is that of a page.
    write = ("eeprom", "write", data, "--address", "20001", "--yes")
    assert "does not say of which board" in sbgc(gimbal, *write).error
    written = sbgc(gimbal, *write, "--raw")
    assert written.status == 0 and "150 bytes written and read back" in written.error
    assert sbgc(gimbal, "eeprom", "read", after, "--raw").status == 0
    expected = bytearray(before.read_bytes())
    expected[20001:20151] = data.read_bytes()
    assert after.read_bytes() == expected


def test_an_image_says_what_it_is(gimbal: EmulatedGimbal, tmp_path: Path) -> None:
    image, raw = tmp_path / "image", tmp_path / "raw"
    part = ("--address", "4096", "--size", "300")
    assert sbgc(gimbal, "eeprom", "read", image, *part).status == 0
    assert sbgc(gimbal, "eeprom", "read", raw, "--raw", *part).status == 0
    line, _, data = image.read_bytes().partition(b"\n")
    facts = json.loads(line)
    assert data == raw.read_bytes()
    before = line.partition(b',"crc32"')[0]
    assert facts["crc32"] == f"{zlib.crc32(before + data):08x}"
    del facts["crc32"]
    serial = facts.pop("serial_number")
    expected = {"format": "sbgc-eeprom", "version": 1, "model": "3.6", "firmware": "2.70"}
    assert facts == expected | {"frw_extra_id": 0, "address": 4096, "size": 300}
    written = sbgc(gimbal, "eeprom", "write", image, "--yes")
    assert written.status == 0 and "300 bytes" in written.error, written
    for wrong in (("--raw",), ("--address", "4096")):
        assert sbgc(gimbal, "eeprom", "write", image, "--yes", *wrong).status == 2
    image.write_bytes(line + b"\n" + data[:-7])
    assert "changed, or is incomplete" in sbgc(gimbal, "eeprom", "write", image, "--yes").error
    image.write_bytes(line + b"\n" + data)
    head = before.replace(json.dumps(serial).encode(), b'"00ff"')
    other_sum = f',"crc32":"{zlib.crc32(head + data):08x}"}}'.encode()
    image.write_bytes(head + other_sum + b"\n" + data)
    with emulated_gimbal("--board", "3.0", "--firmware", "2.66") as other:
        options: tuple[str, ...] = ()
        for option in ("--other-model", "--other-firmware"):
            result = sbgc(other, "eeprom", "write", image, "--yes", *options)
            assert result.status == 1 and option in result.error, result
            options += (option,)
        for file, allowed, said in (
            (image, options, "of another board, with the serial number 00ff"),
            (raw, ("--raw",), "Nothing is known of these bytes"),
        ):
            asked = answer_on_terminal(
                "n", "eeprom", "write", str(file), *allowed, "-p", other.address
            )
            assert said in " ".join(asked.error.split()), asked


def test_progress_on_a_terminal(gimbal: EmulatedGimbal, tmp_path: Path) -> None:
    data = tmp_path / "data"
    data.write_bytes(bytes(640))
    written = answer_on_terminal("y", "eeprom", "write", str(data), "--raw", "-p", gimbal.address)
    assert written.status == 0, written
    bars = re.findall(r"\r\x1b\[K\[(#*)( *)\] (\d+)/640 bytes", written.error)
    assert len(bars) > 3
    for full, empty, done in bars:
        assert (len(full), len(full + empty)) == (int(done) * 30 // 640, 30)
    assert int(bars[-1][2]) == 640


def test_a_part_of_the_eeprom(gimbal: EmulatedGimbal, tmp_path: Path) -> None:
    part = tmp_path / "part"
    result = sbgc(gimbal, "eeprom", "read", part, "--raw", "--address", "100", "--size", "7")
    assert result.status == 0 and part.stat().st_size == 7
    late = sbgc(gimbal, "eeprom", "read", tmp_path / "no", "--address", str(SIZE))
    assert late.status == 1 and "ends before address" in late.error
    long = sbgc(gimbal, "eeprom", "read", tmp_path / "no", "--size", str(SIZE + 1))
    assert long.status == 1 and "exceed the EEPROM" in long.error
    assert not (tmp_path / "no").exists()


def test_nothing_is_overwritten_without_force(gimbal: EmulatedGimbal, tmp_path: Path) -> None:
    kept = tmp_path / "kept"
    kept.write_text("my thesis")
    sbgc(gimbal, "files", "put", "3", kept, "--yes")
    for command in (("eeprom", "read"), ("files", "get", "3")):
        result = sbgc(gimbal, *command, kept)
        assert result.status == 1 and "--force replaces it" in result.error
        assert kept.read_text() == "my thesis"
    assert sbgc(gimbal, "eeprom", "read", kept, "--size", "5", "--force", "--raw").status == 0
    assert kept.stat().st_size == 5


def test_files_come_and_go(gimbal: EmulatedGimbal, tmp_path: Path) -> None:
    sent, got = tmp_path / "sent", tmp_path / "got"
    sent.write_bytes(os.urandom(1000))
    put = sbgc(gimbal, "files", "put", "7", sent, "--yes")
    assert put.status == 0 and "1000 bytes written and read back" in put.error
    assert "    7  1000 bytes\n" in sbgc(gimbal, "files", "list", "--last", "9").text
    assert sbgc(gimbal, "files", "list", "--first", "8", "--last", "9").text == ""
    get = sbgc(gimbal, "files", "get", "7", got)
    assert get.status == 0 and f"1000 bytes written to {got}\n" in get.error
    assert got.read_bytes() == sent.read_bytes()
    assert sbgc(gimbal, "files", "delete", "7", "--yes").status == 0
    missing = sbgc(gimbal, "files", "get", "7", tmp_path / "none")
    assert missing.status == 1 and "No file has this id" in missing.error
    assert not (tmp_path / "none").exists()


def test_scripts(gimbal: EmulatedGimbal, tmp_path: Path) -> None:
    script = tmp_path / "script"
    script.write_text("wait 1\n" * 10)
    assert sbgc(gimbal, "files", "put", "1", script, "--yes").status == 0
    started = sbgc(gimbal, "script", "start", "2", "--yes")
    assert started.status == 0 and "It can do whatever a command can do" in started.error
    stopped = sbgc(gimbal, "script", "stop", "2")
    assert stopped.status == 0 and "the script in slot 2 has stopped" in stopped.error
    assert "what it set in motion goes on until `sbgc stop`" in stopped.error
    assert len(sbgc(gimbal, "script", "list").text.splitlines()) == 5
    assert sbgc(gimbal, "script", "start", "0", "--yes").status == 2


def test_ctrl_c_during_a_transfer(tmp_path: Path) -> None:
    with emulated_gimbal("--baud", "9600", "--tcp", "0") as gimbal:
        target = tmp_path / "part"
        with subprocess.Popen(
            [PROGRAM, "eeprom", "read", str(target), "-v", "-p", gimbal.address],
            stderr=subprocess.PIPE,
        ) as process:
            assert process.stderr is not None
            for line in process.stderr:  # the frames are printed
                if b"CMD_EEPROM_READ" in line:
                    break
            process.send_signal(signal.SIGINT)
            process.stderr.read()
            assert process.wait(30) == 130
        assert list(tmp_path.iterdir()) == [], "neither the file nor a part of it"


def test_the_board_vanishes_in_the_middle(tmp_path: Path) -> None:
    with emulated_gimbal("--baud", "9600", "--tcp", "0") as gimbal:
        with subprocess.Popen(
            [PROGRAM, "eeprom", "read", str(tmp_path / "part"), "-v", "-p", gimbal.address],
            stderr=subprocess.PIPE,
        ) as process:
            assert process.stderr is not None
            for line in process.stderr:
                if b"CMD_EEPROM_READ" in line:
                    break
            gimbal.kill()
            error = process.stderr.read().decode()
            assert process.wait(30) == 1
    assert "sbgc: " in error
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    "arguments",
    [
        ("eeprom", "write", "{data}", "--raw"),
        ("files", "put", "1", "{data}"),
        ("files", "delete", "1"),
        ("files", "delete", "--all"),
        ("script", "start", "1"),
    ],
)
def test_nothing_is_written_unarmed(
    gimbal: EmulatedGimbal, arguments: tuple[str, ...], tmp_path: Path
) -> None:
    (tmp_path / "data").write_text("x")
    for file in ("0", "1"):  # the first is the script in slot 1
        assert sbgc(gimbal, "files", "put", file, tmp_path / "data", "--yes").status == 0
    files = sbgc(gimbal, "files", "list").text
    (tmp_path / "data").write_text("changed")
    words = [word.format(data=tmp_path / "data") for word in arguments]
    result = sbgc(gimbal, *words)
    assert result.status == 1 and "add --yes" in result.error
    assert sbgc(gimbal, "files", "list").text == files


def test_files_that_cannot_be_read(tmp_path: Path) -> None:
    (tmp_path / "empty").touch()
    for name, words in (("empty", "is empty"), ("missing", "missing")):
        result = run("files", "put", "1", str(tmp_path / name), "--yes", "-p", "tcp:127.0.0.1:1")
        assert result.status == 1 and words in result.error
