"""generated/fields/ has a row for each field and each value of an enum, and no heading twice."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[2]
MODEL = json.loads((ROOT / "generated/simplebgc.json").read_text(encoding="utf-8"))
PAGES = {path.stem: path.read_text("utf-8") for path in (ROOT / "generated/fields").glob("*.md")}


def name_of(thing: dict[str, Any]) -> str:
    """Returns the id of a message or type in pytest."""
    return str(thing["name"])


def sections(page: str) -> dict[str, list[list[str]]]:
    """Returns the rows under each heading; without the marks of code."""
    parts = [part.partition("\n") for part in re.split(r"^## ", page, flags=re.M)[1:]]
    assert len({title for title, _, _ in parts}) == len(parts)
    return {
        title: [
            [cell.strip(" `") for cell in row.split("|")[1:-1]]
            for row in re.findall(r"^\|.*\|$", text, re.M)[2:]
        ]
        for title, _, text in parts
    }


TABLES = {title: rows for page in PAGES.values() for title, rows in sections(page).items()}


@pytest.mark.parametrize("message", MODEL["messages"], ids=name_of)
def test_each_field_has_a_row(message: dict[str, Any]) -> None:
    way = message["direction"].replace("_", " the ")
    rows = TABLES[f"{message['name']} ({way})"]
    leaves = [leaf for outer in message["layout"] for leaf in (outer, *outer.get("cases", ()))]
    if message["same_as"] not in (None, message["name"]):
        leaves = []
    assert [row[:1] + row[2:3] for row in rows] == [
        [str("…" if leaf["offset"] is None else leaf["offset"]), leaf["path"]] for leaf in leaves
    ]
    for (_, type_, _, unit, limits), leaf in zip(rows, leaves):
        assert type_.split()[0] in (leaf["type"], "announced")
        assert (leaf["unit"] or "") in unit
        for limit in (leaf["min"], leaf["max"]):
            assert limit is None or str(limit) in limits.split()


@pytest.mark.parametrize("enum", MODEL["enums"], ids=name_of)
def test_each_value_has_a_row(enum: dict[str, Any]) -> None:
    rows = [[str(value["value"]), value["name"]] for value in enum["values"]]
    assert TABLES[enum["name"]] == rows


@pytest.mark.parametrize("packed", MODEL["packed"], ids=name_of)
def test_each_part_has_a_row(packed: dict[str, Any]) -> None:
    assert [row[1] for row in TABLES[packed["name"]]] == [p["name"] for p in packed["parts"]]


def test_one_byte_is_singular() -> None:
    headers = (ROOT / "generated/include").rglob("*.hpp")
    for text in (*PAGES.values(), *(path.read_text(encoding="utf-8") for path in headers)):
        assert not re.search(r"(?<![0-9])1 bytes", text)
