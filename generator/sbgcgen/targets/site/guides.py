"""The handwritten pages of the site: the guides, and the beginning of README."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from posixpath import normpath

import markdown
from markupsafe import Markup

from sbgcgen.targets.site.headers import Header


@dataclass(frozen=True)
class Section:
    """A section of a guide: its anchor, heading and contents. The part before the first one has no anchor."""

    anchor: str
    heading: Markup
    html: str


@dataclass(frozen=True)
class Guide:
    """A handwritten page: docs/<name>.md."""

    name: str
    title: str
    html: Markup

    @property
    def page(self) -> str:
        return f"guides/{self.name}.html"

    @property
    def parts(self) -> list[Section]:
        """The part before the first section, and the sections."""
        return self.split("2")

    def split(self, levels: str) -> list[Section]:
        """The part before the first heading of these levels, and the part after each, as in "23"."""
        heading = rf'<h[{levels}] id="([^"]*)">(.*?)</h[{levels}]>'
        parts = re.split(heading, self.html, flags=re.DOTALL)
        sections = zip(parts[1::3], parts[2::3], parts[3::3])
        return [
            Section("", Markup(), parts[0]),
            *(Section(anchor, Markup(heading), html) for anchor, heading, html in sections),
        ]

    @property
    def sections(self) -> list[Section]:
        return self.parts[1:]


@dataclass(frozen=True)
class Pages:
    """Maps files of the project to pages of the site: guides, headers and other pages.

    `others` are the pages about folders of the project, `messages` the pages of messages by lower-case name.
    """

    headers: Sequence[Header] = ()
    others: Mapping[str, str] = field(default_factory=dict)
    messages: Mapping[str, str] = field(default_factory=dict)

    def page_of(self, path: str, section: str) -> str:
        """The page about a file of the project, or a section of it; "" if there is none."""
        if guide := re.fullmatch(r"docs/([\w-]+)\.md", path):
            page = f"guides/{name_of(guide[1])}.html"
        elif path.startswith("docs/pictures/"):
            page = path.removeprefix("docs/")
        elif path in self.others:
            page = self.others[path]
        elif path.startswith("generated/fields") and section.partition("-")[0] in self.messages:
            return self.messages[section.partition("-")[0]]
        elif path.startswith(("spec", "generated/fields")):
            return _page_about(f"{path}#{section}" if section else path)
        else:
            return ""
        return f"{page}#{section}" if section else page

    def html(self, text: str, folder: str, root: str) -> Markup:
        """Converts a text in a folder of the project to HTML; `root` leads from the page to the root."""
        html = markdown.markdown(
            text, extensions=["tables", "fenced_code", "toc"], output_format="html"
        )

        def linked(match: re.Match[str]) -> str:
            path, _, section = match[2].partition("#")
            page = self.page_of(normpath(f"{folder}/{path}"), section) if path else ""
            return f'{match[1]}="{root}{page}"' if page else match[0]

        html = re.sub(r'\b(href|src)="([^":]*)"', linked, html)
        for header in self.headers:
            name = f"<code>{header.include}</code>"
            html = html.replace(name, f'<a href="{root}{header.page}">{name}</a>')
        html = html.replace("<table>", '<div class="table free" tabindex="0"><table>')
        html = html.replace("<th>", '<th scope="col">')
        html = html.replace("</table>", "</table></div>").replace("<pre>", '<pre tabindex="0">')
        return Markup(html)


def guides_in(folder: Path, pages: Pages = Pages()) -> list[Guide]:
    """The guides, sorted by the numbers at the start of their file names."""
    return [_guide(path, pages) for path in sorted(folder.glob("*.md"), key=_order)]


def front_of(project: Path, pages: Pages) -> Markup:
    """The introduction of README, without its title."""
    path = project / "README.md"
    text = path.read_text(encoding="utf-8") if path.is_file() else ""
    found = re.match(r"# [^\n]+\n(.*?)(?=^## )", text, re.MULTILINE | re.DOTALL)
    return pages.html(found[1] if found else "", ".", "")


def _order(path: Path) -> tuple[int, str]:
    number = re.match(r"[0-9]*", path.stem)
    return (int(number[0] or 0) if number else 0, path.stem)


def name_of(stem: str) -> str:
    """The name of a guide in links, without its number."""
    return re.sub(r"^[0-9]+[-_]", "", stem)


def _guide(path: Path, pages: Pages) -> Guide:
    text = path.read_text(encoding="utf-8")
    title = re.search(r"^# (.+)$", text, re.MULTILINE)
    name = name_of(path.stem)
    return Guide(name, title[1].strip() if title else name, pages.html(text, "docs", "../"))


# The pages about files of the repository; the other files belong to families.
_PAGES = {
    "spec": "messages.html",
    "spec/adjustable_variables.yaml": "variables.html",
    "spec/errata.yaml": "errata.html",
    "spec/simplebgc.yaml#directions": "units.html#directions",
    "spec/simplebgc.yaml#framings": "framing.html",
    "spec/simplebgc.yaml#revisions": "availability.html",
    "spec/units.yaml": "units.html",
    "generated/fields": "messages.html",
}


def _page_about(link: str) -> str:
    """The page with the contents of a file, or a section of it, that a guide links."""
    path, _, section = link.partition("#")
    if path == "spec/errata.yaml" and section:
        return f"errata.html#{section}"
    return _PAGES.get(link, f"families/{Path(path).stem}.html")
