"""Names and numbers in code, in any language: the model's names, and an example's raw values."""

from __future__ import annotations

import keyword
from fractions import Fraction
from functools import reduce
from operator import or_

from sbgcgen.model import Enum, EnumValue, Packed, Part, Quantity
from sbgcgen.model.packed_text import part_of

# Names that every Python message, packed integer or enum already has.
_TAKEN_IN_PYTHON = set("self cls raw assign from_body from_json to_json name value mro".split())


def enum_name(value: EnumValue) -> str:
    """The name of an enum value: the protocol's own, unless it is impossible in Python."""
    name = value.name
    is_taken = keyword.iskeyword(name) or name in _TAKEN_IN_PYTHON or name.startswith("_")
    return value.identifier.upper() if is_taken or not name.isidentifier() else name


def attribute_name(name: str) -> str:
    """The name of a field or part, which may be a Python keyword: in_."""
    is_taken = keyword.iskeyword(name) or name in _TAKEN_IN_PYTHON - {"name", "value"}
    return f"{name}_" if is_taken else name


def unit_name(quantity: Quantity) -> str:
    """The unit of a quantity as a part of names: deg/s^2 is deg_per_s2."""
    words = {"/": "_per_", "^": "", " ": "_", "%": "percent", "°": "deg", "µ": "u"}
    return "".join(words.get(c, c) for c in quantity.unit or quantity.accessor)


def decimal(raw: int, quantity: Quantity) -> str:
    """The shortest decimal number for which this raw value is the nearest one."""
    exact = quantity.real(raw)
    for digits in range(12):
        text = f"{float(exact):.{digits}f}"
        if abs(quantity.raw(Fraction(text)) - raw) < Fraction(1, 2):
            return text
    raise ValueError(f"no decimal for {raw} of {quantity.name}")


def value_named(enum: Enum, value: int) -> EnumValue | None:
    return next((v for v in enum.values if v.value == value), None)


def flags_of(enum: Enum, bits: int) -> list[EnumValue]:
    """The flags that make up these bits; empty if they do not make up all of them."""
    found = [v for v in enum.values if v.value and bits & v.value == v.value]
    return found if reduce(or_, (flag.value for flag in found), 0) == bits else []


def parts_that_make(packed: Packed, raw: int) -> list[tuple[Part, int]] | None:
    """The non-zero parts and their values; None if they do not make up the whole number."""
    made = 0
    for part in packed.parts:
        made |= 0 if part.is_digits else part_of(part, raw) << part.shift
    if made != raw or raw < 0:
        return None
    return [(part, part_of(part, raw)) for part in packed.parts if part_of(part, raw)]
