"""The reader disables YAML's type guesses, and every value has a position."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from sbgcgen.spec.diagnostics import Diagnostics
from sbgcgen.spec.load import List, Map, load
from support import write_spec


def loaded(folder: Path, text: str) -> Map:
    """Returns a family file as loaded."""
    found = Diagnostics()
    spec = load(write_spec(folder, text), found)
    assert found.found == []
    return spec.families["probe"]


TEXTS = """2.50 2.59 1e3 on no yes True 010 0o10 1_000 0..100 -127..127 12:30 2016-07-09 360/16384 .inf
    9999999999999999999""".split()
OTHERS = [
    *(("true", True), ("false", False), ("null", None), ("~", None), ("", None)),
    *(("5", 5), ("-5", -5), ("0", 0), ("0x3E", 62), ("0xff", 255), ("9" * 18, int("9" * 18))),
    *(("'5'", "5"), ('"true"', "true"), ("'0x10'", "0x10")),
]


@pytest.mark.parametrize(("text", "value"), [*((text, text) for text in TEXTS), *OTHERS])
def test_scalars(text: str, value: Any, tmp_path: Path) -> None:
    result = loaded(tmp_path, f"family: probe\nvalue: {text}\n")["value"]
    assert result == value
    assert type(result) is type(value)


def test_keys_are_always_text(tmp_path: Path) -> None:
    result = loaded(tmp_path, "family: probe\nkeys: {255: a, -10000: b, on: c, 2.50: d, null: e}\n")
    assert list(result["keys"]) == ["255", "-10000", "on", "2.50", "null"]


def test_positions_count_from_one(tmp_path: Path) -> None:
    text = "family: probe\nouter:\n  inner: [1, {a: 2}]\n"
    outer = loaded(tmp_path, text)["outer"]
    assert str(outer.position) == "spec/probe.yaml:3:3"
    assert str(outer.at("inner")) == "spec/probe.yaml:3:3"
    assert str(outer.at("nothing")) == "spec/probe.yaml:3:3"
    inner = outer["inner"]
    assert isinstance(inner, List)
    assert [str(at) for at in inner.items_at] == ["spec/probe.yaml:3:11", "spec/probe.yaml:3:14"]
    assert str(inner[1].at("a")) == "spec/probe.yaml:3:15"


def test_folded_text_is_kept_as_text(tmp_path: Path) -> None:
    text = "family: probe\nsummary: >-\n  010 of\n  20\n"
    assert loaded(tmp_path, text)["summary"] == "010 of 20"


def test_entries_come_in_the_order_of_families_and_files(tmp_path: Path) -> None:
    text = "family: probe\nstructs: {Zebra: {fields: []}, Ant: {fields: []}}\n"
    spec = load(write_spec(tmp_path, text), Diagnostics())
    names = [(family, name, str(at)) for family, name, _, at in spec.entries("structs")]
    assert names == [
        ("base", "Pair", "spec/base.yaml:33:3"),
        ("probe", "Zebra", "spec/probe.yaml:2:11"),
        ("probe", "Ant", "spec/probe.yaml:2:32"),
    ]


def test_every_file_that_was_read_is_known(tmp_path: Path) -> None:
    folder = write_spec(tmp_path)
    spec = load(folder, Diagnostics())
    assert sorted(spec.files) == sorted(folder.glob("*.yaml"))
