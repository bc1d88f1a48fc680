"""Filters for the templates of Python."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Callable
from typing import Any

from sbgcgen.model import Announced, Blob, Enum, EnumValue, Field, Layout, Message, Packed, Part
from sbgcgen.model import Quantity, Struct, constants, scalar_of
from sbgcgen.views.code import attribute_name, enum_name
from sbgcgen.views.words import body_size, directions_text, narrow_range, number, rules_in
from sbgcgen.views.words import versions

LINE = 100  # columns


def doc(paragraphs: list[str], indent: int = 4) -> str:
    """A docstring, wrapped; its first line is not indented."""
    margin = " " * indent
    said = [
        " ".join(text.split()).replace("\\", "\\\\").replace('"""', "'''") for text in paragraphs
    ]
    said = [text for text in said if text]
    if len(said) == 1 and indent + len(said[0]) + 6 <= LINE:
        text = f"{said[0]} " if said[0].endswith('"') else said[0]
        return f'"""{text}"""'
    wrapped = [
        textwrap.fill(
            text,
            LINE - indent - (3 if at == 0 else 0),
            subsequent_indent=margin,
            initial_indent=margin if at else "",
            break_long_words=False,
            break_on_hyphens=False,
        )
        for at, text in enumerate(said)
    ]
    return '"""' + "\n\n".join(wrapped) + f'\n{margin}"""'


def call(text: str, indent: int, close: str = "") -> str:
    """A line of code, or one line for each argument if it is too long."""
    text = " ".join(text.split())
    if indent + len(text) <= LINE:
        return text
    open_, _, rest = text.partition("(")
    inside, _, end = rest.rpartition(")")
    margin = " " * (indent + 4)
    arguments = "".join(f"\n{margin}{argument}," for argument in _arguments(inside))
    return f"{open_}({arguments}\n{' ' * indent}){end}"


def _arguments(text: str) -> list[str]:
    """The arguments in a text, without the commas between them."""
    found, depth, start = [], 0, 0
    for at, c in enumerate(text):
        depth += (c in "([") - (c in ")]")
        if c == "," and depth == 0:
            found.append(text[start:at].strip())
            start = at + 1
    return [*found, text[start:].strip()]


def shown(fields: tuple[Field, ...]) -> list[Field]:
    """The fields that are attributes: without the counters that follow from a list."""
    return [field for field in fields if not field.is_counter]


def has_raw(field: Field) -> bool:
    """True if the raw number differs from the value."""
    return isinstance(field.type, Quantity) or bool(field.variable)


def _kind(field: Field) -> str:
    type_ = field.type
    if isinstance(type_, Struct):
        return f"GroupOf({type_.name})"
    if isinstance(type_, (Enum, Packed)):
        return f"ValueOf({type_.name})"
    if isinstance(type_, Blob):
        return "BYTES" if type_.kind == "bytes" else "TEXT"
    scalar = scalar_of(type_)
    is_real = has_raw(field) or isinstance(type_, Announced) or (scalar and scalar.is_float)
    return "REAL" if is_real else "RAW"


def _hints(field: Field) -> tuple[str, str]:
    """The types for reading and writing an element of the field."""
    type_ = field.type
    if isinstance(type_, Packed):
        return type_.name, "int"
    if isinstance(type_, (Struct, Enum)):
        return type_.name, type_.name
    if isinstance(type_, Blob):
        return ("bytes", "Bytes") if type_.kind == "bytes" else ("str", "str")
    return ("int", "int") if _kind(field) == "RAW" else ("float", "float")


def _is_one(field: Field) -> bool:
    is_run = isinstance(field.type, Blob) and field.type.kind == "bytes" and not field.type.size
    return field.dim == "one" or (field.dim == "rest" and is_run)


def _raw_hint(field: Field) -> str:
    scalar = scalar_of(field.type)
    return "float" if scalar and scalar.is_float else "int"


def kind(field: Field, raw: bool = False) -> str:
    """The expression for the kind of a field, or of the raw numbers beside it."""
    element = "RAW" if raw else _kind(field)
    if _is_one(field):
        return element
    if field.dim == "axis":
        return f"AxesOf({element})"
    if field.dim == "xyz":
        return f"AxesOf({element}, Xyz)"
    return f"ListOf({element})"


def hints(field: Field, raw: bool = False) -> tuple[str, str]:
    """The types for reading and writing a field."""
    get, set_ = (_raw_hint(field), _raw_hint(field)) if raw else _hints(field)
    if field.dim in ("axis", "xyz") and not _is_one(field):
        name = "Axes" if field.dim == "axis" else "Xyz"
        get = set_ = f"{name}[{get}]"
    elif not _is_one(field):
        get, set_ = f"Elements[{get}]", f"Iterable[{set_}]"
    if field.may_be_absent:
        get, set_ = f"Optional[{get}]", f"Optional[{set_}]"
    return get, set_


def field_doc(field: Field, whole: str = "body") -> str:
    """The documentation of a field of a body, or of an element."""
    unit = field.type.unit or "" if isinstance(field.type, Quantity) else ""
    said = [field.summary]
    if limits := narrow_range(field):
        said.append(f"Range: {limits}.")
    elif unit:
        said.append(f"Unit: {unit}.")
    said.append(directions_text(field.directions or ()))
    raw = "Raw value" if has_raw(field) else "Value"
    said += [f"{raw} {s.value}: {s.meaning}." for s in field.special]
    said.append(f"At least {field.min_count}." if field.min_count else "")
    said.append(f"At most {field.max_count}." if field.max_count is not None else "")
    said.append(f"A multiple of {field.align}." if field.align != 1 else "")
    if field.alternative:
        other = field.alternative
        said.append(f"Sent as {other.quantity.name} if {other.flag.name} is set.")
    said.append(f"Present if {field.when.words}." if field.when else "")
    said.append(f"Used if {field.used_when.words}." if field.used_when else "")
    said.append("The same in all copies." if field.role == "general" else "")
    if field.since:
        before = f"; before, the {whole} ends here" if field.appended else ""
        said.append(f"Since {versions(field.since)}{before}.")
    said.append(f"Always {field.default}." if field.constant else "")
    said.append("Unconfirmed." if field.unconfirmed else "")
    if field.deprecated:
        since = f" since {versions(field.deprecated.since)}" if field.deprecated.since else ""
        instead = f": use {field.deprecated.replaced_by}" if field.deprecated.replaced_by else ""
        said.append(f"Deprecated{since}{instead}.")
    return doc([" ".join(filter(None, said))])


def message_doc(message: Message) -> str:
    """The summary of a message, and its facts."""
    ways = {"from_board": "from the board", "to_board": "to the board"}
    way = "in both directions" if message.in_both_directions else ways[message.direction]
    form = f", {message.form} form" if message.form else ""
    more = ", and later firmware may append more" if message.keeps_tail else ""
    facts = [f"{message.command} ({message.id}), {way}{form}; {body_size(message)}{more}."]
    if message.effect:
        facts.append(f"Effect: {', '.join(message.effect.words)}.")
    if message.since:
        facts.append(f"Since {versions(message.since)}.")
    if message.until:
        instead = message.until.instead
        verdict = f"accepts {instead} instead" if instead else "no longer accepts it"
        facts.append(f"{versions(message.until.versions).capitalize()} and later {verdict}.")
    if message.unconfirmed:
        facts.append("Unconfirmed.")
    if message.deprecated:
        instead = message.deprecated.replaced_by
        facts.append(f"Deprecated{f': use {instead}' if instead else ''}.")
    rules = rules_in(message.body)
    if rules:
        facts.append(f"Rules: {', '.join(rules)}.")
    facts.append(f"Source: {message.source}.")
    before = f"Before: {message.preparation}" if message.preparation else ""
    return doc([message.summary, message.description or "", before, " ".join(facts)])


def value_doc(value: EnumValue) -> str:
    said = [value.summary, f"Since {versions(value.since)}." if value.since else ""]
    return doc([" ".join(filter(None, [*said, "Unconfirmed." if value.unconfirmed else ""]))])


def part_type(part: Part) -> str:
    """The type of a part of a packed value."""
    if part.enum:
        return part.enum.name
    if part.quantity:
        return "float"
    return "bool" if part.is_bool else "int"


def answers(layout: Layout) -> dict[str, str]:
    """The return type of a call for each request: its responses, or their confirmation."""
    errors = {message.name for message in layout.messages if message.form == "error"}
    confirmations = [m.name for m in layout.messages if m.role and m.role.kind == "confirmation"]
    found: dict[str, str] = {}
    for message in layout.messages:
        if message.answer is None:
            continue
        names: list[str] = []
        for case in message.answer.cases:
            names += [name for name in case.messages if name not in errors]
            names += confirmations if case.confirm != "never" and not case.messages else []
            names += ["None"] if case.confirm != "always" and not case.messages else []
        if not names:  # only errors answer it
            continue
        possible = [name for name in dict.fromkeys(names) if name != "None"]
        one = possible[0] if len(possible) == 1 else f"Union[{', '.join(possible)}]"
        if "None" in names:
            one = f"Optional[{one}]" if possible else "None"
        found[message.name] = one
    return found


def homes(layout: Layout) -> dict[str, tuple[str, str]]:
    """A message with each structure in it, and the path."""
    found: dict[str, tuple[str, str]] = {}

    def visit(fields: tuple[Field, ...], message: Message, path: str) -> None:
        for field in fields:
            if isinstance(field.type, Struct):
                first = {"one": "", "axis": ".roll", "xyz": ".x"}.get(field.dim, "[0]")
                place = f"{path}{field.name}{first}"
                found.setdefault(field.type.name, (message.name, place))
                visit(field.type.fields, message, f"{place}.")

    for message in layout.messages:
        visit(message.fields, message, "")
    return found


FILTERS: dict[str, Callable[..., Any]] = {
    "attribute_name": attribute_name,
    "call": call,
    "constants": constants,
    "doc": doc,
    "enum_name": enum_name,
    "field_doc": field_doc,
    "has_raw": has_raw,
    "hints": hints,
    "kind": kind,
    "message_doc": message_doc,
    "number": number,
    "part_type": part_type,
    "repr": repr,
    "shown": shown,
    "value_doc": value_doc,
    "words": lambda text: [
        word for word in re.findall(r"\w+", text) if word not in ("Union", "Optional", "None")
    ],
}
