"""Converts the protocol's names to identifiers, and parses field names with dimensions."""

from __future__ import annotations

import re
from dataclasses import dataclass

_FIELD = re.compile(
    r"(?P<head>[A-Za-z][A-Za-z0-9_]*?|(?=\{[A-Z]))"
    r"(?P<expand>\{(?P<kind>[A-Z]+|[0-9]+\.\.[0-9]+)\})?"
    r"(?P<rest>[A-Za-z0-9_]*)"
    r"(?P<array>\[(?P<index>[A-Za-z0-9_.]*)\])?\Z"
)


@dataclass(frozen=True)
class FieldName:
    """A parsed field name.

    `spec_name` keeps a placeholder ("SPEED_{AXIS}") where the protocol has one name per element.
    `expand` is the text in braces, `index` the text in brackets; None without them.
    """

    base: str
    spec_name: str
    expand: str | None
    index: str | None


def parse_field_name(text: str) -> FieldName | None:
    """Parses NAME, NAME[axis], NAME[6], NAME[COUNT], NAME[], NAME_{AXIS}, {AXIS}_NAME or NAME{1..5}_MORE."""
    match = _FIELD.match(text)
    if match is None or (match["expand"] and match["array"]):
        return None
    base = (match["head"] + match["rest"]).replace("__", "_").strip("_")
    if not base[:1].isalpha():
        return None
    spec_name = match["head"] + ("{" + match["kind"] + "}" if match["expand"] else "")
    return FieldName(base, spec_name + match["rest"], match["kind"], match["index"])


_FOREIGN = re.compile(r"(?P<sign>u?)int(?P<bits>8|16|32)(_t)?\Z|(?P<size>[124])(?P<kind>[usf])\Z")


def type_advice(text: str) -> str:
    """Advice for a type in C notation or in that of the specification; "" if there is none."""
    array = re.match(r"(\w+)\[(.*)\]\Z", text)
    if array and array[1] not in ("bytes", "text"):
        return f"the count belongs to the name: 'NAME[{array[2]}]' with type: {array[1]}"
    match = _FOREIGN.match(text)
    if match and match["bits"]:
        return f"write {'u' if match['sign'] else 'i'}{match['bits']}"
    if match:
        kind = {"u": "u", "s": "i", "f": "f"}[match["kind"]]
        return f"write {kind}{8 * int(match['size'])}"
    return {
        "float": "write f32",
        "double": "write f64",
        "char": "write i8 or text[N]",
        "bool": "write u8",
    }.get(text, "")


def snake_case(name: str) -> str:
    """deviceID -> device_id, RC_MIN_ANGLE -> rc_min_angle."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).lower()


def camel_case(name: str) -> str:
    """BOARD_INFO_3 -> BoardInfo3, trigger_slots -> TriggerSlots."""
    return "".join(word.capitalize() for word in name.split("_"))


# The forms of a command that have a special meaning; any other name describes the difference.
KNOWN_FORMS = ("simple", "extended", "success", "error")
_FORM_WORDS = {"simple": "", "success": "", "extended": "ext"}


def form_suffix(form: str | None) -> str:
    """The suffix of a form to the name of its command: simple -> "", extended_wide -> ext_wide."""
    words = [_FORM_WORDS.get(word, word) for word in (form or "").split("_")]
    return "_".join(word for word in words if word)


def singular(plural: str) -> str:
    """The name of one flag of a set: SystemErrors -> SystemError, Switches -> Switch, Axes -> Axis."""
    if re.search(r"(ch|sh|ss)es\Z", plural):
        return plural[:-2]
    if plural.endswith("Axes"):
        return f"{plural[:-2]}is"
    return plural[:-1] if plural.endswith("s") else f"{plural}Bit"


def slug(name: str) -> str:
    """BoardInfo3Request -> board-info3-request, for use in paths."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "-", name).lower()


def is_name(text: str) -> bool:
    """True if a name consists of letters, digits and underscores and starts with a letter."""
    return re.match(r"[A-Za-z][A-Za-z0-9_]*\Z", text) is not None


def parse_lines(text: str) -> list[tuple[int, int]]:
    """The line ranges in a source: "Variables L1005-L1009, L12" -> [(1005, 1009), (12, 12)]."""
    found = re.findall(r"L([0-9]+)(?:-L([0-9]+))?", text)
    return [(int(first), int(last or first)) for first, last in found]
