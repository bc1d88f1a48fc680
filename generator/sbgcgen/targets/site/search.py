"""The search index of the site."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from html import unescape
from itertools import chain
from typing import Any

from sbgcgen.model import Command, Layout, Message, Quantity
from sbgcgen.targets import Reference
from sbgcgen.targets.site.documentation import anchors_of
from sbgcgen.targets.site.guides import Guide
from sbgcgen.targets.site.headers import Header
from sbgcgen.targets.site.uses import page_of
from sbgcgen.views.firmware import History
from sbgcgen.views.rows import Row, rows_of
from sbgcgen.views.words import title_of

# Stop words.
_COMMON = frozenset(
    """about after again all also and another any are ask because been before behind below but can
    does each else even every first for from had has have her here his how into its itself last less
    like long made make many may more most much must neither next none nor not nothing now off once one
    only other out own same say says see shall should since some still such take takes tell tells than
    that the their them then there these they this those though through too two under until use used
    very was way well were what when where whether which while who whole whose will with without you
    your""".split()
)

# Pages that are not about one entry: file, title, description, search words.
_PAGES = (
    (
        "index",
        "Start",
        "What there is, for whom, and where to begin.",
        "start download install source github license mit free price cost open project about overview",
    ),
    (
        "messages",
        "All messages",
        "By id and by name.",
        "message messages command commands list table index id ids all protocol serial api",
    ),
    (
        "framing",
        "Framing",
        "How to build and check frames and find them in a byte stream.",
        "frame frames header body start byte id size checksum sync line serial baud parity packet packets format protocol structure",
    ),
    (
        "decoder",
        "Decoder",
        "Shows the frames, fields, units and errors in bytes of a serial line.",
        "decode parse inspect hex bytes capture log dump frame frames",
    ),
    ("enums", "Enums and flags", "Meanings of numbers and bits.", "enum enums flag flags bits"),
    ("packed", "Packed values", "Several values in one integer, bit by bit.", "packed bits bit"),
    ("units", "Units", "Quantities with their exact scales.", "unit quantity scale factor"),
    (
        "variables",
        "Adjustable variables",
        "Parameters that can change while the device runs.",
        "variable variables parameter",
    ),
    (
        "availability",
        "Availability",
        "What each firmware and board version and each revision brought.",
        "changelog version versions firmware board revision revisions since history changes deprecated",
    ),
    (
        "errata",
        "Errata",
        "Where the specification is contradictory, incomplete or wrong.",
        "erratum mistakes contradictions assumptions specification",
    ),
)


@dataclass(frozen=True)
class Entry:
    """An entry of the index: kind, name, description, page, and other search words.

    `twins` are entries that are shown together with it: the writers of the settings that it reads.
    """

    kind: str
    name: str
    about: str
    page: str
    words: str = ""
    twins: tuple[Entry, ...] = ()

    @property
    def data(self) -> list[Any]:
        """The entry in the index: kind, name, about, page, words, then twins without their kind."""
        own = [self.kind, self.name, self.about, self.page, self.words]
        return [*own, [twin.data[1:] for twin in self.twins]] if self.twins else own


def search_index(
    layout: Layout,
    guides: Sequence[Guide],
    history: History,
    references: Sequence[Reference] = (),
    headers: Sequence[Header] = (),
) -> dict[str, Any]:
    """All entries, the most important first, groups of synonyms, and numbers of links in guides."""
    links = Counter(
        link for guide in guides for link in re.findall(r'href="\.\./([^"#]+)', guide.html)
    )
    return {
        "synonyms": [list(group) for group in layout.synonyms],
        "links": links,
        "entries": [
            entry.data
            for entries in (
                _entries(layout, guides, history),
                _references(references),
                _names_of_headers(headers),
            )
            for entry in entries
        ],
    }


def _entries(layout: Layout, guides: Sequence[Guide], history: History) -> Iterator[Entry]:
    yield from _messages(layout)
    yield from _commands(layout)
    yield from _pages(layout, history)
    for family in layout.families:
        if family.messages:
            page = f"families/{family.name}.html"
            yield Entry("family", title_of(family.name), family.summary, page)
    for guide in guides:
        yield from _guide(guide)
    for enum in layout.enums:
        kind = "flags" if enum.kind == "flags" else "enum"
        yield Entry(kind, enum.name, enum.summary, page_of(enum), _lines(enum.source))
    for packed in layout.packed:
        words = _joined(*(part.name for part in packed.parts), _lines(packed.source))
        yield Entry("packed", packed.name, packed.summary, page_of(packed), words)
    for quantity in layout.quantities:
        words = f"{_unit(quantity)} {quantity.scale_text}"
        yield Entry("unit", quantity.name, quantity.summary, page_of(quantity), words)
    for message in layout.definitions:
        if not message.same_as:
            yield from _fields(message, layout)
    for enum in layout.enums:
        for value in enum.values:
            page = f"{page_of(enum)}#{value.name}"
            words = f"{enum.name} {value.value}"
            words = _joined(words, *(alias.spec_name for alias in value.aliases))
            yield Entry("value", value.name, value.summary, page, words)
    for variable in layout.variables:
        page = f"variables.html#{variable.name}"
        yield Entry("variable", variable.name, variable.summary, page, str(variable.id))
    for erratum in layout.errata:
        page = f"errata.html#{erratum.number}"
        about = f"{erratum.problem} {erratum.reading}"
        yield Entry("erratum", erratum.number, about, page, _lines(*erratum.lines))


def _pages(layout: Layout, history: History) -> Iterator[Entry]:
    """The pages that are not about one entry, and the sections of the pages about versions."""
    sums = " ".join(sum_.kind for framing in layout.framings for sum_ in framing.checksums)
    for name, title, about, words in _PAGES:
        words += f" {sums}" if name == "framing" else ""
        yield Entry("page", title, about, f"{name}.html", words)
    about = "What this version added, changed and ended."
    for release in history.releases:
        for news in release.news:
            page = f"firmware/{release.text}.html#{news.text}"
            words = f"version availability {news.text}"
            yield Entry("version", f"Firmware {news.text}", about, page, words)
    for news in history.of_boards:
        page = f"availability.html#board-{news.text}"
        words = f"version availability {news.text}"
        yield Entry("version", f"Board {news.text}", about, page, words)
    for revision in layout.revisions:
        has_own = revision.adds or revision.changes
        anchor = f"revision-{revision.number}" if has_own else "revisions"
        words = _joined("rev", revision.number, revision.date, _lines(revision.source))
        name = f"Revision {revision.number}"
        yield Entry("page", name, f"Of {revision.date}.", f"availability.html#{anchor}", words)


def _names_of_headers(headers: Sequence[Header]) -> Iterator[Entry]:
    for header in headers:
        yield Entry("name", header.include, header.sentence, header.page)
        for item in header.items:
            words = " ".join(member.name for member in item.members)
            yield Entry("name", item.name, item.sentence, f"{header.page}#{item.anchor}", words)


def _joined(*words: str) -> str:
    return " ".join(word for word in words if word)


def _lines(*sources: str) -> str:
    """The line ranges of the specification in sources, each as a word: "L12 L20-L31"."""
    ranges = (found for text in sources for found in re.findall(r"L([0-9]+)(?:-L?([0-9]+))?", text))
    words = (f"L{first}-L{last}" if last else f"L{first}" for first, last in ranges)
    return " ".join(dict.fromkeys(words))


def _messages(layout: Layout) -> Iterator[Entry]:
    def entry(message: Message, *twins: Message) -> Entry:
        numbers = f"{message.command} {message.id} 0x{message.id:02x}"
        words = _joined(numbers, _lines(message.source))
        others = tuple(map(entry, twins))
        return Entry("message", message.name, message.summary, page_of(message), words, others)

    writers = {s.message.name: s.writers for s in layout.settings}
    second = {twin.name for twins in writers.values() for twin in twins}
    for message in layout.definitions:
        if message.name not in second:
            yield entry(message, *writers.get(message.name, ()))


def _commands(layout: Layout) -> Iterator[Entry]:
    by_name = {command.name: command for command in layout.commands}

    def entry(command: Command, *twins: Command) -> Entry:
        page = f"families/{command.family}.html#{command.name}"
        number = "" if command.id is None else f"{command.id} 0x{command.id:02x}"
        others = tuple(map(entry, twins))
        words = _joined(number, _lines(command.source))
        return Entry("command", command.name, command.summary, page, words, others)

    writers = {
        s.message.command: [by_name[w.command] for w in s.writers if w.command != s.message.command]
        for s in layout.settings
    }
    second = {twin.name for twins in writers.values() for twin in twins}
    for command in layout.commands:
        if command.name not in second:
            yield entry(command, *writers.get(command.name, ()))


def _unit(quantity: Quantity) -> str:
    """The words for the unit of a quantity: "V volts", "deg/s degrees per second"."""
    return f"{quantity.unit or ''} {quantity.accessor.replace('_', ' ')}".strip()


def _fields(message: Message, layout: Layout) -> Iterator[Entry]:
    twins = [m.name for m in layout.definitions if m.same_as == message.name]
    for row in rows_of(message):
        if row.field.reserved:
            continue
        anchor = row.leaves[0].path if row.leaves else row.path
        page = f"{page_of(message)}#field-{anchor}"
        words = " ".join([*_words_of(row), *_topics_of(row, layout), *twins])
        yield Entry("field", f"{message.name}.{row.path}", row.field.summary, page, words)


def _topics_of(row: Row, layout: Layout) -> Iterator[str]:
    """The words of its topics, which are less specific for a field than its name: "~gain"."""
    topics = chain.from_iterable((t.name, *t.words) for t in layout.topics_of(row.field))
    yield from (f"~{word}" for text in topics for word in text.split())


def _words_of(row: Row) -> Iterator[str]:
    """More search words of a field: its names in the specification, its paths, its unit."""
    yield from dict.fromkeys(leaf.spec_name for leaf in row.leaves)
    yield from (alias.spec_name for alias in row.field.aliases)
    if len(row.leaves) <= 6:
        yield from (leaf.path for leaf in row.leaves if leaf.path != row.path)
    if isinstance(row.field.type, Quantity) and row.field.type.unit:
        yield _unit(row.field.type)


def _references(references: Sequence[Reference]) -> Iterator[Entry]:
    """The references of libraries, and their functions and classes."""
    for reference in references:
        words = f"{reference.language.lower()} library package api module"
        title = f"{reference.language} reference"
        yield Entry("page", title, reference.parts[0].summary, reference.page, words)
        seen = set()
        for anchor, thing in anchors_of(reference):
            if thing.kind in ("class", "function") and thing.name not in seen:
                seen.add(thing.name)
                about = f"{reference.language}: {thing.summary}"
                yield Entry("name", anchor, about, f"{reference.page}#{anchor}")


# Guides


def _guide(guide: Guide) -> Iterator[Entry]:
    """A guide, and each of its sections.

    A part has its own words, and additional search words: `<!-- search: jitter, jello -->`.
    """
    start, *sections = guide.split("23")
    first = re.search(r"<p>(.*?)</p>", start.html, re.DOTALL)
    about = _text(first[1]) if first else ""
    yield Entry("guide", guide.title, about, guide.page, _words_of_part(start.html))
    for part in sections:
        page = f"{guide.page}#{part.anchor}"
        about = f"in {guide.title}"
        yield Entry("section", _text(part.heading), about, page, _words_of_part(part.html))


def _words_of_part(html: str) -> str:
    """The vocabulary of a part of a guide, and its additional search words: "!jitter"."""
    asked = re.findall(r"<!-- search: (.*?) -->", html, re.DOTALL)
    words = dict.fromkeys(unescape(" ".join(asked)).replace(",", " ").lower().split())
    return _joined(*(f"!{word}" for word in words), _vocabulary(html))


def _text(html: str) -> str:
    return " ".join(unescape(re.sub(r"<[^>]*>", "", html)).split())


def _vocabulary(html: str) -> str:
    """The distinct words of a text without code blocks and stop words."""
    prose = _text(re.sub(r"<pre.*?</pre>", " ", html, flags=re.DOTALL).replace("<", " <"))
    words = re.findall(r"[a-z][a-z0-9_]{2,}", prose.lower())
    return " ".join(dict.fromkeys(word for word in words if word not in _COMMON))
