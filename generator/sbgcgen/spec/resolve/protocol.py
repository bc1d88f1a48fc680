"""Resolves a Spec to the Layout model."""

from __future__ import annotations

from collections.abc import Iterator

from sbgcgen.model import (
    Command,
    Enum,
    Erratum,
    Family,
    Layout,
    Message,
    Position,
    Revision,
)
from sbgcgen.model.names import snake_case
from sbgcgen.spec.diagnostics import Diagnostics
from sbgcgen.spec.load import List, Map, Spec
from sbgcgen.spec.resolve.answers import AnswerResolver
from sbgcgen.spec.resolve.effects import EffectResolver
from sbgcgen.spec.resolve.fields import FieldResolver
from sbgcgen.spec.resolve.framing import framings_of
from sbgcgen.spec.resolve.line import line_of
from sbgcgen.spec.resolve.messages import MessageResolver
from sbgcgen.spec.resolve.revisions import RevisionResolver
from sbgcgen.spec.resolve.topics import topics_of
from sbgcgen.spec.resolve.types import TypeResolver
from sbgcgen.spec.resolve.variables import VariableResolver


class _Resolver:
    def __init__(self, spec: Spec, found: Diagnostics) -> None:
        self.spec = spec
        self.found = found
        self.types = TypeResolver(spec, found)
        self.types.run()
        self.framings = framings_of(spec.main["framings"], self.types, found)
        self.fields = FieldResolver(spec, self.types, found, self.framings[0].max_body)
        self.answers = AnswerResolver(spec, self.types, self.fields, found)
        self.line = line_of(spec.main.get("line"), self.types, found)
        self.commands = [self._command(*entry) for entry in spec.entries("commands")]
        effects = EffectResolver(spec, self.fields.references, found)
        self.messages = MessageResolver(self.types, self.fields, self.answers, effects, found)

    def run(self) -> Layout:
        for command, (_, _, node, _) in zip(self.commands, self.spec.entries("commands")):
            self.messages.add(command, node)
        messages = self.messages.run()
        structs = self.fields.all_structs()
        variables = VariableResolver(self.types, messages, self.found)
        families = []
        for family, content in self.spec.families.items():
            of_family = tuple(s for s in structs if s.family == family)
            mine = tuple(m for m in messages if m.family == family)
            families.append(Family(family, str(content.get("summary", "")), of_family, mine))
        return Layout(
            protocol={
                k: str(v) for k, v in self.spec.main.get("protocol", {}).items() if k != "lines"
            },
            framings=self.framings,
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
            versions=self.types.versions.versions,
            oldest_firmware=self._firmware("oldest_firmware"),
            newest_firmware=self._firmware("newest_firmware"),
            feature_sets=self._feature_sets(),
            revisions=tuple(self._revisions(messages)),
            guides={k: str(v) for k, v in self.spec.main.get("guides", {}).items()},
            synonyms=tuple(tuple(group) for group in self.spec.main.get("synonyms", ())),
            topics=tuple(topics_of(self.spec.main.get("topics", Map()), messages, self.found)),
            directions=self.fields.directions.directions,
            timeout_errata=self.types.errata(self.spec.main.get("defaults", Map())),
            identifiers=tuple(self.types.identifiers),
            effects=self.messages.effects.kinds,
            main_file=self.spec.main_file,
            command_prefix=self.spec.command_prefix,
        )

    def _revisions(self, messages: list[Message]) -> Iterator[Revision]:
        enums = list(self.types.types.enums.values())
        return RevisionResolver(self.commands, messages, enums, self.found).revisions(self.spec)

    # The main file

    def _firmware(self, key: str) -> int:
        node = self.spec.main.get("protocol", Map())
        if key not in node:
            return 0
        text, at = str(node[key]), node.at(key)
        return self.types.versions.version("firmware", text, at)

    def _feature_sets(self) -> tuple[Enum, ...]:
        """The flag sets of board features."""
        names = self.spec.main.get("features", List())
        found = []
        for name, at in zip(names, getattr(names, "items_at", [])):
            flags = self.types.enum_named(str(name), at)
            if flags is not None and flags.kind != "flags":
                hint = "each feature is a flag that boards report"
                self.found.add(at, "SBGC026", f"{name} is not a flag set", hint)
            elif flags is not None:
                found.append(flags)
        if sum(flags.scalar.size for flags in found) > 8:
            text = "the board features have more than 64 bits"
            self.found.add(names.items_at[-1], "SBGC017", text, "name smaller flag sets")
        return tuple(found)

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

    def _command(self, family: str, name: str, node: Map, at: Position) -> Command:
        return Command(
            name=name,
            identifier=str(node.get("as", snake_case(name.removeprefix(self.spec.command_prefix)))),
            id=node["id"],
            family=family,
            summary=self.types.summary(node, at, name),
            source=str(node.get("source", "")),
            errata=self.types.errata(node),
            since=self.types.availability(node),
            undocumented=bool(node.get("undocumented", False)),
            aliases=self.types.aliases(node, self.spec.command_prefix),
            unconfirmed=bool(node.get("unconfirmed", False)),
            needs=self.types.needs(node),
            at=at,
        )


def resolve(spec: Spec, found: Diagnostics) -> Layout:
    """Resolve a spec that fits the schema; findings go into `found`."""
    return _Resolver(spec, found).run()
