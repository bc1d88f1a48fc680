"""The version of the library, which runtime/core/include/sbgc/version.hpp defines."""

from __future__ import annotations

import re
from pathlib import Path
from typing import NamedTuple

HEADER = Path("runtime/core/include/sbgc/version.hpp")


class Version(NamedTuple):
    """A version of three numbers, which compare in this order."""

    major: int
    minor: int
    patch: int

    def __str__(self) -> str:
        return ".".join(map(str, self))


def parse(text: str) -> Version:
    """The version written as 1.2.3. Raises ValueError for other texts."""
    major, minor, patch = map(int, text.split("."))
    return Version(major, minor, patch)


def version(project: Path) -> Version:
    """The version of the library in the folder `project`."""
    text = (project / HEADER).read_text(encoding="utf-8")
    numbers = dict(re.findall(r"^#define SBGC_VERSION_([A-Z]+) ([0-9]+)$", text, re.MULTILINE))
    return Version(*(int(numbers[part.upper()]) for part in Version._fields))
