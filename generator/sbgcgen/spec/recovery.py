"""Repairs a copy of a structurally invalid spec, so that one run can also report the mistakes that
are hidden by the invalid parts. Nothing is generated from the copy."""

from __future__ import annotations

import copy
from dataclasses import dataclass, field
from typing import Any

from sbgcgen.model import Position
from sbgcgen.spec.diagnostics import Diagnostics, closest
from sbgcgen.spec.load import List, Map, Spec
from sbgcgen.spec.schema import ShapeError, add_shape_error, shape_errors

# Findings about one entry that depend neither on other entries nor on its other keys.
_OF_ONE_ENTRY = frozenset(
    f"SBGC0{number}" for number in (11, 12, 15, 16, 17, 18, 19, 20, 22, 24, 28, 30, 31, 53)
)
# Findings about names of other entries; they are valid if no entry was dropped.
_OF_NAMES = frozenset(("SBGC010", "SBGC021", "SBGC023", "SBGC040", "SBGC051", "SBGC052"))
# Keys that an invalid field keeps; the others describe its layout.
_KEPT = ("name", "verbatim", "summary", "range", "special", "since", "errata")
# A type that allows every range.
_ANY_TYPE = "i32"
_PLACEHOLDERS = {"summary": "?", "source": "L1", "type": _ANY_TYPE}
# Keys without which an entry is meaningless or means something else.
_ESSENTIAL = frozenset(
    """bits divide fields forms include mask modulo name parts reserved same_as size struct
    values""".split()
)
# The minimum similarity at which a word counts as a misspelled known one.
_CUTOFF = 0.75
_MOST_ROUNDS = 50
# Schema errors caused by missing parts.
_OF_WHAT_IS_MISSING = frozenset(("minItems", "minProperties", "dependentRequired"))


@dataclass
class Recovery:
    """A repaired copy of the spec, with a record of the changes."""

    spec: Spec
    lost_keys: bool = False
    lost_entries: bool = False
    _misspelled: list[Map] = field(default_factory=list)  # nodes that had misspelled keys
    _dropped: list[tuple[Map, str]] = field(default_factory=list)

    def report(self, after_recovery: Diagnostics, found: Diagnostics) -> None:
        """Add the findings about the copy that also apply to the original."""
        reliable = _OF_ONE_ENTRY if self.lost_entries else _OF_ONE_ENTRY | _OF_NAMES
        for finding in after_recovery.found:
            if finding.code in reliable or not (self.lost_keys or self.lost_entries):
                found.add(finding.position, finding.code, finding.message, finding.hint)

    def repair(self, error: ShapeError) -> bool:
        """Repair one error; returns false if that is not possible."""
        node, parent = error.node, error.parent
        if error.validator == "additionalProperties":
            self._rename_keys(error)
        elif error.validator == "dependentRequired":
            self.lost_keys = True
            for key in error.error.validator_value:
                node.pop(key, None)
        elif parent is None:
            return False
        elif isinstance(parent, List) and parent[error.step : error.step + 1] != [node]:
            pass  # its index has changed with earlier deletions; the next round finds it
        elif error.validator == "enum" and (meant := closest(str(node), error.known, _CUTOFF)):
            parent[error.step] = meant
        elif isinstance(parent, Map):
            kinds = error.error.validator_value if error.validator == "type" else ()
            is_entry = error.validator == "required" or "object" in kinds
            self._drop_key(parent, str(error.step), is_entry)
        else:
            self.lost_entries = True
            del parent[error.step]
            del parent.items_at[error.step]
        return True

    def _rename_keys(self, error: ShapeError) -> None:
        node = error.node
        are_supported = True
        for key in error.unknown:
            meant = closest(key, [known for known in error.known if known not in node], _CUTOFF)
            if meant:
                node[meant] = node[key]
                node.keys_at[meant] = node.at(key)
            else:
                are_supported = False
                self.lost_entries = True
            del node[key]
        if are_supported:
            self._misspelled.append(node)

    def _drop_key(self, parent: Map, key: str, is_entry: bool) -> None:
        if key not in parent:
            return  # dropped with another error
        self.lost_keys = True
        self._dropped.append((parent, key))
        if not is_entry and parent[key] != _PLACEHOLDERS.get(key, parent[key]):
            parent[key] = _PLACEHOLDERS[key]
            return
        self.lost_entries |= is_entry or key in _ESSENTIAL
        del parent[key]

    def is_news(self, error: ShapeError) -> bool:
        """True if the original has the error, too; false if a repair caused it."""
        if error.validator != "required":
            is_ours = error.parent is not None and self._has_dropped(error.parent, str(error.step))
            return not is_ours and error.validator not in _OF_WHAT_IS_MISSING
        was_misspelt = any(node is error.node for node in self._misspelled)
        return was_misspelt and not self._has_dropped(error.node, error.missing)

    def _has_dropped(self, parent: Map | List, key: str) -> bool:
        return any(node is parent and dropped == key for node, dropped in self._dropped)


def recover_shape(spec: Spec, found: Diagnostics) -> Recovery | None:
    """A copy that matches the schema, or None. Adds mistakes that this uncovers to `found`."""
    recovery = Recovery(copy.deepcopy(spec), lost_entries=found.any_of(("SBGC003",)))
    for _ in range(_MOST_ROUNDS):
        errors = list(shape_errors(recovery.spec))
        if not errors:
            return recovery
        for error in errors:  # one may be the reason that a family was not read
            is_in_main = error.content.position.file == spec.main.position.file
            if is_in_main and list(error.error.absolute_path)[:1] in ([], ["families"]):
                return None
        for error in errors:
            if recovery.is_news(error):
                add_shape_error(error, found)
        for error in errors:
            if not recovery.repair(error):
                return None
    return None


def recover_syntax(recovery: Recovery, after_recovery: Diagnostics) -> bool:
    """Remove contradictions from fields and parts; returns false if there are others."""
    places = {finding.position for finding in after_recovery.found}
    for content in recovery.spec.families.values():
        _mend(recovery, content, places)
    return not places


def _mend(recovery: Recovery, node: Any, places: set[Position]) -> None:
    """Repair the fields and parts at these positions, and remove the positions from the set."""
    if isinstance(node, Map):
        for key, value in node.items():
            if key in ("fields", "parts") and isinstance(value, List):
                _mend_items(recovery, key, value, places)
        for value in node.values():
            _mend(recovery, value, places)
    elif isinstance(node, list):
        for value in node:
            _mend(recovery, value, places)


def _mend_items(recovery: Recovery, key: str, items: List, places: set[Position]) -> None:
    for index in reversed(range(len(items))):
        item = items[index]
        if not isinstance(item, Map):
            continue  # the key is the name of an entry
        here = places & {item.position, *item.keys_at.values()}
        if not here:
            continue
        places -= here
        recovery.lost_keys = True
        recovery.lost_entries |= "fields" in item
        if key == "fields" and "name" in item:
            for other in [k for k in item if k not in _KEPT]:
                del item[other]
            item["type"] = _ANY_TYPE
            item.setdefault("summary", _PLACEHOLDERS["summary"])
        else:
            recovery.lost_entries = True
            del items[index]
            del items.items_at[index]
