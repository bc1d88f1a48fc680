"""Renders the templates and writes what has changed.

A template's path says where its output goes: `templates/<target>/a/@family@.hpp.j2` makes
`generated/a/<family>.hpp` for each family. Adding a target is adding templates.
"""

from __future__ import annotations

import errno
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import jinja2

from sbgcgen import seeds, vectors
from sbgcgen.export import export
from sbgcgen.filters import FILTERS, TESTS
from sbgcgen.model import Layout

TEMPLATES = Path(__file__).resolve().parent.parent / "templates"
# Every output has it, so a folder without it is not ours to clean.
_MARK = "simplebgc.json"


def inputs() -> list[Path]:
    """Every file of the generator that its output depends on."""
    here = Path(__file__).resolve().parent
    files = [*here.glob("*.py"), *(here.parent / "schema").glob("*.json")]
    return files + [path for path in TEMPLATES.rglob("*") if path.is_file()]


def _fail(message: str) -> None:
    raise ValueError(message)


def _environment() -> jinja2.Environment:
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(TEMPLATES),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
        extensions=["jinja2.ext.do", "jinja2.ext.loopcontrols"],
    )
    environment.filters.update(FILTERS)
    environment.tests.update(TESTS)
    environment.globals["fail"] = _fail
    return environment


def outputs(layout: Layout) -> dict[str, bytes]:
    """All output files by their path below generated/."""
    return {**dict(_render(layout)), **dict(vectors.files(layout)), **dict(seeds.files(layout))}


def _render(layout: Layout) -> Iterator[tuple[str, bytes]]:
    environment = _environment()
    environment.globals.update(layout=layout, model=export(layout))
    for path in sorted(TEMPLATES.rglob("*.j2")):
        name = path.relative_to(TEMPLATES).as_posix()
        template = environment.get_template(name)
        _, _, target = name.removesuffix(".j2").partition("/")
        if "@family@" in target:
            for family in layout.families:
                if family.messages or family.structs:
                    text = template.render(family=family)
                    yield target.replace("@family@", family.name), text.encode()
        else:
            yield target, template.render().encode()


@dataclass(frozen=True)
class Output:
    """The content that a folder should have."""

    folder: Path
    files: dict[str, bytes]

    def _stale(self) -> list[str]:
        if not self.folder.is_dir():
            return []
        there = (
            p.relative_to(self.folder).as_posix() for p in self.folder.rglob("*") if p.is_file()
        )
        return sorted(name for name in there if name not in self.files)

    def drift(self) -> list[str]:
        """One line for each file that differs from what it should be."""
        lines = [f"{name}: not generated from the spec" for name in self._stale()]
        for name, content in sorted(self.files.items()):
            path = self.folder / name
            if not path.is_file():
                lines.append(f"{name}: missing")
            elif path.read_bytes() != content:
                lines.append(f"{name}: differs")
        return lines

    def write(self) -> int:
        """Make the folder so; returns how many files were written or deleted.

        Raises OSError, also if the folder holds something else: files that are not generated are
        deleted, so it must be empty or hold an earlier output.
        """
        stale = self._stale()
        if stale and not (self.folder / _MARK).is_file():
            raise FileExistsError(errno.EEXIST, "it holds other files", str(self.folder))
        changed = 0
        for name, content in self.files.items():
            path = self.folder / name
            if path.is_file() and path.read_bytes() == content:
                continue
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
            changed += 1
        for name in stale:
            path = self.folder / name
            path.unlink()
            changed += 1
            while path.parent != self.folder and not any(path.parent.iterdir()):
                path = path.parent
                path.rmdir()
        return changed
