"""TypeScript types for the messages as JSON, for the npm package. The build makes them."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from sbgcgen.model import Enum, Field, Layout, Message, Packed, Quantity, Scalar, Struct
from sbgcgen.model.bodies import Announced, Blob
from sbgcgen.oracle.codec import is_bytes, keys_of
from sbgcgen.targets import Target

_HEAD = """\
// Generated from spec/ by generator/: edit those.
// The messages as JSON, as `sbgc decode --format jsonl` prints them: numbers are those on the wire,
// bytes are hex digits, integers of 64 bits are text.

/** A number with named values. */
export type Named<Name extends string> = number & { readonly names: Name };

/** A number on the wire; what JSON has no number for is text. */
export type Real = number | "inf" | "-inf" | `nan:${string}`;

/** What encode() takes for a message: everything may be missing, and names may stand for numbers. */
export type Input<T> = T extends Named<infer Name>
  ? number | Name | readonly Name[]
  : T extends readonly (infer Element)[]
    ? readonly Input<Element>[]
    : T extends object
      ? { readonly [Key in keyof T]?: Input<T[Key]> }
      : T;

/** An answer: its message, and the values. */
export interface Answer<Name extends keyof AllMessages> {
  message: Name;
  fields: AllMessages[Name];
}
"""


class TypeScript(Target):
    """Interfaces of all messages and structs, and the names of enums and flags."""

    committed = False
    help = "write the types of the npm package; they are not part of generated/"
    file = "types.ts"

    def files(self, layout: Layout, project: Path) -> Iterator[tuple[str, bytes]]:
        yield self.file, "\n".join(_lines(layout)).encode() + b"\n"


@dataclass(frozen=True)
class _Names:
    """The names of the values of a number."""

    of: str
    summary: str
    values: tuple[str, ...]


def _lines(layout: Layout) -> Iterator[str]:
    yield _HEAD
    messages = {message.name: message for message in layout.messages}
    structs: dict[str, Struct] = {}
    names: dict[str, _Names] = {}
    for message in messages.values():
        _collect(message.body.fields, structs, names)
    for name in sorted(names):
        yield from _doc(names[name].summary)
        yield f"export type {name}Name = {' | '.join(map(json.dumps, names[name].values))};\n"
    for name in sorted(structs):
        yield from _interface(name, structs[name].summary, structs[name].fields)
    for message in messages.values():
        yield from _interface(message.name, message.summary, message.body.fields, message)
    for name, choice, directions in (
        ("Requests", "Messages that are sent to the board.", ("to_board", "both")),
        ("AllMessages", "All messages, by their names.", ("to_board", "both", "from_board")),
    ):
        yield from _doc(choice)
        yield f"export interface {name} {{"
        for message in messages.values():
            if message.direction in directions or message.in_both_directions:
                yield f"  {message.name}: {message.name};"
        yield "}\n"
    yield from _doc("The messages that answer a request; null for a confirmation, or none.")
    yield "export interface Answers {"
    for message in messages.values():
        if message.answer is not None:
            answers = [f"Answer<{json.dumps(name)}>" for name in message.answer.messages]
            if not message.answer.is_certain:
                answers.append("null")
            yield f"  {message.name}: {' | '.join(answers)};"
    yield "}\n"


def _collect(fields: Iterable[Field], structs: dict[str, Struct], names: dict[str, _Names]) -> None:
    for field in fields:
        type_ = field.type
        if isinstance(type_, Struct):
            if type_.name not in structs:
                structs[type_.name] = type_
                _collect(type_.fields, structs, names)
        elif (named := _names_of(field)) is not None:
            names[named.of] = named


def _names_of(field: Field) -> _Names | None:
    type_ = field.type
    if isinstance(type_, Enum):
        enums = [type_]
    elif isinstance(type_, Packed):
        enums = [part.enum for part in type_.parts if part.enum is not None]
        enums += [type_.names] if type_.names else []
    else:
        return None
    values = tuple(dict.fromkeys(value.name for enum in enums for value in enum.values))
    return _Names(type_.name, type_.summary, values) if values else None


def _interface(
    name: str, summary: str, fields: Iterable[Field], message: Message | None = None
) -> Iterator[str]:
    yield from _doc(summary)
    yield f"export interface {name} {{"
    for field in fields:
        if field.is_counter:
            continue
        yield from (f"  {line}" for line in _doc(_described(field)))
        mark = "?" if field.may_be_absent else ""
        yield f"  {field.name}{mark}: {_type_of(field)};"
    if message is not None and message.keeps_tail:
        yield "  /** Bytes after those that the model describes. */"
        yield "  tail?: string;"
    yield "}\n"


def _described(field: Field) -> str:
    if not isinstance(field.type, Quantity):
        return field.summary
    quantity = field.type
    if quantity.ratio:
        return f"{field.summary} In {quantity.unit or 'no unit'}: {quantity.formula}."
    offset = f", from {quantity.offset}" if quantity.offset else ""
    return f"{field.summary} In {quantity.scale} {quantity.unit or ''}".rstrip() + f"{offset}."


def _doc(text: str) -> Iterator[str]:
    if text:
        closed = text.replace("*/", "* /")
        yield f"/** {closed} */"


def _type_of(field: Field) -> str:
    element = _element_of(field)
    if field.dim == "one" or is_bytes(field):
        return element
    if field.dim in ("axis", "xyz") or (field.index and field.dim != "fixed"):
        keys = "; ".join(f"{key}: {element}" for key in keys_of(field))
        return f"{{ {keys} }}"
    return f"{element}[]" if element.isidentifier() else f"({element})[]"


def _element_of(field: Field) -> str:
    type_ = field.type
    if isinstance(type_, Struct):
        return type_.name
    if isinstance(type_, Blob):
        return "string"
    if isinstance(type_, Announced):
        return "Record<string, Real>"
    if (named := _names_of(field)) is not None:
        return f"Named<{named.of}Name>"
    scalar = type_ if isinstance(type_, Scalar) else type_.scalar
    if scalar.is_float:
        return "Real"
    return "string" if scalar.size == 8 else "number"
