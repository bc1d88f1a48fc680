"""Diagnostics with the position in the YAML and a hint for the fix."""

from __future__ import annotations

import difflib
import re
import unicodedata
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Protocol

from sbgcgen.model import Position


# Longer messages and hints contain a quoted value of excessive length.
_LONGEST = 1000


def _printable(text: str) -> str:
    """The text as one line of limited length: quoted file content may be anything."""
    if len(text) > _LONGEST:
        text = f"{text[:_LONGEST]} ..."
    if text.isprintable():
        return text
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in text)


def _look_alikes(message: str) -> str:
    """Names the letters in quoted words that only look like Latin ones."""
    letters = "".join(re.findall(r"'(\S+)'", message))
    names = {c: unicodedata.name(c, "") for c in letters if c.isalpha() and not c.isascii()}
    others = [f"'{c}' is {name}" for c, name in names.items() if not name.startswith("LATIN")]
    return ", ".join(others)


@dataclass(frozen=True, order=True)
class Diagnostic:
    """One finding: position, rule, problem, and hint."""

    position: Position
    code: str
    message: str
    hint: str = ""

    def __str__(self) -> str:
        text = f"{self.position}: {self.code} {self.message}"
        return f"{text}\n    hint: {self.hint}" if self.hint else text


class Mistake(Exception):
    """A finding without a position, which is added on the way up (see Diagnostics.at).

    `key` is the key of the node that contains the mistake.
    """

    def __init__(self, code: str, message: str, hint: str = "", key: str = "") -> None:
        super().__init__(message)
        self.code = code
        self.message = message
        self.hint = hint
        self.key = key


class _Node(Protocol):
    def at(self, key: str) -> Position:
        """The position of a key."""


@dataclass
class Diagnostics:
    """Collects findings, so that one run reports them all."""

    found: list[Diagnostic] = field(default_factory=list)
    _known: set[Diagnostic] = field(default_factory=set)

    def add(self, position: Position, code: str, message: str, hint: str = "") -> None:
        """Record a finding unless the same one has been recorded before."""
        hint = "; ".join(filter(None, (hint, _look_alikes(message))))
        diagnostic = Diagnostic(position, code, _printable(message), _printable(hint))
        if diagnostic not in self._known:
            self._known.add(diagnostic)
            self.found.append(diagnostic)

    @contextmanager
    def at(self, place: Position | _Node) -> Iterator[None]:
        """Record a Mistake raised in the block, at a position or at its key of a node."""
        try:
            yield
        except Mistake as mistake:
            position = place if isinstance(place, Position) else place.at(mistake.key)
            self.add(position, mistake.code, mistake.message, mistake.hint)

    def any_of(self, codes: Iterable[str]) -> bool:
        """True if any finding so far has one of these codes."""
        return any(diagnostic.code in codes for diagnostic in self.found)

    def raise_if_any(self) -> None:
        """Raise SpecError with all findings so far, sorted by position."""
        if self.found:
            raise SpecError(sorted(self.found))


class SpecError(Exception):
    """The spec has mistakes; `diagnostics` has one entry for each."""

    def __init__(self, diagnostics: Iterable[Diagnostic]) -> None:
        self.diagnostics = list(diagnostics)
        super().__init__("\n".join(str(d) for d in self.diagnostics))


def closest(name: str, known: Iterable[str], cutoff: float = 0.6) -> str:
    """The known word that was probably meant, or "" if none is close. A `cutoff` of 1 means equal.

    A word that differs only in a number is not a typo: E999 is not E099.
    """
    by_lower = {word.lower(): word for word in known}
    close = difflib.get_close_matches(name.lower(), by_lower, n=10, cutoff=cutoff)
    for word in close:
        if word == name.lower() or _without_numbers(word) != _without_numbers(name.lower()):
            return by_lower[word]
    return ""


def _without_numbers(word: str) -> str:
    return re.sub(r"[0-9]+", "0", word)


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """A hint that names the closest known word, or "" if none is close."""
    word = closest(name, known)
    return f"did you mean '{word}'?" if word else ""
