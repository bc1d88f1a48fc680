"""The reference in Markdown: for reading where the code is."""

from __future__ import annotations

from pathlib import Path

from sbgcgen.model import Layout
from sbgcgen.targets import Target, View
from sbgcgen.targets.docs.markdown_text import FILTERS
from sbgcgen.targets.docs.view import names


class Docs(Target):
    """Pages by family, and of what they have in common."""

    def view(self, layout: Layout, project: Path) -> View:
        return View(names=names(layout), filters=FILTERS)
