"""What firmware really does to a protocol is put into the right class: most of it breaks nothing."""

from __future__ import annotations

from pathlib import Path

import pytest

from sbgcgen.build import load_layout
from sbgcgen.compat.changes import Level
from sbgcgen.compat.compare import compare
from sbgcgen.compat.report import describe
from support import write_spec

WIRE, MEANING, SOURCE, OK = Level.WIRE, Level.MEANING, Level.SOURCE, Level.COMPATIBLE

OLD = """\
family: probe
summary: Messages that grow.

commands:
  CMD_STATE:
    id: 10
    summary: State of everything.
    from_board:
      source: Incoming commands L50
      fields:
        - {name: MODE, type: Mode, summary: What it does.}
        - {name: LOW,  type: u8, summary: Lowest.}
        - {name: HIGH, type: u8, summary: Highest.}
        - {name: OPAQUE, type: "bytes[3]", summary: Unknown.}
        - {reserved: 4}

  CMD_STREAM:
    id: 11
    summary: Stream.
    to_board:
      source: Outgoing commands L61
      effect: sets
      answer: none
      fields:
        - {name: MODE, type: Mode, summary: What to stream.}
        - name: CONFIG
          struct: Config
          size: 4
          summary: How.
          fields:
            - {name: RATE,  type: u16, when: {field: MODE, is: MODE_ON}, summary: How fast.}
            - {name: LIMIT, type: u8,  when: {field: MODE, is: MODE_ON}, summary: How much.}

  CMD_LIST:
    id: 12
    summary: A list.
    from_board:
      source: Incoming commands L52
      fields:
        - {name: NUM, type: u8, summary: How many.}
        - {name: "ITEM[NUM]", type: u8, summary: The elements.}

  CMD_DO:
    id: 13
    summary: Do something.
    to_board:
      source: Outgoing commands L63
      effect:
        - {when: {field: MODE, is: MODE_OFF}, does: reads}
        - {does: moves}
      answer: none
      fields:
        - {name: MODE, type: Mode, summary: What to do.}
"""

STATE_END = "        - {reserved: 4}\n"
SINCE = "since: {firmware: 2.59}"
OPAQUE = '        - {name: OPAQUE, type: "bytes[3]", summary: Unknown.}\n'
LIMIT = (
    "            - {name: LIMIT, type: u8,  when: {field: MODE, is: MODE_ON}, summary: How much.}\n"
)
RATE = (
    "            - {name: RATE,  type: u16, when: {field: MODE, is: MODE_ON}, summary: How fast.}\n"
)
CASE = "            - {name: OTHER, type: u32, when: {field: MODE, is: MODE_OFF}, summary: New.}\n"
SAME_CASE = (
    "            - {name: OTHER, type: u8, when: {field: MODE, is: MODE_ON}, summary: New.}\n"
)
MODE_ON = "MODE_ON:  {value: 1, summary: Something.}"
LOW = "{name: LOW,  type: u8, summary: Lowest.}"

# The edits as pairs of old and new text, and the expected class and text of the report.
Edits = list[tuple[str, str]]
CASES: dict[str, tuple[Edits, Level, str]] = {
    "field appended": (
        [(STATE_END, STATE_END + f"        - {{name: MORE, type: u16, {SINCE}, summary: New.}}\n")],
        OK,
        "State.MORE: none → u16 at the end",
    ),
    "reserved bytes named by a later firmware": (
        [
            (STATE_END, f"        - {{name: MORE, type: u32, {SINCE}, summary: New.}}\n"),
            (
                "      source: Incoming commands L50\n",
                "      source: Incoming commands L50\n      size: 10\n",
            ),
        ],
        OK,
        "State.MORE: none → u32 in reserved bytes",
    ),
    "size of every firmware stated": (
        [
            (
                "      source: Incoming commands L50\n",
                "      source: Incoming commands L50\n      size: 10\n",
            )
        ],
        OK,
        "",
    ),
    "bytes without a meaning named": (
        [
            (
                OPAQUE,
                "        - {name: A, type: u8, summary: A.}\n        - {name: B, type: u16, summary: B.}\n",
            )
        ],
        SOURCE,
        "State.OPAQUE: bytes[3], which has names now → deleted",
    ),
    "bytes without a meaning named in part": (
        [(OPAQUE, "        - {name: A, type: u8, summary: A.}\n        - {reserved: 2}\n")],
        SOURCE,
        "State.OPAQUE",
    ),
    "bytes without a meaning replaced by fewer": (
        [(OPAQUE, "        - {name: A, type: u8, summary: A.}\n")],
        WIRE,
        "State.OPAQUE: bytes[3] → deleted",
    ),
    "case added to a union": (
        [(LIMIT, LIMIT + CASE)],
        OK,
        "Config.OTHER: none → u32 if mode is MODE_OFF",
    ),
    "case added before others": (
        [(RATE, CASE + RATE)],
        OK,
        "Config.OTHER: none → u32 if mode is MODE_OFF",
    ),
    "field added to the same case": ([(LIMIT, LIMIT + SAME_CASE)], OK, "Config.OTHER"),
    "field inserted into the same case": (
        [(LIMIT, SAME_CASE + LIMIT)],
        WIRE,
        "Config.LIMIT: place",
    ),
    "case deleted": ([(LIMIT, "")], WIRE, "Config.LIMIT: u8 → deleted"),
    "case under another value": (
        [
            (
                "when: {field: MODE, is: MODE_ON}, summary: How much",
                "when: {field: MODE, is: MODE_OFF}, summary: How much",
            )
        ],
        WIRE,
        "Config.LIMIT: when",
    ),
    "enum value added": (
        [(MODE_ON, f"{MODE_ON}\n      MODE_NEW: {{value: 2, {SINCE}, summary: New.}}")],
        OK,
        "MODE_NEW",
    ),
    "effect of a new value": (
        [
            (MODE_ON, f"{MODE_ON}\n      MODE_NEW: {{value: 2, summary: New.}}"),
            (
                "        - {when: {field: MODE, is: MODE_OFF}, does: reads}\n",
                "        - {when: {field: MODE, is: [MODE_OFF, MODE_NEW]}, does: reads}\n",
            ),
        ],
        OK,
        "message Do: effect",
    ),
    "effect of an old value": (
        [
            (
                "        - {when: {field: MODE, is: MODE_OFF}, does: reads}\n",
                "        - {when: {field: MODE, is: MODE_OFF}, does: sets}\n",
            )
        ],
        MEANING,
        "message Do: effect of MODE_OFF: reads → sets",
    ),
    "form added": (
        [
            (
                "      effect:\n        - {when: {field: MODE, is: MODE_OFF}, does: reads}\n        - {does: moves}\n      answer: none\n"
                "      fields:\n        - {name: MODE, type: Mode, summary: What to do.}\n",
                "      effect: moves\n      answer: none\n      forms:\n        simple:\n          summary: One.\n"
                "          effect:\n            - {when: {field: MODE, is: MODE_OFF}, does: reads}\n            - {does: moves}\n"
                "          fields:\n            - {name: MODE, type: Mode, summary: What to do.}\n"
                "        longer:\n          summary: Two.\n          fields:\n            - {name: MODE, type: Mode, summary: What to do.}\n"
                "            - {name: MORE, type: u8, summary: New.}\n",
            )
        ],
        OK,
        "message DoLonger: none → to_board",
    ),
    "field renamed, the old name kept": (
        [(LOW, "{name: LEAST, was: LOW, type: u8, summary: Lowest.}")],
        OK,
        "State.LEAST: name: LOW → LEAST",
    ),
    "enum value renamed, the old name kept": (
        [
            (MODE_ON, "MODE_QUICK: {value: 1, was: MODE_ON, summary: Fast.}"),
            ("is: MODE_ON", "is: MODE_QUICK"),
        ],
        OK,
        "enum Mode.MODE_ON: MODE_ON → MODE_QUICK",
    ),
    "command renamed, the old name kept": (
        [
            ("  CMD_LIST:\n", "  CMD_ITEMS:\n    was: CMD_LIST\n"),
            (
                "      source: Incoming commands L52\n",
                "      source: Incoming commands L52\n      as: List\n",
            ),
        ],
        OK,
        "command CMD_LIST: name: CMD_LIST → CMD_ITEMS",
    ),
    "default": (
        [(LOW, "{name: LOW,  type: u8, default: 5, summary: Lowest.}")],
        MEANING,
        "State.LOW: default: 0 → 5",
    ),
    "constant": (
        [(LOW, "{name: LOW,  type: u8, constant: 0, summary: Lowest.}")],
        MEANING,
        "State.LOW: constant: no → yes",
    ),
    "rule": (
        [
            (
                "      source: Incoming commands L50\n",
                '      source: Incoming commands L50\n      rules: ["LOW <= HIGH"]\n',
            )
        ],
        MEANING,
        "State: rule: none → low <= high",
    ),
    "unconfirmed": (
        [(LOW, "{name: LOW,  type: u8, unconfirmed: true, summary: Lowest.}")],
        OK,
        "State.LOW: unconfirmed: no → yes",
    ),
    "former meaning": (
        [
            (
                MODE_ON,
                "MODE_ON: {value: 1, before: {firmware: 2.59, summary: Slow.}, summary: Fast.}",
            )
        ],
        MEANING,
        "enum Mode.MODE_ON: before: none → Slow.",
    ),
    "version of a field": (
        [
            (LOW, f"{{name: LOW,  type: u8, {SINCE}, summary: Lowest.}}"),
            (
                "      source: Incoming commands L50\n",
                "      source: Incoming commands L50\n      size: 10\n",
            ),
        ],
        MEANING,
        "State.LOW: since: always → firmware 2.59",
    ),
    "counter in bytes": (
        [('"ITEM[NUM]", type: u8,', '"ITEM[NUM]", type: u8, counted_in: bytes,')],
        WIRE,
        "List.ITEM: counted in: elements → bytes",
    ),
    "counter off by one": (
        [('"ITEM[NUM]", type: u8,', '"ITEM[NUM]", type: u8, counted_from: 1,')],
        WIRE,
        "List.ITEM: counted in: elements → minus_1",
    ),
    "wider number": (
        [(LOW, "{name: LOW,  type: u24, summary: Lowest.}")],
        WIRE,
        "State.LOW: type: u8 → u24",
    ),
}


def _spec(folder: Path, edits: Edits) -> Path:
    spec = write_spec(folder, OLD)
    for before, after in edits:
        files = [path for path in spec.glob("*.yaml") if before in path.read_text(encoding="utf-8")]
        assert files, f"nothing to edit: {before}"
        for path in files:
            text = path.read_text(encoding="utf-8")
            path.write_text(text.replace(before, after), encoding="utf-8")
    return spec


@pytest.mark.parametrize("name", CASES)
def test_growth_is_put_into_its_class(name: str, tmp_path: Path) -> None:
    edits, level, words = CASES[name]
    old, new = _spec(tmp_path / "old", []), _spec(tmp_path / "new", edits)
    found = [(c.level, describe(c)) for c in compare(load_layout(old), load_layout(new))]
    if not words:
        assert found == []
        return
    assert any(at is level and words in text for at, text in found), found
    assert found[0][0] is level, f"it breaks more than it should: {found}"


def test_what_was_appended_must_stay_optional(tmp_path: Path) -> None:
    more = "        - {name: MORE, type: u16, summary: New.}\n"
    old = _spec(tmp_path / "old", CASES["field appended"][0])
    new = _spec(tmp_path / "new", [(STATE_END, STATE_END + more)])
    found = [(c.level, describe(c)) for c in compare(load_layout(old), load_layout(new))]
    assert found[0][0] is WIRE and "State.MORE: may be absent: yes → no" in found[0][1]
