"""Commands refuse before they ask what cannot succeed, and ask for what they name."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from board_command import answer_on_terminal
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from sbgc_command import MODEL, run


@pytest.fixture(name="gimbal", scope="module")
def one_gimbal() -> Iterator[EmulatedGimbal]:
    with emulated_gimbal("--firmware", "2.72", "--board", "3.6") as gimbal:
        yield gimbal


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
