"""The C++ library of the project: its version, its license, and its headers as files.

For targets that redistribute the library in another form.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

# The header that defines the version.
VERSION_HEADER = Path("runtime/core/include/sbgc/version.hpp")

# The headers that a freestanding program starts from. The headers that they include, directly or
# indirectly, are core, codec and session.
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
# Tables of names, units and limits, which are also freestanding, but large.
TABLES = ("sbgc/validate.hpp", "sbgc/meta/all.hpp")

# The project with the runtime: this generator's own, for protocols in other folders.
_HERE = Path(__file__).resolve().parents[2]
_FOLDERS = ("generated/include", "runtime/core/include", "runtime/session/include")
_GENERATED = "// Generated from "
_DIRECTIVE = re.compile(r"^\s*#\s*(\w+)\s*(.*?)\s*$")


@dataclass
class Part:
    """A header without its `#include` lines, or a part of it: an `#include` after code splits it."""

    header: str  # as in #include <header>
    body: str = ""
    standard: list[str] = field(default_factory=list)  # headers of the compiler that it includes


def version(project: Path) -> str:
    """The version of the library, such as 1.2.3."""
    text = _file(project, VERSION_HEADER).read_text(encoding="utf-8")
    numbers = re.findall(
        r"^#define SBGC_VERSION_(?:MAJOR|MINOR|PATCH) ([0-9]+)$", text, re.MULTILINE
    )
    if len(numbers) != 3:
        raise ValueError(f"{VERSION_HEADER} defines no version")
    return ".".join(numbers)


def license_text(project: Path) -> str:
    return _file(project, "LICENSE").read_text(encoding="utf-8")


def in_namespace(text: str, name: str) -> str:
    """Code of the library with another namespace, and another prefix for macros."""
    text = re.sub(r"\bsbgc\b", name, text)
    return re.sub(r"\bSBGC_", f"{name.upper()}_", text)


def _file(project: Path, path: Path | str) -> Path:
    return project / path if (project / path).is_file() else _HERE / path


def path_of(project: Path, name: str) -> Path:
    """The file of a header."""
    paths = [_file(project, f"{folder}/{name}") for folder in _FOLDERS]
    found = next((path for path in paths if path.is_file()), None)
    if found is None:
        raise ValueError(f"{name} is not a header of core, codec or session")
    return found


def headers(project: Path, entries: Iterable[str]) -> list[str]:
    """The entries and all headers that they include."""
    return sorted({part.header for part in parts(project, entries)})


def parts(project: Path, entries: Iterable[str]) -> list[Part]:
    """The entries and all headers that they include, in the order in which a compiler reads them.

    Each header is read once. Conditionally included headers precede the header: those of the library
    in any case, those of the compiler where they are.
    """
    found: list[Part] = []
    seen: set[str] = set()

    def read(name: str) -> None:
        if name in seen:
            return
        seen.add(name)
        part, lines, conditions = Part(name), list[str](), 0
        for line in path_of(project, name).read_text(encoding="utf-8").splitlines():
            directive = _DIRECTIVE.match(line)
            word, rest = directive.groups() if directive else ("", "")
            conditions += word.startswith("if")
            conditions -= word == "endif"
            included = rest.strip("<>") if word == "include" else ""
            if included.startswith("sbgc/"):
                if not conditions and any(map(_is_code, lines)):
                    found.append(_finished(part, lines))
                    part, lines = Part(name), []
                read(included)
            elif included and not conditions:
                part.standard.append(included)
            elif (word, rest) != ("pragma", "once") and not line.startswith(_GENERATED):
                lines.append(line)
        found.append(_finished(part, lines))

    for entry in entries:
        read(entry)
    return found


def _is_code(line: str) -> bool:
    return bool(line.strip()) and not line.lstrip().startswith(("//", "#"))


def _finished(part: Part, lines: list[str]) -> Part:
    text = re.sub(r"\n{3,}", "\n\n", "\n".join(lines)).strip()
    part.body = f"{text}\n" if text else ""
    return part
