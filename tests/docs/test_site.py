"""The site documents every fact of the model, on the right page and at the right anchor."""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Mapping
from html import escape, unescape
from pathlib import Path

import pytest
from conftest import LAYOUT
from facts import Fact, all_facts, kind_of, missing, one_of_each_kind, shapes_of
from html_pages import HtmlPages

pytest.importorskip("markdown", reason="the site needs python3-markdown")

ROOT = Path(__file__).resolve().parents[2]
MODEL = json.loads((ROOT / "generated/simplebgc.json").read_text(encoding="utf-8"))
FACTS = list(all_facts(LAYOUT))
_INLINE = re.compile(r"<(a|code|b)\b(?![^>]*\bid=)[^>]*>([^<]*)</\1>")
FAMILIES = {command.name: command.family for command in LAYOUT.commands}


@pytest.fixture(scope="module", name="files")
def texts(files: dict[str, bytes]) -> dict[str, str]:
    """Returns the pages by path."""
    return {name: data.decode() for name, data in files.items() if name.endswith(".html")}


def test_every_fact_is_where_it_belongs(files: dict[str, str]) -> None:
    counts = Counter(fact.kind for fact in FACTS)
    print(f"{len(FACTS)} facts:", ", ".join(f"{n} {kind}" for kind, n in sorted(counts.items())))
    absent = missing(FACTS, HtmlPages(files, FAMILIES))
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


def test_types_have_the_names_of_the_generated_code(files: dict[str, str]) -> None:
    headers = (ROOT / "generated/include").rglob("enums.hpp")
    code = "".join(path.read_text(encoding="utf-8") for path in headers)
    pages = [text for path, text in files.items() if path.startswith(("enums/", "packed/"))]
    shown = [name for text in pages for name in re.findall(r"<code>sbgc::([\w:]+)", text)]
    assert len(shown) >= len(pages) > 50
    for name in shown:
        namespace, _, type_ = name.rpartition("::")
        assert f"namespace sbgc::{namespace} {{" in code, name
        assert re.search(rf"^(enum class|class|using) {type_}\b", code, re.M), name


@pytest.mark.parametrize("fact", one_of_each_kind(FACTS), ids=kind_of)
def test_a_fact_that_is_taken_out_is_missed(fact: Fact, files: dict[str, str]) -> None:
    assert missing([fact], HtmlPages(files, FAMILIES)) == []
    assert missing([fact], HtmlPages(without(fact, files), FAMILIES)) == [fact]


def without(fact: Fact, pages: Mapping[str, str]) -> dict[str, str]:
    """Returns the fact's page with its text or number removed from texts and titles; ids remain."""
    name = HtmlPages(pages, FAMILIES).page_name(fact.place)
    page, count = pages[name].replace("<wbr>", ""), 1
    while count:  # join the parts of texts
        page, count = _INLINE.subn(r"\2", page)
    parts = re.split(r"(<[^>]*>)", page)
    pattern = shapes_of(fact)
    for i, part in enumerate(parts):
        title = re.search(r'(?<= title=")[^"]*', part) if i % 2 else re.match(".*", part, re.S)
        if title:
            rest = escape(pattern.sub("", unescape(title[0])))
            parts[i] = part[: title.start()] + rest + part[title.end() :]
    return {**pages, name: "".join(parts)}
