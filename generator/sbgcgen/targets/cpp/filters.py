"""What the templates of C++ may do to values."""

from __future__ import annotations

import json
import textwrap
from collections.abc import Callable, Iterable
from typing import Any

from sbgcgen.model import Field, Quantity, constants, copy_field
from sbgcgen.targets.cpp.flag_unit import flag_units
from sbgcgen.targets.cpp.memory import Run, runs


def comment(text: str, indent: int = 0, width: int = 100, mark: str = "/// ") -> str:
    """Text as comment lines, wrapped; the first line is not indented."""
    lines = textwrap.wrap(text.replace("??", "? ?"), width - indent - len(mark)) or [""]
    # A backslash at the end of a line would make the next one part of the comment.
    lines = [f"{line} ." if line.endswith("\\") else line for line in lines]
    return f"\n{' ' * indent}".join((mark + line).rstrip() for line in lines)


def c_string(text: str) -> str:
    """Text as a C string literal, in which nothing looks like a trigraph."""
    return json.dumps(text, ensure_ascii=False).replace("??", "?\\?")


def unit_name(quantity: Quantity) -> str:
    """The unit of a quantity as a part of names: deg/s^2 is deg_per_s2."""
    words = {"/": "_per_", "^": "", " ": "_", "%": "percent", "°": "deg", "µ": "u"}
    return "".join(words.get(c, c) for c in quantity.unit or quantity.accessor)


def units(quantities: Iterable[Quantity]) -> list[Quantity]:
    """The first quantity of each unit."""
    return list({unit_name(q): q for q in reversed(list(quantities))}.values())[::-1]


def fast_runs(fields: list[Field]) -> list[Run | Field]:
    """The runs of a list of fields, if copying them in blocks is worth it; else nothing."""
    joined = runs(fields)
    return joined if len(fields) > 2 and 2 * len(joined) <= len(fields) else []


FILTERS: dict[str, Callable[..., Any]] = {
    "comment": comment,
    "c_string": c_string,
    "fast_runs": fast_runs,
    "unit_name": unit_name,
    "units": units,
    "flag_units": flag_units,
    "constants": constants,
    "copy_field": copy_field,
}

TESTS: dict[str, Callable[..., bool]] = {"a_run": lambda step: isinstance(step, Run)}
