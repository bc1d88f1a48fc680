"""The parts of a random spec under construction."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Optional

Node = dict[str, Any]

INTEGERS = {
    "u8": (0, 0xFF),
    "i8": (-0x80, 0x7F),
    "u16": (0, 0xFFFF),
    "i16": (-0x8000, 0x7FFF),
    "u32": (0, 0xFFFFFFFF),
    "i32": (-0x80000000, 0x7FFFFFFF),
}
SIZES = {"u8": 1, "i8": 1, "u16": 2, "i16": 2, "u32": 4, "i32": 4, "f32": 4}
UNSIGNED = ("u8", "u16", "u32")
# Numbers that only fields have: sizes on the wire and in C++.
WIDE = {"u24": (3, 4), "i24": (3, 4), "u64": (8, 8), "i64": (8, 8), "f64": (8, 8)}
MAX_BODY = 255
MAX_MEMORY = 100_000


@dataclass(frozen=True)
class Kind:
    """A type: at least `least` bytes on the wire, exactly if `fixed`; `memory` bytes in C++.

    `number` is the underlying scalar; `values` are those of an enum or flag set (`is_flags`); `parts` are
    those of a packed value. `limits` are those of an integer.
    """

    name: str
    least: int
    memory: int
    fixed: bool = True
    number: str = ""
    values: tuple[tuple[str, int], ...] = ()
    is_flags: bool = False
    is_quantity: bool = False
    unit: Optional[str] = None
    takes_rest: bool = False
    needs_family: str = ""
    parts: tuple[tuple[str, Kind], ...] = ()
    limits: Optional[tuple[int, int]] = None
    is_count: bool = False


def scalar(name: str) -> Kind:
    """Returns the type of a plain number."""
    least, memory = WIDE.get(name) or (SIZES[name], SIZES[name])
    return Kind(name, least, memory, number=name if name in SIZES else "")


def blob(size: int, kind: str = "bytes") -> Kind:
    """Returns the type of some bytes, or of a text."""
    return Kind(f"{kind}[{size}]", size, size)


@dataclass
class Scope:
    """A list of fields under construction.

    `known` are fields that conditions may refer to; `flags` are flags that choose a unit.
    """

    family: str
    budget: int
    in_message: bool
    depth: int = 0
    fields: list[Node] = field(default_factory=list)
    known: list[tuple[str, Kind]] = field(default_factory=list)
    flags: list[tuple[str, str]] = field(default_factory=list)
    variables: list[str] = field(default_factory=list)
    contexts: list[tuple[str, Kind]] = field(default_factory=list)
    least: int = 0
    memory: int = 0
    fixed: bool = True
    has_lists: bool = False
    takes_rest: bool = False
    has_region: bool = False

    def add(self, node: Node, least: int, memory: int, fixed: bool) -> None:
        """Adds a field with at least `least` bytes."""
        self.fields.append(node)
        self.least += least
        self.budget -= least
        self.memory += memory
        self.fixed = self.fixed and fixed


@dataclass(frozen=True)
class Body:
    """A message that others may refer to."""

    name: str
    family: str
    scope: Scope
    direction: str
    has_contexts: bool
