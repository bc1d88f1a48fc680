"""Revisions of the specification and their additions."""

from __future__ import annotations

from dataclasses import dataclass, field

from sbgcgen.model.position import NOWHERE, Position


@dataclass(frozen=True)
class Addition:
    """An addition of a revision.

    `kind` is "command", "message", "field" or "value"; `owner` is the message of a field or the
    enum of a value, and `name` is the command, message, path or value.
    """

    kind: str
    owner: str
    name: str

    @property
    def text(self) -> str:
        return f"{self.owner}.{self.name}" if self.owner else self.name


@dataclass(frozen=True)
class Revision:
    """A revision of the specification; `changes` are sentences about changes without a name."""

    number: str
    date: str
    source: str
    adds: tuple[Addition, ...]
    changes: tuple[str, ...]
    at: Position = field(default=NOWHERE, compare=False, repr=False)
