"""Names of code for what the model names, which several targets use."""

from __future__ import annotations

import keyword

from sbgcgen.model import EnumValue, Quantity

# Names that every message, packed integer or enum of Python has already.
_TAKEN_IN_PYTHON = {
    "self",
    "cls",
    "raw",
    "assign",
    "from_body",
    "from_json",
    "to_json",
    "name",
    "value",
    "mro",
}


def enum_name(value: EnumValue) -> str:
    """The name of an enum value: the protocol's own, unless Python cannot have it."""
    name = value.name
    is_taken = keyword.iskeyword(name) or name in _TAKEN_IN_PYTHON or name.startswith("_")
    return value.identifier.upper() if is_taken or not name.isidentifier() else name


def attribute_name(name: str) -> str:
    """The name of a field or part, which may be a word of Python: in_."""
    return (
        f"{name}_"
        if keyword.iskeyword(name) or name in _TAKEN_IN_PYTHON - {"name", "value"}
        else name
    )


def unit_name(quantity: Quantity) -> str:
    """The unit of a quantity as a part of names: deg/s^2 is deg_per_s2."""
    words = {"/": "_per_", "^": "", " ": "_", "%": "percent", "°": "deg", "µ": "u"}
    return "".join(words.get(c, c) for c in quantity.unit or quantity.accessor)
