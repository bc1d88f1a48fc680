"""Alternative values for a place of the spec, valid ones first."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from key_paths import Place, Schema, resolved, validator
from sbgcgen.model import Position
from sbgcgen.spec.load import List, Map

ABSENT = object()


def changes(place: Place, pool: list[Any]) -> Iterator[Any]:
    """Yields valid values for the place; `pool` has those of other places with the same path."""
    seen = [place.value]
    for value in _candidates(place, pool):
        if value in seen:
            continue
        seen.append(value)
        if validator(place.schema).is_valid(value):
            yield value
    if not place.is_required:
        yield ABSENT


def _candidates(place: Place, pool: list[Any]) -> Iterator[Any]:
    value, schema = place.value, resolved(place.schema)[1]
    if isinstance(value, bool):
        yield not value
    elif isinstance(value, int):
        yield from (value + 1, value - 1, value + 2, value * 2)
    elif isinstance(value, str):
        yield from _texts(value, schema, pool)
    elif isinstance(value, list):
        yield from _lists(value, pool)
    elif isinstance(value, dict):
        yield from pool
        for key in reversed(list(value)):
            yield without(value, key)


def _texts(value: str, schema: Schema, pool: list[Any]) -> Iterator[Any]:
    for branch in (schema, *schema.get("anyOf", ())):
        yield from resolved(branch)[1].get("enum", ())
    if " " in value and not re.search(r"\d\.\.", value):
        yield f"{value} More."
    yield from pool
    for number in reversed(list(re.finditer(r"\d+", value))):
        for other in (int(number[0]) - 1, int(number[0]) + 1):
            if other >= 0:
                digits = str(other).zfill(len(number[0]))
                yield value[: number.start()] + digits + value[number.end() :]
    yield from (f"{value}x", f"{value}_X", f"{value} More.")


def _lists(value: list[Any], pool: list[Any]) -> Iterator[Any]:
    yield items(value, list(range(len(value) - 1, -1, -1)))
    yield items(value, list(range(len(value) - 1)))
    yield from pool


def items(value: list[Any], chosen: list[int]) -> List:
    result = List(value[i] for i in chosen)
    result.position = value.position  # type: ignore[attr-defined]
    result.items_at = [value.items_at[i] for i in chosen]  # type: ignore[attr-defined]
    return result


def without(node: Any, key: str) -> Map:
    return mapping(node, {k: v for k, v in node.items() if k != key})


def mapping(like: Any, content: dict[str, Any]) -> Map:
    result = Map(content)
    result.position = like.position
    result.keys_at = {k: like.keys_at.get(k, like.position) for k in content}
    return result


@contextmanager
def changed(parent: Map, key: str, value: Any) -> Iterator[None]:
    """Sets a key, new or existing, to another value within the with block."""
    content, places = dict(parent), dict(parent.keys_at)
    if value is ABSENT:
        del parent[key]
    else:
        parent.keys_at.setdefault(key, parent.position)
        parent[key] = positioned(value, parent.keys_at[key])
    try:
        yield
    finally:
        parent.clear()
        parent.update(content)
        parent.keys_at = places


def positioned(value: Any, at: Position) -> Any:
    """Converts a plain value to the types of the YAML reader."""
    if isinstance(value, dict) and not isinstance(value, Map):
        result = Map((key, positioned(inner, at)) for key, inner in value.items())
        result.position, result.keys_at = at, dict.fromkeys(value, at)
        return result
    if isinstance(value, list) and not isinstance(value, List):
        found = List(positioned(item, at) for item in value)
        found.position, found.items_at = at, [at] * len(value)
        return found
    return value
