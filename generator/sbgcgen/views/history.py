"""Finds the revision of the specification that added something."""

from __future__ import annotations

import re

from sbgcgen.model import Layout, Message, Revision


class Revisions:
    """An index of the additions of all revisions."""

    def __init__(self, layout: Layout) -> None:
        self._of = {
            (addition.kind, addition.owner, addition.name): revision
            for revision in layout.revisions
            for addition in revision.adds
        }
        self._same = {m.name: m.same_as for m in layout.messages if m.same_as}

    def of(self, kind: str, owner: str, name: str) -> Revision | None:
        """The revision that added something; for a field, also the one that added its group.

        A message with the body of another has the fields of that message.
        """
        owner = self._same.get(owner, owner) if kind == "field" else owner
        name = re.sub(r"\[\d*\]", "", name) if kind == "field" else name
        found = self._of.get((kind, owner, name))
        while found is None and kind == "field" and "." in name:
            name = name.rpartition(".")[0]
            found = self._of.get((kind, owner, name))
        return found

    def of_message(self, message: Message) -> Revision | None:
        """The revision that added a message, or else its command."""
        return self.of("message", "", message.name) or self.of("command", "", message.command)
