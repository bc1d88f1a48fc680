"""Byte maps, and the sizes of a form."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import groupby

from sbgcgen.model import Field, Layout, Leaf, Message
from sbgcgen.oracle.codec import CodecError
from sbgcgen.oracle.frames import choose_message


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
    """The bytes with a fixed position in rows of eight, and the leaves without one."""
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

    def selects(size: int) -> bool:
        try:
            chosen = choose_message(layout.messages_by_id, message.direction, message.id, size)
        except CodecError:
            return False
        return chosen.name == message.name

    groups = groupby(range(layout.max_body + 1), selects)
    runs = [list(sizes) for is_selected, sizes in groups if is_selected]
    return ", ".join(str(r[0]) if len(r) == 1 else f"{r[0]} to {r[-1]}" for r in runs)
