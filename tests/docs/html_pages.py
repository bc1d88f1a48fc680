"""The text of the site's pages: elements by id, and the cells of table rows."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from facts import Place
from pages import Element, read

from sbgcgen.model.names import slug

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


def shown(element: Element) -> str:
    """Returns all text in it, including the titles of elements that are link targets."""
    if element.tag in ("script", "style"):
        return ""
    parts = [shown(part) if isinstance(part, Element) else str(part) for part in element.texts]
    is_target = "id" in element.attributes
    if is_target:
        parts.insert(0, f" {element.get('title')} ")
    text = "".join(parts)
    return f" {text} " if element.tag in _APART or is_target else text


# Several facts are at the same place.
_shown_once = cache(shown)


def _around(element: Element, tag: str) -> Element | None:
    """Returns the nearest enclosing element with this tag, or the element itself."""
    return next((e for e in (element, *element.ancestors()) if e.tag == tag), None)


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
        page = read(name, self.files[name])
        if not id_:
            return _shown_once(page.main)
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
    row = _around(element, "tr")
    if row is None or (column == "offset" and element is not row):
        return _shown_once(element)
    wanted = _COLUMNS.get(column, [])
    titles = _titles(_around(row, "table") or row)
    cells = [_shown_once(cell) for title, cell in zip(titles, _cells(row)) if title in wanted]
    return " ".join(cells) if cells else _shown_once(row)


def _cells(row: Element) -> list[Element]:
    return [cell for cell in row.children if cell.tag in ("td", "th")]


@cache
def _titles(table: Element) -> list[str]:
    """Returns the titles of a table's columns; a row without a table has its own."""
    head = table.all("tr")[0] if table.tag == "table" else table
    return [" ".join(_shown_once(cell).split()) for cell in _cells(head)]
