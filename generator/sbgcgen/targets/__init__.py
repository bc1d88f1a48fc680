"""Targets: what is made of the protocol.

A target is a folder in here, found by being there; nothing outside it names it. It has

- `templates/`: the path of a template says where its output goes, and what it is rendered for (see
  render.py);
- `target.py`, if templates alone do not do: one class derived from `Target`, which overrides what it
  needs.

Targets do not import each other. What several of them show comes from `views/`, and what only one of
them can say (how its language writes an example) is asked of all of them: `codes_of`.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any, Optional

from sbgcgen.model import Layout, Quantity
from sbgcgen.oracle.example import Example
from sbgcgen.spec.diagnostics import Diagnostics
from sbgcgen.spec.load import Spec

HERE = Path(__file__).resolve().parent

Items = list[tuple[str, Any]]  # the text in the path, and the value that the template sees


@dataclass(frozen=True)
class View:
    """What the templates of a target see and may do beyond the Layout and its export.

    `each` has what may stand between @ and @ in a path.
    """

    names: Mapping[str, Any] = field(default_factory=dict)
    filters: Mapping[str, Callable[..., Any]] = field(default_factory=dict)
    tests: Mapping[str, Callable[..., bool]] = field(default_factory=dict)
    each: Mapping[str, Items] = field(default_factory=dict)


@dataclass(frozen=True)
class Code:
    """An example in the language of a target: its lines, and the lines that it prints."""

    language: str  # for people: C++
    word: str  # for markup: cpp
    text: str
    output: tuple[str, ...] = ()


class Target:
    """What the generator asks of a target."""

    # Whether its output is part of generated/. If not, `sbgcgen <name>` writes it to build/<name>/.
    committed = True
    help = ""
    # Of what is not committed, a file that every output has: a folder without it is not ours to clean.
    mark = ""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    @property
    def name(self) -> str:
        return self.folder.name

    @property
    def templates(self) -> Path:
        return self.folder / "templates"

    def view(self, layout: Layout, project: Path) -> View:
        """What its templates see; `project` is the folder that has spec/, docs/ and all else."""
        return View()

    def files(self, layout: Layout, project: Path) -> Iterator[tuple[str, bytes]]:
        """Its output files by their path: those of its templates, if it has no other ways."""
        from sbgcgen.targets.render import render

        return render(self, layout, project)

    def lint(self, spec: Spec, layout: Layout, found: Diagnostics) -> None:
        """Its own rules, such as names of the protocol that its language reserves."""

    def example(self, example: Example) -> Optional[Code]:
        """How its language encodes or decodes a message."""
        return None

    def conversion(self, quantity: Quantity) -> Optional[Code]:
        """How its language makes a quantity of a number, and a number of it."""
        return None


@cache
def targets() -> tuple[Target, ...]:
    """All targets, in the order of their names."""
    folders = sorted(p for p in HERE.iterdir() if p.is_dir() and not p.name.startswith("_"))
    return tuple(_load(folder) for folder in folders if _is_target(folder))


def target(name: str) -> Target:
    """The target in the folder `name`."""
    return next(t for t in targets() if t.name == name)


def _is_target(folder: Path) -> bool:
    """A folder that only has the remains of an earlier version is none."""
    return (folder / "target.py").is_file() or (folder / "templates").is_dir()


def _load(folder: Path) -> Target:
    if not (folder / "target.py").is_file():
        return Target(folder)
    module = import_module(f"{__name__}.{folder.name}.target")
    (found,) = (
        thing
        for _, thing in inspect.getmembers(module, inspect.isclass)
        if issubclass(thing, Target) and thing.__module__ == module.__name__
    )
    made: Target = found(folder)
    return made


def outputs(layout: Layout, project: Path) -> dict[str, bytes]:
    """All files of generated/ by their path."""
    committed = (t for t in targets() if t.committed)
    return {path: content for t in committed for path, content in t.files(layout, project)}


def codes_of(example: Example) -> list[Code]:
    """An example in the language of every target that has one."""
    return [code for t in targets() if (code := t.example(example)) is not None]


def conversions_of(quantity: Quantity) -> list[Code]:
    """How every target that has a language converts a quantity."""
    return [code for t in targets() if (code := t.conversion(quantity)) is not None]
