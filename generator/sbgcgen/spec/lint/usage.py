"""Rules for names in the whole spec: undefined and unused ones."""

from __future__ import annotations

import re
from itertools import chain

from sbgcgen.spec.diagnostics import Diagnostics, did_you_mean
from sbgcgen.spec.load import Map, Spec, maps_in

# Sections of types, and the term for one entry.
_TYPES = {
    "quantities": "quantity",
    "enums": "enum",
    "flags": "flag set",
    "packed": "packed integer",
    "structs": "struct",
}
_NAME = re.compile(r"\b[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)*\b")


def lint_names(spec: Spec, found: Diagnostics) -> None:
    """Check the names in texts of the spec; findings go into `found`."""
    nodes = _all_maps(spec)
    _check_replacements(spec, nodes, found)
    _check_texts(spec, nodes, found)


def _all_maps(spec: Spec) -> list[Map]:
    return [*maps_in(spec.main), *chain(*spec.maps.values())]


def lint_unused(spec: Spec, found: Diagnostics) -> None:
    """Report unused entries; call it only if there are no other findings."""
    nodes, keys = _all_maps(spec), ("type", "names", "extends")
    used = {node[key] for node in nodes for key in keys if _is_text(node, key)}
    used |= set(spec.main.get("versions", Map()).values())
    for section, kind in _TYPES.items():
        for _, name, _, at in spec.entries(section):
            if name not in used:
                text = f"the {kind} {name} is not used"
                found.add(at, "SBGC050", text, "delete it, or refer to it")
    referred = {str(number) for node in nodes for number in node.get("errata") or ()}
    errata = spec.errata.get("errata", Map())
    for number in errata:
        if number not in referred:
            hint = "name it under 'errata' where it decides something, or delete it"
            found.add(errata.at(number), "SBGC050", f"nothing refers to erratum {number}", hint)


def _is_text(node: Map, key: str) -> bool:
    return isinstance(node.get(key), str)


def _check_replacements(spec: Spec, nodes: list[Map], found: Diagnostics) -> None:
    """`replaced_by` must name a command or a field."""
    commands = {name for _, name, _, _ in spec.entries("commands")}
    fields = {re.split(r"[\[{]", str(node["name"]))[0] for node in nodes if _is_text(node, "name")}
    known = commands | fields
    for node in nodes:
        if not _is_text(node, "replaced_by"):
            continue
        names, at = _NAME.findall(node["replaced_by"]), node.at("replaced_by")
        hint = "name a command, or a field and its command"
        for name in names:
            if name not in known:
                message = f"'replaced_by' names {name}, which does not exist"
                found.add(at, "SBGC051", message, did_you_mean(name, known) or hint)
        if not names:
            found.add(at, "SBGC051", "'replaced_by' names no command or field", hint)


def _check_texts(spec: Spec, nodes: list[Map], found: Diagnostics) -> None:
    """Summaries and descriptions must only mention existing commands."""
    commands = {name for _, name, _, _ in spec.entries("commands")}
    fields = {node["name"] for node in nodes if _is_text(node, "name")}
    command = re.compile(rf"\b{spec.command_prefix}[A-Z0-9_]*[A-Z0-9]\b")
    for node in nodes:
        for key in ("summary", "description", "preparation"):
            for name in command.findall(node[key]) if _is_text(node, key) else ():
                if name not in commands | fields:
                    message = f"the {key} mentions {name}, which does not exist"
                    hint = did_you_mean(name, commands) or "name a command of this protocol"
                    found.add(node.at(key), "SBGC052", message, hint)
