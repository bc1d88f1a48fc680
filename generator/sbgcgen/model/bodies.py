"""The contents of a body: fields, their types, and their conditions."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from itertools import takewhile
from typing import Any, Union

from sbgcgen.model.conditions import Condition
from sbgcgen.model.packed_text import part_of
from sbgcgen.model.position import NOWHERE, Position
from sbgcgen.model.values import SCALARS, Alias, Availability, AxisDirection, Deprecation, Enum
from sbgcgen.model.values import EnumValue, Packed, Part, Quantity, Scalar


@dataclass(frozen=True)
class Blob:
    """Bytes, NUL-padded UTF-8 text (kind "text"), or a length-prefixed string (kind "string").

    `size` is None for bytes that fill the rest of the body, and the largest size of a string.
    """

    kind: str
    size: int | None


@dataclass(frozen=True)
class FieldRule:
    """A rule that the field `low` does not exceed the field `high`; if `is_strict`, is below it."""

    low: str
    high: str
    is_strict: bool
    at: Position = field(default=NOWHERE, compare=False, repr=False)

    def text(self, path: str) -> str:
        """The rule with the paths of its fields, which are at the level of `path`."""
        return f"{path}{self.low} {'<' if self.is_strict else '<='} {path}{self.high}"


@dataclass(frozen=True)
class Struct:
    """A reusable group of fields; `size` is None if it varies.

    A tagged union (`is_region`) has a fixed size, whichever of its conditional fields are present; its last field holds
    the bytes that they do not use. Its conditions refer to fields of the enclosing message. `element_sizes` are the
    sizes that the elements of a list have had in any firmware, if it grew: all elements of a body have the same size.
    """

    name: str
    summary: str
    fields: tuple[Field, ...]
    size: int | None
    min_size: int
    family: str
    is_region: bool = False
    kind: str = "struct"
    rules: tuple[FieldRule, ...] = ()
    element_sizes: tuple[int, ...] = ()
    at: Position = field(default=NOWHERE, compare=False, repr=False)

    @cached_property
    def looks_outside(self) -> bool:
        """True if its content depends on fields of the message, which then reads and writes it."""
        return any(test.is_outside for f in self.fields if f.when for test in f.when.tests)

    @cached_property
    def names(self) -> frozenset[str]:
        return frozenset(f.name for f in self.fields)

    @cached_property
    def fixed_part(self) -> tuple[Field, ...]:
        """The leading fields with a fixed offset and size in every body.

        The codec checks their total size once, which determines the field and offset of an error.
        """
        if any(f.is_counter for f in self.fields):
            return ()
        return tuple(takewhile(lambda f: f.offset is not None and not f.is_variable, self.fields))

    @cached_property
    def fixed_size(self) -> int:
        return sum(f.size or 0 for f in self.fixed_part)


@dataclass(frozen=True)
class Announced:
    """A number whose type an earlier message announces, through `context`."""

    context: str
    kind: str = "announced"


Type = Union[Scalar, Quantity, Enum, Packed, Blob, Struct, Announced]


def scalar_of(type_: Type) -> Scalar | None:
    """The wire type of a numeric type; None for bytes and structs."""
    if isinstance(type_, Scalar):
        return type_
    return type_.scalar if isinstance(type_, (Quantity, Enum, Packed)) else None


@dataclass(frozen=True)
class Special:
    """A sentinel: a raw value with its own meaning; `name` identifies its constant, or is ""."""

    value: int
    meaning: str
    name: str = ""
    at: Position = field(default=NOWHERE, compare=False, repr=False)


@dataclass(frozen=True)
class Constant:
    """A named special value of a struct or message, shared by these `fields`."""

    name: str
    scalar: Scalar
    value: int
    meaning: str
    fields: tuple[str, ...]
    at: Position = field(default=NOWHERE, compare=False, repr=False)


def constants(fields: tuple[Field, ...]) -> tuple[Constant, ...]:
    """The named special values of fields, each name once."""
    found: dict[str, Constant] = {}
    for owner in fields:
        scalar = scalar_of(owner.type)
        for special in owner.special if scalar else ():
            if special.name in found:
                first = found[special.name]
                found[special.name] = replace(first, fields=(*first.fields, owner.name))
            elif special.name and scalar:
                found[special.name] = Constant(
                    special.name, scalar, special.value, special.meaning, (owner.name,), special.at
                )
    return tuple(found.values())


@dataclass(frozen=True)
class Alternative:
    """Another unit of the same bytes, selected by a flag of an earlier field.

    `source` is a field of the message, or if `in_group`, of the same group.
    """

    quantity: Quantity
    source: str
    mask: int
    flag: EnumValue
    in_group: bool = False


@dataclass(frozen=True)
class Later:
    """The complete meaning of a field since some firmware, including its unchanged parts."""

    since: Availability
    type: Type
    minimum: Fraction | None
    maximum: Fraction | None
    summary: str


@dataclass(frozen=True)
class Field:
    """One member of a struct or message.

    `dim` is the number of elements: "one", "axis", "xyz", "fixed" (`count`), "counted" (the value
    of the field `counter`) or "rest" (to the end of the body; with an `index`, the first of the
    named elements, at least `min_count`). `offset` is from the start of the struct; None after a
    variable part. `role` is the field's role in a parameter set: "copy" (selects one of several
    copies), "general" (the same in all copies), "state" (not a parameter), or "". `typical` is an
    ordinary value as JSON represents it; None if the spec names none. `appended`: firmware before
    `since` ends the body, or the element of a list, before the field. `fits`: present only if the body has no end without the
    field, but with it; a text of varying size only if it is all that is left of the body, not empty, and
    without control characters.
    `secret`: text and JSON hide the value. `saved_as`: its name in files of the vendor's program, "" for one that
    follows from the field's, None if it has no certain one; `saved_in`: "unit", "raw" or "", for what follows
    from the scale. `counting` is how the counter of a list counts:
    "elements", "bytes", "bits" (the list has an element for each bit that is set) or "minus_1"; it may be
    the part `counter_part` of a packed value. `default` is the raw value in a new message; it is the only valid one of a `constant`. `aliases` are former
    names. `directions` is None if the value counts in no direction; otherwise it counts in that of
    the `axis`, or of the index. `later` are the meanings that later firmware gives it, the first one first.
    `needs` is the feature of boards that have it. The board uses it only if `used_when` holds, which may differ
    between elements; otherwise, any value is valid.
    An `unconfirmed` field comes from a single source or is contradicted by another.
    """

    name: str
    spec_name: str
    type: Type
    dim: str
    offset: int | None
    size: int | None
    capacity: int
    summary: str
    count: int = 0
    index: tuple[str, ...] = ()
    counter: str = ""
    counter_part: Part | None = None
    is_counter: bool = False
    minimum: Fraction | None = None
    maximum: Fraction | None = None
    special: tuple[Special, ...] = ()
    min_count: int = 0
    max_count: int | None = None
    variable: str = ""
    align: int = 1
    reserved: bool = False
    optional: bool = False
    when: Condition | None = None
    used_when: Condition | None = None
    alternative: Alternative | None = None
    since: Availability = Availability()
    deprecated: Deprecation | None = None
    errata: tuple[str, ...] = ()
    role: str = ""
    typical: Any = field(default=None, hash=False)
    appended: bool = False
    fits: bool = False
    secret: bool = False
    saved_as: str | None = ""
    saved_in: str = ""
    counting: str = "elements"
    default: int = 0
    constant: bool = False
    aliases: tuple[Alias, ...] = ()
    unconfirmed: bool = False
    directions: tuple[AxisDirection, ...] | None = None
    axis: str = ""
    later: tuple[Later, ...] = ()
    needs: str = ""
    at: Position = field(default=NOWHERE, compare=False, repr=False)

    def direction(self, element: str) -> AxisDirection | None:
        """The positive direction of this element of an index; None if it is unknown."""
        axis = self.axis or element
        return next((d for d in self.directions or () if d.axis == axis), None)

    @cached_property
    def scalar(self) -> Scalar | None:
        """The wire type of a number or of the elements of a list; None for bytes and structs."""
        return scalar_of(self.type)

    @cached_property
    def may_be_absent(self) -> bool:
        """True if some bodies lack the field."""
        return self.when is not None or self.appended or self.fits

    @property
    def fits_rest(self) -> bool:
        """True for a text that is present if it fills the rest of the body."""
        return self.fits and self.size is None

    @staticmethod
    def is_evident(text: bytes) -> bool:
        """True for a text that fits: others are mistaken for it too easily."""
        return bool(text) and min(text) >= 0x20

    @cached_property
    def repeats_context(self) -> bool:
        """True if the body repeats a fact of its context here: the field has its name and type."""
        when = self.when
        if when is None or not when.from_context:
            return False
        return self.name == when.source and self.type == when.enum

    @cached_property
    def has_hidden_counter(self) -> bool:
        """True if the size of the list implies its counter, which is then not a member."""
        return bool(self.counter) and self.counting != "bits" and self.counter_part is None

    @cached_property
    def has_grown_elements(self) -> bool:
        """True for a list whose elements have a different size in older firmware."""
        return isinstance(self.type, Struct) and bool(self.type.element_sizes)

    def counted(self, counter: int) -> int:
        """The number of elements or bytes that the value of a visible counter means."""
        if self.counting == "bits":
            return bin(counter).count("1")
        count = part_of(self.counter_part, counter) if self.counter_part else counter
        return count + (self.counting == "minus_1")

    @property
    def elements(self) -> tuple[tuple[str, str], ...]:
        """The suffix of the path to each element, and its word in the index."""
        if self.dim == "one":
            return (("", ""),)
        if self.dim == "fixed":
            return tuple((f"[{i}]", "") for i in range(self.count))
        return tuple((f".{word.lower()}", word) for word in self.index)

    @cached_property
    def is_variable(self) -> bool:
        """True if the number of bytes depends on the message."""
        return self.size is None or self.may_be_absent


def all_fields(fields: tuple[Field, ...]) -> Iterator[Field]:
    """The fields, each followed by those of its struct."""
    for field in fields:
        yield field
        if isinstance(field.type, Struct):
            yield from all_fields(field.type.fields)


def field_rules(struct: Struct, path: str = "") -> Iterator[tuple[str, FieldRule]]:
    """The rules of a body and the structs in it, each with the path of its level."""
    for rule in struct.rules:
        yield path, rule
    for member in struct.fields:
        if isinstance(member.type, Struct):
            yield from field_rules(member.type, f"{path}{member.name}.")


@dataclass(frozen=True)
class Leaf:
    """One value or run of bytes of a body, with its full path.

    `cases` are the leaves that a tagged union may hold, depending on other fields. A body may end before an `optional`
    leaf. `when` and `used_when` are the conditions of the field or of an enclosing group. If the field has a sign
    convention, it is `direction`, or None if unknown. In a list of structs, `count` is None and `each` is the count in
    one element.
    """

    path: str
    field: Field
    spec_name: str
    type: str
    count: int | None
    offset: int | None
    cases: tuple[Leaf, ...] = ()
    optional: bool = False
    when: Condition | None = None
    used_when: Condition | None = None
    direction: AxisDirection | None = None
    each: int | None = None

    @property
    def size(self) -> int | None:
        """Size in bytes; None if it varies."""
        if self.count is None or self.type == "string":
            return None
        return self.count * (SCALARS[self.type].size if self.type in SCALARS else 1)


@dataclass(frozen=True)
class Announcement:
    """A list in a message that announces the types of numbers in later messages.

    `kind` is the path of an element's type, an enum or an enum in a packed value; `count` is the
    field with the number of repetitions. `types` are those that the enum can name.
    """

    message: str
    list: str
    kind: str
    count: str
    types: tuple[str, ...] = ()


@dataclass(frozen=True)
class Context:
    """A fact from an earlier message that a body needs for decoding.

    Either an enum or flag set from one of the `sources` (message, path), or announced types.
    """

    name: str
    type: Enum | None
    summary: str
    sources: tuple[tuple[str, str], ...]
    announced: Announcement | None = None


def element_of(typical: Any, path: str) -> Any:
    """The part of a typical value for the last element of a path, or the value for all elements."""
    if isinstance(typical, dict):
        return typical.get(path.rpartition(".")[2], typical)
    if isinstance(typical, list) and path.endswith("]"):
        return typical[int(path.rpartition("[")[2].rstrip("]") or 0)]
    return typical
