"""Resolves the parts of a frame."""

from __future__ import annotations

from collections.abc import Sequence

from sbgcgen.model import BODY, CHECKSUM_SIZES, ID, SIZE, START, Checksum, Crc, Framing
from sbgcgen.spec.diagnostics import Diagnostics, did_you_mean
from sbgcgen.spec.load import Map
from sbgcgen.spec.resolve.entries import Entries

# The largest value of the size byte.
_MOST = 255
# The text whose check value is listed in catalogues of cyclic redundancy checks.
_CHECK_TEXT = b"123456789"
# The parameters of a cyclic redundancy check.
_CRC_KEYS = ("polynomial", "initial", "reflect_in", "reflect_out", "final_xor", "check")


def framings_of(nodes: Map, entries: Entries, found: Diagnostics) -> tuple[Framing, ...]:
    """Resolve the value of `framings:`; findings go into `found`."""
    framings = tuple(_framing(name, node, entries, found) for name, node in nodes.items())
    _check_together(framings, nodes, found)
    return framings


def _check_together(framings: Sequence[Framing], nodes: Map, found: Diagnostics) -> None:
    """A start byte must identify its framing, and all headers must be interchangeable."""
    first = framings[0]
    if first.since:
        text = f"the first framing, '{first.name}', is not in every firmware"
        hint = "put the framing first that every board understands"
        found.add(nodes[first.name].at("since"), "SBGC069", text, hint)
    for number, framing in enumerate(framings):
        node = nodes[framing.name]
        for other in framings[:number]:
            if framing.start == other.start:
                text = f"'{framing.name}' has the start byte of '{other.name}'"
                found.add(node.at("start"), "SBGC069", text, "each framing needs a start byte")
        for key in ("header", "max_body"):
            if getattr(framing, key) != getattr(first, key):
                text = f"'{framing.name}' has another {key} than '{first.name}'"
                hint = "framings may differ in start byte and trailer"
                found.add(node.at(key), "SBGC069", text, hint)


def _framing(name: str, node: Map, entries: Entries, found: Diagnostics) -> Framing:
    checksums = tuple(
        _checksum(part, content, found) for part, content in node["checksums"].items()
    )
    framing = Framing(
        name=name,
        since=entries.availability(node),
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


def _checksum(name: str, node: Map, found: Diagnostics) -> Checksum:
    kind, covers = str(node["kind"]), tuple(str(part) for part in node["covers"])
    if not kind.startswith("crc"):
        for key in _CRC_KEYS:
            if key in node:
                text = f"'{name}' has '{key}', but is no cyclic redundancy check"
                found.add(node.at(key), "SBGC069", text, "delete it, or say 'kind: crc16'")
        return Checksum(name, kind, covers)
    if "polynomial" not in node:
        text = f"'{name}' is a {kind} without a polynomial"
        found.add(node.at("kind"), "SBGC069", text, "add 'polynomial', such as 0x8005")
    width = 8 * CHECKSUM_SIZES[kind]
    for key in _CRC_KEYS:
        if int(node.get(key, 0)) >> width:
            text = f"'{key}' of '{name}' has more than {width} bits"
            hint = "leave out the highest power of the polynomial"
            found.add(node.at(key), "SBGC069", text, hint)
            return Checksum(name, kind, covers)
    crc = Crc(
        polynomial=int(node.get("polynomial", 0)),
        initial=int(node.get("initial", 0)),
        reflect_in=bool(node.get("reflect_in", False)),
        reflect_out=bool(node.get("reflect_out", False)),
        final_xor=int(node.get("final_xor", 0)),
        check=int(node["check"]) if "check" in node else None,
        width=width,
    )
    if crc.check is not None and crc.check != crc.value(_CHECK_TEXT):
        text = f"the check value of '{name}' is 0x{crc.value(_CHECK_TEXT):0{width // 4}X}"
        hint = "correct the parameters, or 'check', the value of the text 123456789"
        found.add(node.at("check"), "SBGC069", text, hint)
    return Checksum(name, kind, covers, crc)


def _check_parts(framing: Framing, node: Map, found: Diagnostics) -> None:
    """Every part must have exactly one position, and the start byte must be first."""
    names = [checksum.name for checksum in framing.checksums]
    header = [START, ID, SIZE, *names]
    for key, known in (("header", header), ("trailer", names)):
        for part, at in node.listed(key):
            if part not in known:
                hint = did_you_mean(part, known) or f"known here: {', '.join(known) or 'none'}"
                found.add(at, "SBGC069", f"'{part}' is not a part of the {key}", hint)
            elif key == "trailer" and part in framing.header:
                text = f"'{part}' is in the header and in the trailer"
                found.add(at, "SBGC069", text, "each part has one place")
    if framing.header[0] != START:
        text = "a frame does not begin with its start byte"
        found.add(node.listed("header")[0][1], "SBGC069", text, "put 'start' first")
    for part in (ID, SIZE):
        if part not in framing.header:
            text = f"the header does not have '{part}'"
            found.add(node.at("header"), "SBGC069", text, "a frame cannot be read without it")


def _check_checksums(framing: Framing, nodes: Map, found: Diagnostics) -> None:
    """Every checksum must have a position, and cover only parts before it."""
    for checksum in framing.checksums:
        name, node = checksum.name, nodes[checksum.name]
        if name in (START, ID, SIZE, BODY):
            text = f"'{name}' is the name of another part"
            found.add(nodes.at(name), "SBGC069", text, "give the checksum another name")
        elif name in framing.header:
            before = framing.header[: framing.header.index(name)]
            _check_covered(name, before, node, found)
        elif name in framing.trailer:
            before = (*framing.header, BODY, *framing.trailer[: framing.trailer.index(name)])
            _check_covered(name, before, node, found)
        else:
            hint = "name it in 'header' or 'trailer'"
            found.add(nodes.at(name), "SBGC069", f"'{name}' has no place in a frame", hint)


def _check_covered(name: str, before: tuple[str, ...], node: Map, found: Diagnostics) -> None:
    for part, at in node.listed("covers"):
        if part not in before:
            text = f"'{part}' is not before '{name}', which covers it"
            hint = did_you_mean(part, before) or f"before it: {', '.join(before)}"
            found.add(at, "SBGC069", text, hint)
