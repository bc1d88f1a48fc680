"""Messages, parser and session of the library as one header."""

from __future__ import annotations

from pathlib import Path

from sbgcgen import library
from sbgcgen.model import Layout
from sbgcgen.targets import Target, View


class SingleHeader(Target):
    """The single header. It is not committed, because it repeats committed headers."""

    committed = False
    help = "write messages, parser and session of the C++ library as a single header"
    file = "sbgc.hpp"

    def view(self, layout: Layout, project: Path) -> View:
        namespace = layout.protocol.get("namespace", "sbgc")
        parts = library.parts(project, library.ENTRIES)
        for part in parts:
            part.header = library.in_namespace(part.header, namespace)
            part.body = library.in_namespace(part.body, namespace)
        return View(
            names={
                "version": library.version(project),
                "license": library.license_text(project).splitlines(),
                "parts": parts,
                "standard": sorted({name for part in parts for name in part.standard}),
            }
        )
