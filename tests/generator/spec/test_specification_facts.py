"""Sizes and offsets, summed up manually from the lists of the specification.

They come neither from spec/ nor from a program. Comments name the erratum that decides, if any.
"""

from __future__ import annotations

import pytest

from sbgcgen.model import Layout
from sbgcgen.views.history import Revisions
from support import message_of, project_layout

FROM, TO = "from_board", "to_board"

# Message, direction, bytes: the sum of the list's entries in order.
SIZES = [
    ("BoardInfo", FROM, 1 + 2 + 1 + 2 + 1 + 4 + 7),
    ("BoardInfo3", FROM, 9 + 12 + 4 + 5 * 2 + 34),
    ("ReadParams3", FROM, 134),  # see PARAMS_3 below
    ("WriteParams3", TO, 134),
    (
        "ReadParamsExt",
        FROM,
        1 + 18 + 6 + 3 + 6 + 6 + 9 + 2 + 1 + 3 + 6 + 6 + 9 + 1 + 6 + 12 + 4 + 2 + 3,
    ),
    ("ReadParamsExt2", FROM, 1 + 16 + 6 + 3 + 3 + 3 + 119),  # E001: a profile id comes first
    ("RealtimeData3", FROM, 12 + 5 + 3 + 12 + 6 + 6 + 6 + 4 + 1 + 2 + 3 + 3),
    ("RealtimeData4", FROM, 63 + 6 + 1 + 6 + 2 + 6 + 4 + 36),
    ("GetAngles", FROM, 3 * (2 + 2 + 2)),
    ("GetAnglesExt", FROM, 3 * (2 + 2 + 4 + 10)),
    ("AutoPid", FROM, 9 + 6 + 2 + 3 * (4 + 6) + 10),
    ("ReadExternalData", FROM, 128),
    ("ReadAdjVarsCfg", FROM, 10 * 6 + 15 * 4 + 8),
    ("CalibInfo", FROM, 2 + 6 + 2 + 2 + 4 + 1 + 6 + 2 + 1 + 7),
    ("ScriptDebug", FROM, 2 + 1),
    ("AhrsHelper", FROM, 12 + 12),
    ("AdjVarsState", FROM, 2 + 1 + 2 + 4 + 6),
    ("ReadFileError", FROM, 1),
    ("Error", FROM, 1 + 4),
    ("ErrorExt", FROM, 1 + 1 + 4),  # E086: real boards put the command first
    ("BoardInfoRequest", TO, 0),
    ("BoardInfoRequestOneByte", TO, 1),  # E214: real boards respond to it
    ("AhrsHelperRequest", TO, 1),  # E023
    ("AhrsHelperRequestWide", TO, 2),  # E209: MODE has two bytes from 2.69b5 on
    ("AhrsHelperRequestExt", TO, 1 + 12 + 12),
    ("AhrsHelperRequestExtWide", TO, 2 + 12 + 12),
    ("MotorsOffExt", TO, 1),  # E205
    ("ResetRequestExt", TO, 1 + 2),
    ("UseDefaults", TO, 1),
    ("ReadParams3Request", TO, 1),
    ("CalibBat", TO, 2),
    ("CalibAccExt", TO, 1 + 1 + 10),
    ("Control", TO, 1 + 6 * 2),
    ("ControlExt", TO, 3 + 6 * 2),
    ("TriggerPin", TO, 2),
    ("HelperData", TO, 5 * 2),
    ("HelperDataExt", TO, 6 + 4 + 1 + 6 + 3),
    ("AutoPidRequest", TO, 3 + 16),
    ("ServoOut", TO, 8 * 2),
    ("EepromReadRequest", TO, 4 + 2),
    ("CalibInfoRequest", TO, 1 + 11),
    ("ReadFileRequest", TO, 2 + 2 + 2 + 14),
    ("RunScript", TO, 1 + 1 + 32),
    ("GyroCorrection", TO, 1 + 6 + 2),
    ("DataStreamInterval", TO, 1 + 2 + 8 + 10),
    ("RealtimeDataCustomRequest", TO, 4 + 6),
]

# Message, direction, minimum and maximum size.
VARIABLE_SIZES = [
    ("BeepSound", TO, 2 + 1 + 1 + 8, 12 + 50 * 2),  # E369: later firmware plays 50 notes, not 30
    ("SetAdjVarsVal", TO, 1, 1 + 40 * (1 + 4)),
    ("ReadFile", FROM, 2 + 2, 255),
    ("WriteFile", TO, 2 + 2 + 2, 255),
    ("RealtimeDataCustom", FROM, 2, 255),  # L1210-L1220: 110; later blocks exceed a body
    ("BoardInfoRequestExt", TO, 2, 255),
    ("ApiVirtChControl", TO, 2, 32 * 2),  # E217: trailing channels may be omitted
]

# CMD_READ_PARAMS_3, compiled manually, L186-L310: protocol name, offset of its first byte.
PARAMS_3 = {
    "PROFILE_ID": 0,
    "P": 1,
    "ACC_LIMITER_ALL": 1 + 3 * 6,
    "EXT_FC_GAIN_ROLL": 20,
    "RC_MIN_ANGLE": 22,
    "GYRO_TRUST": 22 + 3 * 8,
    "SERIAL_SPEED": 49,
    "RC_TRIM_YAW": 52,
    "RC_MAP_ROLL": 56,
    "RC_MIX_FC_PITCH": 63,
    "FOLLOW_OFFSET_ROLL": 67,
    "AXIS_TOP": 70,
    "SKIP_GYRO_CALIB": 78,
    "MENU_CMD_1": 82,
    "MENU_CMD_LONG": 87,
    "OUTPUT_YAW": 90,
    "BAT_THRESHOLD_ALARM": 91,
    "BEEPER_MODES": 97,
    "BOOSTER_POWER_ROLL": 100,
    "FRAME_ANGLE_FROM_MOTORS": 106,
    "RC_MEMORY_PITCH": 109,
    "SERVO3_OUT": 115,
    "SERVO_RATE": 117,
    "ADAPTIVE_PID_RECOVERY_FACTOR": 121,
    "GENERAL_FLAGS1": 125,
    "PROFILE_FLAGS1": 127,
    "SPEKTRUM_MODE": 129,
    "EULER_ORDER": 131,
    "CUR_PROFILE_ID": 133,
}

# Message, protocol name (its first leaf), offset, type.
PLACES = [
    ("BoardInfo", "FIRMWARE_VER", 1, "u16"),
    ("BoardInfo", "BOARD_FEATURES", 4, "u16"),
    ("BoardInfo", "FRW_EXTRA_ID", 7, "u32"),
    ("RealtimeData3", "GYRO_DATA", 2, "i16"),
    ("RealtimeData3", "SYSTEM_ERROR", 14, "u16"),
    ("RealtimeData3", "RC_ROLL", 20, "i16"),
    ("RealtimeData3", "EXT_FC_PITCH", 30, "i16"),
    ("RealtimeData3", "ANGLE_ROLL", 32, "i16"),
    ("RealtimeData3", "RC_ANGLE_YAW", 48, "i16"),
    ("RealtimeData3", "ERROR_CODE", 54, "u8"),
    ("RealtimeData3", "BAT_LEVEL", 55, "u16"),
    ("RealtimeData3", "MOTOR_POWER_YAW", 62, "u8"),
    ("RealtimeData4", "ROTOR_ANGLE", 63, "i16"),
    ("RealtimeData4", "BALANCE_ERROR", 70, "i16"),
    ("RealtimeData4", "CURRENT", 76, "u16"),
    ("RealtimeData4", "MAG_DATA", 78, "i16"),
    ("RealtimeData4", "IMU_TEMPERATURE", 84, "i8"),
    ("RealtimeData4", "IMU_H_ERR", 87, "u8"),
    ("GetAnglesExt", "STATOR_ROTOR_ANGLE", 4, "i32"),
    ("Control", "SPEED_ROLL", 1, "i16"),
    ("Control", "ANGLE_YAW", 11, "i16"),
    ("ControlExt", "SPEED_ROLL", 3, "i16"),
    ("ReadFileRequest", "MAX_SIZE", 4, "u16"),
    ("BeepSound", "NOTE_LENGTH", 2, "u8"),
    ("BeepSound", "NOTE_FREQ_HZ", 12, "u16"),
]


@pytest.fixture(scope="module")
def layout() -> Layout:
    return project_layout()


@pytest.mark.parametrize(("name", "direction", "size"), SIZES)
def test_size(layout: Layout, name: str, direction: str, size: int) -> None:
    message = message_of(layout, name, direction)
    assert (message.min_size, message.max_size) == (size, size)


@pytest.mark.parametrize(("name", "direction", "smallest", "largest"), VARIABLE_SIZES)
def test_sizes_between(
    layout: Layout, name: str, direction: str, smallest: int, largest: int
) -> None:
    message = message_of(layout, name, direction)
    assert (message.min_size, message.max_size) == (smallest, largest)


@pytest.mark.parametrize(("name", "offset"), PARAMS_3.items())
@pytest.mark.parametrize("message", ["ReadParams3", "WriteParams3"])
def test_place_in_params_3(layout: Layout, message: str, name: str, offset: int) -> None:
    leaves = message_of(layout, message).leaves
    assert next(leaf.offset for leaf in leaves if leaf.spec_name == name) == offset


@pytest.mark.parametrize(("message", "name", "offset", "type_"), PLACES)
def test_place(layout: Layout, message: str, name: str, offset: int, type_: str) -> None:
    leaves = message_of(layout, message).leaves
    leaf = next(leaf for leaf in leaves if leaf.spec_name == name)
    assert (leaf.offset, leaf.type) == (offset, type_)


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


def test_forms_that_share_an_id(layout: Layout) -> None:
    """Id 67 is CMD_CONTROL to the board and CMD_CONFIRM from it."""
    names = {(m.name, m.direction) for m in layout.messages if m.id == 67}
    assert names == {("Control", TO), ("ControlExt", TO), ("Confirm", FROM)}


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


# Known effects of requests.
EFFECTS_KNOWN = {
    "GetAnglesRequest": ("reads",),
    "ReadParams3Request": ("reads",),
    "Control": ("moves",),
    "MotorsOff": ("moves",),
    "SetAdjVarsVal": ("sets", "moves"),
    "WriteParams": ("stores", "moves"),
    "WriteParams3": ("stores", "moves"),
    "WriteParamsExt": ("stores", "moves"),
    "WriteParamsExt2": ("stores", "moves"),
    "WriteAdjVarsCfg": ("stores", "moves"),
    "WriteProfileNames": ("stores",),
    "EepromWrite": ("stores", "moves"),
    "CalibOffset": ("stores", "moves"),
    "GyroCorrection": ("stores", "moves"),
    "RunScript": ("sets", "stores", "moves", "restarts"),
    "ApiVirtChControl": ("sets", "stores", "moves", "restarts"),
    "UseDefaults": ("stores", "moves", "erases"),
    "FsClearAll": ("erases",),
    "ResetRequest": ("restarts",),
    "BootMode3": ("restarts", "disconnects"),
    "SystemStateRequest": ("unknown",),
    "ExecuteMenu": ("sets", "stores", "moves", "restarts"),
    "CalibAccExt": ("stores", "restarts", "erases"),
}


@pytest.mark.parametrize("name", EFFECTS_KNOWN)
def test_effect(layout: Layout, name: str) -> None:
    effect = message_of(layout, name, TO).effect
    assert effect is not None and effect.words == EFFECTS_KNOWN[name]


def test_no_time_for_an_answer_is_told_without_saying_whose_it_is(layout: Layout) -> None:
    numbers = {erratum.number for erratum in layout.errata}
    assert layout.timeout_errata and set(layout.timeout_errata) <= numbers
