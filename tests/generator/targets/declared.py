"""Finds the types that the headers of the library declare in its namespace."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from support import PROJECT

_NAMESPACE = re.compile(r"(?:inline )?namespace ([\w:]+) \{")
_TYPE = re.compile(
    r"(?:template <.*> )?(?:class|struct|enum class|union|using|concept)"
    r" (?:\[\[\w+\]\] |\w+\(\w+\) )?([A-Z]\w*)(?! *<)\b"
)


def declared_in(text: str) -> Iterator[str]:
    """The names of the types in the namespace `sbgc` itself; its contents are not indented."""
    inside: list[str] = []
    for line in text.splitlines():
        if opened := _NAMESPACE.match(line):
            inside.append(opened[1])
        elif line.startswith("}  // namespace"):
            inside.pop()
        elif inside == ["sbgc"] and (declared := _TYPE.match(line)):
            yield declared[1]


def declared() -> set[str]:
    """The types that all headers of the library declare."""
    folders = [p for p in (PROJECT / "runtime").iterdir() if (p / "include").is_dir()]
    headers: list[Path] = [h for f in folders for h in (f / "include").rglob("*.hpp")]
    headers += (PROJECT / "generator/sbgcgen/targets/cpp/templates").rglob("*.hpp.j2")
    return {name for header in headers for name in declared_in(header.read_text("utf-8"))}


def used() -> set[str]:
    """The words in the namespace of messages, where a type of the spec would hide one of these."""
    words: set[str] = set()
    for header in (PROJECT / "generated/include").rglob("*.hpp"):
        for part in header.read_text("utf-8").split("namespace sbgc::msg {\n")[1:]:
            code = re.sub(r"//.*", "", part.partition("}  // namespace sbgc::msg")[0])
            words.update(re.findall(r"(?<!::)\b[A-Z]\w*", code))
    return words
