"""Generates the test vectors of a message, with the bodies that are most likely to expose bugs."""

from __future__ import annotations

import copy
import re
import zlib
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Optional

from sbgcgen.model import Blob, Condition, Field, Message, Struct, conditions, satisfying, value_at
from sbgcgen.oracle.codec import CodecError, Fields
from sbgcgen.oracle.compose import Choice, Places, all_types, compose, counter_size
from sbgcgen.oracle.compose import documented_length, first_that_fits, full_context, typical_context
from sbgcgen.oracle.compose import variable_parts
from sbgcgen.oracle.decoding import decode
from sbgcgen.oracle.encoding import encode
from sbgcgen.oracle.room import has_room


@dataclass(frozen=True)
class Vector:
    """A body with its fields, or a body or fields with the error of decoding or encoding them."""

    message: Message
    why: str
    body: bytes | None
    fields: Fields | None
    context: Fields
    error: CodecError | None = None


def vectors_of(message: Message, is_known: bool = False) -> list[Vector]:
    """The vectors of a message; only a few if the body is shared with another message."""
    maker = _Maker(message)
    maker.typical()
    maker.uniform()
    if is_known:
        maker.add(maker.choice(context=full_context(message)))
    else:
        maker.rounds()
        maker.lengths()
        maker.random()
        maker.too_much()
        maker.out_of_place()
    maker.tails()
    maker.truncated()
    return maker.vectors


def typical_vector(message: Message) -> Vector:
    """The first vector that can be decoded, which has typical values."""
    maker = _Maker(message)
    maker.typical()
    maker.uniform()
    if not maker.readable():
        maker.rounds()
    return maker.readable()[0]


def _typical_body(message: Message) -> tuple[bytes, Fields] | None:
    """A body of typical values that satisfies the first condition on a field, and its context."""
    forced: Fields = next((case["forced"] for case in cases_of(message) if "forced" in case), {})
    context = typical_context(message)
    for short in (False, True):
        choice = Choice(
            Places(),
            typical=True,
            context=context,
            forced=forced,
            short=short,
            example=message.example,
        )
        try:
            body = encode(message, compose(message, choice))
        except CodecError:
            continue
        if len(body) <= message.max_size:
            return body, context
    return None


def cases_of(message: Message) -> Iterator[dict[str, Any]]:
    """For each condition, the options of a choice that satisfies it."""
    seen = []
    for when in conditions(message):
        for value in satisfying(_with_those_of_sources(when, message)):
            case = {"context" if when.from_context else "forced": value}
            if case not in seen:
                seen.append(case)
                yield case
    for context in message.contexts:
        if context.announced:
            known = all_types(context)
            for types in (known, known[:1], known[:1] * 254):
                yield {"context": {context.name: types}}


def _with_those_of_sources(when: Condition, message: Message) -> Condition:
    """The condition, and the conditions under which its sources are present."""
    needed = [
        field.when
        for field in message.fields
        if field.when and field.name in {test.source for test in when.tests}
    ]
    if when.from_context or not needed or any(other.from_context for other in needed):
        return when
    terms = (when, *(_with_those_of_sources(other, message) for other in needed))
    together = Condition("", False, None, joined="all", terms=terms)
    return together if satisfying(together) else when


class _Maker:
    """Collects the distinct vectors of one message."""

    def __init__(self, message: Message) -> None:
        self.message = message
        self.vectors: list[Vector] = []
        self.seen: set[tuple[str, str]] = set()
        self.places = Places()

    def readable(self) -> list[Vector]:
        """The vectors that have a body and can be decoded."""
        return [v for v in self.vectors if v.body is not None and v.fields is not None]

    # Kinds of vectors

    def typical(self) -> None:
        """Ordinary values that satisfy the first condition on a field."""
        found = _typical_body(self.message)
        if found:
            self.add_body(*found, "typical values")

    def uniform(self) -> None:
        """All bits zero, and all bits one."""
        for name, byte in (("zeros", b"\x00"), ("ones", b"\xff")):
            self.add_body(byte * self.message.min_size, {}, f"all {name}")

    def rounds(self) -> None:
        """Every edge value of every field, with all fields of a message varied at once.

        Neighbors have different edge values, so that a field at a wrong offset is noticed. Then each
        condition is satisfied, for as many rounds as its dependent fields need.
        """
        for choice in self.all_rounds({}, "free"):
            self.add(choice)
        for case in cases_of(self.message):
            for choice in self.all_rounds(case, "conditional"):
                self.add(choice)
            if any(when.may_be_missing for when in conditions(self.message)):
                self.add(self.choice(short=True, leave_out=True, **case), "without optional fields")
        for field in self.message.fields:
            if field.fits and field.scalar:
                for case in cases_of(self.message):
                    self.add(self.choice(fits=True, **case), f"with {field.name}")
                for value in (field.scalar.minimum, field.scalar.maximum):
                    forced = {field.name: value}
                    self.add(self.choice(fits=True, forced=forced), f"{field.name} = {value}")
            if field.appended:
                choice = self.choice(ends_before=field.name)
                self.add(choice, f"firmware that ends before {field.name}")
                there = compose(self.message, self.choice())
                there.pop(field.name)
                self.add_refused(there, f"{field.name} is missing, what follows it is not")
            if field.has_grown_elements:
                self.elements(field)
        if self.message.contexts:
            self.add(self.choice(context=full_context(self.message)))

    def elements(self, of: Field) -> None:
        """Elements of every size that they have had, and elements of different sizes in one list."""
        assert isinstance(of.type, Struct)
        there = compose(self.message, self.choice())
        for field in (field for field in of.type.fields if field.appended):
            path = f"{of.name}[].{field.name}"
            self.add(self.choice(ends_before=path), f"firmware whose elements end before {path}")
            mixed = copy.deepcopy(there)
            if len(mixed[of.name]) > 1:
                mixed[of.name][0].pop(field.name)
                self.add_refused(mixed, f"the first element lacks {field.name}, the others do not")

    def lengths(self) -> None:
        """Lists and texts of length 0, 1, the minimum, the documented and the possible maximum."""
        for path, member, beside in variable_parts(self.message.fields):
            case: dict[str, Any] = {"context": full_context(self.message)}
            if member.when and not member.when.from_context:
                case["forced"] = satisfying(member.when)[0]
            if member.fits:
                case["fits"] = True
            if member.counter and not member.has_hidden_counter:
                prefix = path[: len(path) - len(member.name)]
                for mask in _counts(member, counter_size(beside, member)):
                    forced = {**case.get("forced", {}), f"{prefix}{member.counter}": mask}
                    choice = self.choice(**{**case, "forced": forced})
                    what = "an element for each bit" if member.counting == "bits" else "the count"
                    self.add(choice, f"{path} with {what} of {mask:#x}")
                continue
            if member.dim in ("counted", "rest") and not path.endswith("[]"):
                documented = documented_length(beside, member)
                least = member.min_count
                lengths = {0, 1, max(0, least - 1), least, documented, member.capacity}
            else:
                empty = self.choice(short=True, lengths={path: 0}, **{**case, "fits": False})
                rest = self.message.room - len(first_that_fits(self.message, empty))
                assert isinstance(member.type, Blob)
                lengths = {0, 1, min(rest, member.type.size or rest)}
                if member.fits:  # what follows it is a mistake
                    self.add_refused(
                        compose(self.message, self.choice(lengths={path: 1}, fits=True)),
                        f"something after {path}",
                    )
            for length in sorted(lengths):
                choice = self.choice(short=True, lengths={path: length}, **case)
                self.add(choice, f"{path} of length {length}")

    def random(self) -> None:
        """Bodies of pseudo-random bytes, which need not be valid."""
        numbers = _Random(zlib.crc32(f"{self.message.direction} {self.message.name}".encode()))
        for number in (1, 2):
            size = numbers.between(self.message.min_size, self.message.max_size)
            body = bytes(numbers.between(0, 255) for _ in range(size))
            self.add_body(body, full_context(self.message), f"random {number}")

    def tails(self) -> None:
        """Tails: one byte, and as many as fit. Surplus exceeds the largest size of a request."""
        if not self.message.keeps_tail and not self.message.takes_surplus:
            return
        context, body = self.whole(short=self.message.keeps_tail)
        least = max(1, self.message.max_size + 1 - len(body)) if self.message.takes_surplus else 1
        for size in sorted({1, least, self.message.room - len(body)}):
            tail = bytes((251 * i + 165) % 256 for i in range(size))
            self.add_body(body + tail, context, f"a tail of {size} bytes")

    def truncated(self) -> None:
        """Truncated bodies, one for each distinct error, and one body that is too long."""
        context, whole = self.whole()
        reported: set[tuple[str, str]] = set()
        # All bodies that are shorter than the fixed part have the same error.
        least = max(0, self.message.body.fixed_size - 1)
        for size in (len(whole) + 1, *range(len(whole) - 1, least - 1, -1)):
            body = (whole + b"\x5a")[:size]
            try:
                decode(self.message, body, context)
            except CodecError as error:
                if (error.code, error.field) not in reported:
                    reported.add((error.code, error.field))
                    self.add_body(body, context, f"{size} bytes instead of {len(whole)}")

    def too_much(self) -> None:
        """Lists and tails at their capacity, which do not fit beside all other fields."""
        context = full_context(self.message)
        for path, member, _ in variable_parts(self.message.fields):
            if member.dim in ("counted", "rest") and not path.endswith("[]") and not member.when:
                choice = self.choice(context=context, lengths={path: member.capacity})
                self.add_refused(compose(self.message, choice), f"too many {path}")
        if self.message.keeps_tail or self.message.takes_surplus:
            fields = compose(self.message, self.choice(context=context))
            tail = bytes(self.message.tail_capacity).hex()
            self.add_refused({**fields, "tail": tail}, "a tail that is too long")

    def out_of_place(self) -> None:
        """Conditional fields that are present or missing contrary to their condition."""
        for case in cases_of(self.message):
            forced = case.get("forced", {})
            for source, value in forced.items():
                other = self.value_of_no_condition(source, forced)
                if other is None or value_at(compose(self.message, self.choice()), source) is None:
                    continue
                there = compose(self.message, self.choice(**case))
                self.add_refused(_with(there, source, other), f"with another {source}")
                absent = compose(self.message, self.choice(forced={**forced, source: other}))
                self.add_refused(_with(absent, source, value), f"missing for this {source}")

    # Inputs

    def whole(self, short: bool = False) -> tuple[Fields, bytes]:
        """A body with as many fields as fit, and its context."""
        contexts: list[Fields] = [full_context(self.message), typical_context(self.message), {}]
        for context in contexts:
            for is_short in (True,) if short else (False, True):
                try:
                    choice = self.choice(short=is_short, context=context)
                    return context, encode(self.message, compose(self.message, choice))
                except CodecError:
                    continue
        # A number that counts a list is large in all of these.
        empty = {
            path[: len(path) - len(member.name)] + member.counter: 0
            for path, member, _ in variable_parts(self.message.fields)
            if member.counter and not member.has_hidden_counter
        }
        choice = self.choice(short=True, forced=empty)
        return {}, encode(self.message, compose(self.message, choice))

    def value_of_no_condition(self, source: str, others: Fields) -> Optional[int]:
        """A value of a field that satisfies no condition on it; None if there is none."""
        asked = [w for w in conditions(self.message) if source in {t.source for t in w.tests}]
        # Avoid neighbors that later conditions may use.
        numbers: list[int] = [0, *range(127, 0, -1)]
        for number in numbers:
            if not any(w.holds_in({**others, source: number}) for w in asked):
                return number
        return None

    def choice(self, **options: Any) -> Choice:
        return Choice(self.places, **options)

    def all_rounds(self, case: dict[str, Any], kind: str) -> Iterator[Choice]:
        """The choices for all values of the free or conditional fields; use each one immediately."""
        last = self.choice(**case)
        yield last
        named = set(last.numbers[kind])
        while last.round + 1 < last.rounds[kind]:
            last = self.choice(round=last.round + 1, **case)
            yield last
            named |= last.numbers[kind]
        for number in sorted(named):
            yield self.choice(round=number, named=number, **case)

    # Results

    def add(self, choice: Choice, why: str = "") -> None:
        """Add the composed message, or the error if it cannot be encoded."""
        fields = compose(self.message, choice)
        why = why or choice.why()
        try:
            self.add_body(encode(self.message, fields), choice.context, why)
        except CodecError:
            self.add_refused(fields, why)

    def add_body(self, body: bytes, context: Fields, why: str) -> None:
        """Add a body with its fields or the error of decoding it."""
        if not self._is_new(body, context):
            return
        try:
            fields = decode(self.message, body, context)
        except CodecError as error:
            self.vectors.append(Vector(self.message, why, body, None, context, error))
        else:
            self.vectors.append(Vector(self.message, why, body, fields, context))

    def add_refused(self, fields: Fields, why: str) -> None:
        """Add fields with the error of encoding them, if there is one and they can be held."""
        if not has_room(self.message.fields, fields):
            return
        try:
            encode(self.message, fields)
        except CodecError as error:
            if self._is_new(fields, {}):
                self.vectors.append(Vector(self.message, why, None, fields, {}, error))

    def _is_new(self, given: bytes | Fields, context: Fields) -> bool:
        key = repr(given), repr(context)
        if key in self.seen:
            return False
        self.seen.add(key)
        return True


def _counts(member: Field, size: int) -> list[int]:
    """Values of a visible counter: for no, one and all elements."""
    part = member.counter_part
    if part is None:
        return [0, 1, (1 << 8 * size) - 1]
    most = part.limits[1]
    return sorted({part.bits_of(n) for n in (0, 1, min(3, most), most)})


def _with(fields: Fields, path: str, value: int) -> Fields:
    steps = re.findall(r"\w+", path)
    result = copy.deepcopy(fields)
    found: Any = result
    for step in steps[:-1]:
        found = found[int(step)] if isinstance(found, list) else found[step]
    found[int(steps[-1]) if isinstance(found, list) else steps[-1]] = value
    return result


class _Random:
    """A linear congruential generator, the same in every version of Python."""

    def __init__(self, seed: int) -> None:
        self.state = seed

    def between(self, low: int, high: int) -> int:
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % (1 << 64)
        return low + (self.state >> 33) % (max(low, high) - low + 1)
