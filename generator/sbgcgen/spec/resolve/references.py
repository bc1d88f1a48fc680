"""Resolves references of a field: conditions, flags that select a unit, ids of variables."""

from __future__ import annotations

from typing import Any

from sbgcgen.model import Alternative, Condition, Context, Enum, Field, Scalar, Type
from sbgcgen.model.names import snake_case
from sbgcgen.spec.diagnostics import Diagnostics, Mistake, did_you_mean
from sbgcgen.spec.load import Map
from sbgcgen.spec.resolve.types import VARIABLE_ID, TypeResolver

_RULE = "SBGC026"
# The words of conditions on each kind of value.
_WORDS = {
    "a flag set": ("has", "any", "has_not"),
    "an enum": ("is", "is_not"),
    "an integer": ("is", "is_not"),
}
_ALL = tuple(dict.fromkeys(word for words in _WORDS.values() for word in words))


def _kind(type_: Type | None) -> str:
    if isinstance(type_, Enum):
        return "a flag set" if type_.kind == "flags" else "an enum"
    return "an integer" if isinstance(type_, Scalar) and not type_.is_float else ""


class ReferenceResolver:
    """Resolves references to earlier fields and contexts; findings go into `found`."""

    def __init__(self, types: TypeResolver, found: Diagnostics) -> None:
        self.types = types
        self.found = found
        self._ids = types.types.enums[VARIABLE_ID]

    def condition(
        self, node: Map, earlier: list[Field], contexts: tuple[Context, ...]
    ) -> Condition | None:
        """The condition under `when`, which refers to a context or one of the `earlier` fields."""
        when = node.get("when")
        if not isinstance(when, Map):
            return None
        unknown = {c.name.upper() for c in contexts if c.type is None and c.announced is None}
        if when.get("context") in unknown:
            return None  # the context's unknown type has been reported
        with self.found.at(when):
            source, type_, may_be_missing = _source(when, earlier, contexts)
            _check_words(when, type_)
            chosen = {word: self._values(type_, when, word) for word in _ALL}
            self._check_clauses(when, chosen)
            enum = type_ if isinstance(type_, Enum) else None
            values = chosen["is"] or chosen["is_not"]
            return Condition(
                source,
                "context" in when,
                enum,
                flags=chosen["has"],
                any_flags=chosen["any"],
                no_flags=chosen["has_not"],
                numbers=tuple(v if isinstance(v, int) else v.value for v in values),
                values=values if enum else (),
                negated="is_not" in when,
                may_be_missing=bool(when.get("may_be_missing", False)),
                source_may_be_missing=may_be_missing,
            )
        return None

    def _check_clauses(self, when: Map, chosen: dict[str, tuple[Any, ...]]) -> None:
        """Report clauses without bits, and those that contradict each other."""
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

    def _values(self, type_: Type, node: Map, key: str) -> tuple[Any, ...]:
        said = node.get(key, [])
        result = []
        for name in said if isinstance(said, list) else [said]:
            with self.found.at(node):
                result.append(_value(type_, name, node, key))
        return tuple(result)

    def alternative(self, node: Map) -> Alternative | None:
        """The alternative unit of a field, and the flag that selects it."""
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
            return Alternative(types.quantities[other["type"]], source, flag.value, flag)
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


def _source(
    when: Map, earlier: list[Field], contexts: tuple[Context, ...]
) -> tuple[str, Type, bool]:
    """What a condition looks at: its name and type, and whether it may be missing."""
    key = "context" if "context" in when else "field"
    known: dict[str, tuple[str, Type, bool]]
    if key == "context":
        known = {c.name.upper(): (c.name, c.type, False) for c in contexts if c.type is not None}
    else:
        known = {f.spec_name: (f.name, f.type, f.may_be_absent) for f in earlier if f.dim == "one"}
    wanted = str(when.get(key))
    if wanted not in known:
        hint = did_you_mean(wanted, known) or f"known here: {', '.join(known) or 'none'}"
        raise Mistake(_RULE, f"'{wanted}' is not an earlier {key}", hint, key)
    if not _kind(known[wanted][1]):
        message = f"'{wanted}' is neither an integer nor a flag set"
        raise Mistake(_RULE, message, "a condition needs values or flags", key)
    return known[wanted]


def _check_words(when: Map, type_: Type) -> None:
    """A condition names values of its source, with the words for its kind."""
    wanted, kind = when.get("context", when.get("field")), _kind(type_)
    words = [word for word in _ALL if word in when]
    hint = f"use '{_WORDS[kind][0]}' for it"
    if not words:
        raise Mistake(_RULE, f"the condition on '{wanted}' names no value", hint)
    if not set(words) <= set(_WORDS[kind]):
        raise Mistake(_RULE, f"'{wanted}' is {kind}", hint)


def _value(type_: Type, name: Any, when: Map, key: str) -> Any:
    """A value of an enum or flag set, or a number."""
    if isinstance(type_, Enum):
        by_name = {value.name: value for value in type_.values}
        if name not in by_name:
            hint = did_you_mean(str(name), by_name) or f"see {type_.at}"
            raise Mistake(_RULE, f"{type_.name} has no value '{name}'", hint, key)
        return by_name[name]
    assert isinstance(type_, Scalar)
    if not isinstance(name, int):
        hint = f"'{when.get('field')}' has no named values"
        raise Mistake(_RULE, f"'{name}' is not an integer", hint, key)
    if not type_.holds(name):
        hint = f"its type is {type_.name}: {type_.minimum} to {type_.maximum}"
        raise Mistake(_RULE, f"'{when.get('field')}' is never {name}", hint, key)
    return name
