"""Renders the site of random specs: the pages support every construct of the spec language."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

import test_pages
from conftest import PROJECT
from pages import read

sys.path.insert(0, str(PROJECT / "tests" / "random_schemas"))

from spec_maker import write_spec  # noqa: E402

from sbgcgen.build import load_protocol  # noqa: E402
from sbgcgen.targets import target  # noqa: E402


@pytest.mark.parametrize("seed", range(1, 5))
def test_random_spec(seed: int, tmp_path: Path) -> None:
    write_spec(tmp_path / "spec", seed, 6)
    layout = load_protocol(tmp_path / "spec", allow_slips=True).layout
    files = dict(target("site").files(layout, tmp_path))
    pages = {
        path: read(path, content.decode())
        for path, content in files.items()
        if path.endswith(".html")
    }
    test_pages.test_there_is_a_page_for_everything(pages, layout)
    test_pages.test_ids_are_unique(pages)
    test_pages.test_every_link_and_anchor_is_there(pages, files)
    test_pages.test_references_to_ids_are_there(pages)
    test_pages.test_outline(pages)
    test_pages.test_everything_has_a_name(pages)
    test_pages.test_tables_have_heads(pages)
    test_pages.test_every_leaf_has_a_deep_link(pages, layout)
    test_pages.test_search_finds_everything_and_leads_to_it(pages, files, layout)
