"""The messages of the Python package: a class for each, and for every structure, enum and packed value."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Optional

from sbgcgen.blocking import MADE, blocking, source_of
from sbgcgen.model import Layout
from sbgcgen.oracle.example import Example
from sbgcgen.spec.diagnostics import Diagnostics
from sbgcgen.spec.load import Spec
from sbgcgen.targets import Code, Reference, Target, View
from sbgcgen.targets.python import words
from sbgcgen.targets.python.example import decoding, encoding
from sbgcgen.targets.python.lint import check_names
from sbgcgen.targets.python.reference import reference_of


class Python(Target):
    """Modules of the package `sbgc.msg`, and the blocking client; python/ has the rest of the package."""

    def view(self, layout: Layout, project: Path) -> View:
        return View(
            names={"homes": words.homes(layout), "answers": words.answers(layout)},
            filters=words.FILTERS,
        )

    def files(self, layout: Layout, project: Path) -> Iterator[tuple[str, bytes]]:
        yield from super().files(layout, project)
        for path in source_of(project):
            yield MADE, blocking(path.read_text(encoding="utf-8")).encode()

    def examples(self, example: Example) -> list[Code]:
        """The code of a host: it encodes what goes to the board, and decodes the rest."""
        message = example.message
        if message.in_both_directions or message.direction == "to_board":
            return [Code("Python", "python", encoding(example))]
        text, output = decoding(example)
        return [Code("Python", "python", text, output)]

    def reference(self, project: Path) -> Optional[Reference]:
        return reference_of(project)

    def lint(self, spec: Spec, layout: Layout, found: Diagnostics) -> None:
        check_names(layout, found)
