"""The exported model: forms, directions and the fingerprint. Its schema says its keys, and test_output compares
all of it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from sbgcgen.build import load_layout
from sbgcgen.model.export import export
from support import layout_of, project_layout


@pytest.fixture(scope="module")
def model() -> dict[str, Any]:
    """The real protocol as another program reads it."""
    exported = export(project_layout())
    read: dict[str, Any] = json.loads(json.dumps(exported))
    return read


def leaves(model: dict[str, Any]) -> list[tuple[dict[str, Any], dict[str, Any]]]:
    return [(message, leaf) for message in model["messages"] for leaf in message["layout"]]


def test_forms_of_other_names_count_as_extended(model: dict[str, Any]) -> None:
    forms = {"simple", "extended", "success", "error", None}
    assert {m.get("form_name") for m in model["messages"]} > forms
    for message in model["messages"]:
        assert ("form_name" in message) == (message["form"] is not None)
        name = message.get("form_name")
        assert message["form"] == (name if name in forms else "extended"), message["name"]


def test_leaves_say_which_way_they_count(model: dict[str, Any]) -> None:
    """Angles, speeds, targets and limits of each axis; sizes have no direction."""
    said = {
        (message["name"], leaf["path"]): leaf["positive"]
        for message, leaf in leaves(model)
        if "positive" in leaf
    }
    for name, path in (
        ("Control", "axes.{}.angle"),
        ("Control", "axes.{}.speed"),
        ("ControlExtCommand", "axes.{}.angle"),
        ("GetAngles", "axes.{}.rc_target_angle"),
        ("GetAnglesExt", "axes.{}.stator_rotor_angle"),
        ("RealtimeData4", "angle.{}"),
        ("ReadParams3", "rc.{}.rc_min_angle"),
        ("ReadParamsExt2", "frame_cam_angle_max.{}"),
    ):
        words = [said[name, path.format(axis)] for axis in ("roll", "pitch", "yaw")]
        assert words == [None, "down", "right"], path
    for axis in ("roll", "pitch", "yaw"):  # the axes of sensors are not known
        assert said["RealtimeData4", f"axes.{axis}.gyro_data"] is None
        assert said["RealtimeData4", f"axes.{axis}.acc_data"] is None
    for name, path in (("ReadParams3", "axes.pitch.p"), ("ReadParams3", "follow_speed.pitch")):
        assert (name, path) not in said
    variables = {v["name"]: v["positive"] for v in model["adjustable_variables"] if "positive" in v}
    assert (variables["SW_LIM_MIN_PITCH"], variables["RC_LIMIT_MAX_YAW"]) == ("down", "right")
    assert "P_PITCH" not in variables


def test_every_signed_angle_and_speed_has_a_direction(model: dict[str, Any]) -> None:
    units = {"deg", "deg/s", "rad", "rad/s", "rpm"}
    for message, leaf in leaves(model):
        if leaf["unit"] in units and leaf["type"] in ("i8", "i16", "i32", "f32"):
            is_distance = leaf["path"].endswith(".dist")
            assert ("positive" in leaf) != is_distance, (message["name"], leaf["path"])


PROBE = """\
family: probe
summary: Two commands.

enums:
  Color:
    type: u8
    prefix: COLOR_
    summary: A color.
    source: Variables L30
    values:
      COLOR_RED: {value: 0, summary: Like fire.}

commands:
  CMD_FIRST:
    id: 10
    summary: The first.
    from_board:
      source: Incoming commands L50
      fields:
        - {name: COLOR, type: Color, summary: Which color.}
        - {name: LEVEL, type: u8, range: 0..100, special: {255: unknown}, summary: How full it is.}

  CMD_SECOND:
    id: 11
    summary: The second.
    from_board:
      source: Incoming commands L51
      fields:
        - {name: ANGLE, type: Angle, summary: Where it is.}
"""
SECOND = PROBE[PROBE.index("  CMD_SECOND:") :]
SWAPPED = PROBE.replace(SECOND, "").replace("  CMD_FIRST:", SECOND + "\n  CMD_FIRST:")


def fingerprint(folder: Path, text: str) -> Any:
    return export(layout_of(folder, text))["fingerprint"]


@pytest.mark.parametrize(
    "edited",
    [
        PROBE.replace("How full it is.", "The level."),
        PROBE.replace("Like fire.", "Like blood."),
        PROBE.replace("Two commands.", "Some commands."),
        PROBE.replace("255: unknown", "255: not known"),
        PROBE.replace("L50", "L52"),
        SWAPPED,
    ],
    ids=["field", "value", "family", "special value", "source", "order"],
)
def test_prose_and_order_have_no_effect(edited: str, tmp_path: Path) -> None:
    assert edited != PROBE
    assert fingerprint(tmp_path / "new", edited) == fingerprint(tmp_path / "old", PROBE)


@pytest.mark.parametrize(
    "old, new",
    [
        ("id: 10", "id: 12"),
        ("CMD_SECOND", "CMD_OTHER"),
        ("name: LEVEL", "name: HEIGHT"),
        ("LEVEL, type: u8", "LEVEL, type: u16"),
        ("0..100", "0..101"),
        ("255: unknown", "254: unknown"),
        ("{value: 0,", "{value: 1,"),
        ("COLOR_RED", "COLOR_BLUE"),
        ("type: Angle", "type: Speed"),
    ],
)
def test_every_fact_has_an_effect(old: str, new: str, tmp_path: Path) -> None:
    edited = PROBE.replace(old, new)
    assert edited != PROBE
    assert fingerprint(tmp_path / "new", edited) != fingerprint(tmp_path / "old", PROBE)


def test_the_shared_facts_have_an_effect(tmp_path: Path) -> None:
    before = fingerprint(tmp_path, PROBE)
    for file, old, new in (
        ("simplebgc.yaml", "start: 0x3E", "start: 0x3F"),
        ("simplebgc.yaml", "answer_timeout_ms: 500", "answer_timeout_ms: 600"),
        ("base.yaml", "scale: 360/16384", "scale: 360/16385"),
    ):
        text = (tmp_path / "spec" / file).read_text(encoding="utf-8")
        assert old in text
        (tmp_path / "spec" / file).write_text(text.replace(old, new), encoding="utf-8")
        after = export(load_layout(tmp_path / "spec"))["fingerprint"]
        assert after != before
        before = after
