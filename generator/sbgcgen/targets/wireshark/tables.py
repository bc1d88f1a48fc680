"""The protocol as Lua tables: exactly the facts that the program in the templates needs."""

from __future__ import annotations

import re
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from sbgcgen.model import ID, SIZE, Alternative, Announced, AnswerCase, Blob, Checksum
from sbgcgen.model import Condition, Enum, Field, Framing, Layout, Leaf, Message, Packed, Part
from sbgcgen.model import Quantity, Struct, Type

Table = dict[str, Any]

_KEYWORDS = frozenset(
    """and break do else elseif end false for function goto if in local nil not or repeat return
    then true until while""".split()
)
_ESCAPES = {ord('"'): '\\"', ord("\\"): "\\\\", ord("\n"): "\\n"}


def lua(value: Any) -> str:
    """A value as Lua. Keys without a value, and unset flags, are omitted."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return f'"{value.translate(_ESCAPES)}"'
    if isinstance(value, Fraction):
        return str(value.numerator) if value.denominator == 1 else repr(float(value))
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, dict):
        items = [(_key(key), item) for key, item in value.items()]
        return "{" + ", ".join(f"{k} = {lua(v)}" for k, v in items if not _is_unset(v)) + "}"
    return "{" + ", ".join(lua(item) for item in value) + "}"


def _is_unset(value: Any) -> bool:
    return value is None or value is False or value in ((), [], "", {})


def _key(key: int | str) -> str:
    if isinstance(key, int):
        return f"[{key}]"
    return key if key.isidentifier() and key not in _KEYWORDS else f'["{key}"]'


def framing(one: Framing) -> Table:
    """The parts of a frame by offset; those of the trailer count from the end of the body."""
    checks = [_check(one, checksum) for checksum in one.checksums]
    return {
        "name": one.name,
        "start": one.start,
        "header": one.header_size,
        "trailer": one.trailer_size,
        "most": one.max_body,
        "id": one.place(ID),
        "size": one.place(SIZE),
        "in_header": [check for check in checks if check["is_first"]],
        "in_trailer": [check for check in checks if not check["is_first"]],
    }


def _check(one: Framing, checksum: Checksum) -> Table:
    """A checksum over the bytes from the offset `from` to `to`, or to the end of the body."""
    is_first = checksum.name in one.header
    first = checksum.covers[0]
    covered = sum(one.size_of(part) for part in checksum.covers if part in one.header)
    begin = one.place(first) if first in one.header else one.header_size
    crc = checksum.crc
    return {
        "kind": checksum.kind,
        "is_first": is_first,
        "at": one.place(checksum.name),
        "bytes": checksum.size,
        "from": begin,
        "to": begin + covered if is_first else None,
        "width": crc and crc.width,
        "polynomial": crc and crc.polynomial,
        "initial": crc and crc.initial,
        "reflect_in": bool(crc and crc.reflect_in),
        "reflect_out": bool(crc and crc.reflect_out),
        "final": crc and crc.final_xor,
    }


def enum(one: Enum) -> Table:
    """The names of an enum or flag set, in the order of the spec."""
    return {
        "is_flags": one.kind == "flags",
        "values": [[value.value, value.name, value.identifier] for value in one.values],
    }


def packed(one: Packed) -> Table:
    """The parts of a packed value, and its display text."""
    return {
        "display": one.display,
        "later_from": one.later_from,
        "later_display": one.later_display,
        "names": one.names and one.names.name,
        "parts": [{"name": part.name, **_part(part)} for part in one.parts],
    }


def _part(part: Part) -> Table:
    return {
        "most": part.mask >> part.shift,
        "shift": part.shift,
        "divide": part.divide if part.divide != 1 else None,
        "modulo": part.modulo or None,
        "signed": part.signed,
        "sign": part.sign.bit_length() - 1 if part.sign else None,
        "enum": part.enum and part.enum.name,
        "is_bool": part.is_bool,
        "unit": part.quantity and part.quantity.unit,
        "scale": part.quantity and part.quantity.scale,
        "add": part.quantity and part.quantity.offset,
    }


# The Lua names of structs, by the identity of the object, because hashing one is slow.
Names = dict[int, str]


def structs(layout: Layout) -> tuple[list[tuple[str, Struct]], Names]:
    """Every struct inside a message once, each after the structs that it contains; and their names."""
    found: list[tuple[str, Struct]] = []
    names: Names = {}

    def visit(struct: Struct) -> None:
        for field in struct.fields:
            if isinstance(field.type, Struct) and id(field.type) not in names:
                visit(field.type)
                names[id(field.type)] = f"{field.type.name}{len(found)}"
                found.append((names[id(field.type)], field.type))

    for message in layout.messages:
        visit(message.body)
    return found, names


def struct(one: Struct, names: Names) -> Table:
    """A group of fields."""
    return {
        "size": one.size,
        "is_region": one.is_region,
        "looks_outside": one.looks_outside,
        "fields": [_field(field, names) for field in one.fields],
    }


def message(one: Message, layout: Layout) -> Table:
    """A message without its fields."""
    asked = layout.asked_forms(one)
    repeats = next((f for f in one.fields if f.repeats_context), None)
    has_surplus = one.takes_surplus
    return {
        "name": one.name,
        "filter": one.identifier,
        "command": one.command,
        "id": one.id,
        "to_board": one.direction == "to_board",
        "min": one.min_size,
        "max": one.max_size,
        "open": one.is_open or has_surplus,
        "asked": bool(asked and one is not asked.forms[0]),
        "keeps_tail": one.keeps_tail,
        "takes_surplus": has_surplus,
        "tail": one.tail_capacity,
        "fits": any(field.fits and not field.fits_rest for field in one.fields),
        "repeats": repeats
        and {
            "name": repeats.name,
            "at": one.body.fixed_size,
            "size": repeats.size,
            "mask": repeats.when.mask if repeats.when else 0,
        },
        "does": one.effect.words if one.effect else (),
        "secret_from": one.secret_from,
        "role": one.role and _role(one),
        "answers": [_answer(case) for case in one.answer.cases] if one.answer else (),
    }


def _role(one: Message) -> Table:
    assert one.role is not None
    return {"is": one.role.kind, **{part: field.name for part, field in one.role.parts.items()}}


def _answer(case: AnswerCase) -> Table:
    """The answers to a request for which the condition holds."""
    return {
        "when": case.when and _condition(case.when),
        "messages": case.messages,
        "confirm": case.confirm != "never",
        "certain": bool(case.messages) or case.confirm == "always",
        "count": case.confirmations if case.confirmations > 1 else None,
        "timeout": Fraction(max(case.timeout_ms, case.finish_ms), 1000),
        "repeated": {
            response.message: [
                {"field": one.field.name, "at": one.offset, "size": one.size}
                for one in response.correlation
            ]
            for response in case.responses
        },
    }


def learns(layout: Layout) -> Iterator[Table]:
    """The facts from earlier messages that bodies need, and their sources."""
    for asked in layout.asked:
        for request, form in asked.requests:
            yield {
                "from": request.name,
                "path": (),
                "for": form.id,
                "name": "asked",
                "is": form.name,
            }
    for one in layout.messages:
        for context in one.contexts:
            for source, path in context.sources:
                yield {"from": source, "path": _steps(path), "for": one.name, "name": context.name}
            if context.announced:
                said = context.announced
                yield {
                    "from": said.message,
                    "list": said.list,
                    "kind": _steps(said.kind),
                    "count": said.count,
                    "types": _announced(layout, said.message, said.list, said.kind),
                    "for": one.name,
                    "name": context.name,
                }


def _announced(layout: Layout, name: str, list_: str, path: str) -> Table:
    """The part of an element that names a type, and the types by number."""
    first, _, part_name = path.partition(".")
    found = next(m for m in layout.messages if m.name == name)
    element = next(f.type for f in found.fields if f.name == list_)
    assert isinstance(element, Struct)
    type_ = next(f.type for f in element.fields if f.name == first)
    if isinstance(type_, Enum):
        return {"part": None, "types": {v.value: v.wire for v in type_.values}}
    assert isinstance(type_, Packed)
    part = next(part for part in type_.parts if part.name == part_name)
    assert part.enum is not None
    return {"part": _part(part), "types": {v.value: v.wire for v in part.enum.values}}


def fields(one: Message, names: Names) -> list[Table]:
    return [_field(field, names) for field in one.fields]


def _field(one: Field, names: Names) -> Table:
    return {
        "name": one.name,
        **_type(one.type, names),
        "dim": one.dim if one.dim != "one" else None,
        "index": [word.lower() for word in one.index],
        "count": one.count or None,
        "capacity": one.capacity if one.dim in ("counted", "rest") else None,
        "min_count": one.min_count or None,
        "counter": one.counter,
        "counter_part": one.counter_part and _part(one.counter_part),
        "counting": one.counting if one.counting != "elements" else None,
        "fixed": one.size,
        "min": one.minimum,
        "max": one.maximum,
        "special": {special.value: special.meaning for special in one.special},
        "reserved": one.reserved,
        "secret": one.secret,
        "appended": one.appended,
        "element_sizes": isinstance(one.type, Struct) and one.type.element_sizes,
        "fits": one.fits and not one.fits_rest,
        "fits_rest": one.fits_rest,
        "when": one.when and _condition(one.when),
        "used_when": one.used_when and _condition(one.used_when),
        "alternative": one.alternative and _alternative(one.alternative),
        "ways": {
            way.axis.lower(): [way.positive or "", way.negative or ""]
            for way in one.directions or ()
            if way.positive
        },
        "axis": one.axis.lower(),
        "later": [
            {
                "firmware": later.since.firmware,
                **_type(later.type, names),
                "min": later.minimum,
                "max": later.maximum,
            }
            for later in one.later
        ],
    }


def _type(type_: Type, names: Names) -> Table:
    if isinstance(type_, Struct):
        return {"struct": names[id(type_)]}
    if isinstance(type_, Blob):
        return {"blob": type_.kind, "size": type_.size}
    if isinstance(type_, Announced):
        return {"announced": type_.context}
    if isinstance(type_, Enum):
        return {"type": type_.scalar.name, "enum": type_.name}
    if isinstance(type_, Packed):
        return {"type": type_.scalar.name, "packed": type_.name}
    if isinstance(type_, Quantity):
        return {"type": type_.scalar.name, **_quantity(type_)}
    return {"type": type_.name}


def _quantity(one: Quantity) -> Table:
    return {
        "unit": one.unit,
        "scale": one.scale if not one.is_plain else None,
        "add": one.offset or None,
        "ratio": one.ratio or None,
        "over": one.over if one.ratio else None,
    }


def _alternative(one: Alternative) -> Table:
    return {
        "field": one.source,
        "mask": one.mask,
        "in_group": one.in_group,
        **_quantity(one.quantity),
    }


def _steps(path: str) -> list[Any]:
    """The names and numbers in a path."""
    return [int(s) if s.isdigit() else s for s in re.findall(r"\w+", path)]


def _condition(when: Condition) -> Table:
    if when.terms:
        return {
            "joined": when.joined,
            "terms": [_condition(term) for term in when.terms],
            "missing": when.may_be_missing,
        }
    return {
        "context": when.source if when.from_context else None,
        "steps": None if when.from_context else _steps(when.source),
        "outside": when.is_outside,
        "part": when.part and _part(when.part),
        "all": when.mask if when.is_on_flags and when.mask else None,
        "any": [flag.value for flag in when.any_flags],
        "none": [flag.value for flag in when.no_flags],
        "numbers": {number: True for number in when.numbers if not when.is_on_flags},
        "negated": when.negated,
        "at_least": when.at_least,
        "at_most": when.at_most,
        "missing": when.may_be_missing,
        "elements": {word.lower(): _condition(inner) for word, inner in when.elements},
    }


def path_of(leaf: Leaf) -> str:
    """The path of a leaf in display filters: without indices, and without the group `axes`."""
    *steps, last = re.sub(r"\[\d*\]", "", leaf.path).split(".")
    return ".".join([*(step for step in steps if step != AXES), last])


# A group of the axes has this name if it has no other; filters omit it.
AXES = "axes"


def kind_of(type_: Type, field: Field) -> str:
    """The display filter type of a value, as far as two must agree."""
    if isinstance(type_, Blob):
        return "bytes" if type_.kind == "bytes" else "text"
    if isinstance(type_, Announced):
        return "real"
    if isinstance(type_, Quantity) and not (type_.is_plain and not field.alternative):
        return "real"
    return "number"
