"""The reference on the site has every public name of the package, as Python itself sees them."""

from __future__ import annotations

import inspect
import sys
from collections.abc import Mapping
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

import sbgc
from sbgc import aio

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "generator"))

from sbgcgen.targets import Documented, Reference, references_of  # noqa: E402

REFERENCE: Reference = next(r for r in references_of(ROOT) if r.language == "Python")
MODULES = {"sbgc": sbgc, "sbgc.aio": aio}


def name_of(part: Documented) -> str:
    return part.name


def names_in(module: ModuleType) -> dict[str, object]:
    """The public classes and functions."""
    listed = getattr(module, "__all__", None)
    names = {name: getattr(module, name) for name in listed or vars(module) if name[0] != "_"}
    return {
        name: thing
        for name, thing in names.items()
        if (inspect.isclass(thing) or inspect.isfunction(thing))
        and (listed or thing.__module__ == module.__name__)
    }


def members_of(type_: type) -> dict[str, object]:
    """The public methods and properties that the package defines."""
    found = inspect.getmembers(type_)
    ours = (type, int, str, tuple, OSError, Mapping)
    return {
        name: thing
        for name, thing in found
        if name[0] != "_" and not any(hasattr(other, name) for other in ours)
    }


@pytest.mark.parametrize("part", REFERENCE.parts, ids=name_of)
def test_all_names_are_there(part: Documented) -> None:
    expected = names_in(MODULES[part.name])
    shown = {thing.name: thing for thing in part.members}
    assert shown.keys() == expected.keys()
    for name, thing in expected.items():
        assert shown[name].text, name
        if inspect.isclass(thing):
            inside = {member.name.rpartition(".")[2] for member in shown[name].members}
            assert members_of(thing).keys() <= inside, name


@pytest.mark.parametrize("part", REFERENCE.parts, ids=name_of)
def test_functions_have_the_parameters_that_python_knows(part: Documented) -> None:
    seen = 0
    for thing in (item for outer in part.members for item in (outer, *outer.members)):
        if thing.kind != "function":
            continue
        assert thing.text, thing.name
        called: Any = MODULES[part.name]
        for step in thing.name.split("."):
            called = getattr(called, step)
        assert callable(called)
        for name in inspect.signature(called).parameters:
            assert name == "self" or f"{name}:" in thing.signature, f"{thing.name}: {name}"
        seen += 1
    assert seen
