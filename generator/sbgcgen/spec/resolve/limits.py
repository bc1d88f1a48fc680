"""Resolves the valid values of a field: its range and special values."""

from __future__ import annotations

import re
from fractions import Fraction

from sbgcgen.model import Scalar, Special, Type, scalar_of
from sbgcgen.spec.diagnostics import Diagnostics
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
                if not scalar.is_float and not (_fits(scalar, minimum) and _fits(scalar, maximum)):
                    message = f"the range of {text} exceeds {scalar.name}"
                    self.found.add(at, "SBGC017", message, "the range is in raw wire values")
        for entry in special:
            where = node["special"].at(str(entry.value)) if isinstance(node["special"], Map) else at
            if scalar is None or not _fits(scalar, Fraction(entry.value)):
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


def _fits(scalar: Scalar, value: Fraction) -> bool:
    if scalar.minimum is None or scalar.maximum is None:
        return True
    return scalar.minimum <= value <= scalar.maximum
