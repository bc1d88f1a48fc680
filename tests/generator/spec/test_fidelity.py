"""The model contains every fact of the specification's text, or an erratum explains the difference.

The facts are in tests/data/specification_facts.json. A script extracted them from the text, which is not
part of the project, so they do not change.
"""

from __future__ import annotations

import copy
from collections import Counter
from collections.abc import Callable, Iterator

import pytest

from fidelity import (
    DATA,
    LATER,
    Check,
    Comparison,
    Json,
    Table,
    leaf_of,
    loaded,
    model_of_documents,
    value_of,
)
from later import Later
from sbgcgen.model.names import parse_lines
from support import project_layout


# Said for each difference.
HOW_TO_EXPLAIN = (
    "if the model is right, add an entry with its erratum to tests/data/fidelity_exceptions.yaml, "
    "because the text says otherwise"
)


@pytest.fixture(scope="module")
def facts() -> Json:
    return loaded(DATA / "specification_facts.json")


@pytest.fixture(scope="module")
def model() -> Json:
    return model_of_documents()


@pytest.fixture(scope="module")
def accepted() -> Json:
    return loaded(DATA / "fidelity_exceptions.yaml")


@pytest.fixture(scope="module")
def exceptions(accepted: Json) -> Table:
    return Table(accepted["exceptions"], set())


@pytest.fixture(scope="module")
def not_checked(accepted: Json) -> Table:
    return Table(accepted["not_checked"], set())


def _compare(facts: Json, model: Json, table: Table) -> list[Check]:
    """Compares the model with the text; what the notes on later firmware know is no addition."""
    later = Later(loaded(DATA / "later_facts.json"), model, Table([], set()))
    later.run()
    comparison = Comparison(facts, model, table, later.told)
    return [
        check
        for check in comparison.run()
        if not check.is_addition
        or table.find(check.kind, check.line, check.name)
        or not later.knows(check, comparison)
    ]


@pytest.fixture(scope="module")
def checks(facts: Json, model: Json, exceptions: Table) -> list[Check]:
    return _compare(facts, model, exceptions)


def _unexplained(checks: list[Check], exceptions: Table, not_checked: Table) -> Iterator[str]:
    for check in checks:
        if check.holds and check.kind != "extra command":
            continue
        entry = exceptions.find(check.kind, check.line, check.name)
        if entry is None and not_checked.find(check.kind, check.line, check.name) is None:
            yield f"{check}; {HOW_TO_EXPLAIN}"
        elif entry is not None and str(entry["ours"]) != str(check.ours):
            yield f"{check}; the exception says {entry['ours']} ({entry['errata']})"


def test_every_fact_is_in_the_model_or_has_an_erratum(
    checks: list[Check], exceptions: Table, not_checked: Table
) -> None:
    assert list(_unexplained(checks, exceptions, not_checked)) == []


def test_every_exception_is_needed(
    checks: list[Check], exceptions: Table, not_checked: Table
) -> None:
    list(_unexplained(checks, exceptions, not_checked))
    for table in (exceptions, not_checked):
        assert [e for i, e in enumerate(table.entries) if i not in table.used] == []


def test_every_exception_names_an_erratum_about_its_lines(accepted: Json, model: Json) -> None:
    errata = {e["number"]: e for e in model["errata"]}
    for entry in accepted["exceptions"]:
        assert entry["errata"] in errata, f"{entry}: there is no such erratum"
        line = entry.get("line")
        known = [int(text[1:]) for text in errata[entry["errata"]]["lines"]]
        if line is not None and known:
            first, last = line if isinstance(line, list) else (line, line)
            near = any(first - 3 <= number <= last + 3 for number in known)
            assert near, f"{entry}: {entry['errata']} is about other lines"


def test_no_fact_is_lost(
    checks: list[Check], accepted: Json, capsys: pytest.CaptureFixture[str]
) -> None:
    """The number of facts must not drop; if it rises, the recorded numbers should, too."""
    distinct = {check.fact for check in checks if not check.is_addition}
    counts = Counter(kind for kind, *_ in distinct)
    with capsys.disabled():
        words = ", ".join(f"{kind} {number}" for kind, number in counts.most_common())
        additions = sum(check.is_addition for check in checks)
        print(f"\n{len(distinct)} facts of the specification in {len(checks)} comparisons")
        print(f"  {words}; and {additions} additions with an erratum")
    recorded = accepted["facts"]
    assert set(counts) == set(recorded)
    assert {k: n for k, n in recorded.items() if counts[k] < n} == {}


# Sources named by the spec


def test_the_source_of_a_message_is_about_its_command(facts: Json, model: Json) -> None:
    """Each range of lines names the command, or is in its list, its table or its errata."""
    mentioned = {name: set(lines) for name, lines in facts["mentions"].items()}
    lines: dict[str, set[int]] = {}
    for body in facts["bodies"]:
        own = lines.setdefault(body["command"].removesuffix("_3"), set())
        own.update(field["line"] for field in body["fields"])
        own.add(body["line"])
    for row in facts["rows"]:
        for command in row["commands"]:
            lines.setdefault(command.removesuffix("_3"), set()).add(row["line"])
    codes = {code["line"] for code in facts["codes"]}
    errata = {e["number"]: e["lines"] for e in model["errata"]}
    with_codes = {
        message["command"]
        for message in model["messages"]
        if any(leaf["spec_name"] == "ERR_CODE" for leaf in message["layout"])
    } | {code["command"] for code in facts["codes"]}
    for message in model["messages"]:
        name = message["command"]
        about = mentioned.get(name, set()) | mentioned.get(f"{name}_3", set())
        ranges = parse_lines(message["source"])
        if not ranges and message["source"] == LATER:  # test_later_facts.py compares those
            continue
        assert ranges, f"{message['name']}: no lines in '{message['source']}'"
        wanted = about | lines.get(name.removesuffix("_3"), set())
        if name in with_codes:
            wanted |= codes
        for number in message["errata"]:
            wanted = wanted | {int(line[1:]) for line in errata[number]}
        for first, last in ranges:
            inside = any(first <= line <= last for line in wanted)
            assert inside, f"{message['name']}: nothing about {name} in L{first}-L{last}"
        assert any(
            first <= line <= last for first, last in ranges for line in about
        ), f"{message['name']}: no line of its source names {name}"


def test_the_source_of_an_enum_holds_its_values(facts: Json, model: Json) -> None:
    """One of its lines has a named value, or the field with the enum as its type."""
    constants: dict[str, set[int]] = {}
    fields: dict[str, set[int]] = {}
    for row in facts["rows"]:
        spans = [row["line"], *row.get("more_lines", [])]
        for name in row["names"]:
            fields.setdefault(name.partition("[")[0], set()).update(spans)
        for constant in row.get("constants", []):
            constants.setdefault(constant["name"], set()).add(constant["line"])
    for code in facts["codes"]:
        constants.setdefault(code["name"], set()).add(code["line"])
    for body in facts["bodies"]:
        for field in body["fields"]:
            spans = [field["line"], *field.get("more_lines", [])]
            fields.setdefault(field["name"], set()).update(spans)
    for variable in facts["variables"]:
        constants.setdefault(variable["name"], set()).add(variable["line"])
    for define in facts["defines"]:
        constants.setdefault(define["name"], set()).add(define["line"])
    users = _fields_by_enum(model)
    for enum in model["enums"]:
        about: set[int] = set()
        for value in enum["values"]:
            about |= constants.get(value["name"], set())
        for name in users.get(enum["name"], set()):
            about |= fields.get(name, set())
        ranges = parse_lines(enum["source"])
        if not ranges and enum["source"] == LATER:  # test_later_facts.py compares those
            continue
        inside = any(first <= line <= last for first, last in ranges for line in about)
        assert inside, f"{enum['name']}: none of its values in '{enum['source']}'"


def _fields_by_enum(model: Json) -> dict[str, set[str]]:
    """Returns the names of the fields that have an enum as their type, or as the type of a part."""
    users: dict[str, set[str]] = {}
    parts = {p["name"]: p for p in model["packed"]}
    for message in model["messages"]:
        leaves = [leaf for top in message["layout"] for leaf in [top, *top.get("cases", [])]]
        for leaf in leaves:
            packed = parts.get(leaf.get("packed", ""), {"parts": []})
            names = {leaf["enum"], *(part["enum"] for part in packed["parts"])}
            for name in names - {None}:
                users.setdefault(name, set()).add(leaf["spec_name"])
                if leaf["path"].startswith("config."):
                    users[name].add("CONFIG")
    return users


def test_every_source_lies_in_the_text(facts: Json) -> None:
    layout = project_layout()
    last = facts["specification"]["lines"]
    things: list[tuple[str, str]] = [
        *((m.name, m.source) for m in layout.messages),
        *((e.name, e.source) for e in layout.enums),
        *((p.name, p.source) for p in layout.packed),
        *((c.name, c.source) for c in layout.commands),
    ]
    for name, source in things:
        for first, end in parse_lines(source):
            assert 1 <= first <= end <= last, f"{name}: L{first}-L{end}"


# Sensitivity of the comparison


MUTATIONS: dict[str, Callable[[Json], object]] = {
    "id": lambda m: m["commands"][0].update(id=200),
    "type": lambda m: leaf_of(m, "BoardInfo", "FIRMWARE_VER").update(type="i16"),
    "offset": lambda m: leaf_of(m, "RealtimeData3", "CYCLE_TIME").update(offset=99),
    "name": lambda m: leaf_of(m, "ReadParams3", "GYRO_SENS").update(spec_name="GYRO_SENSE"),
    "axis": lambda m: leaf_of(m, "ReadParams3", "P").update(path="axes.yaw.p"),
    "order": lambda m: m["messages"][0]["layout"].reverse(),
    "missing field": lambda m: m["messages"][0]["layout"].pop(),
    "missing message": lambda m: m["messages"].pop(0),
    "minimum": lambda m: leaf_of(m, "ReadParams3", "SERVO_RATE").update(min=4),
    "maximum": lambda m: leaf_of(m, "CalibInfo", "PROGRESS").update(max=101),
    "invented range": lambda m: leaf_of(m, "ReadParams3", "GYRO_SENS").update(min=0, max=9),
    "scale": lambda m: leaf_of(m, "RealtimeData3", "BAT_LEVEL").update(scale=0.1),
    "unit": lambda m: leaf_of(m, "RealtimeData4", "CURRENT").update(unit="A"),
    "invented unit": lambda m: leaf_of(m, "ReadParams3", "POWER").update(scale=0.5, quantity="W"),
    "enum value": lambda m: value_of(m, "MenuCommand", "MENU_CMD_RUN_SCRIPT3").update(value=99),
    "enum value's name": lambda m: value_of(m, "SystemErrors", "ERR_SYSTEM").update(name="ERR_SYS"),
    "special value": lambda m: leaf_of(m, "ApiVirtChControl", "VAL_CH7").update(special={}),
    "answer": lambda m: [x.update(response=None) for x in m["messages"] if x["id"] == 25],
    "version": lambda m: [x.update(since=None) for x in m["messages"] if x["id"] == 89],
    "variable": lambda m: m["adjustable_variables"][37].update(max=1801),
}


@pytest.mark.parametrize("mutation", MUTATIONS)
def test_a_changed_model_is_noticed(
    mutation: str, facts: Json, model: Json, accepted: Json, not_checked: Table
) -> None:
    changed = copy.deepcopy(model)
    MUTATIONS[mutation](changed)
    table = Table(accepted["exceptions"], set())
    found = _compare(facts, changed, table)
    assert list(_unexplained(found, table, not_checked))
