"""Tests of quantities, enums, flag sets, packed integers and variables."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest

from sbgcgen.spec.resolve.types import parse_bits
from support import layout_of

TYPES = """\
family: probe
summary: Types.

quantities:
  Power:
    {type: u16, unit: W, accessor: watts, scale: 4000/32767, offset: -0.5, summary: Power.}
  Decimal:
    {type: u8, unit: null, scale: 0.02, summary: A ratio.}

enums:
  Sort:
    type: i8
    prefix: SORT_
    summary: Some values.
    source: Variables L7
    errata: [E001]
    values:
      SORT_UP:   {value: 1, summary: Upwards.}
      SORT_DOWN: {value: -1, since: {board: 3.0}, summary: Downwards.}
      OTHER:     {value: 100, as: "none", ours: true, summary: Neither.}

flags:
  Switches:
    type: u16
    summary: Some bits.
    source: Variables L8
    values:
      LOW:  {value: 0x0001, summary: The lowest.}
      HIGH: {value: 0x8000, summary: The highest.}

packed:
  Byte:
    type: u8
    summary: Three parts.
    source: Variables L9
    parts:
      - {name: low, bits: 0..2, summary: Low.}
      - {name: single, bits: 3, summary: One bit.}
      - {name: high, mask: 0xF0, summary: High.}
  Version:
    type: u16
    summary: Digits.
    source: Variables L10
    display: "{major}.{minor:02}"
    parts:
      - {name: major, divide: 1000, summary: Major.}
      - {name: minor, divide: 10, modulo: 100, summary: Minor.}

variables:
  GAIN: {id: 3, type: Power, range: 0..65535, summary: A gain.}

commands:
  CMD_ALL:
    id: 200
    summary: Uses them all.
    to_board:
      source: L11
      effect: reads
      answer: none
      fields:
        - {name: DECIMAL,  type: Decimal,  summary: A ratio.}
        - {name: SORT,     type: Sort,     summary: A value.}
        - {name: SWITCHES, type: Switches, summary: Bits.}
        - {name: BYTE,     type: Byte,     summary: Parts.}
        - {name: VERSION,  type: Version,  summary: Digits.}
"""

SETTINGS = """\
family: probe
summary: A setting that variables stand for.
variables:
  LIMIT: {id: 3, type: FineSpeed, range: -1000..10000, sets: Settings.limit, summary: In finer steps.}
  SAME: {id: 4, type: Speed, range: -10..100, sets: Settings.limit, summary: In the same steps.}
commands:
  CMD_SETTINGS:
    id: 9
    summary: Settings.
    from_board:
      source: L1
      as: Settings
      fields:
        - name: LIMIT
          type: Speed
          range: -100..100
          special: {0: no limit, 100: the highest there is}
          special_in_range: true
          summary: A limit.
    to_board:
      source: L1
      effect: reads
      summary: Ask for it.
      answer: {message: Settings}
  CMD_STORE_SETTINGS:
    id: 12
    summary: Store them.
    to_board:
      source: L1
      effect: reads
      answer: {confirm: always}
      same_as: Settings
      stores: Settings
"""


def test_quantities_are_exact(tmp_path: Path) -> None:
    by_name = {q.name: q for q in layout_of(tmp_path, TYPES).quantities}
    power = by_name["Power"]
    assert (power.scale, power.offset) == (Fraction(4000, 32767), Fraction(-1, 2))
    assert (power.unit, power.accessor, power.scalar.name) == ("W", "watts", "u16")
    assert by_name["Decimal"].scale == Fraction(1, 50), "not the nearest binary fraction"
    assert by_name["Decimal"].unit is None
    assert by_name["Angle"].scale == Fraction(45, 2048)


def test_enum(tmp_path: Path) -> None:
    layout = layout_of(tmp_path, TYPES)
    sort = next(e for e in layout.enums if e.name == "Sort")
    assert (sort.kind, sort.scalar.name, sort.errata) == ("enum", "i8", ("E001",))
    assert [(v.name, v.identifier, v.value, v.ours) for v in sort.values] == [
        ("SORT_UP", "up", 1, False),
        ("SORT_DOWN", "down", -1, False),
        ("OTHER", "none", 100, True),
    ]
    assert sort.values[1].since.board == 30


def test_flags(tmp_path: Path) -> None:
    layout = layout_of(tmp_path, TYPES)
    switches = next(e for e in layout.enums if e.name == "Switches")
    assert (switches.kind, switches.member, switches.scalar.size) == ("flags", "Switch", 2)
    assert [v.value for v in switches.values] == [0x0001, 0x8000]


def test_command_ids_are_an_enum_in_the_order_of_ids(tmp_path: Path) -> None:
    more = TYPES + "  CMD_LAST: {id: 255, summary: Last., undocumented: true}\n"
    layout = layout_of(tmp_path, more)
    to_board, from_board = (
        [(v.name, v.identifier, v.value) for e in layout.enums if e.name == name for v in e.values]
        for name in ("CommandToBoard", "CommandFromBoard")
    )
    last = ("CMD_LAST", "last", 255)  # its direction is unknown
    assert to_board == [
        ("CMD_PING", "ping", 1),
        ("CMD_USE", "use", 199),
        ("CMD_ALL", "all", 200),
        last,
    ]
    assert from_board == [("CMD_PING", "ping", 1), last]


def test_flags_that_extend_others(tmp_path: Path) -> None:
    wide = """
  Wide:
    type: u32
    extends: Switches
    summary: The same bits, and more.
    source: Variables L9
    values:
      FAR: {value: 0x10000, summary: Beyond.}

packed:
"""
    text = TYPES.replace("\npacked:\n", wide)
    text = text.replace("type: Switches,", "type: Wide,", 1)
    made = {e.name: e for e in layout_of(tmp_path, text).enums}["Wide"]
    assert (made.scalar.name, made.kind, made.member) == ("u32", "flags", "WideBit")
    assert [(v.name, v.value) for v in made.values] == [
        ("LOW", 0x0001),
        ("HIGH", 0x8000),
        ("FAR", 0x10000),
    ]


def test_packed_by_bits(tmp_path: Path) -> None:
    layout = layout_of(tmp_path, TYPES)
    byte = next(p for p in layout.packed if p.name == "Byte")
    assert [(p.name, p.mask, p.shift, p.is_bool) for p in byte.parts] == [
        ("low", 0x07, 0, False),
        ("single", 0x08, 3, True),
        ("high", 0xF0, 0, False),  # a mask does not shift the value
    ]


def test_packed_by_digits(tmp_path: Path) -> None:
    layout = layout_of(tmp_path, TYPES)
    version = next(p for p in layout.packed if p.name == "Version")
    assert [(p.is_digits, p.divide, p.modulo) for p in version.parts] == [
        (True, 1000, 0),
        (True, 10, 100),
    ]
    assert version.display == "{major}.{minor:02}"


def test_variable(tmp_path: Path) -> None:
    (variable,) = layout_of(tmp_path, TYPES).variables
    assert (variable.name, variable.identifier, variable.id) == ("GAIN", "gain", 3)
    assert (variable.scalar.name, variable.minimum, variable.maximum) == ("u16", 0, 65535)
    assert variable.quantity is not None and variable.quantity.name == "Power"


def test_value_of_a_variable_is_no_special_one_by_rounding(tmp_path: Path) -> None:
    variable = next(v for v in layout_of(tmp_path, SETTINGS).variables if v.name == "LIMIT")
    (setting,) = variable.settings
    values = [-150, -60, -50, -10, -1, 0, 1, 10, 49, 50, 60, 150]
    assert [setting.count(v) for v in values] == [-2, -1, -1, -1, -1, 0, 1, 1, 1, 1, 1, 2]
    assert setting.count(9951) == setting.count(9999) == 99, "as near as allowed"
    assert setting.count(10000) == 100, "exactly the special one"


def test_value_of_a_variable_in_steps_of_the_setting_is_always_exact(tmp_path: Path) -> None:
    variable = next(v for v in layout_of(tmp_path, SETTINGS).variables if v.name == "SAME")
    (setting,) = variable.settings
    assert setting.special == ()
    assert [setting.count(v) for v in (-1, 0, 1, 100)] == [-1, 0, 1, 100]


@pytest.mark.parametrize(
    ("text", "bits"), [(3, (3, 3)), ("3", (3, 3)), ("0..2", (0, 2)), ("6..7", (6, 7))]
)
def test_bits(text: int | str, bits: tuple[int, int]) -> None:
    assert parse_bits(text) == bits
