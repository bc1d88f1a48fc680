"""The rows of field tables: the fields of a message with their leaves."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from sbgcgen.model import Availability, Field, Leaf, Message, Struct


@dataclass(frozen=True)
class Row:
    """A row of a field table: a field with all its leaves, or a group of fields.

    `path` has a * for each axis and [] for each index; `leaves` is empty for a group. `since` is
    the availability of the field and of the groups around it.
    """

    path: str
    depth: int
    field: Field
    leaves: tuple[Leaf, ...]
    since: Availability

    @property
    def first(self) -> str:
        """The path of the first leaf, or of the group."""
        return self.leaves[0].path if self.leaves else self.path

    @property
    def spec_name(self) -> str:
        """The protocol's name, with {AXIS} or {1..5} if each element has a name."""
        return self.field.spec_name

    def index_of(self, leaf: Leaf) -> str:
        """The index that distinguishes a leaf from the others of its row: "roll", "[2]"."""
        pattern = re.escape(self.path).replace(r"\*", r"(\w+)").replace(r"\[\]", r"\[(\d*)\]")
        match = re.fullmatch(pattern, leaf.path)
        assert match, f"{leaf.path} is not {self.path}"
        words = [f"[{word}]" if word.isdigit() else word for word in match.groups() if word]
        return " ".join(words)


def rows_of(message: Message) -> list[Row]:
    """The rows of a message's field table, in wire order."""
    return list(_rows(message.fields, "", 0, message.leaves, Availability()))


def _rows(
    fields: Iterable[Field], path: str, depth: int, leaves: tuple[Leaf, ...], around: Availability
) -> Iterator[Row]:
    for member in fields:
        name = path + member.name + _indices(member)
        since = around.later(member.since)
        if isinstance(member.type, Struct) and not member.type.is_region:
            yield Row(name, depth, member, (), since)
            yield from _rows(member.type.fields, f"{name}.", depth + 1, leaves, since)
            continue
        found = tuple(leaf for leaf in leaves if leaf.field is member and _fits(name, leaf.path))
        yield Row(name, depth, member, found, since)
        if isinstance(member.type, Struct):
            for inner in member.type.fields[:-1]:
                cases = [case for leaf in found for case in leaf.cases if case.field is inner]
                later = since.later(inner.since)
                path_ = f"{name}.{inner.name}"
                yield Row(path_, depth + 1, inner, tuple(cases), later)


def _indices(member: Field) -> str:
    if member.dim in ("axis", "xyz"):
        return ".*"
    is_list = member.dim in ("fixed", "counted", "rest")
    has_leaves = (
        isinstance(member.type, Struct)
        or bool(member.index)
        or (member.dim == "fixed" and member.type.kind in ("text", "bytes", "string"))
    )
    return "[]" if is_list and has_leaves else ""


def _fits(pattern: str, path: str) -> bool:
    return re.sub(r"\[\d+\]", "[]", path) == pattern or bool(
        re.fullmatch(re.escape(pattern).replace(r"\*", r"\w+").replace(r"\[\]", r"\[\d*\]"), path)
    )
