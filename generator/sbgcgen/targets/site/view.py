"""The view of the reference site's templates: guides, captures, cross-references and filters."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, partial
from html import unescape
from itertools import chain
from pathlib import Path
from typing import Any
from urllib.parse import quote

from jinja2.utils import htmlsafe_json_dumps
from markupsafe import Markup, escape

from sbgcgen import library
from sbgcgen.model import Availability, Enum, Layout, Leaf, Message, Packed, Revision
from sbgcgen.model.export import export
from sbgcgen.oracle.example import Example, example_of, physical
from sbgcgen.targets import Items, Target, View, codes_of, conversions_of, references_of
from sbgcgen.targets.render import expand, sources_of
from sbgcgen.targets.site import rows, uses
from sbgcgen.targets.site.builder import builder_facts
from sbgcgen.targets.site.documentation import Documentation
from sbgcgen.targets.site.guides import Guide, Pages, front_of, guides_in, name_of
from sbgcgen.targets.site.headers import Header, headers_of, linked
from sbgcgen.targets.site.related import Relations
from sbgcgen.targets.site.search import search_index
from sbgcgen.targets.site.uses import page_of
from sbgcgen.views.firmware import History, deprecated_always
from sbgcgen.views.rows import Row, rows_of as rows_of_message
from sbgcgen.views.settings import send_command


class Revisions:
    """An index of the additions of all revisions."""

    def __init__(self, layout: Layout) -> None:
        self._of = {
            (addition.kind, addition.owner, addition.name): revision
            for revision in layout.revisions
            for addition in revision.adds
        }
        self._same = {m.name: m.same_as for m in layout.messages if m.same_as}

    def of(self, kind: str, owner: str, name: str) -> Revision | None:
        """The revision that added something; for a field, also the one that added its group.

        A message with the same body as another has the fields of that message.
        """
        owner = self._same.get(owner, owner) if kind == "field" else owner
        name = re.sub(r"\[\d*\]", "", name) if kind == "field" else name
        found = self._of.get((kind, owner, name))
        while found is None and kind == "field" and "." in name:
            name = name.rpartition(".")[0]
            found = self._of.get((kind, owner, name))
        return found

    def of_message(self, message: Message) -> Revision | None:
        """The revision that added a message, or its command."""
        return self.of("message", "", message.name) or self.of("command", "", message.command)


def captures_in(folder: Path) -> dict[str, str]:
    """Bytes for trying the decoder by title, in the format of `sbgc decode --hex`: docs/captures/<title>.hex."""
    paths = sorted(folder.glob("*.hex"))
    return {name_of(p.stem).replace("-", " ").capitalize(): p.read_text("utf-8") for p in paths}


def view_of(site: Target, layout: Layout, project: Path) -> View:
    """The view of the templates; the guides and the version are those of the project.

    Raises ValueError if two pages would have the same path.
    """
    docs = project / "docs"
    version = library.version(project) if (project / library.VERSION_HEADER).is_file() else ""
    headers = headers_of(project, layout)
    references = references_of(project)
    handwritten = Pages(
        headers,
        {reference.source: reference.page for reference in references},
        {message.name.lower(): page_of(message) for message in layout.definitions},
    )
    guides = guides_in(docs, handwritten)
    history = History(layout)
    each: dict[str, Items] = {
        "guide": [(guide.name, guide) for guide in guides],
        "header": [(header.word, header) for header in headers],
        "source": [(header.word, header) for header in headers],
        "headers": [("headers", headers)] if headers else [],
        "reference": [(reference.word, reference) for reference in references],
        "release": [(release.text, release) for release in history.releases],
    }
    references_of_names = uses.references(layout)
    pages = [path for _, path, _ in expand(sources_of(site), layout, each)]
    twice = {page for page in pages if pages.count(page) > 1}
    if twice:
        raise ValueError(f"several pages have the path {min(twice)}")
    names: dict[str, Any] = {
        "pages": frozenset(pages),
        "version": version,
        "fingerprint": export(layout)["fingerprint"],
        "front": front_of(project, handwritten),
        "guides": guides,
        "headers": headers,
        "references": references,
        "captures": captures_in(docs / "captures"),
        "uses": references_of_names,
        "related": Relations(layout, guides, references_of_names).of,
        "errata": {erratum.number: erratum for erratum in layout.errata},
        "history": history,
        "revisions": Revisions(layout),
        "guide_pages": {
            about: f"guides/{name_of(Path(path).stem)}.html"
            for about, path in layout.guides.items()
            if f"guides/{name_of(Path(path).stem)}.html" in pages
        },
        "deprecated_always": deprecated_always(layout),
        "confirmation": next(iter(layout.having_role("confirmation")), None),
        "search_index": search_index(layout, guides, history, references, headers),
    }
    tests: dict[str, Callable[..., bool]] = {
        "mentions": lambda guide, word: str(word) in guide.html,
        "containing": lambda names, name: name in names,
        "an_enum_or_flags": lambda type_: isinstance(type_, Enum),
    }
    filters = _filters(layout, headers) | {"example_in_guides": partial(_example_in, guides)}
    return View(names=names, filters=filters, tests=tests, each=each)


def _example_in(guides: list[Guide], include: str) -> str:
    """The shortest program in the guides that includes a header; "" if there is none."""
    blocks = (re.findall(r'<code class="language-cpp">(.*?)</code>', g.html, re.S) for g in guides)
    programs = [unescape(block) for block in chain.from_iterable(blocks)]
    return min((p for p in programs if f"#include <{include}>" in p), key=len, default="")


def _filters(layout: Layout, headers: list[Header]) -> dict[str, Callable[..., Any]]:
    """The filters of the site's templates."""
    prose = _Prose(layout)
    undocumented = {command.name for command in layout.commands if command.undocumented}
    rows_of = cache(rows_of_message)
    types = uses.availability_of_types(layout)

    def all_errata(message: Message) -> list[str]:
        numbers = {*message.errata, *(n for row in rows_of(message) for n in row.field.errata)}
        numbers.update(
            n for leaf in message.leaves if leaf.direction for n in leaf.direction.errata
        )
        for instance in uses.instances(message, layout):
            numbers.update(instance.errata)
            numbers.update(instance.answer.errata if instance.answer else ())
        return sorted(numbers)

    return {
        "compact_json": lambda data: htmlsafe_json_dumps(data, separators=(",", ":")),
        "page": page_of,
        "prose": prose,
        "rows": rows_of,
        "siblings": lambda message: [m for m in layout.messages if m.id == message.id],
        "instances": lambda message: uses.instances(message, layout),
        "sizes": lambda message: rows.sizes_of(message, layout),
        "byte_map": rows.byte_map,
        "bits": bits_of,
        "builder_facts": builder_facts,
        "bit_range": bit_range,
        "later_leaves": lambda message: later_leaves(message, rows_of(message)),
        "needs": lambda type_: types.get(type_.name, Availability()),
        "all_errata": all_errata,
        "is_undocumented": lambda name: name in undocumented,
        "example": lambda message: example_for_page(message, layout),
        "codes": codes_of,
        "send_command": send_command,
        "conversions": conversions_of,
        "documentation": Documentation,
        "hex_bytes": lambda data: bytes(data).hex(" ").upper(),
        "plain": plain,
        "physical": lambda raw, quantity: physical(int(raw), quantity),
        "fragment": fragment,
        "breakable": lambda name: escape(name).replace("_", Markup("_<wbr>")),
        "breakable_word": breakable_word,
        "bits_hex": lambda value, size: f"0x{value & ((1 << 8 * size) - 1):0{2 * size}X}",
        "short": short,
        "label": label,
        "linked": lambda code: linked(code, headers, layout),
        "rooted": lambda html, root: Markup(str(html).replace('href="ROOT/', f'href="{root}')),
        "size_words": size_words,
        "offset_words": offset_words,
    }


def example_for_page(message: Message, layout: Layout) -> Example:
    """The example of a message; for one in both directions, that of the request."""
    instances = uses.instances(message, layout)
    return example_of(next((m for m in instances if m.direction == "to_board"), message), layout)


def later_leaves(message: Message, of: list[Row]) -> dict[str, Availability]:
    """The first versions of the leaves that are newer than their message, by path."""
    return {
        leaf.path: row.since
        for row in of
        for leaf in row.leaves
        if row.since.is_after(message.since)
    }


def fragment(link: str) -> str:
    """A link with an escaped fragment."""
    page, mark, name = link.partition("#")
    return page + mark + quote(name)


class _Prose:
    """Adds links to the commands, messages and errata named in a text; text in backticks is code."""

    def __init__(self, layout: Layout) -> None:
        pages = {c.name: f"families/{c.family}.html#{c.name}" for c in layout.commands}
        pages.update({e.number: f"errata.html#{e.number}" for e in layout.errata})
        pages.update({m.name: page_of(m) for m in layout.definitions})
        self.pages = pages
        self.known = re.compile(
            rf"\b({layout.command_prefix}[A-Z0-9_]+|E[0-9]{{3}}|(?:[A-Z][a-z0-9]+){{2,}})\b"
        )

    def __call__(self, text: str, root: str) -> Markup:
        result, link = Markup(), Markup('<a href="{}">{}</a>')
        for part in self.known.split(text):
            page = self.pages.get(part)
            result += link.format(root + page, part) if page else escape(part)
        return Markup(re.sub(r"`([^`]+)`", r"<code>\1</code>", str(result)))


# Words


def breakable_word(name: str) -> Markup:
    """A name that may be too long for the menu, with break opportunities between its words."""
    if len(name) <= 22:
        return escape(name)
    return Markup(re.sub(r"(?<=[a-z0-9_])(?=[A-Z])", "<wbr>", escape(name)))


def plain(value: Fraction) -> str:
    """An exact number as a decimal if possible, such as 255 or -0.5, else as a fraction."""
    if value.denominator == 1:
        return str(value.numerator)
    text = f"{float(value):.10g}"
    return text if Fraction(text) == value else str(value)


def short(path: str) -> str:
    """The last two steps of a path, which fit into a cell: axes.roll.speed -> roll.speed."""
    return ".".join(path.split(".")[-2:])


def label(row: Row) -> str:
    """The label of a row: its name, with .* if it is repeated for each axis."""
    return row.path.rpartition(".")[2] if row.path[-1] != "*" else row.path.split(".")[-2] + ".*"


def size_words(leaf: Leaf) -> str:
    """The size of a leaf without a fixed place, in words."""
    size = leaf.size
    if size is not None:
        return f"{size} byte" + "s" * (size != 1)
    return "each " + leaf.type if leaf.type not in ("bytes", "text", "string") else leaf.type


def offset_words(leaf: Leaf, row: Row) -> str:
    if leaf.offset is None:
        return "varies"
    return f"{leaf.offset}…" if "[]" in leaf.path and "[]" in row.path else str(leaf.offset)


def bit_range(mask: int) -> str:
    """The bits of a mask: "7", "0..3", "0, 2"."""
    bits = [bit for bit in range(mask.bit_length()) if mask >> bit & 1]
    if len(bits) > 1 and bits[-1] - bits[0] + 1 == len(bits):
        return f"{bits[0]}..{bits[-1]}"
    return ", ".join(map(str, bits))


@dataclass(frozen=True)
class Bits:
    """Adjacent bits of a packed integer in the same part; `name` is "" for unused bits."""

    name: str
    label: str
    width: int
    number: int


def bits_of(packed: Packed) -> list[Bits]:
    """The bits of a packed integer, the highest first; parts of decimal digits as one run."""
    total = 8 * packed.scalar.size
    if any(part.is_digits for part in packed.parts):
        names = ", ".join(part.name for part in packed.parts)
        return [Bits(names, f"{total - 1}..0, decimal digits", total, 0)]
    owner = [
        next((i for i, part in enumerate(packed.parts) if part.bits >> bit & 1), None)
        for bit in range(total)
    ]
    result: list[Bits] = []
    high = total - 1
    for bit in range(total - 1, -1, -1):
        if bit and owner[bit - 1] == owner[bit]:
            continue
        number = owner[bit]
        name = packed.parts[number].name if number is not None else ""
        text = str(bit) if high == bit else f"{high}..{bit}"
        result.append(Bits(name, text, high - bit + 1, number or 0))
        high = bit - 1
    return result
