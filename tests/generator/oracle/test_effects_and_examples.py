"""Tests of the words for effects, of examples that change what was read, and of the history."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

from sbgcgen.build import load_protocol
from sbgcgen.model import USUAL_EFFECTS, Layout
from sbgcgen.model.export import export
from sbgcgen.oracle.example import example_of
from sbgcgen.oracle.vectors import typical_vector
from sbgcgen.targets import codes_of
from sbgcgen.targets.site.view import Revisions
from support import GENERATOR, PROJECT, layout_of, message_of, write_spec

SETTINGS = """\
family: probe
summary: Settings.
commands:
  CMD_READ:
    id: 20
    summary: Settings.
    from_board:
      source: L1
      example: {"limits[1].max": 40}
      fields:
        - {name: COPY, type: u8, range: 0..4, role: copy, summary: Which.}
        - {name: VOLUME, type: u8, typical: 100, summary: How loud.}
        - name: "limits[2]"
          struct: Limits
          summary: Limits.
          fields:
            - {name: MIN, type: i8, typical: -20, summary: Lowest.}
            - {name: MAX, type: i8, typical: 20, summary: Highest.}
    to_board:
      source: L1
      effect: reads
      summary: Ask.
      answer: {message: Read}
      fields:
        - {name: COPY, type: u8, range: 0..4, role: copy, summary: Which.}
  CMD_WRITE:
    id: 21
    summary: Store them.
    to_board:
      source: L1
      effect: stores
      answer: {confirm: always}
      same_as: Read
      stores: Read
      example: {volume: 0, "limits[0].min": -30}
"""


def typical_fields(layout: Layout, name: str) -> Any:
    return typical_vector(message_of(layout, name)).fields


def cpp_of(layout: Layout) -> list[str]:
    """The lines of the example in C++ that change the message."""
    example = example_of(message_of(layout, "Write"), layout)
    lines = next(c for c in codes_of(example) if c.word == "cpp").text.splitlines()
    assert "sbgc::msg::Write message{read};" in lines
    return [line for line in lines if line.startswith("message.")]


def test_what_is_written_is_what_was_read_but_for_the_example(tmp_path: Path) -> None:
    layout = layout_of(tmp_path, SETTINGS)
    read, write = typical_fields(layout, "Read"), typical_fields(layout, "Write")
    assert read == {
        "copy": 0,
        "volume": 100,
        "limits": [{"min": -20, "max": 20}, {"min": -20, "max": 40}],
    }
    assert write == {
        "copy": 0,
        "volume": 0,
        "limits": [{"min": -30, "max": 20}, {"min": -20, "max": 40}],
    }
    example = example_of(message_of(layout, "Write"), layout)
    assert example.changed == {"volume", "limits[0].min"}
    assert cpp_of(layout) == ["message.volume = 0;", "message.limits[0].min = -30;"]


def test_single_bytes_of_what_was_read_are_changed(tmp_path: Path) -> None:
    old = "        - {name: VOLUME, type: u8, typical: 100, summary: How loud.}\n"
    new = '        - {name: KEY, type: "bytes[16]", typical: "0a0b0c", summary: A key.}\n'
    changes = 'example: {key: "0a0b0d", "limits[0].min": -30}'
    text = SETTINGS.replace(old, new).replace('example: {volume: 0, "limits[0].min": -30}', changes)
    assert cpp_of(layout_of(tmp_path, text)) == [
        "message.key[2] = 0x0D;",
        "message.limits[0].min = -30;",
    ]


def test_history_names_what_came(tmp_path: Path) -> None:
    spec = write_spec(tmp_path, SETTINGS)
    main = (spec / "simplebgc.yaml").read_text(encoding="utf-8")
    history = (
        'revisions:\n  "0.9": {date: 2026-01-30, source: L1}\n'
        '  "0.10": {date: 2026-01-31, source: L2, adds: [CMD_WRITE, Read.limits, Mode.MODE_ON],'
        " changes: [More of it.]}\n\n"
    )
    (spec / "simplebgc.yaml").write_text(main.replace("families:", history + "families:"))
    layout = load_protocol(spec).layout
    assert [r.number for r in layout.revisions] == ["0.9", "0.10"]
    revisions = Revisions(layout)
    found = revisions.of("field", "Read", "limits[0].min")
    assert found is not None and found.number == "0.10"
    assert revisions.of_message(message_of(layout, "Write")) is found
    assert revisions.of("value", "Mode", "MODE_OFF") is None
    assert export(layout)["revisions"][1]["adds"] == ["CMD_WRITE", "Read.limits", "Mode.MODE_ON"]


def test_the_words_for_effects_are_the_same_everywhere() -> None:
    words = [kind.word for kind in USUAL_EFFECTS]
    schema = json.loads((GENERATOR / "schema" / "sbgc-spec.schema.json").read_text("utf-8"))
    assert schema["$defs"]["effect_word"]["examples"] == words
    header = (PROJECT / "generated/include/sbgc/protocol.hpp").read_text("utf-8")
    enum = header[header.index("enum class Effect ") :].partition("};")[0]
    assert re.findall(r"^  (\w+) = 0x", enum, re.MULTILINE) == words
    guide = (PROJECT / "docs/2-safety.md").read_text("utf-8")
    assert re.findall(r"^\| ([a-z]+) \| [A-Z]", guide, re.MULTILINE) == words
