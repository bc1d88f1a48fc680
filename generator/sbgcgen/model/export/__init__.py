"""The model as plain data: generated/simplebgc.json, for tools in any language."""

from __future__ import annotations

import hashlib
import json
from dataclasses import asdict
from typing import Any

from sbgcgen.model import Command, Framing, Layout
from sbgcgen.model.export.messages import message_json
from sbgcgen.model.export.types import enum_json, former_names, given, packed_json, quantity_json
from sbgcgen.model.export.types import attributes, variable_json


def export(layout: Layout) -> dict[str, Any]:
    """The whole model as plain data for JSON, with its fingerprint."""
    model = _model(layout)
    return {"fingerprint": fingerprint(model), **model}


def _model(layout: Layout) -> dict[str, Any]:
    return {
        "protocol": layout.protocol,
        "framings": [_framing(framing) for framing in layout.framings],
        "versions": {
            "firmware": layout.versions.firmware.name if layout.versions.firmware else None,
            "board": layout.versions.board.name if layout.versions.board else None,
            "newest_firmware": layout.newest_firmware or None,
        },
        **({"features": _features(layout)} if layout.features else {}),
        "line": {
            "baud_rates": list(layout.line.baud_rates),
            "named_baud_rates": list(layout.line.baud_rates[: layout.line.named]),
            **attributes(layout.line, "parities", "shortest_pause_ms", "longest_pause_ms"),
            **attributes(layout.line, "source", "errata"),
        },
        "revisions": [
            {
                **attributes(revision, "number", "date", "source"),
                "adds": [addition.text for addition in revision.adds],
                "changes": list(revision.changes),
            }
            for revision in layout.revisions
        ],
        "directions": [
            {"name": direction.axis, **attributes(direction, "positive", "negative", "errata")}
            for direction in layout.directions
        ],
        "synonyms": [list(group) for group in layout.synonyms],
        "topics": [
            attributes(topic, "name", "summary", "words")
            | given(changes_line=topic.changes_line or None)
            for topic in layout.topics
        ],
        "families": [attributes(family, "name", "summary") for family in layout.families],
        "effects": [
            {"name": kind.word, "summary": kind.summary, "risk": kind.risk or None}
            for kind in layout.effects
        ],
        "timeouts": {"errata": list(layout.timeout_errata)},
        "commands": [_command(command) for command in layout.commands],
        "messages": [message_json(message, layout) for message in layout.messages],
        "enums": [enum_json(enum) for enum in layout.enums],
        "packed": [packed_json(packed) for packed in layout.packed],
        "quantities": [quantity_json(quantity) for quantity in layout.quantities],
        "adjustable_variables": [variable_json(variable) for variable in layout.variables],
        "errata": [
            attributes(erratum, "number", "kind", "lines", "problem", "reading")
            | {"reason": erratum.reason or None}
            for erratum in layout.errata
        ],
    }


def _framing(framing: Framing) -> dict[str, Any]:
    return {
        **attributes(framing, "name", "since", "start", "header", "trailer"),
        "checksums": [
            attributes(checksum, "name", "kind", "covers")
            | (asdict(checksum.crc) if checksum.crc else {})
            for checksum in framing.checksums
        ],
        **attributes(framing, "header_size", "trailer_size", "max_body", "source", "errata"),
    }


def _command(command: Command) -> dict[str, Any]:
    return {
        **attributes(command, "name", "id", "family", "summary", "source", "errata", "since"),
        "documented": not command.undocumented,
    } | given(
        formerly=former_names(command.aliases),
        unconfirmed=command.unconfirmed or None,
        needs=command.needs or None,
    )


def _features(layout: Layout) -> list[dict[str, str]]:
    """The features that boards may have, and the fields that report them."""
    fields = {
        field.type: f"{message.name}.{field.name}"
        for message in layout.messages
        for field, _, _ in layout.reports(message)
    }
    return [
        {"name": value.name, "reported_by": fields.get(flags, "")}
        for flags in layout.feature_sets
        for value in flags.values
    ]


# Sections and keys that only explain the protocol. For special values, only the texts do.
_PROSE_SECTIONS = {"errata", "revisions", "synonyms", "timeouts", "topics"}
_PROSE = {"description", "document", "errata", "preparation", "source", "summary", "topics"}
_EXPLAINED = {"special"}


def fingerprint(model: dict[str, Any]) -> str:
    """The first 64 bits of the SHA-256 digest of a model's meaning, as 16 hexadecimal digits.

    Models with the same meaning have equal fingerprints: prose and the order of entries have no effect;
    names, numbers, layouts and rules do. A later version of the generator may export more facts, which
    changes it as well.
    """
    sections = {name: section for name, section in model.items() if name not in _PROSE_SECTIONS}
    for name, section in sections.items():
        if isinstance(section, list) and name != "framings":  # the first framing is the basic one
            sections[name] = sorted(section, key=lambda entry: str(entry["name"]))
    text = json.dumps(_meaning(sections), sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def _meaning(value: Any) -> Any:
    if isinstance(value, list):
        return [_meaning(item) for item in value]
    if isinstance(value, dict):
        return {
            key: sorted(item) if item and key in _EXPLAINED else _meaning(item)
            for key, item in value.items()
            if key not in _PROSE
        }
    return value
