"""Edits of compat/probe.yaml by class of change, and the expected report."""

from __future__ import annotations

from sbgcgen.compat.changes import Level
from support import HERE

OLD = (HERE / "compat" / "probe.yaml").read_text(encoding="utf-8")
BASE = (HERE / "minimal" / "base.yaml").read_text(encoding="utf-8")

WIRE, MEANING, SOURCE, OK = Level.WIRE, Level.MEANING, Level.SOURCE, Level.COMPATIBLE

# The edits as pairs of old and new text, and the expected class and text of the report.
Case = tuple[list[tuple[str, str]], Level, str]

RESERVED = "        - {reserved: 4}\n"
COUNT = "        - {name: COUNT,  type: u16, summary: How often.}\n"
LEVEL = (
    "        - {name: LEVEL,  type: u8, range: 0..100, special: {255: unknown}, "
    "summary: How full it is.}\n"
)
MORE_FIELD = "        - {name: MORE, type: u16, summary: New.}\n"
MORE_BYTE = "        - {name: MORE, type: u8, summary: New.}\n"
STATE = OLD[OLD.index("  CMD_STATE:") : OLD.index("  CMD_MOVE:")]
MOVE = OLD[OLD.index("  CMD_MOVE:") : OLD.index("  CMD_LIST:")]
EXTENDED = OLD[OLD.index("        extended:\n") : OLD.index("variables:")]
MORE_COMMAND = (
    "  CMD_MORE:\n    id: 14\n    summary: New.\n    to_board:\n      source: Outgoing L64\n      effect: reads\n"
    "      answer: none\n"
)

STORE_ENDS = (
    "          summary: Store everything.\n          until: {firmware: 2.59, instead: extended}\n"
)
TILT = "        - {name: TILT, type: i8, summary: Tilt.}\n"
STORE_STATE = (
    "  CMD_KEEP:\n    id: 14\n    summary: New.\n    to_board:\n      source: Outgoing L64\n      effect: reads\n"
    "      answer: none\n      same_as: State\n      stores: State\n"
)

CASES: dict[str, Case] = {
    # On the wire
    "command deleted": ([(MOVE, "")], WIRE, "command CMD_MOVE: 11 → deleted"),
    "message deleted": ([(MOVE, "")], WIRE, "message Move: to_board, 11 → deleted"),
    "form deleted": ([(EXTENDED, "")], WIRE, "message StoreExt: to_board, 13 → deleted"),
    "id": ([("id: 11", "id: 21")], WIRE, "command CMD_MOVE: id: 11 → 21"),
    "direction": (
        [
            (
                "    to_board:\n      source: Outgoing commands L61\n",
                "    from_board:\n      source: Outgoing commands L61\n",
            ),
            ("      answer: {confirm: always, retry: safe}\n", ""),
        ],
        WIRE,
        "message Move: direction: to_board → from_board",
    ),
    "form": (
        [("        extended:\n", "        error:\n")],
        WIRE,
        "message StoreError: form: extended → error",
    ),
    "type": ([("COUNT,  type: u16", "COUNT,  type: i16")], WIRE, "State.COUNT: type: u16 → i16"),
    "size": ([("COUNT,  type: u16", "COUNT,  type: u32")], WIRE, "State.COUNT: type: u16 → u32"),
    "array size": (
        [('"DATA[]", type: u8, max_count: 8', '"DATA[4]", type: u8')],
        WIRE,
        "StoreExt.DATA: elements: rest → 4",
    ),
    "field deleted": ([(LEVEL, "")], WIRE, "State.LEVEL: u8 → deleted"),
    "field became reserved": (
        [(LEVEL, "        - {reserved: 1}\n")],
        WIRE,
        "State.LEVEL: u8 → deleted",
    ),
    "offset": (
        [(LEVEL, ""), (RESERVED, LEVEL + RESERVED)],
        WIRE,
        "State.LEVEL: place: byte 2 → byte 14",
    ),
    "field inserted": ([(LEVEL, MORE_BYTE + LEVEL)], WIRE, "State.MORE: none → u8 in between"),
    "order": (
        [(RESERVED + COUNT, COUNT + RESERVED)],
        WIRE,
        "State.COUNT: place: byte 19 → byte 15",
    ),
    "reserved bytes fewer": (
        [("reserved: 4", "reserved: 3")],
        WIRE,
        "State.COUNT: place: byte 19 → byte 18",
    ),
    "behind a variable part": (
        [
            (
                "summary: Something more.}",
                "summary: Something more.}\n        - {name: LAST, type: u8, "
                "when: {field: OPTIONS, has: OPTION_FINE}, summary: Last.}",
            ),
        ],
        WIRE,
        "Move.LAST: none → u8 at the end, where no tail is accepted",
    ),
    "field added where no tail is kept": (
        [("How to do it.}\n\n  CMD_MOVE", "How to do it.}\n" + MORE_BYTE + "\n  CMD_MOVE")],
        WIRE,
        "StateRequest.MORE: none → u8 at the end, where no tail is accepted",
    ),
    "struct grown": (
        [
            (
                "How fast it turns.}",
                "How fast it turns.}\n      - {name: MORE, type: u8, summary: New.}",
            )
        ],
        WIRE,
        "struct AxisState.MORE: none → u8 at the end",
    ),
    "struct grown moves others": (
        [
            (
                "How fast it turns.}",
                "How fast it turns.}\n      - {name: MORE, type: u8, summary: New.}",
            )
        ],
        WIRE,
        "State.COUNT: place: byte 19 → byte 22",
    ),
    "condition's flag": ([("has: OPTION_FAST", "has: OPTION_FINE")], WIRE, "Move.EXTRA: when"),
    "condition gone": (
        [("when: {field: OPTIONS, has: OPTION_FAST}, ", "")],
        WIRE,
        "Move.EXTRA: when",
    ),
    "mask of a condition's flag": (
        [("OPTION_FAST: {value: 0x01", "OPTION_FAST: {value: 0x02")],
        WIRE,
        "Move.EXTRA: when",
    ),
    "type of an enum": (
        [
            ("Mode:\n    type: u8", "Mode:\n    type: u16"),
            ("type: Mode, summary: What to do.", "summary: What to do."),
            ("    main: mode\n", ""),
        ],
        WIRE,
        "enum Mode: type: u8 → u16",
    ),
    "type of a quantity": (
        [("{type: i16, unit: deg,", "{type: u16, unit: deg,")],
        WIRE,
        "quantity Angle: type: i16 → u16",
    ),
    "type of a packed integer": (
        [("Setup:\n    type: u8", "Setup:\n    type: u16")],
        WIRE,
        "packed Setup: type: u8 → u16",
    ),
    "tail refused": (
        [
            (
                "      source: Incoming commands L50\n",
                "      source: Incoming commands L50\n      tail: refuse\n",
            )
        ],
        WIRE,
        "message State: keeps its tail: yes → no",
    ),
    "start byte": ([("start: 0x3E", "start: 0x24")], WIRE, "framing v1: start: 62 → 36"),
    "order of the header": (
        [("header: [start, id, size,", "header: [start, size, id,")],
        WIRE,
        "framing v1: header: start, id, size, header_checksum → start, size, id, header_checksum",
    ),
    "bytes of a checksum": (
        [
            (
                "body_checksum: {kind: sum8, covers: [body]",
                "body_checksum: {kind: sum8, covers: [id, body]",
            )
        ],
        WIRE,
        "framing v1: body_checksum: covers: body → id, body",
    ),
    "variable's id": ([("TRIM: {id: 1", "TRIM: {id: 2")], WIRE, "variable TRIM: id: 1 → 2"),
    "variable's type": (
        [("TRIM: {id: 1, type: i8", "TRIM: {id: 1, type: i16")],
        WIRE,
        "variable TRIM: type: i8 → i16",
    ),
    "variable deleted": (
        [("  TRIM: {id: 1, type: i8, range: -100..100, summary: How skew.}\n", "")],
        WIRE,
        "variable TRIM: 1 → deleted",
    ),
    # In meaning
    "unit": ([("unit: deg,", "unit: rad,")], MEANING, "quantity Angle: unit: deg → rad"),
    "scale": (
        [("scale: 360/16384", "scale: 360/65536")],
        MEANING,
        "quantity Angle: scale: 45/2048 → 45/8192",
    ),
    "offset of a quantity": (
        [("scale: 360/16384,", "scale: 360/16384, offset: 1/2,")],
        MEANING,
        "quantity Angle: offset: 0 → 1/2",
    ),
    "quantity of a field": (
        [
            (
                "{name: SPEED, type: Speed, summary: How fast it",
                "{name: SPEED, type: FineSpeed, summary: How fast it",
            )
        ],
        MEANING,
        "struct AxisState.SPEED: scale: 1/10 → 1/1000",
    ),
    "direction of an axis": (
        [("{positive: down, negative: up}", "{positive: up, negative: down}")],
        MEANING,
        "direction of PITCH: down → up",
    ),
    "unit dropped": (
        [
            (
                "{name: SPEED, type: Speed, summary: How fast it",
                "{name: SPEED, type: i16, summary: How fast it",
            )
        ],
        MEANING,
        "struct AxisState.SPEED: unit: 1/10 deg/s → none",
    ),
    "value of an enum's name": (
        [("MODE_ON:  {value: 1", "MODE_ON:  {value: 2")],
        MEANING,
        "enum Mode.MODE_ON: 1 → 2",
    ),
    "name of an enum's value": (
        [("MODE_ON:  {value: 1", "MODE_STANDBY:  {value: 1")],
        MEANING,
        "enum Mode: 1: MODE_ON → MODE_STANDBY",
    ),
    "value of a flag": (
        [("OPTION_FINE: {value: 0x80", "OPTION_FINE: {value: 0x40")],
        MEANING,
        "flags Options.OPTION_FINE: 128 → 64",
    ),
    "range narrowed": (
        [("range: 0..100, special", "range: 0..90, special")],
        MEANING,
        "State.LEVEL: range: 0..100 → 0..90",
    ),
    "range invented": (
        [("COUNT,  type: u16", "COUNT,  type: u16, range: 0..9")],
        MEANING,
        "State.COUNT: range: 0..65535 → 0..9",
    ),
    "alignment": ([("align: 2", "align: 4")], MEANING, "StoreExt.WHAT: align: 2 → 4"),
    "role given": (
        [("COUNT,  type: u16", "COUNT,  type: u16, role: state")],
        MEANING,
        "State.COUNT: role: none → state",
    ),
    "fewer elements": (
        [("max_count: 8", "max_count: 7")],
        MEANING,
        "StoreExt.DATA: max_count: 8 → 7",
    ),
    "special value changed": (
        [("255: unknown", "255: empty")],
        MEANING,
        "State.LEVEL: special 255: unknown → empty",
    ),
    "special value removed": (
        [(" special: {255: unknown},", "")],
        MEANING,
        "State.LEVEL: special 255: unknown → none",
    ),
    "ordinary value made special": (
        [
            (
                "range: 0..100, special: {255: unknown}",
                "range: 0..99, special: {100: full, 255: unknown}",
            )
        ],
        MEANING,
        "State.LEVEL: special 100: none → full",
    ),
    "part moved": (
        [("bits: 4..6", "bits: 5..7")],
        MEANING,
        "packed Setup.level: (value & 0x70) >> 4 → (value & 0xe0) >> 5",
    ),
    "alternative unit": (
        [
            (
                "alternative: {type: FineSpeed, of: OPTIONS, flag: OPTION_FINE}",
                "alternative: {type: FineSpeed, of: OPTIONS, flag: OPTION_FAST}",
            )
        ],
        MEANING,
        "Move.SPEED: alternative unit, chosen by",
    ),
    "answer": (
        [("answer: {message: List}", "answer: {message: State}")],
        MEANING,
        "message ListRequest: answered by: List → State",
    ),
    "answer to a silent request": (
        [("answer: {message: List}", "answer: none")],
        MEANING,
        "message ListRequest: answered by: List → none",
    ),
    "confirmation": (
        [("answer: {confirm: always, retry: safe}", "answer: {confirm: possible, retry: safe}")],
        MEANING,
        "message Move: confirmed: always → possible",
    ),
    "confirmation in a case": (
        [("confirm: possible, retry: safe", "confirm: always, retry: safe")],
        MEANING,
        "message Aim: case 1: confirmed: possible → always",
    ),
    "retry": (
        [("answer: {confirm: always, retry: safe}", "answer: {confirm: always}")],
        MEANING,
        "message Move: safe to retry: yes → no",
    ),
    "answer under a condition": (
        [
            (
                "      answer: {confirm: always, retry: safe}\n",
                "      answer:\n"
                "        - {when: {field: OPTIONS, has: OPTION_FAST}, confirm: always, retry: safe}\n"
                "        - {confirm: always, retry: safe, then: restart}\n",
            )
        ],
        MEANING,
        "message Move: answered when: else → options has OPTION_FAST, else",
    ),
    "restart": (
        [
            (
                "answer: {confirm: always, retry: safe}",
                "answer: {confirm: always, retry: safe, then: restart}",
            )
        ],
        MEANING,
        "message Move: restarts the board: no → yes",
    ),
    "effect": (
        [("effect: sets", "effect: [stores, moves]")],
        MEANING,
        "message Move: effect: sets → stores moves",
    ),
    "effect under a condition": (
        [
            (
                "effect: sets\n",
                "effect: [{when: {field: OPTIONS, has: OPTION_FAST}, does: moves}, {does: sets}]\n",
            )
        ],
        MEANING,
        "message Move: effect: sets → moves if options has OPTION_FAST, sets",
    ),
    "role moved": (
        [
            (
                "      source: Incoming commands L52\n",
                "      source: Incoming commands L52\n      role: {is: details}\n",
            )
        ],
        OK,
        "message List: role: none → details",
    ),
    "since later": (
        [("since: {firmware: 2.59}", "since: {firmware: 2.60}")],
        MEANING,
        "message StoreExt: since: firmware 2.59 → firmware 2.60",
    ),
    "variable's range": (
        [("range: -100..100", "range: -99..100")],
        MEANING,
        "variable TRIM: range: -100..100 → -99..100",
    ),
    "variable's id reused": (
        [("TRIM: {id: 1", "TILT: {id: 1")],
        MEANING,
        "variable 1: TRIM → TILT",
    ),
    # In C++ only
    "message renamed": (
        [
            (
                "      source: Incoming commands L52\n",
                "      source: Incoming commands L52\n      as: Items\n",
            ),
            ("message: List", "message: Items"),
        ],
        SOURCE,
        "message Items: C++ name: List → Items",
    ),
    "command renamed": (
        [("CMD_STATE:", "CMD_STATUS:"), ("message: State", "message: Status")],
        SOURCE,
        "command CMD_STATE: name: CMD_STATE → CMD_STATUS",
    ),
    "field renamed": (
        [("name: COUNT, ", "name: TIMES, ")],
        SOURCE,
        "State.TIMES: C++ name: count → times",
    ),
    "field renamed in C++": (
        [("name: COUNT, ", "name: COUNT, as: times, ")],
        SOURCE,
        "State.COUNT: C++ name: count → times",
    ),
    "enum value renamed in C++": (
        [("MODE_ON:  {value: 1,", "MODE_ON:  {value: 1, as: running,")],
        SOURCE,
        "enum Mode.MODE_ON: C++ name: on → running",
    ),
    "enum value removed": (
        [("      MODE_ON:  {value: 1, summary: Something.}\n", "")],
        SOURCE,
        "enum Mode.MODE_ON: 1 → deleted",
    ),
    "enum renamed": (
        [("  Mode:\n", "  Action:\n"), ("type: Mode", "type: Action")],
        SOURCE,
        "enum Mode: name: Mode → Action",
    ),
    "quantity renamed": (
        [("  Angle:\n", "  Bearing:\n"), ("type: Angle", "type: Bearing")],
        SOURCE,
        "quantity Angle: name: Angle → Bearing",
    ),
    "accessor": (
        [("unit: deg, accessor: degrees", "unit: deg, accessor: bearing")],
        SOURCE,
        "quantity Angle: accessor: degrees → bearing",
    ),
    "struct renamed": (
        [("  AxisState:\n", "  Axis:\n"), ("type: AxisState", "type: Axis")],
        SOURCE,
        "struct AxisState: name: AxisState → Axis",
    ),
    "unit added": (
        [
            ("COUNT,  type: u16", "COUNT,  type: Ticks"),
            (
                "quantities:\n",
                "quantities:\n"
                "  Ticks: {type: u16, unit: ms, accessor: ms, scale: 1, summary: Ticks.}\n",
            ),
        ],
        SOURCE,
        "State.COUNT: C++ type: u16 → Ticks (u16)",
    ),
    "part renamed": (
        [("name: level", "name: amount")],
        SOURCE,
        "packed Setup.level: name: level → amount",
    ),
    "main part taken away": (
        [("    main: mode\n", "")],
        SOURCE,
        "packed Setup: main part: mode → none",
    ),
    "index instead of a number": (
        [('"axes[axis]"', '"axes[3]"')],
        SOURCE,
        "State.axes: index: ROLL, PITCH, YAW → 3",
    ),
    # Compatible
    "command added": (
        [("variables:\n", MORE_COMMAND + "\nvariables:\n")],
        OK,
        "command CMD_MORE: none → 14",
    ),
    "direction learned": (
        [("ROLL: {positive: null, negative: null}", "ROLL: {positive: right, negative: left}")],
        OK,
        "direction of ROLL: none → right",
    ),
    "field that counts in a direction": (
        [("scale: 360/16384, summary", "scale: 360/16384, directed: true, summary")],
        OK,
        "struct AxisState.ANGLE: directed: none → as its axis",
    ),
    "message added": (
        [("variables:\n", MORE_COMMAND + "\nvariables:\n")],
        OK,
        "message More: none → to_board",
    ),
    "enum value added": (
        [("      MODE_ON:", "      MODE_IDLE: {value: 7, summary: Idle.}\n      MODE_ON:")],
        OK,
        "enum Mode.MODE_IDLE: none → 7",
    ),
    "field added at a kept tail": (
        [(COUNT, COUNT + MORE_FIELD)],
        OK,
        "State.MORE: none → u16 at the end",
    ),
    "reserved bytes added at a kept tail": (
        [(COUNT, COUNT + RESERVED)],
        OK,
        "State: end: byte 21 → byte 25",
    ),
    "field in reserved bytes": (
        [(RESERVED, MORE_FIELD + "        - {reserved: 2}\n")],
        OK,
        "State.MORE: none → u16 in reserved bytes",
    ),
    "field instead of all reserved bytes": (
        [(RESERVED, "        - {name: MORE, type: u32, summary: New.}\n")],
        OK,
        "State.MORE: none → u32 in reserved bytes",
    ),
    "range widened": (
        [("range: 0..100, special", "range: 0..110, special")],
        OK,
        "State.LEVEL: range: 0..100 → 0..110",
    ),
    "fewest elements": (
        [("max_count: 8", "min_count: 2, max_count: 8")],
        WIRE,
        "StoreExt.DATA: min_count: 0 → 2",
    ),
    "form that ends": (
        [("          summary: Store everything.\n", STORE_ENDS)],
        MEANING,
        "message Store: until: none → firmware 2.59, then StoreExt",
    ),
    "more elements": ([("max_count: 8", "max_count: 9")], OK, "StoreExt.DATA: max_count: 8 → 9"),
    "special value added": (
        [("{255: unknown}", "{254: full, 255: unknown}")],
        OK,
        "State.LEVEL: special 254: none → full",
    ),
    "part added": (
        [
            (
                "summary: How much.}",
                "summary: How much.}\n      - {name: on, bits: 7, summary: Whether.}",
            )
        ],
        OK,
        "packed Setup.on: none → (value & 0x80) >> 7",
    ),
    "confirmation possible": (
        [("answer: {message: List}", "answer: {message: List, confirm: possible}")],
        OK,
        "message ListRequest: confirmed: never → possible",
    ),
    "confirmation unlikely": (
        [("answer: {message: List}", "answer: {message: List, confirm: unlikely}")],
        OK,
        "message ListRequest: confirmed: never → unlikely",
    ),
    "confirmation less likely": (
        [("answer: {confirm: possible}", "answer: {confirm: unlikely}")],
        OK,
        "message StoreExt: confirmed: possible → unlikely",
    ),
    "confirmation less likely in a case": (
        [("confirm: possible, retry: safe", "confirm: unlikely, retry: safe")],
        OK,
        "message Aim: case 1: confirmed: possible → unlikely",
    ),
    "effect not stated any more": (
        [("      effect: sets\n", "")],
        MEANING,
        "message Move: effect: sets → none",
    ),
    "history": (
        [
            (
                "families: [base, probe]",
                'revisions: {"1.0": {date: 2026-01-31, source: L2, adds: [CMD_MOVE]}}\n\n'
                "families: [base, probe]",
            )
        ],
        OK,
        "revision 1.0: none → 2026-01-31, CMD_MOVE, none",
    ),
    "since earlier": (
        [("since: {firmware: 2.59}", "since: {firmware: 2.58}")],
        OK,
        "message StoreExt: since: firmware 2.59 → firmware 2.58",
    ),
    "form added beside the only one": (
        [
            (
                "      fields:\n        - {name: NUM,",
                "      forms:\n       simple:\n        summary: A list.\n        fields:\n"
                "        - {name: NUM,",
            ),
            (
                '        - {name: "ITEM[NUM]", type: u16, summary: The elements.}\n',
                '        - {name: "ITEM[NUM]", type: u16, summary: The elements.}\n'
                "       error:\n        summary: Empty.\n",
            ),
        ],
        OK,
        "message List: form: none → simple",
    ),
    "deprecated": (
        [("name: COUNT, ", "name: COUNT, deprecated: true, ")],
        OK,
        "State.COUNT: deprecated: no → yes",
    ),
    "text": (
        [("summary: How often.", "summary: How many times.")],
        OK,
        "State.COUNT: summary: How often. → How many times.",
    ),
    "variable added": (
        [("  TRIM:", "  TILT: {id: 2, type: u8, range: 0..1, summary: Tilt.}\n  TRIM:")],
        OK,
        "variable TILT: none → 2",
    ),
    "variable's range widened": (
        [("range: -100..100", "range: -110..110")],
        OK,
        "variable TRIM: range: -100..100 → -110..110",
    ),
    "special value named": (
        [("special: {255: unknown}", "special: {255: {as: unknown, summary: unknown}}")],
        OK,
        "State.LEVEL: special 255: C++ name: none → unknown",
    ),
    "variable's setting": (
        [
            ("variables:\n", STORE_STATE + "\nvariables:\n"),
            ("range: -100..100,", "range: -100..100, sets: State.tilt,"),
            ("type: u16, summary: How often.}\n", f"type: u16, summary: How often.}}\n{TILT}"),
        ],
        OK,
        "variable TRIM: sets: none → State.tilt",
    ),
}
