"""The messages of the Python package: a class for each, and for every structure, enum and packed value."""

from __future__ import annotations

from pathlib import Path

from sbgcgen.model import Layout
from sbgcgen.targets import Target, View
from sbgcgen.targets.python import words


class Python(Target):
    """Modules of the package `sbgc.msg`; python/ has the rest of the package, written by hand."""

    def view(self, layout: Layout, project: Path) -> View:
        return View(names={"homes": words.homes(layout)}, filters=words.FILTERS)
