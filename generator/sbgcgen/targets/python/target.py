"""The messages of the Python package: a class for each, and for every structure, enum and packed value."""

from __future__ import annotations

from pathlib import Path

from sbgcgen.model import Layout
from sbgcgen.spec.diagnostics import Diagnostics
from sbgcgen.spec.load import Spec
from sbgcgen.targets import Target, View
from sbgcgen.targets.python import words
from sbgcgen.targets.python.lint import check_names


class Python(Target):
    """Modules of the package `sbgc.msg`; python/ has the rest of the package, written by hand."""

    def view(self, layout: Layout, project: Path) -> View:
        return View(names={"homes": words.homes(layout)}, filters=words.FILTERS)

    def lint(self, spec: Spec, layout: Layout, found: Diagnostics) -> None:
        check_names(layout, found)
