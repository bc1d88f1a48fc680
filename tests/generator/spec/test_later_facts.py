"""The model contains every fact of the notes on the later protocol, and nothing newer than rev. 0.15 besides.

The facts are in tests/data/later_facts.json. They come from the notes, some by a script and those in prose
by hand. The notes are not part of the project, so the facts do not change.
"""

from __future__ import annotations

import copy
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from fidelity import (
    DATA,
    Check,
    Comparison,
    Json,
    Table,
    leaf_of,
    loaded,
    model_of_documents,
    named,
    value_of,
)
from later import Later

# Said for each difference.
HOW_TO_EXPLAIN = (
    "if the model is right, add an entry with the reason to tests/data/later_exceptions.yaml, "
    "because no document says so"
)
# How many facts are compared; the test fails if one of these sinks.
FACTS = {"bodies": 91, "offsets": 119, "enums": 95, "commands": 54, "variables": 62, "parts": 18}
CHECKS = 4500


@pytest.fixture(scope="module")
def facts() -> Json:
    return loaded(DATA / "later_facts.json")


@pytest.fixture(scope="module")
def model() -> Json:
    return model_of_documents()


@pytest.fixture(scope="module")
def exceptions() -> list[Json]:
    entries: list[Json] = loaded(DATA / "later_exceptions.yaml")["exceptions"]
    return entries


def _checks(facts: Json, model: Json, table: Table) -> list[Check]:
    """Compares both ways: the facts with the model, then what is in neither document."""
    later = Later(facts, model, table)
    checks = later.run()
    known = Table(loaded(DATA / "fidelity_exceptions.yaml")["exceptions"], set())
    older = Comparison(loaded(DATA / "specification_facts.json"), model, known, later.told)
    list(older.run())
    return checks + list(later.additions(older))


def _unexplained(checks: list[Check], table: Table) -> Iterator[str]:
    for check in checks:
        if check.holds:
            continue
        entry = table.find(check.kind, check.line, check.name)
        if entry is None:
            yield f"{check}; {HOW_TO_EXPLAIN}"
        elif "ours" in entry and str(entry["ours"]) != str(check.ours):
            yield f"{check}; the exception says {entry['ours']}"


@pytest.fixture(scope="module")
def checks(facts: Json, model: Json) -> list[Check]:
    return _checks(facts, model, Table([], set()))


def test_every_fact_is_in_the_model_and_nothing_else_is_newer(
    checks: list[Check], exceptions: list[Json]
) -> None:
    assert list(_unexplained(checks, Table(exceptions, set()))) == []


def test_every_exception_is_needed(checks: list[Check], exceptions: list[Json]) -> None:
    needed = {
        (number, pattern)
        for number, entry in enumerate(exceptions)
        for pattern in str(entry["name"]).split()
        for check in checks
        if not check.holds
        and Table([{**entry, "name": pattern}], set()).find(check.kind, check.line, check.name)
    }
    unneeded = [
        (entry["kind"], pattern)
        for number, entry in enumerate(exceptions)
        for pattern in str(entry["name"]).split()
        if (number, pattern) not in needed
    ]
    assert unneeded == []
    assert all(entry["reason"] for entry in exceptions)


def test_errata_named_in_reasons_exist(exceptions: list[Json], model: Json) -> None:
    errata = {e["number"] for e in model["errata"]}
    for entry in exceptions:
        words = entry["reason"].replace("(", " ").replace(")", " ").split()
        named = {word for word in words if word[0] == "E" and word[1:].isdigit()}
        assert named <= errata, entry


def test_what_the_document_lacks_has_a_first_firmware() -> None:
    documented = {entry["value"] for entry in loaded(DATA / "specification_facts.json")["defines"]}
    commands = loaded(DATA.parents[1] / "generated/simplebgc.json")["commands"]
    later = [c for c in commands if c["id"] not in {None, *documented}]
    undated = [c["name"] for c in later if not (c["since"] or {}).get("firmware")]
    assert later and undated == []


def test_no_fact_is_lost(facts: Json, checks: list[Check]) -> None:
    assert {key: n for key, n in FACTS.items() if len(facts[key]) < n} == {}
    assert sum(not check.is_addition for check in checks) >= CHECKS


# Sensitivity of the comparison


def _add(values: list[Json], **other: Any) -> None:
    values.append({**values[-1], **other})


def _message(model: Json, name: str) -> Json:
    return named(model["messages"], name)


def _command(model: Json, name: str) -> Json:
    return named(model["commands"], name)


def _variable(model: Json, number: int) -> Json:
    return next(v for v in model["adjustable_variables"] if v["id"] == number)


MUTATIONS: dict[str, Callable[[Json], object]] = {
    "id": lambda m: _command(m, "CMD_SIGN_MESSAGE").update(id=5),
    "command's version": lambda m: _command(m, "CMD_PROFILE_SET").update(since=None),
    "message's version": lambda m: _message(m, "ProfileSet").update(since={"firmware": "2.66"}),
    "type": lambda m: leaf_of(m, "SyncMotors", "TIME_MS").update(type="i16"),
    "name": lambda m: leaf_of(m, "ProfileSet", "SLOT").update(spec_name="SLOTS"),
    "order": lambda m: _message(m, "SyncMotors")["layout"].reverse(),
    "missing field": lambda m: _message(m, "Event")["layout"].pop(),
    "missing message": lambda m: m["messages"].remove(_message(m, "Event")),
    "size": lambda m: _message(m, "ControlQuatStatus").update(max_size=98),
    "bit of a condition": lambda m: value_of(m, "CanDrvTelemetryFlags", "TEMP_BOARD").update(
        value=1
    ),
    "named reserved byte": lambda m: leaf_of(m, "BoardInfo3", "HW_FLAGS").update(offset=48),
    "parameter": lambda m: leaf_of(m, "ReadParamsExt3", "SOFT_LIMIT_WIDTH").update(offset=41),
    "scale": lambda m: leaf_of(m, "ReadParamsExt2", "MOTOR_RES").update(scale_exact="1"),
    "unit": lambda m: leaf_of(m, "ExtMotorsState", "CURRENT").update(unit="A"),
    "invented unit": lambda m: leaf_of(m, "SignMessageRequest", "SIGN_TYPE").update(
        scale=2, quantity="W"
    ),
    "invented range": lambda m: leaf_of(m, "SignMessageRequest", "SIGN_TYPE").update(min=0, max=9),
    "range": lambda m: leaf_of(m, "CalibCogging", "SMOOTH").update(max=101),
    "since": lambda m: leaf_of(m, "DebugVarsInfo3Request", "START_IDX").update(since=None),
    "invented since": lambda m: leaf_of(m, "CalibCogging", "SPEED").update(
        since={"firmware": "2.70"}
    ),
    "enum value": lambda m: value_of(m, "CalibMode", "COGGING").update(value=99),
    "enum value's name": lambda m: value_of(m, "CalibMode", "COGGING").update(name="KOGGING"),
    "enum value's version": lambda m: value_of(m, "EventId", "SCRIPT").update(since=None),
    "invented value": lambda m: _add(named(m["enums"], "EventId")["values"], name="MORE", value=7),
    "invented flag": lambda m: _add(
        named(m["enums"], "StateFlags")["values"], name="MORE", value=1 << 31
    ),
    "packed part": lambda m: next(p for p in m["packed"] if p["name"] == "PackedQuaternion")[
        "parts"
    ][0].update(mask=1),
    "stream": lambda m: leaf_of(m, "DataStreamInterval", "CONFIG")["cases"].pop(-2),
    "variable": lambda m: _variable(m, 81).update(max=255),
    "variable's version": lambda m: value_of(m, "VariableId", "EULER_ORDER").update(since=None),
}


@pytest.mark.parametrize("mutation", MUTATIONS)
def test_a_changed_model_is_noticed(
    mutation: str, facts: Json, model: Json, exceptions: list[Json]
) -> None:
    changed = copy.deepcopy(model)
    MUTATIONS[mutation](changed)
    table = Table(exceptions, set())
    assert list(_unexplained(_checks(facts, changed, table), table))
