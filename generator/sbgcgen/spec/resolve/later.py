"""Resolves what a field means in later firmware."""

from __future__ import annotations

from sbgcgen.model import SCALARS, Availability, Field, Later, Type, scalar_of
from sbgcgen.spec.diagnostics import Diagnostics, Mistake, did_you_mean
from sbgcgen.spec.load import Map
from sbgcgen.spec.resolve.limits import LimitResolver
from sbgcgen.spec.resolve.types import TypeResolver


class LaterResolver:
    """Resolves the key `later`; findings go into `found`."""

    def __init__(self, types: TypeResolver, limits: LimitResolver, found: Diagnostics) -> None:
        self.types = types
        self.limits = limits
        self.found = found

    def later(self, node: Map, field: Field) -> tuple[Later, ...]:
        """The meanings of a field, the first one first; each says what differs from the one before."""
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
    """Only numbers without another rule for their meaning have a later one."""
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
