"""Compiled templates are kept between runs, and never used for another template."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import jinja2
import pytest

import sbgcgen.targets.bytecode as bytecode


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty cache."""
    cache = tmp_path / "cache"
    monkeypatch.setattr(bytecode, "_FOLDER", cache)
    return cache


def render(text: str, compiled: list[str] | None = None) -> str:
    """Renders a template in a new environment, and notes whether it has been compiled."""

    class Environment(jinja2.Environment):
        def _generate(self, *arguments: Any, **options: Any) -> str:
            if compiled is not None:
                compiled.append(text)
            return super()._generate(*arguments, **options)

    loader = jinja2.DictLoader({"a": text})
    return (
        Environment(loader=loader, bytecode_cache=bytecode.BytecodeCache())
        .get_template("a")
        .render()
    )


def test_a_template_is_compiled_once(folder: Path) -> None:
    compiled: list[str] = []
    assert render("{{ 1 + 1 }}", compiled) == render("{{ 1 + 1 }}", compiled) == "2"
    assert len(compiled) == len(list(folder.iterdir())) == 1


def test_a_changed_template_is_compiled_again(folder: Path) -> None:
    assert (render("old"), render("new"), render("old")) == ("old", "new", "old")


def test_a_changed_generator_compiles_again(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    compiled: list[str] = []
    render("x", compiled)
    monkeypatch.setattr(bytecode, "generator_digest", lambda: "another")
    render("x", compiled)
    assert len(compiled) == 2


@pytest.mark.parametrize("content", [b"", b"\n", b"no checksum", b"\xff\n\xff"])
def test_a_damaged_file_is_ignored(content: bytes, folder: Path) -> None:
    render("x")
    (file,) = folder.iterdir()
    file.write_bytes(content)
    assert render("x") == "x"


def test_truncated_bytecode_is_ignored(folder: Path) -> None:
    render("x")
    (file,) = folder.iterdir()
    file.write_bytes(file.read_bytes()[:-20])
    assert render("x") == "x"


def test_without_a_place_for_the_cache(folder: Path) -> None:
    folder.write_text("a file")
    assert render("x") == "x"
