"""Reads the keys that entries of all sections share: summary, source, errata, versions, name."""

from __future__ import annotations

from typing import Any

from sbgcgen.model import Alias, Availability, Deprecation, Identifier, Position
from sbgcgen.model.names import is_name, snake_case
from sbgcgen.spec.diagnostics import Diagnostics, did_you_mean
from sbgcgen.spec.load import Map, Spec
from sbgcgen.spec.resolve.versions import KINDS, VersionReader


class Entries:
    """Reads common keys of entries; findings go into `found`."""

    def __init__(self, spec: Spec, found: Diagnostics) -> None:
        self.spec = spec
        self.found = found
        self.versions = VersionReader(spec.main.get("versions", Map()), found)
        self.identifiers: list[Identifier] = []
        self.features = [
            name
            for _, flags, node, _ in spec.entries("flags")
            for name in (node["values"] if flags in spec.main.get("features", ()) else ())
        ]

    def errata(self, node: Map) -> tuple[str, ...]:
        """The errata numbers of a node; reports those that do not exist."""
        known = self.spec.errata.get("errata", {})
        for number, at in node.listed("errata"):
            if number not in known:
                hint = did_you_mean(str(number), known) or "add it to spec/errata.yaml"
                self.found.add(at, "SBGC023", f"there is no erratum {number}", hint)
        return tuple(str(number) for number, _ in node.listed("errata"))

    def availability(self, node: Map, key: str = "since") -> Availability:
        """The versions under `key`, as numbers on the wire and as text."""
        since = node.get(key)
        if not isinstance(since, Map):
            return Availability()
        said: dict[str, Any] = {}
        for kind in KINDS:
            if kind in since:
                text = str(since[kind])
                said[kind] = self.versions.version(kind, text, since.at(kind))
                said[f"{kind}_text"] = text
        return Availability(**said)

    def needs(self, node: Map) -> str:
        """The board feature under `needs`; reports one that does not exist."""
        name = str(node.get("needs", ""))
        if name and name not in self.features:
            hint = did_you_mean(name, self.features) or "name a flag of the sets under 'features'"
            self.found.add(node.at("needs"), "SBGC010", f"there is no feature '{name}'", hint)
            return ""
        return name

    def deprecation(self, node: Map) -> Deprecation | None:
        """The value of `deprecated` and `replaced_by`; None if not deprecated."""
        mark = node.get("deprecated")
        if not mark:
            return None
        since = self.availability(mark) if isinstance(mark, Map) else Availability()
        return Deprecation(since, str(node.get("replaced_by", "")))

    def summary(self, node: Map, at: Position, what: str) -> str:
        """The summary; reports a missing one."""
        text = " ".join(str(node.get("summary") or "").split())
        if not text:
            self.found.add(at, "SBGC019", f"{what} has no summary", "describe it in one sentence")
        return text

    def source(self, node: Map, at: Position, what: str) -> str:
        """The source in the specification; reports a missing one."""
        text = str(node.get("source") or "")
        if not text:
            hint = "name the section and lines, as in 'Variables L1005-L1009'"
            self.found.add(at, "SBGC020", f"{what} has no source", hint)
        return text

    def aliases(self, node: Map, prefix: str = "") -> tuple[Alias, ...]:
        """The former names, with their identifiers."""
        at = node.at("was")
        return tuple(
            Alias(self.identifier(snake_case(str(name).removeprefix(prefix)), at), at, str(name))
            for name, _ in node.listed("was")
        )

    def identifier(self, name: str, at: Position) -> str:
        """Returns `name`; reports one that is not a valid identifier."""
        self.identifiers.append(Identifier(name, at))
        if not is_name(name):
            message = f"'{name}' cannot be a name"
            self.found.add(at, "SBGC022", message, "give another one with 'as'")
        return name
