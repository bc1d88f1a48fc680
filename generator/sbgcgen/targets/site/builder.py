"""Data of the frame builder for typed code: names in Python and C++, by the paths of fields.

A value without a fact is assigned as text.
"""

from __future__ import annotations

from typing import Any

from sbgcgen.model import Enum, Field, Message, Packed, Part, Quantity, Scalar, Struct, Type
from sbgcgen.oracle.codec import keys_of
from sbgcgen.views.code import attribute_name, enum_name, unit_name
from sbgcgen.views.words import positive_text

# The sizes in bytes of integers that are written without a suffix; 3 bytes are a separate type.
_PLAIN_SIZES = (1, 2, 4)


def builder_facts(message: Message) -> dict[str, Any]:
    """The header of a message, the facts by path, the enums in them, and the sign conventions."""
    facts: dict[str, Any] = {}
    enums: dict[str, Any] = {}
    for field in message.fields:
        _add(field, "", facts, enums)
    positive = {
        leaf.path: positive_text([leaf])
        for leaf in message.leaves
        if leaf.direction and leaf.direction.positive
    }
    return {"family": message.family, "facts": facts, "enums": enums, "positive": positive}


def _add(field: Field, before: str, facts: dict[str, Any], enums: dict[str, Any]) -> None:
    path = before + field.name
    is_simple = field.dim in ("one", "axis", "xyz", "fixed")
    if not is_simple or field.is_counter or field.reserved or field.may_be_absent:
        return
    paths = [path]
    if field.dim == "fixed":
        fact = {} if isinstance(field.type, (Struct, Packed)) else _fact(field, enums)
        if fact:
            facts[path] = {"each": fact}
        return
    if field.dim != "one":
        facts[path] = {"class": "Axes" if field.dim == "axis" else "Xyz"}
        paths = [f"{path}.{key}" for key in keys_of(field)]
    for one in paths:
        if isinstance(field.type, Struct):
            facts[one] = {"class": field.type.name}
            for member in field.type.fields:
                _add(member, f"{one}.", facts, enums)
        elif fact := _fact(field, enums):
            facts[one] = fact
    if attribute_name(field.name) != field.name:
        facts.setdefault(path, {})["attribute"] = attribute_name(field.name)


def _fact(field: Field, enums: dict[str, Any]) -> dict[str, Any]:
    """The fact about a value; none if the firmware or another message selects its meaning."""
    if field.variable or field.later:
        return {}
    fact = _of_type(field.type, enums)
    if isinstance(field.type, Packed) and field.default:
        return {}
    if fact and field.alternative:
        fact["unless"] = field.alternative.flag.name
    if fact and field.special:
        fact["special"] = [str(special.value) for special in field.special]
    return fact


def _of_type(type_: Type, enums: dict[str, Any]) -> dict[str, Any]:
    if isinstance(type_, Quantity):
        return {} if type_.scalar.is_float else {"unit": unit_name(type_)}
    if isinstance(type_, Enum):
        names = {v.name: [enum_name(v), v.identifier] for v in type_.values}
        enums[type_.name] = {"member": type_.member, "names": names}
        return {"flags" if type_.kind == "flags" else "enum": type_.name}
    if isinstance(type_, Packed):
        parts = {part.name: _of_part(part, enums) for part in type_.parts}
        is_known = all(parts.values()) and type_.names is None
        order = [part.name for part in type_.parts]  # a name belongs to the first part that has it
        return {"packed": type_.name, "parts": parts, "order": order} if is_known else {}
    if isinstance(type_, Scalar) and not type_.is_float and type_.size in _PLAIN_SIZES:
        return {"number": True}
    return {}


def _of_part(part: Part, enums: dict[str, Any]) -> dict[str, Any]:
    if part.is_digits or attribute_name(part.name) != part.name:
        return {}
    if part.is_bool:
        return {"bool": True}
    type_ = part.enum or part.quantity
    return _of_type(type_, enums) if type_ else {"number": True}
