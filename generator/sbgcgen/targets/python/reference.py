"""The reference of the package, from the signatures and docstrings of its modules."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from inspect import cleandoc
from pathlib import Path
from typing import Optional, Union

from sbgcgen.targets import Documented, Reference
from sbgcgen.targets.python.example import Call, lines_of

PACKAGE = "sbgc"
# The folders of the modules written by hand and of those from templates.
SOURCES = ("python", "generated/python")

_Function = (ast.FunctionDef, ast.AsyncFunctionDef)


def reference_of(project: Path) -> Optional[Reference]:
    """All public names of the package; None without a package."""
    if not (project / SOURCES[0] / PACKAGE).is_dir():
        return None
    package = _Package(project)
    return Reference(
        language="Python",
        word="python",
        source=f"{SOURCES[0]}/{PACKAGE}",
        messages=f"{PACKAGE}.msg",
        parts=(package.module(PACKAGE), package.module(f"{PACKAGE}.aio")),
    )


class _Package:
    """Modules of the package, and the modules that define their names."""

    def __init__(self, project: Path) -> None:
        self.project = project
        self.parsed: dict[str, ast.Module] = {}
        self.told: dict[str, Documented] = {}  # by the name in its module

    def module(self, name: str) -> Documented:
        """A module with its public names: those of __all__, or those that it defines."""
        tree = self._parse(name)
        found = tuple(self._names(name, _public(tree)))
        for thing in found:
            for item in (thing, *thing.members):
                self.told.setdefault(item.name, item)
        return Documented("module", name, f"import {name}", _text(tree), found)

    def _parse(self, module: str) -> ast.Module:
        if module in self.parsed:
            return self.parsed[module]
        path = module.replace(".", "/")
        files = (f"{source}/{path}{end}" for source in SOURCES for end in (".py", "/__init__.py"))
        file = next(file for file in files if (self.project / file).is_file())
        tree = ast.parse((self.project / file).read_text(encoding="utf-8"))
        return self.parsed.setdefault(module, tree)

    def _find(self, module: str, name: str) -> Optional[tuple[str, ast.stmt]]:
        """A class or function of the package, and the module that defines it."""
        for node in _statements(self._parse(module).body):
            if isinstance(node, (ast.ClassDef, *_Function)) and node.name == name:
                return module, node
            if not isinstance(node, ast.ImportFrom) or node.module in (None, module):
                continue
            is_ours = f"{node.module}.".startswith(f"{PACKAGE}.")
            if is_ours and name in (alias.name for alias in node.names):
                return self._find(str(node.module), name)
        return None

    def _names(self, module: str, names: list[str]) -> Iterator[Documented]:
        for name in names:
            found = self._find(module, name)
            if found and isinstance(found[1], ast.ClassDef):
                yield self._class(found[0], found[1], names)
            elif found and isinstance(found[1], _Function):
                yield self._function(found[1], name)

    def _class(self, module: str, node: ast.ClassDef, public: list[str]) -> Documented:
        bases = [ast.unparse(base) for base in node.bases]
        members = {member.name: member for member in self._members(module, node, node.name)}
        functions = (item for item in node.body if isinstance(item, ast.FunctionDef))
        start = next((f for f in functions if f.name == "__init__"), None)
        said = _signature(start, node.name, is_method=True) if start else ""
        if not start or "_core." in said:  # the package itself makes its objects
            shown = [base for base in bases if base in public or not self._find(module, base)]
            said = f"class {node.name}" + (f"({', '.join(shown)})" if shown else "")
        return self._known("class", node.name, said, _text(node), tuple(members.values()))

    def _members(self, module: str, node: ast.ClassDef, owner: str) -> Iterator[Documented]:
        """The public members, after those of its base classes in the package."""
        for base in node.bases:
            above = self._find(module, ast.unparse(base).partition("[")[0])
            if above and isinstance(above[1], ast.ClassDef):
                yield from self._members(above[0], above[1], owner)
        for at, item in enumerate(node.body):
            if isinstance(item, _Function):
                if not item.name.startswith("_"):
                    yield self._function(item, f"{owner}.{item.name}", is_method=True)
                continue
            to = item.target if isinstance(item, ast.AnnAssign) else None
            if isinstance(item, ast.Assign) and isinstance(item.targets[0], ast.Name):
                to = item.targets[0]
            if isinstance(to, ast.Name) and not to.id.startswith("_"):
                said = _assigned(item)
                text = _text_below(node.body, at)
                yield Documented("attribute", f"{owner}.{to.id}", said, text)

    def _function(
        self,
        node: Union[ast.FunctionDef, ast.AsyncFunctionDef],
        name: str,
        is_method: bool = False,
    ) -> Documented:
        decorators = [ast.unparse(decorator) for decorator in node.decorator_list]
        if "property" in decorators:
            hint = f": {ast.unparse(node.returns)}" if node.returns else ""
            return self._known("attribute", name, node.name + hint, _text(node))
        is_static = not is_method or "staticmethod" in decorators
        said = _signature(node, node.name, not is_static, with_result=True)
        if any("contextmanager" in decorator for decorator in decorators):
            said = f"{'async ' if isinstance(node, ast.AsyncFunctionDef) else ''}with {said}"
        elif isinstance(node, ast.AsyncFunctionDef):
            said = f"await {said}"
        return self._known("function", name, said, _text(node))

    def _known(
        self,
        kind: str,
        name: str,
        signature: str,
        text: str,
        members: tuple[Documented, ...] = (),
    ) -> Documented:
        """A name; without a text, the description of the same name in an earlier module is used."""
        if not text and name in self.told:
            text = f"As `{PACKAGE}.{name}`."
        return Documented(kind, name, signature, text, members)


def _statements(body: list[ast.stmt]) -> Iterator[ast.stmt]:
    """The statements of a module, including conditional ones."""
    for node in body:
        yield node
        if isinstance(node, ast.If):
            yield from _statements(node.body)


def _public(tree: ast.Module) -> list[str]:
    """The names in __all__; without it, the classes and functions that the module defines."""
    for node in tree.body:
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "__all__":
            names: list[str] = ast.literal_eval(node.value)
            return names
    things = (node for node in tree.body if isinstance(node, (ast.ClassDef, *_Function)))
    return [node.name for node in things if not node.name.startswith("_")]


def _assigned(node: ast.stmt) -> str:
    """An attribute with its type, or a constant with its value."""
    if isinstance(node, ast.AnnAssign):
        return f"{ast.unparse(node.target)}: {ast.unparse(node.annotation)}"
    return ast.unparse(node)


def _text(node: Union[ast.Module, ast.stmt]) -> str:
    assert isinstance(node, (ast.Module, ast.ClassDef, *_Function))
    return ast.get_docstring(node) or ""


def _text_below(body: list[ast.stmt], at: int) -> str:
    """The docstring below an attribute."""
    below = body[at + 1] if at + 1 < len(body) else None
    if isinstance(below, ast.Expr) and isinstance(below.value, ast.Constant):
        return cleandoc(str(below.value.value))
    return ""


def _signature(
    node: Union[ast.FunctionDef, ast.AsyncFunctionDef],
    name: str,
    is_method: bool,
    with_result: bool = False,
) -> str:
    """The signature of a function, on several lines if it is long."""
    given = node.args
    plain = [*given.posonlyargs, *given.args]
    defaults = [None] * (len(plain) - len(given.defaults)) + list(given.defaults)
    said = [_argument(a, d) for a, d in list(zip(plain, defaults))[int(is_method) :]]
    if given.vararg:
        said.append(f"*{_argument(given.vararg, None)}")
    elif given.kwonlyargs:
        said.append("*")
    said += [_argument(a, d) for a, d in zip(given.kwonlyargs, given.kw_defaults)]
    result = ""
    if with_result and node.returns:
        result = f" -> {ast.unparse(node.returns)}"
    return "\n".join(lines_of("", Call(f"{name}(", tuple(("", part) for part in said)), result))


def _argument(argument: ast.arg, default: Optional[ast.expr]) -> str:
    hint = f": {ast.unparse(argument.annotation)}" if argument.annotation else ""
    if default is None:
        return argument.arg + hint
    return f"{argument.arg}{hint}{' = ' if hint else '='}{ast.unparse(default)}"
