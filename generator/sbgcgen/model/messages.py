"""Commands, their messages, and what these store."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from sbgcgen.model.position import NOWHERE, Position
from sbgcgen.model.answers import Answer, Role
from sbgcgen.model.bodies import Condition, Context, Field, Leaf, Struct
from sbgcgen.model.effects import Effect
from sbgcgen.model.values import Availability, Deprecation, Enum, Until
from sbgcgen.model.names import form_suffix, snake_case

# The enum of the ids of commands, by direction.
COMMAND_IDS = {"to_board": "CommandToBoard", "from_board": "CommandFromBoard"}


@dataclass(frozen=True)
class Message:
    """One body layout of one command in one direction.

    `keeps_tail`: bytes behind the described ones are kept. `is_open`: any body of at least
    `min_size` is taken for this message, of several forms the longest. `example` has the values by
    path in which the worked example is not typical; of what has the body of another message, on top
    of that one's.
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
    effect: Effect | None = None
    example: dict[str, Any] = field(default_factory=dict, hash=False)
    at: Position = field(default=NOWHERE, compare=False, repr=False)

    @property
    def identifier(self) -> str:
        """The name as a member would have it."""
        return snake_case(self.name)

    @property
    def command_ids(self) -> str:
        """The enum that has the id of its command; in both directions it is first of all a request."""
        return COMMAND_IDS["to_board" if self.in_both_directions else self.direction]

    @property
    def call(self) -> str:
        """The name of a function that sends it."""
        suffix = form_suffix(self.form)
        return f"{self.command_identifier}_{suffix}" if suffix else self.command_identifier

    @property
    def fields(self) -> tuple[Field, ...]:
        return self.body.fields

    @property
    def failure(self) -> Field | None:
        """In the form that answers a request that has failed, the field that says why."""
        return next(
            (
                f
                for f in self.fields
                if self.form == "error" and isinstance(f.type, Enum) and f.type.success
                if f.offset is not None and f.dim == "one" and f.when is None
            ),
            None,
        )

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
    at: Position = field(default=NOWHERE, compare=False, repr=False)


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


def conditions(message: Message) -> list[Condition]:
    """All conditions about what the message as a whole says: those of its fields and regions."""
    regions = [m.type for m in message.fields if isinstance(m.type, Struct) and m.type.is_region]
    inner = [member for region in regions for member in region.fields]
    return [member.when for member in (*message.fields, *inner) if member.when]
