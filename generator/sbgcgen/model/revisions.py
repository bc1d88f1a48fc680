"""What the revisions of the specification have added."""

from __future__ import annotations

from dataclasses import dataclass, field

from sbgcgen.model.position import NOWHERE, Position


@dataclass(frozen=True)
class Addition:
    """Something that a revision has added.

    `kind` is "command", "message", "field" or "value"; `owner` is the message of a field or the enum
    of a value, and `name` the command, message, path or value.
    """

    kind: str
    owner: str
    name: str

    @property
    def text(self) -> str:
        return f"{self.owner}.{self.name}" if self.owner else self.name


@dataclass(frozen=True)
class Revision:
    """A revision of the specification; `changes` are sentences about what has no name of its own."""

    number: str
    date: str
    source: str
    adds: tuple[Addition, ...]
    changes: tuple[str, ...]
    at: Position = field(default=NOWHERE, compare=False, repr=False)
