"""The whole protocol."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from sbgcgen.model.bodies import Field
from sbgcgen.model.effects import USUAL_EFFECTS, EffectKind
from sbgcgen.model.framing import Framing
from sbgcgen.model.messages import Command, Family, Message, Settings
from sbgcgen.model.names import KNOWN_FORMS
from sbgcgen.model.position import NOWHERE, Position
from sbgcgen.model.values import AxisDirection, Enum, Feature, Identifier, Packed, Quantity
from sbgcgen.model.values import Versions
from sbgcgen.model.variables import Variable


@dataclass(frozen=True)
class Addition:
    """An addition of a revision.

    `kind` is "command", "message", "field" or "value"; `owner` is the message of a field or the
    enum of a value, and `name` is the command, message, path or value.
    """

    kind: str
    owner: str
    name: str

    @property
    def text(self) -> str:
        return f"{self.owner}.{self.name}" if self.owner else self.name


@dataclass(frozen=True)
class Revision:
    """A revision of the specification; `changes` are sentences about changes without a name."""

    number: str
    date: str
    source: str
    adds: tuple[Addition, ...]
    changes: tuple[str, ...]
    at: Position = field(default=NOWHERE, compare=False, repr=False)


@dataclass(frozen=True)
class Erratum:
    """A problem of the specification, with its interpretation."""

    number: str
    kind: str
    lines: tuple[str, ...]
    problem: str
    reading: str
    reason: str
    at: Position = field(default=NOWHERE, compare=False, repr=False)


@dataclass(frozen=True)
class Line:
    """The serial line; the most likely baud rates and parities come first.

    The protocol names the first `named` of the rates.
    """

    baud_rates: tuple[int, ...]
    named: int
    parities: tuple[str, ...]
    shortest_pause_ms: int
    longest_pause_ms: int
    source: str
    errata: tuple[str, ...]
    at: Position = field(default=NOWHERE, compare=False, repr=False)


@dataclass(frozen=True)
class AskedForms:
    """Forms of a command from the board that have the same size: the request decides between them.

    Without a request, it is the first. `requests` are the requests for each of the forms.
    """

    identifier: str
    forms: tuple[Message, ...]
    requests: tuple[tuple[Message, Message], ...]

    def asks_for(self, form: Message) -> list[str]:
        """The names of the requests for a form."""
        return [request.name for request, wanted in self.requests if wanted is form]


@dataclass(frozen=True)
class Topic:
    """A topic of parameters; `fields` are their names, `words` other names of the topic. If it `changes_line`, the
    board may no longer answer after a change."""

    name: str
    summary: str
    words: tuple[str, ...]
    fields: tuple[str, ...]
    changes_line: bool = False
    at: Position = field(default=NOWHERE, compare=False, repr=False)


@dataclass(frozen=True)
class Layout:
    """The whole protocol.

    All framings are known; the first one is understood by every board. `newest_firmware` is the newest
    version that the specification describes, `oldest_firmware` the oldest one that the reference
    distinguishes; 0 if the spec does not state it. `timeout_errata` justify the default timeout; `guides` are files in docs/ by topic;
    `synonyms` are groups of words for the same thing; a field belongs to the first of its `topics`; `identifiers` are all words that become names
    in code, including those of fields that could not be resolved; `effects` are all that requests may
    have; `main_file` is the name of the file that describes the protocol. Messages report the features
    of a board in fields of the types `feature_sets`.
    """

    protocol: dict[str, str]
    framings: tuple[Framing, ...]
    line: Line
    families: tuple[Family, ...]
    quantities: tuple[Quantity, ...]
    enums: tuple[Enum, ...]
    packed: tuple[Packed, ...]
    commands: tuple[Command, ...]
    variables: tuple[Variable, ...]
    errata: tuple[Erratum, ...]
    indices: dict[str, tuple[str, ...]]
    versions: Versions = Versions()
    oldest_firmware: int = 0
    newest_firmware: int = 0
    revisions: tuple[Revision, ...] = ()
    timeout_errata: tuple[str, ...] = ()
    directions: tuple[AxisDirection, ...] = ()
    guides: dict[str, str] = field(default_factory=dict)
    synonyms: tuple[tuple[str, ...], ...] = ()
    topics: tuple[Topic, ...] = ()
    feature_sets: tuple[Enum, ...] = ()
    identifiers: tuple[Identifier, ...] = field(default=(), compare=False, repr=False)
    effects: tuple[EffectKind, ...] = USUAL_EFFECTS
    main_file: str = ""
    command_prefix: str = "CMD_"

    @property
    def short_name(self) -> str:
        """The name of the protocol for file names: that of the main file."""
        return self.main_file.removesuffix(".yaml")

    @property
    def framing(self) -> Framing:
        """The framing that every board understands."""
        return self.framings[0]

    @property
    def max_body(self) -> int:
        """The maximum size of a body, the same in all framings."""
        return self.framing.max_body

    @cached_property
    def features(self) -> tuple[Feature, ...]:
        """The features that boards may have: the flags of all sets, with consecutive bits."""
        found, shift = [], 0
        for flags in self.feature_sets:
            found += [Feature(v.name, v.value << shift) for v in flags.values]
            shift += 8 * flags.scalar.size
        return tuple(found)

    def topics_of(self, field_: Field) -> list[Topic]:
        """The topics of a field: its own first, then related ones."""
        known = [] if field_.reserved else self.topics
        return [topic for topic in known if field_.spec_name in topic.fields]

    def feature_mask(self, name: str) -> int:
        """The bit of a feature."""
        return next((feature.mask for feature in self.features if feature.name == name), 0)

    def reports(self, message: Message) -> list[tuple[Field, int, int]]:
        """The fields of a message that report features, with their shift and the named bits."""
        found, shift = [], 0
        for flags in self.feature_sets:
            named = sum(value.value for value in flags.values)
            for field_ in message.fields:
                if field_.type == flags and field_.dim == "one" and not field_.may_be_absent:
                    found.append((field_, shift, named))
            shift += 8 * flags.scalar.size
        return found

    @cached_property
    def messages(self) -> tuple[Message, ...]:
        return tuple(m for family in self.families for m in family.messages)

    def messages_of(self, command: str, direction: str) -> tuple[Message, ...]:
        return self._by_command.get((command, direction), ())

    @cached_property
    def _by_command(self) -> dict[tuple[str, str], tuple[Message, ...]]:
        return _grouped(self.messages, lambda m: (m.command, m.direction))

    @cached_property
    def asked(self) -> tuple[AskedForms, ...]:
        """The forms of the board that have the same size."""
        found: list[AskedForms] = []
        for (command, direction), messages in self._by_command.items():
            if direction == "to_board":
                continue
            sizes = [(m.min_size, m.max_size) for m in messages]
            forms = tuple(m for m in messages if sizes.count((m.min_size, m.max_size)) > 1)
            requests = [
                (request, form)
                for request in self.messages
                for form in forms
                if request.answer and request.answer.messages == (form.name,)
            ]
            if forms:
                found.append(AskedForms(messages[0].command_identifier, forms, tuple(requests)))
        return tuple(found)

    def asked_forms(self, message: Message) -> AskedForms | None:
        """The forms of the same size that a message is one of."""
        return next((asked for asked in self.asked if message in asked.forms), None)

    @cached_property
    def messages_by_id(self) -> dict[tuple[str, int], tuple[Message, ...]]:
        """The messages of each direction and id."""
        return _grouped(self.messages, lambda m: (m.direction, m.id))

    @cached_property
    def definitions(self) -> tuple[Message, ...]:
        """Messages that define a type, in the order of families."""
        return tuple(m for family in self.families for m in family.definitions)

    @property
    def types(self) -> tuple[Enum | Packed | Quantity, ...]:
        return *self.enums, *self.packed, *self.quantities

    @cached_property
    def settings(self) -> tuple[Settings, ...]:
        """The settings that can be read and stored, in the order of families."""
        stored = {m.stores for m in self.messages}
        bodies = {m.name: m.same_as or m.name for m in self.messages}

        requests = sorted(self.messages, key=lambda m: m.deprecated is not None)
        asking = [(m, [bodies.get(n) for n in m.answer.messages]) for m in requests if m.answer]
        found = []
        for message in self.definitions:
            if message.name in stored:
                readers = tuple(m for m, answers in asking if message.name in answers)
                writers = tuple(m for m in requests if m.stores == message.name)
                found.append(Settings(message, readers, writers))
        return tuple(found)

    @cached_property
    def forms(self) -> tuple[str, ...]:
        """The names of all forms, those with a special meaning first."""
        named = (m.form for m in self.messages if m.form)
        return tuple(dict.fromkeys((*KNOWN_FORMS, *named)))

    def having_role(self, kind: str) -> tuple[Message, ...]:
        """The messages with a role; if there are several, they are forms of one command."""
        return tuple(m for m in self.messages if m.role and m.role.kind == kind)


def _grouped(
    messages: Iterable[Message], key: Callable[[Message], tuple[Any, Any]]
) -> dict[tuple[Any, Any], tuple[Message, ...]]:
    groups: dict[tuple[Any, Any], tuple[Message, ...]] = {}
    for message in messages:
        groups[key(message)] = (*groups.get(key(message), ()), message)
    return groups
