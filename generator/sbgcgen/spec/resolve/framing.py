"""Resolves the parts of a frame."""

from __future__ import annotations

from sbgcgen.model import BODY, ID, SIZE, START, Checksum, Framing, Position
from sbgcgen.spec.diagnostics import Diagnostics, did_you_mean
from sbgcgen.spec.load import List, Map
from sbgcgen.spec.resolve.entries import Entries

# The largest value of the size byte.
_MOST = 255


def framing_of(node: Map, entries: Entries, found: Diagnostics) -> Framing:
    """Resolve the value of `framing:`; findings go into `found`."""
    checksums = tuple(
        Checksum(name, str(content["kind"]), tuple(str(part) for part in content["covers"]))
        for name, content in node["checksums"].items()
    )
    framing = Framing(
        start=int(node["start"]),
        header=tuple(str(part) for part in node["header"]),
        trailer=tuple(str(part) for part in node["trailer"]),
        checksums=checksums,
        max_body=int(node["max_body"]),
        source=str(node["source"]),
        errata=entries.errata(node),
    )
    _check_parts(framing, node, found)
    _check_checksums(framing, node["checksums"], found)
    if framing.max_body > _MOST:
        text = f"a size of {framing.max_body} does not fit into its byte"
        found.add(node.at("max_body"), "SBGC069", text, f"at most {_MOST}")
    return framing


def _check_parts(framing: Framing, node: Map, found: Diagnostics) -> None:
    """Every part must have one place, and the start byte must be first."""
    names = [checksum.name for checksum in framing.checksums]
    header = [START, ID, SIZE, *names]
    for key, parts, known in (
        ("header", framing.header, header),
        ("trailer", framing.trailer, names),
    ):
        for part, at in zip(parts, _places(node, key)):
            if part not in known:
                hint = did_you_mean(part, known) or f"known here: {', '.join(known) or 'none'}"
                found.add(at, "SBGC069", f"'{part}' is not a part of the {key}", hint)
            elif key == "trailer" and part in framing.header:
                text = f"'{part}' is in the header and in the trailer"
                found.add(at, "SBGC069", text, "each part has one place")
    if framing.header[0] != START:
        text = "a frame does not begin with its start byte"
        found.add(_places(node, "header")[0], "SBGC069", text, "put 'start' first")
    for part in (ID, SIZE):
        if part not in framing.header:
            text = f"the header does not have '{part}'"
            found.add(node.at("header"), "SBGC069", text, "a frame cannot be read without it")


def _check_checksums(framing: Framing, nodes: Map, found: Diagnostics) -> None:
    """Every checksum must have a place, and cover only parts before it."""
    for checksum in framing.checksums:
        name, node = checksum.name, nodes[checksum.name]
        if name in (START, ID, SIZE, BODY):
            text = f"'{name}' is the name of another part"
            found.add(nodes.at(name), "SBGC069", text, "give the checksum another name")
        elif name in framing.header:
            before = framing.header[: framing.header.index(name)]
            _check_covered(name, checksum.covers, before, node, found)
        elif name in framing.trailer:
            before = (*framing.header, BODY, *framing.trailer[: framing.trailer.index(name)])
            _check_covered(name, checksum.covers, before, node, found)
        else:
            hint = "name it in 'header' or 'trailer'"
            found.add(nodes.at(name), "SBGC069", f"'{name}' has no place in a frame", hint)


def _check_covered(
    name: str, covers: tuple[str, ...], before: tuple[str, ...], node: Map, found: Diagnostics
) -> None:
    for part, at in zip(covers, _places(node, "covers")):
        if part not in before:
            text = f"'{part}' is not before '{name}', which covers it"
            hint = did_you_mean(part, before) or f"before it: {', '.join(before)}"
            found.add(at, "SBGC069", text, hint)


def _places(node: Map, key: str) -> list[Position]:
    items = node[key]
    return items.items_at if isinstance(items, List) else []
