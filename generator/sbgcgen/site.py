"""The reference site: what its templates see, beyond the Layout."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import markdown

from sbgcgen.emit import SITE, Items, expand, render, sources_of
from sbgcgen.model import Layout

# No other folder has this file, so no other one is taken for an earlier site and cleaned.
MARK = "assets/search-index.js"


@dataclass(frozen=True)
class Guide:
    """A page that somebody has written: docs/<name>.md."""

    name: str
    title: str
    html: str

    @property
    def page(self) -> str:
        return f"guides/{self.name}.html"


def guides_in(folder: Path) -> list[Guide]:
    """The guides in the order of their file names; a leading number is only for the order."""
    return [_guide(path) for path in sorted(folder.glob("*.md"))]


def _guide(path: Path) -> Guide:
    text = path.read_text(encoding="utf-8")
    name = re.sub(r"^[0-9]+[-_]", "", path.stem)
    title = re.search(r"^# (.+)$", text, re.MULTILINE)
    html = markdown.markdown(text, extensions=["tables", "fenced_code", "toc"], output_format="html")
    return Guide(name, title[1].strip() if title else name, html)


def outputs(layout: Layout, docs: Path) -> dict[str, bytes]:
    """All files of the site by their path; `docs` is the folder of the guides.

    Raises ValueError if two of them had the same path.
    """
    guides = guides_in(docs)
    each: dict[str, Items] = {"guide": [(guide.name, guide) for guide in guides]}
    pages = [path for _, path, _ in expand(sources_of(SITE), layout, each)]
    twice = {page for page in pages if pages.count(page) > 1}
    if twice:
        raise ValueError(f"several things have the page {min(twice)}")
    names = {"pages": frozenset(pages), "guides": guides}
    return dict(render(SITE, layout, each, names))
