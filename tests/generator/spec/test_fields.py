"""Tests of fields: repetition, offsets, sizes, and the leaves with their paths and names."""

from __future__ import annotations

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


def test_structs_in_structs(tmp_path: Path) -> None:
    made = message(
        tmp_path,
        'name: "outer[2]"\n          struct: Outer\n          summary: S.\n          fields:\n'
        '            - {name: "inner[2]", type: Pair, summary: S.}\n'
        "            - {reserved: 1}",
    )
    inner = "inner[0].first inner[0].second inner[1].first inner[1].second reserved".split()
    paths = [f"outer[{i}].{path}" for i in range(2) for path in inner]
    assert [leaf.path for leaf in made.leaves] == paths
    assert [leaf.offset for leaf in made.leaves] == [0, 1, 3, 4, 6, 7, 8, 10, 11, 13]


def test_reserved_bytes_are_numbered_only_if_there_are_several(tmp_path: Path) -> None:
    number = "{name: A, type: u8, summary: S.}"
    one = message(tmp_path / "one", "{reserved: 3}", number)
    assert leaves(one)[0] == ("reserved", "RESERVED", "bytes", 3, 0)
    spare = '{name: SPARE, type: "bytes[2]", reserved: true}'
    two = message(tmp_path / "two", "{reserved: 3}", number, spare, "{reserved: 2}")
    assert [i.path for i in two.leaves] == ["reserved_1", "a", "spare", "reserved_2"]
    assert [i.field.reserved for i in two.leaves] == [True, False, True, True]


def test_list_counted_by_an_earlier_field(tmp_path: Path) -> None:
    made = message(
        tmp_path,
        "{name: N, type: u8, range: 0..4, summary: S.}",
        '{name: "items[N]", type: Pair, summary: S.}',
        "{name: AFTER, type: u8, summary: S.}",
    )
    offsets = [(leaf.path, leaf.offset) for leaf in made.leaves]
    # The first element of a list has a fixed offset.
    fixed = [("n", 0), ("items[].first", 1), ("items[].second", 2), ("after", None)]
    assert offsets == fixed
    assert [f.is_counter for f in made.fields] == [True, False, False]
    assert made.fields[1].counter == "n"
    assert (made.min_size, made.max_size) == (2, 2 + 4 * 3)


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


@pytest.mark.parametrize("mark", ["special_in_range: true, ", ""])
def test_special_value_at_the_edge_of_the_type_needs_no_range(mark: str, tmp_path: Path) -> None:
    made = field(tmp_path, f"{{name: A, type: u8, {mark}special: {{255: none}}, summary: S.}}")
    assert (made.minimum, made.maximum) == (None, None)


def test_largest_body_fits_and_one_byte_more_does_not(tmp_path: Path) -> None:
    assert message(tmp_path, "{reserved: 255}").max_size == 255
