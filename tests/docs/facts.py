"""All facts of the model that a reference has to document, and where a reader looks for them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Protocol, Union

from sbgcgen.views.words import default_words, rules_in, versions
from sbgcgen.model import (
    Alias,
    Answer,
    Availability,
    Condition,
    Effect,
    Enum,
    Field,
    Layout,
    Leaf,
    Message,
    Packed,
    Part,
    Quantity,
)

Wanted = Union[str, Fraction]


@dataclass(frozen=True)
class Place:
    """The place of a fact.

    `kind` is "message", "enum", "packed", "unit", "variables", "errata" or "commands"; `name` is
    the message, type or (with a direction) message and direction; `hook` is the path of a leaf, the
    name of a value or variable, or the number of an erratum; "" is the page as a whole.
    """

    kind: str
    name: str = ""
    direction: str = ""
    hook: str = ""


@dataclass(frozen=True)
class Fact:
    """Something that must be found at a place: a text, or a number in any notation.

    `column` is the column of the place's row that must contain it, if the row has such a column;
    `flags` are regular expression flags, for a text whose case may differ.
    """

    place: Place
    kind: str
    wanted: Wanted
    column: str = ""
    flags: int = 0

    def holds(self, text: str) -> bool:
        """Returns True if the text contains this fact."""
        if isinstance(self.wanted, Fraction):
            return any(_same(number, self.wanted) for number in numbers(text))
        wanted = " ".join(self.wanted.split())
        pattern = rf"(?<![\w.]){re.escape(wanted)}(?!\w)"
        return re.search(pattern, " ".join(text.split()), self.flags) is not None


class Pages(Protocol):
    """A rendered reference."""

    def text(self, place: Place, column: str) -> str | None:
        """Returns the text at a place, or None if there is no such place."""


def missing(facts: Iterator[Fact] | list[Fact], pages: Pages) -> list[Fact]:
    """Returns the facts that the pages lack at their place."""
    return [f for f in facts if not f.holds(pages.text(f.place, f.column) or "")]


def numbers(text: str) -> Iterator[Fraction]:
    """Yields the numbers in a text: 12, -0.5, 360/16384, 0x3E."""
    text = text.replace("\u2212", "-").replace("..", " .. ")
    for word in re.findall(r"(?<![\w.])0x[0-9A-Fa-f]+", text):
        yield Fraction(int(word, 16))
    for word in re.findall(r"(?<![\w.])-?\d+(?:\.\d+)?(?:/\d+)?(?![\w])", text):
        numerator, _, denominator = word.partition("/")
        if denominator != "0":
            yield Fraction(numerator) / Fraction(denominator or 1)


def _same(number: Fraction, wanted: Fraction) -> bool:
    """Returns True if the numbers are equal within six digits."""
    return number == wanted or abs(number - wanted) < abs(wanted) * Fraction(6, 1000000)


def one_of_each_kind(facts: list[Fact]) -> list[Fact]:
    """Returns the first fact of each kind."""
    found: dict[str, Fact] = {}
    for fact in facts:
        found.setdefault(fact.kind, fact)
    return list(found.values())


def kind_of(fact: Fact) -> str:
    """Returns the id of a fact in pytest."""
    return fact.kind


def shapes_of(fact: Fact) -> re.Pattern[str]:
    """Returns a pattern of all notations of a fact's text or number."""
    if isinstance(fact.wanted, str):
        shapes = [r"\s+".join(re.escape(word) for word in fact.wanted.split())]
    else:
        number = fact.wanted.numerator
        digits = f"0*{number}" if number >= 0 else str(number)  # 02 in a row of bytes
        shapes = [digits, r"\d+/\d+", r"\d+\.\d+", f"0x0*{number & 0xFFFFFFFF:x}"]
    return re.compile("|".join(rf"(?<!\w){shape}(?!\w)" for shape in shapes), re.IGNORECASE)


# The facts


def all_facts(layout: Layout) -> Iterator[Fact]:
    """Yields all facts of the protocol."""
    for message in layout.messages:
        yield from facts_of_message(message)
    for enum in layout.enums:
        yield from _enum(enum)
    for packed in layout.packed:
        yield from _packed(packed)
    for quantity in layout.quantities:
        yield from _quantity(quantity)
    yield from _variables(layout)
    yield from _errata(layout)
    yield from _commands(layout)


def facts_of_message(message: Message) -> Iterator[Fact]:
    """Yields the facts on the page of a message."""
    place = Place("message", message.name, message.direction)
    yield Fact(place, "message", message.name)
    yield Fact(place, "message command", message.command)
    yield Fact(place, "message id", Fraction(message.id))
    yield Fact(place, "message summary", message.summary)
    yield Fact(place, "message source", message.source)
    yield Fact(place, "message size", Fraction(message.min_size))
    yield Fact(place, "message size", Fraction(message.max_size))
    if message.description:
        yield Fact(place, "message description", message.description)
    if message.form:
        yield Fact(place, "message form", message.form)
    yield from _since(place, "message since", message.since)
    yield from _unconfirmed(place, "message", message.unconfirmed)
    for since, size in message.lengths:
        yield Fact(place, "message size of a firmware", Fraction(size))
        yield from _since(place, "message size of a firmware", since)
    for rule in rules_in(message.body):
        for name in rule.replace("<=", "<").split(" < "):
            yield Fact(place, "rule", name)
        yield Fact(place, "rule", re.findall("<=?", rule)[0])
    if message.until:
        yield from _since(place, "message until", message.until.versions)
        if message.until.instead:
            yield Fact(place, "message instead", message.until.instead)
    if message.deprecated:
        yield Fact(place, "message deprecated", "deprecated", flags=re.IGNORECASE)
        yield from _since(place, "message deprecated since", message.deprecated.since)
        if message.deprecated.replaced_by:
            yield Fact(place, "message replaced by", message.deprecated.replaced_by)
    for number in message.errata:
        yield Fact(place, "message errata", number)
    if message.answer:
        yield from _answer(place, message.answer)
    if message.stores:
        yield Fact(place, "message stores", message.stores)
    if message.effect:
        yield from _effect(place, message.effect)
    if message.role and message.role.messages:
        for name in message.role.messages:
            yield Fact(place, "message streams", name)
        if message.role.limit:
            yield Fact(place, "message stream limit", Fraction(message.role.limit))
    for context in message.contexts:
        yield Fact(place, "context", context.name)
        yield Fact(place, "context", context.summary)
        for name, path in context.sources:
            yield Fact(place, "context source", name)
            yield Fact(place, "context source", path)
        if context.announced:
            yield Fact(place, "context source", context.announced.message)
    for leaf in message.leaves:
        yield from _leaf(message, leaf)
        for case in leaf.cases:
            yield from _leaf(message, case)


def _unconfirmed(place: Place, kind: str, is_unconfirmed: bool, column: str = "") -> Iterator[Fact]:
    if is_unconfirmed:
        yield Fact(place, f"{kind} unconfirmed", "unconfirmed", column, re.IGNORECASE)


def _formerly(
    place: Place, kind: str, aliases: tuple[Alias, ...], column: str = ""
) -> Iterator[Fact]:
    for alias in aliases:
        yield Fact(place, f"{kind} formerly", alias.spec_name, column)


def _condition(place: Place, kind: str, when: Condition, column: str = "") -> Iterator[Fact]:
    """Its source, and each clause with its verb; numbers as numbers."""
    if when.terms:
        for term in when.terms:
            yield from _condition(place, kind, term, column)
        return
    yield Fact(place, kind, when.source, column)
    if when.pattern:  # the names of the flags differ between the elements
        for name in re.findall(r"\w*\{AXIS\}\w*", when.pattern):
            yield Fact(place, kind, name, column)
        return
    for verb, _, values in when.clauses:
        yield Fact(place, f"{kind} verb", verb, column)
        for value in values:
            wanted = Fraction(value) if isinstance(value, int) else value.name
            yield Fact(place, kind, wanted, column)


def _since(place: Place, kind: str, since: Availability, column: str = "") -> Iterator[Fact]:
    for word in versions(since).split(", ") if since else ():
        yield Fact(place, kind, word, column)


def _effect(place: Place, effect: Effect) -> Iterator[Fact]:
    for case in effect.cases:
        for kind in effect.known:
            if kind.word in case.words:
                yield Fact(place, "message effect", kind.summary)
        if case.when:
            yield from _condition(place, "message effect condition", case.when)


def _answer(place: Place, answer: Answer) -> Iterator[Fact]:
    for case in answer.cases:
        if case.when:
            yield from _condition(place, "answer condition", case.when)
        for name in case.messages:
            yield Fact(place, "answer", name)
        if case.messages or case.confirm == "always":
            yield Fact(place, "answer timeout", Fraction(case.timeout_ms))
            if case.finish_ms:
                yield Fact(place, "answer timeout", Fraction(case.finish_ms))
        if case.confirmations > 1:
            yield Fact(place, "answer confirmations", Fraction(case.confirmations))
        for name in case.correlation:
            yield Fact(place, "answer echo", name)
        if case.result:
            yield Fact(place, "answer result", case.result.success.name)
        for number in case.errata:
            yield Fact(place, "answer errata", number)


def _leaf(message: Message, leaf: Leaf) -> Iterator[Fact]:
    place = Place("message", message.name, message.direction, leaf.path)
    field = leaf.field
    yield Fact(place, "field", leaf.path, "field")
    yield Fact(place, "field spec name", leaf.spec_name, "spec name", re.IGNORECASE)
    if leaf.offset is not None:
        yield Fact(place, "field offset", Fraction(leaf.offset), "offset")
    if field.type.kind != "announced":
        yield Fact(place, "field type", leaf.type, "type")
    if leaf.count not in (None, 1):
        assert leaf.count is not None
        yield Fact(place, "field count", Fraction(leaf.count), "type")
    if field.summary:
        yield Fact(place, "field summary", field.summary, "meaning")
    if isinstance(field.type, Quantity):
        yield from _unit_of_field(place, field.type)
    if field.directions is not None:
        positive = (leaf.direction and leaf.direction.positive) or "unknown"
        yield Fact(place, "field direction", positive)
    if isinstance(field.type, (Enum, Packed)):
        yield Fact(place, "field enum", field.type.name, "unit")
    for limit in (field.minimum, field.maximum):
        if limit is not None:
            yield Fact(place, "field range", limit, "range")
    for special in field.special:
        yield Fact(place, "field special value", Fraction(special.value), "meaning")
        yield Fact(place, "field special meaning", special.meaning, "meaning")
        if special.name:
            yield Fact(place, "field special name", special.name, "meaning")
    if field.reserved:
        yield Fact(place, "field reserved", "reserved", "meaning", re.IGNORECASE)
    if field.min_count and not field.index:
        yield Fact(place, "field least elements", Fraction(field.min_count), "meaning")
    if field.max_count is not None and not field.index:  # else each element has its own row
        yield Fact(place, "field most elements", Fraction(field.max_count), "meaning")
    if field.align != 1:
        yield Fact(place, "field alignment", Fraction(field.align), "meaning")
    if field.counter:
        yield Fact(place, "field counter", field.counter, "meaning")
        if field.counting != "elements":
            word = {"bytes": "bytes", "minus_1": "minus 1", "bits": "each bit that is set"}
            yield Fact(place, "field counting", word[field.counting], "meaning")
    if field.variable:
        yield Fact(place, "field variable", field.variable, "meaning")
    if field.when:
        yield from _condition(place, "field condition", field.when, "meaning")
    if field.alternative:
        yield Fact(place, "field other unit", field.alternative.flag.name, "meaning")
        yield Fact(place, "field other unit", field.alternative.quantity.name, "meaning")
    yield from _since(place, "field since", field.since, "meaning")
    yield from _before(place, field, message)
    yield from _formerly(place, "field", field.aliases, "meaning")
    yield from _unconfirmed(place, "field", field.unconfirmed, "meaning")
    yield from _default(place, field)
    if field.deprecated:
        yield Fact(place, "field deprecated", "deprecated", "meaning", re.IGNORECASE)
        yield from _since(place, "field deprecated since", field.deprecated.since, "meaning")
        if field.deprecated.replaced_by:
            yield Fact(place, "field replaced by", field.deprecated.replaced_by, "meaning")
    for number in field.errata:
        yield Fact(place, "field errata", number, "meaning")


def _before(place: Place, field: Field, message: Message) -> Iterator[Fact]:
    """What bodies of firmware without the field have in its place."""
    if field.appended:
        whole = "element" if "[]." in place.hook else "body"
        yield Fact(place, "field appended", f"before, the {whole} ends here", "meaning")
    elif message.was_reserved(field):
        yield Fact(place, "field reserved before", "before, its bytes are reserved", "meaning")


def _default(place: Place, field: Field) -> Iterator[Fact]:
    if not field.constant and not field.default:
        return
    kind = "field constant" if field.constant else "field default"
    yield Fact(place, kind, "always" if field.constant else "default", "meaning", re.IGNORECASE)
    for word in default_words(field):
        is_number = re.fullmatch(r"-?\d+", word)
        yield Fact(place, kind, Fraction(word) if is_number else word, "meaning")


def _unit_of_field(place: Place, quantity: Quantity) -> Iterator[Fact]:
    yield Fact(place, "field quantity", quantity.name, "unit")
    if quantity.unit:
        yield Fact(place, "field unit", quantity.unit, "unit")
    if quantity.scale != 1:
        yield Fact(place, "field scale", quantity.scale, "unit")
    if quantity.offset:
        yield Fact(place, "field scale", quantity.offset, "unit")


def _enum(enum: Enum) -> Iterator[Fact]:
    place = Place("enum", enum.name)
    yield Fact(place, "enum", enum.name)
    yield Fact(place, "enum type", enum.scalar.name)
    yield Fact(place, "enum summary", enum.summary)
    yield Fact(place, "enum source", enum.source)
    for number in enum.errata:
        yield Fact(place, "enum errata", number)
    for value in enum.values:
        at = Place("enum", enum.name, hook=value.name)
        yield Fact(at, "value", value.name, "name")
        yield Fact(at, "value number", Fraction(value.value), "number")
        yield Fact(at, "value summary", value.summary, "meaning")
        yield from _since(at, "value since", value.since, "meaning")
        yield from _formerly(at, "value", value.aliases, "meaning")
        yield from _unconfirmed(at, "value", value.unconfirmed, "meaning")
        if value.former:
            yield from _since(at, "value changed", value.former.firmware, "meaning")
            yield Fact(at, "value changed", value.former.summary, "meaning")
        for number in value.errata:
            yield Fact(at, "value errata", number, "meaning")


def _packed(packed: Packed) -> Iterator[Fact]:
    place = Place("packed", packed.name)
    yield Fact(place, "packed", packed.name)
    yield Fact(place, "packed type", packed.scalar.name)
    yield Fact(place, "packed summary", packed.summary)
    yield Fact(place, "packed source", packed.source)
    if packed.names:
        yield Fact(place, "packed names", packed.names.name)
    for number in packed.errata:
        yield Fact(place, "packed errata", number)
    for part in packed.parts:
        yield Fact(place, "part", part.name)
        yield Fact(place, "part summary", part.summary)
        if part.enum:
            yield Fact(place, "part enum", part.enum.name)
        if part.quantity:
            yield Fact(place, "part quantity", part.quantity.name)
            if part.quantity.unit:
                yield Fact(place, "part unit", part.quantity.unit)
            if part.quantity.scale != 1:
                yield Fact(place, "part scale", part.quantity.scale)
        if part.signed:
            yield Fact(place, "part signed", "in two's complement")
        if part.sign:
            yield Fact(place, "part sign", Fraction(part.sign.bit_length() - 1))
        yield from _bits(place, part)


def _bits(place: Place, part: Part) -> Iterator[Fact]:
    if part.is_digits:
        for number in (part.divide, part.modulo):
            if number > 1:
                yield Fact(place, "part digits", Fraction(number))
        return
    bits = [bit for bit in range(part.mask.bit_length()) if part.mask >> bit & 1]
    for bit in (bits[0], bits[-1]):
        yield Fact(place, "part bits", Fraction(bit))


def _quantity(quantity: Quantity) -> Iterator[Fact]:
    place = Place("unit", quantity.name)
    yield Fact(place, "unit", quantity.name)
    yield Fact(place, "unit type", quantity.scalar.name)
    yield Fact(place, "unit summary", quantity.summary)
    yield Fact(place, "unit scale", quantity.scale)
    if quantity.unit:
        yield Fact(place, "unit unit", quantity.unit)
    if quantity.offset and not quantity.ratio:
        yield Fact(place, "unit offset", quantity.offset)
    for number in quantity.errata:
        yield Fact(place, "unit errata", number)


def _variables(layout: Layout) -> Iterator[Fact]:
    for variable in layout.variables:
        place = Place("variables", hook=variable.name)
        yield Fact(place, "variable", variable.name, "name")
        yield Fact(place, "variable id", Fraction(variable.id), "id")
        yield Fact(place, "variable type", variable.scalar.name, "type")
        yield Fact(place, "variable range", Fraction(variable.minimum), "range")
        yield Fact(place, "variable range", Fraction(variable.maximum), "range")
        yield Fact(place, "variable summary", variable.summary, "meaning")
        if variable.quantity:
            yield Fact(place, "variable unit", variable.quantity.name, "unit")
        yield from _since(place, "variable since", variable.since, "meaning")
        yield from _unconfirmed(place, "variable", variable.unconfirmed, "meaning")
        for setting in variable.settings:
            yield Fact(place, "variable setting", setting.path, "setting")
            yield Fact(place, "variable setting", setting.message, "setting")
        for number in variable.errata:
            yield Fact(place, "variable errata", number, "meaning")


def _errata(layout: Layout) -> Iterator[Fact]:
    for erratum in layout.errata:
        place = Place("errata", hook=erratum.number)
        yield Fact(place, "erratum", erratum.number)
        yield Fact(place, "erratum problem", erratum.problem)
        yield Fact(place, "erratum reading", erratum.reading)
        if erratum.reason:
            yield Fact(place, "erratum reason", erratum.reason)
        for line in erratum.lines:
            yield Fact(place, "erratum line", line)


def _commands(layout: Layout) -> Iterator[Fact]:
    for command in layout.commands:
        place = Place("commands", hook=command.name)
        yield Fact(place, "command", command.name)
        if command.id is not None:
            yield Fact(place, "command id", Fraction(command.id))
        yield Fact(place, "command summary", command.summary)
        yield from _since(place, "command since", command.since)
        yield from _formerly(place, "command", command.aliases)
        yield from _unconfirmed(place, "command", command.unconfirmed)
        for number in command.errata:
            yield Fact(place, "command errata", number)
