"""Rules for what a spec can say but hardly means."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from sbgcgen.model import Enum, Field, Layout, Message, Quantity, Struct
from sbgcgen.spec.diagnostics import Diagnostics

# Digits of a limit that somebody has chosen, as in 1275 or 0.0125.
_DIGITS = 4
# Limits of an angle that somebody has chosen, in degrees.
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
        for field in _fields(message.fields):
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
    """A range is in raw values; one in the unit of the field has odd limits in that unit."""
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
    """A counter without a limit of its own says nothing about the list."""
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
    """Finds ranges of versions that end before they start. Fields of structs start with the message."""
    for what, since, mark, at in (
        (message.name, message.since, message.deprecated, message.at),
        *((f"'{f.name}'", f.since, f.deprecated, f.at) for f in _fields(message.fields)),
    ):
        start = max(since.firmware, message.since.firmware)
        if mark and mark.since and mark.since.firmware < start:
            text = f"{what} is deprecated before it exists"
            found.add(at, "SBGC071", text, "'deprecated' has the first firmware to avoid it")


def _fields(fields: tuple[Field, ...]) -> Iterator[Field]:
    for field in fields:
        yield field
        if isinstance(field.type, Struct):
            yield from _fields(field.type.fields)
