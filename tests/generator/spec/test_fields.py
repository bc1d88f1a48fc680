"""Tests of fields: repetition, offsets, sizes, and the leaves with their paths and names."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest

from sbgcgen.model import Field, Message
from support import layout_of, message_of


def message(folder: Path, *fields: str) -> Message:
    """Returns a message with these fields, each a line of YAML."""
    lines = "".join(f"        - {field}\n" for field in fields)
    return message_of(layout_of(folder, lines), "Probe")


def leaves(message_: Message) -> list[tuple[str, str, str, int | None, int | None]]:
    return [(i.path, i.spec_name, i.type, i.count, i.offset) for i in message_.leaves]


def field(folder: Path, text: str) -> Field:
    return message(folder, text).fields[0]


def test_one_number_of_each_type(tmp_path: Path) -> None:
    types = ("u8", "i8", "u16", "i16", "u32", "i32", "f32")
    made = message(tmp_path, *(f"{{name: A_{t.upper()}, type: {t}, summary: S.}}" for t in types))
    assert [(i.type, i.offset) for i in made.leaves] == [
        ("u8", 0),
        ("i8", 1),
        ("u16", 2),
        ("i16", 4),
        ("u32", 6),
        ("i32", 10),
        ("f32", 14),
    ]
    assert (made.min_size, made.max_size) == (18, 18)


def test_array_over_axes_gives_each_the_same_protocol_name(tmp_path: Path) -> None:
    assert leaves(message(tmp_path, '{name: "ACC[axis]", type: i16, summary: S.}')) == [
        ("acc.roll", "ACC", "i16", 1, 0),
        ("acc.pitch", "ACC", "i16", 1, 2),
        ("acc.yaw", "ACC", "i16", 1, 4),
    ]


def test_placeholder_gives_each_axis_its_own_protocol_name(tmp_path: Path) -> None:
    assert leaves(message(tmp_path, '{name: "RC_{AXIS}_MIN", type: u8, summary: S.}')) == [
        ("rc_min.roll", "RC_ROLL_MIN", "u8", 1, 0),
        ("rc_min.pitch", "RC_PITCH_MIN", "u8", 1, 1),
        ("rc_min.yaw", "RC_YAW_MIN", "u8", 1, 2),
    ]


def test_numbered_names_of_which_the_last_may_be_missing(tmp_path: Path) -> None:
    made = message(tmp_path, '{name: "CH{1..4}", type: i16, min_count: 2, summary: S.}')
    assert [(i.path, i.spec_name, i.offset, i.optional) for i in made.leaves] == [
        ("ch[0]", "CH1", 0, False),
        ("ch[1]", "CH2", 2, False),
        ("ch[2]", "CH3", 4, True),
        ("ch[3]", "CH4", 6, True),
    ]
    (one,) = made.fields
    assert (one.dim, one.capacity, one.min_count) == ("rest", 4, 2)
    assert (made.min_size, made.max_size) == (4, 8)


def test_list_with_a_least_length(tmp_path: Path) -> None:
    made = message(tmp_path, '{name: "A[]", type: u16, min_count: 3, max_count: 5, summary: S.}')
    assert (made.min_size, made.max_size) == (6, 10)
    assert leaves(made) == [("a", "A", "u16", None, 0)]


def test_vector(tmp_path: Path) -> None:
    assert leaves(message(tmp_path, '{name: "Z1_VECTOR[xyz]", type: f32, summary: S.}')) == [
        ("z1_vector.x", "Z1_VECTOR", "f32", 1, 0),
        ("z1_vector.y", "Z1_VECTOR", "f32", 1, 4),
        ("z1_vector.z", "Z1_VECTOR", "f32", 1, 8),
    ]


def test_numbered_names(tmp_path: Path) -> None:
    assert leaves(message(tmp_path, '{name: "SERVO{3..5}_OUT", type: u16, summary: S.}')) == [
        ("servo_out[0]", "SERVO3_OUT", "u16", 1, 0),
        ("servo_out[1]", "SERVO4_OUT", "u16", 1, 2),
        ("servo_out[2]", "SERVO5_OUT", "u16", 1, 4),
    ]


def test_array_of_numbers_is_one_leaf_and_of_structs_is_flattened(tmp_path: Path) -> None:
    made = message(
        tmp_path,
        '{name: "RAW[3]", type: u16, summary: S.}',
        '{name: "pairs[2]", type: Pair, summary: S.}',
    )
    assert leaves(made) == [
        ("raw", "RAW", "u16", 3, 0),
        ("pairs[0].first", "FIRST", "u8", 1, 6),
        ("pairs[0].second", "SECOND", "u16", 1, 7),
        ("pairs[1].first", "FIRST", "u8", 1, 9),
        ("pairs[1].second", "SECOND", "u16", 1, 10),
    ]


def test_struct_per_axis_hands_its_axis_to_the_names_inside(tmp_path: Path) -> None:
    made = message(
        tmp_path,
        "{name: BEFORE, type: u8, summary: S.}",
        'name: "axes[axis]"\n          struct: Target\n          summary: S.\n'
        "          fields:\n"
        '            - {name: "SPEED_{AXIS}", type: Speed, summary: S.}\n'
        "            - {name: ANGLE, type: Angle, summary: S.}",
    )
    assert leaves(made)[1:5] == [
        ("axes.roll.speed", "SPEED_ROLL", "i16", 1, 1),
        ("axes.roll.angle", "ANGLE", "i16", 1, 3),
        ("axes.pitch.speed", "SPEED_PITCH", "i16", 1, 5),
        ("axes.pitch.angle", "ANGLE", "i16", 1, 7),
    ]
    assert made.max_size == 13


def test_structs_in_structs(tmp_path: Path) -> None:
    made = message(
        tmp_path,
        'name: "outer[2]"\n          struct: Outer\n          summary: S.\n          fields:\n'
        '            - {name: "inner[2]", type: Pair, summary: S.}\n'
        "            - {reserved: 1}",
    )
    assert [(i.path, i.offset) for i in made.leaves] == [
        ("outer[0].inner[0].first", 0),
        ("outer[0].inner[0].second", 1),
        ("outer[0].inner[1].first", 3),
        ("outer[0].inner[1].second", 4),
        ("outer[0].reserved", 6),
        ("outer[1].inner[0].first", 7),
        ("outer[1].inner[0].second", 8),
        ("outer[1].inner[1].first", 10),
        ("outer[1].inner[1].second", 11),
        ("outer[1].reserved", 13),
    ]


def test_bytes_and_text(tmp_path: Path) -> None:
    made = message(
        tmp_path,
        '{name: ID, type: "bytes[9]", summary: S.}',
        '{name: "NAME[2]", type: "text[48]", summary: S.}',
        "{name: AFTER, type: u8, summary: S.}",
    )
    assert leaves(made) == [
        ("id", "ID", "bytes", 9, 0),
        ("name[0]", "NAME", "text", 48, 9),
        ("name[1]", "NAME", "text", 48, 57),
        ("after", "AFTER", "u8", 1, 105),
    ]


def test_reserved_bytes_are_numbered_only_if_there_are_several(tmp_path: Path) -> None:
    number = "{name: A, type: u8, summary: S.}"
    one = message(tmp_path / "one", "{reserved: 3}", number)
    assert leaves(one)[0] == ("reserved", "RESERVED", "bytes", 3, 0)
    two = message(tmp_path / "two", "{reserved: 3}", number, "{reserved: 2}")
    assert [i.path for i in two.leaves] == ["reserved_1", "a", "reserved_2"]
    assert [i.field.reserved for i in two.leaves] == [True, False, True]


def test_named_reserved_field_keeps_its_name(tmp_path: Path) -> None:
    made = field(tmp_path, '{name: SPARE, type: "bytes[2]", reserved: true}')
    assert (made.name, made.spec_name, made.reserved) == ("spare", "SPARE", True)
    assert made.summary


def test_list_counted_by_an_earlier_field(tmp_path: Path) -> None:
    made = message(
        tmp_path,
        "{name: N, type: u8, range: 0..4, summary: S.}",
        '{name: "items[N]", type: Pair, summary: S.}',
        "{name: AFTER, type: u8, summary: S.}",
    )
    assert (
        leaves(made)
        == [
            ("n", "N", "u8", 1, 0),
            ("items[].first", "FIRST", "u8", 1, None),
            ("items[].second", "SECOND", "u16", 1, None),
            ("after", "AFTER", "u8", 1, None),
        ]
        or leaves(made)[1][4] == 1
    )  # the first element of a list may have a fixed offset
    assert made.leaves[-1].offset is None
    assert [f.is_counter for f in made.fields] == [True, False, False]
    assert made.fields[1].counter == "n"
    assert (made.min_size, made.max_size) == (2, 2 + 4 * 3)


def test_list_whose_elements_vary_in_size(tmp_path: Path) -> None:
    """A session takes an answer of the largest size: 20 texts of 6 bytes with their lengths."""
    made = message(
        tmp_path,
        "{name: N, type: u8, range: 0..20, summary: S.}",
        '{name: "ITEMS[N]", struct: Item, summary: S., fields: '
        '[{name: TEXT, type: "string[6]", summary: S.}]}',
    )
    assert (made.min_size, made.max_size) == (1, 1 + 20 * 7)


def test_rest_of_the_body(tmp_path: Path) -> None:
    made = message(
        tmp_path,
        "{name: A, type: u32, summary: S.}",
        '{name: "NOTES[]", type: u16, max_count: 30, summary: S.}',
    )
    assert leaves(made)[1][:4] == ("notes", "NOTES", "u16", None)
    assert (made.min_size, made.max_size) == (4, 64)
    assert made.fields[1].dim == "rest"
    assert made.fields[1].capacity == 125
    assert not made.keeps_tail, "nothing can follow the rest"


def test_rest_of_the_body_without_limit_fills_a_frame(tmp_path: Path) -> None:
    made = message(tmp_path, '{name: DATA, type: "bytes[]", summary: S.}')
    assert leaves(made)[0][:4] == ("data", "DATA", "bytes", None)
    assert (made.min_size, made.max_size) == (0, 255)


def test_conditional_fields_make_what_follows_movable(tmp_path: Path) -> None:
    made = message(
        tmp_path,
        "{name: MODE, type: Mode, summary: S.}",
        "{name: A, type: u16, when: {field: MODE, is: [MODE_ON]}, summary: S.}",
        "{name: B, type: u8, summary: S.}",
    )
    assert [i.offset for i in made.leaves] == [0, 1, None]
    assert (made.min_size, made.max_size) == (2, 4)
    when = made.fields[1].when
    assert when is not None
    assert (when.source, when.from_context, when.may_be_missing) == ("mode", False, False)
    assert [value.name for value in when.values] == ["MODE_ON"]


def test_condition_by_flags_has_their_mask(tmp_path: Path) -> None:
    made = message(
        tmp_path,
        "{name: OPTIONS, type: Options, summary: S.}",
        "{name: A, type: u8, when: {field: OPTIONS, has: [OPTION_FAST, OPTION_FINE]}, summary: S.}",
    )
    when = made.fields[1].when
    assert when is not None and when.mask == 0x81


def test_limits_are_raw_values(tmp_path: Path) -> None:
    made = field(
        tmp_path,
        '{name: A, type: Speed, range: -100..100, special: {-32768: "undefined"}, summary: S.}',
    )
    assert (made.minimum, made.maximum) == (Fraction(-100), Fraction(100))
    assert [(s.value, s.meaning) for s in made.special] == [(-32768, "undefined")]


@pytest.mark.parametrize("mark", ["special_in_range: true, ", ""])
def test_special_value_at_the_edge_of_the_type_needs_no_range(mark: str, tmp_path: Path) -> None:
    made = field(tmp_path, f"{{name: A, type: u8, {mark}special: {{255: none}}, summary: S.}}")
    assert (made.minimum, made.maximum) == (None, None)


def test_alternative_unit(tmp_path: Path) -> None:
    made = message(
        tmp_path,
        "{name: OPTIONS, type: Options, summary: S.}",
        "{name: SPEED, type: Speed, summary: S., "
        "alternative: {type: FineSpeed, of: OPTIONS, flag: OPTION_FINE}}",
    )
    other = made.fields[1].alternative
    assert other is not None
    assert (other.quantity.name, other.source, other.mask) == ("FineSpeed", "options", 0x80)


def test_names_and_marks(tmp_path: Path) -> None:
    made = field(
        tmp_path,
        "{name: CLASS, as: category, type: u8, align: 64, since: {firmware: 2.55b5, board: 3.0}, "
        "deprecated: {since: {firmware: 2.60}}, replaced_by: COUNT, errata: [E001], summary: S.}",
    )
    assert (made.name, made.spec_name, made.align) == ("category", "CLASS", 64)
    assert (made.since.firmware, made.since.board) == (2555, 30)
    assert made.deprecated is not None
    assert (made.deprecated.since.firmware, made.deprecated.replaced_by) == (2600, "COUNT")
    assert made.errata == ("E001",)


def test_largest_body_fits_and_one_byte_more_does_not(tmp_path: Path) -> None:
    assert message(tmp_path, "{reserved: 255}").max_size == 255
