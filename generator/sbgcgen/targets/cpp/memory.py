"""Where members lie in memory beside where they lie on the wire.

On a little-endian machine with natural alignment most members of a struct stand in memory exactly
as on the wire, many in a row. A compiler rarely sees that, so the C++ templates copy such runs as
one block. The generated code checks each run against the real offsets at compile time, and copies
member by member where they differ.
"""

from __future__ import annotations

from dataclasses import dataclass

from sbgcgen.model import Announced, Blob, Field, Struct, Type, scalar_of


@dataclass(frozen=True)
class Run:
    """Members `first` to `last`, which take `size` bytes from byte `offset` of the wire on."""

    first: Field
    last: Field
    offset: int
    size: int


def _size_and_alignment(type_: Type) -> tuple[int, int] | None:
    """Size and alignment in memory; None for what has no fixed offset on the wire."""
    if isinstance(type_, Announced):
        return None
    if isinstance(type_, Blob):
        return None if type_.size is None or type_.kind == "string" else (type_.size, 1)
    if not isinstance(type_, Struct):
        scalar = scalar_of(type_)
        assert scalar is not None
        return scalar.size, scalar.size
    end, alignment = 0, 1
    for field in type_.fields:
        member = _size_and_alignment(field.type)
        if member is None or field.is_variable or type_.is_region:
            return None
        end = _aligned(end, member[1]) + member[0] * field.count
        alignment = max(alignment, member[1])
    return _aligned(end, alignment), alignment


def _aligned(offset: int, alignment: int) -> int:
    return -(-offset // alignment) * alignment


def runs(fields: list[Field]) -> list[Run | Field]:
    """Fields with a fixed place, those that stand alike in memory and on the wire joined to runs."""
    result: list[Run | Field] = []
    memory = 0
    start = -1  # in memory, of the last run
    for field in fields:
        layout = _size_and_alignment(field.type)
        assert field.offset is not None and field.size is not None
        if layout is None or layout[0] * field.count != field.size:
            size, alignment = layout or (0, 1)
            memory = _aligned(memory, alignment) + size * field.count
            result.append(field)
            continue
        memory = _aligned(memory, layout[1])
        last = result[-1] if result else None
        if isinstance(last, Run) and memory - start == field.offset - last.offset:
            result[-1] = Run(last.first, field, last.offset, last.size + field.size)
        else:
            start = memory
            result.append(Run(field, field, field.offset, field.size))
        memory += field.size
    return result
