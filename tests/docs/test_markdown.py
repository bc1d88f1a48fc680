"""generated/docs/ documents every fact of the model in the right place, and its links are valid."""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Mapping
from functools import cache
from pathlib import Path

import pytest
from facts import Fact, all_facts, kind_of, missing, one_of_each_kind, shapes_of
from markdown_pages import MarkdownPages, plain
from spec_maker import write_spec

from sbgcgen.build import load_protocol
from sbgcgen.oracle.example import example_of
from sbgcgen.targets import codes_of, target
from sbgcgen.targets.docs.markdown_text import anchor, escape

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "generated/docs"
LAYOUT = load_protocol(ROOT / "spec").layout
FACTS = list(all_facts(LAYOUT))
MODEL = json.loads((ROOT / "generated/simplebgc.json").read_text(encoding="utf-8"))


def files() -> dict[str, str]:
    """Returns all pages by their path in generated/docs/."""
    return {
        path.relative_to(DOCS).as_posix(): path.read_text(encoding="utf-8")
        for path in sorted(DOCS.rglob("*.md"))
    }


FILES = files()


def test_every_fact_stands_where_it_belongs() -> None:
    counts = Counter(fact.kind for fact in FACTS)
    print(f"{len(FACTS)} facts:", ", ".join(f"{n} {kind}" for kind, n in sorted(counts.items())))
    absent = missing(FACTS, MarkdownPages(FILES))
    assert not absent, absent[:20]


def test_no_fact_of_the_exported_model_is_left_out_of_the_count() -> None:
    """The facts come from the Layout; the exported model must contain the same number."""
    counts = Counter(fact.kind for fact in FACTS)
    leaves = [
        leaf
        for message in MODEL["messages"]
        for outer in message["layout"]
        for leaf in (outer, *outer.get("cases", ()))
    ]
    enums = MODEL["enums"]
    assert counts["message"] == len(MODEL["messages"])
    assert counts["field"] == len(leaves)
    assert counts["field offset"] == sum(leaf["offset"] is not None for leaf in leaves)
    assert counts["field special meaning"] == sum(len(leaf.get("special", ())) for leaf in leaves)
    assert counts["field range"] == sum(
        leaf[limit] is not None for leaf in leaves for limit in ("min", "max")
    )
    assert counts["field unit"] == sum(bool(leaf["unit"]) for leaf in leaves)
    assert counts["field errata"] == sum(len(leaf.get("errata", ())) for leaf in leaves)
    assert counts["field since"] == sum(len(leaf.get("since", ())) for leaf in leaves)
    assert counts["enum"] == len(enums)
    assert counts["value"] == sum(len(enum["values"]) for enum in enums)
    assert counts["packed"] == len(MODEL["packed"])
    assert counts["part"] == sum(len(packed["parts"]) for packed in MODEL["packed"])
    assert counts["unit"] == len(MODEL["quantities"])
    assert counts["variable"] == len(MODEL["adjustable_variables"])
    assert counts["erratum"] == len(MODEL["errata"])
    assert counts["command"] == len(MODEL["commands"])


@pytest.mark.parametrize("fact", one_of_each_kind(FACTS), ids=kind_of)
def test_a_fact_that_is_taken_out_is_missed(fact: Fact) -> None:
    assert missing([fact], MarkdownPages(FILES)) == []
    assert missing([fact], MarkdownPages(without(fact, FILES))) == [fact]


def without(fact: Fact, pages: Mapping[str, str]) -> dict[str, str]:
    """Returns the pages with the fact's text or number removed everywhere."""
    pattern = shapes_of(fact)
    if isinstance(fact.wanted, str):  # in Markdown notation
        pattern = re.compile(f"{re.escape(escape(fact.wanted))}|{pattern.pattern}", re.IGNORECASE)
    return {name: pattern.sub("", text) for name, text in pages.items()}


@pytest.mark.parametrize("seed", range(1, 4))
def test_any_other_protocol_is_told_as_well(seed: int, tmp_path: Path) -> None:
    """Random protocols use all features of the spec language; this one does not."""
    write_spec(tmp_path, seed, 8)
    layout = load_protocol(tmp_path).layout
    made = target("docs").files(layout, tmp_path)
    pages = {name.removeprefix("docs/"): data.decode() for name, data in made}
    facts = list(all_facts(layout))
    assert len(facts) > 500
    absent = missing(facts, MarkdownPages(pages))
    assert not absent, absent[:20]


# ---- links ----


@cache
def anchors(page: str) -> list[str]:
    """Returns the anchors of a page as a code host derives them from the headings."""
    page = re.sub(r"```.*?```", "", page, flags=re.DOTALL)
    return [anchor(plain(title)) for title in re.findall(r"^#+ (.+)$", page, re.MULTILINE)]


def test_every_example_stands_there_as_the_code_of_the_site() -> None:
    for message in LAYOUT.messages:
        example = example_of(message, LAYOUT)
        (code,) = codes_of(example)
        page = FILES[f"messages/{message.family}.md"]
        assert not example.fields or f"```cpp\n{code.text}\n```" in page, message.name


@pytest.mark.parametrize("name", FILES)
def test_links_lead_somewhere(name: str) -> None:
    links = re.findall(r"\]\(([^)]+)\)", re.sub(r"```.*?```", "", FILES[name], flags=re.DOTALL))
    assert links
    for link in links:
        target, _, where = link.partition("#")
        path = (DOCS / name).parent / target if target else DOCS / name
        assert path.is_file(), link
        if where:
            page = FILES[path.resolve().relative_to(DOCS).as_posix()]
            assert where in anchors(page), link


@pytest.mark.parametrize("name", FILES)
def test_no_anchor_stands_for_two_headings(name: str) -> None:
    found = anchors(FILES[name])
    assert len(found) == len(set(found))


@pytest.mark.parametrize("name", FILES)
def test_nothing_unresolved_is_left(name: str) -> None:
    for wrong in ("None", "Undefined", "{{", "{%", "object at 0x"):
        assert wrong not in FILES[name].replace("| None", ""), wrong


def test_no_time_for_what_the_library_does_not_wait_for() -> None:
    rows = [r for page in FILES.values() for r in re.findall(r"^\| Response \|.*$", page, re.M)]
    cases = [case for row in rows for case in row.split("<br>")]
    possibly = [
        case for case in cases if "possibly" in case and "](" not in case.partition("possibly")[0]
    ]
    assert len(possibly) > 5
    for case in possibly:
        assert "does not wait for it" in case and " ms" not in case, case


@pytest.mark.parametrize("name", FILES)
def test_one_byte_is_singular(name: str) -> None:
    assert not re.search(r"(?<![0-9])1 bytes", FILES[name])


def test_one_byte_is_singular_in_headers() -> None:
    for path in (ROOT / "generated/include").rglob("*.hpp"):
        assert not re.search(r"(?<![0-9])1 bytes", path.read_text(encoding="utf-8")), path
