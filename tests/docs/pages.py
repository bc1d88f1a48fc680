"""Reads pages of the site for the tests. Strict: every element must be closed explicitly."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from functools import cache, cached_property
from html.parser import HTMLParser
from typing import Any, Optional
from urllib.parse import unquote, urljoin

# Elements without content: those of HTML, and the SVG elements that the site uses.
VOID = frozenset("br hr img input link meta wbr path rect circle ellipse".split())


@dataclass(eq=False)
class Element:
    """An element with its attributes and contents."""

    tag: str
    attributes: dict[str, str]
    parent: Optional[Element] = None
    children: list[Element] = field(default_factory=list)
    texts: list[object] = field(default_factory=list)  # str and Element in order

    @property
    def text(self) -> str:
        return "".join(t.text if isinstance(t, Element) else str(t) for t in self.texts)

    def get(self, name: str) -> str:
        return self.attributes.get(name, "")

    @cached_property
    def descendants(self) -> list[Element]:
        """All elements in this one, in the order of the page, which is complete when this is used."""
        return [e for child in self.children for e in (child, *child.descendants)]

    def all(self, *tags: str) -> list[Element]:
        """Returns the descendants with one of these tags, or all of them."""
        return [e for e in self.descendants if e.tag in tags] if tags else self.descendants

    def with_class(self, name: str) -> list[Element]:
        return [e for e in self.all() if name in e.get("class").split()]

    def ancestors(self) -> list[Element]:
        return [self.parent, *self.parent.ancestors()] if self.parent else []


class _Reader(HTMLParser):
    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self.root = Element("document", {})
        self.open = self.root
        self.doctype = ""

    def handle_decl(self, decl: str) -> None:
        self.doctype = decl

    def handle_starttag(self, tag: str, attrs: list[tuple[str, Optional[str]]]) -> None:
        names = [name for name, _ in attrs]
        assert len(set(names)) == len(names), f"{tag} has an attribute twice: {names}"
        element = Element(tag, {name: value or "" for name, value in attrs}, self.open)
        self.open.children.append(element)
        self.open.texts.append(element)
        if tag not in VOID:
            self.open = element

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, Optional[str]]]) -> None:
        assert tag in VOID, f"<{tag}/> is not empty in HTML"
        self.handle_starttag(tag, attrs)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.tag == tag, f"</{tag}> closes <{self.open.tag}> at {self.getpos()}"
        assert self.open.parent is not None
        self.open = self.open.parent

    def handle_data(self, data: str) -> None:
        self.open.texts.append(data)


@dataclass(frozen=True)
class Page:
    """A page, identified by its path in the site."""

    path: str
    root: Element

    @property
    def main(self) -> Element:
        """The part that is specific to this page."""
        return self.root.all("main")[0]

    @cached_property
    def by_id(self) -> dict[str, Element]:
        """Returns the first element of each id."""
        return {e.get("id"): e for e in reversed(self.root.all()) if "id" in e.attributes}

    @cached_property
    def ids(self) -> list[str]:
        return [e.get("id") for e in self.root.all() if "id" in e.attributes]

    @property
    def links(self) -> list[tuple[str, str]]:
        """Returns the targets of its links: path in the site (or a URL), and fragment."""
        result = []
        for element in self.root.all("a"):
            page, _, fragment = element.get("href").partition("#")
            target = urljoin(self.path, page) if page else self.path
            result.append((target, unquote(fragment)))
        return result


@cache
def read(path: str, text: str) -> Page:
    """Parses a page; fails if an element is not closed."""
    reader = _Reader()
    reader.feed(text)
    reader.close()
    assert reader.doctype.lower() == "doctype html", path
    assert reader.open is reader.root, f"{path}: <{reader.open.tag}> is not closed"
    return Page(path, reader.root)


@dataclass(frozen=True)
class Found:
    """An entry of the search index."""

    kind: str
    name: str
    about: str
    page: str
    words: list[str]
    twins: list[Found]


def search_index(files: dict[str, bytes]) -> list[Found]:
    """Returns the entries of the search index."""
    text = files["assets/search-index.js"].decode()
    index = json.loads(text[text.index("{") : text.rindex("}") + 1])
    return [_found(*entry) for entry in index["entries"]]


def _found(kind: str, name: str, about: str, page: str, words: str, twins: Any = ()) -> Found:
    others = [_found(kind, *twin) for twin in twins]
    return Found(kind, name, about, page, words.split(), others)
