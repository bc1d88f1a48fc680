"""Tests of splitting and joining names."""

from __future__ import annotations

import pytest

from sbgcgen.model.names import camel_case, is_name, parse_field_name, parse_lines, singular
from sbgcgen.model.names import snake_case, type_advice


def test_singular() -> None:
    plurals = "SystemErrors Switches Pushes Losses Modes Presence".split()
    expected = "SystemError Switch Push Loss Mode PresenceBit".split()
    assert [singular(plural) for plural in plurals] == expected


@pytest.mark.parametrize(
    ("text", "base", "spec_name", "expand", "index"),
    [
        ("ACC_DATA", "ACC_DATA", "ACC_DATA", None, None),
        ("axes[axis]", "axes", "axes", None, "axis"),
        ("RC_DATA[6]", "RC_DATA", "RC_DATA", None, "6"),
        ("params[NUM_VARS]", "params", "params", None, "NUM_VARS"),
        ("NOTE_FREQ_HZ[]", "NOTE_FREQ_HZ", "NOTE_FREQ_HZ", None, ""),
        ("SPEED_{AXIS}", "SPEED", "SPEED_{AXIS}", "AXIS", None),
        ("SERVO{1..4}_OUT", "SERVO_OUT", "SERVO{1..4}_OUT", "1..4", None),
        ("MENU_CMD_{1..5}", "MENU_CMD", "MENU_CMD_{1..5}", "1..5", None),
        ("A_{AXIS}_B", "A_B", "A_{AXIS}_B", "AXIS", None),
        ("{AXIS}_B", "B", "{AXIS}_B", "AXIS", None),
        ("deviceID", "deviceID", "deviceID", None, None),
    ],
)
def test_field_name(
    text: str, base: str, spec_name: str, expand: str | None, index: str | None
) -> None:
    name = parse_field_name(text)
    assert name is not None
    assert (name.base, name.spec_name, name.expand, name.index) == (base, spec_name, expand, index)


_NO_NAMES = (
    "|3D|A B|A-B|A[|A]|A[1][2]|A[-1]|A_{axis}|{AXIS}|{AXIS}_3|{1..3}_A|A_{AXIS}[3]|Größe|A\n"
)


@pytest.mark.parametrize("text", _NO_NAMES.split("|"))
def test_no_field_name(text: str) -> None:
    assert parse_field_name(text) is None


def test_cases_of_names() -> None:
    snake = "firmware_ver device_id rc_min_angle board_info realtime_data3 i2c_error_count"
    names = "FIRMWARE_VER deviceID RC_MIN_ANGLE BoardInfo RealtimeData3 I2C_ERROR_COUNT"
    assert [snake_case(name) for name in names.split()] == snake.split()
    names, camel = "BOARD_INFO_3 I2C_READ_REG_BUF ERROR", "BoardInfo3 I2cReadRegBuf Error"
    assert [camel_case(name) for name in names.split()] == camel.split()


def test_names() -> None:
    assert is_name("acc_limiter3") and is_name("Limit_3")
    assert not any(is_name(word) for word in ("", "3d", "a b", "a-b", "größe", "_a", "a\n"))


def test_lines_of_a_source() -> None:
    assert parse_lines("Variables L1005-L1009, L12") == [(1005, 1009), (12, 12)]
    assert parse_lines("Appendix B") == []


@pytest.mark.parametrize(
    ("text", "advice"),
    [
        ("uint16_t", "write u16"),
        ("int8", "write i8"),
        ("2u", "write u16"),
        ("1s", "write i8"),
        ("4f", "write f32"),
        ("float", "write f32"),
        ("u8[3]", "the count belongs to the name: 'NAME[3]' with type: u8"),
        ("bytes[3]", ""),
        ("Angle", ""),
    ],
)
def test_advice_for_types_from_elsewhere(text: str, advice: str) -> None:
    assert type_advice(text) == advice
