"""The reference site: a page for each message, the guides, a search and a decoder."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from sbgcgen.model import Layout
from sbgcgen.targets import Target, View


class Site(Target):
    """The site. It is not committed, and only this target needs the module markdown."""

    committed = False
    help = "write the reference site; it is not part of generated/"
    # Only an earlier site has this file, so no other folder is cleaned.
    mark = "assets/search-index.js"

    def view(self, layout: Layout, project: Path) -> View:
        from sbgcgen.targets.site.view import view_of

        return view_of(self, layout, project)

    def record(self, layout: Layout, project: Path, version: str) -> None:
        """Record the new public C++ names."""
        from sbgcgen.targets.site.headers import SINCE, record_names

        record_names(project, layout, version)
        print(f"{SINCE} has the names of {version}")

    def files(self, layout: Layout, project: Path) -> Iterator[tuple[str, bytes]]:
        """The files of the templates, and the pictures of guides and README."""
        yield from super().files(layout, project)
        for path in sorted((project / "docs/pictures").glob("*.[sp][vn]g")):
            yield f"pictures/{path.name}", path.read_bytes()
