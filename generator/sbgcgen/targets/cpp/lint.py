"""Names that are reserved by C++ or by surrounding code."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from sbgcgen.model import BODY, ID, SIZE, Enum, Field, Framing, Layout, Message, Packed, Position
from sbgcgen.model import Quantity
from sbgcgen.spec.diagnostics import Diagnostics
from sbgcgen.spec.load import Map, Spec
from sbgcgen.targets.cpp.filters import later_units
from sbgcgen.targets.cpp.flag_unit import flag_units
from sbgcgen.views.code import unit_name

WORDS = frozenset(
    """alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t
    char32_t char8_t class co_await co_return co_yield compl concept const const_cast consteval
    constexpr constinit continue decltype default delete do double dynamic_cast else enum
    explicit export extern false float for friend goto if inline int long mutable namespace new
    noexcept not not_eq nullptr operator or or_eq private protected public register
    reinterpret_cast requires return short signed sizeof static static_assert static_cast struct
    switch template this thread_local throw true try typedef typeid typename union unsigned
    using virtual void volatile wchar_t while xor xor_eq""".split()
)
# Types of the library that a type of the spec would hide where messages use them.
TYPES = frozenset(
    """Availability Axes BoundedArray BoundedBytes BoundedText Bytes Confirmed Direction Flags
    Form Members Number NumberType NumberTypes Optional Physical ResponsePolicy StreamChange
    Text I24 U24 Xyz""".split()
)
# Members that every generated message, struct, packed integer and quantity has.
_MEMBERS = ("varying_members", "tagged_unions")
_MESSAGE = frozenset(
    ("command", "direction", "form", "min_size", "max_size", "since", "tail", "until", *_MEMBERS)
)
# Nested types of messages.
_INNER_TYPES = frozenset(("Context", "Response"))
_STRUCT = frozenset(("wire_size", "element_sizes", *_MEMBERS))
_PACKED = frozenset(("raw", "raw_", "raw_type", "named", "set"))
_QUANTITY = frozenset(
    ("raw", "real", "unit", "from_real", "growth", "raw_type", "unit_type", "number_type")
)


def can_be_a_name(word: str) -> bool:
    """True if C++ reserves `word`; two underscores belong to the compiler."""
    return "__" not in word and word not in WORDS


def check_names(spec: Spec, layout: Layout, found: Diagnostics) -> None:
    """Report every name that is impossible in the headers; findings go into `found`."""
    for at, name, hint in _all_names(spec, layout):
        if not can_be_a_name(name):
            found.add(at, "SBGC022", f"'{name}' cannot be a name in C++", hint)
    for form, at in _forms(spec):
        if form == "only" or not can_be_a_name(form):
            text = f"'{form}' cannot be the name of a form"
            found.add(at, "SBGC022", text, "it becomes an enumerator in C++")
    types = _types(layout)
    for name, at in (*types.items(), *((m.name, m.at) for m in layout.messages)):
        if name in TYPES:
            text = f"'{name}' is a type of the library"
            found.add(at, "SBGC022", text, "choose another name, for a message with 'as'")
        if name in _INNER_TYPES:
            text = f"'{name}' is a type that every message has inside"
            found.add(at, "SBGC022", text, "choose another name")
    for struct in (s for family in layout.families for s in family.structs):
        _check_members(struct.fields, "struct", _STRUCT, types, found)
    for message in layout.messages:
        _check_members(message.fields, "message", _MESSAGE, types, found)
        _check_flag_units(message, found)
    for _, name, node, _ in spec.entries("quantities"):
        if node.get("accessor") in _QUANTITY:
            text = f"'{node['accessor']}' is a member that every quantity has"
            hint = "call the conversion after its unit: degrees, volts"
            found.add(node.at("accessor"), "SBGC022", text, hint)
    _check_units(layout, found)
    _check_packed(layout, found)
    for part in (part for packed in layout.packed for part in packed.parts):
        if part.name in _PACKED:
            text = f"'{part.name}' is a member that every packed integer has"
            found.add(part.at, "SBGC022", text, "give the part another name")
    _check_flags(layout.enums, types, found)
    for framing in () if found.any_of(("SBGC069",)) else layout.framings:
        _check_framing(framing, spec.main["framings"], found)


def _all_names(spec: Spec, layout: Layout) -> Iterator[tuple[Position, str, str]]:
    """Names with their positions, and advice if one of them is impossible."""
    for words in spec.main.get("indices", {}).values():
        for word, at in zip(words, words.items_at):
            yield at, word.lower(), "call the element by another name"
    for identifier in layout.identifiers:
        yield identifier.at, identifier.name, "give another one with 'as'"
    for message in layout.messages:
        yield message.at, message.name, "give the message another one with 'as'"
    protocol, effects = spec.main["protocol"], spec.main.get("effects", {})
    namespace = str(protocol.get("namespace", "sbgc"))
    yield protocol.at("namespace"), namespace, "choose another namespace"
    yield from ((effects.at(word), word, "choose another word") for word in effects)


def _forms(spec: Spec) -> Iterator[tuple[str, Position]]:
    for _, _, command, _ in spec.entries("commands"):
        for direction in ("from_board", "to_board"):
            forms = command.get(direction, Map()).get("forms", Map())
            yield from ((form, forms.at(form)) for form in forms)


def _types(layout: Layout) -> dict[str, Position]:
    types: list[Quantity | Enum | Packed] = [*layout.quantities, *layout.enums, *layout.packed]
    structs = (s for family in layout.families for s in family.structs)
    return {thing.name: thing.at for thing in (*types, *structs)}


def _check_members(
    fields: tuple[Field, ...],
    owner: str,
    words: frozenset[str],
    types: dict[str, Position],
    found: Diagnostics,
) -> None:
    functions = {f"{word}_{f.name}" for f in later_units(fields) for word in ("set", "real")}
    for field in fields:
        if field.name in words:
            text = f"'{field.name}' is a member that every {owner} has"
            found.add(field.at, "SBGC022", text, "give the field another name with 'as'")
        if field.name in functions:
            text = f"'{field.name}' is a function of the {owner}, for a field that later firmware changed"
            found.add(field.at, "SBGC022", text, "give the field another name with 'as'")
        if field.name in types:
            text = f"'{field.name}' is the name of a type"
            found.add(field.at, "SBGC022", text, "a member's name starts with a lower-case letter")
        for special in field.special:
            if special.name in words:
                text = f"'{special.name}' is the name of another member"
                found.add(special.at, "SBGC012", text, "give the special value another name")


def _check_units(layout: Layout, found: Diagnostics) -> None:
    """A unit is the name of a type with the accessors, and of its literals, as in 45_deg."""
    seen: dict[str, Quantity] = {}
    for quantity in layout.quantities:
        name = unit_name(quantity)
        first = seen.setdefault(name, quantity)
        if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", name) or not can_be_a_name(name):
            text = f"the unit of {quantity.name} cannot be a part of names in C++"
            found.add(quantity.at, "SBGC022", text, f"its literals would end in '_{name}'")
        elif first.unit != quantity.unit:
            text = f"literals of {quantity.name} would be those of {first.name}: 1_{name}"
            found.add(quantity.at, "SBGC028", text, "give its unit or accessor another name")
        elif first.accessor != quantity.accessor:
            text = f"{first.name} has the accessor '{first.accessor}' for {first.unit}"
            found.add(quantity.at, "SBGC028", text, "the accessors of a unit have one name")


def _check_flag_units(message: Message, found: Diagnostics) -> None:
    """A field with two units adds functions."""
    members = {f"{word}_{unit.name}" for unit in flag_units(message) for word in ("set", "real")}
    for field in message.fields:
        if field.name in members:
            text = f"'{field.name}' is a function of {message.name}, for a field with two units"
            found.add(field.at, "SBGC022", text, "give the field another name with 'as'")


def _check_packed(layout: Layout, found: Diagnostics) -> None:
    """The values that a packed integer converts from are members of it."""
    for packed in layout.packed:
        enum = packed.names or (packed.main.enum if packed.main else None)
        if enum is None:
            continue
        parts = {name for part in packed.parts for name in (part.name, f"set_{part.name}")}
        for value in enum.values:
            if value.identifier in _PACKED | parts:
                text = (
                    f"'{value.identifier}' of {enum.name} is the name of a member of {packed.name}"
                )
                found.add(packed.at, "SBGC022", text, "give the part, or the value, another name")


def _check_flags(enums: Iterable[Enum], types: dict[str, Position], found: Diagnostics) -> None:
    """A single flag is a type, too."""
    for enum in enums:
        if enum.member != enum.name and enum.member in types:
            text = f"the single flag of {enum.name} is called {enum.member} in C++"
            hint = f"that name is taken; give {enum.name} another one"
            found.add(enum.at, "SBGC028", text, hint)


def _check_framing(framing: Framing, nodes: Map, found: Diagnostics) -> None:
    """The runtime implements one header, and one checksum after the body (<sbgc/framing.hpp>)."""
    node = nodes[framing.name]
    hint = "the C++ code has no other: extend <sbgc/framing.hpp> first"
    names = [(framing.name, nodes.at(framing.name))]
    names += [(name, node["checksums"].at(name)) for name in node["checksums"]]
    for name, at in names:
        if not can_be_a_name(name):
            found.add(at, "SBGC022", f"'{name}' cannot be a name in C++", "choose another one")
    header = framing.checksum("header_checksum")
    if sorted(framing.header[1:]) != ["header_checksum", ID, SIZE] or header is None:
        text = f"the header of '{framing.name}' is not start, id, size and header_checksum"
        found.add(node.at("header"), "SBGC069", text, hint)
    elif (header.kind, header.covers) != ("sum8", (ID, SIZE)):
        text = f"the header checksum of '{framing.name}' is not the sum of id and size"
        found.add(node["checksums"].at("header_checksum"), "SBGC069", text, hint)
    if len(framing.trailer) != 1:
        text = f"the trailer of '{framing.name}' is not a single checksum"
        found.add(node.at("trailer"), "SBGC069", text, hint)
        return
    trailer = framing.checksum(framing.trailer[0])
    parts = (*framing.header, BODY)
    if trailer and trailer.covers != parts[-len(trailer.covers) :]:
        text = f"'{trailer.name}' does not cover the body, or the parts from one on up to the body"
        hint = f"their order is {', '.join(parts)}"
        found.add(node["checksums"].at(trailer.name), "SBGC069", text, hint)
