"""Tests of sbgc describe, against the exported model."""

from __future__ import annotations

import os
import re

import pytest

from sbgc_command import MODEL, run


def described(word: str) -> str:
    result = run("describe", word)
    assert result.status == 0, result
    return result.text


def words_of(text: str) -> str:
    return " ".join(text.split())


def entries(page: str, name: str) -> list[str]:
    """The texts in the column after the name of a fact of a message."""
    return [
        line.split(maxsplit=1)[1] for line in page.splitlines() if line.startswith(f"  {name} ")
    ]


@pytest.mark.parametrize(
    "chunk", [MODEL["messages"][start::8] for start in range(8)], ids=lambda chunk: chunk[0]["name"]
)
def test_every_message_has_its_facts(chunk: list[dict]) -> None:
    for message in chunk:
        page = described(message["name"])
        text = words_of(page)
        assert message["command"] in text and f"id {message['id']}" in text
        assert words_of(message["summary"]) in text
        assert words_of(message["description"] or "") in text
        for name in (message["response"] or {"messages": []})["messages"]:
            assert name in text
        for leaf in message["layout"]:
            assert words_of(leaf["summary"]) in text, leaf["path"]
        until, deprecated = message["until"], message["deprecated"]
        assert entries(page, "until") == ([f"firmware {until['firmware']}"] if until else [])
        assert entries(page, "deprecated") == (
            [f"use {deprecated['replaced_by']}"] if deprecated else []
        )
        is_general = any(leaf.get("role") == "general" for leaf in message["layout"])
        assert ("general: the same in all profiles" in text) == is_general


def test_all_parameters_of_a_profile_are_not_general() -> None:
    text = words_of(described("ReadParams3"))
    (general,) = [
        [leaf for leaf in message["layout"] if leaf.get("role") == "general"]
        for message in MODEL["messages"]
        if message["name"] == "ReadParams3"
    ]
    assert text.count("general: the same in all profiles") == len(general)


def test_fields_and_variables_say_which_way_they_count() -> None:
    """They agree with the exported model."""
    assert "positive" not in described("follow_speed")
    for variable in MODEL["adjustable_variables"]:
        page = words_of(described(variable["name"]))
        assert ("positive:" in page) == ("positive" in variable), page
        if "positive" in variable:
            assert f"positive: {variable['positive'] or 'unknown'}" in page


def test_topics_have_their_parameters() -> None:
    for topic in MODEL["topics"]:
        text = words_of(described(topic["name"].upper()))
        assert f"topic of parameters {topic['summary']}" in text
        for message in MODEL["messages"]:
            for leaf in message["layout"]:
                if topic["name"] in leaf.get("topics", []):
                    assert leaf["summary"] in text, leaf
    assert described("tuning") == described("pid")
    assert "Control.axes.roll.speed" in described("speed"), "a field as well"


def test_a_long_list_of_uses_is_cut() -> None:
    lines = described("MenuCommand").splitlines()
    uses = lines[lines.index("Used in") + 1 :]
    assert len(uses) == 13 and uses[0] == "  ReadParams3.rc_cmd_low"
    assert re.fullmatch(r"  and \d+ more", uses[-1])


def test_a_text_is_below_a_name_that_is_too_long_or_in_a_narrow_terminal(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    text = described("MenuCommand")
    assert "\n  MENU_CMD_SERVO_MODE_TOGGLE  81: Turn the servo mode" in text
    assert "\n  MENU_CMD_HOME_POSITION_SHORTEST\n" + 30 * " " in text
    monkeypatch.setenv("COLUMNS", "40")
    narrow = described("MenuCommand")
    assert "\n  MENU_CMD_SERVO_MODE_TOGGLE\n    81: Turn the servo mode on or off.\n" in narrow
    assert all(len(line) <= 40 for line in narrow.splitlines())


def test_everything_by_family() -> None:
    text = run("describe").text
    for command in MODEL["commands"]:
        assert f"  {command['name']} " in text or f"  {command['name']}\n" in text


@pytest.mark.parametrize("width", [60, 80, 120])
def test_lines_wrap_at_the_width(width: int) -> None:
    text = run("describe", "CMD_READ_PARAMS_3", env={**os.environ, "COLUMNS": str(width)}).text
    long = [line for line in text.splitlines() if len(line) > width and " " in line.strip()]
    assert not long
    assert "\x1b" not in text, "no colors without a terminal"
