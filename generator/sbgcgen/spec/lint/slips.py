"""Rules for valid but unlikely content, and for the spelling of the protocol's own names."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterator
from fractions import Fraction

from sbgcgen.model import COMMAND_IDS, Enum, Field, Layout, Message, Position, Quantity, all_fields
from sbgcgen.spec.diagnostics import Diagnostics
from sbgcgen.spec.load import Map, Spec
from sbgcgen.spec.resolve.types import VARIABLE_ID

# The number of digits of a deliberately chosen limit, as in 1275 or 0.0125.
_DIGITS = 4
# Deliberately chosen limits of angles, in degrees.
_ANGLES = frozenset((0, 45, 90, 180, 270, 360))


def lint_slips(layout: Layout, found: Diagnostics) -> None:
    """Check values that contradict their context; findings go into `found`."""
    for quantity in layout.quantities:
        _check_scale(quantity, found)
    for enum in layout.enums:
        _check_flags(enum, found)
    bodies = [struct.fields for family in layout.families for struct in family.structs]
    bodies += [message.fields for message in layout.messages if not message.same_as]
    for fields in bodies:
        for field in fields:
            _check_range(field, found)
            _check_counter(field, fields, found)
    for message in layout.messages:
        _check_deprecation(message, found)
        for field in all_fields(message.fields):
            if field.later and field.later[0].since.firmware <= message.since.firmware:
                text = (
                    f"'{field.name}' has its later meaning in all firmware that has {message.name}"
                )
                found.add(field.at, "SBGC071", text, "describe the later meaning alone")


def _check_scale(quantity: Quantity, found: Diagnostics) -> None:
    scale = quantity.scale
    if scale.numerator > scale.denominator > 1 and "/" in quantity.scale_text:
        first, _, second = quantity.scale_text.partition("/")
        text = f"the scale of {quantity.name} seems inverted: 1 on the wire is {float(scale):g}"
        hint = (
            f"the real value is raw * scale: write {second}/{first}, or {float(scale):g} if right"
        )
        found.add(quantity.at, "SBGC073", text, hint)


def _check_flags(enum: Enum, found: Diagnostics) -> None:
    for value in enum.values:
        if enum.kind == "flags" and value.value == 0 and not value.errata:
            text = f"{value.name} of {enum.name} has no bit"
            hint = "give it one; an erratum can say that the protocol has a name for no flags"
            found.add(value.at, "SBGC074", text, hint)


def _check_range(field: Field, found: Diagnostics) -> None:
    """A range is in raw values; a range in the unit of the field would have odd limits in that unit."""
    type_, low, high = field.type, field.minimum, field.maximum
    if not isinstance(type_, Quantity) or low is None or high is None or field.constant:
        return
    if type_.scale == 1 or type_.ratio or type_.scalar.is_float:
        return
    own = [
        limit for limit in (low, high) if limit not in (type_.scalar.minimum, type_.scalar.maximum)
    ]
    real = [type_.real(limit) for limit in own]
    is_angle = type_.unit == "deg" and any(own) and _ANGLES.issuperset(map(abs, own))
    if is_angle or not all(_is_chosen(limit) for limit in real):
        unit = f" {type_.unit}" if type_.unit else ""
        ends = [float(type_.real(limit)) for limit in (low, high)]
        text = f"the range of '{field.name}' is {ends[0]:g}..{ends[1]:g}{unit}"
        raw = [round(type_.raw(limit)) for limit in (low, high)]
        hint = f"it is in raw values; {low}..{high}{unit} would be {raw[0]}..{raw[1]}"
        found.add(field.at, "SBGC075", text, hint)


def _is_chosen(limit: Fraction) -> bool:
    """True for a number with few digits."""
    return Fraction(f"{float(limit):.{_DIGITS}g}") == limit


def _check_counter(field: Field, fields: tuple[Field, ...], found: Diagnostics) -> None:
    """A counter without a limit implies nothing about the list."""
    counter = next((f for f in fields if f.name == field.counter), None)
    if counter is None or counter.maximum is None or field.counting == "bits":
        return
    count = int(counter.maximum) + (field.counting == "minus_1")
    if field.counting == "bytes":
        count //= field.scalar.size if field.scalar else 1
    scalar = counter.scalar
    if count > field.capacity and scalar and counter.maximum != scalar.maximum:
        text = f"'{counter.name}' counts up to {count}, but {field.capacity} elements fit"
        found.add(counter.at, "SBGC042", text, f"lower the range, or leave it out")


def _check_deprecation(message: Message, found: Diagnostics) -> None:
    """Finds version ranges that end before they start. Fields of structs start with the message."""
    for what, since, mark, at in (
        (message.name, message.since, message.deprecated, message.at),
        *((f"'{f.name}'", f.since, f.deprecated, f.at) for f in all_fields(message.fields)),
    ):
        start = max(since.firmware, message.since.firmware)
        if mark and mark.since and mark.since.firmware < start:
            text = f"{what} is deprecated before it exists"
            found.add(at, "SBGC071", text, "'deprecated' has the first firmware to avoid it")


# Types of the spec begin with an upper-case letter; built-in ones do not.
_BUILT_IN = re.compile(r"[a-z]")
# Parts of a field's name that are not from the protocol: index and placeholder.
_BRACKETS = re.compile(r"\[.*?\]|\{.*?\}")
# The minimum similarity at which the beginning of a name counts as a misspelled prefix.
_SIMILAR = 0.85


def lint_spelling(spec: Spec, found: Diagnostics) -> None:
    """Check the names of commands, fields and named values; findings go into `found`."""
    for _, name, _, at in spec.entries("commands"):
        if not name.startswith(spec.command_prefix):
            text = f"the command {name} does not begin with '{spec.command_prefix}'"
            hint = "the 'command_prefix' of the protocol is not a part of names in code"
            found.add(at, "SBGC054", text, hint)
    leaf_types = {*COMMAND_IDS.values(), VARIABLE_ID}
    for section in ("quantities", "enums", "flags", "packed"):
        leaf_types.update(name for _, name, _, _ in spec.entries(section))
    for nodes in spec.maps.values():
        for field in _spelled_fields(nodes):
            type_ = str(field.get("type", ""))
            if type_ in leaf_types or _BUILT_IN.match(type_):
                name = _BRACKETS.sub("", str(field["name"]))
                _check_case(name, field, field.at("name"), found)
    for section in ("enums", "flags"):
        for _, name, node, _ in spec.entries(section):
            for value, content in node["values"].items():
                _check_case(value, content, node["values"].at(value), found)
            _check_prefix(name, node, found)


def _spelled_fields(nodes: list[Map]) -> Iterator[Map]:
    """The named fields of all lists of fields."""
    for node in nodes:
        fields = node.get("fields")
        for item in fields if isinstance(fields, list) else ():
            if isinstance(item, Map) and "name" in item:
                yield item


def _check_case(name: str, node: Map, at: Position, found: Diagnostics) -> None:
    is_upper = name == name.upper()
    if not is_upper and not node.get("verbatim"):
        hint = f"write {name.upper()}, or 'verbatim: true' if the protocol spells it like this"
        found.add(at, "SBGC053", f"'{name}' is not in upper case", hint)
    elif is_upper and node.get("verbatim"):
        message = f"'verbatim' is redundant on {name}, which is in upper case"
        found.add(node.at("verbatim"), "SBGC053", message, "leave it out")


def _check_prefix(name: str, node: Map, found: Diagnostics) -> None:
    prefix = str(node.get("prefix", ""))
    values = node["values"]
    if not prefix:
        return
    if not any(value.startswith(prefix) for value in values):
        message = f"no value of {name} starts with '{prefix}'"
        found.add(node.at("prefix"), "SBGC054", message, "leave 'prefix' out, or correct it")
        return
    for value in values:
        begin = value[: len(prefix)]
        alike = difflib.SequenceMatcher(None, begin, prefix).ratio()
        if begin != prefix and alike >= _SIMILAR:
            message = f"{value} almost begins with '{prefix}'"
            found.add(values.at(value), "SBGC054", message, "the other values begin with it")
