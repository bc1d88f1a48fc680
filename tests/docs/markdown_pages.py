"""The text of generated/docs/: sections and table rows, without the markup."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from html import unescape

from facts import Place

_COLUMNS = {
    "field": "Field",
    "spec name": "In the specification",
    "offset": "Offset",
    "type": "Type",
    "unit": "Values",
    "range": "Raw range",
    "setting": "Setting",
    "meaning": "Meaning",
    "name": "Name",
    "number": "Value",
    "id": "Id",
}


def plain(text: str) -> str:
    """Returns the text without Markdown."""
    text = re.sub(r"\[((?:[^\]\\]|\\.)*)\]\([^)]*\)", r"\1", text)
    text = re.sub(r"<[/!a-z][^>]*>", " ", text)
    parts = re.split(r"(`[^`]*`)", text)
    for i in range(0, len(parts), 2):
        parts[i] = re.sub(r"(?<!\\)\*", "", parts[i])
        parts[i] = unescape(re.sub(r"\\([^A-Za-z0-9\s])", r"\1", parts[i]))
    parts[1::2] = [part.strip("`").replace("\\|", "|") for part in parts[1::2]]
    return "".join(parts)


@dataclass
class Section:
    """The text under a heading, without examples; table rows by column."""

    text: str = ""
    rows: list[dict[str, str]] = field(default_factory=list)

    def row(self, column: str, value: str) -> dict[str, str] | None:
        """Returns the row with this value in a column."""
        return next((row for row in self.rows if row.get(column) == value), None)


@lru_cache(maxsize=None)
def sections_of(page: str) -> dict[str, Section]:
    """Returns the sections of a page by heading; text before them is under the title."""
    page = re.sub(r"<details>.*?</details>", "", page, flags=re.DOTALL)
    found: dict[str, Section] = {}
    for part in re.split(r"^#+ ", page, flags=re.MULTILINE)[1:]:
        title, _, body = part.partition("\n")
        section = found.setdefault(plain(title), Section())
        section.text += plain(title) + "\n" + plain(body)
        header: list[str] = []
        for line in body.splitlines():
            if not line.startswith("|"):
                header = []
                continue
            cells = [plain(c).strip() for c in re.split(r"(?<!\\)\|", line)[1:-1]]
            if not header:
                header = cells
            elif not re.fullmatch(r"[|:\- ]+", line):
                assert len(cells) == len(header), f"{title}: a row with other columns: {line}"
                section.rows.append(dict(zip(header, cells)))
    return found


class MarkdownPages:
    """The files of generated/docs/ by their path in it."""

    def __init__(self, files: Mapping[str, str]) -> None:
        self.sections = {name: sections_of(text) for name, text in files.items()}
        self.messages: dict[str, Section] = {}
        for name, sections in self.sections.items():
            if name.startswith("messages/"):
                self.messages.update(sections)

    def text(self, place: Place, column: str) -> str | None:
        """See Pages."""
        if place.kind == "message":
            return self._of_message(place, column)
        if place.kind == "commands":
            rows = [
                row
                for section in self.sections["README.md"].values()
                for row in section.rows
                if place.hook in row.get("Command", "").split()
            ]
            return " ".join(" ".join(row.values()) for row in rows)
        if place.kind == "errata":
            section = self.sections["errata.md"].get(place.hook)
            return section.text if section else None
        if place.kind == "variables":
            section = self.sections["variables.md"]["Adjustable variables"]
            return _cell(section, "Name", place.hook, column)
        if place.kind == "unit":
            section = self.sections["units.md"].get(place.name, Section())
            row = self.sections["units.md"]["Units"].row("Name", place.name) or {}
            return section.text + " ".join(row.values())
        section = self.sections["enums.md"].get(place.name, Section())
        return _cell(section, "Name", place.hook, column) if place.hook else section.text

    def _of_message(self, place: Place, column: str) -> str | None:
        way = "from the board" if place.direction == "from_board" else "to the board"
        section = self.messages.get(f"{place.name} ({way})")
        if section is None or not place.hook:
            return section.text if section else None
        while same := re.search(r"The body is identical to that of (\w+ *)", section.text):
            name = same[1].strip()
            section = next(s for t, s in self.messages.items() if t.split()[0] == name)
        return _cell(section, "Field", place.hook, column)


def _cell(section: Section, key: str, value: str, column: str) -> str | None:
    row = section.row(key, value)
    if row is None:
        return None
    name = _COLUMNS.get(column, "")
    return row[name] if name in row else " ".join(row.values())
