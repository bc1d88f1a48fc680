"""The messages of the Python package: a class for each, and for every structure, enum and packed value."""

from __future__ import annotations

import keyword
from collections.abc import Iterator
from pathlib import Path
from typing import Optional

from sbgcgen.blocking import MADE, blocking, source_of
from sbgcgen.model import Enum, Layout, Message, Packed, Struct
from sbgcgen.oracle.example import Example
from sbgcgen.spec.diagnostics import Diagnostics
from sbgcgen.spec.load import Spec
from sbgcgen.targets import Code, Reference, Target, View
from sbgcgen.targets.python import words
from sbgcgen.targets.python.example import decoding, encoding
from sbgcgen.targets.python.reference import reference_of

# The imports of the modules, and the bases of their classes.
TAKEN = frozenset(
    """Axes AxesOf BYTES Bytes ClassVar Elements Field Framing GroupOf IntEnum Iterable ListOf Message
    Flags8 Flags16 Flags32 OpenEnum Optional Packed Part RAW REAL Request Structure TEXT TYPE_CHECKING UNSET Union ValueOf Xyz""".split()
)


class Python(Target):
    """Modules of the package `sbgc.msg`, and the blocking client; python/ has the rest of the package."""

    def view(self, layout: Layout, project: Path) -> View:
        return View(
            names={"homes": words.homes(layout), "answers": words.answers(layout)},
            filters=words.FILTERS,
        )

    def files(self, layout: Layout, project: Path) -> Iterator[tuple[str, bytes]]:
        yield from super().files(layout, project)
        for path in source_of(project):
            yield MADE, blocking(path.read_text(encoding="utf-8")).encode()

    def examples(self, example: Example) -> list[Code]:
        """The code of a host: it encodes messages to the board, and decodes the others."""
        message = example.message
        if message.in_both_directions or message.direction == "to_board":
            return [Code("Python", "python", encoding(example))]
        text, output = decoding(example)
        return [Code("Python", "python", text, output)]

    def reference(self, project: Path) -> Optional[Reference]:
        return reference_of(project)

    def lint(self, spec: Spec, layout: Layout, found: Diagnostics) -> None:
        """Report types and messages that are impossible in the modules."""
        structs = (s for family in layout.families for s in family.structs)
        things: list[Enum | Packed | Struct | Message] = [*layout.enums, *layout.packed, *structs]
        for thing in (*things, *layout.messages):
            if thing.name in TAKEN or keyword.iskeyword(thing.name):
                text = f"'{thing.name}' is a type of the library"
                found.add(thing.at, "SBGC022", text, "choose another name, for a message with 'as'")
