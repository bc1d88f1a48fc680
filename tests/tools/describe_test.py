"""Tests of sbgc describe, against the exported model."""

from __future__ import annotations

import os
import re
import subprocess

import pytest

from sbgc_command import MODEL, PROGRAM, run


def described(word: str) -> str:
    result = run("describe", word)
    assert result.status == 0, result
    return result.text


def words_of(text: str) -> str:
    return " ".join(text.split())


def entries(page: str, name: str) -> list[str]:
    """What is in the column after the name of a fact of a message."""
    return [
        line.split(maxsplit=1)[1] for line in page.splitlines() if line.startswith(f"  {name} ")
    ]


def test_a_command_with_all_its_messages() -> None:
    text = described("CMD_CONTROL")
    assert text.startswith("CMD_CONTROL  id 67, control\n")
    for words in (
        "Control to the board, 13 bytes",
        "ControlExt to the board, 15 bytes",
        "axes.roll|pitch|yaw.speed",
        "MODE_ANGLE 2",
        "0.122074 deg/s each",
        "at 1, 5, 9",
        "since firmware 2.55b5",
        "moves.",
    ):
        assert words in words_of(text), words
    assert described("cmd_control") == text
    assert described("Control") != text, "this is the name of one message"
    assert text in described("67"), "and two commands share the id"


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


def test_a_field_has_its_name_in_the_specification_too() -> None:
    text = described("DataStreamInterval")
    assert "config.telemetry_flags (FLAGS)" in text
    assert "config.drv_id (" not in text


def test_facts_stand_under_their_heading() -> None:
    text = described("MotorsOff")
    assert text.endswith("\n  response    a confirmation within 500 ms; may be repeated\n")
    assert "\n  until       firmware 2.69b5\n" in described("AhrsHelperRequest")


def test_pages_of_types_variables_and_fields() -> None:
    assert described("RcMode") == (
        "RcMode  several values in one number\n"
        "  How an RC signal controls an axis.\n"
        "\n"
        "  mode (bits 0 to 2): RC_MODE_ANGLE 0, RC_MODE_SPEED 1\n"
        "  inverted (bit 3)\n"
        "\n"
        "Used in\n"
        "  ReadParams3.rc.roll|pitch|yaw.rc_mode\n"
        "  WriteParams3.rc.roll|pitch|yaw.rc_mode\n"
        "  ReadParamsAnswer.rc.roll|pitch|yaw.rc_mode\n"
        "  WriteParams.rc.roll|pitch|yaw.rc_mode\n"
    )
    assert described("ControlModeKind").startswith(
        "ControlModeKind  enum\n"
        "  Meaning of SPEED and ANGLE in a control command.\n"
        "\n"
        "  MODE_NO_CONTROL             0: Serial control ends and RC takes over.\n"
    )
    assert described("LPF_FREQ_ROLL") == (
        "LPF_FREQ_ROLL  adjustable variable 45\n"
        "  Low-pass filter of roll.\n"
        "  Hz; 10 to 400 Hz\n"
    )
    assert described("pitch.rc_min_angle") == (
        "pitch.rc_min_angle  field of 4 messages\n"
        "  ReadParams3.rc.pitch.rc_min_angle\n"
        "      Angle at the lowest signal.\n"
        "      i16; deg; -720 to 720 deg; positive: pitch down, yaw right, roll unknown\n"
        "  WriteParams3.rc.pitch.rc_min_angle\n"
        "  ReadParamsAnswer.rc.pitch.rc_min_angle\n"
        "  WriteParams.rc.pitch.rc_min_angle\n"
    )


def test_fields_and_variables_say_which_way_they_count() -> None:
    """As the exported model does."""
    all_axes = "positive: pitch down, yaw right, roll unknown"
    for word in (
        "Control.axes.pitch.angle",
        "ControlExtCommand.axes.pitch.angle",
        "GetAngles.axes.yaw.rc_speed",
        "rc_min_angle",
    ):
        assert all_axes in words_of(described(word)), word
    assert "positive: unknown" in described("RealtimeData4.axes.pitch.acc_data")
    assert "positive: unknown" in described("HelperDataExt.frame_speed")
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


def test_other_words_are_searched() -> None:
    text = run("describe", "tilt", "limit").text
    assert text.startswith("tilt limit  occurs at ")
    assert "ReadParams3.rc.roll|pitch|yaw.rc_max_angle\n" in text
    assert "\n  RC_LIMIT_MAX_PITCH " in text and "YAW" not in text
    many = described("tilt")
    assert many.endswith("\n  and more; search for several words\n")


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


@pytest.mark.parametrize(
    "word, words",
    [
        ("MODE_ANGLE", ["ControlModeKind", "2: Go to", "Used in", "Control.control_mode"]),
        ("ControlModeKind", ["MODE_NO_CONTROL", "MODE_SPEED"]),
        ("RcMode", ["RC_MODE_SPEED", "inverted"]),
        ("LPF_FREQ_ROLL", ["adjustable variable 45", "10 to 400 Hz"]),
        ("rc_min_angle", ["ReadParams3.rc.roll.rc_min_angle", "-720 to 720 deg"]),
        ("pitch.rc_min_angle", ["ReadParams3.rc.pitch.rc_min_angle"]),
        ("SPEED_PITCH", ["Control.axes.pitch.speed"]),
        ("storage", ["CMD_EEPROM_READ"]),
        ("0x49", ["CMD_GET_ANGLES"]),
        # A flag, and fields with the same name.
        ("control_mode", ["ExtMotorsStateFields flags", "ControlExt.control_mode Mode of each"]),
        ("Control.axes", ["field of 1 message", "Control.axes Target of each axis"]),
        ("control.pitch.angle", ["field of 1 message", "Control.axes.pitch.angle"]),
        ("73", ["CMD_GET_ANGLES", "GetAnglesRequest"]),
    ],
)
def test_other_words(word: str, words: list[str]) -> None:
    text = words_of(described(word))
    for one in words:
        assert one in text


def test_everything_by_family() -> None:
    text = run("describe").text
    for command in MODEL["commands"]:
        assert f"  {command['name']} " in text or f"  {command['name']}\n" in text


@pytest.mark.parametrize(
    "word, suggestion",
    [
        ("CMD_CONTRL", "'CMD_CONTROL'"),
        ("cmd_contrl", "'CMD_CONTROL'"),
        ("rc_min_angl", "'rc_min_angle'"),
        ("MODE_ANGEL", "'MODE_ANGLE'"),
        ("zzzzzzz", "lists the commands"),
        ("300", "300"),
    ],
)
def test_typos(word: str, suggestion: str) -> None:
    result = run("describe", word)
    assert result.status == 1 and result.out == b""
    assert suggestion in result.error


@pytest.mark.parametrize("width", [60, 80, 120])
def test_lines_wrap_at_the_width(width: int) -> None:
    text = subprocess.run(
        [PROGRAM, "describe", "CMD_READ_PARAMS_3"],
        env={**os.environ, "COLUMNS": str(width)},
        capture_output=True,
        check=True,
    ).stdout.decode()
    long = [line for line in text.splitlines() if len(line) > width and " " in line.strip()]
    assert not long
    assert "\x1b" not in text, "no colors without a terminal"
