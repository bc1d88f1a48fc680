"""The C++ reference has every public name with a sentence about it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from sbgcgen.model import Layout
from sbgcgen.targets.site.headers import Header, Item, headers_of

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


def functions(header: Header) -> Iterator[tuple[str, Item]]:
    for item in header.items:
        yield from (
            (f"{header.include}: {i.name}", i)
            for i in (item, *item.members)
            if i.kind == "function"
        )


def test_each_function_of_the_client_has_a_sentence_and_its_errors(
    headers: dict[str, Header]
) -> None:
    found = {
        name: item
        for include, header in headers.items()
        if include.startswith("sbgc/client/")
        for name, item in functions(header)
    }
    assert len(found) > 150
    assert [name for name, item in found.items() if not item.text] == []
    # They pass on what others return.
    passes_on = r"replied|reply|end_of_wait|await_\w+|WriteReport"
    silent = [
        name
        for name, item in found.items()
        if re.search(r"Result<|^WriteReport |<WriteReport>|Token&& token", item.code.striptags())
        and not re.fullmatch(passes_on, item.name)
        and "<strong>Errors</strong>" not in item.text
    ]
    assert silent == []


def test_the_errors_of_a_function_are_links(headers: dict[str, Header]) -> None:
    items = {item.name: item for item in headers["sbgc/client/motion.hpp"].items}
    assert (
        '<a href="ROOT/headers/error.html#ErrorCode.interrupted">interrupted</a>'
        in items["move_to"].text
    )
    linked = [
        item
        for header in headers.values()
        for item in header.items
        if "ROOT/headers/error" in item.text
    ]
    assert len(linked) > 20


def test_a_comment_behind_a_member_ends_with_its_line(headers: dict[str, Header]) -> None:
    (options,) = (i for i in headers["sbgc/client/parameters.hpp"].items if i.name == "ReadOptions")
    texts = {member.name: member.text.striptags() for member in options.members}
    assert texts["wanted"].startswith("Returns true for the parameters to read")
    assert "Returns true" not in texts["progress"]


def test_names_tell_the_release_that_brought_them(headers: dict[str, Header]) -> None:
    (client,) = (item for item in headers["sbgc/client/client.hpp"].items if item.name == "Client")
    since = {member.name: member.since for member in client.members}
    assert client.since == since["call"] == "0.1.0"
    releases = re.findall(
        r"^## \[(.*)\]", (PROJECT / "CHANGELOG.md").read_text("utf-8"), re.MULTILINE
    )
    assert {item.since for header in headers.values() for item in header.items} <= {"", *releases}
