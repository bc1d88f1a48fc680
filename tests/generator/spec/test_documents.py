"""The model contains every fact of the two documents and nothing besides, or an exception explains the difference.

The documents are the specification's text, and the notes on the later protocol. Neither is part of the project,
so the facts in tests/data/*_facts.json, which come from them, do not change.
"""

from __future__ import annotations

import copy
from collections import Counter
from typing import Any

import pytest

import altered
from additions import additions
from documents import DATA, FACTS, Check, Json, Table, entry_lines, loaded, model_of_documents
from fidelity import Comparison
from later import Later
from support import project_layout

DOCUMENTS = ("fidelity", "later")
EXCEPTIONS = {name: loaded(DATA / f"{name}_exceptions.yaml") for name in DOCUMENTS}
# Said for each difference.
HOW_TO_EXPLAIN = (
    "if the model is right, add an entry to tests/data/*_exceptions.yaml with its erratum or reason"
)
ALTERED = {"fidelity": altered.SPECIFICATION, "later": altered.LATER}

Compared = dict[str, tuple[list[Check], Table]]


def compared(model: Json) -> Compared:
    """Returns the checks of each document and of additions to both, with the exceptions."""
    tables = {name: Table([]) for name in (*DOCUMENTS, "additions")}
    for name, found in EXCEPTIONS.items():
        for entry in found["exceptions"] + found.get("not_checked", []):
            is_extra = entry["kind"].startswith("extra")
            tables["additions" if is_extra else name].entries.append(entry)
    notes = Later(FACTS["later"], model)
    newer = list(notes.run())
    text = Comparison(FACTS["specification"], model, tables["fidelity"], notes.told)
    older = list(text.run())
    extra = [check for check in older if check.is_addition]
    checks = {
        "fidelity": [check for check in older if not check.is_addition],
        "later": newer,
        "additions": [*extra, *additions(notes, text.told, notes.told)],
    }
    return {name: (checks[name], tables[name]) for name in checks}


def unexplained(checks: list[Check], table: Table) -> list[Check]:
    return [check for check in checks if not check.holds and not table.explains(check)]


@pytest.fixture(scope="module")
def model() -> Json:
    return model_of_documents()


@pytest.fixture(scope="module")
def both(model: Json) -> Compared:
    return compared(model)


@pytest.mark.parametrize("document", (*DOCUMENTS, "additions"))
def test_an_exception_explains_each_difference_and_is_needed(both: Compared, document: str) -> None:
    found = [str(check) for check in unexplained(*both[document])]
    assert found == [], HOW_TO_EXPLAIN
    assert both[document][1].unneeded() == []


@pytest.mark.parametrize("document", DOCUMENTS)
def test_every_exception_has_a_reason(document: str, model: Json) -> None:
    """It names errata that exist, and that are about its lines of the text."""
    errata = {e["number"]: e for e in model["errata"]}
    for entry in EXCEPTIONS[document]["exceptions"]:
        words = entry.get("errata", entry.get("reason", "")).replace("(", " ").replace(")", " ")
        numbers = {word for word in words.split() if word[0] == "E" and word[1:].isdigit()}
        assert words and numbers <= set(errata), entry
        for number in numbers if document == "fidelity" and "line" in entry else ():
            first, last = entry_lines(entry, 0)
            known = [int(text[1:]) for text in errata[number]["lines"]]
            near = any(first - 3 <= line <= last + 3 for line in known)
            assert near or not known, f"{entry}: {number} is about other lines"


@pytest.mark.parametrize("document", DOCUMENTS)
def test_no_fact_is_lost(both: Compared, document: str) -> None:
    """The number of facts must not drop; if it rises, the recorded numbers should, too."""
    distinct = {check.fact for check in both[document][0]}
    counts = Counter(kind for kind, *_ in distinct)
    recorded = EXCEPTIONS[document]["facts"]
    assert set(counts) == set(recorded)
    assert {kind: n for kind, n in recorded.items() if counts[kind] < n} == {}


@pytest.mark.parametrize("document", DOCUMENTS)
def test_every_kind_of_fact_notices_an_altered_model(document: str, model: Json) -> None:
    changed = copy.deepcopy(model)
    for _, place, change, *_ in ALTERED[document]:
        altered.alter(changed, place, change)
    every = compared(changed)
    found = [
        (check.kind, check.name)
        for part in (document, "additions")
        for check in unexplained(*every[part])
    ]

    def noticed(kind: str, place: str, _change: Any, name: str = "") -> bool:
        return any(kind == k and (name or place.rpartition(".")[2]) in n for k, n in found)

    assert [row for row in ALTERED[document] if not noticed(*row)] == []
    kinds = {kind for kind, *_ in ALTERED[document]}
    # The model does not say which notations the text defines.
    assert set(EXCEPTIONS[document]["facts"]) - kinds <= {"notation"}


def test_what_the_text_lacks_has_a_first_firmware() -> None:
    facts = FACTS["specification"]
    documented = {None, *(define["value"] for define in facts["defines"])}
    later = [c for c in project_layout().commands if c.id not in documented]
    undated = [c.name for c in later if not c.since.firmware]
    assert later and undated == []
