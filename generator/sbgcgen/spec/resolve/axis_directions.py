"""Resolves sign conventions: the directions of the axes, and the fields that have one."""

from __future__ import annotations

from collections.abc import Collection

from sbgcgen.model import AxisDirection, Quantity, Type, scalar_of
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
        positive, negative = words["positive"], words["negative"]
        if axis not in axes:
            hint = did_you_mean(axis, axes) or "name an element of 'indices'"
            found.add(at, "SBGC072", f"there is no axis {axis}", hint)
        if (positive is None) != (negative is None) or (positive and positive == negative):
            text = f"the directions of {axis} are not opposite"
            found.add(at, "SBGC072", text, "name both, or null for both if they are not known")
        result.append(AxisDirection(axis, positive, negative, entries.errata(words), at))
    return tuple(result)


class DirectionResolver:
    """Resolves `directed` of fields; findings go into `found`."""

    def __init__(self, directions: tuple[AxisDirection, ...], found: Diagnostics) -> None:
        self.directions = directions
        self.axes = [direction.axis for direction in directions]
        self.found = found

    def direction(
        self, node: Map, type_: Type, name: str, index: Collection[str]
    ) -> tuple[tuple[AxisDirection, ...] | None, str]:
        """The possible directions of a field, and its axis if it names one."""
        is_directed = isinstance(type_, Quantity) and type_.is_directed
        if "directed" not in node:
            self._check_name(node, name, is_directed and not index)
            return (self.directions if is_directed else None), ""
        said, at = str(node["directed"]), node.at("directed")
        scalar = scalar_of(type_)
        if said == "none":
            if not is_directed:
                hint = "delete 'directed': values of its type count in no direction"
                self.found.add(at, "SBGC072", f"{name} is no directed quantity", hint)
            return None, ""
        if scalar is None or scalar.minimum == 0:
            hint = "delete 'directed', or use a type with a sign"
            self.found.add(at, "SBGC072", f"{name} has no sign", hint)
        if said == "unknown":
            return (), ""
        if said not in self.axes:
            hint = did_you_mean(said, self.axes) or "name an axis of 'directions', or unknown"
            self.found.add(at, "SBGC072", f"{said} has no direction", hint)
        elif index:
            hint = "delete 'directed': the index names the axes"
            self.found.add(at, "SBGC072", f"{name} has an element for each axis", hint)
        return self.directions, said

    def _check_name(self, node: Map, name: str, is_single: bool) -> None:
        """A quantity with a sign convention must declare it if its name contains an axis."""
        named = [axis for axis in self.axes if axis in name.split("_")]
        if is_single and named:
            hint = f"write 'directed: {named[0]}', or 'directed: unknown'"
            text = f"{name} does not say in which direction it counts"
            self.found.add(node.at("name"), "SBGC072", text, hint)
