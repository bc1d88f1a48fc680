"""Texts for values of the model: the Jinja filters and tests of all targets."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from fractions import Fraction
from typing import Any

from sbgcgen.model import Announced, Availability, AxisDirection, Blob, Enum, Field, Leaf, Message
from sbgcgen.model import Packed, Quantity, Scalar, StopValue, Struct, field_rules, scalar_of
from sbgcgen.model.names import slug
from sbgcgen.model.export import export
from sbgcgen.views.framing import crc_text, frame_parts, sums_in


def to_json(value: dict[str, Any]) -> str:
    """An object as JSON, in insertion order: one line for each member, and for each object of a list,
    so that differences are readable. Other nested values of such an object stay on its line.
    """
    members = [f"  {_quoted(name)}: {_rows(item, '  ')}" for name, item in value.items()]
    return "{\n" + ",\n".join(members) + "\n}"


def _rows(value: Any, indent: str) -> str:
    if not _is_rows(value):
        return _quoted(value)
    inner = indent + "  "
    return "[\n" + ",\n".join(inner + _row(item, inner) for item in value) + f"\n{indent}]"


def _row(value: dict[str, Any], indent: str) -> str:
    inner = indent + "  "
    starts = [f"\n{inner}" if _is_rows(item) else " " for item in value.values()]
    members = [f"{_quoted(name)}: {_rows(item, inner)}" for name, item in value.items()]
    text = ",".join(start + member for start, member in zip(starts, members))
    return "{" + text.removeprefix(" ") + "}"


def _is_rows(value: Any) -> bool:
    return isinstance(value, (list, tuple)) and bool(value) and isinstance(value[0], dict)


_quoted = json.JSONEncoder(ensure_ascii=False).encode


def number(value: Fraction) -> str:
    """A decimal number with the precision of a double: 255, -0.5."""
    is_exact = value.denominator == 1 and abs(value.numerator) <= 1 << 53
    return str(value.numerator) if is_exact else repr(float(value))


def versions(since: Availability) -> str:
    """'firmware 2.59, board 3.0', or ''."""
    return ", ".join(f"{kind} {text}" for kind, text in since.words)


def stop_text(message: Message) -> str:
    """The stop condition of a request: "Stops all motion if `cmd_id` is `MOTOR_OFF`."; or ""."""
    if not message.stops:
        return ""
    patterns = [" and ".join(map(_stop_value, pattern)) for pattern in message.stops]
    when = "; or if ".join(patterns)
    return f"Stops all motion{f' if {when}' if when else ''}."


def _stop_value(value: StopValue) -> str:
    if not isinstance(value.type, Packed):
        return f"`{value.path}` is {_name(value.type, value.value)}"
    parts = [part for part in value.type.parts if not value.mask or part.mask & value.mask]
    numbers = [(value.value & part.mask) >> part.shift for part in parts]
    return " and ".join(
        f"`{value.path}.{part.name}` is {_name(part.enum, number)}"
        for part, number in zip(parts, numbers)
    )


def _name(type_: Any, number: Any) -> str:
    """The name of an enum value, or else the number."""
    values = type_.values if isinstance(type_, Enum) else ()
    return next((f"`{v.name}`" for v in values if v.value == number), f"{number:g}")


def hexadecimal(value: int, digits: int = 2) -> str:
    """0x3E."""
    return f"0x{value:0{digits}X}"


def body_size(message: Message) -> str:
    """The size of a body: "1 byte", "0 or 1 byte", "2 to 9 bytes"."""
    low, high = message.min_size, message.max_size
    if low == high:
        return f"{high} byte{'s' if high != 1 else ''}"
    return "0 or 1 byte" if high == 1 else f"{low} to {high} bytes"


def narrow_range(field: Field) -> str:
    """The range of a field in its unit, if it is narrower than that of its type: '-90 to 90 deg'."""
    scalar = scalar_of(field.type)
    if field.constant or field.minimum is None or field.maximum is None or scalar is None:
        return ""
    if field.minimum == scalar.minimum and field.maximum == scalar.maximum:
        return ""
    limits = [field.minimum, field.maximum]
    unit = ""
    if isinstance(field.type, Quantity):
        limits = [field.type.real(limit) for limit in limits]
        unit = f" {field.type.unit}" if field.type.unit else ""
    return " to ".join(f"{float(limit):.6g}" for limit in limits) + unit


def default_words(field: Field) -> list[str]:
    """The value of a field in a new message: a number, or the names of an enum value or of flags."""
    type_ = field.type
    if not isinstance(type_, Enum):
        return [str(field.default)]
    if type_.kind == "enum":
        return [v.name for v in type_.values if v.value == field.default] or [str(field.default)]
    named = [v for v in type_.values if v.value and v.value & field.default == v.value]
    rest = field.default - sum(v.value for v in named)
    return [*(v.name for v in named), *([str(rest)] if rest else [])]


def rules_in(body: Struct) -> list[str]:
    """The rules across fields of a body, such as "min <= max"."""
    return [rule.text(path) for path, rule in field_rules(body)]


def title_of(name: str) -> str:
    """adjustable_variables -> Adjustable variables; a short name is an abbreviation: imu -> IMU."""
    return name.upper() if len(name) <= 3 else name.replace("_", " ").capitalize()


def positive_text(leaves: Iterable[Leaf]) -> str:
    """The sign convention of leaves: "down", or "pitch down, yaw right, roll unknown"."""
    words = {leaf.direction: _positive(leaf.direction) for leaf in leaves}
    if len(words) <= 1:
        return "".join(words.values())
    named = sorted(words, key=lambda direction: words[direction] == _positive(None))
    return ", ".join(f"{d.axis.lower()} {words[d]}" for d in named if d)


def _positive(direction: AxisDirection | None) -> str:
    return (direction and direction.positive) or "unknown"


def directions_text(directions: Iterable[AxisDirection]) -> str:
    """A sentence: "Positive pitch is down and negative up; for roll it is not known."."""
    known, unknown = [], []
    for direction in directions:
        axis = direction.axis.lower()
        if direction.positive is None:
            unknown.append(axis)
        else:
            known.append(f"positive {axis} is {direction.positive}, negative {direction.negative}")
    if unknown:
        known.append(f"for {' and '.join(unknown)} it is not known")
    return "; ".join(known).capitalize() + "." if known else ""


FILTERS: dict[str, Callable[..., Any]] = {
    "crc_text": crc_text,
    "frame_parts": frame_parts,
    "sums_in": sums_in,
    "export": export,
    "to_json": to_json,
    "number": number,
    "versions": versions,
    "stop_text": stop_text,
    "hex": hexadecimal,
    "slug": slug,
    "title_of": title_of,
    "body_size": body_size,
    "default_words": default_words,
    "narrow_range": narrow_range,
    "rules_in": rules_in,
    "positive_text": positive_text,
    "directions_text": directions_text,
}

TESTS: dict[str, Callable[..., bool]] = {
    "a_scalar": lambda t: isinstance(t, Scalar),
    "a_quantity": lambda t: isinstance(t, Quantity),
    "an_enum": lambda t: isinstance(t, Enum) and t.kind == "enum",
    "a_flag_set": lambda t: isinstance(t, Enum) and t.kind == "flags",
    "a_packed": lambda t: isinstance(t, Packed),
    "a_blob": lambda t: isinstance(t, Blob),
    "in_region": lambda f: isinstance(f.type, Struct) and f.type.is_region,
    "announced": lambda t: isinstance(t, Announced),
    "a_region": lambda t: isinstance(t, Struct) and t.is_region,
    "a_struct": lambda t: isinstance(t, Struct),
}
