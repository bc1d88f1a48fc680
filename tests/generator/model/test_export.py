"""The exported model has the keys and values that design.md section 7 specifies."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from sbgcgen.model.export import export
from support import layout_of, project_layout

SCALARS = {"u8": 1, "i8": 1, "u16": 2, "i16": 2, "u32": 4, "i32": 4, "f32": 4}
SCALARS |= {"u24": 3, "i24": 3, "u64": 8, "i64": 8, "f64": 8}
TEXT = (str,)
NUMBER = (int, float)
MAYBE_TEXT = (str, type(None))
MAYBE_NUMBER = (int, float, type(None))
MAYBE_INT = (int, type(None))

KEYS: dict[str, dict[str, tuple[type, ...]]] = {
    "commands": {"name": TEXT, "id": MAYBE_INT},
    "messages": {
        "name": TEXT,
        "command": TEXT,
        "id": (int,),
        "direction": TEXT,
        "form": MAYBE_TEXT,
        "min_size": (int,),
        "max_size": (int,),
        "response": (dict, type(None)),
        "layout": (list,),
    },
    "enums": {"name": TEXT, "kind": TEXT, "width": (int,), "values": (list,)},
    "adjustable_variables": {
        "name": TEXT,
        "id": (int,),
        "type": TEXT,
        "min": NUMBER,
        "max": NUMBER,
        "unit": MAYBE_TEXT,
    },
}
LEAF: dict[str, tuple[type, ...]] = {
    "path": TEXT,
    "spec_name": TEXT,
    "offset": MAYBE_INT,
    "type": TEXT,
    "count": MAYBE_INT,
    "unit": MAYBE_TEXT,
    "scale": MAYBE_NUMBER,
    "min": MAYBE_NUMBER,
    "max": MAYBE_NUMBER,
    "enum": MAYBE_TEXT,
    "reserved": (bool,),
}


@pytest.fixture(scope="module")
def model() -> dict[str, Any]:
    """The real protocol as another program reads it."""
    exported = export(project_layout())
    read: dict[str, Any] = json.loads(json.dumps(exported))
    return read


def has_keys(entry: dict[str, Any], keys: dict[str, tuple[type, ...]]) -> None:
    for key, types in keys.items():
        assert key in entry, f"{entry.get('name')} has no '{key}'"
        value = entry[key]
        assert isinstance(value, types), f"{entry.get('name')}: {key} is {value!r}"
        assert isinstance(value, bool) == (types == (bool,)), f"{key} is {value!r}"


def leaves(model: dict[str, Any]) -> list[tuple[dict[str, Any], dict[str, Any]]]:
    return [(message, leaf) for message in model["messages"] for leaf in message["layout"]]


def test_protocol_has_name_and_revision(model: dict[str, Any]) -> None:
    assert model["protocol"]["name"] and model["protocol"]["revision"] == "0.15"


@pytest.mark.parametrize("section", KEYS)
def test_promised_keys(model: dict[str, Any], section: str) -> None:
    assert model[section]
    for entry in model[section]:
        has_keys(entry, KEYS[section])


def test_promised_keys_of_leaves(model: dict[str, Any]) -> None:
    for _, leaf in leaves(model):
        has_keys(leaf, LEAF)


def test_words_are_the_promised_ones(model: dict[str, Any]) -> None:
    assert {m["direction"] for m in model["messages"]} == {"from_board", "to_board"}
    forms = {"simple", "extended", "success", "error", None}
    assert {m["form"] for m in model["messages"]} == forms
    assert {m.get("form_name") for m in model["messages"]} > forms
    for message in model["messages"]:
        assert ("form_name" in message) == (message["form"] is not None)
        name = message.get("form_name")
        assert message["form"] == (name if name in forms else "extended"), message["name"]
    assert {e["kind"] for e in model["enums"]} == {"enum", "flags"}
    types = {*SCALARS, "bytes", "text", "string"}
    assert {leaf["type"] for _, leaf in leaves(model)} <= types


def test_references_lead_somewhere(model: dict[str, Any]) -> None:
    commands = {c["name"]: c["id"] for c in model["commands"]}
    enums = {e["name"] for e in model["enums"]}
    sent = {m["name"] for m in model["messages"] if m["direction"] == "from_board"}
    for message in model["messages"]:
        assert commands[message["command"]] == message["id"]
        if message["response"]:
            assert set(message["response"]["messages"]) <= sent
    for _, leaf in leaves(model):
        assert leaf["enum"] is None or leaf["enum"] in enums


def test_message_with_several_forms_names_each(model: dict[str, Any]) -> None:
    forms: dict[tuple[str, str], list[str | None]] = {}
    for message in model["messages"]:
        key = (message["command"], message["direction"])
        forms.setdefault(key, []).append(message.get("form_name"))
    for key, names in forms.items():
        assert len(names) == len(set(names)), key
        assert names == [None] if len(names) == 1 else None not in names, key


def test_enum_values_fit_their_width_and_are_named_once(model: dict[str, Any]) -> None:
    for enum in model["enums"]:
        names = [value["name"] for value in enum["values"]]
        assert len(names) == len(set(names)), enum["name"]
        for value in enum["values"]:
            assert -(1 << (8 * enum["width"] - 1)) <= value["value"] < 1 << (8 * enum["width"])


def test_fixed_layouts_add_up(model: dict[str, Any]) -> None:
    """Offsets follow each other without gaps, and the last byte ends the body."""
    for message in model["messages"]:
        at = 0
        for leaf in message["layout"]:
            if (
                "when" in leaf
                or "may_be_missing" in leaf
                or "[]" in leaf["path"]
                or None in (leaf["offset"], leaf["count"])
            ):
                break
            assert leaf["offset"] == at, f"{message['name']}.{leaf['path']}"
            at += SCALARS.get(leaf["type"], 1) * leaf["count"]
        else:
            assert at == message["min_size"], message["name"]


def test_paths_are_unique(model: dict[str, Any]) -> None:
    for message in model["messages"]:
        paths = [leaf["path"] for leaf in message["layout"]]
        assert len(paths) == len(set(paths)), message["name"]


def test_example_of_the_design(model: dict[str, Any]) -> None:
    """The entries shown in design.md match exactly."""
    (message,) = [m for m in model["messages"] if m["name"] == "BoardInfo"]
    assert {key: message[key] for key in KEYS["messages"] if key != "layout"} == {
        "name": "BoardInfo",
        "command": "CMD_BOARD_INFO",
        "id": 86,
        "direction": "from_board",
        "form": None,
        "min_size": 18,
        "max_size": 18,
        "response": None,
    }
    (leaf,) = [i for i in message["layout"] if i["path"] == "firmware_version"] or [
        i for i in message["layout"] if i["spec_name"] == "FIRMWARE_VER"
    ]
    assert {key: leaf[key] for key in LEAF if key != "path"} == {
        "spec_name": "FIRMWARE_VER",
        "offset": 1,
        "type": "u16",
        "count": 1,
        "unit": None,
        "scale": None,
        "min": None,
        "max": None,
        "enum": None,
        "reserved": False,
    }
    values = {v["name"]: v["value"] for e in model["enums"] for v in e["values"]}
    assert values["RC_MODE_ANGLE"] == 0


def test_names_carry_no_indices(model: dict[str, Any]) -> None:
    for message, leaf in leaves(model):
        assert not set("[]{}.") & set(leaf["spec_name"]), f"{message['name']}.{leaf['path']}"


PROBE = """\
family: probe
commands:
  CMD_PROBE:
    id: 9
    summary: Numbers of all kinds.
    from_board:
      source: L1
      fields:
        - {name: A, type: Angle, range: -4096..4096, special: {-32768: {as: lost, summary: undefined}}, summary: An angle.}
        - {name: B, type: f32, range: -1.5..1, summary: A fraction.}
        - {name: C, type: Mode, summary: A mode.}
        - {name: "N[2]", type: "text[8]", summary: Two names.}
        - {reserved: 3}
        - {name: D, type: "bytes[]", summary: The rest.}
"""


def test_leaf_by_leaf(tmp_path: Path) -> None:
    exported = export(layout_of(tmp_path, PROBE))
    (message,) = [m for m in exported["messages"] if m["name"] == "Probe"]
    rows = [tuple(leaf[key] for key in LEAF) for leaf in message["layout"]]
    (special,) = [leaf for leaf in message["layout"] if "special" in leaf]
    assert special["special"] == {"-32768": "undefined"}
    assert special["special_names"] == {"-32768": "lost"}
    assert rows == [
        ("a", "A", 0, "i16", 1, "deg", 360 / 16384, -4096, 4096, None, False),
        ("b", "B", 2, "f32", 1, None, None, -1.5, 1, None, False),
        ("c", "C", 6, "u8", 1, None, None, None, None, "Mode", False),
        ("n[0]", "N", 7, "text", 8, None, None, None, None, None, False),
        ("n[1]", "N", 15, "text", 8, None, None, None, None, None, False),
        ("reserved", "RESERVED", 23, "bytes", 3, None, None, None, None, None, True),
        ("d", "D", 26, "bytes", None, None, None, None, None, None, False),
    ]


LATER = """\
family: probe
enums:
  Lamp:
    type: u8
    summary: A lamp.
    source: L1
    values:
      LAMP_OFF: {value: 0, summary: "Off."}
      LAMP_LIT:
        value: 1
        was: [LAMP_ON, LAMP_SHINE]
        since: {firmware: 2.60}
        before: {firmware: 2.70, summary: It blinked.}
        unconfirmed: true
        summary: It is lit.
packed:
  Tilt:
    type: u64
    summary: A tilt.
    source: L1
    parts:
      - {name: low, bits: 0..11, signed: true, summary: A number.}
      - {name: high, bits: 12..26, sign: 27, type: Angle, summary: An angle.}
variables:
  DIMMER: {id: 7, type: u8, range: 0..9, since: {firmware: 2.70}, unconfirmed: true, summary: A dimmer.}
commands:
  CMD_PROBE:
    id: 9
    was: CMD_OLD
    unconfirmed: true
    summary: All that later firmware can do.
    from_board:
      source: L1
      rules: [LOW < HIGH]
      fields:
        - {name: VERSION, type: u8, constant: 2, summary: A version.}
        - {name: LAMP, type: Lamp, default: LAMP_LIT, was: LIGHT, summary: A lamp.}
        - {name: LOW, type: u24, summary: A number.}
        - {name: HIGH, type: u24, unconfirmed: true, summary: A number.}
        - {name: TILT, type: Tilt, since: {firmware: 2.60}, summary: A tilt.}
        - {name: ID, type: VariableId, since: {firmware: 2.70}, summary: A variable.}
  CMD_LISTS:
    id: 10
    summary: Lists of all kinds.
    from_board:
      source: L2
      fields:
        - {name: OPTIONS, type: Options, summary: Options.}
        - {name: SIZE, type: u8, summary: A size.}
        - {name: "A[OPTIONS]", type: u8, summary: By bits.}
        - {name: "B[SIZE]", type: u16, counted_in: bytes, summary: By bytes.}
        - {name: COUNT, type: u8, summary: A count.}
        - {name: "C[COUNT]", type: u8, counted_from: 1, summary: By the count minus 1.}
        - {name: D, type: f64, when: {field: OPTIONS, any: [OPTION_FAST, OPTION_FINE]}, summary: One flag.}
        - {name: E, type: i24, when: {field: OPTIONS, has: OPTION_FAST, has_not: OPTION_FINE}, summary: Not both.}
        - {name: F, type: u64, when: {field: SIZE, is_not: [0, 1]}, summary: A number.}
        - {name: G, type: Pair, when: {field: SIZE, is: 9}, since: {firmware: 2.60}, summary: Two numbers.}
"""


def test_what_later_firmware_needs_is_exported(tmp_path: Path) -> None:
    exported = export(layout_of(tmp_path, LATER))
    messages = {m["name"]: m for m in exported["messages"]}
    probe = messages["Probe"]
    leaf = {item["path"]: item for item in probe["layout"]}
    assert (leaf["version"]["default"], leaf["version"]["constant"]) == (2, 2)
    assert (leaf["lamp"]["default"], leaf["lamp"]["formerly"]) == (1, ["LIGHT"])
    assert leaf["high"]["unconfirmed"] is True and "unconfirmed" not in leaf["low"]
    assert probe["rules"] == ["low < high"] and probe["unconfirmed"] is True
    assert probe["sizes"] == [
        {"since": None, "size": 8},
        {"since": {"firmware": "2.60"}, "size": 16},
        {"since": {"firmware": "2.70"}, "size": 17},
    ]
    assert (probe["min_size"], probe["max_size"]) == (8, 17)
    assert leaf["tilt"]["may_be_missing"] and leaf["tilt"]["since"] == {"firmware": "2.60"}

    lists = {item["path"]: item for item in messages["Lists"]["layout"]}
    counted = {name: item.get("counted_in") for name, item in lists.items() if "counted_by" in item}
    assert counted == {"a": "bits", "b": "bytes", "c": "minus_1"}
    assert lists["d"]["when"]["any"] == ["OPTION_FAST", "OPTION_FINE"]
    assert lists["e"]["when"]["has"] == ["OPTION_FAST"]
    assert lists["e"]["when"]["has_not"] == ["OPTION_FINE"]
    assert lists["f"]["when"]["is_not"] == [0, 1] and lists["f"]["when"]["is"] == []
    assert [lists[name]["type"] for name in "def"] == ["f64", "i24", "u64"]
    assert lists["g.first"]["may_be_missing"] is True and "may_be_missing" not in lists["f"]
    (group,) = messages["Lists"]["groups"]
    assert (group["path"], group["since"]) == ("g", {"firmware": "2.60"})
    assert (group["when"]["field"], group["when"]["is"]) == ("size", [9])

    (lamp,) = [e for e in exported["enums"] if e["name"] == "Lamp"]
    lit = lamp["values"][1]
    assert lit["formerly"] == ["LAMP_ON", "LAMP_SHINE"] and lit["unconfirmed"] is True
    assert lit["before"] == {"firmware": "2.70", "summary": "It blinked."}
    (tilt,) = [p for p in exported["packed"] if p["name"] == "Tilt"]
    low, high = tilt["parts"]
    assert low["signed"] is True and "sign" not in low
    assert high["sign"] == 1 << 27 and high["unit"] == "deg"
    (dimmer,) = exported["adjustable_variables"]
    assert dimmer["since"] == {"firmware": "2.70"} and dimmer["unconfirmed"] is True
    (command,) = [c for c in exported["commands"] if c["name"] == "CMD_PROBE"]
    assert command["formerly"] == ["CMD_OLD"] and command["unconfirmed"] is True


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
