"""All facts of the model that a reference has to document, and where a reader looks for them."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from operator import attrgetter
from typing import Any, Optional, Protocol, Union

from sbgcgen.views.words import default_words, rules_in, versions
from sbgcgen.model import AnswerCase, Availability, Command, Condition, Effect, Enum, Erratum, Field
from sbgcgen.model import Layout, Leaf, Message, Packed, Part, Quantity, Variable

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
    parts: tuple[tuple[Callable[[Any], Iterator[Fact]], Iterable[Any]], ...] = (
        (facts_of_message, layout.messages),
        (_enum, layout.enums),
        (_packed, layout.packed),
        (_quantity, layout.quantities),
        (_variable, layout.variables),
        (_erratum, layout.errata),
        (_command, layout.commands),
    )
    for facts_of, things in parts:
        for thing in things:
            yield from facts_of(thing)


def _plain(place: Place, kind: str, thing: object, attributes: str) -> Iterator[Fact]:
    """Yields the attributes `path@column` of a thing that are said: each a text, a number, or several of them.

    The kind of the first is that of the thing.
    """
    for number, word in enumerate(attributes.split()):
        path, _, column = word.partition("@")
        found = attrgetter(path)(thing)
        for one in found if isinstance(found, tuple) else (found,):
            if one not in (None, ""):
                wanted: Wanted = one if isinstance(one, str) else Fraction(one)
                yield Fact(place, f"{kind} {path}" if number else kind, wanted, column)


def _common(place: Place, kind: str, thing: Any, column: str = "") -> Iterator[Fact]:
    """Its first versions, former names, doubts, deprecation and errata, as far as it can have them."""
    yield from _since(place, f"{kind} since", getattr(thing, "since", None), column)
    for alias in getattr(thing, "aliases", ()):
        yield Fact(place, f"{kind} formerly", alias.spec_name, column)
    if getattr(thing, "unconfirmed", False):
        yield Fact(place, f"{kind} unconfirmed", "unconfirmed", column, re.IGNORECASE)
    if deprecated := getattr(thing, "deprecated", None):
        yield Fact(place, f"{kind} deprecated", "deprecated", column, re.IGNORECASE)
        yield from _since(place, f"{kind} deprecated since", deprecated.since, column)
        if deprecated.replaced_by:
            yield Fact(place, f"{kind} replaced by", deprecated.replaced_by, column)
    for number in getattr(thing, "errata", ()):
        yield Fact(place, f"{kind} errata", number, column)


def _since(
    place: Place, kind: str, since: Optional[Availability], column: str = ""
) -> Iterator[Fact]:
    for word in versions(since).split(", ") if since else ():
        yield Fact(place, kind, word, column)


def facts_of_message(message: Message) -> Iterator[Fact]:
    """Yields the facts on the page of a message."""
    place = Place("message", message.name, message.direction)
    words = "name command id summary source min_size max_size description form stores"
    yield from _plain(place, "message", message, words)
    yield from _common(place, "message", message)
    for since, size in message.lengths:
        yield Fact(place, "message size of a firmware", Fraction(size))
        yield from _since(place, "message size of a firmware", since)
    for rule in rules_in(message.body):
        for name in (*rule.replace("<=", "<").split(" < "), re.findall("<=?", rule)[0]):
            yield Fact(place, "rule", name)
    if message.until:
        yield from _since(place, "message until", message.until.versions)
        yield from _plain(place, "message instead", message.until, "instead")
    for case in message.answer.cases if message.answer else ():
        yield from _answer(place, case)
    if message.effect:
        yield from _effect(place, message.effect)
    if message.role and message.role.messages:
        yield from _plain(place, "message streams", message.role, "messages")
        if message.role.limit:
            yield Fact(place, "message stream limit", Fraction(message.role.limit))
    for context in message.contexts:
        yield from _plain(place, "context", context, "name summary")
        for source in (word for pair in context.sources for word in pair):
            yield Fact(place, "context source", source)
        if context.announced:
            yield Fact(place, "context source", context.announced.message)
    for outer in message.leaves:
        for leaf in (outer, *outer.cases):
            yield from _leaf(message, leaf)


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


def _effect(place: Place, effect: Effect) -> Iterator[Fact]:
    for case in effect.cases:
        for kind in effect.known:
            if kind.word in case.words:
                yield Fact(place, "message effect", kind.summary)
        if case.when:
            yield from _condition(place, "message effect condition", case.when)


def _answer(place: Place, case: AnswerCase) -> Iterator[Fact]:
    if case.when:
        yield from _condition(place, "answer condition", case.when)
    yield from _plain(place, "answer", case, "messages errata")
    if case.messages or case.confirm == "always":
        times = f"timeout_ms {'finish_ms' if case.finish_ms else ''}"
        yield from _plain(place, "answer timeout", case, times)
    if case.confirmations > 1:
        yield Fact(place, "answer confirmations", Fraction(case.confirmations))
    for name in case.correlation:
        yield Fact(place, "answer echo", name)
    if case.result:
        yield Fact(place, "answer result", case.result.success.name)


def _leaf(message: Message, leaf: Leaf) -> Iterator[Fact]:
    place = Place("message", message.name, message.direction, leaf.path)
    field = leaf.field
    yield from _plain(place, "field", leaf, "path@field offset@offset")
    yield Fact(place, "field spec name", leaf.spec_name, "spec name", re.IGNORECASE)
    if field.type.kind != "announced":
        yield Fact(place, "field type", leaf.type, "type")
    if leaf.count not in (None, 1):
        yield from _plain(place, "field count", leaf, "count@type")
    words = "summary@meaning counter@meaning variable@meaning"
    yield from _plain(place, "field summary", field, words)
    yield from _common(place, "field", field, "meaning")
    if isinstance(field.type, Quantity):
        yield from _unit(place, "field", field.type, "unit")
    if field.directions is not None:
        positive = (leaf.direction and leaf.direction.positive) or "unknown"
        yield Fact(place, "field direction", positive)
    if isinstance(field.type, (Enum, Packed)):
        yield Fact(place, "field enum", field.type.name, "unit")
    for limit in (field.minimum, field.maximum):
        if limit is not None:
            yield Fact(place, "field range", limit, "range")
    for special in field.special:
        words = "value@meaning meaning@meaning name@meaning"
        yield from _plain(place, "field special", special, words)
    if field.reserved:
        yield Fact(place, "field reserved", "reserved", "meaning", re.IGNORECASE)
    if not field.index:  # else each element has its own row
        counts = f"{'min_count@meaning' if field.min_count else ''} max_count@meaning"
        yield from _plain(place, "field elements", field, counts)
    if field.align != 1:
        yield Fact(place, "field alignment", Fraction(field.align), "meaning")
    if field.counter and field.counting != "elements":
        word = {"bytes": "bytes", "minus_1": "minus 1", "bits": "each bit that is set"}
        yield Fact(place, "field counting", word[field.counting], "meaning")
    if field.when:
        yield from _condition(place, "field condition", field.when, "meaning")
    if field.alternative:
        words = "flag.name@meaning quantity.name@meaning"
        yield from _plain(place, "field other unit", field.alternative, words)
    yield from _before(place, field, message)
    yield from _default(place, field)


def _before(place: Place, field: Field, message: Message) -> Iterator[Fact]:
    """The facts about bodies from firmware without the field."""
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


def _unit(place: Place, kind: str, quantity: Quantity, column: str = "") -> Iterator[Fact]:
    yield Fact(place, f"{kind} quantity", quantity.name, column)
    if quantity.unit:
        yield Fact(place, f"{kind} unit", quantity.unit, column)
    if quantity.scale != 1:
        yield Fact(place, f"{kind} scale", quantity.scale, column)
    if quantity.offset and kind == "field":
        yield Fact(place, f"{kind} scale", quantity.offset, column)


def _enum(enum: Enum) -> Iterator[Fact]:
    place = Place("enum", enum.name)
    yield from _plain(place, "enum", enum, "name scalar.name summary source errata")
    for value in enum.values:
        at = Place("enum", enum.name, hook=value.name)
        yield from _plain(at, "value", value, "name@name value@number summary@meaning")
        yield from _common(at, "value", value, "meaning")
        if value.former:
            yield from _since(at, "value changed", value.former.firmware, "meaning")
            yield Fact(at, "value changed", value.former.summary, "meaning")


def _packed(packed: Packed) -> Iterator[Fact]:
    place = Place("packed", packed.name)
    yield from _plain(place, "packed", packed, "name scalar.name summary source errata")
    if packed.names:
        yield Fact(place, "packed names", packed.names.name)
    for part in packed.parts:
        yield from _plain(place, "part", part, "name summary")
        if part.enum:
            yield Fact(place, "part enum", part.enum.name)
        if part.quantity:
            yield from _unit(place, "part", part.quantity)
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
    yield from _plain(place, "unit", quantity, "name scalar.name summary scale unit errata")
    if quantity.offset and not quantity.ratio:
        yield Fact(place, "unit offset", quantity.offset)


def _variable(variable: Variable) -> Iterator[Fact]:
    place = Place("variables", hook=variable.name)
    words = "name@name id@id scalar.name@type minimum@range maximum@range summary@meaning"
    yield from _plain(place, "variable", variable, words)
    yield from _common(place, "variable", variable, "meaning")
    if variable.quantity:
        yield Fact(place, "variable unit", variable.quantity.name, "unit")
    for setting in variable.settings:
        yield from _plain(place, "variable setting", setting, "path@setting message@setting")


def _erratum(erratum: Erratum) -> Iterator[Fact]:
    words = "number problem reading reason lines"
    yield from _plain(Place("errata", hook=erratum.number), "erratum", erratum, words)


def _command(command: Command) -> Iterator[Fact]:
    place = Place("commands", hook=command.name)
    yield from _plain(place, "command", command, "name id summary")
    yield from _common(place, "command", command)
