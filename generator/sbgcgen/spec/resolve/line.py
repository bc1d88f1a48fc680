"""Resolves the settings of the serial line."""

from __future__ import annotations

from typing import Any

from sbgcgen.model import Line
from sbgcgen.spec.diagnostics import Diagnostics
from sbgcgen.spec.load import Map
from sbgcgen.spec.resolve.types import TypeResolver


def line_of(node: Any, types: TypeResolver, found: Diagnostics) -> Line:
    """Resolve the value of `line:` in the main file; None if it is absent."""
    if not isinstance(node, Map):
        return Line((), 0, (), 0, 0, "", ())
    named: list[int] = []
    if "baud_rates" in node:
        enum = types.enum_named(str(node["baud_rates"]), node.at("baud_rates"))
        named = [value.number for value in enum.values if value.number] if enum else []
        if enum and not named:
            text = f"no value of {enum.name} has a 'number'"
            found.add(node.at("baud_rates"), "SBGC038", text, f"see {enum.at}")
    for rate in node.get("more_baud_rates", ()):
        if rate in named:
            text = f"{rate} is one of {node['baud_rates']}"
            found.add(node.at("more_baud_rates"), "SBGC038", text, "leave it out")
    low, _, high = str(node["pause_ms"]).partition("..")
    if int(low) > int(high):
        text = "the pause after each command has its limits reversed"
        found.add(node.at("pause_ms"), "SBGC017", text, f"write {high}..{low}")
    return Line(
        baud_rates=(*named, *node.get("more_baud_rates", ())),
        named=len(named),
        parities=tuple(str(parity) for parity in node["parities"]),
        shortest_pause_ms=int(low),
        longest_pause_ms=int(high),
        source=str(node["source"]),
        errata=types.errata(node),
        at=node.position,
    )
