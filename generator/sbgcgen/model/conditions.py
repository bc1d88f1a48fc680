"""Conditions on earlier fields and contexts, on which the content of a body depends."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property, reduce
from itertools import product
from operator import or_
from typing import Any

from sbgcgen.model.packed_text import part_of
from sbgcgen.model.values import Enum, EnumValue, Part


@dataclass(frozen=True)
class Condition:
    """A condition on one number: a context, an earlier field or its element, or a `part` of these.

    For flags: all of `flags`, at least one of `any_flags`, and none of `no_flags` are set. For other numbers:
    the value is one of `numbers`, or if `negated` none of them (`values` are their names), and between
    `at_least` and `at_most`. `is_wrapped`: C++ has the number in a class, whose raw value counts. If the
    earlier field is missing (see `source_may_be_missing`), the condition is false.

    With `terms`, it is about several numbers: "all" of the terms hold, or "one_of" them, according to `joined`.
    In a group of fields, the source may be a field of the message (`is_outside`), and the condition may differ
    between the `elements` of an index; `pattern` has the words for all of them.
    """

    source: str
    from_context: bool
    enum: Enum | None  # None for a plain integer
    flags: tuple[EnumValue, ...] = ()
    any_flags: tuple[EnumValue, ...] = ()
    no_flags: tuple[EnumValue, ...] = ()
    numbers: tuple[int, ...] = ()
    values: tuple[EnumValue, ...] = ()
    negated: bool = False
    may_be_missing: bool = False
    source_may_be_missing: bool = False
    part: Part | None = None
    is_wrapped: bool = False
    at_least: int | None = None
    at_most: int | None = None
    joined: str = ""
    terms: tuple[Condition, ...] = ()
    is_outside: bool = False
    elements: tuple[tuple[str, Condition], ...] = ()
    pattern: str = ""

    def of(self, word: str) -> Condition:
        """The condition for an element of an index."""
        if self.terms:
            return replace(self, terms=tuple(term.of(word) for term in self.terms))
        return dict(self.elements).get(word, self)

    @cached_property
    def tests(self) -> tuple[Condition, ...]:
        """The conditions on single numbers of which it consists."""
        return tuple(test for term in self.terms for test in term.tests) or (self,)

    @cached_property
    def is_on_flags(self) -> bool:
        return self.enum is not None and self.enum.kind == "flags"

    @property
    def is_on_values(self) -> bool:
        """True if it lists the values of one number for which it holds."""
        return bool(self.numbers) and not self.negated

    @cached_property
    def mask(self) -> int:
        """The flags that must all be set."""
        return reduce(or_, (flag.value for flag in self.flags), 0)

    @property
    def subject(self) -> str:
        """The value that it depends on."""
        return f"{self.source}.{self.part.name}" if self.part else self.source

    @property
    def clauses(self) -> tuple[tuple[str, str, tuple[Any, ...]], ...]:
        """The parts that must all hold: a verb, a conjunction, and values or numbers.

        For example ("has", "and", (FLAG_A, FLAG_B)), ("lacks", "and", (FLAG_C,)).
        """
        limits = (self.at_least, self.at_most)
        clauses = (
            ("has", "and", self.flags),
            ("has", "or", self.any_flags),
            ("lacks", "and", self.no_flags),
            ("is not" if self.negated else "is", "or", self.values or self.numbers),
            *(
                (word, "and", () if limit is None else (limit,))
                for word, limit in zip(("is at least", "is at most"), limits)
            ),
        )
        return tuple(clause for clause in clauses if clause[2])

    @property
    def words(self) -> str:
        """The condition in words, such as "OPTIONS has FLAG_A and FLAG_B, and lacks FLAG_C"."""
        if self.terms:
            words = (" and " if self.joined == "all" else " or ").join(t.words for t in self.terms)
            return words if self.joined == "all" else f"either {words}"
        return self.pattern or f"{self.subject} " + ", and ".join(
            f"{verb} " + f" {join} ".join(str(getattr(v, "name", v)) for v in values)
            for verb, join, values in self.clauses
        )

    def holds(self, value: int | None) -> bool:
        """True if the condition holds for a value of its source, which is None if missing."""
        if value is None:
            return False
        return self.accepts(part_of(self.part, value) if self.part else value)

    def accepts(self, value: int) -> bool:
        """True if the condition holds for this value of the number."""
        if self.is_on_flags:
            return (
                value & self.mask == self.mask
                and (not self.any_flags or any(value & f.value == f.value for f in self.any_flags))
                and not (self.no_flags and any(value & f.value == f.value for f in self.no_flags))
            )
        return (
            (not self.numbers or (value in self.numbers) != self.negated)
            and (self.at_least is None or value >= self.at_least)
            and (self.at_most is None or value <= self.at_most)
        )

    def holds_in(
        self,
        fields: Mapping[str, Any],
        context: Mapping[str, Any] | None = None,
        outside: Mapping[str, Any] | None = None,
    ) -> bool:
        """True if the condition holds for these fields, facts from earlier messages, and outer fields."""
        if self.terms:
            return (all if self.joined == "all" else any)(
                term.holds_in(fields, context, outside) for term in self.terms
            )
        if self.from_context:
            return self.holds((context or {}).get(self.source, 0))
        value = value_at((outside or {}) if self.is_outside else fields, self.source)
        return self.holds(None if value is None else int(value))


def value_at(fields: Mapping[str, Any], path: str) -> Any:
    """The value at a path such as "mode", "modes.yaw" or "channels[2]"; None if it is missing."""
    found: Any = fields
    if path in fields:
        return fields[path]
    for step in re.findall(r"\w+", path):
        if found is None:
            return None
        found = found[int(step)] if isinstance(found, list) else found.get(step)
    return found


def satisfying(when: Condition) -> list[dict[str, int]]:
    """Values of the sources for which a condition holds, without other bits.

    With several fields, those of each alternative; for a negated condition, the smallest.
    """
    if not when.terms:
        return [{when.source: value} for value in _candidates(when)]
    if when.joined == "one_of":
        return [values for term in when.terms for values in satisfying(term)]
    choices: dict[str, set[int]] = {}
    for test in when.tests:
        known = choices.setdefault(test.source, set())
        known |= {old | new for old in known for new in _candidates(test) if old >= 0 and new >= 0}
        known.update(_candidates(test))
    found = (
        dict(zip(choices, values))
        for values in product(*[sorted(known) for known in choices.values()])
    )
    return [values for values in found if when.holds_in(values, values, values)][:4]


def _candidates(when: Condition) -> list[int]:
    """Values of the source for which a condition on one number holds."""
    if when.is_on_flags:
        found = [when.mask | flag.value for flag in when.any_flags] or [when.mask]
    elif when.is_on_values:
        found = [number for number in when.numbers if when.accepts(number)]
    else:
        limits = [n for n in (when.at_least, when.at_most) if n is not None]
        step = 1
        if when.part and not when.part.is_digits:  # a mask in place has multiples of its lowest bit
            step = (bits := when.part.mask >> when.part.shift) & -bits
        first = (limits[0] // step - 256) * step if limits else 0
        around = range(first, first + 513 * step, step)
        found = [n for n in limits if _is_met(when, n)]
        found = found or [n for n in around if _is_met(when, n)][:1]
    return [_whole(when, n) for n in found]


def _whole(when: Condition, number: int) -> int:
    """The value of the source whose part is this number."""
    part = when.part
    if part is None:
        return number
    return number * part.divide if part.is_digits else part.bits_of(number)


def _is_met(when: Condition, number: int) -> bool:
    """True if the condition holds for the number, and its part can have that value."""
    return when.accepts(number) and when.holds(_whole(when, number))
