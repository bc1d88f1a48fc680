"""Expands a body into its leaves: the values in wire order, with one leaf per named element."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace

from sbgcgen.model import Announced, Blob, Field, Leaf, Struct, scalar_of
from sbgcgen.spec.resolve.sizes import size_of


def expand_name(spec_name: str, word: str) -> str:
    """SPEED_{AXIS} with ROLL -> SPEED_ROLL."""
    return re.sub(r"\{[^}]*\}", word, spec_name)


def leaves(
    fields: tuple[Field, ...], path: str = "", base: int | None = 0, word: str = ""
) -> Iterator[Leaf]:
    """The leaves of a list of fields in wire order."""
    for field in fields:
        offset = None if base is None or field.offset is None else base + field.offset
        for leaf in _field_leaves(field, path + field.name, offset, word):
            if field.may_be_absent:
                optional = leaf.optional or field.appended or field.fits
                when = leaf.when or (field.when and field.when.of(word))
                leaf = replace(leaf, optional=optional, when=when)
            if field.used_when:
                element = leaf.path.removeprefix(f"{path}{field.name}.").partition(".")[0]
                leaf = replace(leaf, used_when=field.used_when.of(element.upper()))
            yield leaf


def _field_leaves(field: Field, path: str, offset: int | None, word: str) -> Iterator[Leaf]:
    element = size_of(field.type)

    def one(path: str, offset: int | None, word: str, count: int | None) -> Iterator[Leaf]:
        if isinstance(field.type, Struct) and field.type.is_region:
            cases = tuple(leaves(field.type.fields[:-1], f"{path}.", offset, word))
            yield Leaf(path, field, field.spec_name, "bytes", field.type.size, offset, cases)
            return
        if isinstance(field.type, Struct):
            yield from leaves(field.type.fields, f"{path}.", offset, word)
            return
        scalar = scalar_of(field.type)
        if isinstance(field.type, Announced):
            yield Leaf(path, field, field.spec_name, "bytes", None, offset)
            return
        if isinstance(field.type, Blob):
            name, amount = field.type.kind, field.type.size if field.type.kind != "string" else None
        else:
            assert scalar is not None
            name, amount = scalar.name, count
        spec_name, direction = expand_name(field.spec_name, word), field.direction(word)
        yield Leaf(path, field, spec_name, name, amount, offset, direction=direction)

    def step(i: int) -> int | None:
        if offset is None or (element is None and i > 0):
            return None
        return offset + i * (element or 0)

    if field.dim in ("counted", "rest") and not field.index:
        suffix = "[]" if isinstance(field.type, Struct) else ""
        for leaf in one(path + suffix, offset, word, 1 if suffix else None):
            each = leaf.each if "[]." in leaf.path[len(path) + 2 :] else leaf.count
            yield replace(leaf, count=None, each=each if suffix else None)
    elif field.dim in ("fixed", "rest"):
        if not field.index and not isinstance(field.type, (Struct, Blob)):
            yield from one(path, offset, word, field.count)
            return
        for i in range(len(field.index) or field.count):
            inner = field.index[i] if field.index else word
            may_be_missing = field.dim == "rest" and i >= field.min_count
            for leaf in one(f"{path}[{i}]", step(i), inner, 1):
                yield replace(leaf, optional=may_be_missing)
    elif field.dim == "one":
        yield from one(path, offset, word, 1)
    else:
        for i, inner in enumerate(field.index):
            yield from one(f"{path}.{inner.lower()}", step(i), inner, 1)
