"""The freestanding parts of the library, as a library for Arduino and PlatformIO."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from sbgcgen import library
from sbgcgen.model import Layout
from sbgcgen.targets import Target, View


class Arduino(Target):
    """The Arduino library. It is not committed, because it repeats committed headers."""

    committed = False
    help = (
        "write core, codec and session of the C++ library as a library for Arduino and PlatformIO"
    )
    mark = "src/sbgc.h"

    def view(self, layout: Layout, project: Path) -> View:
        return View(names={"version": library.version(project), "entries": library.ENTRIES})

    def files(self, layout: Layout, project: Path) -> Iterator[tuple[str, bytes]]:
        yield from super().files(layout, project)
        yield "LICENSE", library.license_text(project).encode()
        for header in library.headers(project, (*library.ENTRIES, *library.TABLES)):
            yield f"src/{header}", library.path_of(project, header).read_bytes()
