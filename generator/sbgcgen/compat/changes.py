"""Changes between two versions of the protocol, and their severity."""

from __future__ import annotations

import enum
from collections.abc import Callable
from dataclasses import dataclass, field
from operator import attrgetter
from typing import Any

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

    def add(self, level: Level, what: str, old: object, new: object, at: Position) -> None:
        """Record an object that differs between the versions."""
        self._append(Change(level, what, text(old), text(new), at, False))

    def deleted(self, level: Level, what: str, at: Position, old: object = "present") -> None:
        """Record an object that the new version lacks."""
        self._append(Change(level, what, text(old), "deleted", at, True))

    def added(
        self, what: str, at: Position, new: object = "added", level: Level = Level.COMPATIBLE
    ) -> None:
        """Record an object that the old version lacks."""
        self._append(Change(level, what, "none", text(new), at, False))

    def compare(self, level: Level, what: str, old: object, new: object, at: Position) -> None:
        """Record a change unless both values are equal."""
        if old != new:
            self.add(level, what, old, new, at)

    def pair(self, what: str, old: Any, new: Any) -> Pair:
        """An object that both versions have; what differs is reported at its new position."""
        return Pair(self, what, old, new, new.at)

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


@dataclass(frozen=True)
class Pair:
    """An object that both versions have, and the position at which what differs is reported."""

    changes: Changes
    what: str
    old: Any
    new: Any
    at: Position

    def inner(self, what: str, old: Any, new: Any) -> Pair:
        """A part of the object, reported at the same position."""
        return Pair(self.changes, self.what + what, old, new, self.at)

    def compare(
        self,
        level: Level,
        label: str,
        of: str | Callable[[Any], object] = "",
        added: Level | None = None,
    ) -> None:
        """Compare an attribute, or what `of` returns for the object; by default the attribute `label`.

        `added` is the severity if the old version has nothing there.
        """
        if isinstance(of, str):
            of = attrgetter(of or label)
        before, now = of(self.old), of(self.new)
        level = added if added is not None and not before else level
        self.changes.compare(level, f"{self.what}: {label}", before, now, self.at)

    def mark(self, level: Level, label: str, old: object, new: object) -> None:
        """Record a change unless both values, which are facts about the object, are equal."""
        self.changes.compare(level, f"{self.what}: {label}", old, new, self.at)

    def compare_needs(self) -> None:
        """Compare the feature of boards; one that was not needed before breaks the meaning."""
        self.compare(MEANING if self.new.needs else COMPATIBLE, "needs")

    def compare_since(self) -> None:
        """Compare the availability; only a later version than before breaks the meaning."""
        level = MEANING if self.new.since.is_after(self.old.since) else COMPATIBLE
        self.compare(level, "since", lambda thing: self.changes.versions(thing.since))


def text(value: object) -> str:
    """A value as text for the report."""
    if value is None or value == "":
        return "none"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, (tuple, list)):
        return ", ".join(text(item) for item in value) or "none"
    return str(value)
