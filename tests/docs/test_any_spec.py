"""The site of random specs: the pages support all of the spec language, of which one protocol uses a part."""

from __future__ import annotations

from pathlib import Path

import pytest
from facts import all_facts, missing
from html_pages import HtmlPages
from pages import read
from spec_maker import write_spec

import test_pages
from sbgcgen.build import load_protocol
from sbgcgen.targets import target


@pytest.mark.parametrize("seed", range(1, 5))
def test_random_spec(seed: int, tmp_path: Path) -> None:
    write_spec(tmp_path / "spec", seed, 8)
    layout = load_protocol(tmp_path / "spec", allow_slips=True).layout
    files = dict(target("site").files(layout, tmp_path))
    texts = {path: data.decode() for path, data in files.items() if path.endswith(".html")}
    pages = {path: read(path, text) for path, text in texts.items()}
    test_pages.test_there_is_a_page_for_everything(pages, layout)
    test_pages.test_ids_are_unique(pages)
    test_pages.test_every_link_and_anchor_is_there(pages, files)
    test_pages.test_references_to_ids_are_there(pages)
    test_pages.test_every_leaf_has_a_deep_link(pages, layout)
    test_pages.test_search_finds_everything_and_leads_to_it(pages, files, layout)
    # The site names the elements of a list together.
    facts = [f for f in all_facts(layout) if f.kind != "field spec name" or "[" not in f.place.hook]
    assert len(facts) > 500
    absent = missing(facts, HtmlPages(texts, {c.name: c.family for c in layout.commands}))
    assert not absent, absent[:20]
