"""The public C++ headers of the project, parsed by Doxygen, for the pages of the C++ reference."""

from __future__ import annotations

import re
import subprocess
import tempfile
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from textwrap import dedent, fill, indent
from xml.etree.ElementTree import Element, parse

from markupsafe import Markup, escape

from sbgcgen.model import Layout
from sbgcgen.targets.site.uses import page_of

SETTINGS = Path("docs/Doxyfile")
# For each release, its version and, indented, the names it introduced: "Client{call close}" has two members.
SINCE = Path("docs/since.txt")
# Longer declarations have a line for each parameter.
_WIDTH = 90


@dataclass(frozen=True)
class Item:
    """A public name: a class with its members, a function, a constant, an alias, an enum with its values."""

    kind: str
    name: str
    anchor: str
    code: Markup
    text: Markup
    members: tuple[Item, ...] = ()
    # The members of its base classes, by the names of these.
    inherited: tuple[tuple[str, tuple[Item, ...]], ...] = ()
    line: int = 0
    # The path from the root of the site, with the anchor.
    page: str = ""
    # The release that introduced the name; "" if none has yet.
    since: str = ""

    @property
    def sentence(self) -> str:
        return _first_sentence(Markup(str(self.text).replace("</p>", "</p> ")).striptags())


@dataclass(frozen=True)
class Header:
    """A header: `include` is "sbgc/client/motion.hpp", `component` the library that it belongs to."""

    include: str
    component: str
    lead: Markup
    text: Markup
    lines: tuple[str, ...]
    items: tuple[Item, ...]
    includes: tuple[str, ...]

    @property
    def order(self) -> int:
        return _ORDER.index(self.component)

    @property
    def word(self) -> str:
        return self.include.removeprefix("sbgc/").removesuffix(".hpp")

    @property
    def page(self) -> str:
        return f"headers/{self.word}.html"

    @property
    def source(self) -> str:
        return f"source/{self.word}.html"

    @property
    def sentence(self) -> str:
        return _first_sentence(self.lead.striptags())


def headers_of(project: Path, layout: Layout) -> list[Header]:
    """The headers of a project, sorted by component and name; none if it has no settings for Doxygen."""
    if not (project / SETTINGS).is_file():
        return []
    with tempfile.TemporaryDirectory() as folder:
        settings = f"@INCLUDE = {SETTINGS}\nOUTPUT_DIRECTORY = {folder}\nSTRIP_FROM_PATH = .\n"
        subprocess.run(["doxygen", "-"], input=settings, text=True, cwd=project, check=True)
        compounds = [
            found
            for path in sorted(Path(folder, "xml").glob("*.xml"))
            for found in parse(path).getroot().iter("compounddef")
        ]
    return _Reader(project, layout, compounds).headers()


def record_names(project: Path, layout: Layout, version: str) -> None:
    """Records the release that introduced each name which no earlier one had."""
    names = [
        n for h in headers_of(project, layout) for i in h.items for n in _names(i) if not n.since
    ]
    if names:
        text = fill(_grouped({name.anchor for name in names}), 118, break_on_hyphens=False)
        with (project / SINCE).open("a", encoding="utf-8") as file:
            file.write(f"{version}:\n{indent(text, '  ')}\n")


def _grouped(names: set[str]) -> str:
    """Names with their members in braces."""
    members: dict[str, list[str]] = {}
    for name in sorted(names):
        owner, _, member = name.rpartition(".")
        members.setdefault(owner, []).append(member)
    top = [] if "" not in members else members.pop("")
    return " ".join([*top, *(f"{owner}{{{' '.join(of)}}}" for owner, of in members.items())])


def _ungrouped(text: str) -> Iterator[str]:
    for owner, members, name in re.findall(r"(\S+)\{([^}]*)\}|(\S+)", text):
        yield from (f"{owner}.{member}" for member in members.split())
        if name:
            yield name


def _names(item: Item) -> Iterator[Item]:
    yield item
    for member in item.members:
        yield from _names(member)


def _since(project: Path) -> dict[str, str]:
    """The releases by the anchors of the names that they introduced."""
    path = project / SINCE
    releases = re.split("(?m)^(?=\\S)", path.read_text("utf-8")) if path.is_file() else []
    parts = (release.split(":", 1) for release in releases if release)
    return {name: version for version, names in parts for name in _ungrouped(names)}


def linked(code: str, headers: Sequence[Header], layout: Layout) -> Markup:
    """Code that uses the library, with links from headers, names and messages to their pages."""
    pages = {f"sbgc::msg::{name}": page for name, page in _types(layout).items()}
    for family in layout.families:
        pages[f"sbgc/messages/{family.name}.hpp"] = f"families/{family.name}.html"
    for header in headers:
        pages[header.include] = header.page
        for item in header.items:
            pages.setdefault(f"sbgc::{item.name}", f"{header.page}#{item.anchor}")
    result, end = Markup(), 0
    for match in re.finditer(r"sbgc/[\w/]+\.hpp|sbgc::(?:msg::)?\w+", code) if headers else ():
        if page := pages.get(match[0]):
            result += escape(code[end : match.start()]) + _link(page, match[0])
            end = match.end()
    return result + escape(code[end:])


def _types(layout: Layout) -> dict[str, str]:
    """The pages of messages and types by their names."""
    return {item.name: page_of(item) for item in (*layout.definitions, *layout.types)}


def _link(page: str, text: str) -> Markup:
    # The template knows the path to the root.
    return Markup('<a href="{}">{}</a>').format("ROOT/" + page, text)


def _first_sentence(text: str) -> str:
    return re.split(r"(?<=\.)(?<!e\.g\.)\s", " ".join(text.split()), maxsplit=1)[0]


def _text_of(element: Element, tag: str) -> str:
    return " ".join((element.findtext(tag) or "").split())


def _location(element: Element) -> tuple[str, int]:
    found = element.find("location")
    assert found is not None
    return found.get("declfile", found.get("file", "")), int(found.get("line", "0"))


class _Reader:
    """Converts Doxygen's XML to headers; its links lead to other elements and to messages."""

    def __init__(self, project: Path, layout: Layout, compounds: list[Element]) -> None:
        self.project = project
        self.files = {_location(c)[0]: c for c in compounds if c.get("kind") == "file"}
        self.declared: dict[str, list[Element]] = {path: [] for path in self.files}
        for element in sorted(self._public(compounds), key=_location):
            self.declared[_location(element)[0]].append(element)
        self.pages: dict[str, str] = {}  # by the id of Doxygen
        self.compounds = {compound.get("id"): compound for compound in compounds}
        # The values of ErrorCode, by Doxygen's ids.
        self.codes = {
            _text_of(value, "name"): value.get("id", "")
            for compound in compounds
            for enum in compound.iter("memberdef")
            if enum.findtext("name") == "ErrorCode"
            for value in enum.iter("enumvalue")
        }
        self.types = _types(layout)
        self.since = _since(project)
        self.includes = {"sbgc/client/calls.hpp": "messages.html"}
        for path in self.files:
            include = path.partition("/include/")[2]
            self.includes[include] = f"headers/{include[5:].removesuffix('.hpp')}.html"
            self.pages[self.files[path].get("id", "")] = self.includes[include]
        for family in layout.families:
            self.includes[f"sbgc/messages/{family.name}.hpp"] = f"families/{family.name}.html"
        # The functions of namespaces by the last component of the namespace and their own name.
        self.functions = {
            (
                _text_of(compound, "compoundname").rpartition("::")[2],
                _text_of(member, "name"),
            ): member
            for compound in compounds
            if compound.get("kind") == "namespace"
            for member in compound.iter("memberdef")
            if member.get("kind") == "function" and self._description_parts(member)
        }

    @staticmethod
    def _public(compounds: list[Element]) -> Iterator[Element]:
        """Macros, and the members of namespaces, without specializations."""
        kinds = ("class", "struct", "concept")
        classes = {c.findtext("compoundname"): c for c in compounds if c.get("kind") in kinds}
        for name, compound in classes.items():
            if name and "<" not in name and name.rpartition("::")[0] not in classes:
                yield compound
        for compound in compounds:
            if compound.get("kind") in ("namespace", "file"):
                for member in compound.iter("memberdef"):
                    is_macro = member.get("kind") == "define"
                    has_comment = member.find("briefdescription/para") is not None
                    name = member.findtext("name") or ""
                    if has_comment if is_macro else not re.search(r"(?<!operator)<.*>$", name):
                        yield member

    def headers(self) -> list[Header]:
        """Headers with public names, and headers that only include others."""
        paths = [
            path
            for path, elements in self.declared.items()
            if elements or "namespace detail" not in (self.project / path).read_text("utf-8")
        ]
        for path in paths:
            self._number(path)
        return sorted(map(self._header, paths), key=lambda header: (header.order, header.include))

    def _number(self, path: str) -> None:
        """Assigns an anchor to each name of a header, and to each member."""
        taken: set[str] = set()
        page = f"headers/{path.partition('/include/sbgc/')[2].removesuffix('.hpp')}.html"

        def give(element: Element, name: str) -> None:
            name = name.replace(" ", "-")  # of conversions: operator bool
            anchor, count = name, 1
            while anchor in taken and self._description(element):
                count += 1
                anchor = f"{name}-{count}"
            taken.add(anchor)
            self.pages[element.get("id", "")] = f"{page}#{anchor}"
            for member in self._members(element):
                give(member, f"{name}.{_text_of(member, 'name')}")

        for element in self.declared[path]:
            give(element, self._name(element))

    def _header(self, path: str) -> Header:
        component, _, include = path.partition("/include/")
        text = (self.project / path).read_text(encoding="utf-8")
        about = re.match(r"(?:///.*\n)*", text)
        assert about is not None
        lead, *more = re.split(r"\n\s*\n", re.sub(r"^/// ?", "", about[0], flags=re.MULTILINE))
        others = tuple(name.text or "" for name in self.files[path].findall("includes"))
        items = tuple(self._items(self.declared[path]))
        after = Markup().join(map(self._paragraph, more))
        library, lines = Path(component).name, tuple(text.splitlines())
        return Header(include, library, self._inline(lead), after, lines, items, others)

    def _inline(self, text: str) -> Markup:
        return Markup(re.sub(r"`([^`]+)`", r"<code>\1</code>", str(self._words(text))))

    def _paragraph(self, text: str) -> Markup:
        """A paragraph of the comment of a header: code, a list or prose."""
        if text.startswith("    "):
            return Markup('<pre tabindex="0"><code>{}</code></pre>').format(dedent(text).rstrip())
        start, *entries = re.split(r"^- ", text, flags=re.MULTILINE)
        points = Markup().join(Markup("<li>{}</li>").format(self._inline(e)) for e in entries)
        prose = Markup("<p>{}</p>").format(self._inline(start)) if start.strip() else Markup()
        return prose + (Markup("<ul>{}</ul>").format(points) if entries else "")

    def _name(self, element: Element) -> str:
        name = element.findtext("name") or element.findtext("compoundname") or ""
        return name.rpartition("::")[2] if element.tag == "compounddef" else name

    def _items(self, elements: list[Element]) -> list[Item]:
        """The items of elements; an overload without a description belongs to the first one."""
        found: dict[str, Item] = {}
        for item in map(self._item, elements):
            if first := found.get(item.anchor):
                item = replace(first, code=first.code + "\n" + item.code)
            found[item.anchor] = item
        return list(found.values())

    def _item(self, element: Element) -> Item:
        members = tuple(self._members_of(element))
        page = self.pages[element.get("id", "")]
        code, text = self._code(element), self._description(element)
        kind = element.get("kind", "")
        kind = {"typedef": "alias", "variable": "constant", "define": "macro"}.get(kind, kind)
        inherited = tuple(self._inherited(element))
        name, anchor = self._name(element), page.partition("#")[2]
        line = 0 if element.tag == "enumvalue" else _location(element)[1]
        since = self.since.get(anchor, "")
        return Item(kind, name, anchor, code, text, members, inherited, line, page, since)

    def _inherited(self, element: Element) -> Iterator[tuple[str, tuple[Item, ...]]]:
        for reference in element.findall("basecompoundref"):
            base = self.compounds.get(reference.get("refid"))
            if base is not None and base.get("id") in self.pages:
                yield self._name(base), tuple(self._members_of(base))

    def _members_of(self, element: Element) -> Iterator[Item]:
        """Members as items. A member without a description has that of the function with its name in the
        namespace that the description of its class names: tasks::move_to().
        """
        spaces = re.findall(r"\b(\w+)::", self._description(element).striptags())
        for item in self._items(self._members(element)):
            twins = (self.functions.get((space, item.name)) for space in spaces)
            twin = None if item.text else next((t for t in twins if t is not None), None)
            if twin is not None:
                note = Markup("<p>See {}.</p>").format(
                    _link(self.pages[twin.get("id", "")], f"{twin.findtext('name')}()")
                )
                item = replace(item, text=self._description(twin) + note)
            yield item

    def _members(self, element: Element) -> list[Element]:
        """The public members in source order, without those that the compiler generates."""
        if element.get("kind") == "enum":
            return element.findall("enumvalue")
        found = []
        for member in element.iter("memberdef") if element.tag == "compounddef" else ():
            name, ending = _text_of(member, "name"), _text_of(member, "argsstring")
            is_special = ending.endswith(("=default", "=delete")) or name[0] == "~"
            if member.get("prot") == "public" and member.get("kind") != "friend":
                if not is_special or self._description(member):
                    found.append(member)
        return sorted(found, key=_location)

    # Declarations

    def _code(self, element: Element) -> Markup:
        template = self._template(element)
        kind, name = element.get("kind"), self._name(element)
        if element.tag == "enumvalue":
            return Markup(escape(f"{name} {_text_of(element, 'initializer')}".rstrip()))
        if kind in ("class", "struct"):
            bases = [
                self._reference(base, re.sub(r"sbgc::|(?<=<) | (?=>)", "", base.text or ""))
                for base in element.findall("basecompoundref")
            ]
            derived = Markup(" : ") + Markup(", ").join(bases) if bases else Markup()
            return template + Markup(f"{kind} {name}") + derived
        if kind == "concept":
            return Markup(
                str(self._linked(element.find("initializer"))).replace(f"sbgc::{name}", name)
            )
        type_ = self._linked(element.find("type"))
        if kind == "typedef":
            return template + Markup("using {} = {}").format(name, type_)
        if kind == "define":
            return escape(f"#define {name}")
        if kind == "enum":
            return Markup("enum class {}").format(name) + (Markup(" : ") + type_ if type_ else "")
        start = template + (Markup("{} {}").format(type_, name) if type_ else escape(name))
        if element.get("static") == "yes":
            start = template + Markup("static ") + Markup(str(start).removeprefix(str(template)))
        if kind == "variable":
            found = element.find("initializer")
            value = "" if found is None else " ".join("".join(found.itertext()).split())
            if value in ("", "{}") or value[:2] == "{{" or len(value) > 50:
                return start
            return start + escape(value if value[0] == "{" else f" {value}")
        return start + self._arguments(element, len(start.striptags()))

    def _template(self, element: Element) -> Markup:
        found = element.find("templateparamlist")
        if found is None or element.get("kind") == "concept":
            return Markup()
        line = escape("template <") + Markup(", ").join(self._parameters(found)) + ">"
        return line + "\n"

    def _parameters(self, element: Element) -> list[Markup]:
        result = []
        for parameter in element.findall("param"):
            text = self._linked(parameter.find("type"))
            if name := _text_of(parameter, "declname"):
                text += f" {name}"
            if (value := parameter.find("defval")) is not None:
                text += Markup(" = ") + self._linked(value)
            result.append(text)
        return result

    def _arguments(self, element: Element, before: int) -> Markup:
        parameters = self._parameters(element)
        ending = _text_of(element, "argsstring").rpartition(")")[2]
        ending = re.sub(r"=(0|default|delete)$", r" = \1", ending)
        clause = element.find("requiresclause")
        after = escape(ending) + (
            Markup("\n    requires ") + self._linked(clause) if clause is not None else ""
        )
        length = before + sum(len(p.striptags()) + 2 for p in parameters) + len(ending)
        between = ",\n    " if length > _WIDTH and len(parameters) > 1 else ", "
        first = between[1:] if "\n" in between else ""
        return Markup("(") + first + Markup(between).join(parameters) + ")" + after

    def _linked(self, element: Element | None) -> Markup:
        """The text of a type or value, with links."""
        if element is None:
            return Markup()
        result = self._words(element.text or "")
        for part in element:
            result += self._reference(part, "".join(part.itertext()))
            result += self._words(part.tail or "")
        plain = re.sub(r"&lt; | (?=&gt;|&amp;|\*)", lambda m: m[0].strip(), str(result))
        return Markup(plain.strip())

    def _words(self, text: str) -> Markup:
        """Text with links to messages and types of the protocol, to headers and to guides."""

        def link(match: re.Match[str]) -> Markup:
            if match[2]:
                return _link(f"guides/{match[2]}.html", match[2].replace("-", " "))
            page = self.types.get(match[1]) if match[1] else self.includes.get(match[3])
            return _link(page, match[0]) if page else escape(match[0])

        parts, end = Markup(), 0
        text = re.sub(r"\s+", " ", text)
        names = r"\bmsg::(\w+)|docs/[0-9]+-([\w-]+)\.md|<?(sbgc/[\w/]+\.hpp)>?"
        for match in re.finditer(names, text):
            parts += escape(text[end : match.start()]) + link(match)
            end = match.end()
        return parts + escape(text[end:])

    def _reference(self, element: Element, text: str) -> Markup:
        """A link to the target of an element."""
        page = self.pages.get(element.get("refid", ""))
        return _link(page, text) if page else escape(text)

    # Descriptions

    def _description(self, element: Element) -> Markup:
        text = Markup().join(map(self._block, self._description_parts(element))).strip()
        # The descriptions of a function form a paragraph, with links.
        return Markup(
            re.sub(r"(?:<p>|\s)Errors(?=[:,]\s)(.*?</p>)", self._errors, str(text), flags=re.S)
        )

    def _errors(self, match: re.Match[str]) -> str:
        def link(code: re.Match[str]) -> str:
            page = self.pages.get(self.codes.get(code[1], ""))
            return str(_link(page, code[1])) if page else code[0]

        start = match[0][:3] == "<p>"
        text = re.sub(r"<code>(\w+)</code>", link, match[1])
        return f"{'' if start else '</p>'}<p><strong>Errors</strong>{text}"

    @staticmethod
    def _description_parts(element: Element) -> list[Element]:
        parts = (element.find(tag) for tag in ("briefdescription", "detaileddescription"))
        return [part for part in parts if part is not None and part.find("para") is not None]

    def _block(self, element: Element) -> Markup:
        """The contents of an element. Fails for unknown ones, so that nothing is lost."""
        result = self._prose(element.text or "")
        for part in element:
            tag = part.tag
            if tag == "verbatim":
                lines = (part.text or "").strip("\n")
                result += Markup('</p><pre tabindex="0"><code>{}</code></pre><p>').format(lines)
            elif tag == "ref":
                result += self._reference(part, "".join(part.itertext()))
            else:
                result += _BLOCKS[tag](self._block(part))
            result += self._prose(part.tail or "")
        return result

    def _prose(self, text: str) -> Markup:
        return self._words(text) if text.strip() else Markup(" " if text else "")


def _element(name: str) -> Callable[[Markup], Markup]:
    return lambda content: Markup(f"<{name}>{{}}</{name}>").format(content)


_BLOCKS: dict[str, Callable[[Markup], Markup]] = {
    "para": lambda content: Markup(
        re.sub(r"<p>\s*</p>", "", str(_element("p")(Markup(content.strip()))))
    ),
    "computeroutput": _element("code"),
    "emphasis": _element("em"),
    "bold": _element("strong"),
    "itemizedlist": lambda content: Markup("</p><ul>{}</ul><p>").format(content),
    "listitem": lambda content: Markup("<li>{}</li>").format(
        Markup(re.sub("</?p>", "", str(content)))
    ),
}

# The libraries, in the order of the introduction.
_ORDER = ("core", "session", "any", "tasks", "io", "client", "emulator")
