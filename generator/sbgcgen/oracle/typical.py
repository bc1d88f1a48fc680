"""Ordinary values for every kind of field: inside its range, round in its unit, and not special.

They are used in the examples of the documentation. Neighboring places have different values, so
that readers can distinguish them.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from sbgcgen.oracle.edges import counting
from sbgcgen.model import Blob, Enum, EnumValue, Field, Packed, Part, Quantity, Scalar, Type
from sbgcgen.oracle.codec import scalar_of
from sbgcgen.oracle.json_values import integer_of

_WORDS = ("Studio", "Tripod", "Handheld", "Crane", "Car", "Drone", "Walking")


def typical(field: Field, type_: Type, place: int) -> Any:
    """A value for a field or one of its elements; `place` makes neighbors differ."""
    if isinstance(type_, Blob):
        assert type_.size is not None, "the rest of a body is a list of bytes"
        if type_.kind == "bytes":
            return (bytes(type_.size) if field.reserved else counting(type_.size)).hex()
        return _WORDS[place % len(_WORDS)][: type_.size]
    if isinstance(type_, Enum):
        return _enum(type_, place, field)
    scalar = scalar_of(type_)
    if isinstance(type_, Packed):
        return integer_of(_packed(type_, place), scalar.size)
    if field.role == "copy" and field.minimum is not None:
        return int(field.minimum)
    if scalar.is_float:
        return _float(field, place)
    return integer_of(_integer(field, type_, scalar, place), scalar.size)


def _enum(type_: Enum, place: int, field: Field | None = None) -> int:
    """A named value, not the first one if possible; for flags, one or two of them."""
    values = [v for v in type_.values if not v.since and _allows(field, v)]
    if not values and type_.kind == "flags":
        return 0  # only later firmware has these flags
    values = values or list(type_.values)
    if not values:
        return 0
    if type_.kind == "flags":
        first, second = values[place % len(values)], values[(place + 2) % len(values)]
        return first.value | second.value
    return (values[1:] or values)[place % max(1, len(values) - 1)].value


def _allows(field: Field | None, value: EnumValue) -> bool:
    if field is None or field.minimum is None or field.maximum is None:
        return True
    return field.minimum <= value.value <= field.maximum


def _packed(type_: Packed, place: int) -> int:
    digits = [part for part in type_.parts if part.is_digits]
    if digits:  # a version, such as 2.60, with 0 in its last part
        tops = {part.divide: 2 if not part.modulo else part.modulo * 6 // 10 for part in digits}
        tops[min(tops)] = 0
        return sum(divide * number for divide, number in tops.items())
    raw = 0
    for number, part in enumerate(type_.parts):
        raw |= _part(part, place + number) << part.shift
    assert type_.scalar.maximum is not None
    return raw if raw <= type_.scalar.maximum else raw - (1 << 8 * type_.scalar.size)


def _part(part: Part, place: int) -> int:
    most = part.mask >> part.shift
    if part.enum:
        return _enum(part.enum, place) & most
    return min(most, 1 if part.is_bool else 2 + place % 3)


def _share(place: int, low: int, high: int) -> Fraction:
    """A fraction of a range, from `low` to `high` percent, which differs by position."""
    return Fraction(low + 7 * place % (high - low), 100)


def _float(field: Field, place: int) -> float:
    if field.minimum is None or field.maximum is None:
        return 1.5 + place % 8 / 4
    middle, half = (field.maximum + field.minimum) / 2, (field.maximum - field.minimum) / 2
    # Sixteenths have few digits in binary and in decimal.
    share = Fraction(int(16 * _share(place, 10, 80)), 16)
    return float(middle + half * share * (-1 if place % 2 else 1))


def _integer(field: Field, type_: Type, scalar: Scalar, place: int) -> int:
    assert scalar.minimum is not None and scalar.maximum is not None
    if field.variable:  # small enough for the range of every variable
        return 10 + place % 7
    low = Fraction(scalar.minimum) if field.minimum is None else field.minimum
    high = Fraction(scalar.maximum) if field.maximum is None else field.maximum
    is_narrow = low > scalar.minimum or high < scalar.maximum
    number = _inside(low, high, is_narrow, type_, place)
    number = -(-number // field.align) * field.align
    number = min(max(number, int(low)), int(high))
    step = field.align if number < (low + high) / 2 else -field.align
    while any(special.value == number for special in field.special):
        number += step
    return number


def typical_number(quantity: Quantity) -> int | float:
    """An ordinary raw value of a quantity without a range."""
    low, high = quantity.scalar.minimum, quantity.scalar.maximum
    if low is None or high is None:
        return 1.5
    number = _inside(Fraction(low), Fraction(high), False, quantity, 0)
    return min(max(number, low), high)


def _inside(low: Fraction, high: Fraction, is_narrow: bool, type_: Type, place: int) -> int:
    """A number in a range that is round in its unit."""
    # Values of fields without a range are usually far from the limits of their type.
    most = high if is_narrow else min(high, Fraction(65535))
    share = _share(place, 40, 80) if is_narrow else _share(place, 2, 7)
    if most <= 255 and not is_narrow:
        share = max(share, _share(place, 4, 24))
    if low < 0:
        value = most * share / 2 * (-1 if place % 2 else 1)
    else:
        value = low + (most - low) * share
    if not isinstance(type_, Quantity) or type_.ratio:
        return round(value)
    two_digits = Fraction(f"{float(type_.real(value)):.1e}")
    return round(type_.raw(two_digits))
