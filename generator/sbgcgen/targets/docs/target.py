"""The reference in Markdown, for reading in the repository."""

from __future__ import annotations

from pathlib import Path

from sbgcgen.model import Layout
from sbgcgen.targets import Target, View
from sbgcgen.targets.docs.markdown_text import FILTERS
from sbgcgen.targets.docs.view import names


class Docs(Target):
    """A page for each family, and pages for types, framing, availability and errata."""

    def view(self, layout: Layout, project: Path) -> View:
        return View(names=names(layout), filters=FILTERS)
