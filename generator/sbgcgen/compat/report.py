"""The `compat` command with a revision: prints the changes between two versions of the spec."""

from __future__ import annotations

import sys
from collections import Counter
from pathlib import Path

from sbgcgen.build import load_protocol
from sbgcgen.compat.changes import Change, Level
from sbgcgen.compat.severities import compare
from sbgcgen.spec.diagnostics import SpecError
from sbgcgen.model import Layout
from sbgcgen.compat.reading import UnreadableRevision, layout_of
from sbgcgen.compat.revision import UnknownRevision, Version, version

_LONGEST = 60


def run(old: str, new: str | None, root: Path, spec_dir: Path) -> int:
    """Run the command; returns 0, or 1 for breaking changes, or 2 for an unknown revision."""
    inside = spec_dir.relative_to(root).as_posix() if root in spec_dir.parents else "spec"
    try:
        with version(old, root, inside) as before, version(
            new or str(spec_dir), root, inside
        ) as now:
            current = now if new else Version(now.folder, f"{now.folder.name}/")
            return _report(before, current, is_working_tree=new is None)
    except UnknownRevision as error:
        print(f"sbgcgen compat: {error}", file=sys.stderr)
        return 2


def _report(old: Version, new: Version, is_working_tree: bool) -> int:
    layouts: list[Layout] = []
    for side in (old, new):
        try:
            checked = is_working_tree and side is new
            layouts.append(load_protocol(side.folder).layout if checked else layout_of(side))
        except UnreadableRevision as error:
            print(f"{side.prefix}: its own generator cannot read it: {error}", file=sys.stderr)
        except SpecError as error:
            for diagnostic in error.diagnostics:
                where = side.where(diagnostic.position)
                hint = f"\n    hint: {diagnostic.hint}" if diagnostic.hint else ""
                print(f"{where}: {diagnostic.code} {diagnostic.message}{hint}", file=sys.stderr)
    if len(layouts) < 2:
        return 1
    changes = compare(*layouts)
    print_changes(changes, old, new)
    return 1 if any(change.level is not Level.COMPATIBLE for change in changes) else 0


def print_changes(changes: list[Change], old: Version, new: Version) -> None:
    """Print the changes with their positions, and their number."""
    for change in changes:
        where = (old if change.in_old else new).where(change.at)
        print(f"{change.level.value}: {describe(change)}  [{where}]")
    counts = Counter(change.level for change in changes)
    print(", ".join(f"{counts[level]} {level.value}" for level in Level))


def describe(change: Change) -> str:
    """A change as text: the object, the old and the new value."""
    return f"{change.what}: {_shorten(change.old)} → {_shorten(change.new)}"


def _shorten(text: str) -> str:
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 1]}…"
