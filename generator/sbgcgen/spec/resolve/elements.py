"""Lists whose elements grew with a firmware."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations
from math import lcm

from sbgcgen.model import Availability, Field, Struct
from sbgcgen.spec.resolve.sizes import min_size, total_size


def grown(struct: Struct, since: Availability) -> Struct:
    """The struct of a list that exists since `since`, with the sizes that its elements have had.

    It is the same struct if they did not grow, or in a way that a decoder cannot follow.
    """
    first = len(struct.fields)
    while first and struct.fields[first - 1].since.is_after(since):
        first -= 1
    kept, later = struct.fields[:first], struct.fields[first:]
    size = total_size(kept)
    if not kept or not later or size is None:
        return struct
    sizes = [size]
    for number, field in enumerate(later):
        following = later[number + 1].since if number + 1 < len(later) else None
        if field.is_variable or field.size is None or field.is_counter:
            return struct
        if following is not None and field.since.is_after(following):
            return struct
        size += field.size
        if following != field.since:
            sizes.append(size)
    fields = (*kept, *(replace(field, appended=True) for field in later))
    return replace(
        struct, fields=fields, size=None, min_size=min_size(fields), element_sizes=tuple(sizes)
    )


def may_grow(field: Field) -> bool:
    """True for a list of structs of which the rest of the body tells how large an element is."""
    is_list = field.dim in ("counted", "rest") and not field.index
    is_plain = field.when is None and field.counting != "bytes"
    return is_list and is_plain and isinstance(field.type, Struct)


def confused(sizes: tuple[int, ...], room: int) -> tuple[int, int, int] | None:
    """Two sizes of elements, and a number of bytes that is a list of either kind."""
    for one, other in combinations(sizes, 2):
        if lcm(one, other) <= room:
            return one, other, lcm(one, other)
    return None
