"""Resolves references of a field: conditions, flags that select a unit, ids of variables."""

from __future__ import annotations

from typing import Any

from sbgcgen.model import Alternative, Condition, Context, Enum, Field, Scalar, Type
from sbgcgen.model.names import snake_case
from sbgcgen.spec.diagnostics import Diagnostics, did_you_mean
from sbgcgen.spec.load import Map
from sbgcgen.spec.resolve.types import VARIABLE_ID, TypeResolver


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
        from_context = "context" in when
        key = "context" if from_context else "field"
        wanted = str(when.get(key))
        found: dict[str, tuple[str, Type, bool]] = (
            {c.name.upper(): (c.name, c.type, False) for c in contexts if c.type is not None}
            if from_context
            else {f.spec_name: (f.name, f.type, f.may_be_absent) for f in earlier if f.dim == "one"}
        )
        unknown = {c.name.upper() for c in contexts if c.type is None and c.announced is None}
        if from_context and wanted in unknown:
            return None  # the context's unknown type has been reported
        if wanted not in found:
            hint = did_you_mean(wanted, found) or f"known here: {', '.join(found) or 'none'}"
            self.found.add(when.at(key), "SBGC026", f"'{wanted}' is not an earlier {key}", hint)
            return None
        source, type_, conditional = found[wanted]
        kind = _kind(type_)
        words = [word for words in _WORDS.values() for word in words if word in when]
        if not kind:
            message = f"'{wanted}' is neither an integer nor a flag set"
            self.found.add(when.at(key), "SBGC026", message, "a condition needs values or flags")
            return None
        if not words:
            message = f"the condition on '{wanted}' names no value"
            self.found.add(when.position, "SBGC026", message, f"use '{_WORDS[kind][0]}' for it")
            return None
        if any(word not in _WORDS[kind] for word in words):
            message = f"'{wanted}' is {kind}"
            hint = f"use '{_WORDS[kind][0]}' for it"
            self.found.add(when.position, "SBGC026", message, hint)
            return None
        enum = type_ if isinstance(type_, Enum) else None
        chosen = {word: self._values(type_, when, word) if word in when else () for word in _ALL}
        for word in words:
            if kind == "a flag set" and chosen[word] and not any(v.value for v in chosen[word]):
                message = f"{chosen[word][0].name} has no bits, so it is always set"
                hint = "a condition needs bits to look at"
                self.found.add(when.at(word), "SBGC026", message, hint)
        self._check_clauses(when, chosen)
        values = chosen["is"] or chosen["is_not"]
        return Condition(
            source,
            from_context,
            enum,
            flags=chosen["has"],
            any_flags=chosen["any"],
            no_flags=chosen["has_not"],
            numbers=tuple(v if isinstance(v, int) else v.value for v in values),
            values=values if enum else (),
            negated="is_not" in when,
            may_be_missing=bool(when.get("may_be_missing", False)),
            source_may_be_missing=conditional,
        )

    def _check_clauses(self, when: Map, chosen: dict[str, tuple[Any, ...]]) -> None:
        """Report clauses that contradict each other."""
        if "is" in when and "is_not" in when:
            hint = "'is' already excludes all other values"
            self.found.add(when.at("is_not"), "SBGC026", "'is_not' stands beside 'is'", hint)
        for flag in chosen["has_not"]:
            if flag in chosen["has"] or chosen["any"] == (flag,):
                message = f"the condition on {flag.name} never holds"
                hint = "it must be set and must not be set"
                self.found.add(when.at("has_not"), "SBGC026", message, hint)

    def _values(self, type_: Type, node: Map, key: str) -> tuple[Any, ...]:
        names = node[key] if isinstance(node[key], list) else [node[key]]
        enum = type_ if isinstance(type_, Enum) else None
        if enum is None:
            assert isinstance(type_, Scalar)
            for name in names:
                if not isinstance(name, int):
                    message = f"'{name}' is not an integer"
                    hint = f"'{node.get('field')}' has no named values"
                    self.found.add(node.at(key), "SBGC026", message, hint)
                elif not type_.holds(name):
                    message = f"'{node.get('field')}' is never {name}"
                    hint = f"its type is {type_.name}: {type_.minimum} to {type_.maximum}"
                    self.found.add(node.at(key), "SBGC026", message, hint)
            return tuple(name for name in names if isinstance(name, int))
        by_name = {v.name: v for v in enum.values}
        for name in names:
            if name not in by_name:
                hint = did_you_mean(str(name), by_name) or f"see {enum.at}"
                self.found.add(node.at(key), "SBGC026", f"{enum.name} has no value '{name}'", hint)
        return tuple(by_name[n] for n in names if n in by_name)

    def alternative(self, node: Map) -> Alternative | None:
        """The alternative unit of a field, and the flag that selects it."""
        other = node.get("alternative")
        if not isinstance(other, Map):
            return None
        quantity = self.types.types.quantities.get(str(other["type"]))
        if quantity is None:
            hint = did_you_mean(str(other["type"]), self.types.types.quantities)
            hint = hint or "name one under 'quantities'"
            self.found.add(other.at("type"), "SBGC010", f"unknown quantity '{other['type']}'", hint)
            return None
        for enum in self.types.types.enums.values():
            for value in enum.values if enum.kind == "flags" else ():
                if value.name == other["flag"]:
                    return Alternative(quantity, snake_case(str(other["of"])), value.value, value)
        flags = [v.name for e in self.types.types.enums.values() for v in e.values]
        hint = did_you_mean(str(other["flag"]), flags) or "name a value of a flag set"
        self.found.add(other.at("flag"), "SBGC026", f"there is no flag '{other['flag']}'", hint)
        return None

    def variable(self, node: Map, earlier: list[Field]) -> str:
        """The earlier field with the id of the adjustable variable whose value this field holds."""
        wanted = str(node.get("variable", ""))
        for field in earlier:
            if wanted and field.spec_name == wanted and field.type == self._ids:
                return field.name
        if wanted:
            message = f"'{wanted}' is not an earlier field of type {VARIABLE_ID}"
            self.found.add(node.at("variable"), "SBGC026", message)
        return ""
