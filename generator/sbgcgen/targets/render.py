"""Renders the templates of a target.

A template's path determines the path of its output: `templates/a/@family@.hpp.j2` is rendered to `a/<family>.hpp` for
each family. Templates import files that end in .jinja; any other file that does not end in .j2 is copied. Names of
templates begin with that of their target, or with `views`, the package with shared templates: "cpp/macros.jinja",
"views/axes.svg.jinja".
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from functools import cache
from pathlib import Path
from types import CodeType
from typing import Any

import jinja2
from jinja2.bccache import Bucket

from sbgcgen import views
from sbgcgen.model import Layout
from sbgcgen.model.names import slug
from sbgcgen.targets import Items, Target
from sbgcgen.views.words import FILTERS, TESTS

# The objects that placeholders such as @family@ in a path stand for.
_EACH: dict[str, Callable[[Layout], Items]] = {
    "protocol": lambda layout: [(layout.short_name, layout)],
    "family": lambda layout: [(f.name, f) for f in layout.families if f.messages or f.structs],
    "message": lambda layout: [(slug(m.name), m) for m in layout.definitions],
    "enum": lambda layout: [(slug(e.name), e) for e in layout.enums],
    "packed": lambda layout: [(slug(p.name), p) for p in layout.packed],
    "unit": lambda layout: [(slug(q.name), q) for q in layout.quantities],
}


def _fail(message: str) -> None:
    raise ValueError(message)


class _CompiledTemplates(jinja2.BytecodeCache):
    """The code of templates, whose compilation takes longer than running them."""

    def __init__(self) -> None:
        self._code: dict[tuple[str, str], CodeType | None] = {}

    def load_bytecode(self, bucket: Bucket) -> None:
        bucket.code = self._code.get((bucket.key, bucket.checksum))

    def dump_bytecode(self, bucket: Bucket) -> None:
        self._code[bucket.key, bucket.checksum] = bucket.code


@cache
def environment(target: Target) -> jinja2.Environment:
    """The environment of a target; it keeps the code of its templates."""
    loader = jinja2.FileSystemLoader(target.templates)
    shared = jinja2.FileSystemLoader(Path(views.__file__).parent)
    environment = jinja2.Environment(
        loader=jinja2.PrefixLoader({target.name: loader, "views": shared}),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=lambda name: (name or "").endswith((".html.j2", ".html.jinja")),
        bytecode_cache=_CompiledTemplates(),
        extensions=["jinja2.ext.do", "jinja2.ext.loopcontrols"],
    )
    environment.filters.update(FILTERS)
    environment.tests.update(TESTS)
    environment.globals["fail"] = _fail
    return environment


def render(target: Target, layout: Layout, project: Path) -> Iterator[tuple[str, bytes]]:
    """The output files of a target's templates.

    Each template sees `layout`, the names of the target's view, `here` (the path of its output) and `root` (the relative path from there to the root of the output).
    """
    view = target.view(layout, project)
    made = environment(target)
    # Imported templates keep the names that they were loaded with, such as another layout.
    if made.cache is not None:
        made.cache.clear()
    made.globals.update(layout=layout, **view.names)
    made.filters.update(view.filters)
    made.tests.update(view.tests)
    for path, output, values in expand(sources_of(target), layout, view.each):
        if path.suffix == ".j2":
            name = f"{target.name}/{path.relative_to(target.templates).as_posix()}"
            text = made.get_template(name).render(
                here=output, root="../" * output.count("/"), **values
            )
            yield output, text.encode()
        else:
            yield output, path.read_bytes()


def sources_of(target: Target) -> dict[str, Path]:
    """The source files of a target by the path of their output, with unexpanded placeholders."""
    return {
        path.relative_to(target.templates).as_posix().removesuffix(".j2"): path
        for path in sorted(target.templates.rglob("*"))
        if path.is_file() and path.suffix != ".jinja"
    }


def expand(
    sources: Mapping[str, Path], layout: Layout, each: Mapping[str, Items]
) -> Iterator[tuple[Path, str, dict[str, Any]]]:
    """Each source with the path of each of its outputs, and the names for its template."""
    for output, path in sources.items():
        placeholder = re.search(r"@(\w+)@", output)
        if placeholder is None:
            yield path, output, {}
            continue
        name = placeholder[1]
        for word, item in each[name] if name in each else _EACH[name](layout):
            yield path, output.replace(placeholder[0], word), {name: item}
