"""Tests of scales, flags that extend others, variables that stand for settings, and bits."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

from support import layout_of

WIDE = """\
family: probe
summary: Types.
flags:
  Wide:
    type: u32
    extends: Options
    summary: The same bits, and more.
    source: Variables L9
    values:
      FAR: {value: 0x10000, summary: Beyond.}
quantities:
  Decimal: {type: u8, unit: null, scale: 0.02, summary: A ratio.}
commands:
  CMD_ALL:
    id: 200
    summary: Uses them all.
    to_board:
      source: L11
      effect: reads
      answer: none
      fields:
        - {name: DECIMAL, type: Decimal, summary: A ratio.}
        - {name: WIDE, type: Wide, summary: Bits.}
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


def test_scales_are_exact(tmp_path: Path) -> None:
    by_name = {q.name: q for q in layout_of(tmp_path, WIDE).quantities}
    assert by_name["Decimal"].scale == Fraction(1, 50), "not the nearest binary fraction"


def test_flags_that_extend_others(tmp_path: Path) -> None:
    made = {e.name: e for e in layout_of(tmp_path, WIDE).enums}["Wide"]
    assert (made.scalar.name, made.kind, made.member) == ("u32", "flags", "WideBit")
    values = [("OPTION_FAST", 0x01), ("OPTION_FINE", 0x80), ("FAR", 0x10000)]
    assert [(v.name, v.value) for v in made.values] == values


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
