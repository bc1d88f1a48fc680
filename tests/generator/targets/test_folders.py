"""A target is self-contained: it is added and removed with its folder, and no code names it."""

from __future__ import annotations

import ast
import shutil
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

from sbgcgen.targets import HERE, target, targets
from support import BASE, GENERATOR, PROJECT, files_in, run_generator, write_spec

NAMES = [target.name for target in targets()]
# Packages from the lowest to the highest layer; a module uses only its own package and lower ones.
# Modules outside of them (the command line and its helpers) use all.
FOLDERS = ("model", "spec", "oracle", "views", "targets")

TOY = '''
from collections.abc import Sequence
from pathlib import Path

from sbgcgen.model import Layout
from sbgcgen.oracle.example import Example
from sbgcgen.spec.diagnostics import Diagnostics
from sbgcgen.spec.load import Spec
from sbgcgen.targets import Code, Target, View


class Toy(Target):
    """A list of messages, and a language in which every example is the name of its message."""

    def view(self, layout: Layout, project: Path) -> View:
        longest = max(layout.messages, key=lambda message: message.max_size)
        return View(names={"longest": longest}, filters={"shout": str.upper})

    def lint(self, spec: Spec, layout: Layout, found: Diagnostics) -> None:
        for message in layout.messages:
            if message.name == "Toy":
                found.add(message.at, "SBGC022", "'Toy' cannot be a name in toys", "take another")

    def examples(self, example: Example) -> Sequence[Code]:
        return (Code("Toys", "toy", f"play({example.message.name})"),)
'''
TEMPLATES = {
    "toys/@family@.txt.j2": '{% import "toy/macros.jinja" as m %}'
    "{% for message in family.messages %}{{ m.line(message) }}{% endfor %}\n{{ longest.name | shout }}\n",
    "macros.jinja": "{% macro line(message) %}{{ message.name }} {{ message.id }}\n{% endmacro %}",
}


@pytest.fixture(name="generator")
def copied(tmp_path: Path) -> Path:
    """A copy of the generator."""
    copy = tmp_path / "generator"
    shutil.copytree(GENERATOR, copy)
    return copy


def output_of(generator: Path, spec: Path, folder: Path) -> dict[str, bytes]:
    at = ["--root", spec.parent, "--spec", spec, "--output", folder]
    done = run_generator("generate", *at, generator=generator)
    assert done.returncode == 0, done.stderr
    return files_in(folder)


@pytest.fixture(name="before", scope="module")
def as_it_is(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    """The output of the unmodified generator."""
    folder = tmp_path_factory.mktemp("before")
    return output_of(GENERATOR, write_spec(folder), folder / "out")


def add_toy(generator: Path) -> None:
    toy = generator / "sbgcgen" / "targets" / "toy"
    for name, text in TEMPLATES.items():
        path = toy / "templates" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    (toy / "target.py").write_text(TOY, encoding="utf-8")


def test_a_folder_is_all_that_a_target_takes(
    before: dict[str, bytes], generator: Path, tmp_path: Path
) -> None:
    spec = write_spec(tmp_path)
    add_toy(generator)
    after = output_of(generator, spec, tmp_path / "after")
    assert after.keys() - before.keys() == {"toys/base.txt"}
    assert after["toys/base.txt"].endswith(b"\nUSE\n") and b"Ping 1\n" in after["toys/base.txt"]
    assert before.items() <= after.items()
    # The site shows examples in any language.
    at = ["--spec", spec, "--output", tmp_path / "site"]
    site = run_generator("site", *at, generator=generator)
    assert site.returncode == 0, site.stderr
    assert "play(Use)" in (tmp_path / "site/messages/use.html").read_text(encoding="utf-8")


def test_rules_of_a_target_are_checked(generator: Path, tmp_path: Path) -> None:
    spec = write_spec(tmp_path, BASE.replace("CMD_PROBE", "CMD_TOY"))
    assert run_generator("lint", "--spec", spec, generator=generator).returncode == 0
    add_toy(generator)
    done = run_generator("lint", "--spec", spec, generator=generator)
    assert done.returncode == 1
    assert "SBGC022 'Toy' cannot be a name in toys" in done.stderr


@pytest.mark.parametrize("name", NAMES)
def test_a_target_needs_no_other(
    name: str, before: dict[str, bytes], generator: Path, tmp_path: Path
) -> None:
    """It is rendered as before if the folders of all others are gone."""
    spec = write_spec(tmp_path)
    for other in set(NAMES) - {name}:
        shutil.rmtree(generator / "sbgcgen" / "targets" / other)
    after = output_of(generator, spec, tmp_path / "after")
    assert after.items() < before.items()
    assert bool(after) == target(name).committed


# Imports of the modules


@cache
def modules() -> dict[Path, list[ast.AST]]:
    """The nodes of each module."""
    paths = sorted((GENERATOR / "sbgcgen").rglob("*.py"))
    return {path: list(ast.walk(ast.parse(path.read_text(encoding="utf-8")))) for path in paths}


def imports(nodes: list[ast.AST]) -> Iterator[str]:
    """Yields the imported modules and names."""
    for node in nodes:
        if isinstance(node, ast.Import):
            yield from (name.name for name in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            yield from (f"{node.module}.{name.name}" for name in node.names)


@pytest.mark.parametrize("name", NAMES)
def test_no_module_outside_names_a_target(name: str) -> None:
    folder = HERE / name
    for path, nodes in modules().items():
        if folder in path.parents:
            continue
        for module in imports(nodes):
            assert f"{module}.".find(f".targets.{name}.") < 0, f"{path.name} imports {module}"
        for node in nodes:
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                words = node.value.replace("/", " ").replace(".", " ").split()
                is_other = len(words) > 2
                assert is_other or name not in words, f"{path.name}:{node.lineno} mentions {name}"


def test_templates_of_a_target_use_no_other_one() -> None:
    for target in targets():
        for path in target.templates.rglob("*.j*"):
            text = path.read_text(encoding="utf-8")
            for other in NAMES:
                assert other == target.name or f'"{other}/' not in text, path


def test_folders_use_lower_ones_only() -> None:
    root = GENERATOR / "sbgcgen"
    for path, nodes in modules().items():
        folder = path.relative_to(root).parts[0]
        if folder not in FOLDERS:
            continue
        higher = FOLDERS[FOLDERS.index(folder) + 1 :]
        for module in imports(nodes):
            used = f"{module}.".removeprefix("sbgcgen.").split(".")[0]
            assert not module.startswith("sbgcgen.") or used not in higher, f"{path}: {module}"


def test_the_project_says_no_name_of_a_target_to_the_build() -> None:
    text = (PROJECT / "CMakeLists.txt").read_text(encoding="utf-8")
    assert "targets/*/templates/*" in text
    assert not any(f"targets/{name}" in text for name in NAMES)
