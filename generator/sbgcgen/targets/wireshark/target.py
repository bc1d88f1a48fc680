"""A dissector for Wireshark: the protocol as tables of Lua, and the program that interprets them."""

from __future__ import annotations

from pathlib import Path

from sbgcgen.model import Layout
from sbgcgen.spec.diagnostics import Diagnostics
from sbgcgen.spec.load import Spec
from sbgcgen.targets import Target, View
from sbgcgen.targets.wireshark import limits, tables


class Wireshark(Target):
    """One file of Lua, which Wireshark loads from its folder of plugins."""

    def view(self, layout: Layout, project: Path) -> View:
        structs, names = tables.structs(layout)
        return View(
            filters={"lua": tables.lua},
            names={
                "tables": tables,
                "namespace": layout.protocol.get("namespace", "sbgc"),
                "structs": structs,
                "struct_names": names,
            },
        )

    def lint(self, spec: Spec, layout: Layout, found: Diagnostics) -> None:
        limits.check(layout, found)
