"""Reads a spec that is written in an earlier version of the spec language."""

from __future__ import annotations

from typing import Any

from sbgcgen.spec.load import Map, Spec

# One type for the ids of both directions; what it meant depends on who sends the field.
_COMMAND_ID = "CommandId"
_MEANT = {"from_board": "CommandToBoard", "to_board": "CommandFromBoard"}
# Keys that have another name now.
_KEYS = {"echoes": "correlation"}


def update(spec: Spec) -> None:
    """Replace what the current language says differently; a current spec stays as it is."""
    for _, _, command, _ in spec.entries("commands"):
        for direction, meant in _MEANT.items():
            if isinstance(command, Map):
                _update(command.get(direction), meant)


def _update(node: Any, command_id: str) -> None:
    if isinstance(node, list):
        for item in node:
            _update(item, command_id)
    elif isinstance(node, Map):
        if node.get("type") == _COMMAND_ID:
            node["type"] = command_id
        for old, new in _KEYS.items():
            if old in node:
                node[new] = node.pop(old)
                node.keys_at[new] = node.keys_at[old]
        for value in node.values():
            _update(value, command_id)
