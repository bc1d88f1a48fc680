"""The text of the site's pages: elements by id, and the cells of table rows."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from html.parser import HTMLParser

from facts import Place

from sbgcgen.model.names import slug

_EMPTY = {"area", "base", "br", "col", "hr", "img", "input", "link", "meta", "source", "wbr"}
_APART = {"td", "th", "li", "p", "dd", "dt", "div", "br", "h1", "h2", "h3", "tr", "small"}
# The columns of a row in which a reader looks for each kind of fact; an empty list is the whole
# row.
_COLUMNS = {
    "offset": ["Offset"],
    "type": ["Type"],
    "unit": ["Type", "Unit"],
    "range": ["Values", "Range"],
    "setting": ["Meaning"],
    "number": ["Value"],
    "id": ["Id"],
}


@dataclass
class Element:
    """An element of a page."""

    tag: str
    attributes: dict[str, str]
    parent: Element | None
    children: list[Element | str] = field(default_factory=list)

    def text(self) -> str:
        """Returns all text in it, including the titles of elements that are link targets."""
        parts = [child if isinstance(child, str) else child.text() for child in self.children]
        if "id" in self.attributes:
            parts.insert(0, f" {self.attributes.get('title', '')} ")
        text = "".join(parts)
        return f" {text} " if self.tag in _APART or "id" in self.attributes else text

    def all(self) -> Iterator[Element]:
        """Yields the element and all its descendants."""
        yield self
        for child in self.children:
            if isinstance(child, Element):
                yield from child.all()

    def around(self, *tags: str) -> Element | None:
        """Returns the nearest enclosing element, or the element itself, with one of these tags."""
        element: Element | None = self
        while element is not None and element.tag not in tags:
            element = element.parent
        return element


class _Reader(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.root = Element("", {}, None)
        self.open = self.root

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        element = Element(tag, {name: value or "" for name, value in attrs}, self.open)
        self.open.children.append(element)
        if tag not in _EMPTY:
            self.open = element

    def handle_endtag(self, tag: str) -> None:
        if tag in _EMPTY:
            return
        assert self.open.tag == tag, f"</{tag}> closes <{self.open.tag}>"
        assert self.open.parent is not None
        self.open = self.open.parent

    def handle_data(self, data: str) -> None:
        if self.open.tag not in ("script", "style"):
            self.open.children.append(data)


@dataclass
class Page:
    """A page, without the parts that all pages share; its elements by id."""

    main: Element
    by_id: dict[str, Element]


@lru_cache(maxsize=None)
def page_of(text: str) -> Page:
    """Parses a page; fails on an unclosed element."""
    reader = _Reader()
    reader.feed(text)
    reader.close()
    assert reader.open is reader.root, f"<{reader.open.tag}> is never closed"
    main = next((e for e in reader.root.all() if e.tag == "main"), reader.root)
    by_id: dict[str, Element] = {}
    for element in reader.root.all():
        if "id" in element.attributes:
            by_id.setdefault(element.attributes["id"], element)
    return Page(main, by_id)


class HtmlPages:
    """The files of the site by path."""

    def __init__(self, files: Mapping[str, str], families: Mapping[str, str]) -> None:
        self.files = files
        self.families = families  # of commands

    def text(self, place: Place, column: str) -> str | None:
        """See Pages."""
        name, id_ = self._where(place)
        if name not in self.files:
            return None
        page = page_of(self.files[name])
        if not id_:
            return page.main.text()
        # Some ids are only the name of the documented item.
        element = page.by_id.get(id_) or page.by_id.get(place.hook)
        if element is None:
            return None
        text = _text_of(element, column)
        # The row of a member shows only the last part of its path, below its group, without an index.
        is_shown = place.hook.rpartition(".")[2].partition("[")[0] in text
        return f"{text} {place.hook}" if column == "field" and is_shown else text

    def page_name(self, place: Place) -> str:
        """Returns the file that contains a place."""
        return self._where(place)[0]

    def _where(self, place: Place) -> tuple[str, str]:
        """Returns the page and the id of a place."""
        folders = {"message": "messages", "enum": "enums", "packed": "packed", "unit": "units"}
        hooks = {"message": "field-", "enum": "value-", "variables": "variable-"}
        id_ = hooks.get(place.kind, "") + place.hook if place.hook else ""
        if place.kind in folders:
            return f"{folders[place.kind]}/{slug(place.name)}.html", id_
        if place.kind == "commands":
            return f"families/{self.families[place.hook]}.html", id_
        return f"{place.kind}.html", id_


def _text_of(element: Element, column: str) -> str:
    row = element.around("tr")
    if row is None:
        return element.text()
    if column == "offset" and element is not row:
        return element.text()
    wanted = _COLUMNS.get(column, [])
    cells = [cell.text() for title, cell in zip(_titles(row), _cells(row)) if title in wanted]
    return " ".join(cells) if cells else row.text()


def _cells(row: Element) -> list[Element]:
    return [c for c in row.children if isinstance(c, Element) and c.tag in ("td", "th")]


def _titles(row: Element) -> list[str]:
    table = row.around("table")
    head = next((e for e in table.all() if e.tag == "tr"), row) if table else row
    return [" ".join(cell.text().split()) for cell in _cells(head)]
