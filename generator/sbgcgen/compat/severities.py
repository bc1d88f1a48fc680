"""The comparison tables of the classes of the model, with the severity of each change.

A row has the label of a fact in reports, its severity, and the attribute or function that returns it; by default,
the label is the attribute. `rows` have the same severity: "may be absent: appended" is a label and an attribute.
difference.py describes all kinds of rows. A function in a table performs a comparison that needs an algorithm.
"""

from __future__ import annotations

from typing import Any

from sbgcgen.compat import facts, messages
from sbgcgen.compat.changes import COMPATIBLE, MEANING, SOURCE, WIRE, Change, Changes, Level
from sbgcgen.compat.difference import Each, Pair, Replaced, Row, Severity, Table, Values, rows
from sbgcgen.compat.fields import compare_structs
from sbgcgen.compat.wire import cut, times, wire_type
from sbgcgen.compat.words import cut_text, direction_text, index_text, range_text, type_text
from sbgcgen.compat.words import when_text
from sbgcgen.model import Answer, AnswerCase, AxisDirection, Checksum, Command, EffectKind, Enum
from sbgcgen.model import EnumValue, Field, Framing, Layout, Line, Message, Packed, Part, Quantity
from sbgcgen.model import Position, Revision, Role, Struct, Variable

# Severities that depend on the old and the new value


def if_old(level: Level, otherwise: Level | None = COMPATIBLE) -> Severity:
    """The severity `level` if the old version states something."""
    return lambda old, new: level if old else otherwise


def if_new(level: Level, otherwise: Level = COMPATIBLE) -> Severity:
    """The severity `level` if the new version states something."""
    return lambda old, new: level if new else otherwise


def if_smaller(level: Level, otherwise: Level = COMPATIBLE) -> Severity:
    """The severity `level` if the number is smaller than before."""
    return lambda old, new: level if new < old else otherwise


def if_fewer(old: Any, new: Any) -> Level:
    """Something has been removed from the list."""
    return MEANING if set(old) - set(new) else COMPATIBLE


def if_other(level: Level) -> Severity:
    """The severity `level` if the fact that it depends on has changed, too."""
    return lambda old, new: level if old != new else None


def if_narrower(old: Any, new: Any) -> Level | None:
    """Valid values have become invalid. Without a range in both versions, the type has changed."""
    if not old or not new:
        return None
    return MEANING if new[0] > old[0] or new[1] < old[1] else COMPATIBLE


# Facts of several classes

SUMMARY = Row("summary", COMPATIBLE)
DEPRECATED = Row("deprecated", COMPATIBLE, text=bool)
SCALAR = Row("type", WIRE, "scalar.name")
# Only a later version than before is a breaking change.
SINCE = Row("since", lambda old, new: MEANING if new.is_after(old) else COMPATIBLE)
NEEDS = Row("needs", if_new(MEANING))

# The content of types, which is also compared if one replaces another in a field.

UNIT = rows(MEANING, "unit", "scale", "offset", "ratio", "over")
VALUES: Table = (Each("values", ".", shown="value", number="value", is_alias=facts.is_alias),)
PARTS: Table = (
    Row("names: type", SOURCE, "names.name"),
    Replaced("names", {Enum: VALUES}, ": names"),
    Row("main part", if_old(SOURCE), "main.name"),
    Each("parts", ".", shown=cut_text, content=cut),
)
CONTENT = {Quantity: UNIT, Enum: VALUES, Packed: PARTS, Struct: (compare_structs,)}

# The tables of the classes

TABLES: dict[type, Table] = {
    Layout: (
        Row("main file", if_old(SOURCE, None), "main_file"),
        Row("namespace", SOURCE, lambda layout: layout.protocol.get("namespace", "sbgc")),
        Row("prefix of commands", COMPATIBLE, "command_prefix"),
        Each("framings", "framing ", WIRE),
        Each("effects", "effect ", name="word"),
        Row("versions: firmware", if_old(MEANING, None), "versions.firmware.name"),
        Row("versions: board", if_old(MEANING, None), "versions.board.name"),
        Row("newest firmware", if_old(COMPATIBLE, None), "newest_firmware"),
        facts.compare_line,
        Values("directions", "direction of ", MEANING, "positive", name="axis"),
        messages.compare_commands,
        facts.Types("quantities", "quantity "),
        facts.Types(lambda layout: [e for e in layout.enums if e.at.file], "enum "),
        facts.Types("packed", "packed "),
        facts.Types(lambda layout: [s for f in layout.families for s in f.structs], "struct "),
        Each("variables", "variable ", WIRE, shown="id", number="id"),
        Values("revisions", "revision ", COMPATIBLE, name="number"),
    ),
    AxisDirection: (Row("", if_old(MEANING), "positive"),),
    Revision: (Row("", COMPATIBLE, facts.revision_of),),
    Framing: (*rows(WIRE, "start", "header", "trailer", "max_body"), facts.compare_checksums),
    Checksum: rows(WIRE, "kind", "covers", "crc"),
    EffectKind: (Row("risk", MEANING), SUMMARY),
    Line: (
        *rows(if_fewer, "baud_rates", "parities"),
        *rows(COMPATIBLE, "shortest_pause_ms", "longest_pause_ms"),
    ),
    Variable: (
        Row("id", WIRE),
        SCALAR,
        Row("C++ name", SOURCE, "identifier"),
        Row("unit", if_old(MEANING), "quantity", text=facts.unit_of),
        Row("range", if_narrower, lambda v: (v.minimum, v.maximum), text=range_text),
        SINCE,
        Row(
            "sets", if_old(MEANING), lambda v: " ".join(f"{s.message}.{s.path}" for s in v.settings)
        ),
        Row("as_switch", if_old(MEANING), "is_switch", by="settings"),
        SUMMARY,
    ),
    # Commands and messages
    Command: (
        Row("id", WIRE),
        Row("C++ name", SOURCE, "identifier", alike="name"),
        SINCE,
        NEEDS,
        *rows(COMPATIBLE, "undocumented", "unconfirmed", "summary"),
    ),
    Message: (
        *rows(SOURCE, "C++ name: name", "family"),
        Row("keeps its tail", if_new(COMPATIBLE, WIRE), "keeps_tail"),
        Row("max_size", lambda old, new: COMPATIBLE if new > old else WIRE, alike=messages.lengths),
        Row("context", SOURCE, messages.contexts),
        Row("source of its context", MEANING, messages.sources, alike=messages.contexts),
        messages.compare_answers,
        messages.compare_effects,
        Row("stops", MEANING, messages.stops),
        Row("role", if_old(MEANING), "role.kind", by="role"),
        messages.compare_roles,
        Row("stores", MEANING, is_name=True),
        SINCE,
        NEEDS,
        messages.compare_ends,
        DEPRECATED,
        *rows(COMPATIBLE, "summary", "description", "preparation"),
    ),
    Answer: (
        messages.CONFIRMED,
        Row("confirmations", MEANING, alike="confirm"),
        Row("safe to retry", if_new(COMPATIBLE, MEANING), "retry_safe"),
        Row("timeout_ms", COMPATIBLE),
        Row("finish_ms", COMPATIBLE, lambda answer: max(case.finish_ms for case in answer.cases)),
        Row("answered when", MEANING, messages.conditions),
    ),
    AnswerCase: (
        Row("repeats", MEANING, lambda case: sorted(case.correlation)),
        *rows(MEANING, "preceded by: series", "restarts the board: restarts"),
        Row("result", MEANING, "result.field.spec_name"),
    ),
    Role: (
        *rows(MEANING, "interval_us", "end", "cycle", "cycle_us", "delay_ms"),
        Row("limit", if_old(MEANING), lambda role: role.limit or None),
        Row("messages", if_fewer, lambda role: sorted(set(role.messages))),
    ),
    # Fields
    Field: (
        Row("C++ name and key in JSON", SOURCE, "name"),
        Row("name", COMPATIBLE, "spec_name"),
        Row("type", facts.if_type_is_another, "type", type_text, key=wire_type),
        Row("C++ type", SOURCE, "type", type_text, alike=lambda f: wire_type(f.type)),
        Row("unit", facts.if_unit_is_lost, "type", facts.unit_text),
        Replaced("type", CONTENT),
        Row("elements", WIRE, times),
        Row("index", if_other(SOURCE), index_text, by=lambda f: (f.dim, f.index), alike=times),
        Row("counted by", WIRE, "counter", is_name=True),
        Row("counted in", WIRE, "counting"),
        Row(
            "counted by part", if_other(WIRE), "counter_part.name", by=lambda f: cut(f.counter_part)
        ),
        *rows(WIRE, "may be absent: appended", "is present if it fits: fits"),
        Row("is hidden in text and JSON", MEANING, "secret"),
        *rows(COMPATIBLE, "name in saved files: saved_as", "number in saved files: saved_in"),
        facts.compare_conditions,
        # Values that were valid only become invalid if the board used the field less often before.
        Row("used when", if_old(MEANING), "used_when", text=when_text),
        # A new default changes the messages of programs that do not set the field.
        Row("default", MEANING),
        Row("constant", if_new(MEANING)),
        Row("unconfirmed", COMPATIBLE),
        Row("range", if_narrower, facts.range_of, text=range_text),
        Row("align", lambda old, new: MEANING if old % new else COMPATIBLE),
        Row("role", MEANING),
        Row("min_count", if_smaller(COMPATIBLE, WIRE), alike="dim"),
        Row("max_count", if_smaller(MEANING), by=facts.capacity, alike="dim"),
        facts.compare_special_values,
        Replaced("alternative.quantity", CONTENT, ": alternative unit"),
        facts.compare_alternatives,
        facts.compare_later_meanings,
        *rows(MEANING, "variable", "reserved"),
        Row("directed", if_old(MEANING), direction_text, by="directions"),
        SINCE,
        NEEDS,
        DEPRECATED,
        SUMMARY,
    ),
    # Types
    Quantity: (SCALAR, *UNIT, Row("accessor", SOURCE), SUMMARY),
    Enum: (
        SCALAR,
        Row("kind", SOURCE),
        Row("C++ member", SOURCE, "member", alike="name"),
        *VALUES,
        Row("success", if_old(MEANING), "success.name"),
        SUMMARY,
    ),
    EnumValue: (
        Row("", MEANING, "value"),
        Row("C++ name", SOURCE, "identifier", alike="name"),
        Row("type it names", if_old(WIRE), "wire"),
        Row("number", lambda old, new: COMPATIBLE if old is None else MEANING),
        SINCE,
        NEEDS,
        Row("before", if_new(MEANING), "former.summary", by="former"),
        *rows(COMPATIBLE, "unconfirmed", "summary"),
    ),
    Packed: (
        SCALAR,
        *PARTS,
        *rows(COMPATIBLE, "display", "later display: later_display"),
        *rows(COMPATIBLE, "first value of the later display: later_from", "summary"),
    ),
    Part: (
        Row("", MEANING, lambda part: part, cut_text, key=cut),
        Row("type", SOURCE, "enum.name"),
        Replaced("enum", {Enum: VALUES}),
        Row("quantity", if_old(MEANING, SOURCE), "quantity.name"),
        SUMMARY,
    ),
    Struct: (
        compare_structs,
        Row("size", WIRE, lambda struct: struct.size if struct.is_region else None),
        Row("family", SOURCE),
        SUMMARY,
    ),
}


def compare(old: Layout, new: Layout) -> list[Change]:
    """All changes, the worst first; those of equal severity are grouped by kind of entry."""
    changes = Changes(new.versions)
    whole_protocol = Position(f"spec/{new.main_file}")
    Pair(changes, TABLES, "", old, new, whole_protocol).compare()
    rank = list(Level)
    return sorted(changes.found, key=lambda change: rank.index(change.level))
