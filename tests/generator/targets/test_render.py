"""Tests of template rendering: the path of the output, and the names visible to the template."""

from __future__ import annotations

from pathlib import Path

import pytest

from sbgcgen.model import Layout
from sbgcgen.targets import Target, View
from sbgcgen.targets.render import expand, render
from support import BASE, layout_of


class Toy(Target):
    """A target with its own names."""

    def view(self, layout: Layout, project: Path) -> View:
        things = [("x", 1), ("y", 2)]
        return View(
            names={"more": "!", "x": "a < b"},
            filters={"twice": lambda text: text * 2},
            tests={"short": lambda text: len(text) < 2},
            each={"thing": list(things)},
        )


def made(folder: Path, files: dict[str, str]) -> dict[str, bytes]:
    """Returns the output of a target with these templates."""
    for name, text in files.items():
        path = folder / "toy" / "templates" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return dict(render(Toy(folder / "toy"), layout_of(folder, BASE), folder))


def test_paths_name_what_they_are_rendered_for(tmp_path: Path) -> None:
    files = {
        "a/@message@.txt.j2": "{{ root }}{{ here }} {{ message.id }}\n",
        "@thing@.md.j2": "{{ thing }}{{ more | twice }}{{ more is short }}\n",
        "plain.bin": "{{ as it is }}",
        "part.jinja": "imported",
        "whole.txt.j2": '{% include "toy/part.jinja" %}',
    }
    found = made(tmp_path, files)
    assert found.pop("a/probe.txt") == b"../a/probe.txt 9\n"
    assert {k: v for k, v in found.items() if not k.startswith("a/")} == {
        "x.md": b"1!!True\n",
        "y.md": b"2!!True\n",
        "plain.bin": b"{{ as it is }}",
        "whole.txt": b"imported",
    }


def test_unknown_word_in_a_path_fails(tmp_path: Path) -> None:
    layout = layout_of(tmp_path, BASE)
    with pytest.raises(KeyError, match="nothing"):
        list(expand({"@nothing@.txt": tmp_path}, layout, {}))


def test_only_html_is_escaped(tmp_path: Path) -> None:
    found = made(tmp_path, {"a.html.j2": "{{ x }}", "a.hpp.j2": "{{ x }}"})
    assert found == {"a.html": b"a &lt; b", "a.hpp": b"a < b"}
