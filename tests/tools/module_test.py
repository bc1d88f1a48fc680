"""sbgc module: modules of an emulated board, and their firmware."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import pytest
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from sbgc_command import run


@pytest.fixture(name="gimbal", scope="module")
def one_gimbal() -> Iterator[EmulatedGimbal]:
    with emulated_gimbal("--board", "3.6", "--firmware", "2.74.5") as gimbal:
        yield gimbal


def test_the_list(gimbal: EmulatedGimbal) -> None:
    rows = [line.split() for line in run("module", "list", "-p", gimbal.address).text.splitlines()]
    assert rows[0] == ["module", "board", "bootloader", "firmware"]
    assert rows[1] == ["IMU_MAIN", "1.00", "1.00", "1.20"]
    found = json.loads(run("module", "list", "--format", "json", "-p", gimbal.address).out)
    assert len(found["modules"]) == len(rows) - 1


def test_firmware(gimbal: EmulatedGimbal, tmp_path: Path) -> None:
    file = tmp_path / "driver.bin"
    file.write_bytes(bytes(range(256)) * 5)
    flash = ("module", "flash", str(file), "--module", "can_drv1", "-p", gimbal.address)
    asked = run(*flash)
    text = " ".join(asked.error.split())
    assert asked.status == 1 and "add --yes" in text
    assert "CAN_DRV1, which has firmware 1.42, restarts, is erased and gets 1280 bytes" in text
    assert "full battery" in text
    done = run(*flash, "--yes")
    assert done.status == 0 and "The firmware of CAN_DRV1 is loaded." in done.error


def test_what_cannot_be_loaded(gimbal: EmulatedGimbal, tmp_path: Path) -> None:
    file = tmp_path / "driver.bin"
    file.write_bytes(b"abcde")
    flash = ("module", "flash", str(file), "--yes", "-p", gimbal.address, "--module")
    odd = run(*flash, "CAN_DRV1")
    assert odd.status == 1 and "5 bytes, not a multiple of 4" in odd.error
    file.write_bytes(b"abcd")
    unknown = run(*flash, "CAN_DRV9")
    text = " ".join(unknown.error.split())
    assert unknown.status == 1 and "the board has no module 'CAN_DRV9'; did you mean" in text
    file.write_bytes(b"")
    assert run(*flash, "CAN_DRV1").status == 1


def test_a_line_that_may_repeat_packets_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "driver.bin"
    file.write_bytes(bytes(256))
    with emulated_gimbal("--board", "3.6", "--firmware", "2.70b0", "--udp", "0") as gimbal:
        flash = ("module", "flash", str(file), "--module", "can_drv1", "--yes", "-v")
        result = run(*flash, "-p", gimbal.address)
    text = " ".join(result.error.split())
    assert result.status == 1 and "CMD_MODULE" not in text
    assert "no firmware is loaded over UDP to" in text and "may repeat packets" in text


def test_a_board_without_modules() -> None:
    with emulated_gimbal("--firmware", "2.60b4") as gimbal:
        result = run("module", "list", "-p", gimbal.address)
        assert (result.status, result.text) == (0, "")
        assert "no modules" in result.error
