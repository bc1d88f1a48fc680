"""The Layout model: the protocol fully resolved, frozen, and the only thing that templates see.

Every size, offset, name and reference is decided here, once. Targets print it; none of them
computes a layout again.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from fractions import Fraction
from math import floor, lcm
from typing import Union

from sbgcgen.diagnostics import Position
from sbgcgen.names import snake_case

_NOWHERE = Position("")


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
    """Since when something exists; encoded as on the wire (2.55b5 is 2555, board 3.0 is 30)."""

    firmware: int = 0
    board: int = 0

    def __bool__(self) -> bool:
        return bool(self.firmware or self.board)


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
    at: Position = field(default=_NOWHERE, compare=False, repr=False)


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
    at: Position = field(default=_NOWHERE, compare=False, repr=False)
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
    at: Position = field(default=_NOWHERE, compare=False, repr=False)
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
    at: Position = field(default=_NOWHERE, compare=False, repr=False)

    @property
    def is_digits(self) -> bool:
        """Whether the part is cut out of the decimal digits rather than out of the bits."""
        return self.divide != 1 or self.modulo != 0

    @property
    def is_bool(self) -> bool:
        return not self.is_digits and self.enum is None and self.mask == 1 << self.shift


@dataclass(frozen=True)
class Packed:
    """Several values in one integer; the raw integer is kept, so no bit is ever lost."""

    name: str
    scalar: Scalar
    summary: str
    source: str
    errata: tuple[str, ...]
    display: str
    names: Enum | None
    parts: tuple[Part, ...]
    kind: str = "packed"
    at: Position = field(default=_NOWHERE, compare=False, repr=False)


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
    at: Position = field(default=_NOWHERE, compare=False, repr=False)


@dataclass(frozen=True)
class Announced:
    """A number whose type an earlier message announces; `context` is the context that knows it."""

    context: str
    kind: str = "announced"


Type = Union[Scalar, Quantity, Enum, Packed, Blob, Struct, Announced]


@dataclass(frozen=True)
class Special:
    """A value outside the ordinary meaning; `name` is that of a constant in C++, or ""."""

    value: int
    meaning: str
    name: str = ""
    at: Position = field(default=_NOWHERE, compare=False, repr=False)


@dataclass(frozen=True)
class Constant:
    """A special value, of these `fields`, that a struct or message has a name for."""

    name: str
    scalar: Scalar
    value: int
    meaning: str
    fields: tuple[str, ...]
    at: Position = field(default=_NOWHERE, compare=False, repr=False)


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
class Deprecation:
    """That something should not be used any more, since when, and what to use instead."""

    since: Availability
    replaced_by: str


@dataclass(frozen=True)
class Field:
    """One member of a struct or message.

    `dim` says how often the type stands: "one", "axis", "xyz", "fixed" (`count` times),
    "counted" (as the field `counter` says) or "rest" (to the end of the body). `offset` is from
    the start of the struct, None behind a variable part. `role` is what the field is among
    settings: "copy" (which of several copies they are), "state" (no setting), or "".
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
    at: Position = field(default=_NOWHERE, compare=False, repr=False)

    @property
    def is_variable(self) -> bool:
        """Whether the number of bytes depends on the message."""
        return self.size is None or self.when is not None


@dataclass(frozen=True)
class Leaf:
    """One value (or run of bytes) of a body in wire order, with the whole path to it.

    `cases` are the leaves that a region may hold, depending on other fields.
    """

    path: str
    field: Field
    spec_name: str
    type: str
    count: int | None
    offset: int | None
    cases: tuple[Leaf, ...] = ()


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
    """Something a body can not be read without, that stands in an earlier message.

    Either an enum or flag set, found in `sources` (message, path), or announced types.
    """

    name: str
    type: Enum | None
    summary: str
    sources: tuple[tuple[str, str], ...]
    announced: Announcement | None = None


@dataclass(frozen=True)
class Echo:
    """A number of the request that stands again in what answers it, `offset` bytes from its start.

    A special value of the request's `field` is not repeated.
    """

    field: Field
    offset: int
    size: int


@dataclass(frozen=True)
class Growth:
    """`size` bytes that a body has if `when` holds for the value at `path` of the request.

    `optional`: that value may be missing; then it does not hold.
    """

    path: str
    optional: bool
    when: Condition
    size: int


@dataclass(frozen=True)
class Reply:
    """One message of the board that answers a request, or that it makes the board send."""

    message: str
    id: int
    is_error: bool
    min_size: int
    max_size: int
    is_open: bool
    echoes: tuple[Echo, ...] = ()
    growth: tuple[Growth, ...] = ()


@dataclass(frozen=True)
class Result:
    """The place in the data of a confirmation that tells whether the request has succeeded."""

    field: Field
    offset: int
    size: int
    success: EnumValue


@dataclass(frozen=True)
class AnswerCase:
    """What a request is answered with, if `when` holds for it.

    `echoes` are the fields that are repeated. `replies`, `confirmation` (what the data of a
    confirmation repeat) and `result` follow from them and from the messages of the board.
    """

    when: Condition | None
    messages: tuple[str, ...]
    confirm: str
    confirmations: int
    timeout_ms: int
    finish_ms: int
    retry_safe: bool
    restarts: bool
    echoes: tuple[str, ...]
    errata: tuple[str, ...]
    replies: tuple[Reply, ...] = ()
    confirmation: Echo | None = None
    result: Result | None = None
    at: Position = field(default=_NOWHERE, compare=False, repr=False)


@dataclass(frozen=True)
class Answer:
    """What a request is answered with: the first case that holds; the last one always does."""

    cases: tuple[AnswerCase, ...]

    @property
    def messages(self) -> tuple[str, ...]:
        """All messages that may answer."""
        return tuple(dict.fromkeys(name for case in self.cases for name in case.messages))

    @property
    def confirm(self) -> str:
        """What holds of all cases: "always", "never", or else "possible"."""
        said = {case.confirm for case in self.cases}
        return said.pop() if len(said) == 1 else "possible"

    @property
    def confirmations(self) -> int:
        return max(case.confirmations for case in self.cases)

    @property
    def timeout_ms(self) -> int:
        return max(case.timeout_ms for case in self.cases)

    @property
    def retry_safe(self) -> bool:
        return all(case.retry_safe for case in self.cases)

    @property
    def errata(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys(number for case in self.cases for number in case.errata))

    @property
    def is_certain(self) -> bool:
        """Whether one of the messages comes in every case."""
        return all(case.messages for case in self.cases)


@dataclass(frozen=True)
class Role:
    """What a message is in the conversation (`kind`), and which of its fields tell what about it.

    A board restarts `delay_ms` after its reset message.
    `streams` are the messages that a stream request makes the board send; its interval is in units
    of `interval_us`, `end` ends the stream and `cycle` stands for `cycle_us`. There are at most
    `limit` streams at a time over all ports; 0 if that is not known.
    """

    kind: str
    parts: dict[str, Field] = field(hash=False)
    messages: tuple[str, ...] = ()
    streams: tuple[Reply, ...] = ()
    interval_us: int = 0
    end: int = 0
    cycle: int | None = None
    cycle_us: int = 0
    limit: int = 0
    delay_ms: int = 0
    at: Position = field(default=_NOWHERE, compare=False, repr=False)


@dataclass(frozen=True)
class Message:
    """One body layout of one command in one direction.

    `keeps_tail`: bytes behind the described ones are kept. `is_open`: any body of at least
    `min_size` is taken for this message, of several forms the longest.
    """

    name: str
    command: str
    command_identifier: str
    id: int
    direction: str
    form: str | None
    family: str
    summary: str
    description: str
    source: str
    errata: tuple[str, ...]
    since: Availability
    deprecated: Deprecation | None
    body: Struct
    same_as: str
    in_both_directions: bool
    keeps_tail: bool
    is_open: bool
    tail_capacity: int
    min_size: int
    max_size: int
    contexts: tuple[Context, ...]
    answer: Answer | None
    role: Role | None
    stores: str
    leaves: tuple[Leaf, ...]
    at: Position = field(default=_NOWHERE, compare=False, repr=False)

    @property
    def identifier(self) -> str:
        """The name as a member would have it."""
        return snake_case(self.name)

    @property
    def fields(self) -> tuple[Field, ...]:
        return self.body.fields

    @property
    def has_fixed_size(self) -> bool:
        return self.body.size is not None


@dataclass(frozen=True)
class Command:
    """One command name of the protocol; several may share an id in different directions."""

    name: str
    identifier: str
    id: int | None
    family: str
    summary: str
    source: str
    errata: tuple[str, ...]
    since: Availability
    undocumented: bool
    at: Position = field(default=_NOWHERE, compare=False, repr=False)


@dataclass(frozen=True)
class VariableSetting:
    """A setting that a variable stands for: its count is the variable's * `scale` + `offset`."""

    message: str
    path: str
    scalar: Scalar
    scale: Fraction
    offset: Fraction

    @property
    def denominator(self) -> int:
        """Of both `scale` and `offset`."""
        return lcm(self.scale.denominator, self.offset.denominator)

    @property
    def numerator(self) -> int:
        return int(self.scale * self.denominator)

    @property
    def addend(self) -> int:
        return int(self.offset * self.denominator)

    def count(self, value: int) -> int:
        """The count of the setting that is nearest to a value of the variable."""
        return _nearest(value * self.scale + self.offset)

    def value(self, count: int) -> int:
        """The value of the variable that is nearest to a count of the setting."""
        return _nearest((count - self.offset) / self.scale)


def _nearest(exact: Fraction) -> int:
    """The nearest integer; a half goes away from 0."""
    whole = floor(abs(exact) + Fraction(1, 2))
    return whole if exact >= 0 else -whole


@dataclass(frozen=True)
class Variable:
    """An adjustable variable (Appendix B).

    It stands for `settings`, the first of which is the one that is read. A switch tells only
    whether its settings are 0, and leaves what is not 0 as it is when it is switched on.
    """

    name: str
    identifier: str
    id: int
    scalar: Scalar
    quantity: Quantity | None
    minimum: int
    maximum: int
    summary: str
    errata: tuple[str, ...]
    settings: tuple[VariableSetting, ...] = ()
    is_switch: bool = False
    at: Position = field(default=_NOWHERE, compare=False, repr=False)


@dataclass(frozen=True)
class Erratum:
    """A decision on how to read the specification."""

    number: str
    kind: str
    lines: tuple[str, ...]
    problem: str
    reading: str
    reason: str
    at: Position = field(default=_NOWHERE, compare=False, repr=False)


@dataclass(frozen=True)
class Framing:
    """How a body is wrapped on the line."""

    start: int
    header_size: int
    trailer_size: int
    max_body: int
    source: str
    errata: tuple[str, ...]


@dataclass(frozen=True)
class Line:
    """The serial line. Rates and parities stand with the most likely first.

    `named` of the rates are those that the protocol names.
    """

    baud_rates: tuple[int, ...]
    named: int
    parities: tuple[str, ...]
    shortest_pause_ms: int
    longest_pause_ms: int
    source: str
    errata: tuple[str, ...]
    at: Position = field(default=_NOWHERE, compare=False, repr=False)


@dataclass(frozen=True)
class Family:
    """A group of commands that get one header and one page."""

    name: str
    summary: str
    structs: tuple[Struct, ...]
    messages: tuple[Message, ...]

    @property
    def uses(self) -> tuple[str, ...]:
        """Other families whose structs or messages this one needs."""
        fields = [f for m in self.messages for f in m.fields]
        fields += [f for s in self.structs for f in s.fields]
        names = {f.type.family for f in fields if isinstance(f.type, Struct)}
        names |= {m.body.family for m in self.messages}
        return tuple(sorted(names - {self.name}))

    @property
    def definitions(self) -> tuple[Message, ...]:
        """Messages that define a C++ type of their own (a same_as in both directions does not).

        Those with the body of another message come last, behind what they are made of.
        """
        seen: dict[str, Message] = {}
        for message in self.messages:
            seen.setdefault(message.name, message)

        def steps(message: Message) -> int:
            return 1 + steps(seen[message.same_as]) if message.same_as in seen else 0

        return tuple(sorted(seen.values(), key=lambda m: (bool(m.same_as), steps(m))))


@dataclass(frozen=True)
class Settings:
    """A message whose content a host can read and store, and with which requests.

    Deprecated requests come last. `copies` is how many of these settings the board has, told apart
    by a field with the role "copy"; 1 without such a field.
    """

    message: Message
    readers: tuple[Message, ...]
    writers: tuple[Message, ...]

    @property
    def copies(self) -> int:
        found = copy_field(self.message)
        return int(found.maximum) + 1 if found and found.maximum is not None else 1


def copy_field(message: Message) -> Field | None:
    """The field that says which of several copies of its settings a message is about."""
    return next((f for f in message.fields if f.role == "copy"), None)


@dataclass(frozen=True)
class Layout:
    """The whole protocol."""

    protocol: dict[str, str]
    framing: Framing
    line: Line
    families: tuple[Family, ...]
    quantities: tuple[Quantity, ...]
    enums: tuple[Enum, ...]
    packed: tuple[Packed, ...]
    commands: tuple[Command, ...]
    variables: tuple[Variable, ...]
    errata: tuple[Erratum, ...]
    indices: dict[str, tuple[str, ...]]

    @property
    def messages(self) -> tuple[Message, ...]:
        return tuple(m for family in self.families for m in family.messages)

    @property
    def definitions(self) -> tuple[Message, ...]:
        """Messages with a type of their own, in the order of families."""
        return tuple(m for family in self.families for m in family.definitions)

    @property
    def settings(self) -> tuple[Settings, ...]:
        """What can be read and stored, in the order of families."""
        stored = {m.stores for m in self.messages}

        def requests(of: list[Message]) -> tuple[Message, ...]:
            return tuple(sorted(of, key=lambda m: m.deprecated is not None))

        return tuple(
            Settings(
                message,
                requests(
                    [m for m in self.messages if m.answer and message.name in m.answer.messages]
                ),
                requests([m for m in self.messages if m.stores == message.name]),
            )
            for message in self.definitions
            if message.name in stored
        )

    def having_role(self, kind: str) -> tuple[Message, ...]:
        """The messages with a role; several are forms of one command."""
        return tuple(m for m in self.messages if m.role and m.role.kind == kind)
