"""EEPROM, files and scripts with the sbgc command."""

from __future__ import annotations

import json
import os
import re
import zlib
from collections.abc import Iterator
from pathlib import Path

import pytest
from board_command import Watched, answer_on_terminal
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from sbgc_command import Result, run

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


def test_ctrl_c_during_a_transfer(tmp_path: Path) -> None:
    with emulated_gimbal("--baud", "9600", "--tcp", "0") as gimbal:
        reading = Watched("eeprom", "read", str(tmp_path / "part"), "-p", gimbal.address)
        reading.wait_for("CMD_EEPROM_READ")
        assert reading.interrupt().status == 130
    assert list(tmp_path.iterdir()) == [], "neither the file nor a part of it"


def test_the_board_vanishes_in_the_middle(tmp_path: Path) -> None:
    with emulated_gimbal("--baud", "9600", "--tcp", "0") as gimbal:
        reading = Watched("eeprom", "read", str(tmp_path / "part"), "-p", gimbal.address)
        reading.wait_for("CMD_EEPROM_READ")
        gimbal.kill()
        ended = reading.end()
    assert ended.status == 1 and "sbgc: " in ended.error
    assert list(tmp_path.iterdir()) == []


def test_files_that_cannot_be_read(tmp_path: Path) -> None:
    (tmp_path / "empty").touch()
    for name, words in (("empty", "is empty"), ("missing", "missing")):
        result = run("files", "put", "1", str(tmp_path / name), "--yes", "-p", "tcp:127.0.0.1:1")
        assert result.status == 1 and words in result.error
