"""The C++ reference has every public name with a sentence about it."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from sbgcgen.model import Layout
from sbgcgen.targets.site.headers import Header, headers_of

PROJECT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def headers(layout: Layout) -> dict[str, Header]:
    return {header.include: header for header in headers_of(PROJECT, layout)}


def test_each_header_that_a_guide_names_has_a_page(headers: dict[str, Header]) -> None:
    guides = "".join(path.read_text("utf-8") for path in (PROJECT / "docs").glob("*.md"))
    named = {
        name
        for name in re.findall(r"`(sbgc/[\w/]+\.hpp)`", guides)
        if not (PROJECT / "generated/include" / name).is_file()
    }
    assert len(named) > 20
    assert named - set(headers) == set()


def test_each_name_has_a_sentence(headers: dict[str, Header]) -> None:
    bare = [header.include for header in headers.values() if not header.sentence]
    bare += [
        f"{header.include}: {item.name}"
        for header in headers.values()
        for item in header.items
        if not item.text
    ]
    assert bare == []


def test_the_names_in_the_table_of_headers_are_there(headers: dict[str, Header]) -> None:
    guide = (PROJECT / "docs/11-library.md").read_text(encoding="utf-8")
    table = re.findall(r"^\| `(sbgc/[\w/]+\.hpp)`.*?\| (.*) \|$", guide, re.MULTILINE)
    known = {item.name for header in headers.values() for item in header.items}
    named = {
        name
        for _, content in table
        for name in re.findall(r"`(?:sbgc::)?([A-Za-z]\w*)(?:\(|<|`)", content)
        if "_" in name or name[0].isupper()
    }
    assert len(named) > 15
    generated = {"Angle14", "Voltage", "response_policy"}
    assert named - known - generated == set()
