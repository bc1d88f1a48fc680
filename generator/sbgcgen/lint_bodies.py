"""Rules over resolved bodies: what a decoder could not read or an encoder could not write."""

from __future__ import annotations

from sbgcgen.diagnostics import Diagnostics
from sbgcgen.model import Enum, Field, Layout, Message, Packed, Quantity, Scalar, Struct
from sbgcgen.names import is_identifier, parse_lines


def lint_bodies(layout: Layout, found: Diagnostics) -> None:
    """Check every message and struct; findings go into `found`."""
    for family in layout.families:
        for struct in family.structs:
            _check_list(struct.fields, found)
    for message in layout.messages:
        _check_list(message.fields, found)
        _check_message(message, layout.framing.max_body, found)
        _check_contexts(message, layout, found)
        _check_alternatives(message, message.fields, found)
        _check_source(message.source, message, found)
    types: list[Enum | Packed] = [*layout.enums, *layout.packed]
    for type_ in types:
        _check_source(type_.source, type_, found)


def _check_message(message: Message, max_body: int, found: Diagnostics) -> None:
    if not is_identifier(message.name):
        text = f"'{message.name}' can not be a name in C++"
        found.add(message.at, "SBGC022", text, "give the message another one with 'as'")
    if not message.min_size <= message.max_size <= max_body and message.min_size <= max_body:
        text = f"{message.name} has at least {message.min_size} bytes, at most {message.max_size}"
        hint = f"'max_size' lies between the fields' least size and {max_body}"
        found.add(message.at, "SBGC042", text, hint)


def _check_source(source: str, owner: Message | Enum | Packed, found: Diagnostics) -> None:
    """Line ranges run forwards. (What came later than the specification names no lines.)"""
    if any(last < first for first, last in parse_lines(source)):
        text = f"the source of {owner.name} names lines backwards"
        hint = "write it like 'Variables L1005-L1009'"
        found.add(owner.at, "SBGC020", text, hint)


# Lists of fields


def _check_list(fields: tuple[Field, ...], found: Diagnostics) -> None:
    by_name = {field.name: field for field in fields}
    counted: set[str] = set()
    for field in fields:
        if field.max_count is not None and field.max_count > field.capacity:
            text = f"{field.max_count} elements of '{field.name}' do not fit into a body"
            found.add(field.at, "SBGC042", text, f"there is room for {field.capacity}")
        if isinstance(field.type, Struct) and _takes_rest(field.type):
            if field.dim != "one" or field is not fields[-1]:
                text = f"{field.type.name} takes the rest of the body, but something follows it"
                hint = "such a struct stands once, and last"
                found.add(field.at, "SBGC027", text, hint)
        if field.counter:
            problem = _counter_problem(by_name.get(field.counter), counted)
            if problem:
                text = f"'{field.counter}' can not count '{field.name}': {problem}"
                hint = "a counter is a u8, u16 or u32 of its own, in the same list of fields"
                found.add(field.at, "SBGC043", text, hint)
            counted.add(field.counter)


def _takes_rest(struct: Struct) -> bool:
    if not struct.fields or struct.size is not None:
        return False
    last = struct.fields[-1]
    return last.dim == "rest" or (isinstance(last.type, Struct) and _takes_rest(last.type))


def _counter_problem(counter: Field | None, counted: set[str]) -> str:
    if counter is None:
        return "it stands elsewhere"
    if counter.name in counted:
        return "it counts another list"
    if not isinstance(counter.type, Scalar) or counter.type.minimum != 0:
        return "it is no unsigned number"
    if counter.dim != "one":
        return "there are several of it"
    return "it is not always present" if counter.when is not None else ""


# References to other fields and messages


def _check_alternatives(message: Message, fields: tuple[Field, ...], found: Diagnostics) -> None:
    by_name = {field.name: field for field in message.fields}
    for field in fields:
        if isinstance(field.type, Struct):
            _check_alternatives(message, field.type.fields, found)
        if field.alternative and not (
            isinstance(field.type, Quantity)
            and field.type.scalar == field.alternative.quantity.scalar
        ):
            text = f"{field.alternative.quantity.name} is no other unit of '{field.name}'"
            found.add(field.at, "SBGC026", text, "both are quantities over the same number")
        source = by_name.get(field.alternative.source) if field.alternative else None
        if source is None or field.alternative is None:
            continue
        flag = field.alternative.flag
        sets = [source.type] if isinstance(source.type, Enum) else []
        if isinstance(source.type, Packed):
            sets = [part.enum for part in source.type.parts if part.enum]
        if not any(flag in enum.values for enum in sets):
            text = f"'{source.name}' of {message.name} has no flag {flag.name}"
            hint = "'of' names the field whose flags choose the unit"
            found.add(field.at, "SBGC026", text, hint)


def _check_contexts(message: Message, layout: Layout, found: Diagnostics) -> None:
    fields = {m.name: m.fields for m in layout.messages}
    seen: set[str] = set()
    for context in message.contexts:
        if context.name in seen:
            text = f"duplicate context '{context.name}' in {message.name}"
            found.add(message.at, "SBGC012", text, "one of them is enough")
        seen.add(context.name)
        for name, path in context.sources:
            if not _has_field(fields.get(name, ()), path.split(".")):
                text = f"the context '{context.name}' of {message.name} comes from no field"
                hint = f"there is no '{name}.{path}'; write it like BoardInfo.FIRMWARE_VER"
                found.add(message.at, "SBGC026", text, hint)


def _has_field(fields: tuple[Field, ...], path: list[str]) -> bool:
    for field in fields:
        if field.name == path[0]:
            inner = field.type.fields if isinstance(field.type, Struct) else ()
            return len(path) == 1 or _has_field(inner, path[1:])
    return False
