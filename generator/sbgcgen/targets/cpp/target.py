"""C++20 headers: structs, codecs, and what the runtime knows of the protocol."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from sbgcgen.model import Layout, Quantity
from sbgcgen.oracle.example import Example
from sbgcgen.spec.diagnostics import Diagnostics
from sbgcgen.spec.load import Spec
from sbgcgen.targets import Code, Target, View
from sbgcgen.targets.cpp import example as worked
from sbgcgen.targets.cpp.filters import FILTERS
from sbgcgen.targets.cpp.lint import check_names
from sbgcgen.targets.render import environment


class Cpp(Target):
    """The headers, C++ in worked examples, and names that C++ cannot have."""

    def view(self, layout: Layout, project: Path) -> View:
        return View(filters=FILTERS)

    def lint(self, spec: Spec, layout: Layout, found: Diagnostics) -> None:
        check_names(spec, layout, found)

    def example(self, example: Example) -> Code:
        """The code of a host: it encodes what goes to the board, and decodes the rest."""
        message = example.message
        if message.in_both_directions or message.direction == "to_board":
            steps = worked.steps_of(example)
            size = len(example.frame)
            return self._code("encode", message=message, read=example.read, steps=steps, size=size)
        looks = worked.looks_at(example)
        facts = {"message": message, "frame": example.frame, "values": example.context}
        return self._code("decode", tuple(look.printed for look in looks), looks=looks, **facts)

    def conversion(self, quantity: Quantity) -> Code:
        raw, output = worked.number_and_output(quantity)
        return self._code("convert", output, quantity=quantity, raw=raw)

    def _code(self, template: str, output: tuple[str, ...] = (), **facts: Any) -> Code:
        made = environment(self)
        made.filters.update(worked.FILTERS)
        text = made.get_template(f"{self.name}/example/{template}.jinja").render(**facts)
        return Code("C++", "cpp", text.strip(), output)
