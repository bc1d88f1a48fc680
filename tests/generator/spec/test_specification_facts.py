"""Facts of the specification missing in tests/data/specification_facts.json, compiled manually.

It comes neither from spec/ nor from a program. Comments name the erratum that decides, if any.
"""

from __future__ import annotations

import pytest

from sbgcgen.model import Layout
from sbgcgen.targets.site.view import Revisions
from support import message_of, project_layout

FROM, TO = "from_board", "to_board"


@pytest.fixture(scope="module")
def layout() -> Layout:
    return project_layout()


# Message, direction, minimum and maximum size.
VARIABLE_SIZES = [
    ("ReadFile", FROM, 2 + 2, 255),
    ("WriteFile", TO, 2 + 2 + 2, 255),
    ("BoardInfoRequestExt", TO, 2, 255),
]


@pytest.mark.parametrize(("name", "direction", "smallest", "largest"), VARIABLE_SIZES)
def test_size(layout: Layout, name: str, direction: str, smallest: int, largest: int) -> None:
    message = message_of(layout, name, direction)
    assert (message.min_size, message.max_size) == (smallest, largest)


def test_a_list_begins_after_the_fields_before_it(layout: Layout) -> None:
    leaves = message_of(layout, "BeepSound").leaves
    assert next(leaf.offset for leaf in leaves if leaf.spec_name == "NOTE_FREQ_HZ") == 12


def test_framing(layout: Layout) -> None:
    """L41-L61: '>', id, size, header checksum; body; body checksum."""
    framing = layout.framing
    assert (framing.start, framing.header_size, framing.trailer_size) == (ord(">"), 4, 1)
    assert framing.header == ("start", "id", "size", "header_checksum")
    assert framing.trailer == ("body_checksum",)
    assert [(c.name, c.kind, c.covers) for c in framing.checksums] == [
        ("header_checksum", "sum8", ("id", "size")),
        ("body_checksum", "sum8", ("body",)),
    ]
    assert framing.max_body == 255


# Additions according to the revision history (L9-L25), compiled manually.
HISTORY = {
    "0.4": ["ControlExt", "MenuCommand.MENU_CMD_LEVEL_ROLL_PITCH", "RealtimeData4.rotor_angle"],
    "0.6": ["ControlModeKind.MODE_ANGLE_REL_FRAME", "CMD_GET_ANGLES_EXT", "CMD_SET_ADJ_VARS_VAL"],
    "0.7": ["ReadParams3.order_of_axes", "ReadParams3.euler_order"],
    "0.9": [
        "CMD_GYRO_CORRECTION",
        "VariableId.FRAME_HEADING_ANGLE",
        "VariableId.GYRO_HEADING_CORRECTION",
    ],
    "0.11": [
        "CMD_READ_PARAMS_EXT2",
        "ReadParamsExt2.motor_mag_link_fine",
        "CMD_CALIB_MOTOR_MAG_LINK",
        "ReadParamsExt2.acc_limiter3",
        "HelperDataExt",
    ],
    "0.12": ["CMD_DATA_STREAM_INTERVAL", "CMD_REALTIME_DATA_CUSTOM"],
    "0.13": ["CMD_BEEP_SOUND"],
}


def test_a_field_is_as_old_in_what_is_written_as_in_what_is_read(layout: Layout) -> None:
    revisions = Revisions(layout)
    for owner, field, number in (
        ("WriteParams3", "order_of_axes", "0.7"),
        ("WriteParams", "euler_order", "0.7"),
        ("WriteParamsExt2", "motor_mag_link_fine.roll", "0.11"),
        ("WriteParamsExt2", "acc_limiter3.yaw", "0.11"),
    ):
        found = revisions.of("field", owner, field)
        assert found is not None and found.number == number, owner


def test_the_history_is_that_of_the_document(layout: Layout) -> None:
    assert [r.number for r in layout.revisions] == [f"0.{n}" for n in range(1, 16)]
    assert [r.source for r in layout.revisions] == [f"L{n}" for n in range(11, 26)]
    assert (layout.revisions[0].date, layout.revisions[-1].date) == ("2015-03-24", "2016-07-09")
    assert sorted(r.date for r in layout.revisions) == [r.date for r in layout.revisions]
    added = {r.number: [a.text for a in r.adds] for r in layout.revisions if r.adds}
    assert added == HISTORY
    said = {r.number for r in layout.revisions if r.adds or r.changes}
    assert said == {
        r.number for r in layout.revisions[1:]
    }, "all but the first have changed something"


# Effects, and requests that have them.
EFFECTS_KNOWN = {
    "reads": "GetAnglesRequest ReadParams3Request",
    "moves": "Control MotorsOff",
    "sets moves": "SetAdjVarsVal",
    "stores": "WriteProfileNames",
    "stores moves": "WriteParams WriteParams3 WriteParamsExt WriteParamsExt2 WriteAdjVarsCfg EepromWrite"
    " CalibOffset GyroCorrection",
    "sets stores moves restarts": "RunScript ApiVirtChControl ExecuteMenu",
    "stores moves erases": "UseDefaults",
    "erases": "FsClearAll",
    "restarts": "ResetRequest",
    "restarts disconnects": "BootMode3",
    "unknown": "SystemStateRequest",
    "stores restarts erases": "CalibAccExt",
}


@pytest.mark.parametrize("effects", EFFECTS_KNOWN)
def test_effect(layout: Layout, effects: str) -> None:
    for name in EFFECTS_KNOWN[effects].split():
        effect = message_of(layout, name, TO).effect
        assert effect is not None and effect.words == tuple(effects.split()), name


def test_no_time_for_an_answer_is_told_without_saying_whose_it_is(layout: Layout) -> None:
    numbers = {erratum.number for erratum in layout.errata}
    assert layout.timeout_errata and set(layout.timeout_errata) <= numbers
