"""Remembers what was computed for objects of the model."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any, TypeVar

_Function = TypeVar("_Function", bound=Callable[..., Any])


def remember(function: _Function) -> _Function:
    """Compute a function once for the same arguments.

    Unlike functools.cache, it identifies arguments by their identity, because the hash of an object
    of the model takes as long as most functions.
    """
    known: dict[tuple[int, ...], tuple[tuple[Any, ...], Any]] = {}

    @wraps(function)
    def remembered(*arguments: Any) -> Any:
        key = tuple(map(id, arguments))
        found = known.get(key)
        if found is None:
            # The arguments are kept, so that no other object gets the id of one of them.
            found = known[key] = (arguments, function(*arguments))
        return found[1]

    return remembered  # type: ignore[return-value]
