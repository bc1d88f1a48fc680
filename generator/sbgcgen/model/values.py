"""Types of single values on the wire: numbers, quantities, enums, packed integers."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from fractions import Fraction
from math import log

from sbgcgen.model.position import NOWHERE, Position


@dataclass(frozen=True)
class Identifier:
    """A word that becomes a name in code, and its position in the spec."""

    name: str
    at: Position = field(default=NOWHERE, compare=False, repr=False)


@dataclass(frozen=True)
class Alias(Identifier):
    """A former name, in code and in the protocol."""

    spec_name: str = ""


@dataclass(frozen=True)
class Scalar:
    """A number on the wire, little-endian."""

    name: str
    size: int
    minimum: int | None
    maximum: int | None
    kind: str = "scalar"

    @cached_property
    def is_float(self) -> bool:
        return self.minimum is None

    @cached_property
    def is_signed(self) -> bool:
        return self.minimum is not None and self.minimum < 0

    def holds(self, number: int | Fraction) -> bool:
        """True if a value of this type can be the number."""
        if self.minimum is None or self.maximum is None:
            return True
        return self.minimum <= number <= self.maximum


def _integer(name: str, size: int, signed: bool) -> Scalar:
    bits = 8 * size
    low, high = (-(1 << (bits - 1)), (1 << (bits - 1)) - 1) if signed else (0, (1 << bits) - 1)
    return Scalar(name, size, low, high)


SCALARS: dict[str, Scalar] = {
    "u8": _integer("u8", 1, False),
    "i8": _integer("i8", 1, True),
    "u16": _integer("u16", 2, False),
    "i16": _integer("i16", 2, True),
    "u24": _integer("u24", 3, False),
    "i24": _integer("i24", 3, True),
    "u32": _integer("u32", 4, False),
    "i32": _integer("i32", 4, True),
    "u64": _integer("u64", 8, False),
    "i64": _integer("i64", 8, True),
    "f32": Scalar("f32", 4, None, None),
    "f64": Scalar("f64", 8, None, None),
}


@dataclass(frozen=True)
class Availability:
    """The first versions that have something, as numbers on the wire and as text."""

    firmware: int = 0
    board: int = 0
    firmware_text: str = field(default="", compare=False)
    board_text: str = field(default="", compare=False)

    @property
    def words(self) -> tuple[tuple[str, str], ...]:
        """Kind and text of each version: ("firmware", "2.59"), ("board", "3.0")."""
        said = (
            ("firmware", self.firmware, self.firmware_text),
            ("board", self.board, self.board_text),
        )
        return tuple((kind, text or str(number)) for kind, number, text in said if number)

    def __bool__(self) -> bool:
        return bool(self.firmware or self.board)

    def is_after(self, other: Availability) -> bool:
        """True if some versions that have the other thing do not have this one."""
        return self.firmware > other.firmware or self.board > other.board

    def later(self, other: Availability) -> Availability:
        """The first versions that have both things."""
        firmware = self if self.firmware >= other.firmware else other
        board = self if self.board >= other.board else other
        return Availability(
            firmware.firmware, board.board, firmware.firmware_text, board.board_text
        )


@dataclass(frozen=True)
class Feature:
    """Something that only some boards have: a flag in their report. `mask` is its bit among all."""

    name: str
    mask: int


@dataclass(frozen=True)
class Until:
    """The first versions that no longer accept a message, and the message that replaces it."""

    versions: Availability
    instead: str
    at: Position = field(default=NOWHERE, compare=False, repr=False)


@dataclass(frozen=True)
class Deprecation:
    """A deprecation: the versions since which it applies, and the replacement."""

    since: Availability
    replaced_by: str


@dataclass(frozen=True)
class AxisDirection:
    """The directions of an axis; None if they are unknown."""

    axis: str
    positive: str | None
    negative: str | None
    errata: tuple[str, ...]
    at: Position = field(default=NOWHERE, compare=False, repr=False)


@dataclass(frozen=True)
class Quantity:
    """A physical quantity: physical value = raw * scale + offset, in `unit`.

    With a `ratio`, it is exponential: scale * ratio^(raw / over) + offset. If it `is_directed`, its values
    have a sign convention.
    """

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
    is_directed: bool = False
    at: Position = field(default=NOWHERE, compare=False, repr=False)
    ratio: Fraction = Fraction(0)
    over: int = 1

    @property
    def is_plain(self) -> bool:
        """True if the physical value is the raw value."""
        return self.scale == 1 and not self.offset and not self.ratio

    @property
    def growth(self) -> float:
        """The factor between adjacent values of an exponential quantity."""
        return float(float(self.ratio) ** (1 / self.over))

    @property
    def formula(self) -> str:
        """The formula of an exponential quantity."""
        offset = f" {'-' if self.offset < 0 else '+'} {abs(self.offset)}" if self.offset else ""
        return f"{self.scale_text} * {self.ratio}^(raw / {self.over}){offset}"

    def real(self, raw: Fraction | int | float) -> Fraction:
        """The physical value, which is exact unless the quantity is exponential."""
        if not self.ratio:
            return Fraction(raw) * self.scale + self.offset
        power = float(self.ratio) ** (float(raw) / self.over)
        return Fraction(f"{power * float(self.scale):.12g}") + self.offset

    def raw(self, real: Fraction) -> Fraction:
        """The raw value nearest to a physical one; far below the range if there is none."""
        steps = (real - self.offset) / self.scale
        if not self.ratio:
            return steps
        return Fraction(log(steps) / log(self.growth)) if steps > 0 else Fraction(-1 << 62)


@dataclass(frozen=True)
class Former:
    """A meaning that ended with a firmware version."""

    firmware: Availability
    summary: str


@dataclass(frozen=True)
class EnumValue:
    """One named value; `name` is the protocol's own unless `ours`.

    If the value names a type, `wire` is that wire type. `number` is any other number that the value
    stands for, such as a baud rate. `aliases` are former names. An `unconfirmed` fact comes from a
    single source or is contradicted by another. `needs` is the feature of boards that know it. `saved_as` is
    the name of a flag in files of the vendor's program.
    """

    name: str
    identifier: str
    value: int
    summary: str
    ours: bool = False
    wire: str = ""
    since: Availability = Availability()
    errata: tuple[str, ...] = ()
    at: Position = field(default=NOWHERE, compare=False, repr=False)
    number: int | None = None
    aliases: tuple[Alias, ...] = ()
    unconfirmed: bool = False
    former: Former | None = None
    needs: str = ""
    saved_as: str = ""


@dataclass(frozen=True)
class Enum:
    """An enum, or (kind "flags") a set of bits with masks as values.

    `success` is the value of a result code that means success. `are_errors`: programs quote the
    summaries of the values.
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
    are_errors: bool = False


@dataclass(frozen=True)
class Part:
    """A named part of a packed integer: ((raw & mask) >> shift) / divide % modulo.

    `signed`: the bits are a two's complement number. `sign` is the mask of a bit that makes the
    number negative, or 0. `quantity` has the unit of the number. `saved_as` is the name of the part in files
    of the vendor's program.
    """

    name: str
    mask: int
    shift: int
    divide: int
    modulo: int
    enum: Enum | None
    summary: str
    at: Position = field(default=NOWHERE, compare=False, repr=False)
    signed: bool = False
    sign: int = 0
    quantity: Quantity | None = None
    saved_as: str = ""

    @property
    def is_digits(self) -> bool:
        """True if the part consists of decimal digits rather than bits."""
        return self.divide != 1 or self.modulo != 0

    @property
    def bits(self) -> int:
        """The mask of all bits of the part."""
        return self.mask | self.sign

    @property
    def limits(self) -> tuple[int, int]:
        """The lowest and highest number that the bits can hold."""
        most = self.mask >> self.shift
        if self.signed:
            return -(most // 2) - 1, most // 2
        return (-most if self.sign else 0), most

    @property
    def is_number(self) -> bool:
        """True for a number that is not just unsigned bits: with a sign or a unit."""
        return self.signed or bool(self.sign) or self.quantity is not None

    @property
    def is_bool(self) -> bool:
        is_plain = not self.is_digits and self.enum is None and not self.is_number
        return is_plain and self.mask == 1 << self.shift

    def bits_of(self, number: int) -> int:
        """The bits of a number within the limits."""
        if self.sign and number < 0:
            return (-number << self.shift) | self.sign
        return (number << self.shift) & self.mask


@dataclass(frozen=True)
class Packed:
    """Several values in one integer, which is kept as a raw value so that no bit is lost.

    `names` names values of the whole integer. A value of the part `main` alone is a value of the
    whole, with 0 in the other parts.
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
    later_from: int = 0  # the raw values from here on have the display text `later_display`
    later_display: str = ""

    def display_of(self, raw: int) -> str:
        """The display text for a value."""
        return self.later_display if self.later_display and raw >= self.later_from else self.display


@dataclass(frozen=True)
class Versions:
    """The packed integers whose display texts define the notation of versions."""

    firmware: Packed | None = None
    board: Packed | None = None

    def of(self, kind: str) -> Packed | None:
        """The packed integer for a kind of version."""
        return self.firmware if kind == "firmware" else self.board
