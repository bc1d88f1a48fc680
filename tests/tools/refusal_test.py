"""Commands refuse before they ask what cannot succeed, and ask for what they name."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from board_command import answer_on_terminal
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from sbgc_command import MODEL, Result, run


@pytest.fixture(name="gimbal", scope="module")
def one_gimbal() -> Iterator[EmulatedGimbal]:
    with emulated_gimbal("--firmware", "2.72", "--board", "3.6") as gimbal:
        yield gimbal


@pytest.fixture(name="old_gimbal", scope="module")
def board_1() -> Iterator[EmulatedGimbal]:
    with emulated_gimbal("--firmware", "2.43b9", "--board", "1.0") as gimbal:
        yield gimbal


def assert_refused(result: Result, reason: str) -> None:
    """The reason is all that it says: not what would happen, and no question."""
    assert result.status == 1 and result.out == b"", result
    assert result.error.startswith("sbgc: ") and reason in result.error, result


@pytest.mark.parametrize(
    "command, reason",
    [
        ("script start 9", "there is no script in slot 9"),
        ("script start 200", "there is no script in slot 200"),
        ("move --yaw 5", "the motors are off"),
        ("move --yaw 5 --wait", "the motors are off"),
        ("speed --yaw 5 --for 1s", "the motors are off"),
        ("files delete 77", "file 77: No file has this id"),
        ("eeprom write --raw --address 999999 FILE", "the EEPROM ends before address 999999"),
        (
            "eeprom write --raw --address 32767 FILE",
            "2 bytes do not fit: the EEPROM has 1 from address",
        ),
    ],
)
def test_what_this_board_cannot_do(
    gimbal: EmulatedGimbal, tmp_path: Path, command: str, reason: str
) -> None:
    assert run("motors", "off", "--yes", "-p", gimbal.address).status == 0
    (tmp_path / "file").write_bytes(b"ab")
    words = command.replace("FILE", str(tmp_path / "file")).split()
    assert_refused(run(*words, "-p", gimbal.address), reason)


@pytest.mark.parametrize(
    "command, lacking",
    [
        ("script start 1", "CMD_RUN_SCRIPT"),
        ("send CMD_BEEP_SOUND", "CMD_BEEP_SOUND"),
        ("calibrate mag", "CMD_CALIB_MAG"),
        ("eeprom write --raw FILE", "CMD_EEPROM_WRITE"),
        ("files put 1 FILE", "CMD_WRITE_FILE"),
        ("files delete 1", "CMD_READ_FILE"),
        ("files delete --all", "CMD_FS_CLEAR_ALL"),
        ("params rename 1 x", "CMD_READ_PROFILE_NAMES"),
        ("vars set LPF_FREQ_ROLL=30Hz", "CMD_GET_ADJ_VARS_VAL"),
    ],
)
def test_what_an_old_board_lacks(
    old_gimbal: EmulatedGimbal, tmp_path: Path, command: str, lacking: str
) -> None:
    (tmp_path / "file").write_bytes(b"ab")
    words = command.replace("FILE", str(tmp_path / "file")).split()
    result = run(*words, "-p", old_gimbal.address)
    assert_refused(result, f"{lacking} needs ")
    assert "this is board 1.0" in result.error or "the board has 2.43b9" in result.error


def test_without_a_board_nothing_is_asked() -> None:
    for command in ("motors on", "reset", "calibrate gyro", "send CMD_MOTORS_ON"):
        assert_refused(run(*command.split(), "-p", "tcp:127.0.0.1:1"), "refused the connection")


def test_what_can_succeed_is_asked(gimbal: EmulatedGimbal, tmp_path: Path) -> None:
    script = tmp_path / "script"
    script.write_text("wait 1\n")
    assert run("files", "put", "8", str(script), "--yes", "-p", gimbal.address).status == 0
    result = run("script", "start", "9", "-p", gimbal.address)
    assert result.status == 1
    assert "The board runs the script in slot 9" in " ".join(result.error.split())
    assert "not confirmed" in result.error


@pytest.mark.parametrize("answer", ["y", "Y", "yes", "YES", "Yes"])
def test_yes_in_any_case(gimbal: EmulatedGimbal, answer: str) -> None:
    assert answer_on_terminal(answer, "motors", "OFF", "-p", gimbal.address).status == 0


def about_profiles() -> list[str]:
    return [
        message["name"]
        for message in MODEL["messages"]
        if message["direction"] == "to_board"
        and "stores" in message["effect"]["does"]
        and any(field["path"] == "profile_id" for field in message["layout"])
    ]


@pytest.mark.parametrize("message", about_profiles())
def test_a_profile_is_named_as_people_count(gimbal: EmulatedGimbal, message: str) -> None:
    def asked(*values: str) -> str:
        command = ("send", message, *values, "--no-validate", "-p", gimbal.address)
        return " ".join(run(*command).error.split())

    assert "with profile_id = 1 (profile 2)" in asked("profile_id=1")
    assert asked("profile_id=1").count("profile_id") == 1
    assert "with profile_id = 4 (profile 5)" in asked("PROFILE_ID=raw:4")
    assert "(profile 1)" in asked() or "(profile 5)" in asked(), "a default is named, too"


def test_a_profile_without_a_number_is_named_by_its_meaning(gimbal: EmulatedGimbal) -> None:
    for number, meaning in (("253", "erases the EEPROM"), ("254", "resets the active profile")):
        result = run("send", "CMD_USE_DEFAULTS", f"profile_id={number}", "-p", gimbal.address)
        assert f"profile_id = {number} ({meaning})" in " ".join(result.error.split())
