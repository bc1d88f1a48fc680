"""The history of the protocol: additions, changes and removals of each version."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from sbgcgen.model import NOWHERE, Availability, Command, Enum, EnumValue, Framing, Later, Layout
from sbgcgen.model import Message, Variable
from sbgcgen.model.packed_text import part_of, raw_of, text_of
from sbgcgen.views.rows import Row, rows_of


@dataclass
class News:
    """The additions, changes and removals of one version; `since` is only that version.

    `forms` are new messages of older commands. `changed` are values, and `meanings` fields, with a
    changed meaning.
    """

    since: Availability
    framings: list[Framing] = field(default_factory=list)
    commands: list[Command] = field(default_factory=list)
    messages: list[Message] = field(default_factory=list)
    fields: list[tuple[Message, Row]] = field(default_factory=list)
    enum_values: list[tuple[Enum, EnumValue]] = field(default_factory=list)
    variables: list[Variable] = field(default_factory=list)
    changed: list[tuple[Enum, EnumValue]] = field(default_factory=list)
    meanings: list[tuple[Message, Row, Later]] = field(default_factory=list)
    ended: list[Message] = field(default_factory=list)
    deprecated: list[tuple[Message, Row]] = field(default_factory=list)
    deprecated_messages: list[Message] = field(default_factory=list)

    @property
    def text(self) -> str:
        """The version without its kind: "2.68b7"."""
        return self.since.words[0][1]

    @property
    def forms(self) -> list[Message]:
        names = {command.name for command in self.commands}
        return [message for message in self.messages if message.command not in names]

    def messages_of(self, command: Command) -> list[Message]:
        """The messages that were introduced with a new command."""
        return [message for message in self.messages if message.command == command.name]


@dataclass(frozen=True)
class Release:
    """A firmware with its beta versions, such as 2.68 with 2.68b7; `news` is in their order."""

    text: str
    news: tuple[News, ...]


class History:
    """The news of all firmware and board versions, the oldest first."""

    def __init__(self, layout: Layout) -> None:
        self._of: dict[tuple[int, int], News] = {}
        self._layout = layout
        for framing in layout.framings:
            self._note(framing.since, "framings", framing)
        for message in layout.definitions:
            self._add_message(message)
        for command in layout.commands:
            self._note(command.since, "commands", command)
        for enum in layout.enums:
            # The ids of commands and variables derive from these, and have no position of their own.
            for value in enum.values if enum.at is not NOWHERE else ():
                former = value.former.firmware if value.former else None
                self._note(former, "changed", (enum, value))
                if value.since != former:
                    self._note(value.since, "enum_values", (enum, value))
        for variable in layout.variables:
            self._note(variable.since, "variables", variable)

    @property
    def of_boards(self) -> list[News]:
        return [self._of[key] for key in sorted(self._of) if key[1]]

    @property
    def of_firmware(self) -> list[News]:
        return [self._of[key] for key in sorted(self._of) if key[0]]

    @property
    def releases(self) -> list[Release]:
        """The firmware versions by release."""
        found: dict[str, list[News]] = {}
        for news in self.of_firmware:
            found.setdefault(self.release_of(news.since), []).append(news)
        return [Release(text, tuple(news)) for text, news in found.items()]

    @cached_property
    def choices(self) -> list[tuple[str, list[tuple[int, str]]]]:
        """The firmware versions with differences, with their numbers, by release.

        All releases since the oldest firmware are included, even those without news.
        """
        found = {news.since.firmware: news.text for news in self.of_firmware}
        type_ = self._layout.versions.firmware
        oldest, newest = self._layout.oldest_firmware, self._layout.newest_firmware
        if type_ is not None and newest:
            found.setdefault(newest, text_of(type_, newest))
            for number in range(oldest, newest) if oldest else ():
                text = text_of(type_, number)
                if text == self.release_of(Availability(number, firmware_text=text)):
                    found.setdefault(number, text)
        by_release: dict[str, dict[int, str]] = {}
        for number, text in sorted(found.items()):
            release = self.release_of(Availability(number, firmware_text=text))
            whole = raw_of(type_, release) if type_ is not None else None
            of_release = by_release.setdefault(release, {} if whole is None else {whole: release})
            of_release[number] = text
        return [(release, sorted(of.items())) for release, of in by_release.items()]

    def release_of(self, since: Availability) -> str:
        """The release to which a firmware version belongs: 2.68 for 2.68b7."""
        type_ = self._layout.versions.firmware
        if type_ is None:
            return since.firmware_text
        parts = {part.name: part_of(part, since.firmware) for part in type_.parts}
        return re.sub(r"\[[^]]*\]", "", type_.display).format(**parts)

    def _at(self, since: Availability) -> Iterator[News]:
        """The news of the firmware and of the board of an availability."""
        for kind in ("firmware", "board"):
            number = getattr(since, kind)
            if number:
                text = {f"{kind}_text": getattr(since, f"{kind}_text")}
                key = (number, 0) if kind == "firmware" else (0, number)
                yield self._of.setdefault(key, News(Availability(**{kind: number}, **text)))

    def _note(self, since: Availability | None, kind: str, thing: Any) -> None:
        """Add something to a list of the news of these versions."""
        for news in self._at(since or Availability()):
            getattr(news, kind).append(thing)

    def _add_message(self, message: Message) -> None:
        self._note(message.since, "messages", message)
        self._note(message.until.versions if message.until else None, "ended", message)
        mark = message.deprecated
        self._note(mark.since if mark else None, "deprecated_messages", message)
        for row in rows_of(message) if not message.same_as else ():
            for news in self._at(row.field.since):
                if news.since.is_after(message.since):
                    news.fields.append((message, row))
            for later in row.field.later:
                self._note(later.since, "meanings", (message, row, later))
            mark = row.field.deprecated
            self._note(mark.since if mark else None, "deprecated", (message, row))


def deprecated_always(layout: Layout) -> list[tuple[Message, Row]]:
    """The fields that are deprecated in all versions."""
    return [
        (message, row)
        for message in layout.definitions
        for row in rows_of(message)
        if row.field.deprecated and not row.field.deprecated.since
    ]
