"""Resolves the valid values of a field: its range and special values; and its later meanings."""

from __future__ import annotations

import re
from fractions import Fraction

from sbgcgen.model import SCALARS, Availability, Field, Later, Special, Type, scalar_of
from sbgcgen.spec.diagnostics import Diagnostics, Mistake, did_you_mean
from sbgcgen.spec.load import Map
from sbgcgen.spec.resolve.types import TypeResolver

_RANGE = re.compile(r"(-?[0-9]+(?:\.[0-9]+)?)\.\.(-?[0-9]+(?:\.[0-9]+)?)$")


class LimitResolver:
    """Resolves ranges and special values; findings go into `found`."""

    def __init__(self, types: TypeResolver, found: Diagnostics) -> None:
        self.types = types
        self.found = found

    def limits(
        self, node: Map, type_: Type, text: str
    ) -> tuple[Fraction | None, Fraction | None, tuple[Special, ...]]:
        """Minimum and maximum (None if only the type limits the value) and the special values."""
        at = node.at("range")
        special = self._special(node)
        minimum = maximum = None
        scalar = scalar_of(type_)
        if "range" in node:
            match = _RANGE.match(str(node["range"]))
            if match is None or scalar is None:
                hint = "write it like 0..100, for a number"
                self.found.add(at, "SBGC017", f"the range of {text} is not valid", hint)
            else:
                minimum, maximum = Fraction(match[1]), Fraction(match[2])
                if minimum > maximum:
                    hint = f"write {match[2]}..{match[1]}"
                    self.found.add(at, "SBGC017", f"the range of {text} is reversed", hint)
                if not scalar.is_float and minimum.denominator * maximum.denominator != 1:
                    message = f"the range of {text} is not in whole numbers"
                    self.found.add(at, "SBGC017", message, "the range is in raw wire values")
                if not scalar.is_float and not (scalar.holds(minimum) and scalar.holds(maximum)):
                    message = f"the range of {text} exceeds {scalar.name}"
                    self.found.add(at, "SBGC017", message, "the range is in raw wire values")
        for entry in special:
            where = node["special"].at(str(entry.value)) if isinstance(node["special"], Map) else at
            if scalar is None or not scalar.holds(entry.value):
                message = f"the special value {entry.value} of {text} does not fit its type"
                self.found.add(where, "SBGC017", message, "it is a raw wire value")
            elif minimum is not None and maximum is not None:
                if minimum <= entry.value <= maximum and not node.get("special_in_range"):
                    message = f"the special value {entry.value} of {text} is inside its range"
                    hint = "narrow the range, or mark it with 'special_in_range: true'"
                    self.found.add(where, "SBGC018", message, hint)
        return minimum, maximum, special

    def _special(self, node: Map) -> tuple[Special, ...]:
        """The special values: texts, or mappings that also give an identifier."""
        result = []
        for key, content in (node.get("special") or {}).items():
            if not isinstance(content, Map):
                result.append(Special(int(key), str(content), at=node["special"].at(key)))
                continue
            at = content.at("as")
            name = self.types.identifier(str(content["as"]), at)
            text = self.types.summary(content, content.position, f"the special value {key}")
            result.append(Special(int(key), text, name, at))
        return tuple(result)


class LaterResolver:
    """Resolves the key `later`; findings go into `found`."""

    def __init__(self, types: TypeResolver, limits: LimitResolver, found: Diagnostics) -> None:
        self.types = types
        self.limits = limits
        self.found = found

    def later(self, node: Map, field: Field) -> tuple[Later, ...]:
        """The meanings of a field, the first one first; each states the differences from the previous one."""
        result: list[Later] = []
        known = Later(field.since, field.type, field.minimum, field.maximum, field.summary)
        for said in node.get("later", []):
            with self.found.at(said):
                _check_field(field)
                known = self._next(said, known, field)
                result.append(known)
        return tuple(result)

    def _next(self, said: Map, known: Later, field: Field) -> Later:
        text = str(said["firmware"])
        at = said.at("firmware")
        since = self.types.versions.version("firmware", text, at)
        if 0 < since <= known.since.firmware:
            hint = "'later' has the first firmware of each meaning, in their order"
            raise Mistake("SBGC071", f"firmware {text} is not later", hint, "firmware")
        type_ = self._type(said, field) if "type" in said else known.type
        low, high = known.minimum, known.maximum
        if "range" in said:
            low, high, _ = self.limits.limits(said, type_, field.spec_name)
        summary = " ".join(str(said.get("summary", known.summary)).split())
        if (type_, low, high, summary) == (known.type, known.minimum, known.maximum, known.summary):
            raise Mistake(
                "SBGC026", "nothing is new in this firmware", "say what differs", "firmware"
            )
        return Later(Availability(since, firmware_text=text), type_, low, high, summary)

    def _type(self, said: Map, field: Field) -> Type:
        known = self.types.types
        named: dict[str, Type] = {**SCALARS, **known.quantities, **known.enums, **known.packed}
        name = str(said["type"])
        if name not in named:
            hint = did_you_mean(name, named) or "name a number, quantity, enum or packed integer"
            raise Mistake("SBGC010", f"unknown type '{name}'", hint, "type")
        ours, theirs = scalar_of(field.type), scalar_of(named[name])
        if ours != theirs and ours and theirs:
            hint = "the bytes stay, so it is a type over the same number"
            raise Mistake("SBGC026", f"{name} is not of type {ours.name}", hint, "type")
        return named[name]


def _check_field(field: Field) -> None:
    """Only numbers without another rule for their meaning can have a later one."""
    problem = ""
    if scalar_of(field.type) is None:
        problem = "is not a number"
    elif field.reserved or field.constant:
        problem = "has no meaning that could change"
    elif field.alternative or field.variable:
        problem = "has a unit that depends on another field"
    if problem:
        text = f"'{field.name}' {problem}"
        raise Mistake("SBGC026", text, "only the meaning of a number changes", "firmware")
