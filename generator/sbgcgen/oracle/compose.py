"""Composes messages with chosen values in all fields."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any, Optional

from sbgcgen.model import SCALARS, Announced, Blob, Condition, Context, Field, Message, Struct, Type
from sbgcgen.model import conditions, element_of, satisfying
from sbgcgen.oracle.codec import LISTS, CodecError, Fields, is_bytes, keys_of, scalar_of
from sbgcgen.oracle.edges import Edge, counting, edges, named_numbers, with_number
from sbgcgen.oracle.encoding import counter_of, encode
from sbgcgen.oracle.typical import typical


def all_types(context: Context) -> list[str]:
    """Each type that may be announced, and one of them repeatedly."""
    assert context.announced is not None
    known = [name for name in SCALARS if name in context.announced.types]
    several = "i16" if "i16" in known else known[-1]
    return [*known, several, several]


@dataclass
class Places:
    """The value positions of a message, numbered on first use, with their edge values."""

    numbers: dict[str, int] = field(default_factory=dict)
    known: dict[str, tuple[int, list[Edge], frozenset[int]]] = field(default_factory=dict)

    def number(self, path: str) -> int:
        return self.numbers.setdefault(path, len(self.numbers))

    def at(self, path: str, member: Field, type_: Type) -> tuple[int, list[Edge], frozenset[int]]:
        """The number of a position, its edge values, and the numbers with a name there."""
        found = self.known.get(path)
        if found is None:
            found = (self.number(path), edges(member, type_), named_numbers(type_))
            self.known[path] = found
        return found


@dataclass
class Choice:
    """The choice of values for a message.

    Each round uses another edge value at every place, shifted by the place's number so that neighbors differ. With
    `named`, places with named values have this number, which may have a name in some of them: so a new name adds at
    most one round and changes none. `forced` has values of fields by path, `lengths` those of lists and texts. Other
    lists are long enough for all edge values, or minimal if `short`. The body ends before the field `ends_before`. With
    `fits`, it has the optional field. If `typical`, all values except those in `example` are ordinary.
    Composing finds how many `rounds` the free and the conditional fields need, and the `numbers` with a name in them.
    """

    places: Places
    round: int = 0
    named: Optional[int] = None
    context: Fields = field(default_factory=dict)
    forced: Fields = field(default_factory=dict)
    lengths: dict[str, int] = field(default_factory=dict)
    short: bool = False
    leave_out: bool = False
    ends_before: str = ""
    fits: bool = False
    typical: bool = False
    example: Fields = field(default_factory=dict)
    chosen: list[tuple[str, str]] = field(default_factory=list)
    rounds: dict[str, int] = field(default_factory=lambda: {"free": 1, "conditional": 1})
    numbers: dict[str, set[int]] = field(default_factory=lambda: defaultdict(set))

    def why(self) -> str:
        """A description of the chosen values, or only of the round if it would be too long."""
        text = ", ".join(f"{path} = {name}" for path, name in self.chosen)
        if not text:
            return "no variable values"
        return text if len(text) <= 100 else f"round {self.round} of edge values of all fields"


def compose(message: Message, choice: Choice) -> Fields:
    """The fields of a message with the chosen values."""
    return compose_fields(message.body, choice)


def compose_fields(body: Struct, choice: Choice) -> Fields:
    """Like compose(), for a body or struct."""
    return _Composer(choice).fields(body, "", {})


def first_that_fits(message: Message, *choices: Choice) -> bytes:
    """The body of the first choice that fits into a body. The last choice must fit."""
    for choice in choices[:-1]:
        try:
            return encode(message, compose(message, choice))
        except CodecError:
            pass
    return encode(message, compose(message, choices[-1]))


def full_context(message: Message) -> Fields:
    """A context with all flags that fields depend on and all types announced."""
    context: Fields = {}
    for when in conditions(message):
        if when.from_context:
            known = context.get(when.source, 0)
            wanted = satisfying(when)[0][when.source]
            context[when.source] = known | wanted if when.is_on_flags else wanted
    context.update({c.name: all_types(c) for c in message.contexts if c.announced})
    return context


def typical_context(message: Message) -> Fields:
    """A context with some of the flags that fields depend on and all types announced."""
    context: Fields = {}
    for when in conditions(message):
        known = context.get(when.source, 0)
        if when.from_context and when.is_on_flags and bin(known).count("1") < 2:
            context[when.source] = known | satisfying(when)[0][when.source]
    return {**full_context(message), **context}


def variable_parts(
    fields: tuple[Field, ...], path: str = ""
) -> Iterator[tuple[str, Field, tuple[Field, ...]]]:
    """The lists and length-prefixed texts: path, member, and the member list that contains it."""
    for member in fields:
        name = path + member.name
        is_list = member.dim in ("counted", "rest")
        if isinstance(member.type, Announced):
            continue  # its context determines the length
        if is_list:
            yield name, member, fields
        if isinstance(member.type, Blob) and member.type.kind == "string":
            yield name + "[]" * is_list, member, fields
        elif isinstance(member.type, Struct) and member.type.size is None:
            yield from variable_parts(member.type.fields, f"{name}{'[]' * is_list}.")


def counter_size(beside: tuple[Field, ...], member: Field) -> int:
    """The size of the field whose bits count the elements of a list."""
    counter = next(other for other in beside if other.name == member.counter)
    return scalar_of(counter.type).size


def documented_length(beside: tuple[Field, ...], member: Field) -> int:
    """The maximum number of elements that the specification describes for a list."""
    most = member.capacity if member.max_count is None else member.max_count
    for counter in beside:
        if counter.name == member.counter and counter.maximum is not None:
            most = int(counter.maximum)
    return min(most, member.capacity)


class _Composer:
    def __init__(self, choice: Choice) -> None:
        self.choice = choice
        self.conditional = False
        self.element = 0  # sum of the indices in enclosing lists
        self.word = ""  # of the index of an enclosing group

    def fields(self, body: Struct, path: str, around: Fields) -> Fields:
        values: Fields = {}
        outside, ends_before = self.conditional, self.choice.ends_before
        for member in body.fields:
            name = member.name
            if ends_before and path + name == ends_before:
                return values
            if member.fits and not self.choice.fits:
                continue
            if member.when:
                if not self._is_present(member.when.of(self.word), values, around):
                    continue
                self.conditional = True
            values[name] = self._member(member, body.fields, path, values)
            self.conditional = outside
            if member.has_hidden_counter:
                values[member.counter] = max(0, counter_of(member, values[name]))
        return values

    def _is_present(self, when: Condition, values: Fields, around: Fields) -> bool:
        is_left_out = when.may_be_missing and self.choice.leave_out
        return not is_left_out and when.holds_in({**around, **values}, self.choice.context, around)

    def _member(self, member: Field, fields: tuple[Field, ...], path: str, values: Fields) -> Any:
        name = path + member.name
        choice = self.choice
        if choice.typical:
            if name in choice.example:
                return self._given(member, choice.example[name], f"{name}[]")
            if self._is_typical(member, name):
                return member.typical
        if member.repeats_context and member.when:
            return choice.context[member.when.source]
        if name in choice.forced:
            return choice.forced[name]
        if member.is_counter:
            return 0  # set after its list
        if member.dim == "one":
            around = values if isinstance(member.type, Struct) and member.type.is_region else {}
            if isinstance(member.type, Struct) and member.type.looks_outside:
                around = values
            return self._value(member, name, around)
        if isinstance(member.type, Struct) and member.type.looks_outside:
            elements = [self._in_group(member, name, values, *e) for e in member.elements]
            return elements if member.dim == "fixed" else dict(zip(keys_of(member), elements))
        if member.dim not in LISTS:
            return {key: self._value(member, f"{name}.{key}") for key in keys_of(member)}
        if isinstance(member.type, Announced):
            return self._announced(member, member.type, name)
        count = member.count if member.dim == "fixed" else self._length(member, fields, name)
        if member.counter and not member.has_hidden_counter:
            count = member.counted(int(values[member.counter]))
        if is_bytes(member):
            return counting(count).hex()
        if member.dim == "fixed":
            return [self._value(member, f"{name}[{i}]") for i in range(count)]
        return [self._element(member, f"{name}[]", i) for i in range(count)]

    def _in_group(self, member: Field, name: str, values: Fields, suffix: str, word: str) -> Any:
        """An element of a group whose content depends on the surrounding fields."""
        outside, self.word = self.word, word
        value = self._value(member, name + suffix, values)
        self.word = outside
        return value

    def _is_typical(self, member: Field, name: str) -> bool:
        """True if the whole field has its typical value."""
        if member.typical is None or name in self.choice.forced:
            return False
        return not any(path.startswith((f"{name}.", f"{name}[")) for path in self.choice.example)

    def _given(self, member: Field, value: Any, path: str) -> Any:
        """A value of the example; members of elements that it lacks are typical."""
        if not isinstance(member.type, Struct):
            return value
        return [{**self._element(member, path, i), **one} for i, one in enumerate(value)]

    def _announced(self, member: Field, type_: Announced, path: str) -> list[Fields]:
        """A number of each announced type."""
        outside, self.conditional = self.conditional, True
        types = self.choice.context.get(type_.context, [])[: member.capacity]
        numbers = [
            {name: self._value(member, f"{path}[{i}].{name}", type_=SCALARS[name])}
            for i, name in enumerate(types)
        ]
        self.conditional = outside
        return numbers

    def _element(self, member: Field, path: str, number: int) -> Any:
        """An element of a list, with another edge value than its neighbors."""
        outside, self.element = self.element, self.element + number
        value = self._value(member, path)
        self.element = outside
        return value

    def _length(self, member: Field, fields: tuple[Field, ...], name: str) -> int:
        choice = self.choice
        if name in choice.lengths:
            return choice.lengths[name]
        if choice.short:
            is_needed = any(path.startswith(f"{name}[]") for path in choice.lengths)
            return max(member.min_count, int(is_needed))
        if choice.typical:
            usual = 0 if member.reserved else 4 if is_bytes(member) else 3
            usual = max(usual, member.min_count)
            return min(-(-usual // member.align) * member.align, documented_length(fields, member))
        if member.index:
            typical = len(member.index)
        elif is_bytes(member) or isinstance(member.type, Struct):
            typical = 2
        else:
            typical = len(choice.places.at(f"{name}[]", member, member.type)[1])
        return min(max(typical, member.min_count), documented_length(fields, member))

    def _value(
        self, member: Field, path: str, around: Any = None, type_: Type | None = None
    ) -> Any:
        type_, choice = type_ or member.type, self.choice
        if path in choice.forced:
            return choice.forced[path]
        if isinstance(type_, Struct):
            return self.fields(type_, f"{path}.", around or {})
        if isinstance(type_, Blob) and type_.kind == "string":
            length = choice.lengths.get(path, 0 if choice.short else None)
            if length is not None:
                return "".join(chr(65 + i % 26) for i in range(length))
        if choice.typical:
            return self._typical(member, type_, path)
        return self._edge(member, type_, path)

    def _edge(self, member: Field, type_: Type, path: str) -> Any:
        """The edge value of the round, which differs between neighbors."""
        choice = self.choice
        number, found, names = choice.places.at(path, member, type_)
        kind = "conditional" if self.conditional else "free"
        choice.rounds[kind] = max(choice.rounds[kind], len(found))
        choice.numbers[kind] |= names
        if choice.named is not None and names:
            value = with_number(type_, choice.named + self.element)
            choice.chosen.append((path, str(value)))
            return value
        name, value = found[(choice.round + self.element + number) % len(found)]
        choice.chosen.append((path, name))
        return value

    def _typical(self, member: Field, type_: Type, path: str) -> Any:
        """An ordinary value, or that of the example."""
        choice = self.choice
        number = choice.places.number(path)
        if path in choice.example:
            return choice.example[path]
        if member.typical is not None:
            return element_of(member.typical, path)
        return typical(member, type_, number + self.element)
