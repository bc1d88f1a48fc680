"""What a body is made of: fields, their types, and on what they depend."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any, Union

from sbgcgen.model.position import NOWHERE, Position
from sbgcgen.model.values import (
    SCALARS,
    Availability,
    Deprecation,
    Enum,
    EnumValue,
    Packed,
    Quantity,
    Scalar,
)


@dataclass(frozen=True)
class Identifier:
    """A word that becomes a name in code, and where it comes from."""

    name: str
    at: Position = field(default=NOWHERE, compare=False, repr=False)


@dataclass(frozen=True)
class Blob:
    """Bytes, or NUL-padded UTF-8 text (kind "text"), or a length-prefixed string (kind "string").

    `size` is None for bytes that take the rest of the body; a string's size includes its prefix
    at its longest.
    """

    kind: str
    size: int | None


@dataclass(frozen=True)
class Struct:
    """A reusable group of fields; `size` is None when it varies.

    A region has a fixed size, whatever of its conditional fields are present; its last field keeps
    the bytes that they do not use. Its conditions are about fields of the message around it.
    """

    name: str
    summary: str
    fields: tuple[Field, ...]
    size: int | None
    min_size: int
    family: str
    is_region: bool = False
    kind: str = "struct"
    at: Position = field(default=NOWHERE, compare=False, repr=False)


@dataclass(frozen=True)
class Announced:
    """A number whose type an earlier message announces; `context` is the context that knows it."""

    context: str
    kind: str = "announced"


Type = Union[Scalar, Quantity, Enum, Packed, Blob, Struct, Announced]


def scalar_of(type_: Type) -> Scalar | None:
    """The number on the wire behind a type, None for bytes and structs."""
    if isinstance(type_, Scalar):
        return type_
    return type_.scalar if isinstance(type_, (Quantity, Enum, Packed)) else None


@dataclass(frozen=True)
class Special:
    """A value outside the ordinary meaning; `name` is that of a constant in C++, or ""."""

    value: int
    meaning: str
    name: str = ""
    at: Position = field(default=NOWHERE, compare=False, repr=False)


@dataclass(frozen=True)
class Constant:
    """A special value, of these `fields`, that a struct or message has a name for."""

    name: str
    scalar: Scalar
    value: int
    meaning: str
    fields: tuple[str, ...]
    at: Position = field(default=NOWHERE, compare=False, repr=False)


def constants(fields: tuple[Field, ...]) -> tuple[Constant, ...]:
    """The special values of fields that have a name, each name once."""
    found: dict[str, Constant] = {}
    for owner in fields:
        if isinstance(owner.type, (Blob, Struct, Announced)):
            continue
        scalar = owner.type if isinstance(owner.type, Scalar) else owner.type.scalar
        for special in owner.special:
            if special.name in found:
                first = found[special.name]
                found[special.name] = replace(first, fields=(*first.fields, owner.name))
            elif special.name:
                found[special.name] = Constant(
                    special.name, scalar, special.value, special.meaning, (owner.name,), special.at
                )
    return tuple(found.values())


@dataclass(frozen=True)
class Condition:
    """When a field is present: by flags of a context or an earlier field, or by a field's value.

    If the earlier field is not there (`source_may_be_missing`), the condition does not hold.
    """

    source: str
    from_context: bool
    mask: int
    values: tuple[EnumValue, ...]
    flags: tuple[EnumValue, ...]
    enum: Enum
    may_be_missing: bool
    source_may_be_missing: bool = False


@dataclass(frozen=True)
class Alternative:
    """Another unit of the same bytes, chosen by a flag of an earlier field.

    `source` is the path of that field from the message, with "{axis}" for the index in force.
    """

    quantity: Quantity
    source: str
    mask: int
    flag: EnumValue


@dataclass(frozen=True)
class Field:
    """One member of a struct or message.

    `dim` says how often the type stands: "one", "axis", "xyz", "fixed" (`count` times),
    "counted" (as the field `counter` says) or "rest" (to the end of the body; with an `index`, as
    many of those named as there are, at least `min_count`). `offset` is from
    the start of the struct, None behind a variable part. `role` is what the field is among
    settings: "copy" (which of several copies they are), "general" (the same in all copies),
    "state" (no setting), or "". `typical` is an ordinary value, in the shape that it has in JSON, None
    if the spec names none.
    """

    name: str
    spec_name: str
    type: Type
    dim: str
    count: int
    index: tuple[str, ...]
    counter: str
    is_counter: bool
    offset: int | None
    size: int | None
    capacity: int
    minimum: Fraction | None
    maximum: Fraction | None
    special: tuple[Special, ...]
    min_count: int
    max_count: int | None
    variable: str
    align: int
    reserved: bool
    optional: bool
    when: Condition | None
    alternative: Alternative | None
    since: Availability
    deprecated: Deprecation | None
    summary: str
    errata: tuple[str, ...]
    role: str = ""
    typical: Any = field(default=None, hash=False)
    at: Position = field(default=NOWHERE, compare=False, repr=False)

    @property
    def is_variable(self) -> bool:
        """Whether the number of bytes depends on the message."""
        return self.size is None or self.when is not None


@dataclass(frozen=True)
class Leaf:
    """One value (or run of bytes) of a body in wire order, with the whole path to it.

    `cases` are the leaves that a region may hold, depending on other fields. `optional`: a body may
    end before it.
    """

    path: str
    field: Field
    spec_name: str
    type: str
    count: int | None
    offset: int | None
    cases: tuple[Leaf, ...] = ()
    optional: bool = False

    @property
    def size(self) -> int | None:
        """The bytes that it takes, None if that varies."""
        if self.count is None or self.type == "string":
            return None
        return self.count * (SCALARS[self.type].size if self.type in SCALARS else 1)


@dataclass(frozen=True)
class Announcement:
    """The list in a message that announces the types of numbers in later ones.

    Each element has the type in `kind` (the path of an enum, through a packed part if need be) and
    how often it stands in `count`. `types` are those that the enum can name.
    """

    message: str
    list: str
    kind: str
    count: str
    types: tuple[str, ...] = ()


@dataclass(frozen=True)
class Context:
    """Something a body cannot be read without, that stands in an earlier message.

    Either an enum or flag set, found in `sources` (message, path), or announced types.
    """

    name: str
    type: Enum | None
    summary: str
    sources: tuple[tuple[str, str], ...]
    announced: Announcement | None = None


def element_of(typical: Any, path: str) -> Any:
    """What a typical value says about the element that a path ends with, or about all of them."""
    if isinstance(typical, dict):
        return typical.get(path.rpartition(".")[2], typical)
    if isinstance(typical, list) and path.endswith("]"):
        return typical[int(path.rpartition("[")[2].rstrip("]") or 0)]
    return typical
