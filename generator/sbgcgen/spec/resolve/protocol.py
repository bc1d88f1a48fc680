"""Resolves a Spec to the Layout model."""

from __future__ import annotations

from collections.abc import Iterator
from fnmatch import fnmatchcase
from typing import Any

from sbgcgen.model import Command, Enum, Erratum, Family, Layout, Line, Message, Position, Revision
from sbgcgen.model import Topic
from sbgcgen.model.names import snake_case
from sbgcgen.spec.diagnostics import Diagnostics, did_you_mean
from sbgcgen.spec.load import Map, Spec
from sbgcgen.spec.resolve.answers import AnswerResolver
from sbgcgen.spec.resolve.effects import EffectResolver
from sbgcgen.spec.resolve.fields import FieldResolver
from sbgcgen.spec.resolve.framing import framings_of
from sbgcgen.spec.resolve.messages import MessageResolver
from sbgcgen.spec.resolve.revisions import RevisionResolver
from sbgcgen.spec.resolve.types import TypeResolver
from sbgcgen.spec.resolve.variables import VariableResolver


def line_of(node: Any, types: TypeResolver, found: Diagnostics) -> Line:
    """Resolve the value of `line:` in the main file; None if it is absent."""
    if not isinstance(node, Map):
        return Line((), 0, (), 0, 0, "", ())
    named: list[int] = []
    if "baud_rates" in node:
        enum = types.enum_named(str(node["baud_rates"]), node.at("baud_rates"))
        named = [value.number for value in enum.values if value.number] if enum else []
        if enum and not named:
            text = f"no value of {enum.name} has a 'number'"
            found.add(node.at("baud_rates"), "SBGC038", text, f"see {enum.at}")
    for rate in node.get("more_baud_rates", ()):
        if rate in named:
            text = f"{rate} is one of {node['baud_rates']}"
            found.add(node.at("more_baud_rates"), "SBGC038", text, "leave it out")
    low, _, high = str(node["pause_ms"]).partition("..")
    if int(low) > int(high):
        text = "the pause after each command has its limits reversed"
        found.add(node.at("pause_ms"), "SBGC017", text, f"write {high}..{low}")
    return Line(
        baud_rates=(*named, *node.get("more_baud_rates", ())),
        named=len(named),
        parities=tuple(str(parity) for parity in node["parities"]),
        shortest_pause_ms=int(low),
        longest_pause_ms=int(high),
        source=str(node["source"]),
        errata=types.errata(node),
        at=node.position,
    )


def topics_of(nodes: Map, messages: list[Message], found: Diagnostics) -> Iterator[Topic]:
    """Resolve the value of `topics:` in the main file; findings go into `found`."""
    stored = {message.stores for message in messages}
    parameters = {
        leaf.field.spec_name: leaf.field
        for message in messages
        for leaf in (message.leaves if message.name in stored else ())
        if not leaf.field.reserved and leaf.field.role in ("", "general")
    }
    filed: set[str] = set()
    for name, node in nodes.items():
        patterns = node["fields"]
        for pattern, at in node.listed("fields"):
            if not any(fnmatchcase(parameter, pattern) for parameter in parameters):
                hint = did_you_mean(pattern, list(parameters)) or "a * stands for any characters"
                found.add(at, "SBGC080", f"'{pattern}' is the name of no parameter", hint)
        fields = [p for p in parameters if any(fnmatchcase(p, pattern) for pattern in patterns)]
        filed.update(fields)
        words = tuple(str(word) for word in node.get("words", ()))
        changes_line = bool(node.get("changes_line"))
        yield Topic(name, str(node["summary"]), words, tuple(fields), changes_line, nodes.at(name))
    for parameter, field in parameters.items():
        if nodes and parameter not in filed:
            hint = "add its name to one of the 'topics' in the main file"
            found.add(field.at, "SBGC080", f"the parameter {parameter} has no topic", hint)


class _Resolver:
    def __init__(self, spec: Spec, found: Diagnostics) -> None:
        self.spec = spec
        self.found = found
        self.types = TypeResolver(spec, found)
        self.types.run()
        self.framings = framings_of(spec.main["framings"], self.types, found)
        self.fields = FieldResolver(spec, self.types, found, self.framings[0].max_body)
        answers = AnswerResolver(self.fields)
        self.line = line_of(spec.main.get("line"), self.types, found)
        self.commands = [self._command(*entry) for entry in spec.entries("commands")]
        effects = EffectResolver(spec, self.fields.references, found)
        self.messages = MessageResolver(self.fields, answers, effects)

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
        names = self.spec.main.listed("features")
        found = []
        for name, at in names:
            flags = self.types.enum_named(str(name), at)
            if flags is not None and flags.kind != "flags":
                hint = "each feature is a flag that boards report"
                self.found.add(at, "SBGC026", f"{name} is not a flag set", hint)
            elif flags is not None:
                found.append(flags)
        if sum(flags.scalar.size for flags in found) > 8:
            text = "the board features have more than 64 bits"
            self.found.add(names[-1][1], "SBGC017", text, "name smaller flag sets")
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
