"""Renders the templates and writes what has changed.

A template's path says where its output goes: `templates/<target>/a/@family@.hpp.j2` makes
`generated/a/<family>.hpp` for each family. Adding a target is adding templates. Files that end in
.jinja are for templates to import; any other that does not end in .j2 is copied as it is.

The target `site` has a folder of its own (see site.py), which is not committed.
"""

from __future__ import annotations

import errno
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, Optional

import jinja2

from sbgcgen import docs_model, markdown_text, seeds, vectors
from sbgcgen.export import export
from sbgcgen.filters import FILTERS, TESTS
from sbgcgen.model import Layout
from sbgcgen.names import slug

TEMPLATES = Path(__file__).resolve().parent.parent / "templates"
DOCS = "docs"
SITE = "site"

Items = list[tuple[str, Any]]  # what stands in the path, and what the template gets to see
# What @family@ and the like in a path stand for.
_EACH: dict[str, Callable[[Layout], Items]] = {
    "family": lambda layout: [(f.name, f) for f in layout.families if f.messages or f.structs],
    "message": lambda layout: [(slug(m.name), m) for m in layout.definitions],
    "enum": lambda layout: [(slug(e.name), e) for e in layout.enums],
    "packed": lambda layout: [(slug(p.name), p) for p in layout.packed],
    "unit": lambda layout: [(slug(q.name), q) for q in layout.quantities],
}


def inputs() -> list[Path]:
    """Every file of the generator that its output depends on."""
    here = Path(__file__).resolve().parent
    files = [*here.rglob("*.py"), *(here.parent / "schema").glob("*.json")]
    return files + [path for path in TEMPLATES.rglob("*") if path.is_file()]


def _fail(message: str) -> None:
    raise ValueError(message)


@cache
def _environment(target: str, templates: Path) -> jinja2.Environment:
    """The environment of a target, with its templates once they are compiled."""
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(templates),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=lambda name: (name or "").endswith((".html.j2", ".html.jinja")),
        extensions=["jinja2.ext.do", "jinja2.ext.loopcontrols"],
    )
    environment.filters.update({**FILTERS, **markdown_text.FILTERS})
    environment.tests.update(TESTS)
    environment.globals["fail"] = _fail
    return environment


def outputs(layout: Layout) -> dict[str, bytes]:
    """All output files by their path below generated/."""
    files = {**dict(vectors.files(layout)), **dict(seeds.files(layout))}
    for target in sorted(path.name for path in TEMPLATES.iterdir() if path.name != SITE):
        names = docs_model.names(layout) if target == DOCS else None
        files.update(render(target, layout, names=names))
    return files


def render(
    target: str,
    layout: Layout,
    each: Optional[Mapping[str, Items]] = None,
    names: Optional[Mapping[str, Any]] = None,
    filters: Optional[Mapping[str, Callable[..., Any]]] = None,
) -> Iterator[tuple[str, bytes]]:
    """The output files of one target.

    `each` has more of what may stand between @ and @ in a path, `names` more of what all templates
    see, `filters` more of what they may do. Each template sees `here`, the path of its output, and
    `root`, the way from there up.
    """
    environment = _environment(target, TEMPLATES)
    environment.globals.update(layout=layout, model=export(layout), **(names or {}))
    environment.filters.update(filters or {})
    sources = sources_of(target)
    for path, output, values in expand(sources, layout, each or {}):
        if path.suffix == ".j2":
            template = environment.get_template(path.relative_to(TEMPLATES).as_posix())
            text = template.render(here=output, root="../" * output.count("/"), **values)
            yield output, text.encode()
        else:
            yield output, path.read_bytes()


def sources_of(target: str) -> dict[str, Path]:
    """The files of a target that have an output, by its path (as yet with @family@ and the like)."""
    folder = TEMPLATES / target
    return {
        path.relative_to(folder).as_posix().removesuffix(".j2"): path
        for path in sorted(folder.rglob("*"))
        if path.is_file() and path.suffix != ".jinja"
    }


def expand(
    sources: Mapping[str, Path], layout: Layout, each: Mapping[str, Items]
) -> Iterator[tuple[Path, str, dict[str, Any]]]:
    """Each source with the paths of its outputs, and what its template gets to see for each."""
    for output, path in sources.items():
        placeholder = re.search(r"@(\w+)@", output)
        if placeholder is None:
            yield path, output, {}
            continue
        name = placeholder[1]
        for word, item in each[name] if name in each else _EACH[name](layout):
            yield path, output.replace(placeholder[0], word), {name: item}


@dataclass(frozen=True)
class Output:
    """The content that a folder should have."""

    folder: Path
    files: dict[str, bytes]
    # A file that every such output has; without it, a folder is not ours to clean.
    mark: str = "simplebgc.json"

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
        if stale and not (self.folder / self.mark).is_file():
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
