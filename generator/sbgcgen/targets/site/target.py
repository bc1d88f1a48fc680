"""The reference site: every message on a page of its own, the guides, a search, a decoder."""

from __future__ import annotations

from pathlib import Path

from sbgcgen.model import Layout
from sbgcgen.targets import Target, View


class Site(Target):
    """It is not committed, and needs more modules than everything else."""

    committed = False
    help = "write the reference site; it is not part of generated/"
    # No other folder has this file, so no other one is taken for an earlier site and cleaned.
    mark = "assets/search-index.js"

    def view(self, layout: Layout, project: Path) -> View:
        from sbgcgen.targets.site.view import view_of

        return view_of(self, layout, project / "docs")
