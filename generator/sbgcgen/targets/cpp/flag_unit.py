"""Fields whose unit is selected by a flag of the message, and the C++ access to field and flag."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace

from sbgcgen.model import Alternative, Field, Message, Quantity, Struct


@dataclass(frozen=True)
class FlagUnit:
    """A field of a message in either of two units.

    `elements` is the list, `index` of which has the field at `member` (with its dot); `flags` is
    the path of the flag. If all elements share one flag, it `is_common`.
    """

    name: str
    field: Field
    usual: Quantity
    alternative: Alternative
    elements: str
    member: str
    flags: str
    is_common: bool

    @property
    def place(self) -> str:
        """The field of an element, or the only one."""
        return f"{self.elements}[index]{self.member}" if self.elements else self.member


def flag_units(message: Message) -> list[FlagUnit]:
    """The fields with two units that are always present and reached by at most one index."""
    found = [unit for path in _paths(message.fields, ()) if (unit := _flag_unit(message, path))]
    names = Counter(unit.name for unit in found)
    full = [replace(u, name=(u.elements + u.member).replace(".", "_")) for u in found]
    return [unit if names[unit.name] == 1 else other for unit, other in zip(found, full)]


def _paths(fields: tuple[Field, ...], path: tuple[Field, ...]) -> Iterator[tuple[Field, ...]]:
    """The paths of the fields with two units."""
    for field in fields:
        if field.when is not None:
            continue
        if isinstance(field.type, Struct):
            if not field.type.is_region:
                yield from _paths(field.type.fields, (*path, field))
        elif field.alternative is not None:
            yield (*path, field)


def _flag_unit(message: Message, path: tuple[Field, ...]) -> FlagUnit | None:
    field = path[-1]
    several = [i for i, step in enumerate(path) if step.dim != "one"]
    if field.alternative is None or not isinstance(field.type, Quantity):
        return None
    source = next((f for f in message.fields if f.name == field.alternative.source), None)
    if len(several) > 1 or source is None or source.when is not None:
        return None
    names = [step.name for step in path]
    split = several[0] + 1 if several else 0
    list_ = path[several[0]] if several else None
    is_own = list_ is not None and source.dim == list_.dim and source.dim in ("axis", "xyz")
    if source.dim != "one" and not is_own:
        return None
    return FlagUnit(
        name=field.name,
        field=field,
        usual=field.type,
        alternative=field.alternative,
        elements=".".join(names[:split]),
        member="".join(f".{name}" for name in names[split:]) if split else ".".join(names),
        flags=f"{source.name}[index]" if is_own else source.name,
        is_common=list_ is not None and not is_own,
    )
