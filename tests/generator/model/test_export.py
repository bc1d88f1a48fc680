"""Forms and directions in the exported model. Its schema says its keys, and test_output compares all of it."""

from __future__ import annotations

import json
from typing import Any

import pytest

from sbgcgen.model.export import export
from support import project_layout


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
