"""Resolves references of a field: conditions, flags that select a unit, ids of variables."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any

from sbgcgen.model import Alternative, Condition, Context, Enum, Field, Packed, Part, Quantity
from sbgcgen.model import Scalar, Struct, Type, satisfying, scalar_of
from sbgcgen.model.names import snake_case
from sbgcgen.spec.diagnostics import Diagnostics, Mistake, did_you_mean
from sbgcgen.spec.load import Map
from sbgcgen.spec.resolve.types import VARIABLE_ID, TypeResolver

_RULE = "SBGC026"
# The words for conditions on each kind of value.
_WORDS = {
    "a flag set": ("has", "any", "has_not"),
    "an enum": ("is", "is_not"),
    "an integer": ("is", "is_not", "at_least", "at_most"),
}
_ALL = tuple(dict.fromkeys(word for words in _WORDS.values() for word in words))
_SEVERAL = ("all", "one_of")
_PLACE = "{"  # of an element of an index, as in {AXIS}_SPEED


@dataclass(frozen=True)
class Outside:
    """The fields before a group, and the words of its index."""

    fields: tuple[Field, ...] = ()
    words: tuple[str, ...] = ()


@dataclass(frozen=True)
class _Source:
    """The number that a condition tests: its path, its type, and the part of a packed value."""

    path: str
    type: Type
    may_be_missing: bool = False
    part: Part | None = None
    is_outside: bool = False

    @property
    def enum(self) -> Enum | None:
        if self.part is not None:
            return self.part.enum
        return self.type if isinstance(self.type, Enum) else None

    @property
    def quantity(self) -> Quantity | None:
        if self.part is not None:
            return self.part.quantity
        return self.type if isinstance(self.type, Quantity) else None

    @property
    def kind(self) -> str:
        """The key in _WORDS; "" if such a value allows no condition."""
        if self.enum is not None:
            return "a flag set" if self.enum.kind == "flags" else "an enum"
        is_integer = isinstance(self.type, (Scalar, Quantity)) and self.limits is not None
        return "an integer" if self.part is not None or is_integer else ""

    @property
    def limits(self) -> tuple[int, int] | None:
        """The lowest and highest number; None if it has none."""
        if self.part is not None and self.part.modulo:
            return 0, self.part.modulo - 1
        if self.part is not None:
            return self.part.limits
        scalar = scalar_of(self.type)
        if scalar is None or scalar.minimum is None or scalar.maximum is None:
            return None
        return scalar.minimum, scalar.maximum

    @property
    def is_wrapped(self) -> bool:
        """True if C++ has the number in a class."""
        is_24 = self.part is None and isinstance(self.type, Scalar) and self.type.size == 3
        return self.quantity is not None or is_24


class ReferenceResolver:
    """Resolves references to earlier fields and contexts; findings go into `found`."""

    def __init__(self, types: TypeResolver, found: Diagnostics) -> None:
        self.types = types
        self.found = found
        self._ids = types.types.enums[VARIABLE_ID]

    def condition(
        self,
        node: Map,
        earlier: list[Field],
        contexts: tuple[Context, ...],
        outside: Outside = Outside(),
    ) -> Condition | None:
        """The condition under `when`, on a context, or on `earlier` or `outside` fields."""
        when = node.get("when")
        return self._condition(when, earlier, contexts, outside) if isinstance(when, Map) else None

    def use(self, node: Map, earlier: list[Field], words: tuple[str, ...]) -> Condition | None:
        """The condition under `used_when`, which may differ between the words of the field's index."""
        when = node.get("used_when")
        return self._condition(when, earlier, (), Outside((), words)) if when else None

    def _condition(
        self, when: Map, earlier: list[Field], contexts: tuple[Context, ...], outside: Outside
    ) -> Condition | None:
        joined = next((word for word in _SEVERAL if word in when), "")
        may_be_missing = bool(when.get("may_be_missing", False))
        condition: Condition | None = None
        before = len(self.found.found)
        if joined:
            terms = [self._condition(term, earlier, (), outside) for term in when[joined]]
            known = tuple(term for term in terms if term is not None)
            if len(known) < len(terms):
                return None
            condition = Condition(
                "", False, None, joined=joined, terms=known, may_be_missing=may_be_missing
            )
        else:
            unknown = {c.name.upper() for c in contexts if c.type is None and c.announced is None}
            if when.get("context") in unknown:
                return None  # the context's unknown type has been reported
            with self.found.at(when):
                source = _source(when, earlier, contexts, outside.fields)
                condition = self._test(when, source, may_be_missing, outside.words)
                if len(self.found.found) == before:
                    _check_sense(condition, source)
        if condition is not None and len(self.found.found) == before and not satisfying(condition):
            hint = "its parts exclude each other"
            self.found.add(when.position, _RULE, "the condition never holds", hint)
            return None
        return condition

    def _test(
        self, when: Map, source: _Source, may_be_missing: bool, words: tuple[str, ...]
    ) -> Condition:
        """A condition on one number, which may differ between the words of an index."""
        _check_words(when, source)
        if not words or not any(_PLACE in str(when.get(word, "")) for word in _ALL):
            return self._one_test(when, source, may_be_missing, "")
        before = len(self.found.found)
        elements = []
        for word in words:
            elements.append((word, self._one_test(when, source, may_be_missing, word)))
            if len(self.found.found) > before:
                break  # the others would say the same
        first = elements[0][1]
        names = iter(str(n) for word in _ALL for n in _listed(when.get(word, [])))
        flags, any_, none, values = (
            tuple(replace(v, name=next(names, "")) for v in listed)
            for listed in (first.flags, first.any_flags, first.no_flags, first.values)
        )
        text = replace(first, flags=flags, any_flags=any_, no_flags=none, values=values).words
        return replace(first, elements=tuple(elements), pattern=text)

    def _one_test(
        self, when: Map, source: _Source, may_be_missing: bool, element: str
    ) -> Condition:
        chosen = {word: self._values(source, when, word, element) for word in _ALL}
        self._check_clauses(when, chosen)
        values = chosen["is"] or chosen["is_not"]
        return Condition(
            source.path,
            "context" in when,
            source.enum,
            flags=chosen["has"],
            any_flags=chosen["any"],
            no_flags=chosen["has_not"],
            numbers=tuple(v if isinstance(v, int) else v.value for v in values),
            values=values if source.enum else (),
            negated="is_not" in when,
            may_be_missing=may_be_missing,
            source_may_be_missing=source.may_be_missing,
            part=source.part,
            is_wrapped=source.is_wrapped,
            at_least=next(iter(chosen["at_least"]), None),
            at_most=next(iter(chosen["at_most"]), None),
            is_outside=source.is_outside,
        )

    def _check_clauses(self, when: Map, chosen: dict[str, tuple[Any, ...]]) -> None:
        """Report clauses without bits, and contradictory ones."""
        for word in ("has", "any", "has_not"):
            if chosen[word] and not any(flag.value for flag in chosen[word]):
                message = f"{chosen[word][0].name} has no bits, so it is always set"
                self.found.add(when.at(word), _RULE, message, "a condition needs bits to look at")
        if "is" in when and "is_not" in when:
            hint = "'is' already excludes all other values"
            self.found.add(when.at("is_not"), _RULE, "'is_not' is beside 'is'", hint)
        for flag in chosen["has_not"]:
            if flag in chosen["has"] or chosen["any"] == (flag,):
                message = f"the condition on {flag.name} never holds"
                hint = "it must be set and must not be set"
                self.found.add(when.at("has_not"), _RULE, message, hint)

    def _values(self, source: _Source, node: Map, key: str, element: str) -> tuple[Any, ...]:
        result = []
        for name in _listed(node.get(key, [])):
            if element and isinstance(name, str):
                name = re.sub(_PLACE + "[A-Z]+}", element, name)
            with self.found.at(node):
                result.append(_value(source, name, node, key))
        return tuple(result)

    def alternative(self, node: Map, siblings: list[Field]) -> Alternative | None:
        """The alternative unit of a field, and the flag that selects it, possibly in its group."""
        other = node.get("alternative")
        if not isinstance(other, Map):
            return None
        types = self.types.types
        with self.found.at(other):
            if other["type"] not in types.quantities:
                hint = did_you_mean(str(other["type"]), types.quantities)
                hint = hint or "name one under 'quantities'"
                raise Mistake("SBGC010", f"unknown quantity '{other['type']}'", hint, "type")
            sets = [enum for enum in types.enums.values() if enum.kind == "flags"]
            flag = next((v for e in sets for v in e.values if v.name == other["flag"]), None)
            if flag is None:
                names = [v.name for enum in types.enums.values() for v in enum.values]
                hint = did_you_mean(str(other["flag"]), names) or "name a value of a flag set"
                raise Mistake(_RULE, f"there is no flag '{other['flag']}'", hint, "flag")
            source = snake_case(str(other["of"]))
            in_group = source in {field.name for field in siblings}
            return Alternative(types.quantities[other["type"]], source, flag.value, flag, in_group)
        return None

    def variable(self, node: Map, earlier: list[Field]) -> str:
        """The earlier field with the id of the adjustable variable whose value this field holds."""
        wanted = str(node.get("variable", ""))
        for field in earlier:
            if wanted and field.spec_name == wanted and field.type == self._ids:
                return field.name
        if wanted:
            message = f"'{wanted}' is not an earlier field of type {VARIABLE_ID}"
            self.found.add(node.at("variable"), _RULE, message)
        return ""


def _listed(said: Any) -> list[Any]:
    return said if isinstance(said, list) else [said]


def _source(
    when: Map, earlier: list[Field], contexts: tuple[Context, ...], outside: tuple[Field, ...]
) -> _Source:
    """The values that a condition depends on."""
    key = "context" if "context" in when else "field"
    wanted = str(when.get(key))
    name = wanted
    known: dict[str, Any] = {}
    if key == "context":
        known = {c.name.upper(): c for c in contexts if c.type is not None}
    else:
        inside = {f.spec_name for f in earlier}
        for is_single in (True, False):  # so that hints name single fields first
            for f in (*earlier, *(f for f in outside if f.spec_name not in inside)):
                if f.dim == "one" if is_single else f.index or f.dim == "fixed":
                    known[f.spec_name] = f
        name = re.split(r"[.\[]", wanted)[0]
    if name not in known:
        hint = did_you_mean(name, known) or f"known here: {', '.join(known) or 'none'}"
        raise Mistake(_RULE, f"'{name}' is not an earlier {key}", hint, key)
    if key == "context":
        source = _Source(known[name].name, known[name].type)
    else:
        source = replace(_at(known[name], wanted), is_outside=name not in inside)
    if not source.kind:
        message = f"'{wanted}' is neither an integer nor a flag set"
        hint = "a condition needs values or flags"
        if isinstance(source.type, Packed):
            hint = f"name a part: {', '.join(f'{wanted}.{p.name}' for p in source.type.parts)}"
        raise Mistake(_RULE, message, hint, key)
    return source


def _at(field: Field, wanted: str) -> _Source:
    """The number at a path that begins with a field: NAME, NAME[2], NAME.yaw, each with .part."""
    path, is_element = field.name, field.dim == "one"
    steps = re.findall(r"\w+", wanted[len(field.spec_name) :])
    for step in steps:
        type_ = field.type
        if not is_element:
            if step.isdigit() and int(step) < field.count and field.dim == "fixed":
                path, is_element = f"{path}[{step}]", True
            elif step.upper() in field.index and field.dim in ("axis", "xyz"):
                path, is_element = f"{path}.{step}", True
            else:
                break
        elif isinstance(type_, Struct) and not type_.is_region:
            inner = next((f for f in type_.fields if step in (f.spec_name, f.name)), None)
            if inner is None or field.may_be_absent:
                break
            field, path, is_element = inner, f"{path}.{inner.name}", inner.dim == "one"
        elif isinstance(type_, Packed) and step is steps[-1]:
            part = next((p for p in type_.parts if p.name == step), None)
            if part is None:
                hint = did_you_mean(step, [p.name for p in type_.parts])
                hint = hint or f"parts: {', '.join(p.name for p in type_.parts)}"
                raise Mistake(_RULE, f"{type_.name} has no part '{step}'", hint, "field")
            return _Source(path, type_, field.may_be_absent, part)
        else:
            break
    else:
        if is_element and (field.dim == "one" or not field.may_be_absent):
            return _Source(path, field.type, field.may_be_absent)
    one = f"{field.spec_name}.{field.index[0].lower()}" if field.index else f"{field.spec_name}[0]"
    hint = f"name one element, such as {one}" if not is_element else "write it like MODE.part"
    if field.dim != "one" and field.may_be_absent:
        hint = "an element of a list that may be missing cannot be looked at"
    raise Mistake(_RULE, f"'{wanted}' is not one number", hint, "field")


def _check_sense(condition: Condition, source: _Source) -> None:
    """A condition on an integer must hold for some of its values, but not for all."""
    if source.enum is not None or source.limits is None:
        return
    lowest, highest = source.limits
    numbers: Iterable[int] = range(lowest, highest + 1)
    if highest - lowest > 255:  # it is decided near the limits and the numbers that are named
        named = {*condition.numbers, condition.at_least or 0, condition.at_most or 0}
        near = {number + step for number in named for step in (-1, 0, 1)}
        numbers = sorted({lowest, highest} | {n for n in near if lowest <= n <= highest})
    holds = {condition.accepts(number) for number in numbers}
    if len(holds) == 1:
        always = "always" if holds == {True} else "never"
        hint = f"the values of '{condition.subject}' are {lowest} to {highest}"
        raise Mistake(_RULE, f"the condition on '{condition.subject}' {always} holds", hint)


def _check_words(when: Map, source: _Source) -> None:
    """A condition must name values of its source, with the words for its kind."""
    wanted, kind = when.get("context", when.get("field")), source.kind
    words = [word for word in _ALL if word in when]
    hint = f"use '{_WORDS[kind][0]}' for it"
    if not words:
        raise Mistake(_RULE, f"the condition on '{wanted}' names no value", hint)
    if not set(words) <= set(_WORDS[kind]):
        raise Mistake(_RULE, f"'{wanted}' is {kind}", hint)


def _value(source: _Source, name: Any, when: Map, key: str) -> Any:
    """A value of an enum or flag set, or a number."""
    enum = source.enum
    if enum is not None:
        by_name = {value.name: value for value in enum.values}
        if name not in by_name:
            hint = did_you_mean(str(name), by_name) or f"see {enum.at}"
            raise Mistake(_RULE, f"{enum.name} has no value '{name}'", hint, key)
        return by_name[name]
    wanted, (lowest, highest) = when.get("field"), source.limits or (0, 0)
    if not isinstance(name, int):
        raise Mistake(_RULE, f"'{name}' is not an integer", f"'{wanted}' has no named values", key)
    if not lowest <= name <= highest:
        scalar = None if source.part else scalar_of(source.type)
        hint = f"its type is {scalar.name}: " if scalar else "its bits hold "
        raise Mistake(_RULE, f"'{wanted}' is never {name}", f"{hint}{lowest} to {highest}", key)
    return name
