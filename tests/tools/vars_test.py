"""Tests of sbgc vars with an emulated board."""

from __future__ import annotations

import json
from collections.abc import Iterator

import pytest

from emulated_gimbal import emulated_gimbal
from sbgc_command import MODEL, Result, run

VARIABLES = {variable["name"]: variable for variable in MODEL["adjustable_variables"]}


@pytest.fixture(name="board", scope="module")
def fixture_board() -> Iterator[str]:
    with emulated_gimbal("--firmware", "2.70") as gimbal:
        yield gimbal.address


def adjust(board: str, *arguments: str) -> Result:
    return run("vars", *arguments, "-p", board)


def value(board: str, name: str) -> float:
    document = json.loads(adjust(board, "get", name, "--format", "json").text)
    return document["variables"][0]["value"]


def test_list(board: str) -> None:
    text = adjust(board, "list").text
    names = [line.split()[0] for line in text.splitlines()]
    assert set(names) <= set(VARIABLES) and len(names) > 60
    assert any(
        line.split() == ["LPF_FREQ_ROLL", "120", "Hz", "10", "to", "400", "Hz"]
        for line in text.splitlines()
    )
    document = json.loads(adjust(board, "list", "--format", "json").text)
    assert (document["format"], document["version"]) == ("sbgc-variables", 1)
    listed = document["variables"]
    assert [one["name"] for one in listed] == names
    for one in listed:
        assert one["unit"] == VARIABLES[one["name"]]["unit"]


def test_get_set_save(board: str) -> None:
    result = adjust(board, "set", "lpf_freq_roll=30Hz", "P_ROLL=21", "--yes")
    assert result.status == 0
    assert result.text == "LPF_FREQ_ROLL: 120 Hz -> 30 Hz\nP_ROLL: 12 -> 21\n"
    assert value(board, "LPF_FREQ_ROLL") == 30
    assert adjust(board, "set", "P_ROLL=21").text == "nothing to change\n"
    saved = adjust(board, "set", "P_ROLL=22", "--save", "--yes")
    assert saved.status == 0 and "saved" in saved.error
    assert "axes.roll.p = 22" in run("params", "get", "roll.p", "-p", board).text


@pytest.mark.parametrize(
    "text, words",
    [
        ("LPF_FREQ_ROLL=3000", ["3000", "400 Hz"]),
        ("LPF_FREQ_ROLL=30V", ["'V'", "Hz"]),
        ("LPF_FREQ_ROL=30", ["'LPF_FREQ_ROLL'"]),
        ("LPF_FREQ_ROLL", ["NAME=VALUE"]),
        ("P_ROLL=x", ["'x'"]),
        ("LPF_FREQ_ROLL=50.5Hz", ["50.5Hz", "1 Hz apart"]),
    ],
)
def test_mistakes(board: str, text: str, words: list[str]) -> None:
    before = value(board, "LPF_FREQ_ROLL")
    result = adjust(board, "set", text, "--yes")
    assert result.status == 2
    for word in words:
        assert word in result.error
    assert value(board, "LPF_FREQ_ROLL") == before


@pytest.mark.parametrize(
    "text, words",
    [
        ("LPF_FREQ_ROLL=+10%", "LPF_FREQ_ROLL: 50 Hz -> 55 Hz\n"),
        ("LPF_FREQ_ROLL-=20Hz", "LPF_FREQ_ROLL: 50 Hz -> 30 Hz\n"),
        ("LPF_FREQ_ROLL=-90%", "LPF_FREQ_ROLL: 5 Hz does not fit: 10 Hz"),
        ("LPF_FREQ_ROLL+=5V", "LPF_FREQ_ROLL: 'V' is not its unit"),
    ],
)
def test_changes(board: str, text: str, words: str) -> None:
    assert adjust(board, "set", "LPF_FREQ_ROLL=50", "--yes").status == 0
    result = adjust(board, "set", text)
    assert result.status in (1, 2) and words in result.text + result.error


def test_unarmed(board: str) -> None:
    result = adjust(board, "set", "P_YAW=33")
    assert result.status == 1 and "add --yes" in result.error
    assert value(board, "P_YAW") != 33
