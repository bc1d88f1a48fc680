"""What changed between two versions of the protocol, and whom it hurts."""

from __future__ import annotations

import enum
from dataclasses import dataclass, field
from fractions import Fraction

from sbgcgen.model import Availability, Position, Versions
from sbgcgen.model.packed_text import text_of


class Level(enum.Enum):
    """Classes of changes, the worst first."""

    WIRE = "wire-breaking"
    MEANING = "meaning-breaking"
    SOURCE = "source-breaking"
    COMPATIBLE = "compatible"


@dataclass(frozen=True)
class Change:
    """One change. It stands at `at` in the new spec, or in the old one if it is a deletion."""

    level: Level
    what: str
    old: str
    new: str
    at: Position
    in_old: bool


@dataclass
class Changes:
    """Collects changes; `what` says which thing they are about, `written` how versions are written."""

    written: Versions = Versions()
    found: list[Change] = field(default_factory=list)

    def add(self, level: Level, what: str, old: object, new: object, at: Position) -> None:
        """Something that is in both versions and differs."""
        self._append(Change(level, what, text(old), text(new), at, False))

    def deleted(self, level: Level, what: str, at: Position, old: object = "there") -> None:
        """Something that the new version has no more."""
        self._append(Change(level, what, text(old), "deleted", at, True))

    def added(
        self, what: str, at: Position, new: object = "added", level: Level = Level.COMPATIBLE
    ) -> None:
        """Something that the old version had not."""
        self._append(Change(level, what, "none", text(new), at, False))

    def compare(self, level: Level, what: str, old: object, new: object, at: Position) -> None:
        """Record a change unless both values are the same."""
        if old != new:
            self.add(level, what, old, new, at)

    def since(self, what: str, old: Availability, new: Availability, at: Position) -> None:
        """A later version than before excludes somebody, an earlier one does not."""
        later = new.firmware > old.firmware or new.board > old.board
        level = Level.MEANING if later else Level.COMPATIBLE
        self.compare(level, f"{what}: since", self.versions(old), self.versions(new), at)

    def versions(self, since: Availability) -> str:
        """The versions of an availability in words."""
        words = []
        for kind, number in (("firmware", since.firmware), ("board", since.board)):
            type_ = self.written.of(kind)
            if number:
                words.append(f"{kind} {text_of(type_, number) if type_ else number}")
        return ", ".join(words) or "always"

    def _append(self, change: Change) -> None:
        if change not in self.found:
            self.found.append(change)


def text(value: object) -> str:
    """A value as the report shows it."""
    if value is None or value == "":
        return "none"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, (tuple, list)):
        return ", ".join(text(item) for item in value) or "none"
    if isinstance(value, Fraction):
        return str(value)
    return str(value)
