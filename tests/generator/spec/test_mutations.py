"""A spec with any typing error is generated from or reported; the generator never crashes."""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from pathlib import Path

import pytest

from sbgcgen.build import load_protocol
from sbgcgen.spec.diagnostics import SpecError
from sbgcgen.targets import outputs
from support import HERE, write_spec

SPEC = (
    (HERE / "minimal" / "base.yaml").read_text(encoding="utf-8")
    + """\
  CMD_SHAPES:
    id: 2
    since: {firmware: 2.60, board: 3.0}
    summary: Everything that a body can hold.
    to_board:
      source: Outgoing commands L50-L60
      effect: reads
      errata: [E001]
      answer: {confirm: always, retry: safe}
      forms:
        simple:
          summary: Short.
          fields:
            - {name: MODE, type: Mode, summary: A mode.}
            - name: "axes[axis]"
              struct: Target
              summary: Targets.
              fields:
                - {name: "SPEED_{AXIS}", type: Speed, range: -100..100, summary: A speed.}
            - {name: A, type: u16, when: {field: MODE, is: MODE_ON}, summary: A number.}
        extended:
          summary: Long.
          fields:
            - {name: OPTIONS, type: Options, summary: Options.}
            - {name: S, type: Speed, alternative: {type: FineSpeed, of: OPTIONS, flag: OPTION_FINE}, summary: S.}
            - {name: "B[3]", type: Angle, special: {-32768: undefined}, summary: Numbers.}
            - {name: "SERVO{1..4}", type: u8, summary: Numbers.}
            - {name: N, type: u8, range: 0..4, summary: How many.}
            - {name: "pairs[N]", type: Pair, summary: Pairs.}
            - {reserved: 3}
            - {name: DATA, type: "bytes[]", max_count: 9, summary: The rest.}
"""
)
TOKENS = [
    "0",
    "-1",
    "256",
    "99999999999",
    "null",
    "[]",
    "{}",
    "Pair",
    "Shapes",
    "MODE",
    "u8",
    "class",
]
Mutation = Callable[[random.Random, list[str], int], None]


def _drop(_: random.Random, lines: list[str], at: int) -> None:
    del lines[at]


def _copy(chance: random.Random, lines: list[str], at: int) -> None:
    lines.insert(at, chance.choice(lines))


def _indent(chance: random.Random, lines: list[str], at: int) -> None:
    lines[at] = " " * chance.choice((1, 2, 4)) + lines[at]


def _outdent(_: random.Random, lines: list[str], at: int) -> None:
    lines[at] = lines[at][2:]


def _mistype(chance: random.Random, lines: list[str], at: int) -> None:
    column = chance.randrange(len(lines[at]) + 1)
    letter = chance.choice("{}[]:,-#'\"|>&*!%@ x0")
    lines[at] = lines[at][:column] + letter + lines[at][column + chance.randrange(2) :]


def _exchange(chance: random.Random, lines: list[str], at: int) -> None:
    words = re.findall(r"[A-Za-z0-9_]+", lines[at])
    if words:
        others = TOKENS + re.findall(r"[A-Za-z0-9_]+", chance.choice(lines))
        lines[at] = lines[at].replace(chance.choice(words), chance.choice(others), 1)


@pytest.mark.parametrize("mutation", [_drop, _copy, _indent, _outdent, _mistype, _exchange])
def test_no_mistake_is_fatal(mutation: Mutation, tmp_path: Path) -> None:
    chance = random.Random(mutation.__name__)
    refused = 0
    for _ in range(50):
        lines = SPEC.split("\n")
        mutation(chance, lines, chance.randrange(len(lines)))
        spec = write_spec(tmp_path, "\n".join(lines), "base.yaml")
        try:
            layout = load_protocol(spec).layout
        except SpecError as error:
            refused += 1
            assert all(d.code and d.message and d.position.line for d in error.diagnostics)
        else:
            assert outputs(layout, tmp_path)
    assert refused > 0


def test_the_spec_itself_is_fine(tmp_path: Path) -> None:
    assert load_protocol(write_spec(tmp_path, SPEC, "base.yaml")).layout.messages
