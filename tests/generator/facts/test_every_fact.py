"""Every key of the YAML has an effect on the exported model, the C++, the vectors, or the findings.

For each key path of the JSON Schema, one value after another is changed in a copy of the spec in memory
until a change has an effect. A rejection counts only if every valid value is rejected. `table.yaml` lists
the keys that affect only documentation, and values that the test cannot derive.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from contextlib import ExitStack
from itertools import islice
from typing import Any, Optional

import pytest
import yaml

from changes import ABSENT, changed, changes
from effects import Made
from key_paths import Place, key_paths, nodes, places, validator
from sbgcgen.spec.diagnostics import Diagnostics
from sbgcgen.spec.load import Spec, load
from support import HERE, PROJECT

# The maximum number of changes of a path, and of places to change.
_CHANGES = 7
_PLACES = 4
# The search ends after this number of valid changes without effect.
_SILENT = 3

TABLE: dict[str, Any] = yaml.safe_load((HERE / "facts" / "table.yaml").read_text("utf-8"))


def loaded() -> Spec:
    """Returns the spec in memory."""
    found = Diagnostics()
    spec = load(PROJECT / "spec", found)
    found.raise_if_any()
    return spec


class Facts:
    """The spec, its output, and the places where it uses each key path."""

    def __init__(self) -> None:
        self.spec = loaded()
        self.before = Made(self.spec, PROJECT)
        assert self.before.model is not None and not self.before.is_refused
        self.places: dict[str, list[Place]] = defaultdict(list)
        for place in places(self.spec):
            self.places[place.path].append(place)

    def shows(self, path: str) -> str:
        """Returns where a change of this path has an effect: "" if nowhere, "unused" for an unused
        key."""
        refused = silent = 0
        for made, before in islice(self.variants(path), _CHANGES):
            if shown := difference(made, before, path in TABLE["documentation"]):
                return shown
            if made.is_refused and path in TABLE["refused"]:
                return "lint"
            refused += made.is_refused
            silent += not made.is_refused
            if silent == _SILENT:
                return ""
        if not refused and not silent:
            return "unused" if path not in self.places else self.only_value(self.places[path][0])
        return "lint" if refused else ""

    def variants(self, path: str) -> Iterator[tuple[Made, Made]]:
        """Yields the output for one change after another, and the output before the change."""
        found = self.places.get(path, [])
        chosen = found[:: max(1, len(found) // _PLACES)][:_PLACES]
        for place in chosen:
            first = [part[path] for part in (TABLE["values"], TABLE["refused"]) if path in part]
            pool = [other.value for other in chosen if other.value != place.value]
            for value in (*first, *changes(place, pool[:3])):
                with changed(place.parent, place.key, value):
                    yield self.made(), self.before
        for place in chosen if path.endswith("*") else ():
            with changed(place.parent, f"{place.key}_X", place.value):
                with changed(place.parent, place.key, ABSENT):
                    yield self.made(), self.before
        if not found and path in TABLE["unused"]:
            yield from self.uses(path, **TABLE["unused"][path])

    def uses(
        self,
        path: str,
        value: Any,
        beside: Optional[dict[str, Any]] = None,
        having: str = "",
        named: str = "",
        without: str = "",
    ) -> Iterator[tuple[Made, Made]]:
        """Yields the output with a key that the spec does not use, and without it."""
        definition, _, key = path.rpartition(".")
        for node in nodes(self.spec, definition):
            if having and having not in node or named not in str(node.get("name", "")):
                continue
            if without and without not in node:
                continue
            with ExitStack() as stack:
                if without:
                    stack.enter_context(changed(node, without, ABSENT))
                for other, content in (beside or {}).items():
                    stack.enter_context(changed(node, other, content))
                before = self.before
                if beside:
                    before = self.made()
                    assert before.model is not None
                with changed(node, key, value):
                    yield self.made(), before

    def made(self) -> Made:
        """Returns the output for the spec in its current state."""
        return Made(self.spec, PROJECT)

    @staticmethod
    def only_value(place: Place) -> str:
        """Returns "lint" for a place where the schema allows a single value."""
        return "" if validator(place.schema).is_valid(f"{place.value}_X") else "lint"


def difference(made: Made, before: Made, is_documentation: bool) -> str:
    """Returns where a valid change has an effect."""
    if made.model is not None and made.model != before.model:
        return "model"
    if made.is_refused:
        return ""
    if made.code != before.code:
        return "code"
    if made.vectors != before.vectors:
        return "vectors"
    return "documentation" if is_documentation and not made.is_documented_like(before) else ""


@pytest.fixture(name="facts", scope="module")
def all_facts() -> Facts:
    """One instance for all tests: each test restores the spec."""
    return Facts()


@pytest.mark.parametrize("path", sorted(key_paths()))
def test_a_change_shows(path: str, facts: Facts) -> None:
    shown = facts.shows(path)
    if path in TABLE["documentation"]:
        assert shown == "documentation", f"{path} drives more than documentation: {shown}"
    else:
        assert shown, f"a change of {path} has no effect"
        assert (
            shown != "unused"
        ), f"the spec does not use {path}: show a use in table.yaml, or delete it"


def test_the_start_is_in_the_code_and_in_the_vectors(facts: Facts) -> None:
    place = facts.places["main.framings.*.start"][0]
    with changed(place.parent, place.key, 0x25):
        made, before = facts.made(), facts.before
        assert made.model != before.model and not made.is_refused
        assert made.code["include/sbgc/protocol.hpp"] != before.code["include/sbgc/protocol.hpp"]
        assert made.vectors["frames.jsonl"] != before.vectors["frames.jsonl"]


@pytest.mark.parametrize(
    ("path", "value"),
    [
        ("main.framings.*.header", ["start", "size", "id", "header_checksum"]),
        ("main.framings.*.checksums.*.covers", ["id"]),
    ],
)
def test_a_framing_that_the_code_cannot_have_is_refused(
    path: str, value: list[str], facts: Facts
) -> None:
    place = facts.places[path][0]
    with changed(place.parent, place.key, value):
        assert facts.made().is_refused


def test_the_table_is_needed(facts: Facts) -> None:
    for part in TABLE.values():
        assert not set(part) - key_paths(), "there is no such path"
    assert not set(TABLE["unused"]) & set(facts.places), "the spec uses it"


def test_the_spec_is_as_it_was(facts: Facts) -> None:
    again = loaded()
    for part in ("main", "families", "errata"):
        assert getattr(facts.spec, part) == getattr(again, part)
