"""Resolves messages: the forms of a command in each direction, and their bodies."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from sbgcgen.model import Availability, Command, Context, Field, Message, Position, Struct, Until
from sbgcgen.model.names import camel_case, form_suffix
from sbgcgen.spec.diagnostics import did_you_mean
from sbgcgen.spec.load import Map, empty_map
from sbgcgen.spec.resolve.answers import AnswerResolver
from sbgcgen.spec.resolve.contexts import announceable_types, context_of
from sbgcgen.spec.resolve.effects import EffectResolver
from sbgcgen.spec.resolve.sizes import confused, max_size, may_grow, min_size, total_size
from sbgcgen.spec.resolve.fields import FieldResolver
from sbgcgen.spec.resolve.leaves import leaves

DIRECTIONS = ("from_board", "to_board")


@dataclass
class _Draft:
    """A message before its body is resolved."""

    name: str
    command: Command
    entry: Map  # of the command
    direction: str
    form: str | None
    node: Map
    parent: Map
    at: Position

    def get(self, key: str, default: Any = None) -> Any:
        """A property of the form, or else of its direction."""
        return self.owner(key).get(key, default)

    def owner(self, key: str) -> Map:
        """The node with a property: that of the form, or else of its direction."""
        return self.node if key in self.node else self.parent

    def inherited(self, read: Callable[[Map], Any]) -> Any:
        """What is said about the form, or else about its direction or command."""
        return read(self.node) or read(self.parent) or read(self.entry)


class MessageResolver:
    """Collects drafts of all messages first, because any message may need the body of another."""

    def __init__(
        self, fields: FieldResolver, answers: AnswerResolver, effects: EffectResolver
    ) -> None:
        self.effects = effects
        self.types = fields.types
        self.fields = fields
        self.answers = answers
        self.found = fields.found
        self.drafts: dict[tuple[str, str], _Draft] = {}
        self.done: dict[tuple[str, str], Message] = {}
        self.open: list[str] = []

    def add(self, command: Command, node: Map) -> None:
        """Add drafts of the messages of a command."""
        for direction in DIRECTIONS:
            if direction in node:
                self._draft(command, direction, node)

    def run(self) -> list[Message]:
        """Resolve all messages; call it after adding all commands."""
        self._check_same_as()
        messages = self._settle_tails([self._message(draft) for draft in self.drafts.values()])
        messages = [self._settle_types(message) for message in messages]
        return self.answers.settle(messages)

    def _draft(self, command: Command, direction: str, node: Map) -> None:
        side = node[direction]
        forms = side.get("forms", {None: side})
        base = camel_case(command.name.removeprefix(self.types.spec.command_prefix))
        # One direction of a command may have the same body, and thus the same name, as the other.
        is_shared = any(node[d].get("same_as") == base for d in DIRECTIONS if d in node)
        if direction == "to_board" and "from_board" in node and not is_shared:
            base += "Request"
        for form, content in forms.items():
            at = side["forms"].at(form) if form else node.at(direction)
            body = content if content is not None else empty_map(at)
            name = str(body.get("as", base + camel_case(form_suffix(form))))
            draft = _Draft(name, command, node, direction, form, body, side, at)
            key = (name, direction)
            if key in self.drafts:
                first = self.drafts[key].at
                message = f"message {name} is defined twice (first at {first})"
                if self.drafts[key].command.name != command.name or first.file == at.file:
                    self.found.add(at, "SBGC028", message, "give one of them a name with 'as'")
            self.drafts[key] = draft

    def _check_same_as(self) -> None:
        """Every 'same_as' must lead to a list of fields; removes those that do not."""
        for draft in self.drafts.values():
            seen: list[_Draft] = []
            step: _Draft | None = draft
            while step is not None and step.get("same_as") and step not in seen:
                seen.append(step)
                name = step.get("same_as")
                others = [d for (n, _), d in self.drafts.items() if n == name and d is not step]
                others.sort(key=lambda d: bool(d.get("same_as")))
                step = others[0] if others else (step if name == step.name else None)
            if step is not None and step in seen:
                node = draft.node if "same_as" in draft.node else draft.parent
                message = f"the 'same_as' of {draft.name} leads back to itself"
                hint = "one of them must list the fields"
                self.found.add(node.at("same_as"), "SBGC029", message, hint)
                node.pop("same_as")

    def _find(self, name: str, at: Position) -> Message | None:
        """The message with this name, from the direction that defines its body."""
        candidates = [d for (n, _), d in self.drafts.items() if n == name]
        candidates.sort(key=lambda d: "same_as" in d.node)
        if not candidates:
            known = sorted({n for n, _ in self.drafts})
            hint = did_you_mean(name, known)
            hint = hint or "use the identifier of a message, such as BoardInfo"
            self.found.add(at, "SBGC021", f"there is no message '{name}'", hint)
            return None
        if name in self.open:
            hint = "write the fields out in one of them"
            self.found.add(at, "SBGC029", f"message {name} includes itself", hint)
            return None
        return self._message(candidates[0])

    def _message(self, draft: _Draft) -> Message:
        key = (draft.name, draft.direction)
        if key in self.done:
            return self.done[key]
        self.open.append(draft.name)
        contexts = tuple(context_of(c, self.types) for c in draft.get("context", []))
        same_as = str(draft.get("same_as", ""))
        both = (draft.name, _other(draft.direction)) in self.drafts
        since = draft.inherited(self.types.availability)
        body = self._body(draft, contexts, same_as, both, since)
        original = self._original(draft, same_as)
        self.open.pop()
        keep = original.keeps_tail if original else draft.direction == "from_board" or both
        tail = str(draft.get("tail", "keep" if keep else "refuse"))
        limit = self.fields.max_body
        if body.min_size > limit:
            message = (
                f"the body of {draft.name} has {body.min_size} bytes; {limit} fit into a frame"
            )
            self.found.add(draft.at, "SBGC013", message, "split it into several messages")
        open_ended = any(
            (f.dim == "rest" and f.type.kind != "announced") or f.has_grown_elements
            for f in body.fields
        )
        self.done[key] = Message(
            name=draft.name,
            command=draft.command.name,
            command_identifier=draft.command.identifier,
            id=draft.command.id or 0,
            direction=draft.direction,
            form=draft.form,
            family=draft.command.family,
            since=since,
            needs=draft.inherited(self.types.needs),
            body=body,
            same_as=same_as if same_as != draft.name else "",
            in_both_directions=both,
            keeps_tail=tail == "keep" and not open_ended,
            is_open=False,
            tail_capacity=max(0, limit - body.min_size),
            min_size=body.min_size,
            max_size=int(draft.get("max_size", max_size(body.fields, limit))),
            contexts=contexts or (original.contexts if original else ()),
            has_own_name="as" in draft.node,
            leaves=tuple(leaves(body.fields)) if body.min_size <= limit else (),
            at=draft.at,
            **self._description(draft),
            **self._behavior(draft, body.fields, original),
        )
        return self.done[key]

    def _description(self, draft: _Draft) -> dict[str, Any]:
        """The documentation of the message: texts, sources and history."""
        source = draft.node.get("source") or self.types.source(draft.parent, draft.at, draft.name)
        errata = *self.types.errata(draft.parent), *self.types.errata(draft.node)
        return {
            "summary": self._summary(draft),
            "description": " ".join(str(draft.get("description", "")).split()),
            "source": str(source),
            "errata": tuple(dict.fromkeys(errata)),
            "until": self._until(draft),
            "deprecated": draft.inherited(self.types.deprecation),
            "preparation": " ".join(str(draft.get("preparation", "")).split()),
            "unconfirmed": bool(draft.get("unconfirmed", False)) or draft.command.unconfirmed,
        }

    def _behavior(
        self, draft: _Draft, fields: tuple[Field, ...], original: Message | None
    ) -> dict[str, Any]:
        """The effects of the message and its answers, with examples of both."""
        examples, name = self.fields.examples, draft.name
        is_request = draft.direction == "to_board"
        return {
            "answer": self.answers.answer(draft.get("answer"), name, fields, draft.at)
            if is_request
            else None,
            "role": self.answers.roles.role(draft.get("role"), draft.direction, fields),
            "stores": str(draft.get("stores", "")),
            "effect": self.effects.effect(draft.owner("effect"), fields),
            "stops": examples.stops(fields, draft.get("stops"), name),
            "example": {
                **(original.example if original else {}),
                **examples.example(fields, draft.get("example"), name),
            },
        }

    def _until(self, draft: _Draft) -> Until | None:
        """The first firmware that no longer accepts the message, and the form that replaces it."""
        node = draft.get("until")
        if not isinstance(node, Map):
            return None
        versions = self.types.availability(draft.owner("until"), "until")
        wanted = str(node.get("instead", ""))
        forms = {
            d.form: d.name
            for d in self.drafts.values()
            if (d.command, d.direction) == (draft.command, draft.direction) and d is not draft
        }
        if wanted and wanted not in forms:
            hint = did_you_mean(wanted, filter(None, forms)) or "name another form of the command"
            text = f"{draft.command.name} has no form '{wanted}'"
            self.found.add(node.at("instead"), "SBGC021", text, hint)
        return Until(versions, forms.get(wanted, "") if wanted else "", node.position)

    def _original(self, draft: _Draft, same_as: str) -> Message | None:
        """The other message that defines the body of this one."""
        keys = [(same_as, direction) for direction in DIRECTIONS if same_as != draft.name]
        return next((self._message(self.drafts[k]) for k in keys if k in self.drafts), None)

    def _settle_tails(self, messages: list[Message]) -> list[Message]:
        """Let only the longest of several forms keep a tail, because size distinguishes the others.

        A message with the body of another has that message's tail setting, unless it has its own.
        """
        sizes: dict[tuple[str, str], int] = {}
        for message in messages:
            key = message.command, message.direction
            sizes[key] = max(sizes.get(key, 0), message.max_size)
        longest = [m.max_size == sizes[m.command, m.direction] for m in messages]
        keeps = [m.keeps_tail and is_last for m, is_last in zip(messages, longest)]
        owners = {id(m.body): keep for m, keep in zip(messages, keeps) if not m.same_as}
        result = []
        for message, is_last, keep in zip(messages, longest, keeps):
            if message.same_as and self.drafts[message.name, message.direction].get("tail") is None:
                keep = owners.get(id(message.body), keep)
            is_open = is_last and (keep or any(f.dim == "rest" for f in message.fields))
            message = replace(message, keeps_tail=keep, is_open=is_open)
            has_room = message.has_end and message.max_size < self.fields.max_body
            is_request = message.direction == "to_board" and not message.contexts
            result.append(replace(message, takes_surplus=is_request and is_last and has_room))
        return result

    def _settle_types(self, message: Message) -> Message:
        """Complete the announced types of contexts, which need all messages."""
        if not any(context.announced for context in message.contexts):
            return message
        contexts = []
        for context in message.contexts:
            announced = context.announced
            if announced:
                others = [m for (n, _), m in self.done.items() if n == announced.message]
                types = announceable_types(announced, others[0].fields) if others else ()
                context = replace(context, announced=replace(announced, types=types))
            contexts.append(context)
        return replace(message, contexts=tuple(contexts))

    def _summary(self, draft: _Draft) -> str:
        for node in (draft.node, draft.parent):
            if node.get("summary"):
                return self.types.summary(node, draft.at, draft.name)
        if draft.direction == "from_board" or "from_board" not in draft.entry:
            return draft.command.summary
        return self.types.summary(draft.node, draft.at, draft.name)

    def _body(
        self,
        draft: _Draft,
        contexts: tuple[Context, ...],
        same_as: str,
        both: bool,
        since: Availability,
    ) -> Struct:
        at = draft.node.at("same_as") if "same_as" in draft.node else draft.parent.at("same_as")
        fields: tuple[Field, ...] = ()
        if same_as and (same_as != draft.name or both):
            if same_as == draft.name:
                other = self.drafts[(draft.name, _other(draft.direction))]
                return self._message(other).body
            original = self._find(same_as, at)
            if original is not None:
                return original.body
        else:
            fields = self.fields.fields(
                draft.node.get("fields", []), draft.name, contexts, include=self._included
            )
            fields = self._appended(draft, fields, since)
            self._check_earlier(draft.node.get("fields", []), draft.name, since)
        size = total_size(fields)
        return Struct(
            name=draft.name,
            summary="",
            fields=fields,
            size=size,
            min_size=size if size is not None else min_size(fields),
            family=draft.command.family,
            rules=self.fields.rules(draft.node, fields),
            at=draft.at,
        )

    def _appended(
        self, draft: _Draft, fields: tuple[Field, ...], since: Availability
    ) -> tuple[Field, ...]:
        """Mark the fields at the end that later versions appended.

        With a `size`, such fields were reserved bytes before.
        """
        if "size" in draft.node:
            self._check_size(draft, fields)
            return fields
        fields = self._with_grown_elements(fields, since)
        for field in fields:
            if field.dim in ("counted", "rest") and isinstance(field.type, Struct):
                self._check_elements(field, field.type, field.since.later(since))
        first = len(fields)
        while first and fields[first - 1].since.is_after(since) and not fields[first - 1].when:
            first -= 1
        self._check_later(draft, fields[:first], since)
        return (
            *fields[:first],
            *(f if f.dim == "rest" else replace(f, appended=True) for f in fields[first:]),
        )

    def _check_later(self, draft: _Draft, fields: tuple[Field, ...], since: Availability) -> None:
        """Report later fields whose bytes are missing in the bodies of older firmware."""
        for field in fields:
            if field.when or field.dim == "rest":
                continue
            if field.since.is_after(since):
                text = f"older firmware of {draft.name} has no bytes for '{field.name}'"
                hint = "move it to the end, or give the message a 'size' if they were reserved"
                self.found.add(field.at, "SBGC071", text, hint)

    def _with_grown_elements(
        self, fields: tuple[Field, ...], since: Availability
    ) -> tuple[Field, ...]:
        """The fields; if the last one is a list that grew, with all sizes of its elements."""
        last = fields[-1] if fields else None
        if last is None or not may_grow(last) or not isinstance(last.type, Struct):
            return fields
        struct = self.fields.grown(last.type, last.since.later(since))
        if not struct.element_sizes:
            return fields
        capacity = self.fields.capacity(
            struct, fields[:-1], last.counting, last.counter, last.counter_part
        )
        room = self.fields.room(fields[:-1])
        problem = confused(struct.element_sizes, room) if last.dim == "rest" else None
        if problem is not None:
            one, other, size = problem
            text = f"{size} bytes of '{last.name}' are elements of {one} or of {other} bytes"
            self.found.add(last.at, "SBGC071", text, "count the elements: NAME[COUNT]")
        return (*fields[:-1], replace(last, type=struct, size=None, capacity=capacity))

    def _check_elements(self, of: Field, struct: Struct, since: Availability) -> None:
        """Report later members of elements whose presence a decoder cannot detect."""
        for field in struct.fields:
            if field.since.is_after(since) and not (field.when or field.appended):
                text = f"older elements of '{of.name}' may have no bytes for '{field.name}'"
                hint = (
                    "append it, in the order of the firmware and with one size, to the elements of a"
                    " list without condition that ends the message, or leave 'since' out"
                )
                self.found.add(field.at, "SBGC071", text, hint)
            if isinstance(field.type, Struct):
                self._check_elements(of, field.type, since)

    def _check_earlier(self, nodes: list[Any], owner: str, since: Availability) -> None:
        """Report fields that are declared older than their message."""
        for node in nodes:
            firmware = self.types.availability(node).firmware
            if firmware and firmware < since.firmware:
                text = f"{node.get('name', 'a field')} is older than {owner}, which it is in"
                self.found.add(node.at("since"), "SBGC071", text, "leave its 'since' out")
            self._check_earlier(node.get("fields", []), owner, since)

    def _check_size(self, draft: _Draft, fields: tuple[Field, ...]) -> None:
        size = total_size(fields)
        if size != draft.node["size"]:
            described = "vary in size" if size is None else f"have {size} bytes"
            message = f"the fields of {draft.name} {described}"
            hint = "'size' is that of a body without variable parts"
            if size is not None:
                word = "add" if size < draft.node["size"] else "remove"
                difference = abs(draft.node["size"] - size)
                hint = f"{word} {difference} byte{'s' * (difference != 1)}, or write size: {size}"
            self.found.add(draft.node.at("size"), "SBGC013", message, hint)

    def _included(self, node: Map) -> list[Field]:
        message = self._find(str(node["include"]), node.at("include"))
        if message is None:
            return []
        return [
            replace(
                f,
                name="reserved" if f.reserved and f.spec_name == "RESERVED" else f.name,
                appended=False,
                at=node.at("include"),
            )
            for f in message.fields
        ]


def _other(direction: str) -> str:
    return "to_board" if direction == "from_board" else "from_board"
