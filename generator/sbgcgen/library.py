"""The C++ library of the project: its version, its license, and its headers as files.

Targets that pass the library on in another form use it.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

# The header that defines the version.
VERSION_HEADER = Path("runtime/core/include/sbgc/version.hpp")

# The headers that a program without an operating system starts from. The headers that they include,
# directly or not, are core, codec and session.
ENTRIES = (
    "sbgc/message.hpp",
    "sbgc/parser.hpp",
    "sbgc/visit.hpp",
    "sbgc/availability.hpp",
    "sbgc/session.hpp",
    "sbgc/detector.hpp",
    "sbgc/responses/all.hpp",
    "sbgc/version.hpp",
)
# Tables of names, units and limits, which need as little but are large.
TABLES = ("sbgc/validate.hpp", "sbgc/meta/all.hpp")

_FOLDERS = ("generated/include", "runtime/core/include", "runtime/session/include")
_GENERATED = "// Generated from "
_DIRECTIVE = re.compile(r"^\s*#\s*(\w+)\s*(.*?)\s*$")


@dataclass
class Header:
    """A header: the headers that it includes, and its text without those `#include` lines."""

    name: str  # as in #include <name>
    own: list[str] = field(default_factory=list)  # headers of the library
    standard: list[str] = field(default_factory=list)
    body: str = ""


def version(project: Path) -> str:
    """The version of the library, such as 1.2.3."""
    text = (project / VERSION_HEADER).read_text(encoding="utf-8")
    numbers = re.findall(
        r"^#define SBGC_VERSION_(?:MAJOR|MINOR|PATCH) ([0-9]+)$", text, re.MULTILINE
    )
    if len(numbers) != 3:
        raise ValueError(f"{VERSION_HEADER} defines no version")
    return ".".join(numbers)


def license_text(project: Path) -> str:
    return (project / "LICENSE").read_text(encoding="utf-8")


def path_of(project: Path, name: str) -> Path:
    """The file of a header."""
    paths = [project / folder / name for folder in _FOLDERS]
    found = next((path for path in paths if path.is_file()), None)
    if found is None:
        raise ValueError(f"{name} is not a header of core, codec or session")
    return found


def headers(project: Path, entries: Iterable[str]) -> list[Header]:
    """The entries and all headers that they include, each after those that it includes."""
    found: dict[str, Header] = {}

    def add(name: str) -> None:
        if name in found:
            return
        header = _read(name, path_of(project, name).read_text(encoding="utf-8"))
        for included in header.own:
            add(included)
        found[name] = header

    for entry in entries:
        add(entry)
    return list(found.values())


def _read(name: str, text: str) -> Header:
    """Separates a header from what it includes.

    An `#include` of the compiler stays where it is if it depends on a condition.
    """
    header = Header(name)
    lines, conditions = [], 0
    for line in text.splitlines():
        directive = _DIRECTIVE.match(line)
        word, rest = directive.groups() if directive else ("", "")
        conditions += word.startswith("if")
        conditions -= word == "endif"
        if word == "pragma" and rest == "once":
            continue
        if word == "include":
            included = rest.strip("<>")
            if included.startswith("sbgc/"):
                header.own.append(included)
                continue
            if not conditions:
                header.standard.append(included)
                continue
        if not line.startswith(_GENERATED):
            lines.append(line)
    header.body = re.sub(r"\n{3,}", "\n\n", "\n".join(lines)).strip() + "\n"
    return header
