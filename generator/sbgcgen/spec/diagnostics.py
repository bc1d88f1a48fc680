"""Errors that point at the line of YAML that caused them and say how to mend it."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable
from dataclasses import dataclass, field

from sbgcgen.model import Position


@dataclass(frozen=True, order=True)
class Diagnostic:
    """One finding: where, which rule, what, and what to do about it."""

    position: Position
    code: str
    message: str
    hint: str = ""

    def __str__(self) -> str:
        text = f"{self.position}: {self.code} {self.message}"
        return f"{text}\n    hint: {self.hint}" if self.hint else text


@dataclass
class Diagnostics:
    """Collects findings, so that one run reports them all."""

    found: list[Diagnostic] = field(default_factory=list)

    def add(self, position: Position, code: str, message: str, hint: str = "") -> None:
        """Record one finding; a repetition of the very same one is dropped."""
        diagnostic = Diagnostic(position, code, message, hint)
        if diagnostic not in self.found:
            self.found.append(diagnostic)

    def any_of(self, codes: Iterable[str]) -> bool:
        """Whether any finding so far has one of these codes."""
        return any(diagnostic.code in codes for diagnostic in self.found)

    def raise_if_any(self) -> None:
        """Raise SpecError with everything found so far, in order of position."""
        if self.found:
            raise SpecError(sorted(self.found))


class SpecError(Exception):
    """The spec cannot be used; `diagnostics` says why, one entry for each mistake."""

    def __init__(self, diagnostics: Iterable[Diagnostic]) -> None:
        self.diagnostics = list(diagnostics)
        super().__init__("\n".join(str(d) for d in self.diagnostics))


def closest(name: str, known: Iterable[str], cutoff: float = 0.6) -> str:
    """The known word that is probably meant, or "" if none is close (1: the same).

    What differs in nothing but a number is another thing, not a slip: E999 is not E099.
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
