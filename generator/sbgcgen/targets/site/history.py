"""Additions and deprecations of each version."""

from __future__ import annotations

from dataclasses import dataclass, replace

from sbgcgen.model import Availability, Command, Enum, Layout, Message
from sbgcgen.targets.site.rows import Row, rows_of
from sbgcgen.views.words import versions


@dataclass(frozen=True)
class Added:
    """The additions and deprecations of a version."""

    version: str
    messages: tuple[Message, ...]
    commands: tuple[Command, ...]
    fields: tuple[tuple[Message, Row], ...]
    values: tuple[tuple[Enum, str, str], ...]
    deprecated: tuple[tuple[Message, Row], ...]


def added(layout: Layout) -> list[Added]:
    """One entry for each firmware version, then for each board version, with changes."""
    rows = [(message, row) for message in layout.definitions for row in rows_of(message)]
    everything: set[Availability] = {message.since for message in layout.messages}
    everything |= {row.field.since for _, row in rows}
    everything |= {row.field.deprecated.since for _, row in rows if row.field.deprecated}
    everything |= {value.since for enum in layout.enums for value in enum.values}
    of_firmware = {a.firmware: replace(a, board=0) for a in everything if a.firmware}
    of_board = {a.board: replace(a, firmware=0) for a in everything if a.board}
    parts = [part for found in (of_firmware, of_board) for _, part in sorted(found.items())]

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


def deprecated_always(layout: Layout) -> list[tuple[Message, Row]]:
    """The fields that are deprecated in all versions."""
    return [
        (message, row)
        for message in layout.definitions
        for row in rows_of(message)
        if row.field.deprecated and not row.field.deprecated.since
    ]
