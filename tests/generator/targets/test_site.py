"""The site for any spec is escaped and reproducible, and cleans up only its own files."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from sbgcgen.build import load_layout
from sbgcgen.cli import main
from sbgcgen.targets import target
from support import BASE, Capture, files_in, layout_of, run_generator, write_spec


def files_of(folder: Path, summary: str = "A number.") -> dict[str, bytes]:
    layout = layout_of(folder, f'        - {{name: A, type: u8, summary: "{summary}"}}\n')
    return dict(target("site").files(layout, folder))


def test_smallest_spec_has_a_site(tmp_path: Path) -> None:
    files = files_of(tmp_path)
    assert {"index.html", "messages/probe.html", "families/probe.html"} <= set(files)
    assert target("site").mark in files
    for path, content in files.items():
        assert content.endswith(b"\n") and b"\r" not in content, path
        assert str(tmp_path).encode() not in content, path


def test_text_of_the_spec_is_never_markup(tmp_path: Path) -> None:
    files = files_of(tmp_path, "<script>alert(1)</script> & {{ x }} <b>")
    page = files["messages/probe.html"].decode()
    assert "&lt;script&gt;alert(1)&lt;/script&gt; &amp; {{ x }} &lt;b&gt;" in page
    assert "<script>" not in page
    assert b"</script>" not in files["assets/search-index.js"]


def test_names_of_commands_and_errata_in_text_are_links(tmp_path: Path) -> None:
    page = files_of(tmp_path, "As CMD_PROBE says; not E999.")["messages/probe.html"].decode()
    assert 'As <a href="../families/probe.html#CMD_PROBE">CMD_PROBE</a> says; not E999.' in page


def test_guides_are_pages(tmp_path: Path) -> None:
    docs = tmp_path / "docs"
    docs.mkdir()
    (docs / "10-second.md").write_text("# Second & last\n\nSee [the first](01-first.md#why).\n")
    (docs / "01-first.md").write_text("# First\n\n## Why\n\n| a | b |\n|---|---|\n| 1 | 2 |\n")
    files = files_of(tmp_path)
    first, second = (files[f"guides/{name}.html"].decode() for name in ("first", "second"))
    assert '<h2 id="why">Why</h2>' in first and "<table>" in first
    assert '<a href="../guides/first.html#why">the first</a>' in second
    start = files["index.html"].decode()
    links = re.findall(r'<li><a href="(guides/[a-z]+\.html)">([^<]+)</a></li>', start)
    assert links[:2] == [
        ("guides/first.html", "First"),
        ("guides/second.html", "Second &amp; last"),
    ]


def test_command_writes_and_cleans(tmp_path: Path, capsys: Capture) -> None:
    write_spec(tmp_path, BASE)
    folder = tmp_path / "build" / "site"
    assert main(["site", "--root", str(tmp_path)]) == 0
    first = re.fullmatch(r"(\d+) files, \1 changed\n", capsys.readouterr().out)
    assert first and (folder / "index.html").is_file()
    (folder / "messages" / "gone.html").write_text("from an earlier spec")
    assert main(["site", "--root", str(tmp_path)]) == 0
    assert capsys.readouterr().out == f"{first[1]} files, 1 changed\n"
    assert not (folder / "messages" / "gone.html").exists()


@pytest.mark.parametrize("name", ["index.html", "simplebgc.json", "thesis.txt"])
def test_folder_with_other_files_is_not_cleaned(tmp_path: Path, name: str, capsys: Capture) -> None:
    """Applies to other people's web pages and to generated/."""
    write_spec(tmp_path, BASE)
    folder = tmp_path / "precious"
    folder.mkdir()
    (folder / name).write_text("years of work")
    (folder / "more.txt").write_text("and more")
    assert main(["site", "--root", str(tmp_path), "--output", str(folder)]) == 1
    assert "it holds other files" in capsys.readouterr().err
    assert (folder / name).read_text() == "years of work"
    assert len(list(folder.iterdir())) == 2


def test_same_bytes_whatever_run_hash_seed_and_locale(tmp_path: Path) -> None:
    write_spec(tmp_path, BASE)
    made = []
    for number, seed in enumerate(("1", "4711")):
        folder = tmp_path / str(number)
        at = ["--root", tmp_path, "--output", folder]
        run_generator("site", *at, PYTHONHASHSEED=seed, LC_ALL="C").check_returncode()
        made.append(files_in(folder))
    assert made[0] == made[1]


def test_site_of_a_protocol_without_requests_that_have_a_body(tmp_path: Path) -> None:
    spec = write_spec(tmp_path)
    base = spec / "base.yaml"
    text, _, rest = base.read_text("utf-8").partition("\n  CMD_USE:")
    assert rest
    base.write_text(text + "\n")
    files = dict(target("site").files(load_layout(spec), tmp_path))
    assert b"3E" in files["framing.html"]
