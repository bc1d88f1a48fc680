"""Positions in spec files."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(unsafe_hash=True, order=True)
class Position:
    """A place in a spec file; line and column count from 1.

    It is immutable by convention. It is not `frozen`, because that would double the construction
    time, and every node of the spec has one.
    """

    file: str
    line: int = 1
    column: int = 1

    def __str__(self) -> str:
        return f"{self.file}:{self.line}:{self.column}"


NOWHERE = Position("")
