"""Resolves the directions in which values about each axis count."""

from __future__ import annotations

from collections.abc import Collection

from sbgcgen.model import AxisDirection
from sbgcgen.spec.diagnostics import Diagnostics, did_you_mean
from sbgcgen.spec.load import Map
from sbgcgen.spec.resolve.entries import Entries


def axis_directions_of(
    node: Map, axes: Collection[str], entries: Entries, found: Diagnostics
) -> tuple[AxisDirection, ...]:
    """Resolve the value of `directions:` in the main file; `axes` are the elements of indices."""
    result = []
    for axis, words in node.items():
        at = node.at(axis)
        if axis not in axes:
            hint = did_you_mean(axis, axes) or "name an element of 'indices'"
            found.add(at, "SBGC072", f"there is no axis {axis}", hint)
        positive, negative = words["positive"], words["negative"]
        if positive == negative and positive is not None:
            text = f"both directions of {axis} are '{positive}'"
            found.add(at, "SBGC072", text, "name the opposite one, or null for both")
        elif (positive is None) != (negative is None):
            text = f"only one direction of {axis} is known"
            found.add(at, "SBGC072", text, "it implies the other one: name both, or null for both")
        result.append(AxisDirection(axis, positive, negative, entries.errata(words), at))
    return tuple(result)
