"""Checks of every page: links, anchors, search, versions, and no external resources. axe-core in tests/site
judges structure and names. The pages of random specs support all of the spec language, of which one protocol
uses a part."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import replace
from pathlib import Path
from urllib.parse import urljoin

import pytest

from facts import all_facts, missing
from html_pages import HtmlPages
from pages import Page, read, search_index
from sbgcgen.build import load_protocol
from sbgcgen.model import Layout
from sbgcgen.targets import target
from sbgcgen.targets.site.uses import page_of
from sbgcgen.views.words import versions
from spec_maker import write_spec

Pages = dict[str, Page]
Files = dict[str, bytes]


def test_there_is_a_page_for_everything(pages: Pages, layout: Layout) -> None:
    things = [layout.definitions, layout.enums, layout.packed, layout.quantities]
    assert len([p for p in pages if p.startswith("messages/")]) == len(things[0])
    assert len([p for p in pages if p.startswith("enums/")]) == len(things[1])
    assert len([p for p in pages if p.startswith("packed/")]) == len(things[2])
    assert len([p for p in pages if p.startswith("units/")]) == len(things[3])


def test_each_guide_has_a_page_and_each_page_a_title_and_a_description(pages: Pages) -> None:
    docs = Path(__file__).resolve().parents[2] / "docs"
    assert len([p for p in pages if p.startswith("guides/")]) == len(list(docs.glob("*.md")))
    titles = [page.root.all("head")[0].all("title")[0].text for page in pages.values()]
    assert all(titles) and len(set(titles)) == len(titles)
    for page in pages.values():
        metas = {m.get("name"): m.get("content") for m in page.root.all("meta")}
        assert metas["description"].strip(), page.path


# Compiled, not rendered; ./dev docs copies it into the site.
BUILT = {"assets/messages-module.js"}


def test_ids_are_unique(pages: Pages) -> None:
    for page in pages.values():
        twice = {name for name, count in Counter(page.ids).items() if count > 1}
        assert not twice, f"{page.path}: {twice}"
        assert "" not in page.ids and not any(re.search(r"\s", i) for i in page.ids), page.path


def test_every_link_and_anchor_is_there(pages: Pages, files: Files) -> None:
    anchors = {path: set(page.ids) for path, page in pages.items()}
    for page in pages.values():
        for target, fragment in page.links:
            assert target in files, f"{page.path}: {target}"
            if target == "decoder.html" and fragment.startswith("hex="):  # the frame to decode
                assert bytes.fromhex(fragment.removeprefix("hex=").partition("&")[0])
            elif fragment:
                assert fragment in anchors[target], f"{page.path}: {target}#{fragment}"


def test_references_to_ids_are_there(pages: Pages) -> None:
    names = ("aria-labelledby", "aria-controls", "aria-describedby", "for")
    for page in pages.values():
        ids = set(page.ids)
        for element in page.root.all():
            for name in names:
                for word in element.get(name).split():
                    assert word in ids, f"{page.path}: {name}={word}"
            if "data-row" in element.attributes:
                assert element.get("data-row") in ids, f"{page.path}: {element.get('data-row')}"


def test_nothing_is_loaded_from_elsewhere(pages: Pages, files: Files) -> None:
    for page in pages.values():
        for element in page.root.all():
            for name in ("src", "srcset", "href", "data", "action", "poster"):
                value = element.get(name)
                if not value or (name == "href" and element.tag == "a"):
                    continue
                assert not re.match(r"[a-z]+:|//|/", value), f"{page.path}: {value}"
                assert urljoin(page.path, value) in {*files, *BUILT}, f"{page.path}: {value}"
            assert not any(name.startswith("on") for name in element.attributes), page.path
            assert element.tag not in ("iframe", "object", "embed"), page.path
    for path, content in files.items():
        if path.endswith(".css"):
            assert not re.search(rb"@import|url\(", content), path
        if path.endswith(".js"):
            assert not re.search(rb"https?://", content.replace(b"http://www.w3.org", b"")), path


def test_links_work_from_a_folder(pages: Pages) -> None:
    """On file:// URLs, a link must name a file, relative to its page."""
    for page in pages.values():
        for element in page.root.all("a"):
            href = element.get("href")
            assert href and not href.startswith("/"), f"{page.path}: {href!r}"
            assert not href.partition("#")[0].endswith("/"), f"{page.path}: {href}"


def test_pages_of_requests_with_directed_fields_draw_the_axes(pages: Pages, layout: Layout) -> None:
    directed = [m for m in layout.messages if m.effect and any(v.direction for v in m.leaves)]
    drawings = {page.path: page.root.with_class("axes-drawing") for page in pages.values()}
    expected = {page_of(message) for message in directed} | {"units.html"}
    assert {path for path, found in drawings.items() if found} == expected
    for (drawing,) in filter(None, drawings.values()):
        assert {drawing.get("role"), *(e.get("id") for e in drawing.all("title", "desc"))} == {
            "img",
            "axes-title",
            "axes-desc",
        }
        for words in ("+ down", "+ right", "not known"):
            assert words in drawing.text


def test_pages_tell_no_time_for_what_the_library_does_not_wait_for(
    pages: Pages, layout: Layout
) -> None:
    unsure = [
        message
        for message in layout.messages
        if message.answer
        and all(
            not c.messages and c.confirm in ("possible", "unlikely") for c in message.answer.cases
        )
    ]
    assert len(unsure) > 5
    for message in unsure:
        (answer,) = [e for e in pages[page_of(message)].root.all() if e.get("id") == "answer"]
        assert "does not wait for it" in answer.text, message.name
        assert "The library waits" not in answer.text, message.name


def test_every_leaf_has_a_deep_link(pages: Pages, layout: Layout) -> None:
    for message in layout.messages:
        ids = set(pages[page_of(message)].ids)
        for leaf in message.leaves:
            assert f"field-{leaf.path}" in ids, f"{message.name}: {leaf.path}"
            for case in leaf.cases:
                assert f"field-{case.path}" in ids, f"{message.name}: {case.path}"


def test_every_value_variable_and_erratum_has_a_deep_link(pages: Pages, layout: Layout) -> None:
    for enum in layout.enums:
        ids = pages[page_of(enum)].ids
        assert {value.name for value in enum.values} <= set(ids), enum.name
    assert {v.name for v in layout.variables} <= set(pages["variables.html"].ids)
    assert {e.number for e in layout.errata} <= set(pages["errata.html"].ids)


def test_search_finds_everything_and_leads_to_it(
    pages: Pages, files: Files, layout: Layout
) -> None:
    entries = [e for entry in search_index(files) for e in (entry, *entry.twins)]
    names = {(entry.kind, entry.name) for entry in entries}
    for message in layout.messages:
        assert ("message", message.name) in names
    for command in layout.commands:
        assert ("command", command.name) in names
    for enum in layout.enums:
        for value in enum.values:
            assert ("value", value.name) in names
    assert {("unit", quantity.name) for quantity in layout.quantities} <= names
    assert {("variable", variable.name) for variable in layout.variables} <= names
    assert {e.number for e in layout.errata} == {n for k, n in names if k == "erratum"}
    for entry in entries:
        page, _, fragment = entry.page.partition("#")
        assert page in pages, entry
        assert not fragment or fragment in pages[page].ids, entry


def test_search_knows_every_field_by_both_names(files: Files, layout: Layout) -> None:
    words = {
        word
        for entry in search_index(files)
        if entry.kind == "field"
        for word in (f"{entry.page.partition('#')[0]} {w}" for w in [entry.name, *entry.words])
    }
    by_name = {message.name: message for message in layout.messages}
    for message in layout.messages:
        page = page_of(by_name[message.same_as] if message.same_as else message)
        for leaf in message.leaves:
            if not leaf.field.reserved:
                assert f"{page} {leaf.spec_name}" in words, leaf.path


def test_search_shows_what_reads_and_what_writes_settings_as_one(
    files: Files, layout: Layout
) -> None:
    entries = search_index(files)
    assert len(layout.settings) >= 5
    for settings in layout.settings:
        writers = [message.name for message in settings.writers]
        for kind, name, others in (
            ("message", settings.message.name, writers),
            ("command", settings.message.command, [m.command for m in settings.writers]),
        ):
            (entry,) = [e for e in entries if e.kind == kind and e.name == name]
            assert [twin.name for twin in entry.twins] == others
            assert not [e for e in entries if e.kind == kind and e.name in others]
        paths = [e for e in entries if e.kind == "field" and e.name.partition(".")[0] in writers]
        assert paths == [], "their fields are those of what reads them"


def test_search_knows_versions_and_pages_of_their_own(files: Files, layout: Layout) -> None:
    kinds = "page", "version"
    found = {entry.page: entry for entry in search_index(files) if entry.kind in kinds}
    assert {"framing.html", "decoder.html", "availability.html", "errata.html"} <= set(found)
    for revision in layout.revisions:
        assert [e for e in found.values() if {"rev", revision.number} <= set(e.words)]
    for message in layout.messages:
        if message.since.firmware:
            version = versions(replace(message.since, board=0)).split()[-1]
            assert any(
                page.startswith("firmware/") and page.endswith(f"#{version}") for page in found
            )


def test_each_firmware_has_a_page_of_what_it_brought(pages: Pages, layout: Layout) -> None:
    """Each version is a section of one page, which links everything that has this version."""
    sections = {
        heading.get("id"): (page, heading.parent)
        for page in pages.values()
        if page.path.startswith("firmware/")
        for heading in page.root.all("main")[0].all("h2")
    }
    things = [
        *((m.since, m.name) for m in layout.definitions),
        *((m.until.versions, m.name) for m in layout.definitions if m.until),
        *((c.since, c.name) for c in layout.commands),
        *((v.since, v.name) for v in layout.variables),
        *((v.since, v.name) for e in layout.enums for v in e.values),
        *((v.former.firmware, v.name) for e in layout.enums for v in e.values if v.former),
        *((f.since, f.name) for m in layout.definitions for f in m.fields if not m.same_as),
    ]
    by_firmware = [(since, name) for since, name in things if since.firmware]
    assert len(by_firmware) > 100
    assert set(sections) == {since.firmware_text for since, _ in by_firmware}
    for since, name in by_firmware:
        page, section = sections[since.firmware_text]
        assert section is not None and since.firmware_text.startswith(page.path[9:-5])
        assert name in section.text, f"{since.firmware_text}: {name}"


def test_the_index_of_versions_lists_each_with_a_link(pages: Pages, layout: Layout) -> None:
    links = {f"{page}#{name}" for page, name in pages["availability.html"].links}
    for page in pages.values():
        if page.path.startswith("firmware/"):
            for heading in page.root.all("main")[0].all("h2"):
                assert f"{page.path}#{heading.get('id')}" in links
    for message in layout.messages:
        if message.since.board:
            assert f"board-{message.since.board_text}" in pages["availability.html"].ids


def test_marks_of_versions_lead_to_what_else_the_version_brought(pages: Pages) -> None:
    found = 0
    for page in pages.values():
        for tag in page.root.with_class("tag"):
            if re.match(r"since (firmware|board) ", tag.text):
                (link, *_) = tag.all("a")
                assert re.search(r"firmware/[\d.]+\.html#|#board-", link.get("href")), tag.text
                found += 1
    assert found > 200


def test_what_a_firmware_lacks_is_marked_for_the_choice(pages: Pages, layout: Layout) -> None:
    for enum in layout.enums:
        marked = _marked(pages[page_of(enum)])
        for value in enum.values:
            assert marked.get(value.name, 0) == value.since.firmware, value.name
    marked = _marked(pages["variables.html"])
    for variable in layout.variables:
        assert marked.get(variable.name, 0) == variable.since.firmware, variable.name
    for message in layout.definitions:
        page = pages[page_of(message)]
        marked = _marked(page)
        for field in message.fields:
            since = field.since if field.since.is_after(message.since) else None
            rows = [n for i, n in marked.items() if re.match(rf"field-{field.name}(\W|$)", i)]
            assert not since or since.firmware == 0 or since.firmware in rows, field.name
        notes = [e.get("data-absent-before") for e in page.root.with_class("absent")]
        wanted = [str(message.since.firmware)] if message.since.firmware else []
        assert [note for note in notes if note] == wanted, message.name
    for command in layout.commands:
        marked = _marked(pages[f"families/{command.family}.html"])
        assert marked.get(command.name, 0) == command.since.firmware, command.name


def _marked(page: Page) -> dict[str, int]:
    """Returns the firmware that brought each element with an id, or with something in it."""
    return {
        inner.get("id"): int(element.get("data-since"))
        for element in page.root.all()
        if "data-since" in element.attributes
        for inner in (element, *element.all())
        if "id" in inner.attributes
    }


def test_the_choice_offers_each_firmware(pages: Pages, layout: Layout) -> None:
    (select,) = pages["index.html"].root.all("select")
    offered = [int(o.get("value")) for o in select.all("option") if o.get("value")]
    assert offered == sorted(set(offered))
    named = {m.since.firmware for m in layout.messages} | {
        v.since.firmware for v in layout.variables
    }
    assert named - {0} <= set(offered)
    assert layout.newest_firmware in offered
    releases = {10 * round(100 * (2.43 + 0.01 * i)) for i in range(32)}
    assert releases <= set(offered) and min(offered) == 2430, "2.43, 2.44, ... 2.74"


def test_no_words_of_templates_are_left(files: Files) -> None:
    for path, content in files.items():
        if path.endswith((".html", ".css")) and not path.startswith("source/"):
            text = content.decode()
            # The guide of Python speaks of None.
            words = r"\{\{|\{%|%\}|Fraction\(|Undefined|object at 0x"
            words += "" if path.startswith("guides/") else "|>None<"
            assert not re.search(words, text), path


@pytest.mark.parametrize("seed", range(1, 5))
def test_random_spec(seed: int, tmp_path: Path) -> None:
    write_spec(tmp_path / "spec", seed, 8)
    layout = load_protocol(tmp_path / "spec", allow_slips=True).layout
    files = dict(target("site").files(layout, tmp_path))
    texts = {path: data.decode() for path, data in files.items() if path.endswith(".html")}
    pages = {path: read(path, text) for path, text in texts.items()}
    test_there_is_a_page_for_everything(pages, layout)
    test_ids_are_unique(pages)
    test_every_link_and_anchor_is_there(pages, files)
    test_references_to_ids_are_there(pages)
    test_every_leaf_has_a_deep_link(pages, layout)
    test_search_finds_everything_and_leads_to_it(pages, files, layout)
    # The site names the elements of a list together.
    facts = [f for f in all_facts(layout) if f.kind != "field spec name" or "[" not in f.place.hook]
    assert len(facts) > 500
    absent = missing(facts, HtmlPages(texts, {c.name: c.family for c in layout.commands}))
    assert not absent, absent[:20]
