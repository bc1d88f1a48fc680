"""Commands, their messages, and the settings that messages store."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from sbgcgen.model.position import NOWHERE, Position
from sbgcgen.model.answers import Answer, Role
from sbgcgen.model.bodies import Context, Field, Leaf, Struct
from sbgcgen.model.conditions import Condition
from sbgcgen.model.effects import Effect, StopPattern
from sbgcgen.model.values import Alias, Availability, Deprecation, Enum, Until
from sbgcgen.model.names import form_suffix, snake_case

# The enum of command ids of each direction.
COMMAND_IDS = {"to_board": "CommandToBoard", "from_board": "CommandFromBoard"}


@dataclass(frozen=True)
class Message:
    """One body layout of one command in one direction.

    `keeps_tail`: decoding keeps undocumented trailing bytes. `is_open`: a body of any size from
    `min_size` up is this message; of several forms, only the longest can be open. `takes_surplus`: the
    board ignores bytes after this longest form of a request. `example` has the values by path in which
    the worked example is not typical; a message with the same body as another inherits that message's.
    `preparation` is the preparation before the request is sent. A request stops all motion if it has
    the values of one of the patterns in `stops`. `needs` is the board feature that the message
    requires.
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
    until: Until | None
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
    takes_surplus: bool = False
    effect: Effect | None = None
    preparation: str = ""
    stops: tuple[StopPattern, ...] = ()
    example: dict[str, Any] = field(default_factory=dict, hash=False)
    unconfirmed: bool = False
    needs: str = ""
    has_own_name: bool = False
    at: Position = field(default=NOWHERE, compare=False, repr=False)

    @cached_property
    def identifier(self) -> str:
        """The name in snake_case, for members."""
        return snake_case(self.name)

    @property
    def command_ids(self) -> str:
        """The enum with the command's id; that of requests for a message in both directions."""
        return COMMAND_IDS["to_board" if self.in_both_directions else self.direction]

    @property
    def call(self) -> str:
        """The name of the function that sends the message."""
        if self.has_own_name:
            return self.identifier
        suffix = form_suffix(self.form)
        return f"{self.command_identifier}_{suffix}" if suffix else self.command_identifier

    @property
    def fields(self) -> tuple[Field, ...]:
        return self.body.fields

    @cached_property
    def secret_from(self) -> int | None:
        """The first byte of a body that may belong to a secret; None if no field is secret."""
        leaves = [one for leaf in self.leaves for one in (leaf, *leaf.cases) if one.field.secret]
        places = [self.body.fixed_size if one.offset is None else one.offset for one in leaves]
        return min(places, default=None)

    @property
    def failure(self) -> Field | None:
        """In an error form, the field with the reason of the failure."""
        for field in self.fields if self.form == "error" else ():
            is_fixed = field.offset is not None and not field.may_be_absent
            if is_fixed and field.dim == "one" and isinstance(field.type, Enum):
                if field.type.success:
                    return field
        return None

    @property
    def room(self) -> int:
        """The size of the largest body of the protocol."""
        return self.min_size + self.tail_capacity

    @cached_property
    def lengths(self) -> tuple[tuple[Availability, int], ...]:
        """The sizes of the body by the versions that introduced them; empty if there is only one."""
        appended = [field for field in self.fields if field.appended]
        if any(field.offset is None or field.size is None for field in appended):
            return ()
        appended.sort(key=lambda field: (field.since.firmware, field.since.board))
        ends: dict[Availability, int] = {}
        for field in appended:
            end = (field.offset or 0) + (field.size or 0)
            ends[field.since] = max([end, *ends.values()])
        sizes = [(self.since, min((field.offset or 0 for field in appended), default=0))]
        for since, size in ends.items():
            if size > sizes[-1][1]:
                sizes.append((since, size))
        return tuple(sizes) if len(sizes) > 1 else ()

    @cached_property
    def has_end(self) -> bool:
        """True if bytes after the known fields belong neither to a list nor to a tail."""
        has_tail = self.keeps_tail or self.in_both_directions
        return not has_tail and not any(
            leaf.count is None or leaf.field.dim in ("counted", "rest") for leaf in self.leaves
        )

    def was_reserved(self, field: Field) -> bool:
        """True if earlier firmware has reserved bytes at the position of the field."""
        is_later = field.since.is_after(self.since)
        return is_later and not field.may_be_absent and field.dim != "rest"


@dataclass(frozen=True)
class Command:
    """One command of the protocol. Two may share an id if their directions differ."""

    name: str
    identifier: str
    id: int | None
    family: str
    summary: str
    source: str
    errata: tuple[str, ...]
    since: Availability
    undocumented: bool
    aliases: tuple[Alias, ...] = ()
    unconfirmed: bool = False
    needs: str = ""
    at: Position = field(default=NOWHERE, compare=False, repr=False)


@dataclass(frozen=True)
class Family:
    """The commands of one spec file; they share a header and a page."""

    name: str
    summary: str
    structs: tuple[Struct, ...]
    messages: tuple[Message, ...]

    @property
    def uses(self) -> tuple[str, ...]:
        """Other families whose structs or messages this family uses."""
        fields = [f for m in self.messages for f in m.fields]
        fields += [f for s in self.structs for f in s.fields]
        names = {f.type.family for f in fields if isinstance(f.type, Struct)}
        names |= {m.body.family for m in self.messages}
        return tuple(sorted(names - {self.name}))

    @cached_property
    def named(self) -> dict[str, list[Message]]:
        """The messages by name: a message in both directions is two entries of one name."""
        found: dict[str, list[Message]] = {}
        for message in self.messages:
            found.setdefault(message.name, []).append(message)
        return found

    @cached_property
    def definitions(self) -> tuple[Message, ...]:
        """Messages that define a type; a message in both directions defines it once.

        Messages with the body of another come last, after the message that defines the body.
        """
        seen = {name: messages[0] for name, messages in self.named.items()}

        def steps(message: Message) -> int:
            return 1 + steps(seen[message.same_as]) if message.same_as in seen else 0

        return tuple(sorted(seen.values(), key=lambda m: (bool(m.same_as), steps(m))))


@dataclass(frozen=True)
class Settings:
    """A message with settings, and the requests that read and store them.

    Deprecated requests come last. `copies` is the number of copies of these settings in the board,
    selected by a field with the role "copy"; 1 without such a field.
    """

    message: Message
    readers: tuple[Message, ...]
    writers: tuple[Message, ...]

    @property
    def copies(self) -> int:
        found = copy_field(self.message)
        return int(found.maximum) + 1 if found and found.maximum is not None else 1


@dataclass(frozen=True)
class LargestForm:
    """The largest form of a request that boards since these versions have, and its size.

    The size is None if the form has no certain end.
    """

    message: Message
    since: Availability
    size: int | None


def largest_forms(forms: Iterable[Message]) -> tuple[LargestForm, ...]:
    """The forms of a request by size, the largest first: the first form that a board has counts."""
    result = []
    for form in sorted(forms, key=lambda m: m.max_size, reverse=True):
        # Before a list was added, the form ended before it.
        added = [f for f in form.fields if f.dim == "rest" and f.since.is_after(form.since)]
        for field in added:
            result.append(LargestForm(form, field.since, None))
            result.append(LargestForm(form, form.since, field.offset))
        for since, size in reversed(form.lengths or ((form.since, form.max_size),)):
            if not added:
                result.append(LargestForm(form, since, size if form.has_end else None))
    return tuple(result)


def copy_field(message: Message) -> Field | None:
    """The field of a message that selects one of several copies of its settings."""
    return next((f for f in message.fields if f.role == "copy"), None)


def conditions(message: Message) -> list[Condition]:
    """All conditions on fields of the message and contexts: those of the fields, unions and groups."""
    unions = [m.type for m in message.fields if isinstance(m.type, Struct) and m.type.is_region]
    inner = [member for union in unions for member in union.fields]
    found = [member.when for member in (*message.fields, *inner) if member.when]
    groups = [m for m in message.fields if isinstance(m.type, Struct) and m.type.looks_outside]
    for group in groups:
        assert isinstance(group.type, Struct)
        asked = [member.when for member in group.type.fields if member.when]
        outer = [when for when in asked if all(test.is_outside for test in when.tests)]
        found += [when.of(word) for _, word in group.elements for when in outer]
    return found
