"""The site documents every fact of the model, on the right page and at the right anchor."""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Mapping
from html import escape, unescape
from os.path import normpath
from pathlib import Path

import pytest
from facts import Fact, all_facts, kind_of, missing, one_of_each_kind, shapes_of
from html_pages import HtmlPages
from spec_maker import write_spec

from sbgcgen.build import load_protocol
from sbgcgen.targets import target

pytest.importorskip("markdown", reason="the site needs python3-markdown")

ROOT = Path(__file__).resolve().parents[2]
MODEL = json.loads((ROOT / "generated/simplebgc.json").read_text(encoding="utf-8"))
LAYOUT = load_protocol(ROOT / "spec").layout
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


@pytest.mark.parametrize("seed", range(1, 4))
def test_every_fact_of_any_other_protocol_too(seed: int, tmp_path: Path) -> None:
    """Random protocols use all features of the spec language; this one does not."""
    write_spec(tmp_path / "spec", seed, 8)
    layout = load_protocol(tmp_path / "spec", allow_slips=True).layout
    made = target("site").files(layout, tmp_path)
    files = {name: data.decode() for name, data in made if name.endswith(".html")}
    # The site names the elements of a list together.
    facts = [f for f in all_facts(layout) if f.kind != "field spec name" or "[" not in f.place.hook]
    assert len(facts) > 500
    absent = missing(facts, HtmlPages(files, {c.name: c.family for c in layout.commands}))
    assert not absent, absent[:20]


def test_guides_link_pages_of_the_site(files: dict[str, str]) -> None:
    guides = {name: text for name, text in files.items() if name.startswith("guides/")}
    assert len(guides) == len(list((ROOT / "docs").glob("*.md")))
    for name, text in guides.items():
        for link in re.findall(r'href="([^"#]+)', page_part(text)):
            path = (Path("/") / Path(name).parent / link).as_posix()
            assert normpath(path).lstrip("/") in files, f"{name}: {link}"


def test_types_have_the_names_of_the_generated_code(files: dict[str, str]) -> None:
    headers = [data.decode() for name, data in target("cpp").files(LAYOUT, ROOT) if "enums" in name]
    code = "".join(headers)
    pages = [text for path, text in files.items() if path.startswith(("enums/", "packed/"))]
    shown = [name for text in pages for name in re.findall(r"<code>sbgc::([\w:]+)", text)]
    assert len(shown) >= len(pages) > 50
    for name in shown:
        namespace, _, type_ = name.rpartition("::")
        assert f"namespace sbgc::{namespace} {{" in code, name
        assert re.search(rf"^(enum class|class|using) {type_}\b", code, re.M), name


def page_part(text: str) -> str:
    """Returns the part that is specific to this page."""
    return text[text.index("<main") : text.index("</main>")]


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
