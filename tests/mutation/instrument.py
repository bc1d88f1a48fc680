"""Copies the sources, with mutants compiled in as switches."""

from __future__ import annotations

import subprocess
from collections import defaultdict
from pathlib import Path

from mutants import Mutant


def write_copy(root: Path, copy: Path, mutants: list[Mutant]) -> None:
    """Makes `copy` a copy of all sources; mutant i of the list is switch number i. Leaves alone what has
    not changed, so that little is built again."""
    by_file: dict[str, list[tuple[int, Mutant]]] = defaultdict(list)
    for number, mutant in enumerate(mutants):
        by_file[mutant.file].append((number, mutant))
    list_files = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    listed = subprocess.run(list_files, cwd=root, capture_output=True, check=True).stdout
    names = {name.decode() for name in listed.split(b"\0") if name}
    wanted = {name for name in names if (root / name).is_file()}
    for old in copy.rglob("*"):
        if old.is_file() and old.relative_to(copy).as_posix() not in wanted:
            old.unlink()
    for name in sorted(wanted):
        source = root / name
        target = copy / name
        content = source.read_bytes()
        if name in by_file:
            content = with_switches(content, by_file[name])
        if target.exists() and target.read_bytes() == content:
            continue
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(content)
        target.chmod(source.stat().st_mode)


def with_switches(source: bytes, numbered: list[tuple[int, Mutant]]) -> bytes:
    """Returns the source with a switch at each mutant. Mutants may be nested, not overlap."""
    order = sorted(numbered, key=lambda item: (item[1].start, -item[1].end))
    text, rest = _render(source, 0, len(source), order)
    assert not rest
    return text


def _render(
    source: bytes, start: int, end: int, mutants: list[tuple[int, Mutant]]
) -> tuple[bytes, list[tuple[int, Mutant]]]:
    """Returns the text of [start, end) with the first mutants, and the mutants after the end."""
    result = b""
    while mutants and mutants[0][1].start < end:
        number, mutant = mutants[0]
        result += source[start : mutant.start]
        original, mutants = _render(source, mutant.start, mutant.end, mutants[1:])
        condition = f"::sbgc_mutant::on({number})"
        if mutant.kind == "statement":
            result += f"if (!{condition}) {{ ".encode() + original + b" }"
        else:
            # A condition may be of any type that converts to bool.
            kept = b"static_cast<bool>(" if mutant.kind == "negation" else b"("
            result += f"({condition} ? ({mutant.replacement}) : ".encode() + kept + original + b"))"
        start = mutant.end
    return result + source[start:end], mutants
