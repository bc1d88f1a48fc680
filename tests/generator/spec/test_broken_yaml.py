"""Broken YAML is generated from, or refused with findings that name a place: no traceback, no hang."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from broken_yaml import LIMIT, broken, outcome
from sbgcgen.build import load_protocol
from sbgcgen.targets import outputs
from support import HERE, findings, write_spec

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


@pytest.mark.parametrize("part", range(4))
def test_a_small_spec(part: int, tmp_path: Path) -> None:
    spec = write_spec(tmp_path, SPEC, "base.yaml")
    contents = {path: path.read_bytes() for path in sorted(spec.iterdir())}
    # Most of what can be said is in this file.
    files = [spec / "base.yaml"] * 4 + list(contents)
    refused = 0
    for seed in range(part, 300, 4):
        file = files[seed // 4 % len(files)]
        file.write_bytes(broken(seed, contents[file]))
        if outcome(spec):
            refused += 1
        else:
            assert outputs(load_protocol(spec).layout, tmp_path)
        file.write_bytes(contents[file])
    assert refused > 40


def test_what_a_finding_quotes_is_one_short_line(tmp_path: Path) -> None:
    text = f'family: probe\n"key\\e[31m\\nnext\\u202e": 1\ncommands: {"x" * 5000}\n'
    found = findings(tmp_path, text)
    for finding in found:
        assert finding.message.isprintable() and len(finding.message) < 1200
    assert any("key\\x1b[31m\\nnext\\u202e" in finding.message for finding in found)
    assert any("not 'xxx" in finding.message for finding in found)


@pytest.mark.parametrize("text", ["{}\n", "# nothing\n{}\n"])
def test_an_empty_mapping_is_no_spec_file(text: str, tmp_path: Path) -> None:
    assert [finding.code for finding in findings(tmp_path, text)] == ["SBGC001"]


def test_the_time_per_finding_does_not_grow(tmp_path: Path) -> None:
    """Comparing each finding with all others would take minutes."""
    lines = "".join(f"key{number}: 1\n" for number in range(20_000))
    start = time.monotonic()
    assert len(findings(tmp_path, "family: probe\nsummary: A family.\n" + lines)) == 20_000
    assert time.monotonic() - start < LIMIT
