"""Turns a Spec into the Layout model: commands, forms, messages and what answers them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

from sbgcgen.model import (
    Announcement,
    Command,
    Context,
    Effect,
    EffectCase,
    Erratum,
    Family,
    Field,
    Framing,
    Layout,
    Message,
    Position,
    Revision,
    Struct,
    Until,
)
from sbgcgen.model.names import camel_case, form_suffix, snake_case
from sbgcgen.spec.diagnostics import Diagnostics, did_you_mean
from sbgcgen.spec.load import Map, Spec
from sbgcgen.spec.resolve.answers import AnswerResolver
from sbgcgen.spec.resolve.fields import (
    FieldResolver,
    announceable_types,
    leaves,
    max_size,
    min_size,
    total_size,
)
from sbgcgen.spec.resolve.revisions import RevisionResolver
from sbgcgen.spec.resolve.types import TypeResolver
from sbgcgen.spec.resolve.variables import VariableResolver

DIRECTIONS = ("from_board", "to_board")


@dataclass
class _Draft:
    """A message before its body is resolved."""

    name: str
    command: Command
    direction: str
    form: str | None
    node: Map
    parent: Map
    at: Position

    def get(self, key: str, default: Any = None) -> Any:
        """A property of the form, or else of the direction it belongs to."""
        return self.node.get(key, self.parent.get(key, default))


class _Resolver:
    def __init__(self, spec: Spec, found: Diagnostics) -> None:
        self.spec = spec
        self.found = found
        self.types = TypeResolver(spec, found)
        self.types.run()
        self.framing = self._framing()
        self.fields = FieldResolver(spec, self.types, found, self.framing.max_body)
        self.answers = AnswerResolver(spec, self.types, self.fields, found)
        self.line = self.answers.line(spec.main.get("line"))
        self.commands = [self._command(*entry) for entry in spec.entries("commands")]
        self.drafts: dict[tuple[str, str], _Draft] = {}
        self.done: dict[tuple[str, str], Message] = {}
        self.open: list[str] = []

    def run(self) -> Layout:
        for command, (_, _, node, _) in zip(self.commands, self.spec.entries("commands")):
            for direction in DIRECTIONS:
                if direction in node:
                    self._draft(command, direction, node)
        self._check_same_as()
        messages = self._settle_tails([self._message(draft) for draft in self.drafts.values()])
        messages = [self._settle_types(message) for message in messages]
        messages = self.answers.settle(messages)
        for name in self.fields._nodes:
            self.fields.struct(name)
        variables = VariableResolver(self.types, messages, self.found)
        families = []
        for family, content in self.spec.families.items():
            structs = [s for s in self.fields.structs.values() if s.family == family]
            mine = [m for m in messages if m.family == family]
            families.append(
                Family(family, str(content.get("summary", "")), tuple(structs), tuple(mine))
            )
        return Layout(
            protocol={
                k: str(v) for k, v in self.spec.main.get("protocol", {}).items() if k != "lines"
            },
            framing=self.framing,
            line=self.line,
            families=tuple(families),
            quantities=tuple(self.types.types.quantities.values()),
            enums=tuple(self.types.types.enums.values()),
            packed=tuple(self.types.types.packed.values()),
            commands=tuple(self.commands),
            variables=tuple(
                variables.variable(name, node, at)
                for _, name, node, at in self.spec.entries("variables")
            ),
            errata=tuple(self._errata()),
            indices=self.fields.indices,
            revisions=tuple(self._revisions(messages)),
            guides={k: str(v) for k, v in self.spec.main.get("guides", {}).items()},
            synonyms=tuple(tuple(group) for group in self.spec.main.get("synonyms", ())),
            timeout_errata=self.types.errata(self.spec.main.get("defaults", Map())),
            identifiers=tuple(self.types.identifiers),
        )

    def _revisions(self, messages: list[Message]) -> Iterator[Revision]:
        enums = list(self.types.types.enums.values())
        return RevisionResolver(self.commands, messages, enums, self.found).revisions(self.spec)

    # The main file

    def _framing(self) -> Framing:
        node = self.spec.main["framing"]
        return Framing(
            start=node["start"],
            header_size=len(node["header"]),
            trailer_size=len(node["trailer"]),
            max_body=node["max_body"],
            source=str(node["source"]),
            errata=self.types.errata(node),
        )

    def _errata(self) -> list[Erratum]:
        entries = self.spec.errata.get("errata", Map())
        return [
            Erratum(
                number=number,
                kind=str(node["kind"]),
                lines=tuple(str(line) for line in node.get("lines", [])),
                problem=" ".join(str(node["problem"]).split()),
                reading=" ".join(str(node["reading"]).split()),
                reason=" ".join(str(node.get("reason", "")).split()),
                at=entries.at(number),
            )
            for number, node in entries.items()
        ]

    # Commands and messages

    def _command(self, family: str, name: str, node: Map, at: Position) -> Command:
        return Command(
            name=name,
            identifier=snake_case(name.removeprefix("CMD_")),
            id=node["id"],
            family=family,
            summary=self.types.summary(node, at, name),
            source=str(node.get("source", "")),
            errata=self.types.errata(node),
            since=self.types.availability(node),
            undocumented=bool(node.get("undocumented", False)),
            at=at,
        )

    def _draft(self, command: Command, direction: str, node: Map) -> None:
        side = node[direction]
        forms = side.get("forms", {None: side})
        base = camel_case(command.name.removeprefix("CMD_"))
        answers_itself = direction == "to_board" and "from_board" in node
        shared = any("same_as" in node.get(d, {}) for d in DIRECTIONS)
        if answers_itself and not (shared and self._is_own_body(node, base)):
            base += "Request"
        for form, content in forms.items():
            at = side["forms"].at(form) if form else node.at(direction)
            body = content if content is not None else _no_body(at)
            name = str(body.get("as", base + camel_case(form_suffix(form))))
            draft = _Draft(name, command, direction, form, body, side, at)
            key = (name, direction)
            if key in self.drafts:
                first = self.drafts[key].at
                message = f"message {name} is defined twice (first at {first})"
                if self.drafts[key].command.name != command.name or first.file == at.file:
                    self.found.add(at, "SBGC028", message, "give one of them a name with 'as'")
            self.drafts[key] = draft

    def _check_same_as(self) -> None:
        """Every 'same_as' must lead to a list of fields; one that does not is taken out."""
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

    def _is_own_body(self, node: Map, base: str) -> bool:
        """Whether one direction of a command has the very body of the other."""
        return any(node[d].get("same_as") == base for d in DIRECTIONS if d in node)

    def _find(self, name: str, at: Position) -> Message | None:
        """A message by name, whichever direction defines its body."""
        candidates = [d for (n, _), d in self.drafts.items() if n == name]
        candidates.sort(key=lambda d: "same_as" in d.node)
        if not candidates:
            known = sorted({n for n, _ in self.drafts})
            hint = did_you_mean(name, known)
            hint = hint or "name the C++ message, such as BoardInfo"
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
        contexts = tuple(self._context(c) for c in draft.get("context", []))
        same_as = str(draft.get("same_as", ""))
        both = (draft.name, _other(draft.direction)) in self.drafts
        body = self._body(draft, contexts, same_as, both)
        original = self._original(draft, same_as)
        if original is not None:
            contexts = contexts or original.contexts
        self.open.pop()
        keep = original.keeps_tail if original else draft.direction == "from_board" or both
        tail = str(draft.get("tail", "keep" if keep else "refuse"))
        limit = self.framing.max_body
        largest = int(draft.get("max_size", max_size(body.fields, limit)))
        if body.min_size > limit:
            message = (
                f"the body of {draft.name} has {body.min_size} bytes; {limit} fit into a frame"
            )
            self.found.add(draft.at, "SBGC013", message, "split it into several messages")
        open_ended = any(f.dim == "rest" and f.type.kind != "announced" for f in body.fields)
        message_ = Message(
            name=draft.name,
            command=draft.command.name,
            command_identifier=draft.command.identifier,
            id=draft.command.id or 0,
            direction=draft.direction,
            form=draft.form,
            family=draft.command.family,
            summary=self._summary(draft),
            description=" ".join(str(draft.get("description", "")).split()),
            source=self.types.source(draft.parent, draft.at, draft.name)
            if not draft.node.get("source")
            else str(draft.node["source"]),
            errata=tuple(
                dict.fromkeys((*self.types.errata(draft.parent), *self.types.errata(draft.node)))
            ),
            since=self.types.availability(draft.node)
            or self.types.availability(draft.parent)
            or draft.command.since,
            until=self._until(draft),
            deprecated=self.types.deprecation(draft.node)
            or self.types.deprecation(draft.parent)
            or self.types.deprecation(self._command_node(draft)),
            body=body,
            same_as=same_as if same_as != draft.name else "",
            in_both_directions=both,
            keeps_tail=tail == "keep" and not open_ended,
            is_open=False,
            tail_capacity=max(0, limit - body.min_size),
            min_size=body.min_size,
            max_size=largest,
            contexts=contexts,
            answer=self.answers.answer(draft.get("answer"), draft.name, body.fields, draft.at)
            if draft.direction == "to_board"
            else None,
            role=self.answers.role(draft.get("role"), draft.direction, body.fields),
            stores=str(draft.get("stores", "")),
            effect=self._effect(draft.get("effect"), body.fields),
            example={
                **(original.example if original else {}),
                **self.fields.examples.example(body.fields, draft.get("example"), draft.name),
            },
            leaves=tuple(leaves(body.fields)) if body.min_size <= limit else (),
            at=draft.at,
        )
        self.done[key] = message_
        return message_

    def _effect(self, node: Any, fields: tuple[Field, ...]) -> Effect | None:
        """`node` is what stands behind `effect:`: a word, several, or cases."""
        if node is None:
            return None
        listed = node if isinstance(node, list) else [node]
        if not isinstance(listed[0], Map):
            return Effect((EffectCase(None, tuple(listed)),))
        cases = []
        for case in listed:
            does = case["does"]
            when = self.fields.condition(case, list(fields), ())
            cases.append(EffectCase(when, tuple(does if isinstance(does, list) else [does])))
        return Effect(tuple(cases))

    def _until(self, draft: _Draft) -> Until | None:
        """The firmware that no longer takes the message, and the form that it takes instead."""
        node = draft.get("until")
        if not isinstance(node, Map):
            return None
        owner = draft.node if "until" in draft.node else draft.parent
        versions = self.types.availability(owner, "until")
        wanted = str(node.get("instead", ""))
        forms = {
            d.form: d.name
            for d in self.drafts.values()
            if (d.command, d.direction) == (draft.command, draft.direction) and d is not draft
        }
        if wanted and wanted not in forms:
            hint = (
                did_you_mean(wanted, [f for f in forms if f]) or "name another form of the command"
            )
            at = node.at("instead")
            self.found.add(at, "SBGC021", f"{draft.command.name} has no form '{wanted}'", hint)
        return Until(versions, forms.get(wanted, "") if wanted else "", node.position)

    def _original(self, draft: _Draft, same_as: str) -> Message | None:
        """The other message whose body this one has."""
        for direction in DIRECTIONS if same_as != draft.name else ():
            if (same_as, direction) in self.drafts:
                return self._message(self.drafts[same_as, direction])
        return None

    def _settle_tails(self, messages: list[Message]) -> list[Message]:
        """Of several forms only the longest may grow: the others are told apart by their size.

        A message with the body of another grows as that does, unless it says otherwise.
        """
        result = []
        for message in messages:
            forms = [
                m.max_size
                for m in messages
                if m.command == message.command and m.direction == message.direction
            ]
            longest = message.max_size == max(forms)
            open_ended = message.keeps_tail or any(f.dim == "rest" for f in message.fields)
            keeps = message.keeps_tail and longest
            result.append(replace(message, keeps_tail=keeps, is_open=open_ended and longest))
        owners = {id(m.body): m.keeps_tail for m in result if not m.same_as}
        return [
            replace(m, keeps_tail=owners.get(id(m.body), m.keeps_tail))
            if m.same_as and self.drafts[m.name, m.direction].get("tail") is None
            else m
            for m in result
        ]

    def _settle_types(self, message: Message) -> Message:
        """What the contexts of a message can announce is known when all messages are."""
        contexts = []
        for context in message.contexts:
            announced = context.announced
            if announced:
                others = [m for (n, _), m in self.done.items() if n == announced.message]
                types = announceable_types(announced, others[0].fields) if others else ()
                context = replace(context, announced=replace(announced, types=types))
            contexts.append(context)
        return replace(message, contexts=tuple(contexts))

    def _command_node(self, draft: _Draft) -> Map:
        node = self.spec.families[draft.command.family]["commands"][draft.command.name]
        assert isinstance(node, Map)
        return node

    def _summary(self, draft: _Draft) -> str:
        for node in (draft.node, draft.parent):
            if node.get("summary"):
                return self.types.summary(node, draft.at, draft.name)
        if draft.direction == "from_board" or "from_board" not in self._command_node(draft):
            return draft.command.summary
        return self.types.summary(draft.node, draft.at, draft.name)

    def _body(
        self, draft: _Draft, contexts: tuple[Context, ...], same_as: str, both: bool
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
        size = total_size(fields)
        return Struct(
            name=draft.name,
            summary="",
            fields=fields,
            size=size,
            min_size=size if size is not None else min_size(fields),
            family=draft.command.family,
            at=draft.at,
        )

    def _included(self, node: Map) -> list[Field]:
        message = self._find(str(node["include"]), node.at("include"))
        if message is None:
            return []
        return [
            replace(
                f,
                name="reserved" if f.reserved and f.spec_name == "RESERVED" else f.name,
                at=node.at("include"),
            )
            for f in message.fields
        ]

    def _context(self, node: Map) -> Context:
        summary = self.types.summary(node, node.position, str(node["name"]))
        name = snake_case(str(node["name"]))
        if "announced_by" in node:
            message, _, list_name = str(node["announced_by"]).partition(".")
            kind = ".".join(snake_case(word) for word in str(node["kind"]).split("."))
            count = snake_case(str(node["count"]))
            announced = Announcement(message, snake_case(list_name), kind, count)
            return Context(name, None, summary, (), announced)
        enum = self.types.enum_named(str(node["type"]), node.at("type"))
        sources = []
        for entry in node.get("from", []):
            message, _, field = str(entry).partition(".")
            sources.append((message, ".".join(snake_case(p) for p in field.split("."))))
        return Context(name, enum, summary, tuple(sources))


def _no_body(at: Position) -> Map:
    """The content of a form that is only named."""
    result = Map()
    result.position, result.keys_at = at, {}
    return result


def _other(direction: str) -> str:
    return "to_board" if direction == "from_board" else "from_board"


def resolve(spec: Spec, found: Diagnostics) -> Layout:
    """Resolve a spec that fits the schema; findings go into `found`."""
    return _Resolver(spec, found).run()
