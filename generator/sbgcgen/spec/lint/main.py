"""Rules for the main file, and for the contents of other files that it governs."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import chain

from sbgcgen.model import Position
from sbgcgen.spec.diagnostics import Diagnostics, did_you_mean
from sbgcgen.spec.load import Map, Spec, maps_in

_LINE = re.compile(r"\bL([0-9]+)\b")


def lint_main(spec: Spec, found: Diagnostics) -> None:
    """Check the main file and the lines that sources name; findings go into `found`."""
    _check_units(spec, found)
    _check_synonyms(spec, found)
    _check_revisions(spec, found)
    _check_lines(spec, found)
    _check_guides(spec, found)


def _check_units(spec: Spec, found: Diagnostics) -> None:
    known = [str(unit) for unit in spec.main.get("units", ())]
    for _, name, node, _ in spec.entries("quantities"):
        unit = node.get("unit")
        if known and unit is not None and str(unit) not in known:
            hint = did_you_mean(str(unit), known) or f"add it to 'units' in {spec.main_file}"
            found.add(node.at("unit"), "SBGC065", f"{name} has the unknown unit '{unit}'", hint)


def _check_synonyms(spec: Spec, found: Diagnostics) -> None:
    seen: dict[str, Position] = {}
    for group in spec.main.get("synonyms", ()):
        for word, at in zip(group, group.items_at):
            first = seen.setdefault(str(word), at)
            if first is not at:
                text = f"'{word}' is in two groups of synonyms (first at {first})"
                found.add(at, "SBGC066", text, "keep it in one, or merge the groups")


def _check_revisions(spec: Spec, found: Diagnostics) -> None:
    nodes = spec.main.get("revisions", Map())
    before: tuple[tuple[int, ...], str] = ((), "")
    for number, node in nodes.items():
        this = (tuple(int(part) for part in number.split(".")), str(node["date"]))
        if this[0] <= before[0]:
            text = f"revision {number} comes after a later one"
            found.add(nodes.at(number), "SBGC067", text, "list the oldest revision first")
        elif this[1] < before[1]:
            text = f"revision {number} is older than the one before it ({before[1]})"
            found.add(node.at("date"), "SBGC067", text, "list the oldest revision first")
        before = this


def _check_lines(spec: Spec, found: Diagnostics) -> None:
    """Sources and errata must name existing lines of the specification."""
    count = spec.main.get("protocol", {}).get("lines")
    if count is None:
        return
    for text, at in _places(spec):
        numbers = [int(number) for number in _LINE.findall(text)]
        wrong = [number for number in numbers if not 1 <= number <= count]
        if wrong:
            message = f"there is no line L{wrong[0]}"
            found.add(at, "SBGC068", message, f"the specification has {count} lines")
        for first, last in re.findall(r"\bL([0-9]+)-L([0-9]+)\b", text):
            if int(last) < int(first):
                message = f"'L{first}-L{last}' ends before it starts"
                found.add(at, "SBGC068", message, "write the first line first")


def _places(spec: Spec) -> Iterator[tuple[str, Position]]:
    for node in (*maps_in(spec.main), *chain(*spec.maps.values())):
        if isinstance(node.get("source"), str):
            yield node["source"], node.at("source")
    for node in spec.errata.get("errata", Map()).values():
        yield from ((str(line), at) for line, at in node.listed("lines"))


def _check_guides(spec: Spec, found: Diagnostics) -> None:
    """Guides must exist. Not checked for a copy of the spec without docs/ beside it."""
    nodes = spec.main.get("guides", Map())
    root = spec.files[0].resolve().parent.parent if spec.files else None
    if root is None or not (root / "docs").is_dir():
        return
    known = [f"docs/{path.name}" for path in sorted((root / "docs").glob("*.md"))]
    for about, path in nodes.items():
        if str(path) not in known:
            hint = did_you_mean(str(path), known) or "name a file in docs/"
            found.add(nodes.at(about), "SBGC021", f"there is no guide '{path}'", hint)
