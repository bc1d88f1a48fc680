"""Rows of field tables, and byte maps."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from sbgcgen.model import Field, Layout, Leaf, Message, Struct
from sbgcgen.oracle.codec import CodecError
from sbgcgen.oracle.frames import choose_message, forms_of


@dataclass(frozen=True)
class Row:
    """A row of a field table: a field with all its leaves, or a group of fields.

    `path` has a * for each axis and [] for each index; `leaves` is empty for a group. Rows of
    fields in a tagged union have `is_case`.
    """

    path: str
    depth: int
    field: Field
    leaves: tuple[Leaf, ...]
    is_case: bool = False

    @property
    def name(self) -> str:
        return self.path.rpartition(".")[2] if self.depth else self.path

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
    return list(_rows(message.fields, "", 0, message.leaves))


def _rows(
    fields: Iterable[Field], path: str, depth: int, leaves: tuple[Leaf, ...]
) -> Iterator[Row]:
    for member in fields:
        name = path + member.name + _indices(member)
        if isinstance(member.type, Struct) and not member.type.is_region:
            yield Row(name, depth, member, ())
            yield from _rows(member.type.fields, f"{name}.", depth + 1, leaves)
            continue
        found = tuple(leaf for leaf in leaves if leaf.field is member and _fits(name, leaf.path))
        yield Row(name, depth, member, found)
        if isinstance(member.type, Struct):
            for inner in member.type.fields[:-1]:
                cases = [case for leaf in found for case in leaf.cases if case.field is inner]
                yield Row(f"{name}.{inner.name}", depth + 1, inner, tuple(cases), True)


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


@dataclass(frozen=True)
class Block:
    """A piece of a byte map: a leaf, or part of one, in one row of eight bytes.

    `start` and `end` are columns; `first` and `last` are true if the leaf begins or ends here.
    """

    leaf: Leaf
    number: int
    start: int
    end: int
    first: bool
    last: bool


def byte_map(message: Message) -> tuple[list[list[Block]], list[Leaf]]:
    """The bytes with a fixed place in rows of eight, and the leaves without one."""
    lines: list[list[Block]] = []
    rest: list[Leaf] = []
    number = -1
    previous: Field | None = None
    for leaf in message.leaves:
        size = leaf.size
        if leaf.offset is None or size is None or leaf.field.is_variable or "[]" in leaf.path:
            rest.append(leaf)
            continue
        number += leaf.field is not previous or leaf.field.dim == "one"
        previous = leaf.field
        at, end = leaf.offset, leaf.offset + size
        while at < end:
            stop = min(end, at - at % 8 + 8)
            while len(lines) <= at // 8:
                lines.append([])
            start = at % 8
            block = Block(leaf, number, start, start + stop - at, at == leaf.offset, stop == end)
            lines[at // 8].append(block)
            at = stop
    return lines, rest


def sizes_of(message: Message, layout: Layout) -> str:
    """The body sizes that select this form of the command: "13", "16 to 255"."""
    forms = forms_of(layout)
    taken = []
    for size in range(layout.max_body + 1):
        try:
            if choose_message(forms, message.direction, message.id, size).name == message.name:
                taken.append(size)
        except CodecError:
            pass
    runs: list[list[int]] = []
    for size in taken:
        if runs and runs[-1][-1] == size - 1:
            runs[-1].append(size)
        else:
            runs.append([size])
    words = [str(run[0]) if len(run) == 1 else f"{run[0]} to {run[-1]}" for run in runs]
    return ", ".join(words)
