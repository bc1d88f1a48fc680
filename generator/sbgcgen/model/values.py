"""What one value on the wire can be: numbers, quantities, enums, packed integers."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction

from sbgcgen.model.position import NOWHERE, Position


@dataclass(frozen=True)
class Scalar:
    """A number on the wire, little-endian."""

    name: str
    size: int
    minimum: int | None
    maximum: int | None
    kind: str = "scalar"

    @property
    def is_float(self) -> bool:
        return self.minimum is None


def _integer(name: str, size: int, signed: bool) -> Scalar:
    bits = 8 * size
    low, high = (-(1 << (bits - 1)), (1 << (bits - 1)) - 1) if signed else (0, (1 << bits) - 1)
    return Scalar(name, size, low, high)


SCALARS: dict[str, Scalar] = {
    "u8": _integer("u8", 1, False),
    "i8": _integer("i8", 1, True),
    "u16": _integer("u16", 2, False),
    "i16": _integer("i16", 2, True),
    "u32": _integer("u32", 4, False),
    "i32": _integer("i32", 4, True),
    "f32": Scalar("f32", 4, None, None),
}


@dataclass(frozen=True)
class Availability:
    """Since when something exists: the versions as on the wire, and as they are written."""

    firmware: int = 0
    board: int = 0
    firmware_text: str = field(default="", compare=False)
    board_text: str = field(default="", compare=False)

    @property
    def words(self) -> tuple[tuple[str, str], ...]:
        """What is said: ("firmware", "2.59"), ("board", "3.0")."""
        said = (
            ("firmware", self.firmware, self.firmware_text),
            ("board", self.board, self.board_text),
        )
        return tuple((kind, text or str(number)) for kind, number, text in said if number)

    def __bool__(self) -> bool:
        return bool(self.firmware or self.board)


@dataclass(frozen=True)
class Until:
    """The first versions that no longer take a message, and the message that they take instead."""

    versions: Availability
    instead: str
    at: Position = field(default=NOWHERE, compare=False, repr=False)


@dataclass(frozen=True)
class Deprecation:
    """That something should not be used any more, since when, and what to use instead."""

    since: Availability
    replaced_by: str


@dataclass(frozen=True)
class Quantity:
    """A physical quantity: real value = raw * scale + offset, in `unit`."""

    name: str
    scalar: Scalar
    unit: str | None
    accessor: str
    scale: Fraction
    scale_text: str
    offset: Fraction
    summary: str
    errata: tuple[str, ...]
    kind: str = "quantity"
    at: Position = field(default=NOWHERE, compare=False, repr=False)


@dataclass(frozen=True)
class EnumValue:
    """One named value; `name` is the protocol's own unless `ours`.

    `wire` is the number on the wire that the value stands for, where it names a type; `number` is
    any other number that it stands for.
    """

    name: str
    identifier: str
    value: int
    summary: str
    ours: bool
    wire: str
    since: Availability
    errata: tuple[str, ...]
    at: Position = field(default=NOWHERE, compare=False, repr=False)
    number: int | None = None


@dataclass(frozen=True)
class Enum:
    """An enum, or (kind "flags") a set of bits whose values are masks.

    `success` is the value, of a result, that does not tell of a failure.
    """

    name: str
    member: str
    scalar: Scalar
    kind: str
    summary: str
    source: str
    errata: tuple[str, ...]
    values: tuple[EnumValue, ...]
    at: Position = field(default=NOWHERE, compare=False, repr=False)
    success: EnumValue | None = None


@dataclass(frozen=True)
class Part:
    """A named part of a packed integer: ((raw & mask) >> shift) / divide % modulo."""

    name: str
    mask: int
    shift: int
    divide: int
    modulo: int
    enum: Enum | None
    summary: str
    at: Position = field(default=NOWHERE, compare=False, repr=False)

    @property
    def is_digits(self) -> bool:
        """Whether the part is cut out of the decimal digits rather than out of the bits."""
        return self.divide != 1 or self.modulo != 0

    @property
    def is_bool(self) -> bool:
        return not self.is_digits and self.enum is None and self.mask == 1 << self.shift


@dataclass(frozen=True)
class Packed:
    """Several values in one integer; the raw integer is kept, so no bit is ever lost.

    `names` names values of the whole integer. `main` is the part whose values say most: such a value
    alone is a value of the whole, with 0 in the other parts.
    """

    name: str
    scalar: Scalar
    summary: str
    source: str
    errata: tuple[str, ...]
    display: str
    names: Enum | None
    parts: tuple[Part, ...]
    kind: str = "packed"
    at: Position = field(default=NOWHERE, compare=False, repr=False)
    main: Part | None = None


@dataclass(frozen=True)
class Versions:
    """The packed integers whose display text is how versions are written."""

    firmware: Packed | None = None
    board: Packed | None = None

    def of(self, kind: str) -> Packed | None:
        """The one of a kind of version."""
        return self.firmware if kind == "firmware" else self.board
