"""The messages of the Python package: a class for each, and for every structure, enum and packed value."""

from __future__ import annotations

from pathlib import Path
from typing import Optional

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
    """Modules of the package `sbgc.msg`; python/ has the rest of the package, written by hand."""

    def view(self, layout: Layout, project: Path) -> View:
        return View(names={"homes": words.homes(layout)}, filters=words.FILTERS)

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
