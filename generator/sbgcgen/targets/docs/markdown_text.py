"""Filters of the Markdown templates: escaping, anchors, byte maps and bit maps."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache

from sbgcgen.model import EnumValue, Message, Packed

# Bytes in a row of a byte map, and characters per byte.
_ROW = 16
_CELL = 4
# Columns of a bit map; a wider one is left out, because the list of parts has its content.
_WIDEST = 240


def escape(text: str) -> str:
    """Escape text for a paragraph or a table cell."""
    return " ".join(text.split()).translate(_ESCAPED)


_ESCAPED = str.maketrans(
    {"&": "&amp;", "<": "&lt;", ">": "&gt;", **{mark: f"\\{mark}" for mark in r"\`*_{}[]|~#"}}
)


def code(text: str) -> str:
    """Format text as code, also for a table cell."""
    fence = "``" if "`" in text else "`"
    return f"{fence}{text}{fence}".replace("|", "\\|") if text else ""


@cache
def anchor(title: str) -> str:
    """The anchor that GitHub gives a heading."""
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


@dataclass(frozen=True)
class _Cell:
    """Bytes of one leaf in a row of a byte map."""

    start: int
    end: int
    label: str
    is_first: bool
    is_last: bool


def byte_map(message: Message) -> str:
    """Draw the bytes of a body, with the numbers of the leaves, which count from 1.

    Of the rows that one leaf fills after its first row, only the last is drawn. The map ends before
    the first leaf without a fixed place.
    """
    spans = []
    for number, leaf in enumerate(message.leaves, 1):
        size = leaf.size
        if leaf.offset is None or size is None or leaf.field.may_be_absent:
            break
        spans.append((leaf.offset, leaf.offset + size, str(number)))
    is_whole = len(spans) == len(message.leaves)
    if not spans:
        return ""
    width = min(_ROW, spans[-1][1])
    head = "".join(f"{byte:>{_CELL}}" for byte in range(width))
    lines = [f"     {head}"]
    last: list[_Cell] = []
    skipped = False
    for row in range(0, spans[-1][1], _ROW):
        cells = list(_cells(spans, row))
        is_end = row + _ROW >= spans[-1][1]
        if last and cells[0].label == last[-1].label and len(cells) == 1 and not is_end:
            if not skipped:
                lines.append(_rule(last, cells))
                lines.append("     :" + " " * (_ROW * _CELL - 1) + ":")
            skipped = True
            continue
        lines.append(_rule(last, cells))
        lines.append(f"{row:>4} " + _row(cells, is_end and not is_whole))
        last = cells
        skipped = False
    lines.append(_rule(last, []))
    return "\n".join(line.rstrip() for line in lines)


def _cells(spans: list[tuple[int, int, str]], row: int) -> Iterator[_Cell]:
    for start, end, label in spans:
        if start < row + _ROW and end > row and end > start:
            inside = max(start, row) - row, min(end, row + _ROW) - row
            yield _Cell(*inside, label, start >= row, end <= row + _ROW)


def _row(cells: list[_Cell], is_open: bool) -> str:
    text = ""
    for cell in cells:
        width = (cell.end - cell.start) * _CELL - 1
        text += "|" + cell.label.center(width) if cell.is_first else "<" + " " * width
    return text + ("| ..." if is_open else "|" if cells[-1].is_last else ">")


def _rule(above: list[_Cell], below: list[_Cell]) -> str:
    """The line between two rows of cells, with a corner at each end of a cell."""
    line = [" "] * (_ROW * _CELL + 1)
    cells = (*above, *below)
    for cell in cells:
        begin, end = cell.start * _CELL, cell.end * _CELL
        line[begin:end] = "-" * (end - begin)
    for cell in cells:
        line[cell.start * _CELL] = line[cell.end * _CELL] = "+"
    return "     " + "".join(line)


def bit_map(packed: Packed) -> str:
    """Draw the bits of a packed integer, the highest first; "" for decimal digits and many bits."""
    parts = [part for part in packed.parts if not part.is_digits]
    if not parts:
        return ""
    bits = 8 * packed.scalar.size
    owners = [
        next((part.name for part in parts if part.bits >> bit & 1), "") for bit in range(bits)
    ]
    runs: list[tuple[str, int]] = []
    for owner in reversed(owners):
        if runs and runs[-1][0] == owner:
            runs[-1] = (owner, runs[-1][1] + 1)
        else:
            runs.append((owner, 1))
    cell = max(_CELL, *(-(-(len(name) + 3) // count) for name, count in runs))
    if cell * bits > _WIDEST:
        return ""
    rule = "+" + "+".join("-" * (cell * count - 1) for _, count in runs) + "+"
    names = "|" + "|".join(name.center(cell * count - 1) for name, count in runs) + "|"
    head = "".join(f"{bit:>{cell}}" for bit in reversed(range(bits)))
    return "\n".join(line.rstrip() for line in (head, rule, names, rule))


def bits_of(mask: int) -> str:
    """The bits of a mask in words: "bit 7", "bits 0 to 3", "bits 0, 2"."""
    bits = [bit for bit in range(mask.bit_length()) if mask >> bit & 1]
    if len(bits) == 1:
        return f"bit {bits[0]}"
    if bits[-1] - bits[0] + 1 == len(bits):
        return f"bits {bits[0]} to {bits[-1]}"
    return "bits " + ", ".join(map(str, bits))


def listed(values: Sequence[str], last: str = "or") -> str:
    """Join values in words: "A, B or C"."""
    if len(values) < 2:
        return "".join(values)
    return ", ".join(values[:-1]) + f" {last} {values[-1]}"


def name_or_number(value: EnumValue | int) -> str:
    """The name of a value, or a number without a name."""
    return str(value) if isinstance(value, int) else value.name


def short(value: Fraction) -> str:
    """A number with at most six digits: 0.0219727, 100."""
    return f"{float(value):.6g}"


def spaced(data: bytes) -> str:
    """Bytes in hex: 3E 44 00."""
    return data.hex(" ").upper()


FILTERS: dict[str, Callable[..., str]] = {
    "md": escape,
    "code": code,
    "anchor": anchor,
    "byte_map": byte_map,
    "bit_map": bit_map,
    "bits": bits_of,
    "listed": listed,
    "name_or_number": name_or_number,
    "short": short,
    "spaced": spaced,
}
