"""Resolves the revision history of the specification."""

from __future__ import annotations

import re
from collections.abc import Iterator

from sbgcgen.model import Addition, Command, Enum, Message, Position, Revision
from sbgcgen.spec.diagnostics import Diagnostics, did_you_mean
from sbgcgen.spec.load import Spec


class RevisionResolver:
    """Resolves `revisions` of the main file; findings go into `found`."""

    def __init__(
        self,
        commands: list[Command],
        messages: list[Message],
        enums: list[Enum],
        found: Diagnostics,
    ) -> None:
        self.found = found
        self.known: dict[str, Addition] = {}
        for message in messages:
            for path in _paths(message):
                self._knows("field", message.name, path)
            self._knows("message", "", message.name)
        for enum in enums:
            for value in enum.values:
                self._knows("value", enum.name, value.name)
        for command in commands:
            self._knows("command", "", command.name)

    def _knows(self, kind: str, owner: str, name: str) -> None:
        addition = Addition(kind, owner, name)
        self.known[addition.text] = addition

    def revisions(self, spec: Spec) -> Iterator[Revision]:
        """All revisions, the oldest first."""
        nodes = spec.main.get("revisions", {})
        for number, node in nodes.items():
            found = [self._addition(str(name), at) for name, at in node.listed("adds")]
            yield Revision(
                number=number,
                date=str(node["date"]),
                source=str(node["source"]),
                adds=tuple(addition for addition in found if addition is not None),
                changes=tuple(" ".join(str(text).split()) for text in node.get("changes", ())),
                at=nodes.at(number),
            )

    def _addition(self, text: str, at: Position) -> Addition | None:
        if text not in self.known:
            hint = "the name of a command, Message, Message.path or Enum.VALUE"
            hint = did_you_mean(text, self.known) or hint
            self.found.add(at, "SBGC021", f"a revision adds '{text}', which does not exist", hint)
        return self.known.get(text)


def _paths(message: Message) -> Iterator[str]:
    """The paths of a message's fields and groups, without indices."""
    for leaf in message.leaves:
        for inner in (leaf, *leaf.cases):
            words = re.sub(r"\[\d*\]", "", inner.path).split(".")
            for count in range(1, len(words) + 1):
                yield ".".join(words[:count])
