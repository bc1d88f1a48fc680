"""Names that the modules of the Python package need for themselves."""

from __future__ import annotations

import keyword

from sbgcgen.model import Enum, Layout, Message, Packed, Struct
from sbgcgen.spec.diagnostics import Diagnostics

# The imports of the modules, and the bases of their classes.
TAKEN = frozenset(
    """Axes AxesOf BYTES Bytes ClassVar Elements Field Framing GroupOf IntEnum Iterable ListOf Message
    Flags8 Flags16 Flags32 OpenEnum Optional Packed Part RAW REAL Request Structure TEXT TYPE_CHECKING UNSET Union ValueOf Xyz""".split()
)


def check_names(layout: Layout, found: Diagnostics) -> None:
    """Report types and messages that the modules could not have; findings go into `found`."""
    structs = (s for family in layout.families for s in family.structs)
    things: list[Enum | Packed | Struct | Message] = [*layout.enums, *layout.packed, *structs]
    for thing in (*things, *layout.messages):
        if thing.name in TAKEN or keyword.iskeyword(thing.name):
            text = f"'{thing.name}' is a type of the library"
            found.add(thing.at, "SBGC022", text, "choose another name, for a message with 'as'")
