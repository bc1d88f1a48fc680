"""Compares two versions of the protocol; severities.py defines the severity of each change."""

from __future__ import annotations

from sbgcgen.compat.changes import Change, Changes, Level
from sbgcgen.compat.difference import Pair
from sbgcgen.compat.severities import TABLES
from sbgcgen.model import Layout, Position


def compare(old: Layout, new: Layout) -> list[Change]:
    """All changes, the worst first; those of equal severity are grouped by kind of entry."""
    changes = Changes(new.versions)
    whole_protocol = Position(f"spec/{new.main_file}")
    Pair(changes, TABLES, "", old, new, whole_protocol).compare()
    rank = list(Level)
    return sorted(changes.found, key=lambda change: rank.index(change.level))
