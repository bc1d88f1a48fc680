"""Versions, numbers and types as plain data."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from sbgcgen.model.values import Alias, Availability, Deprecation, Enum, EnumValue, Packed, Part
from sbgcgen.model.values import Quantity
from sbgcgen.model.bodies import Later
from sbgcgen.model.variables import Variable


def number(value: Fraction | None) -> int | float | None:
    """An exact number as a JSON number."""
    if value is None:
        return None
    return int(value) if value.denominator == 1 else float(value)


def version(since: Availability) -> dict[str, str] | None:
    """The versions of an availability; None if always available."""
    if not since:
        return None
    return dict(since.words)


def deprecation(mark: Deprecation | None) -> dict[str, Any] | None:
    """The versions and the replacement of a deprecation."""
    if mark is None:
        return None
    return {"since": version(mark.since), "replaced_by": mark.replaced_by or None}


def former_names(aliases: tuple[Alias, ...]) -> list[str] | None:
    """The former names of something; None if it has none."""
    return [alias.spec_name for alias in aliases] or None


def attributes(thing: Any, *names: str) -> dict[str, Any]:
    """The attributes with these names: keys that are called as in the model."""
    return {name: _plain(getattr(thing, name)) for name in names}


def _plain(value: Any) -> Any:
    if isinstance(value, Availability):
        return version(value)
    if isinstance(value, tuple):
        return list(value)
    return number(value) if isinstance(value, Fraction) else value


def given(**values: Any) -> dict[str, Any]:
    """The values that are not None, for keys that most objects lack."""
    return {key: value for key, value in values.items() if value is not None}


def _value(value: EnumValue) -> dict[str, Any]:
    former = value.former
    return {
        **attributes(value, "name", "value", "identifier"),
        "named_by_specification": not value.ours,
        **attributes(value, "summary", "since", "errata", "number"),
        "number_type": value.wire or None,
    } | given(
        formerly=former_names(value.aliases),
        unconfirmed=value.unconfirmed or None,
        saved_as=value.saved_as or None,
        needs=value.needs or None,
        before={**(version(former.firmware) or {}), "summary": former.summary} if former else None,
    )


def enum_json(enum: Enum) -> dict[str, Any]:
    """An enum or flag set as plain data."""
    return {
        **attributes(enum, "name", "kind"),
        "width": enum.scalar.size,
        "type": enum.scalar.name,
        **attributes(enum, "summary", "source", "errata"),
        "success": enum.success.name if enum.success else None,
        "values": [_value(value) for value in enum.values],
    }


def packed_json(packed: Packed) -> dict[str, Any]:
    """A packed integer as plain data."""
    later = {"from": packed.later_from, "display": packed.later_display}
    return {
        "name": packed.name,
        "width": packed.scalar.size,
        **attributes(packed, "summary", "source", "errata"),
        "names": packed.names.name if packed.names else None,
        "display": packed.display or None,
        **({"later_display": later} if packed.later_display else {}),
        "main": packed.main.name if packed.main else None,
        "parts": [_part(part) for part in packed.parts],
    }


def _part(part: Part) -> dict[str, Any]:
    result: dict[str, Any] = {
        "name": part.name,
        "mask": None if part.is_digits else part.mask,
        "shift": None if part.is_digits else part.shift,
        "divide": part.divide if part.is_digits else None,
        "modulo": part.modulo if part.is_digits else None,
        "enum": part.enum.name if part.enum else None,
        "summary": part.summary,
    }
    result |= given(
        signed=part.signed or None, sign=part.sign or None, saved_as=part.saved_as or None
    )
    if part.quantity:
        result["quantity"] = part.quantity.name
        result |= {**attributes(part.quantity, "unit", "scale"), **exponential(part.quantity)}
    return result


def exponential(quantity: Quantity | None) -> dict[str, Any]:
    """The growth of an exponential quantity: real = scale * ratio^(raw / over) + offset."""
    if quantity is None or not quantity.ratio:
        return {}
    return {"exponential": {"ratio": number(quantity.ratio), "over": quantity.over}}


def later_json(later: tuple[Later, ...]) -> list[dict[str, Any]] | None:
    """The meanings in later firmware; None if there are none."""
    return [_later(one) for one in later] or None


def _later(later: Later) -> dict[str, Any]:
    type_ = later.type
    quantity = type_ if isinstance(type_, Quantity) else None
    return {
        "since": version(later.since),
        **_unit(quantity),
        **exponential(quantity),
        "min": number(later.minimum),
        "max": number(later.maximum),
        "summary": later.summary,
    } | given(
        quantity=quantity.name if quantity else None,
        enum=type_.name if isinstance(type_, Enum) else None,
        packed=type_.name if isinstance(type_, Packed) else None,
    )


def _unit(quantity: Quantity | None) -> dict[str, Any]:
    """The unit of raw * scale + add."""
    if quantity is None:
        return dict.fromkeys(("unit", "scale", "add"))
    return {**attributes(quantity, "unit", "scale"), "add": number(quantity.offset)}


def quantity_json(q: Quantity) -> dict[str, Any]:
    """A quantity as plain data."""
    return {
        "name": q.name,
        "type": q.scalar.name,
        **attributes(q, "unit", "scale"),
        "scale_exact": str(q.scale),
        **attributes(q, "offset"),
        **exponential(q),
        "summary": q.summary,
        **({"directed": True} if q.is_directed else {}),
        "errata": list(q.errata),
    }


def variable_json(variable: Variable) -> dict[str, Any]:
    """An adjustable variable and the parameters that it sets, as plain data."""
    result = {
        **attributes(variable, "name", "id"),
        "type": variable.scalar.name,
        "min": variable.minimum,
        "max": variable.maximum,
        **_unit(variable.quantity),
        **attributes(variable, "summary", "since", "errata"),
        "sets": [
            {
                **attributes(setting, "message", "path"),
                "scale_exact": str(setting.scale),
                "add_exact": str(setting.offset),
            }
            for setting in variable.settings
        ],
        "as_switch": variable.is_switch,
        **exponential(variable.quantity),
    }
    if variable.is_directed:
        result["positive"] = variable.direction and variable.direction.positive
    return result | given(
        later=later_json(variable.later), unconfirmed=variable.unconfirmed or None
    )
