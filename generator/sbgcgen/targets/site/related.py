"""Related pages for a reader of a message page, derived from the protocol and the guides."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from html import unescape

from sbgcgen.model import Layout, Message, Struct
from sbgcgen.targets.site.guides import Guide
from sbgcgen.targets.site.uses import References, instances
from sbgcgen.views.rows import rows_of

# The maximum number of listed neighbors in the family; the page of the family lists all.
_NEIGHBORS = 6
_GUIDES = 5


@dataclass(frozen=True)
class Mention:
    """A section of a guide that names a message: its title, and its page with the anchor."""

    title: str
    page: str


@dataclass(frozen=True)
class Related:
    """The messages and guides that belong to a message, each once."""

    exchange: list[Message]  # requests and answers
    structs: list[Message]  # with parts of the same types
    family: list[Message]
    guides: list[Mention]
    tasks: list[str]  # command lines that send it, or another form of it


class Relations:
    """Finds the pages related to a message."""

    def __init__(self, layout: Layout, guides: Sequence[Guide], uses: References) -> None:
        self._layout = layout
        self._uses = uses
        self._by_name = {m.name: m for m in layout.definitions}
        self._users: dict[str, list[Message]] = {}
        for message in layout.definitions:
            for name in _structs(message):
                self._users.setdefault(name, []).append(message)
        self._mentions = _mentions(guides)
        self._tasks = _tasks(guides)

    def of(self, message: Message) -> Related:
        seen = {message.name}

        def new(found: Iterable[Message]) -> list[Message]:
            fresh = [m for m in found if m.name not in seen]
            fresh = list({m.name: m for m in fresh}.values())
            seen.update(m.name for m in fresh)
            return fresh

        names = (message.name, message.command)
        mentions = [mention for name in names for mention in self._mentions.get(name, ())]
        return Related(
            new(self._exchange(message)),
            new(user for name in _structs(message) for user in self._users[name]),
            new(self._neighbors(message)),
            list(dict.fromkeys(mentions))[:_GUIDES],
            self._tasks_of(message),
        )

    def _exchange(self, message: Message) -> Iterator[Message]:
        """The messages before and after it on the line. Every request may be confirmed."""
        is_confirmation = message in self._layout.having_role("confirmation")
        found = instances(message, self._layout)
        names = [name for m in found if m.answer for name in m.answer.messages]
        names += [message.stores] if message.stores else []
        names += [m.name for m in self._uses.storers.get(message.name, ())]
        if not is_confirmation:
            names += [m.name for m in self._uses.answers.get(message.name, ())]
        for instance in found:
            names += instance.role.messages if instance.role else ()
        yield from (self._by_name[name] for name in names)

    def _neighbors(self, message: Message) -> list[Message]:
        family = [m for m in self._layout.definitions if m.family == message.family]
        at = family.index(self._by_name[message.name])
        nearest = sorted(range(len(family)), key=lambda i: abs(i - at))[: _NEIGHBORS + 1]
        return [family[i] for i in sorted(nearest)]

    def _tasks_of(self, message: Message) -> list[str]:
        if all(m.direction == "from_board" for m in instances(message, self._layout)):
            return []
        forms = [m.name for m in self._layout.definitions if m.command == message.command]
        names = [message.name, *forms]  # its own tasks first
        return list(dict.fromkeys(task for name in names for task in self._tasks.get(name, ())))


def _structs(message: Message) -> list[str]:
    types = [row.field.type for row in rows_of(message)]
    return list(dict.fromkeys(t.name for t in types if isinstance(t, Struct)))


def _mentions(guides: Sequence[Guide]) -> dict[str, list[Mention]]:
    """The sections of guides by the words of the names in them."""
    found: dict[str, list[Mention]] = {}
    for guide in guides:
        for part in guide.parts:
            title = re.sub(r"<[^>]*>", "", part.heading)
            mention = Mention(
                f"{guide.title}: {title}" if title else guide.title,
                f"{guide.page}#{part.anchor}" if part.anchor else guide.page,
            )
            for word in dict.fromkeys(re.findall(r"\b[A-Z]\w+", part.html)):
                found.setdefault(word, []).append(mention)
    return found


def _tasks(guides: Sequence[Guide]) -> dict[str, list[str]]:
    """The command lines in the guides' tables that send each message, by message."""
    found: dict[str, list[str]] = {}
    for guide in guides:
        rows = re.findall(
            r"<tr>\s*<td><code>([^<]+)</code></td>\s*<td>(.*?)</td>", guide.html, re.DOTALL
        )
        for task, cell in rows:
            for name in re.findall(r"<code>(\w+)</code>", cell) if " " in task else ():
                found.setdefault(name, []).append(unescape(task))
    return found
