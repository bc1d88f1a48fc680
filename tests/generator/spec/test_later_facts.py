"""The model contains every fact of the notes on the later protocol, and nothing newer than rev. 0.15 besides.

The facts are in tests/data/later_facts.json. They come from the notes, some by a script and those in prose
by hand. The notes are not part of the project, so the facts do not change.
"""

from __future__ import annotations

import copy
import json
from collections.abc import Callable, Iterator
from typing import Any

import pytest
import yaml

from fidelity import Check, Comparison, Json, Table
from later import Later
from support import PROJECT

DATA = PROJECT / "tests" / "data"

# How many facts are compared; the test fails if one of these sinks.
FACTS = {"bodies": 91, "offsets": 119, "enums": 95, "commands": 54, "variables": 62, "parts": 18}
CHECKS = 4500


def _json(name: str) -> Json:
    loaded: Json = json.loads((DATA / name).read_text(encoding="utf-8"))
    return loaded


def _yaml(name: str) -> Json:
    loaded: Json = yaml.safe_load((DATA / name).read_text(encoding="utf-8"))
    return loaded


@pytest.fixture(scope="module")
def facts() -> Json:
    return _json("later_facts.json")


@pytest.fixture(scope="module")
def model() -> Json:
    text = (PROJECT / "generated" / "simplebgc.json").read_text(encoding="utf-8")
    loaded: Json = json.loads(text)
    return loaded


@pytest.fixture(scope="module")
def exceptions() -> list[Json]:
    entries: list[Json] = _yaml("later_exceptions.yaml")["exceptions"]
    return entries


def _checks(facts: Json, model: Json, table: Table) -> list[Check]:
    """Compares both ways: the facts with the model, then what is in neither document."""
    later = Later(facts, model, table)
    checks = later.run()
    known = Table(_yaml("fidelity_exceptions.yaml")["exceptions"], set())
    older = Comparison(_json("specification_facts.json"), model, known, later.told)
    list(older.run())
    return checks + list(later.additions(older))


def _unexplained(checks: list[Check], table: Table) -> Iterator[str]:
    for check in checks:
        if check.holds:
            continue
        entry = table.find(check.kind, check.line, check.name)
        if entry is None:
            yield f"{check}; no exception says why"
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


def test_no_fact_is_lost(facts: Json, checks: list[Check]) -> None:
    assert {key: n for key, n in FACTS.items() if len(facts[key]) < n} == {}
    assert sum(not check.is_addition for check in checks) >= CHECKS


# Sensitivity of the comparison


def _message(model: Json, name: str) -> Json:
    found: Json = next(m for m in model["messages"] if m["name"] == name)
    return found


def _leaf(model: Json, message: str, name: str) -> Json:
    layout = _message(model, message)["layout"]
    found: Json = next(f for f in layout if f["spec_name"] == name)
    return found


def _value(model: Json, enum: str, name: str) -> Json:
    values = next(e for e in model["enums"] if e["name"] == enum)["values"]
    found: Json = next(v for v in values if v["name"] == name)
    return found


def _add(values: list[Json], **other: Any) -> None:
    values.append({**values[-1], **other})


def _enum(model: Json, name: str) -> Json:
    found: Json = next(e for e in model["enums"] if e["name"] == name)
    return found


def _command(model: Json, name: str) -> Json:
    found: Json = next(c for c in model["commands"] if c["name"] == name)
    return found


def _variable(model: Json, number: int) -> Json:
    found: Json = next(v for v in model["adjustable_variables"] if v["id"] == number)
    return found


MUTATIONS: dict[str, Callable[[Json], object]] = {
    "id": lambda m: _command(m, "CMD_SIGN_MESSAGE").update(id=5),
    "command's version": lambda m: _command(m, "CMD_PROFILE_SET").update(since=None),
    "message's version": lambda m: _message(m, "ProfileSet").update(since={"firmware": "2.66"}),
    "type": lambda m: _leaf(m, "SyncMotors", "TIME_MS").update(type="i16"),
    "name": lambda m: _leaf(m, "ProfileSet", "SLOT").update(spec_name="SLOTS"),
    "order": lambda m: _message(m, "SyncMotors")["layout"].reverse(),
    "missing field": lambda m: _message(m, "Event")["layout"].pop(),
    "missing message": lambda m: m["messages"].remove(_message(m, "Event")),
    "size": lambda m: _message(m, "ControlQuatStatus").update(max_size=98),
    "bit of a condition": lambda m: _value(m, "CanDrvTelemetryFlags", "TEMP_BOARD").update(value=1),
    "named reserved byte": lambda m: _leaf(m, "BoardInfo3", "HW_FLAGS").update(offset=48),
    "parameter": lambda m: _leaf(m, "ReadParamsExt3", "SOFT_LIMIT_WIDTH").update(offset=41),
    "scale": lambda m: _leaf(m, "ReadParamsExt2", "MOTOR_RES").update(scale_exact="1"),
    "unit": lambda m: _leaf(m, "ExtMotorsState", "CURRENT").update(unit="A"),
    "invented unit": lambda m: _leaf(m, "SignMessageRequest", "SIGN_TYPE").update(
        scale=2, quantity="W"
    ),
    "invented range": lambda m: _leaf(m, "SignMessageRequest", "SIGN_TYPE").update(min=0, max=9),
    "range": lambda m: _leaf(m, "CalibCogging", "SMOOTH").update(max=101),
    "since": lambda m: _leaf(m, "DebugVarsInfo3Request", "START_IDX").update(since=None),
    "invented since": lambda m: _leaf(m, "CalibCogging", "SPEED").update(
        since={"firmware": "2.70"}
    ),
    "enum value": lambda m: _value(m, "CalibMode", "COGGING").update(value=99),
    "enum value's name": lambda m: _value(m, "CalibMode", "COGGING").update(name="KOGGING"),
    "enum value's version": lambda m: _value(m, "EventId", "SCRIPT").update(since=None),
    "invented value": lambda m: _add(_enum(m, "EventId")["values"], name="MORE", value=7),
    "invented flag": lambda m: _add(_enum(m, "StateFlags")["values"], name="MORE", value=1 << 31),
    "packed part": lambda m: next(p for p in m["packed"] if p["name"] == "PackedQuaternion")[
        "parts"
    ][0].update(mask=1),
    "stream": lambda m: _leaf(m, "DataStreamInterval", "CONFIG")["cases"].pop(),
    "variable": lambda m: _variable(m, 81).update(max=255),
    "variable's version": lambda m: _value(m, "VariableId", "EULER_ORDER").update(since=None),
}


@pytest.mark.parametrize("mutation", MUTATIONS)
def test_a_changed_model_is_noticed(
    mutation: str, facts: Json, model: Json, exceptions: list[Json]
) -> None:
    changed = copy.deepcopy(model)
    MUTATIONS[mutation](changed)
    table = Table(exceptions, set())
    assert list(_unexplained(_checks(facts, changed, table), table))
