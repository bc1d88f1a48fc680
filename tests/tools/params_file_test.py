"""Tests of `sbgc params` with files of the vendor's program."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from emulated_gimbal import emulated_gimbal
from params_test import body_of, good, params, words
from sbgc_command import run

Section = dict[str, Any]

# Names and values as in a file that a user published, of board 3.1 with firmware 2.70b0.
COMMON: Section = {
    "axisTop": -1,
    "i2c__fast": 0,
    "rcCmd": [0, 7, 0],
    "menuCmd": [10, 1, 2, 3, 0, 6],
    "followOffset": [0.5, 0.0, 0.0],
    "invert": [True, True, False],
    "poles": [22, 22, 0],
    "encoder__gear__ratio": [1008, 992, 1000],
    "motor__mag__link": [0, 0, 0],
    "mavlink__comp__id": [154, 0],
    "CAN__Drv__soft__params": [{"can-drv-params": {"Ld__stator": 2.0, "notch__freq": [0, 0, 0]}}]
    * 7,
    "adj__vars__trigger": [{"adj-var-trigger-cfg": {"src__ch": 33, "action": [1, 2, 3, 0, 5]}}]
    * 10,
    "extIMU": {"type": 2, "flags": 8, "startup__delay": 0},
}
PROFILE: Section = {
    "P": [68, 15, 76],
    "I": [18, 5, 3],
    "D": [43, 21, 54],
    "pid__gain": [45, 45, 45],
    "angleAccLimit3": [100, 100, 100],
    "invert": [False, False, False],
    "poles": [22, 22, 0],
    "rcMinAngle": [-45, -90, -45],
    "rcMode": [1, 1, 0],
    "rcInverse": [False, True, False],
    "gyroTrust": 100,
    "serialSpeed": 0,
    "rcMap": [0, 1, 5, 0, 0, 2],
    "frameAngleFromMotors": True,
    "notchFreq1": [40, 0, 0],
    "notchWidth2": [7, 8, 9],
    "notchEnabled1": [False, True, True],
    "lpfFreq": [400, 368, 400],
    "lpfEnabled": [False, True, False],
    "d__lpfFreq": [200, 100, 200],
    "servoOut": [0, 0, 4, 0],
    "servoRate": 50,
    "timelapseTime": 600,
    "jerk__slope__ms": [0, 0, 0],
}


def element(name: str, value: Any) -> str:
    if isinstance(value, dict):
        content = "".join(element(*item) for item in value.items())
    elif isinstance(value, list) and isinstance(value[0], dict):
        content = "".join(element(*item) for one in value for item in one.items())
    elif isinstance(value, list):
        kind = {bool: "boolean", int: "int", float: "float"}[type(value[0])]
        content = "".join(element(kind, one) for one in value)
    else:
        content = str(value).lower()
    return f"<{name}>{content}</{name}>\n"


def file_text(*profiles: Section, common: Section = COMMON, firmware: int = 2700) -> str:
    parts: list[tuple[str, Any]] = [("board-params", common)]
    parts += [("profile", profile) for profile in profiles or (PROFILE,)]
    parts += [("firmwareVer", firmware), ("appVer", 2700), ("boardVer", 31)]
    return f"<saved-configuration>{''.join(element(*part) for part in parts)}</saved-configuration>"


@pytest.fixture(name="board", scope="module")
def fixture_board() -> Iterator[str]:
    with emulated_gimbal("--firmware", "2.70b0", "--board", "3.1") as gimbal:
        yield gimbal.address


@pytest.fixture(name="file")
def fixture_file(tmp_path: Path) -> Path:
    path = tmp_path / "studio.profile"
    path.write_text(file_text())
    return path


def test_a_file_is_shown_by_names(file: Path) -> None:
    shown = run("params", "show", str(file), "--format", "json")
    values = {one["path"]: one["raw"] for one in json.loads(shown.text)["parameters"]}
    expected = {
        "axes.pitch.p": "15",
        "axes.pitch.i": "5",
        "axes.pitch.d": "21",
        "gyro_trust": "100",
        "mav_channels[0].mav_comp_id": "154",
        "rc.pitch.rc_mode": "9",
        "rc.roll.rc_mode": "1",
        "encoder_gear_ratio.roll": "1008",
        "menu_cmd_long": "6",
        "notches.yaw.notch_width[1]": "9",
        "d_term_lpf_freq.pitch": "10",
        "servo_rate": "5",
        "trigger_slots[9].action[4]": "5",
        "lpf_freq.pitch": "368",
        "filters_en.pitch": "9",
        "frame_angle_from_motors": "1",
        "timelapse_time": "600",
        "axes.yaw.poles": "0",
    }
    assert {path: values.get(path) for path in expected} == expected
    assert not [
        path for path in values if "invert" in path or "notch_freq" in path or "power" in path
    ]
    lines = {
        reason: set(names.split(", "))
        for reason, _, names in (
            line.partition(": ")
            for line in words(shown.error).split("note: not taken, because ")[1:]
        )
    }
    by_name = {name.strip(): reason for reason, names in lines.items() for name in names}
    assert by_name.keys() == {
        *("followOffset", "invert", "motor__mag__link", "jerk__slope__ms", "extIMU/startup__delay"),
        *("CAN__Drv__soft__params/Ld__stator", "CAN__Drv__soft__params/notch__freq"),
        *("angleAccLimit3", "notchFreq1"),
    }
    assert "differ" in by_name["invert"] and "counts" in by_name["notchFreq1"]
    text = run("params", "show", str(file), "pid").text
    assert "of board 3.1, firmware 2.70" in text and "axes.pitch.p" in text


def test_a_file_is_restored_like_a_backup(file: Path, board: str) -> None:
    before = [body_of(board, profile) for profile in range(5)]
    assert params(board, "diff", str(file), "--profile", "2").status == 1
    unconfirmed = params(board, "restore", str(file), "--profile", "2")
    assert unconfirmed.status != 0 and body_of(board, 1) == before[1]
    result = params(board, "restore", str(file), "--profile", "2", "--yes")
    assert result.status == 0 and "read back and compared" in result.error, result
    saved = list(file.parent.glob("studio.before-restore-*"))
    assert len(saved) == 1
    first, second = body_of(board, 0), body_of(board, 1)
    assert second["axes"]["pitch"]["p"] == 15 and second["axes"]["pitch"]["invert"] == 0
    assert second["rc"]["pitch"]["rc_min_angle"] == -90 and second["rc_map_fc_pitch"]
    assert first["axes"] == before[0]["axes"], "it has parameters of one profile"
    assert first["menu_cmd_long"] == second["menu_cmd_long"] != before[0]["menu_cmd_long"]
    assert params(board, "diff", str(file), "--profile", "2").status == 0
    assert params(board, "diff", str(file), "--profile", "3").status == 1
    good(board, "restore", str(saved[0]), "--yes", "--save-to", str(file.parent / "other.json"))
    assert [body_of(board, profile) for profile in range(5)] == before


def test_a_file_with_all_profiles(file: Path, board: str) -> None:
    profiles = [PROFILE | {"gyroTrust": 10 + number} for number in range(5)]
    file.write_text(file_text(*profiles))
    plan = good(board, "restore", str(file), "--dry-run")
    for number in range(5):
        assert f"-> {10 + number}\n" in plan.split(f"ReadParams3 of profile {number + 1}:")[1]
    assert params(board, "restore", str(file), "--dry-run", "--profile", "2").status == 2
    assert (
        '"11"'
        in run("params", "show", str(file), "gyro_trust", "--profile", "2", "--format", "json").text
    )
    profiles[3]["serialSpeed"] = 1
    file.write_text(file_text(*profiles))
    assert "serialSpeed" in params(board, "restore", str(file), "--dry-run").error
    file.write_text(file_text(*profiles[:3]))
    assert "3 profiles" in params(board, "restore", str(file), "--dry-run").error


def test_two_files_are_compared(file: Path, tmp_path: Path) -> None:
    other = tmp_path / "other.profile"
    other.write_text(file_text(PROFILE | {"gyroTrust": 101, "followSpeed": [1, 2, 3]}))
    result = run("params", "diff", str(file), str(other))
    assert (
        result.status == 1
        and result.text.count("->") == 1
        and "gyro_trust: 100 -> 101" in result.text
    )


@pytest.mark.parametrize(
    "change, said",
    [
        ({"gyroTrust": 300}, "gyroTrust: 300: "),
        ({"gyroTrust": -1}, "gyroTrust: -1: "),
        ({"gyroTrust": "much"}, "'much' is not a number"),
        ({"rcExpoRate": 101}, "rc_expo_rate"),
        ({"d__lpfFreq": [200, 205, 200]}, "d__lpfFreq: 205: the board has steps of 10 Hz"),
        ({"servoRate": 2000}, "servo_rate"),
        ({"rcMode": [1, 8, 1]}, "rcMode: 8: the board takes 0 to 7"),
        ({"rcMinAngle": [50, 0, 0], "rcMaxAngle": [40, 9, 9]}, "rc_min_angle"),
    ],
)
def test_what_the_board_cannot_take_is_refused(
    change: Section, said: str, file: Path, board: str
) -> None:
    file.write_text(file_text(PROFILE | change))
    before = body_of(board, 0)
    result = params(board, "restore", str(file), "--yes")
    assert result.status == 1 and said in words(result.error), result
    assert body_of(board, 0) == before


def test_other_firmware_is_refused(file: Path, board: str) -> None:
    file.write_text(file_text(firmware=2590))
    result = params(board, "restore", str(file), "--dry-run")
    assert result.status == 1 and "--other-firmware" in result.error
    result = params(board, "restore", str(file), "--dry-run", "--other-firmware")
    assert result.status == 0 and "firmware of the file does not have them yet" in words(
        result.error
    )
    file.write_text(file_text(firmware=2731))
    result = params(board, "restore", str(file), "--dry-run", "--other-firmware")
    assert "P, I, D, pid__gain" in words(result.error), "they are logarithmic"


@pytest.mark.parametrize(
    "text, said",
    [
        (file_text().replace("<axisTop>", "<axisTop><!-- -->x<b/>"), "text beside an element"),
        (
            "<!DOCTYPE a [<!ENTITY b 'cc'>]>" + file_text(),
            "a document type is not allowed (line 1)",
        ),
        (file_text().replace("</profile>", ""), "mismatched tag"),
        (file_text()[:-30], "unclosed token"),
        (file_text().replace("firmwareVer", "firmware"), "firmwareVer do not say"),
        (file_text().replace("profile>", "other>"), "it lacks <board-params> or <profile>"),
        (file_text(*[PROFILE] * 6), "more than 5 profiles"),
        (file_text(common={"a" * 65: 1}), "a name is too long"),
        ("<saved-configuration>" + "<a>" * 100_000, "nested too deeply"),
        (file_text(common={"a": [1] * 20_001}), "more than 20000 values"),
        (file_text() + " " * (1 << 20), "more than 1048576 bytes"),
    ],
    ids=str.split("mixed entity unclosed cut version parts profiles name depth values size"),
)
def test_hostile_files_are_refused(text: str, said: str, file: Path) -> None:
    file.write_text(text)
    result = run("params", "show", str(file))
    assert result.status == 1 and said in words(result.error), result.error
    assert "XML of the vendor's program" in result.error or "<!DOCTYPE" in text
