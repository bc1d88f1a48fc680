"""Targets: the kinds of output that are generated from the protocol.

A target is a subfolder, which is found by listing this folder; nothing else refers to it. It has

- `templates/`: the path of a template determines the path of its output and the objects that it is
  rendered for (see render.py);
- `target.py`, if templates are not sufficient: one class derived from `Target` that overrides the
  necessary members.

Targets do not import each other. Facts that several of them show come from `views/`. Facts that only one
of them knows, such as the code of an example in its language, are requested from all of them (see
`codes_of`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
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

Items = list[tuple[str, Any]]  # the text in the path, and the value for the template


@dataclass(frozen=True)
class View:
    """Names, filters and tests for the templates of a target, besides the Layout and its export.

    `each` has the placeholders that a path may have between @ and @, with their items.
    """

    names: Mapping[str, Any] = field(default_factory=dict)
    filters: Mapping[str, Callable[..., Any]] = field(default_factory=dict)
    tests: Mapping[str, Callable[..., bool]] = field(default_factory=dict)
    each: Mapping[str, Items] = field(default_factory=dict)


@dataclass(frozen=True)
class Code:
    """An example in the language of a target: its source, and the lines that it prints."""

    language: str  # as a name: C++ codec
    word: str  # for markup: cpp
    text: str
    output: tuple[str, ...] = ()


@dataclass(frozen=True)
class Documented:
    """A public name of a library: its signature, and its documentation.

    `kind` is a word: class, function, attribute. `text` has paragraphs between empty lines; indented
    ones are code.
    """

    kind: str
    name: str
    signature: str
    text: str
    members: tuple[Documented, ...] = ()

    @property
    def summary(self) -> str:
        """The first sentence."""
        return " ".join(self.text.split("\n\n")[0].split())


@dataclass(frozen=True)
class Reference:
    """The reference of a library, module by module.

    `source` is the folder of the library in the project, `messages` the module with the messages.
    """

    language: str
    word: str
    source: str
    messages: str
    parts: tuple[Documented, ...]

    @property
    def page(self) -> str:
        return f"reference/{self.word}.html"


class Target:
    """The interface of a target to the generator."""

    # True if its output is part of generated/. Otherwise `sbgcgen <command>` writes it to
    # build/<command>/; the command is its name with hyphens.
    committed = True
    help = ""
    # If not committed: a file that every output contains. A folder without it is not cleaned.
    mark = ""
    # If not committed: its only output, which the command writes as a file, to build/<file>.
    file = ""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    @property
    def name(self) -> str:
        return self.folder.name

    @property
    def command(self) -> str:
        return self.name.replace("_", "-")

    @property
    def templates(self) -> Path:
        return self.folder / "templates"

    def view(self, layout: Layout, project: Path) -> View:
        """The view of its templates; `project` is the root folder of the project."""
        return View()

    def files(self, layout: Layout, project: Path) -> Iterator[tuple[str, bytes]]:
        """Its output files by path; by default, those of its templates."""
        from sbgcgen.targets.render import render

        return render(self, layout, project)

    def lint(self, spec: Spec, layout: Layout, found: Diagnostics) -> None:
        """Check its own rules, such as reserved words of its language; findings go into `found`."""

    def examples(self, example: Example) -> Sequence[Code]:
        """Codes in its language that send, encode or decode a message; none without a language."""
        return ()

    def conversion(self, quantity: Quantity) -> Optional[Code]:
        """Code in its language that converts a number to a quantity and back; None without one."""
        return None

    def record(self, layout: Layout, project: Path, version: str) -> None:
        """Record the names that the release of this version shows."""

    def reference(self, project: Path) -> Optional[Reference]:
        """The reference of the library in its language; None without one."""
        return None


@cache
def targets() -> tuple[Target, ...]:
    """All targets, sorted by name."""
    folders = sorted(p for p in HERE.iterdir() if p.is_dir() and not p.name.startswith("_"))
    return tuple(target for folder in folders if (target := _load(folder)) is not None)


def target(name: str) -> Target:
    return next(t for t in targets() if t.name == name)


def _load(folder: Path) -> Optional[Target]:
    """None for a folder with only leftovers of a deleted target, such as caches."""
    if not (folder / "target.py").is_file():
        return Target(folder) if (folder / "templates").is_dir() else None
    module = import_module(f"{__name__}.{folder.name}.target")
    classes = [c for c in vars(module).values() if isinstance(c, type) and issubclass(c, Target)]
    (found,) = (c for c in classes if c.__module__ == module.__name__)
    return found(folder)


def outputs(layout: Layout, project: Path) -> dict[str, bytes]:
    """All files of generated/ by path."""
    committed = (t for t in targets() if t.committed)
    return {path: content for t in committed for path, content in t.files(layout, project)}


def codes_of(example: Example) -> list[Code]:
    """The codes of an example in the languages of all targets."""
    return [code for t in targets() for code in t.examples(example)]


def references_of(project: Path) -> list[Reference]:
    """The references of the libraries in the languages of all targets."""
    return [found for t in targets() if (found := t.reference(project)) is not None]


def conversions_of(quantity: Quantity) -> list[Code]:
    """The code that converts a quantity in the language of every target that has one."""
    return [code for t in targets() if (code := t.conversion(quantity)) is not None]
