"""C++20 headers: structs, codecs, and what the runtime knows of the protocol."""

from __future__ import annotations

from pathlib import Path

from sbgcgen.model import Layout, Quantity
from sbgcgen.oracle.example import Example
from sbgcgen.spec.diagnostics import Diagnostics
from sbgcgen.spec.load import Spec
from sbgcgen.targets import Code, Target, View
from sbgcgen.targets.cpp.example import code_of, converting
from sbgcgen.targets.cpp.filters import FILTERS
from sbgcgen.targets.cpp.lint import check_names


class Cpp(Target):
    """The headers, C++ in worked examples, and names that C++ can not have."""

    def view(self, layout: Layout, project: Path) -> View:
        return View(filters=FILTERS)

    def lint(self, spec: Spec, layout: Layout, found: Diagnostics) -> None:
        check_names(spec, layout, found)

    def example(self, example: Example) -> Code:
        return code_of(example)

    def conversion(self, quantity: Quantity) -> Code:
        return converting(quantity)
