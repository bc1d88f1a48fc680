"""Messages as plain data."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

from sbgcgen.model import Alternative, Announced, Answer, AnswerCase, Blob, Condition, Context
from sbgcgen.model import Effect, Enum, Field, Layout, Leaf, Message, Packed, Quantity, Role
from sbgcgen.model import StopValue, Struct, Until, element_of, field_rules
from sbgcgen.model.export.types import deprecation, exponential, former_names, given, later_json
from sbgcgen.model.export.types import number, attributes, version

# Forms that users of the export may rely on.
_FORMS = ("simple", "extended", "success", "error")


def _until(until: Until | None) -> dict[str, str | None] | None:
    if until is None:
        return None
    return {**(version(until.versions) or {}), "instead": until.instead or None}


def _condition(when: Condition | None) -> dict[str, Any] | None:
    if when is None:
        return None
    if when.terms:
        terms = [_condition(term) for term in when.terms]
        return {when.joined: terms, "may_be_missing": when.may_be_missing}
    result: dict[str, Any] = {
        "context" if when.from_context else "field": when.source,
        "has": [f.name for f in when.flags],
        "is": [] if when.negated else _accepted(when),
        "may_be_missing": when.may_be_missing,
    }
    if when.any_flags:
        result["any"] = [f.name for f in when.any_flags]
    if when.no_flags:
        result["has_not"] = [f.name for f in when.no_flags]
    if when.negated:
        result["is_not"] = _accepted(when)
    part = when.part.name if when.part else None
    return result | given(part=part, at_least=when.at_least, at_most=when.at_most)


def _accepted(when: Condition) -> list[Any]:
    return [v.name for v in when.values] if when.enum else list(when.numbers)


def _alternative(other: Alternative | None, path: str) -> dict[str, Any] | None:
    if other is None:
        return None
    return {
        **attributes(other.quantity, "unit", "scale"),
        "flag": other.flag.name,
        "field": (path.rpartition(".")[0] + "." if other.in_group else "") + other.source,
    }


def _counted_in(field: Field) -> str | None:
    return field.counting if field.counting != "elements" else None


def _leaf(leaf: Leaf) -> dict[str, Any]:
    field, type_ = leaf.field, leaf.field.type
    quantity = type_ if isinstance(type_, Quantity) else None
    result: dict[str, Any] = {
        "path": leaf.path,
        "spec_name": leaf.spec_name,
        "offset": leaf.offset,
        "type": leaf.type,
        "count": leaf.count,
        "unit": quantity.unit if quantity else None,
        "scale": number(quantity.scale) if quantity else None,
        "min": number(field.minimum),
        "max": number(field.maximum),
        "enum": type_.name if isinstance(type_, Enum) else None,
        "reserved": field.reserved,
        "summary": field.summary,
    }
    if quantity:
        result.update(quantity=quantity.name, scale_exact=str(quantity.scale))
        result.update(given(add=number(quantity.offset) or None), **exponential(quantity))
    if field.directions is not None:
        result["positive"] = leaf.direction and leaf.direction.positive
    if field.saved_as != "":
        result["saved_as"] = field.saved_as
    return result | given(
        saved_in=field.saved_in or None,
        announced=type_.context if isinstance(type_, Announced) else None,
        packed=type_.name if isinstance(type_, Packed) else None,
        special={str(s.value): s.meaning for s in field.special} or None,
        special_names={str(s.value): s.name for s in field.special if s.name} or None,
        element_count=leaf.each,
        max_length=type_.size if isinstance(type_, Blob) and type_.kind == "string" else None,
        is_list=True if field.scalar and field.count == 1 and field.dim == "fixed" else None,
        min_count=None if field.index else field.min_count or None,
        may_be_missing=leaf.optional or None,
        fits=field.fits or None,
        secret=field.secret or None,
        max_count=None if field.index else field.max_count,
        align=field.align if field.align != 1 else None,
        role=field.role or None,
        value_of_variable=field.variable or None,
        counted_by=field.counter or None,
        counted_by_part=field.counter_part.name if field.counter_part else None,
        counted_in=_counted_in(field),
        when=_condition(leaf.when),
        used_when=_condition(leaf.used_when),
        alternative=_alternative(field.alternative, leaf.path),
        since=version(field.since),
        later=later_json(field.later),
        needs=field.needs or None,
        typical=None if field.typical is None else element_of(field.typical, leaf.path),
        deprecated=deprecation(field.deprecated),
        default=field.default or None,
        constant=field.default if field.constant else None,
        formerly=former_names(field.aliases),
        unconfirmed=field.unconfirmed or None,
        errata=list(field.errata) or None,
        cases=[_leaf(case) for case in leaf.cases] or None,
    )


def _answer(answer: Answer | None) -> dict[str, Any] | None:
    """The summary of all cases, then each case."""
    if answer is None:
        return None
    return {
        **attributes(answer, "messages", "confirm", "confirmations", "timeout_ms"),
        "retry": "safe" if answer.retry_safe else "unsafe",
        "certain": answer.is_certain,
        "cases": [_case(case) for case in answer.cases],
    }


def _case(case: AnswerCase) -> dict[str, Any]:
    result: dict[str, Any] = {
        "when": _condition(case.when),
        "messages": list(case.messages),
        "series": case.series or None,
        **attributes(case, "confirm", "confirmations", "timeout_ms"),
        "finish_ms": case.finish_ms or case.timeout_ms,
        "retry": "safe" if case.retry_safe else "unsafe",
        "restarts_board": case.restarts,
        "correlation": [
            {"field": repeated.field.name, "message": response.message, "offset": repeated.offset}
            for response in case.responses
            for repeated in response.correlation
        ],
        "errata": list(case.errata),
    }
    if repeated := case.confirmation:
        place = {"field": repeated.field.name, "offset": repeated.offset}
        result["confirmation_correlation"] = place
    if found := case.result:
        place = {"field": found.field.name, "offset": found.offset}
        result["confirmation_result"] = place | {"success": found.success.name}
    return result


def _role(role: Role | None) -> dict[str, Any] | None:
    if role is None:
        return None
    result: dict[str, Any] = {"is": role.kind}
    result.update({part: field.name for part, field in role.parts.items()})
    if role.kind == "stream_request":
        result |= attributes(role, "messages", "interval_us", "end", "cycle", "cycle_us")
        result["limit"] = role.limit or None
    if role.kind == "reset":
        result["delay_ms"] = role.delay_ms
    return result


def _effect(effect: Effect | None) -> dict[str, Any] | None:
    """All effects of a request, then each case."""
    if effect is None:
        return None
    cases = [{"when": _condition(case.when), "does": list(case.words)} for case in effect.cases]
    return {"does": list(effect.words), "cases": cases}


def _stop_value(value: StopValue) -> dict[str, Any]:
    return attributes(value, "path", "value", *(["mask"] if value.mask else []))


def _context(context: Context, message: Message) -> dict[str, Any]:
    common = {"name": context.name, "summary": context.summary}
    for field in message.fields:
        if field.repeats_context and field.when and field.when.source == context.name:
            common["repeated_by"] = field.name
    if context.announced is None:
        sources = [f"{message}.{field}" for message, field in context.sources]
        enum = context.type.name if context.type else None
        return {**common, "enum": enum, "from": sources}
    announced = context.announced
    place = {"announced_by": f"{announced.message}.{announced.list}"}
    return common | place | attributes(announced, "kind", "count")


def _groups(fields: tuple[Field, ...], path: str = "") -> Iterator[tuple[str, Field]]:
    """The groups of fields with facts of their own, and their paths."""
    for field in fields:
        name = path + field.name
        is_list = isinstance(field.type, Struct) and field.dim in ("counted", "rest")
        says = (
            field.may_be_absent or field.since or field.needs or field.unconfirmed or field.aliases
        )
        if (isinstance(field.type, Struct) or field.index) and (says or is_list):
            yield name, field
        if isinstance(field.type, Struct):
            yield from _groups(field.type.fields, f"{name}.")


def _group(path: str, field: Field) -> dict[str, Any]:
    """The facts about all fields of a group."""
    return given(
        path=path,
        when=_condition(field.when),
        may_be_missing=field.appended or None,
        element_sizes=_element_sizes(field),
        counted_by=field.counter or None,
        counted_by_part=field.counter_part.name if field.counter_part else None,
        counted_in=_counted_in(field),
        min_count=None if field.index else field.min_count or None,
        max_count=None if field.index else field.max_count,
        since=version(field.since),
        needs=field.needs or None,
        unconfirmed=field.unconfirmed or None,
        formerly=former_names(field.aliases),
    )


def _leaf_in(leaf: Leaf, groups: list[tuple[str, Field]]) -> dict[str, Any]:
    """A leaf of a message, including the facts of its groups."""
    result = _leaf(leaf)
    path = re.sub(r"\[\d*\]", "", leaf.path)
    for group in (field for name, field in groups if path.startswith(f"{name}.")):
        if isinstance(group.type, Struct) and group.may_be_absent:
            result["may_be_missing"] = True
        if group.counter and leaf.field.dim not in ("counted", "rest"):
            part = group.counter_part.name if group.counter_part else None
            result["counted_by"] = group.counter
            result.update(given(counted_by_part=part, counted_in=_counted_in(group)))
    return result


def _element_sizes(field: Field) -> list[int] | None:
    """The sizes that the elements of a list have had, if it grew."""
    return list(field.type.element_sizes) or None if isinstance(field.type, Struct) else None


def _form(name: str | None) -> str | None:
    """The kind of a form. Forms with other names are later, longer ones."""
    return name if name in (None, *_FORMS) else "extended"


def message_json(message: Message, layout: Layout) -> dict[str, Any]:
    """A message of the layout as plain data."""
    groups = list(_groups(message.fields))
    result = {
        **attributes(message, "name", "command", "id", "direction"),
        "form": _form(message.form),
        **({"form_name": message.form} if message.form else {}),
        **attributes(message, "family", "summary"),
        "description": message.description or None,
        **attributes(message, "source", "errata", "since"),
        "until": _until(message.until),
        "deprecated": deprecation(message.deprecated),
        **attributes(message, "min_size", "max_size", "keeps_tail", "takes_surplus"),
        "same_as": message.same_as or None,
        "stores": message.stores or None,
        "effect": _effect(message.effect),
        "role": _role(message.role),
        "context": [_context(context, message) for context in message.contexts],
        "response": _answer(message.answer),
        "layout": [
            _leaf_in(leaf, groups)
            | given(topics=[topic.name for topic in layout.topics_of(leaf.field)] or None)
            for leaf in message.leaves
        ],
    }
    sizes = [{"since": version(since), "size": size} for since, size in message.lengths]
    asked = layout.asked_forms(message)
    return result | given(
        asked_by=asked.asks_for(message) if asked else None,
        stops=[[_stop_value(value) for value in pattern] for pattern in message.stops] or None,
        preparation=message.preparation or None,
        needs=message.needs or None,
        unconfirmed=message.unconfirmed or None,
        groups=[_group(path, field) for path, field in groups] or None,
        sizes=sizes or None,
        rules=[rule.text(path) for path, rule in field_rules(message.body)] or None,
    )
