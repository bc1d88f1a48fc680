"""The notation for bodies in the notes on the later protocol.

    NAME TYPE[COUNT]... remark, NAME TYPE, group[3]: {NAME TYPE, ...}, repeated {NAME TYPE, ...}

`?3 NAME TYPE` is present if bit 3 of the flags is set, `?1+2 NAME TYPE` if both are. Remarks may have a unit, a range and versions.
"""

from __future__ import annotations

import re
from fractions import Fraction
from typing import Any

Fact = dict[str, Any]

TYPE = r"[uif]\d+|bytes|text|string"
FIELD = re.compile(
    rf"(?:\?(?P<bits>\d+(?:\+\d+)*) )?(?P<name>[A-Z][A-Z0-9_]*) (?P<type>{TYPE})\b"
    r"(?P<counts>(?:\[[A-Z0-9_]*\])*)(?P<remark>.*)",
    re.S,
)
GROUP = re.compile(
    r"(?:@(?P<offset>\d+) )?(?P<name>[A-Za-z_]+)(?:\[(?P<count>\d+)\])?[^{}]*?\{(?P<inner>.*)\}\s*(?P<rest>.*)",
    re.S,
)
VERSION = re.compile(r"\b(2\.\d\d)(?:b0\b|\.0\b|[.b](\d+))?(?![\d])")
RANGE = re.compile(r"(?<![\w.+-])(-?\d+)\.\.(-?\d+)(?![\w.])")
UNIT = re.compile(
    r"(?<![\w.])(?P<scale>\d+(?:\.\d+)?(?:/\d+)?)? ?"
    r"(?<![\w/])(?P<unit>deg/s\^2|deg/s|degC|deg|rad/s|urad/s|rad|rpm|ms|mA|mV|Ohm|W\*h|Hz|dB|A14|A20|HR"
    r"|%|s|A|V|g|G|S)(?![\w/^*])"
)
# Words for a scale with its unit, and units of the notes in those of the spec.
WORDS = {
    "A14": (Fraction(360, 1 << 14), "deg"),
    "A20": (Fraction(360, 1 << 20), "deg"),
    "S": (Fraction(4000, 32767), "deg/s"),
    "G": (Fraction(2000, 32767), "deg/s"),
    "HR": (Fraction(1, 1000), "deg/s"),
    "s": (Fraction(1000), "ms"),
    "A": (Fraction(1000), "mA"),
    "mV": (Fraction(1, 1000), "V"),
    "urad/s": (Fraction(1, 1_000_000), "rad/s"),
    "Ohm": (Fraction(1), "ohm"),
    "W*h": (Fraction(1), "Wh"),
}


def version_of(text: str) -> str | None:
    """Returns the first version in the text, in the notation of the spec."""
    match = VERSION.search(text)
    if match is None:
        return None
    return match[1] + (f"b{match[2]}" if match[2] and match[2] != "0" else "")


def note_version(remark: str) -> str | None:
    """Returns the version in parentheses that a remark states: '(fw 2.70b1)', '(off; 2.66)'."""
    match = re.search(r"[(;] ?(?:fw )?(2\.\d\d(?:b\d+|\.\d+)?)[;)]", remark)
    return version_of(match[1]) if match else None


def split(text: str, at: str) -> list[str]:
    """Splits a text at a character that is in no brackets."""
    parts, depth, start = [], 0, 0
    for i, char in enumerate(text):
        depth += (char in "([{") - (char in ")]}")
        if char in at and depth == 0:
            parts.append(text[start:i])
            start = i + 1
    return [part.strip() for part in [*parts, text[start:]] if part.strip()]


def remark_facts(remark: str) -> Fact:
    """Returns the unit, the range and the version that a remark states."""
    facts: Fact = {}
    open_ = remark
    while "(" in open_:  # parentheses hold values, which have no unit
        shorter = re.sub(r"\([^()]*\)?", " ", open_)
        open_ = shorter if shorter != open_ else open_.replace("(", " ")
    unit = UNIT.search(open_)
    if unit:
        scale, name = WORDS.get(unit["unit"], (Fraction(1), unit["unit"]))
        facts["unit"] = [str(scale * Fraction(unit["scale"] or 1)), name]
    factor = re.match(r" (0\.\d+)\s*(?:$|\()", remark)
    if factor and not unit:
        facts["unit"] = [str(Fraction(factor[1])), None]
    limits = RANGE.search(open_)
    if limits:
        facts["range"] = [int(limits[1]), int(limits[2])]
    since = note_version(remark)
    if since:
        facts["since"] = since
    return facts


def parse_field(text: str, line: int) -> Fact | None:
    """Returns a field or a group, or None if the text is neither."""
    match = FIELD.fullmatch(text)
    if match is None:
        return _parse_group(text, line)
    counts = re.findall(r"\[([A-Z0-9_]*)\]", match["counts"])
    count: Any = 1
    for number in counts:
        count = count * int(number) if number.isdigit() and count is not None else None
    remark = match["remark"]
    if re.search(r"\brepeated\b|for each set bit", remark):
        count = None
    field: Fact = {"name": match["name"], "type": match["type"], "count": count}
    if match["bits"]:
        field["mask"] = sum(1 << int(bit) for bit in match["bits"].split("+"))
    return {**field, **remark_facts(remark), "line": line}


def _parse_group(text: str, line: int) -> Fact | None:
    match = GROUP.fullmatch(text)
    if match is None or re.sub(r"\(.*?\)", "", match["rest"]).strip():
        return None
    fields = parse_fields(match["inner"], line)
    if fields is None:
        return None
    count = int(match["count"]) if match["count"] else None
    return {"group": match["name"], "count": count, "fields": fields, "line": line}


def parse_fields(text: str, line: int) -> list[Fact] | None:
    """Returns the fields of a list, or None if one of them is not in the notation."""
    found: list[Fact] = []
    for part in split(text, ",;"):
        field = parse_field(part, line)
        if field is None:
            return None
        if found and f"bytes[{found[-1].get('name')}]" in part:
            field["type"] = "string"  # a length, then that many characters
            found.pop()
        found.append(field)
    return found


NUMBERED = re.compile(
    r"(?P<first>\d+)(?:\.\.(?P<last>\d+))? =? ?(?P<name>[A-Za-z0-9][\w/*]*)(?:\.\.(?P<end>\d+))?(?P<rest>.*)",
    re.S,
)


def parse_values(text: str, line: int) -> list[Fact]:
    """Returns the named numbers of a list such as '3 ONE, 4..6 TWO_ROLL/PITCH/YAW, 7..8 THREE1..2'."""
    found: list[Fact] = []
    for part in split(text, ",;"):
        match = NUMBERED.match(part.strip())
        if match is None:
            continue
        first = int(match["first"])
        last = int(match["last"] or first)
        names = _names(match["name"], last - first + 1)
        if names is None:
            continue
        since = note_version(match["rest"])
        for number, name in zip(range(first, last + 1), names):
            fact: Fact = {"value": number, "name": name, "line": line}
            found.append({**fact, "since": since} if since else fact)
    return found


def _names(name: str, count: int) -> list[str] | None:
    """Returns `count` names for NAME_A/B/C, NAME_* (an axis each) or NAME1 (counted up)."""
    if name.endswith("*"):
        return [name[:-1] + axis for axis in ("ROLL", "PITCH", "YAW")] if count == 3 else None
    if "/" in name:
        first, *others = name.split("/")
        stem = first[: first.rfind("_") + 1]
        end = others[-1].find("_")  # of MOT_ROLL/PITCH/YAW_DISABLED, that ends all
        suffix = others[-1][end:] if end > 0 else ""
        names = [first + suffix, *(stem + other + suffix for other in others[:-1])]
        names.append(stem + others[-1])
        return names if len(names) == count else None
    if count == 1:
        return [name]
    counted = re.fullmatch(r"(.*?)(\d+)", name)
    if counted is None:
        return None
    return [f"{counted[1]}{int(counted[2]) + i}" for i in range(count)]
