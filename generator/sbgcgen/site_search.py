"""What the search of the site finds."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Protocol

from sbgcgen.filters import title_of
from sbgcgen.model import Layout, Message
from sbgcgen.site_model import page_of_message, page_of_type, rows_of

# kind, name, what it is about, page, other words that find it
Entry = tuple[str, str, str, str, str]


class Page(Protocol):
    """A guide, as far as the search is concerned."""

    @property
    def title(self) -> str:
        ...

    @property
    def page(self) -> str:
        ...


def search_entries(layout: Layout, guides: Sequence[Page]) -> list[Entry]:
    """Everything that can be found, the more important first."""
    return list(_entries(layout, guides))


def _entries(layout: Layout, guides: Sequence[Page]) -> Iterator[Entry]:
    for message in layout.definitions:
        words = f"{message.command} {message.id} 0x{message.id:02x}"
        yield "message", message.name, message.summary, page_of_message(message), words
    for command in layout.commands:
        page = f"families/{command.family}.html#{command.name}"
        number = "" if command.id is None else f"{command.id} 0x{command.id:02x}"
        yield "command", command.name, command.summary, page, number
    for family in layout.families:
        if family.messages:
            page = f"families/{family.name}.html"
            yield "family", title_of(family.name), family.summary, page, ""
    for guide in guides:
        yield "guide", guide.title, "", guide.page, ""
    for enum in layout.enums:
        kind = "flags" if enum.kind == "flags" else "enum"
        yield kind, enum.name, enum.summary, page_of_type(enum), ""
    for packed in layout.packed:
        parts = " ".join(part.name for part in packed.parts)
        yield "packed", packed.name, packed.summary, page_of_type(packed), parts
    for quantity in layout.quantities:
        words = f"{quantity.unit or ''} {quantity.accessor} {quantity.scale_text}"
        yield "unit", quantity.name, quantity.summary, page_of_type(quantity), words
    for message in layout.definitions:
        yield from _fields(message)
    for enum in layout.enums:
        for value in enum.values:
            page = f"{page_of_type(enum)}#{value.name}"
            about = f"{value.value}: {value.summary}"
            yield "value", value.name, about, page, f"{enum.name} {value.identifier}"
    for variable in layout.variables:
        page = f"variables.html#{variable.name}"
        yield "variable", variable.name, variable.summary, page, str(variable.id)
    for erratum in layout.errata:
        page = f"errata.html#{erratum.number}"
        yield "erratum", erratum.number, f"{erratum.problem} {erratum.reading}", page, ""


def _fields(message: Message) -> Iterator[Entry]:
    for row in rows_of(message):
        if row.field.reserved:
            continue
        anchor = row.leaves[0].path if row.leaves else row.path
        name = f"{message.name}.{row.path}"
        names = dict.fromkeys(leaf.spec_name for leaf in row.leaves)
        paths = [leaf.path for leaf in row.leaves if len(row.leaves) <= 6]
        words = " ".join([*names, *(path for path in paths if path != row.path)])
        page = f"{page_of_message(message)}#field-{anchor}"
        yield "field", name, row.field.summary, page, words
