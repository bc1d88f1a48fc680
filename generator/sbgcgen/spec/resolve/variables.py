"""Resolves the adjustable variables and the settings that they set."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from sbgcgen.model import SCALARS, Enum, Leaf, Message, Position, Quantity, Scalar, Variable
from sbgcgen.model import VariableSetting
from sbgcgen.model.names import snake_case
from sbgcgen.spec.diagnostics import Diagnostics, Mistake, did_you_mean
from sbgcgen.spec.load import Map
from sbgcgen.spec.resolve.types import TypeResolver

_WIDEST = SCALARS["i32"]  # type of a variable's value in messages
_LIMIT = 1 << 62  # bound of intermediate products, which must fit into 64 bits


class VariableResolver:
    """Resolves entries under `variables`; findings go into `found`."""

    def __init__(self, types: TypeResolver, messages: list[Message], found: Diagnostics) -> None:
        self.types = types
        self.found = found
        self.messages = {m.name: m for m in messages}
        self.stored = {m.stores for m in messages if m.stores}

    def variable(self, name: str, node: Map, at: Position) -> Variable:
        """Resolve one entry."""
        quantity = self.types.types.quantities.get(str(node["type"]))
        scalar = quantity.scalar if quantity else SCALARS.get(str(node["type"]))
        if scalar is None:
            known = [*SCALARS, *self.types.types.quantities]
            hint = did_you_mean(str(node["type"]), known)
            hint = hint or "a variable is a number or a quantity"
            self.found.add(node.at("type"), "SBGC010", f"unknown type '{node['type']}'", hint)
            scalar = SCALARS["i32"]
        low, _, high = str(node["range"]).partition("..")
        minimum, maximum = int(low), int(high)
        if minimum > maximum:
            message = f"the range of {name} is reversed"
            self.found.add(node.at("range"), "SBGC017", message, f"write {high}..{low}")
        if not (scalar.holds(minimum) and scalar.holds(maximum)):
            message = f"the range of {name} exceeds {scalar.name}"
            hint = "the range is in raw wire values"
            self.found.add(node.at("range"), "SBGC017", message, hint)
        is_switch = bool(node.get("as_switch", False))
        if is_switch and ((minimum, maximum) != (0, 1) or "sets" not in node):
            message = f"{name} is not a switch"
            hint = "a switch has the range 0..1, and settings that it sets"
            self.found.add(node.at("as_switch"), "SBGC044", message, hint)
        return Variable(
            name=name,
            identifier=self.types.identifier(snake_case(name), at),
            id=node["id"],
            scalar=scalar,
            quantity=quantity,
            minimum=minimum,
            maximum=maximum,
            summary=self.types.summary(node, at, name),
            errata=self.types.errata(node),
            settings=tuple(self._settings(node, quantity, (minimum, maximum))),
            is_switch=is_switch,
            since=self.types.availability(node),
            unconfirmed=bool(node.get("unconfirmed", False)),
            at=at,
        )

    def _settings(
        self, node: Map, quantity: Quantity | None, limits: tuple[int, int]
    ) -> Iterator[VariableSetting]:
        """The settings under `sets`, without those that a variable of this quantity cannot set."""
        for text, at in node.listed("sets"):
            with self.found.at(at):
                message, leaf = self._place(text)
                scalar = self._number(text, message, leaf)
                setting = _setting(text, message, leaf, scalar, quantity)
                _check_values(text, setting, limits)
                yield setting

    def _place(self, text: str) -> tuple[Message, Leaf]:
        """The message, and its value at `Message.path`."""
        name, _, path = text.partition(".")
        message = self.messages.get(name)
        if message is None:
            hint = did_you_mean(name, self.stored) or "name settings, such as ReadParams3"
            raise Mistake("SBGC021", f"there is no message '{name}'", hint)
        leaf = next((leaf for leaf in message.leaves if leaf.path == path), None)
        if leaf is None:
            known = [leaf.path for leaf in message.leaves]
            hint = did_you_mean(path, known) or f"write it like {name}.{known[0] if known else ''}"
            raise Mistake("SBGC021", f"{name} has no value '{path}'", hint)
        return message, leaf

    def _number(self, text: str, message: Message, leaf: Leaf) -> Scalar:
        """The type of a setting that a variable can set."""
        scalar = _integer(leaf)
        problem = "is not an integer that is always present" if scalar is None else ""
        if message.name not in self.stored:
            problem = "is not a setting: no message stores it"
        elif leaf.field.role in ("copy", "state") or leaf.field.reserved or leaf.field.is_counter:
            problem = "is not a setting"
        elif not _always_there(leaf, message):
            problem = "is not always present"
        if problem or scalar is None:
            hint = "a variable sets one number among the settings that a message stores"
            raise Mistake("SBGC044", f"'{text}' {problem}", hint)
        return scalar


def _setting(
    text: str, message: Message, leaf: Leaf, scalar: Scalar, ours: Quantity | None
) -> VariableSetting:
    """The setting in `message` that is set by a variable with the quantity `ours`."""
    theirs = leaf.field.type if isinstance(leaf.field.type, Quantity) else None
    units = [q.unit if q else None for q in (ours, theirs)]
    if units[0] != units[1]:
        words = " and ".join(unit or "a plain number" for unit in units)
        hint = "give the variable a type of the same unit"
        raise Mistake("SBGC044", f"'{text}' is in another unit: {words}", hint)
    if ours != theirs and any(q and q.ratio for q in (ours, theirs)):
        problem = f"'{text}' grows otherwise than the variable"
        raise Mistake("SBGC044", problem, "give the variable the type of the setting")
    scales = [q.scale if q else Fraction(1) for q in (ours, theirs)]
    offsets = [q.offset if q else Fraction(0) for q in (ours, theirs)]
    setting = VariableSetting(
        message=message.name,
        path=leaf.path,
        scalar=scalar,
        scale=scales[0] / scales[1],
        offset=(offsets[0] - offsets[1]) / scales[1],
        direction=leaf.direction,
        later=tuple(
            replace(one, summary="" if one.summary == leaf.field.summary else one.summary)
            for one in leaf.field.later
        ),
    )
    if setting.later and (setting.scale != 1 or setting.offset != 0):
        problem = f"'{text}' has another meaning in later firmware"
        raise Mistake("SBGC044", problem, "give the variable the type of the setting")
    if setting.denominator != 1:
        special = tuple(sorted(s.value for s in leaf.field.special))
        setting = replace(setting, special=special)
    return setting


def _check_values(text: str, setting: VariableSetting, limits: tuple[int, int]) -> None:
    """Every value of the variable must be a value of the setting, and vice versa."""
    if any(value + 1 in setting.special for value in setting.special):
        problem = f"a value between two special ones of '{text}' has no raw value"
        raise Mistake("SBGC044", problem, "give the variable the type of the setting")
    if not all(setting.scalar.holds(setting.count(value)) for value in limits):
        problem = f"'{text}' cannot hold every value of the range"
        raise Mistake("SBGC044", problem, f"it is of type {setting.scalar.name}")
    if not _is_told(setting):
        problem = f"not every value of '{text}' fits into a variable"
        raise Mistake("SBGC044", problem, f"the value of a variable is sent as {_WIDEST.name}")


def _integer(leaf: Leaf) -> Scalar | None:
    """The type of a leaf that is a single integer or enum; None for any other."""
    type_ = leaf.field.type
    scalar = type_ if isinstance(type_, Scalar) else None
    if isinstance(type_, Quantity) or (isinstance(type_, Enum) and type_.kind == "enum"):
        scalar = type_.scalar
    return scalar if scalar is not None and not scalar.is_float and leaf.count == 1 else None


def _always_there(leaf: Leaf, message: Message) -> bool:
    top = leaf.path.split(".")[0].split("[")[0]
    field = next(f for f in message.fields if f.name == top)
    return leaf.offset is not None and not field.is_variable


def _is_told(setting: VariableSetting) -> bool:
    """True if a variable can represent every value of the setting without overflow."""
    scalar = setting.scalar
    assert scalar.minimum is not None and scalar.maximum is not None
    parts = (setting.numerator, setting.denominator, setting.addend)
    largest = 1 << 32
    return all(
        _WIDEST.holds(setting.value(raw)) for raw in (scalar.minimum, scalar.maximum)
    ) and all(abs(part) * largest < _LIMIT for part in parts)
