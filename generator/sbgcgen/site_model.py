"""What the pages of the site tell beyond the Layout: rows of tables, and who uses what."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from sbgcgen.filters import versions
from sbgcgen.model import (
    Availability,
    Command,
    Enum,
    Field,
    Layout,
    Leaf,
    Message,
    Packed,
    Quantity,
    Revision,
    Struct,
    Type,
)
from sbgcgen.names import slug
from sbgcgen.reference_codec import CodecError, choose_message, forms_of


@dataclass(frozen=True)
class Row:
    """A line of a field table: a field, or a group of them, with all places where it stands.

    `path` has a * for each index; `leaves` is empty for a group. The rows of what a region may hold
    have `is_case`.
    """

    path: str
    depth: int
    field: Field
    leaves: tuple[Leaf, ...]
    is_case: bool = False

    @property
    def name(self) -> str:
        return self.path.rpartition(".")[2] if self.depth else self.path

    @property
    def spec_name(self) -> str:
        """The protocol's name, with {AXIS} or {1..5} where there is one for each element."""
        return self.field.spec_name

    def index_of(self, leaf: Leaf) -> str:
        """What tells a leaf from the others of its row: "roll", "[2]"."""
        pattern = re.escape(self.path).replace(r"\*", r"(\w+)").replace(r"\[\]", r"\[(\d*)\]")
        match = re.fullmatch(pattern, leaf.path)
        assert match, f"{leaf.path} is not {self.path}"
        words = [f"[{word}]" if word.isdigit() else word for word in match.groups() if word]
        return " ".join(words)


@dataclass(frozen=True)
class Block:
    """A piece of a byte map: (part of) a leaf in one row of eight bytes.

    `start` and `end` are columns; `first` and `last` tell whether the leaf begins and ends here.
    """

    leaf: Leaf
    number: int
    start: int
    end: int
    first: bool
    last: bool


@dataclass(frozen=True)
class Use:
    """A place that uses a type or an erratum: what it is called, and where to read of it."""

    kind: str
    name: str
    page: str


def page_of_message(message: Message) -> str:
    """The path of a message's page."""
    return f"messages/{slug(message.name)}.html"


def page_of_type(type_: Enum | Packed | Quantity) -> str:
    """The path of the page of an enum, a flag set, a packed integer or a quantity."""
    folder = {Packed: "packed", Quantity: "units", Enum: "enums"}[type(type_)]
    return f"{folder}/{slug(type_.name)}.html"


# Rows and byte maps


def rows_of(message: Message) -> list[Row]:
    """The rows of a message's field table, in wire order."""
    return list(_rows(message.fields, "", 0, message.leaves))


def _rows(
    fields: Iterable[Field], path: str, depth: int, leaves: tuple[Leaf, ...]
) -> Iterator[Row]:
    for member in fields:
        name = path + member.name + _indices(member)
        if isinstance(member.type, Struct) and not member.type.is_region:
            yield Row(name, depth, member, ())
            yield from _rows(member.type.fields, f"{name}.", depth + 1, leaves)
            continue
        found = tuple(leaf for leaf in leaves if leaf.field is member and _fits(name, leaf.path))
        yield Row(name, depth, member, found)
        if isinstance(member.type, Struct):
            for inner in member.type.fields[:-1]:
                cases = [case for leaf in found for case in leaf.cases if case.field is inner]
                yield Row(f"{name}.{inner.name}", depth + 1, inner, tuple(cases), True)


def _indices(member: Field) -> str:
    if member.dim in ("axis", "xyz"):
        return ".*"
    is_list = member.dim in ("fixed", "counted", "rest")
    has_leaves = (
        isinstance(member.type, Struct)
        or bool(member.index)
        or (member.dim == "fixed" and member.type.kind in ("text", "bytes", "string"))
    )
    return "[]" if is_list and has_leaves else ""


def _fits(pattern: str, path: str) -> bool:
    return re.sub(r"\[\d+\]", "[]", path) == pattern or bool(
        re.fullmatch(re.escape(pattern).replace(r"\*", r"\w+").replace(r"\[\]", r"\[\d*\]"), path)
    )


def size_of_leaf(leaf: Leaf) -> int | None:
    """The bytes that a leaf takes, None if that varies."""
    if leaf.count is None or leaf.type == "string":
        return None
    sizes = {"u8": 1, "i8": 1, "u16": 2, "i16": 2, "u32": 4, "i32": 4, "f32": 4}
    return leaf.count * sizes.get(leaf.type, 1)


def byte_map(message: Message) -> tuple[list[list[Block]], list[Leaf]]:
    """The bytes with a fixed place, in rows of eight; and the leaves that follow them."""
    lines: list[list[Block]] = []
    rest: list[Leaf] = []
    number = -1
    previous: Field | None = None
    for leaf in message.leaves:
        size = size_of_leaf(leaf)
        if leaf.offset is None or size is None or leaf.field.is_variable or "[]" in leaf.path:
            rest.append(leaf)
            continue
        number += leaf.field is not previous or leaf.field.dim == "one"
        previous = leaf.field
        at, end = leaf.offset, leaf.offset + size
        while at < end:
            stop = min(end, at - at % 8 + 8)
            while len(lines) <= at // 8:
                lines.append([])
            start = at % 8
            block = Block(leaf, number, start, start + stop - at, at == leaf.offset, stop == end)
            lines[at // 8].append(block)
            at = stop
    return lines, rest


def sizes_of(message: Message, layout: Layout) -> str:
    """The sizes of a body that make it this form of the command: "13", "16 to 255"."""
    forms = forms_of(layout)
    taken = []
    for size in range(layout.framing.max_body + 1):
        try:
            if choose_message(forms, message.direction, message.id, size).name == message.name:
                taken.append(size)
        except CodecError:
            pass
    runs: list[list[int]] = []
    for size in taken:
        if runs and runs[-1][-1] == size - 1:
            runs[-1].append(size)
        else:
            runs.append([size])
    words = [str(run[0]) if len(run) == 1 else f"{run[0]} to {run[-1]}" for run in runs]
    return ", ".join(words)


# Who uses what


@dataclass
class References:
    """Uses by the name of a type, the number of an erratum, or the name of a message."""

    types: dict[str, list[Use]] = field(default_factory=dict)
    errata: dict[str, list[Use]] = field(default_factory=dict)
    answers: dict[str, list[Message]] = field(default_factory=dict)
    storers: dict[str, list[Message]] = field(default_factory=dict)
    contexts: dict[str, list[Message]] = field(default_factory=dict)

    def of_type(self, name: str, use: Use) -> None:
        _add(self.types, name, use)

    def of_errata(self, numbers: Iterable[str], use: Use) -> None:
        for number in numbers:
            _add(self.errata, number, use)


def _add(where: dict[str, list[Use]], name: str, use: Use) -> None:
    uses = where.setdefault(name, [])
    if use not in uses:
        uses.append(use)


def references(layout: Layout) -> References:
    """Everything that is used anywhere, with its uses in the order of the protocol."""
    found = References()
    for command in layout.commands:
        page = f"families/{command.family}.html#{command.name}"
        found.of_errata(command.errata, Use("command", command.name, page))
    for message in layout.messages:
        _of_message(message, layout, found)
    types: tuple[Enum | Packed | Quantity, ...] = (
        *layout.enums,
        *layout.packed,
        *layout.quantities,
    )
    for type_ in types:
        use = Use(_kind(type_), type_.name, page_of_type(type_))
        found.of_errata(type_.errata, use)
        if isinstance(type_, Enum):
            for value in type_.values:
                page = f"{page_of_type(type_)}#{value.name}"
                found.of_errata(value.errata, Use("value", f"{type_.name} · {value.name}", page))
        if isinstance(type_, Packed):
            for part in type_.parts:
                if part.enum:
                    page = f"{page_of_type(type_)}#part-{part.name}"
                    found.of_type(
                        part.enum.name, Use("packed value", f"{type_.name} · {part.name}", page)
                    )
            if type_.names:
                found.of_type(type_.names.name, use)
    for variable in layout.variables:
        use = Use("adjustable variable", variable.name, f"variables.html#{variable.name}")
        found.of_errata(variable.errata, use)
        if variable.quantity:
            found.of_type(variable.quantity.name, use)
    found.of_errata(layout.framing.errata, Use("framing", "framing", "framing.html"))
    return found


def _of_message(message: Message, layout: Layout, found: References) -> None:
    page = page_of_message(message)
    here = Use("message", message.name, page)
    found.of_errata(message.errata, here)
    if message.answer:
        found.of_errata(message.answer.errata, Use("message", message.name, f"{page}#answer"))
        for name in message.answer.messages:
            found.answers.setdefault(name, []).append(message)
        if message.answer.confirm != "never":
            for confirming in layout.having_role("confirmation"):
                found.answers.setdefault(confirming.name, []).append(message)
    if message.stores:
        found.storers.setdefault(message.stores, []).append(message)
    for context in message.contexts:
        names = [context.announced.message] if context.announced else []
        for name in names + [source for source, _ in context.sources]:
            found.contexts.setdefault(name, []).append(message)
        if context.type:
            found.of_type(context.type.name, Use("message", message.name, f"{page}#context"))
    for row in rows_of(message):
        anchor = row.leaves[0].path if row.leaves else row.path
        use = Use("field", f"{message.name} · {row.path}", f"{page}#field-{anchor}")
        found.of_errata(row.field.errata, use)
        type_: Type = row.field.type
        if isinstance(type_, (Enum, Packed, Quantity)):
            found.of_type(type_.name, use)
        if row.field.alternative:
            found.of_type(row.field.alternative.quantity.name, use)


def _kind(type_: Enum | Packed | Quantity) -> str:
    if isinstance(type_, Enum):
        return "flag set" if type_.kind == "flags" else "enum"
    return "packed value" if isinstance(type_, Packed) else "unit"


def confirmation(layout: Layout) -> Message | None:
    """The message that confirms, if the protocol has one."""
    return next(iter(layout.having_role("confirmation")), None)


def siblings(message: Message, layout: Layout) -> list[Message]:
    """All messages with the same id, in both directions."""
    return [m for m in layout.messages if m.id == message.id]


def instances(message: Message, layout: Layout) -> list[Message]:
    """A message in each of its directions."""
    return [m for m in layout.messages if m.name == message.name]


# Since when


@dataclass(frozen=True)
class Added:
    """What a version has brought, or what it has deprecated."""

    version: str
    messages: tuple[Message, ...]
    commands: tuple[Command, ...]
    fields: tuple[tuple[Message, Row], ...]
    values: tuple[tuple[Enum, str, str], ...]
    deprecated: tuple[tuple[Message, Row], ...]


def added(layout: Layout) -> list[Added]:
    """One entry for each firmware version, then for each board version that anything is about."""
    rows = [(message, row) for message in layout.definitions for row in rows_of(message)]
    everything: set[Availability] = {message.since for message in layout.messages}
    everything |= {row.field.since for _, row in rows}
    everything |= {row.field.deprecated.since for _, row in rows if row.field.deprecated}
    everything |= {value.since for enum in layout.enums for value in enum.values}
    parts = [Availability(firmware=n) for n in sorted({a.firmware for a in everything} - {0})]
    parts += [Availability(board=n) for n in sorted({a.board for a in everything} - {0})]

    def is_in(since: Availability, part: Availability) -> bool:
        if part.firmware:
            return since.firmware == part.firmware
        return since.board == part.board

    return [
        Added(
            version=versions(part),
            messages=tuple(m for m in layout.definitions if is_in(m.since, part)),
            commands=tuple(c for c in layout.commands if is_in(c.since, part)),
            fields=tuple((m, row) for m, row in rows if is_in(row.field.since, part)),
            values=tuple(
                (enum, value.name, value.summary)
                for enum in layout.enums
                for value in enum.values
                if is_in(value.since, part)
            ),
            deprecated=tuple(
                (m, row)
                for m, row in rows
                if row.field.deprecated and is_in(row.field.deprecated.since, part)
            ),
        )
        for part in parts
    ]


class Revisions:
    """Which revision of the specification has added what."""

    def __init__(self, layout: Layout) -> None:
        self._of = {
            (addition.kind, addition.owner, addition.name): revision
            for revision in layout.revisions
            for addition in revision.adds
        }
        self._same = {m.name: m.same_as for m in layout.messages if m.same_as}

    def of(self, kind: str, owner: str, name: str) -> Revision | None:
        """The revision that names it, or for a field one of the groups that it belongs to.

        The fields of a message with the body of another one are those of that one.
        """
        owner = self._same.get(owner, owner) if kind == "field" else owner
        name = re.sub(r"\[\d*\]", "", name) if kind == "field" else name
        found = self._of.get((kind, owner, name))
        while found is None and kind == "field" and "." in name:
            name = name.rpartition(".")[0]
            found = self._of.get((kind, owner, name))
        return found

    def of_message(self, message: Message) -> Revision | None:
        """The revision that names a message, or else its command."""
        return self.of("message", "", message.name) or self.of("command", "", message.command)


def deprecated_always(layout: Layout) -> list[tuple[Message, Row]]:
    """The fields that should not be used any more, whatever the version."""
    return [
        (message, row)
        for message in layout.definitions
        for row in rows_of(message)
        if row.field.deprecated and not row.field.deprecated.since
    ]
