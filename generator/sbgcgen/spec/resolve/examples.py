"""Resolves typical values and the values of worked examples.

The spec has them in readable form: a quantity in its unit, an enum by name, flags as a list of names,
a packed integer as a mapping of its parts, bytes in hex. The results have the form of messages in
JSON, with raw numbers.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from sbgcgen.model import Announced, Blob, Enum, Field, Packed, Part, Position, Quantity, Scalar
from sbgcgen.model import StopPattern, StopValue, Struct, Type
from sbgcgen.spec.diagnostics import Diagnostics, did_you_mean
from sbgcgen.spec.load import Map

_VALUE, _PATH = "SBGC063", "SBGC064"
_STEP = re.compile(r"\.?([a-z_][a-z0-9_]*)|\[([0-9]+)\]")


class _Unfit(Exception):
    """A value that its field cannot hold."""

    def __init__(self, problem: str, hint: str) -> None:
        super().__init__(problem)
        self.problem = problem
        self.hint = hint


class ExampleReader:
    """Turns `typical` and `example` into raw values; findings go into `found`."""

    def __init__(self, found: Diagnostics, broken: set[str]) -> None:
        """`broken` names the packed integers whose types did not resolve, as reported before."""
        self.found = found
        self._broken = broken
        self.untyped: set[str] = set()  # names of fields whose type did not resolve

    def typical(self, field: Field, node: Any, at: Position) -> Any:
        """The typical value of a field; None if it is not valid."""
        if self._is_broken(field.type):
            return None
        try:
            return _member(field, node)
        except _Unfit as unfit:
            text = f"a value of '{field.name}' {unfit.problem}"
            self.found.add(at, _VALUE, text, unfit.hint)
        return None

    def example(
        self, fields: tuple[Field, ...], node: Any, name: str, what: str = "example"
    ) -> dict[str, Any]:
        """The values of a worked example by path; all others are typical."""
        result: dict[str, Any] = {}
        for path, value in node.items() if isinstance(node, Map) else ():
            found = _find(fields, path)
            if found is None and self.untyped & set(re.findall(r"[a-z_][a-z0-9_]*", path)):
                continue
            if found is None:
                hint = did_you_mean(path, list(_known(fields))) or "write it like axes.pitch.angle"
                text = f"{name} has no value '{path}'"
                self.found.add(node.at(path), _PATH, text, hint)
                continue
            field, is_element = found
            if self._is_broken(field.type):
                continue
            try:
                read = _single(field, field.type, value) if is_element else _member(field, value)
                result[path] = read
            except _Unfit as unfit:
                text = f"'{path}' of the {what} of {name} {unfit.problem}"
                self.found.add(node.at(path), _VALUE, text, unfit.hint)
        return result

    def stops(self, fields: tuple[Field, ...], node: Any, name: str) -> tuple[StopPattern, ...]:
        """The patterns of `stops`: "always", the values of one pattern by path, or a list of these."""
        if node is None:
            return ()
        nodes = node if isinstance(node, list) else [{} if node == "always" else node]
        return tuple(self._stop_pattern(fields, one, name) for one in nodes)

    def _stop_pattern(self, fields: tuple[Field, ...], node: Any, name: str) -> StopPattern:
        pattern = []
        for path, value in self.example(fields, node, name, "stop").items():
            found = _find(fields, path)
            assert found is not None
            field = found[0]
            mask = 0
            if isinstance(field.type, Packed) and isinstance(node[path], Map):
                parts = {part.name: part for part in field.type.parts}
                mask = sum(parts[part].mask for part in node[path])
            each = value.items() if isinstance(value, dict) else [("", value)]
            for key, one in each:
                full = f"{path}.{key}" if key else path
                pattern.append(StopValue(full, field.type, one, mask, field.may_be_absent))
        return tuple(pattern)

    def _is_broken(self, type_: Type) -> bool:
        """True if values of a type cannot be parsed because the type has a finding."""
        if isinstance(type_, Struct):
            return any(self._is_broken(member.type) for member in type_.fields)
        return isinstance(type_, Packed) and type_.name in self._broken


def _find(fields: tuple[Field, ...], path: str) -> tuple[Field, bool] | None:
    """The field at a path, and whether the path denotes one element of it."""
    field: Field | None = None
    is_element = True
    at = 0
    while at < len(path):
        step = _STEP.match(path, at)
        if step is None:
            return None
        at = step.end()
        name, number = step.groups()
        if field is not None and not is_element:
            keys = [word.lower() for word in field.index]
            is_index = name in keys if field.dim in ("axis", "xyz") else number is not None
            if not is_index or (field.dim == "fixed" and int(number) >= field.count):
                return None
            is_element = True
            continue
        if field is not None and not isinstance(field.type, Struct):
            return None
        inner = fields if field is None else field.type.fields  # type: ignore[union-attr]
        field = next((f for f in inner if f.name == name), None)
        if field is None or field.is_counter:
            return None
        is_element = field.dim == "one"
    if field is None or (isinstance(field.type, Struct) and field.dim in ("one", "axis", "xyz")):
        return None
    return field, is_element


def _known(fields: tuple[Field, ...], path: str = "") -> Iterator[str]:
    """The paths of all values, for suggestions."""
    for field in fields:
        names = [path + field.name]
        if field.dim in ("axis", "xyz"):
            names = [f"{path}{field.name}.{word.lower()}" for word in field.index]
        for name in names:
            if isinstance(field.type, Struct):
                yield from _known(field.type.fields, f"{name}.")
            else:
                yield name


# Values


def _member(field: Field, node: Any) -> Any:
    """The value of a whole field; a single value applies to each element."""
    type_ = field.type
    if field.dim == "one":
        return _single(field, type_, node)
    if isinstance(type_, Blob) and type_.kind == "bytes" and type_.size is None:
        return _hex(node, None)
    is_list = isinstance(node, list) and not (_is_flags(type_) and field.dim != "rest")
    if field.dim in ("axis", "xyz", "fixed"):
        nodes = list(node) if is_list else [node] * field.count
        if len(nodes) != field.count:
            raise _Unfit(f"has {len(nodes)} elements", f"give one value, or {field.count}")
    else:
        nodes = list(node) if is_list else [node] * 3
    values = [_single(field, type_, one) for one in nodes]
    if field.dim in ("axis", "xyz"):
        return {word.lower(): value for word, value in zip(field.index, values)}
    return values


def _is_flags(type_: Type) -> bool:
    return isinstance(type_, Enum) and type_.kind == "flags"


def _single(field: Field, type_: Type, node: Any) -> Any:
    if isinstance(type_, Struct):
        return _struct(type_, node)
    if isinstance(type_, Blob):
        return _blob(type_, node)
    if isinstance(type_, Announced):
        raise _Unfit("cannot be given", "its type is announced by another message")
    scalar = type_ if isinstance(type_, Scalar) else type_.scalar
    if isinstance(type_, Packed):
        value: Any = _packed(type_, node)
    elif isinstance(type_, Enum):
        value = _enum(type_, node)
    else:
        value = _number(type_, scalar, node)
    _check(field, scalar, value)
    return value


def _struct(type_: Struct, node: Any) -> dict[str, Any]:
    if not isinstance(node, Map):
        raise _Unfit("is not a mapping", "give an element like {param_id: P_ROLL, param_value: 20}")
    members = {member.name: member for member in type_.fields}
    for name in node:
        if name not in members:
            hint = did_you_mean(name, members) or f"known: {', '.join(members)}"
            raise _Unfit(f"has no member '{name}'", hint)
    return {name: _member(members[name], value) for name, value in node.items()}


def _blob(type_: Blob, node: Any) -> str:
    if type_.kind == "bytes":
        return _hex(node, type_.size)
    text = str(node)
    if len(text.encode()) > (type_.size or 0):
        raise _Unfit("is too long", f"at most {type_.size} bytes fit")
    return text


def _hex(node: Any, size: int | None) -> str:
    """Bytes, padded with zeros."""
    try:
        data = bytes.fromhex(str(node) if node is not None else "")
    except ValueError:
        raise _Unfit("is not hex", 'write bytes like "0a ff", in quotes') from None
    if size is not None and len(data) > size:
        raise _Unfit("is too long", f"at most {size} bytes fit")
    return data.ljust(size or 0, b"\0").hex()


def _enum(type_: Enum, node: Any) -> int:
    if isinstance(node, int) and not isinstance(node, bool):
        return node
    names = {value.name: value.value for value in type_.values}
    result = 0
    for name in node if isinstance(node, list) else [node]:
        if str(name) not in names:
            hint = did_you_mean(str(name), names) or f"name values of {type_.name}"
            raise _Unfit(f"is '{name}', which is not a value of {type_.name}", hint)
        result = result | names[str(name)] if type_.kind == "flags" else names[str(name)]
    return result


def _packed(type_: Packed, node: Any) -> int:
    if isinstance(node, int) and not isinstance(node, bool):
        return node
    if not isinstance(node, Map):
        if type_.names is None:
            raise _Unfit("has no names", "give its parts, as in {mode: MODE_ANGLE}, or a number")
        return _enum(type_.names, node)
    parts = {part.name: part for part in type_.parts}
    raw = 0
    for name, value in node.items():
        if name not in parts:
            hint = did_you_mean(name, parts) or f"parts: {', '.join(parts)}"
            raise _Unfit(f"has no part '{name}'", hint)
        raw += _part(parts[name], value)
    if raw >> 8 * type_.scalar.size:
        raise _Unfit(f"is {raw}, which does not fit into {type_.scalar.name}", "give smaller parts")
    maximum = type_.scalar.maximum or 0
    return raw if raw <= maximum else raw - (1 << 8 * type_.scalar.size)


def _part(part: Part, node: Any) -> int:
    try:
        value = _enum(part.enum, node) if part.enum else int(node)
    except (TypeError, ValueError):
        text = f"has '{node}' as '{part.name}', which is not an integer"
        raise _Unfit(text, "give a number") from None
    if part.is_digits:
        if value < 0 or (part.modulo and value >= part.modulo):
            raise _Unfit(f"does not fit into the digits of '{part.name}'", "give a smaller number")
        return value * part.divide
    lowest, highest = part.limits
    fits = lowest <= value <= highest if part.is_number else value >= 0
    if not fits or (not part.is_number and (value << part.shift) & ~part.mask):
        raise _Unfit(f"does not fit into the bits of '{part.name}'", "give a smaller number")
    return part.bits_of(value)


def _number(type_: Type, scalar: Scalar, node: Any) -> int | float:
    try:
        real = Fraction(str(node))
    except (ValueError, ZeroDivisionError):
        raise _Unfit(f"is '{node}', which is not a number", "write it like -12.5") from None
    if isinstance(type_, Quantity):
        real = type_.raw(real)
    elif real.denominator != 1 and not scalar.is_float:
        raise _Unfit(f"is {node}, but its type is {scalar.name}", "give a whole number")
    return float(real) if scalar.is_float else round(real)


def _check(field: Field, scalar: Scalar, value: int | float) -> None:
    """Raise _Unfit unless the value may be sent."""
    if any(special.value == value for special in field.special):
        return
    low = scalar.minimum if field.minimum is None else field.minimum
    high = scalar.maximum if field.maximum is None else field.maximum
    if (low is not None and value < low) or (high is not None and value > high):
        raise _Unfit(f"is {value} on the wire, out of its range", f"the range is {low} to {high}")
    if field.align != 1 and value % field.align:
        raise _Unfit(f"is {value}, which is not a multiple of {field.align}", "round it")
