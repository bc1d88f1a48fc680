"""The model as plain data: generated/simplebgc.json, for tools in any language."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from sbgcgen.model import (
    Announced,
    Answer,
    AnswerCase,
    Availability,
    Condition,
    Context,
    Effect,
    Enum,
    Field,
    Layout,
    Leaf,
    Message,
    Packed,
    Quantity,
    Role,
    Until,
    element_of,
)

# Words for forms that readers of the export may rely on.
_FORMS = ("simple", "extended", "success", "error")


def _number(value: Fraction | None) -> int | float | None:
    if value is None:
        return None
    return int(value) if value.denominator == 1 else float(value)


def _version(since: Availability) -> dict[str, str] | None:
    if not since:
        return None
    result = {}
    if since.firmware:
        beta = since.firmware % 10
        text = f"{since.firmware // 1000}.{since.firmware // 10 % 100:02}"
        result["firmware"] = f"{text}b{beta}" if beta else text
    if since.board:
        result["board"] = f"{since.board // 10}.{since.board % 10}"
    return result


def _until(until: Until | None) -> dict[str, str | None] | None:
    if until is None:
        return None
    return {**(_version(until.versions) or {}), "instead": until.instead or None}


def _enum_name(field: Field) -> str | None:
    return field.type.name if isinstance(field.type, Enum) else None


def _condition(when: Condition | None) -> dict[str, Any] | None:
    if when is None:
        return None
    return {
        "context" if when.from_context else "field": when.source,
        "has": [f.name for f in when.flags],
        "is": [v.name for v in when.values],
        "may_be_missing": when.may_be_missing,
    }


def _leaf(leaf: Leaf) -> dict[str, Any]:
    field = leaf.field
    quantity = field.type if isinstance(field.type, Quantity) else None
    result: dict[str, Any] = {
        "path": leaf.path,
        "spec_name": leaf.spec_name,
        "offset": leaf.offset,
        "type": leaf.type,
        "count": leaf.count,
        "unit": quantity.unit if quantity else None,
        "scale": _number(quantity.scale) if quantity else None,
        "min": _number(field.minimum),
        "max": _number(field.maximum),
        "enum": _enum_name(field),
        "reserved": field.reserved,
        "summary": field.summary,
    }
    if quantity:
        result["quantity"] = quantity.name
        result["scale_exact"] = str(quantity.scale)
        if quantity.offset:
            result["add"] = _number(quantity.offset)
    if isinstance(field.type, Announced):
        result["announced"] = field.type.context
    if isinstance(field.type, Packed):
        result["packed"] = field.type.name
    if field.special:
        result["special"] = {str(s.value): s.meaning for s in field.special}
    if any(s.name for s in field.special):
        result["special_names"] = {str(s.value): s.name for s in field.special if s.name}
    if field.min_count and not field.index:
        result["min_count"] = field.min_count
    if leaf.optional:
        result["may_be_missing"] = True
    if field.max_count is not None and not field.index:
        result["max_count"] = field.max_count
    if field.align != 1:
        result["align"] = field.align
    if field.role:
        result["role"] = field.role
    if field.variable:
        result["value_of_variable"] = field.variable
    if field.counter:
        result["counted_by"] = field.counter
    if field.when:
        result["when"] = _condition(field.when)
    if field.alternative:
        other = field.alternative
        result["alternative"] = {
            "unit": other.quantity.unit,
            "scale": _number(other.quantity.scale),
            "flag": other.flag.name,
            "field": other.source,
        }
    if field.since:
        result["since"] = _version(field.since)
    if field.typical is not None:
        result["typical"] = element_of(field.typical, leaf.path)
    if field.deprecated:
        result["deprecated"] = {
            "since": _version(field.deprecated.since),
            "replaced_by": field.deprecated.replaced_by or None,
        }
    if field.errata:
        result["errata"] = list(field.errata)
    if leaf.cases:
        result["cases"] = [_leaf(case) for case in leaf.cases]
    return result


def _answer(answer: Answer | None) -> dict[str, Any] | None:
    """What holds of all cases, then the cases one by one."""
    if answer is None:
        return None
    return {
        "messages": list(answer.messages),
        "confirm": answer.confirm,
        "confirmations": answer.confirmations,
        "timeout_ms": answer.timeout_ms,
        "retry": "safe" if answer.retry_safe else "unsafe",
        "certain": answer.is_certain,
        "cases": [_case(case) for case in answer.cases],
    }


def _case(case: AnswerCase) -> dict[str, Any]:
    result: dict[str, Any] = {
        "when": _condition(case.when),
        "messages": list(case.messages),
        "confirm": case.confirm,
        "confirmations": case.confirmations,
        "timeout_ms": case.timeout_ms,
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
    if case.confirmation:
        repeated = case.confirmation
        result["confirmation_correlation"] = {
            "field": repeated.field.name,
            "offset": repeated.offset,
        }
    if case.result:
        found = case.result
        result["confirmation_result"] = {
            "field": found.field.name,
            "offset": found.offset,
            "success": found.success.name,
        }
    return result


def _role(role: Role | None) -> dict[str, Any] | None:
    if role is None:
        return None
    result: dict[str, Any] = {"is": role.kind}
    result.update({part: field.name for part, field in role.parts.items()})
    if role.kind == "stream_request":
        result.update(
            messages=list(role.messages),
            interval_us=role.interval_us,
            end=role.end,
            cycle=role.cycle,
            cycle_us=role.cycle_us,
            limit=role.limit or None,
        )
    if role.kind == "reset":
        result["delay_ms"] = role.delay_ms
    return result


def _effect(effect: Effect | None) -> dict[str, Any] | None:
    """All that a request may do, then case by case."""
    if effect is None:
        return None
    cases = [{"when": _condition(case.when), "does": list(case.words)} for case in effect.cases]
    return {"does": list(effect.words), "cases": cases}


def _context(context: Context) -> dict[str, Any]:
    if context.announced is None:
        sources = [f"{message}.{field}" for message, field in context.sources]
        enum = context.type.name if context.type else None
        return {"name": context.name, "enum": enum, "from": sources}
    announced = context.announced
    return {
        "name": context.name,
        "announced_by": f"{announced.message}.{announced.list}",
        "kind": announced.kind,
        "count": announced.count,
    }


def _form(name: str | None) -> str | None:
    """The kind of a form. Beside those of the protocol, all forms are later, longer ones."""
    return name if name in (None, *_FORMS) else "extended"


def _message(message: Message) -> dict[str, Any]:
    return {
        "name": message.name,
        "command": message.command,
        "id": message.id,
        "direction": message.direction,
        "form": _form(message.form),
        **({"form_name": message.form} if message.form else {}),
        "family": message.family,
        "summary": message.summary,
        "source": message.source,
        "errata": list(message.errata),
        "since": _version(message.since),
        "until": _until(message.until),
        "min_size": message.min_size,
        "max_size": message.max_size,
        "keeps_tail": message.keeps_tail,
        "same_as": message.same_as or None,
        "stores": message.stores or None,
        "effect": _effect(message.effect),
        "role": _role(message.role),
        "context": [_context(context) for context in message.contexts],
        "response": _answer(message.answer),
        "layout": [_leaf(leaf) for leaf in message.leaves],
    }


def _enum(enum: Enum) -> dict[str, Any]:
    return {
        "name": enum.name,
        "kind": enum.kind,
        "width": enum.scalar.size,
        "type": enum.scalar.name,
        "summary": enum.summary,
        "source": enum.source,
        "errata": list(enum.errata),
        "success": enum.success.name if enum.success else None,
        "values": [
            {
                "name": value.name,
                "value": value.value,
                "identifier": value.identifier,
                "named_by_specification": not value.ours,
                "summary": value.summary,
                "since": _version(value.since),
                "errata": list(value.errata),
                "number": value.number,
            }
            for value in enum.values
        ],
    }


def _packed(packed: Packed) -> dict[str, Any]:
    return {
        "name": packed.name,
        "width": packed.scalar.size,
        "summary": packed.summary,
        "source": packed.source,
        "names": packed.names.name if packed.names else None,
        "main": packed.main.name if packed.main else None,
        "parts": [
            {
                "name": part.name,
                "mask": None if part.is_digits else part.mask,
                "shift": None if part.is_digits else part.shift,
                "divide": part.divide if part.is_digits else None,
                "modulo": part.modulo if part.is_digits else None,
                "enum": part.enum.name if part.enum else None,
                "summary": part.summary,
            }
            for part in packed.parts
        ],
    }


def export(layout: Layout) -> dict[str, Any]:
    """Everything the model knows, ready for JSON."""
    return {
        "protocol": layout.protocol,
        "framing": {
            "start": layout.framing.start,
            "header_size": layout.framing.header_size,
            "trailer_size": layout.framing.trailer_size,
            "max_body": layout.framing.max_body,
        },
        "line": {
            "baud_rates": list(layout.line.baud_rates),
            "named_baud_rates": list(layout.line.baud_rates[: layout.line.named]),
            "parities": list(layout.line.parities),
            "shortest_pause_ms": layout.line.shortest_pause_ms,
            "longest_pause_ms": layout.line.longest_pause_ms,
            "source": layout.line.source,
            "errata": list(layout.line.errata),
        },
        "revisions": [
            {
                "number": revision.number,
                "date": revision.date,
                "source": revision.source,
                "adds": [addition.text for addition in revision.adds],
                "changes": list(revision.changes),
            }
            for revision in layout.revisions
        ],
        "timeouts": {"errata": list(layout.timeout_errata)},
        "commands": [
            {
                "name": command.name,
                "id": command.id,
                "family": command.family,
                "summary": command.summary,
                "since": _version(command.since),
                "documented": not command.undocumented,
            }
            for command in layout.commands
        ],
        "messages": [_message(message) for message in layout.messages],
        "enums": [_enum(enum) for enum in layout.enums],
        "packed": [_packed(packed) for packed in layout.packed],
        "quantities": [
            {
                "name": q.name,
                "type": q.scalar.name,
                "unit": q.unit,
                "scale": _number(q.scale),
                "scale_exact": str(q.scale),
                "offset": _number(q.offset),
                "summary": q.summary,
            }
            for q in layout.quantities
        ],
        "adjustable_variables": [
            {
                "name": variable.name,
                "id": variable.id,
                "type": variable.scalar.name,
                "min": variable.minimum,
                "max": variable.maximum,
                "unit": variable.quantity.unit if variable.quantity else None,
                "scale": _number(variable.quantity.scale) if variable.quantity else None,
                "add": _number(variable.quantity.offset) if variable.quantity else None,
                "summary": variable.summary,
                "sets": [
                    {
                        "message": setting.message,
                        "path": setting.path,
                        "scale_exact": str(setting.scale),
                        "add_exact": str(setting.offset),
                    }
                    for setting in variable.settings
                ],
                "as_switch": variable.is_switch,
            }
            for variable in layout.variables
        ],
        "errata": [
            {
                "number": erratum.number,
                "kind": erratum.kind,
                "lines": list(erratum.lines),
                "problem": erratum.problem,
                "reading": erratum.reading,
                "reason": erratum.reason or None,
            }
            for erratum in layout.errata
        ],
    }
