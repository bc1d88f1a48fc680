"""Filters for the templates of C++."""

from __future__ import annotations

import json
import textwrap
from collections.abc import Callable, Iterable
from typing import Any

from sbgcgen.model import Field, Message, Quantity, Scalar, constants, copy_field, largest_forms
from sbgcgen.targets.cpp.flag_unit import flag_units
from sbgcgen.views.code import unit_name

LINE = 100  # columns


def comment(text: str, indent: int = 0, width: int = LINE, mark: str = "/// ") -> str:
    """Text as comment lines, wrapped; the first line is not indented."""
    text = " ".join(text.replace("??", "? ?").split())
    room = width - indent - len(mark)
    # Most texts fit on one line, and wrap() is slow.
    lines = [text] if len(text) <= room else textwrap.wrap(text, room)
    # A backslash at the end of a line would make the next one part of the comment.
    lines = [f"{line} ." if line.endswith("\\") else line for line in lines]
    return f"\n{' ' * indent}".join((mark + line).rstrip() for line in lines)


def documented(code: str, text: str, indent: int) -> str:
    """A declaration with its comment: after it if there is room, else before it."""
    line = f"{code}  ///< {' '.join(text.split())}"
    if indent + len(line) <= LINE and "\\" not in text and "??" not in text:
        return line
    return f"{comment(text, indent)}\n{' ' * indent}{code}"


def c_string(text: str) -> str:
    """Text as a C string literal, without anything that looks like a trigraph."""
    return _quoted(text).replace("??", "?\\?")


_quoted = json.JSONEncoder(ensure_ascii=False).encode


def statement(text: str, indent: int) -> str:
    """A statement on as many lines as it needs, with this indent."""
    first = " " * indent
    text = " ".join(text.split())
    if indent + len(text) <= LINE:
        return first + text
    return textwrap.fill(
        text,
        LINE,
        initial_indent=first,
        subsequent_indent=first + " " * 4,
        break_long_words=False,
        break_on_hyphens=False,
    )


def in_lines(items: str, indent: int) -> str:
    """Items as a comma-separated list, filled into as few lines as possible, with this indent."""
    lines = [""]
    for item in filter(None, items.splitlines()):
        if lines[-1] and indent + len(lines[-1]) + len(item) + 2 > LINE:
            lines.append("")
        lines[-1] += (", " if lines[-1] else "") + item
    return (",\n" + " " * indent).join(lines)


def attribute(message: Message) -> str:
    """The attribute of a message that is deprecated in every firmware.

    Members have none: g++ warns when an object is constructed, even if nothing uses the member.
    """
    mark = message.deprecated
    if mark is None or mark.since:
        return ""
    reason = f"({c_string(f'use {mark.replaced_by}')})" if mark.replaced_by else ""
    return f"[[deprecated{reason}]] "


def units(quantities: Iterable[Quantity]) -> list[Quantity]:
    """The first quantity of each unit."""
    return list({unit_name(q): q for q in reversed(list(quantities))}.values())[::-1]


def later_units(fields: Iterable[Field]) -> list[Field]:
    """The members that are always present, and whose unit changes in later firmware."""
    return [
        f
        for f in fields
        if any(later.type != f.type for later in f.later)
        and all(isinstance(t, (Scalar, Quantity)) for t in (f.type, *(l.type for l in f.later)))
        and not f.may_be_absent
        and f.dim in ("one", "axis", "xyz", "fixed")
    ]


FILTERS: dict[str, Callable[..., Any]] = {
    "comment": comment,
    "c_string": c_string,
    "documented": documented,
    "in_lines": in_lines,
    "statement": statement,
    "unit_name": unit_name,
    "units": units,
    "attribute": attribute,
    "flag_units": flag_units,
    "later_units": later_units,
    "constants": constants,
    "copy_field": copy_field,
    "largest_forms": largest_forms,
    "paired": lambda value, other: (value, other),
    "index_of": lambda values, value: values.index(value),
}
