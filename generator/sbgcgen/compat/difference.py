"""Compares two objects by the table of their class; severities.py has the tables.

A table is a sequence of steps, which report differences in order: facts (`Row`), lists (`Each`, `Values`), and
functions for comparisons that need an algorithm.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import reduce
from typing import Any, Optional, Union

from sbgcgen.compat.changes import COMPATIBLE, MEANING, SOURCE, Changes, Level
from sbgcgen.model import Position

Step = Callable[["Pair"], None]
Table = tuple[Step, ...]
# The compared fact: the path of an attribute, or a function of the object.
Getter = Union[str, Callable[[Any], Any]]
# The severity, or a function of the old and the new value; None if the change is not reported.
Severity = Union[Level, Callable[[Any, Any], Optional[Level]]]


@dataclass(frozen=True)
class Pair:
    """An object that both versions have, and the position at which differences are reported.

    `tables` are those of all classes. `names` maps names in the object to new names.
    """

    changes: Changes
    tables: Mapping[type, Table]
    what: str
    old: Any
    new: Any
    at: Position
    names: Mapping[str, str] = field(default_factory=dict)

    def inner(self, what: str, old: Any, new: Any, **more: Any) -> Pair:
        """A part of the object, reported at the same position by default."""
        return replace(self, what=self.what + what, old=old, new=new, **more)

    def compare(self, table: Table | None = None) -> None:
        """Compare by a table, by default that of the class."""
        for step in self.tables[type(self.new)] if table is None else table:
            step(self)

    def both(self, of: Getter) -> tuple[Any, Any]:
        """Return a fact about the object in both versions."""
        return fact(self.old, of), fact(self.new, of)

    def add(self, level: Level, label: str, old: object, new: object) -> None:
        """Record a different fact about the object."""
        what = ": ".join(filter(None, (self.what, label)))
        self.changes.add(level, what, old, new, self.at)

    def mark(self, level: Level, label: str, old: object, new: object) -> None:
        """Record a fact about the object unless both values are equal."""
        if old != new:
            self.add(level, label, old, new)


def fact(thing: Any, of: Getter) -> Any:
    """A fact about an object; None if the path of an attribute ends early."""
    if callable(of):
        return of(thing)
    steps = of.split(".")
    return reduce(lambda at, name: None if at is None else getattr(at, name), steps, thing)


@dataclass(frozen=True)
class Row:
    """A fact about an object: the attribute or function `of`, by default the attribute `label`.

    The report has the `text` of the value, and the `key` is compared, by default the text. The severity may
    depend on another fact `by`. The fact is compared only if `alike` is the same in both versions. With `is_name`,
    it names something that may have a new name.
    """

    label: str
    level: Severity
    of: Getter = ""
    text: Callable[[Any], object] = lambda value: value
    key: Callable[[Any], object] | None = None
    by: Getter = ""
    alike: Getter = lambda thing: None
    is_name: bool = False

    def __call__(self, pair: Pair) -> None:
        same, (old, new) = pair.both(self.alike), pair.both(self.of or self.label)
        old = pair.names.get(old, old) if self.is_name else old
        key = self.key or self.text
        if same[0] != same[1] or key(old) == key(new):
            return
        by = pair.both(self.by) if self.by else (old, new)
        level = self.level(*by) if callable(self.level) else self.level
        if level is not None:
            pair.add(level, self.label, self.text(old), self.text(new))


def rows(level: Severity, *facts: str) -> Table:
    """Attributes of the same severity, such as "start", or with a label "may be absent: appended"."""
    return tuple(Row(label, level, of) for label, _, of in (each.partition(": ") for each in facts))


@dataclass(frozen=True)
class Each:
    """A list of named things; the common ones are compared by the table of their class.

    A deleted one has the severity `gone`; an added one is compatible. The report shows their `shown` fact. A deleted
    and an added one with the same `content` count as renamed, with the severity `renamed`. Another name with the
    same `number` has a different meaning, unless it is an alias.
    """

    of: Getter
    prefix: str
    gone: Level = SOURCE
    shown: Getter = ""
    name: str = "name"
    content: Getter = lambda thing: None
    renamed: Callable[[Any, Any], Level] = lambda old, new: SOURCE
    number: Getter = lambda thing: None
    is_alias: Callable[[Any, Any], bool] = lambda old, new: False

    def __call__(self, pair: Pair) -> None:
        for both in self.pairs(pair):
            both.compare()

    def pairs(self, pair: Pair) -> Iterator[Pair]:
        """Return the things that both versions have; report the others."""
        old, new = ({fact(t, self.name): t for t in side} for side in pair.both(self.of))
        known, numbers = ({fact(t, self.number): t for t in side.values()} for side in (old, new))
        come = [thing for name, thing in new.items() if name not in old]
        for name, thing in old.items():
            number = fact(thing, self.number)
            if name in new:
                twin = new[name]
            elif number is not None and number in numbers:
                twin = self._of_same_number(pair, thing, numbers[number])
            else:
                twin = self._of_same_content(pair, thing, come)
            if twin is not None:
                at = getattr(twin, "at", pair.at)
                yield pair.inner(f"{self.prefix}{name}", thing, twin, at=at)
        for thing in come:
            number = fact(thing, self.number)
            if number is None or number not in known:
                shown = fact(thing, self.shown) if self.shown else "added"
                pair.changes.added(self._what(pair, thing), getattr(thing, "at", pair.at), shown)

    def _of_same_number(self, pair: Pair, thing: Any, other: Any) -> Any:
        """Return the thing as an alias; otherwise, report that its number has another meaning."""
        names = fact(thing, self.name), fact(other, self.name)
        if self.is_alias(thing, other):
            pair.changes.add(COMPATIBLE, self._what(pair, thing), *names, other.at)
            return other
        label = f"{pair.what}: " if pair.what else self.prefix
        pair.changes.add(MEANING, f"{label}{fact(thing, self.number)}", *names, other.at)
        return None

    def _of_same_content(self, pair: Pair, thing: Any, come: list[Any]) -> Any:
        """Return the renamed thing, and mark it as not new; report the renaming or the deletion."""
        changes, what, content = pair.changes, self._what(pair, thing), fact(thing, self.content)
        alike = [t for t in come if content is not None and fact(t, self.content) == content]
        if not alike:
            self.report_deleted(pair, thing)
            return None
        come.remove(alike[0])
        names = fact(thing, self.name), fact(alike[0], self.name)
        changes.add(self.renamed(thing, alike[0]), f"{what}: name", *names, alike[0].at)
        return alike[0]

    def report_deleted(self, pair: Pair, thing: Any) -> None:
        """Report a thing that the new version lacks."""
        shown = fact(thing, self.shown) if self.shown else "present"
        what, at = self._what(pair, thing), getattr(thing, "at", pair.at)
        pair.changes.deleted(self.gone, what, at, shown)

    def _what(self, pair: Pair, thing: Any) -> str:
        return f"{pair.what}{self.prefix}{fact(thing, self.name)}"


@dataclass(frozen=True)
class Replaced:
    """Something named; if another of the same class replaces it, their content is compared."""

    of: Getter
    content: Mapping[type, Table]
    prefix: str = ""

    def __call__(self, pair: Pair) -> None:
        old, new = pair.both(self.of)
        if type(old) is type(new) and type(new) in self.content and old.name != new.name:
            pair.inner(self.prefix, old, new, at=new.at).compare(self.content[type(new)])


class Values(Each):
    """A list of named facts; added ones are not compared."""

    def __call__(self, pair: Pair) -> None:
        old, new = ({fact(t, self.name): t for t in side} for side in pair.both(self.of))
        for name, thing in new.items():
            what = f"{self.prefix}{name}"
            pair.inner(what, old.pop(name, None), thing, at=thing.at).compare()
        for thing in old.values():
            self.report_deleted(pair, thing)
