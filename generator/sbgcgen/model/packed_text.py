"""Formats and parses packed integers by their display text."""

from __future__ import annotations

import re

from sbgcgen.model.values import Packed, Part

_PART = re.compile(r"\{(\w+)(?::0([0-9]+))?\}")
_GROUP = re.compile(r"\[([^]]*)\]")


def part_of(part: Part, raw: int) -> int:
    """The value of a part of a packed integer."""
    number = ((raw & part.mask) >> part.shift) // part.divide
    if part.signed and number > part.limits[1]:
        return number - (part.mask >> part.shift) - 1
    if part.sign & raw:
        return -number
    return number % part.modulo if part.modulo else number


def text_of(packed: Packed, raw: int) -> str:
    """The display text with the values of the parts; a bracketed group of zeros is omitted."""
    values = {part.name: part_of(part, raw) for part in packed.parts}

    def group(match: re.Match[str]) -> str:
        is_zero = not any(values[name] for name, _ in _PART.findall(match[1]))
        return "" if is_zero else match[1]

    return _GROUP.sub(group, packed.display_of(raw)).format(**values)


def raw_of(packed: Packed, text: str) -> int | None:
    """The integer with this display text; None if there is none."""
    for display in (packed.display, packed.later_display):
        match = re.fullmatch(_pattern(display), text)
        if match is None:
            continue
        raw = 0
        for part in packed.parts:
            number = int(match.groupdict().get(part.name) or 0)
            raw += number * part.divide << part.shift
        if raw < 1 << 8 * packed.scalar.size and text_of(packed, raw) == text:
            return raw
    return None


def _pattern(display: str) -> str:
    """A regular expression that matches the display text, with a group for each part."""
    outside = _GROUP.split(display)  # every second piece was in brackets
    return "".join(
        f"(?:{_literal(text)})?" if number % 2 else _literal(text)
        for number, text in enumerate(outside)
    )


def _literal(text: str) -> str:
    """Like `_pattern`, for a text without brackets."""
    pieces = _PART.split(text)
    result = re.escape(pieces[0])
    for name, digits, literal in zip(pieces[1::3], pieces[2::3], pieces[3::3]):
        result += f"(?P<{name}>[0-9]{{{digits or 1},}})" + re.escape(literal)
    return result
