"""Cross-references: the uses of types, errata and messages, with links to pages."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace

from sbgcgen.model import Availability, Enum, Field, Layout, Message, Packed, Quantity, Type
from sbgcgen.model.names import slug
from sbgcgen.views.rows import rows_of


@dataclass(frozen=True)
class Use:
    """A use of a type or an erratum: its kind, name, page and first versions."""

    kind: str
    name: str
    page: str
    since: Availability = Availability()


_FOLDERS = {Message: "messages", Packed: "packed", Quantity: "units", Enum: "enums"}


def page_of(item: Message | Enum | Packed | Quantity) -> str:
    """The path of the page of a message or type."""
    return f"{_FOLDERS[type(item)]}/{slug(item.name)}.html"


@dataclass
class References:
    """Uses by name of a type, number of an erratum, or name of a message."""

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
    """All uses, in the order of the protocol."""
    found = References(answers=asked_by(layout))
    for command in layout.commands:
        page = f"families/{command.family}.html#{command.name}"
        found.of_errata(command.errata, Use("command", command.name, page, command.since))
    for message in layout.messages:
        _of_message(message, found)
    for type_ in layout.types:
        use = Use(_kind(type_), type_.name, page_of(type_))
        found.of_errata(type_.errata, use)
        if isinstance(type_, Enum):
            for value in type_.values:
                page = f"{use.page}#{value.name}"
                name = f"{type_.name} · {value.name}"
                found.of_errata(value.errata, Use("value", name, page, value.since))
        if isinstance(type_, Packed):
            for part in type_.parts:
                inner = part.enum or part.quantity
                if inner:
                    page = f"{use.page}#part-{part.name}"
                    name = f"{type_.name} · {part.name}"
                    found.of_type(inner.name, Use("packed value", name, page))
            if type_.names:
                found.of_type(type_.names.name, use)
    for variable in layout.variables:
        page = f"variables.html#{variable.name}"
        use = Use("adjustable variable", variable.name, page, variable.since)
        found.of_errata(variable.errata, use)
        if variable.quantity:
            found.of_type(variable.quantity.name, use)
    for framing in layout.framings:
        found.of_errata(framing.errata, Use("framing", framing.name, "framing.html"))
    return found


def _of_message(message: Message, found: References) -> None:
    page = page_of(message)
    here = Use("message", message.name, page, message.since)
    found.of_errata(message.errata, here)
    if message.answer:
        found.of_errata(message.answer.errata, replace(here, page=f"{page}#answer"))
    if message.stores:
        found.storers.setdefault(message.stores, []).append(message)
    for context in message.contexts:
        names = [context.announced.message] if context.announced else []
        for name in names + [source for source, _ in context.sources]:
            found.contexts.setdefault(name, []).append(message)
        if context.type:
            found.of_type(context.type.name, replace(here, page=f"{page}#context"))
    for row in rows_of(message):
        since = message.since.later(row.since)
        use = Use("field", f"{message.name} · {row.path}", f"{page}#field-{row.first}", since)
        found.of_errata(row.field.errata, use)
        for type_, _ in _types_of(row.field):
            if isinstance(type_, (Enum, Packed, Quantity)):
                found.of_type(type_.name, use)


def _types_of(field_: Field) -> Iterator[tuple[Type, Availability]]:
    """The types of a field, with the first versions of its later ones."""
    yield field_.type, Availability()
    if field_.alternative:
        yield field_.alternative.quantity, Availability()
    yield from ((later.type, later.since) for later in field_.later)


def _kind(type_: Enum | Packed | Quantity) -> str:
    if isinstance(type_, Enum):
        return "flag set" if type_.kind == "flags" else "enum"
    return "packed value" if isinstance(type_, Packed) else "unit"


def instances(message: Message, layout: Layout) -> list[Message]:
    """A message in each of its directions."""
    return [m for m in layout.messages if m.name == message.name]


def availability_of_types(layout: Layout) -> dict[str, Availability]:
    """The first firmware in which something uses a type, if all of its uses have one."""
    found: dict[str, list[Availability]] = {}

    def add(type_: object, since: Availability) -> None:
        if isinstance(type_, (Enum, Packed, Quantity)):
            found.setdefault(type_.name, []).append(since)
        for part in type_.parts if isinstance(type_, Packed) else ():
            add(part.enum or part.quantity, since)
        if isinstance(type_, Packed):
            add(type_.names, since)

    for message in layout.messages:
        for row in rows_of(message):
            since = message.since.later(row.since)
            for type_, later in _types_of(row.field):
                add(type_, since.later(later))
        for context in message.contexts:
            add(context.type, message.since)
    for variable in layout.variables:
        add(variable.quantity, variable.since)
    return {name: min(all_, key=lambda since: since.firmware) for name, all_ in found.items()}


def asked_by(layout: Layout) -> dict[str, list[Message]]:
    """The requests that each message answers or confirms, by the message's name."""
    found: dict[str, list[Message]] = {}
    for message in layout.messages:
        if message.answer is None:
            continue
        series = {case.series for case in message.answer.cases if case.series}
        for name in (*message.answer.messages, *sorted(series)):
            found.setdefault(name, []).append(message)
        if message.answer.confirm != "never":
            for confirming in layout.having_role("confirmation"):
                found.setdefault(confirming.name, []).append(message)
    return found
