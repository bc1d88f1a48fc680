"""The fingerprint of an exported model: equal for models with the same meaning.

Prose and the order of entries have no effect on it; names, numbers, layouts and rules have. A later
version of the generator may export more facts, which changes it as well.
"""

from __future__ import annotations

import hashlib
import json
from typing import Any

# Sections and keys that explain the protocol without defining it. Of special values, only the texts do.
_PROSE_SECTIONS = {"errata", "revisions", "synonyms", "timeouts", "topics"}
_PROSE = {"description", "document", "errata", "preparation", "source", "summary", "topics"}
_EXPLAINED = {"special"}


def fingerprint(model: dict[str, Any]) -> str:
    """The first 64 bits of the SHA-256 digest of a model's meaning, as 16 hexadecimal digits."""
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
