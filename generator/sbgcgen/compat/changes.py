"""Changes between two versions of the protocol, and their severity."""

from __future__ import annotations

import enum
from dataclasses import dataclass, field

from sbgcgen.model import Availability, Position, Versions
from sbgcgen.model.packed_text import text_of


class Level(enum.Enum):
    """Severity of a change, the worst first."""

    WIRE = "wire-breaking"
    MEANING = "meaning-breaking"
    SOURCE = "source-breaking"
    COMPATIBLE = "compatible"


WIRE, MEANING = Level.WIRE, Level.MEANING
SOURCE, COMPATIBLE = Level.SOURCE, Level.COMPATIBLE


@dataclass(frozen=True)
class Change:
    """One change; `at` is its position in the new spec, or in the old one if `in_old`."""

    level: Level
    what: str
    old: str
    new: str
    at: Position
    in_old: bool


@dataclass
class Changes:
    """Collects changes; `what` names the changed object, `written` is the notation of versions."""

    written: Versions = Versions()
    found: list[Change] = field(default_factory=list)

    def add(
        self, level: Level, what: str, old: object, new: object, at: Position, in_old: bool = False
    ) -> None:
        """Record an object that differs between the versions."""
        change = Change(level, what, self.text(old), self.text(new), at, in_old)
        if change not in self.found:
            self.found.append(change)

    def deleted(self, level: Level, what: str, at: Position, old: object = "present") -> None:
        """Record an object that the new version lacks."""
        self.add(level, what, old, "deleted", at, in_old=True)

    def added(
        self, what: str, at: Position, new: object = "added", level: Level = Level.COMPATIBLE
    ) -> None:
        """Record an object that the old version lacks."""
        self.add(level, what, None, new, at)

    def text(self, value: object) -> str:
        """A value as text for the report."""
        if value is None or value == "":
            return "none"
        if isinstance(value, bool):
            return "yes" if value else "no"
        if isinstance(value, (tuple, list)):
            return ", ".join(self.text(item) for item in value) or "none"
        return self.versions(value) if isinstance(value, Availability) else str(value)

    def versions(self, since: Availability) -> str:
        """The versions of an availability in words."""
        words = []
        for kind, number in (("firmware", since.firmware), ("board", since.board)):
            type_ = self.written.of(kind)
            if number:
                words.append(f"{kind} {text_of(type_, number) if type_ else number}")
        return ", ".join(words) or "always"
