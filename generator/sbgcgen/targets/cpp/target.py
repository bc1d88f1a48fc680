"""C++20 headers: structs, codecs, and the runtime's facts about the protocol."""

from __future__ import annotations

from dataclasses import replace
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
    """The headers, C++ in worked examples, and names that are impossible in C++."""

    def view(self, layout: Layout, project: Path) -> View:
        return View(filters=FILTERS)

    def lint(self, spec: Spec, layout: Layout, found: Diagnostics) -> None:
        check_names(spec, layout, found)

    def examples(self, example: Example) -> list[Code]:
        """The codes of a host: with the client, and with the codec alone.

        They send or encode messages to the board, and receive or decode the others.
        """
        message = example.message
        if message.in_both_directions or message.direction == "to_board":
            steps = worked.steps_of(example)
            facts: dict[str, Any] = {"message": message, "read": example.read, "steps": steps}
            sent = [self._client("send", **facts)] if example.read is None else []
            return [*sent, self._code("encode", size=len(example.frame), **facts)]
        looks = worked.looks_at(example)
        facts = {"message": message, "looks": looks}
        received = self._client("receive", **facts)
        facts.update(frame=example.frame, values=example.context)
        output = tuple(look.printed for look in looks)
        return [received, self._code("decode", output, **facts)]

    def conversion(self, quantity: Quantity) -> Code:
        raw, output = worked.number_and_output(quantity)
        code = self._code("convert", output, quantity=quantity, raw=raw)
        return replace(code, language="C++")

    def _client(self, kind: str, **facts: Any) -> Code:
        return replace(self._code(kind, **facts), language="C++ client", word="client")

    def _code(self, kind: str, output: tuple[str, ...] = (), **facts: Any) -> Code:
        made = environment(self)
        made.filters.update(worked.FILTERS)
        text = made.get_template(f"{self.name}/example.jinja").render(kind=kind, **facts)
        return Code("C++ codec", "cpp", text.strip(), output)
