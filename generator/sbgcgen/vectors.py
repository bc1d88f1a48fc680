"""Test vectors: bodies and what they say, by the reference codec, for codecs in any language.

`generated/vectors/<family>.jsonl` has one vector a line: {"message", "command", "id", "direction",
"hex", "fields", "why"}. What else a line may have: "context" (raw values that the body can not be
read without) with "after" (messages that tell them), and "error" instead of what there is none of:
without "fields" the body does not decode, without "hex" the fields do not encode.
"""

from __future__ import annotations

import json
import zlib
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import Any

from sbgcgen.compose import Choice, compose
from sbgcgen.edges import Edge
from sbgcgen.model import Condition, Context, Field, Layout, Message, Struct
from sbgcgen.reference_codec import CodecError, Fields, choose_message, decode, encode


@dataclass(frozen=True)
class Vector:
    """One line; see the text above."""

    message: Message | None
    id: int
    direction: str
    why: str
    body: bytes | None
    fields: Fields | None = None
    context: Fields = field(default_factory=dict)
    error: CodecError | None = None

    def line(self, layout: Layout) -> str:
        """The vector as JSON."""
        names = [c.name for c in layout.commands if c.id == self.id]
        command = self.message.command if self.message else names[0] if names else None
        result: dict[str, Any] = {
            "message": self.message.name if self.message else None,
            "command": command,
            "id": self.id,
            "direction": self.direction,
        }
        if self.context and self.message:
            result["context"] = self.context
            result["after"] = list(_telling(layout, self.message.contexts, self.context))
        if self.body is not None:
            result["hex"] = self.body.hex()
        if self.fields is not None:
            result["fields"] = self.fields
        if self.error:
            error = self.error
            result["error"] = {"code": error.code, "field": error.field, "offset": error.offset}
        result["why"] = self.why
        return json.dumps(result, separators=(",", ":"))


def files(layout: Layout) -> Iterator[tuple[str, bytes]]:
    """The vector files by their path below generated/."""
    bodies: set[int] = set()
    for family in layout.families:
        found: list[Vector] = []
        for message in family.messages:
            found += of_message(message, id(message.body) in bodies)
            bodies.add(id(message.body))
        if found:
            yield f"vectors/{family.name}.jsonl", _lines(layout, found)
    yield "vectors/unknown.jsonl", _lines(layout, _of_no_message(layout))


def _lines(layout: Layout, vectors: Iterable[Vector]) -> bytes:
    return "".join(f"{vector.line(layout)}\n" for vector in vectors).encode()


def of_message(message: Message, is_known: bool = False) -> list[Vector]:
    """The vectors of a message; only a few if another one has had all those of its body."""
    maker = _Maker(message)
    maker.uniform()
    if is_known:
        maker.add(maker.choice(context=maker.everything()))
    else:
        maker.rounds()
        maker.lengths()
        maker.random()
    maker.tails()
    maker.truncated()
    return maker.vectors


class _Maker:
    """Collects the vectors of one message, none twice."""

    def __init__(self, message: Message) -> None:
        self.message = message
        self.vectors: list[Vector] = []
        self.seen: set[str] = set()
        self.places = Places()

    # What is made

    def uniform(self) -> None:
        """Nothing but zeros, nothing but ones."""
        for name, byte in (("zeros", b"\x00"), ("ones", b"\xff")):
            self.add_body(byte * self.message.min_size, {}, f"all {name}")

    def rounds(self) -> None:
        """Every field at each of its edges, all fields of a message at once.

        Neighbours are at different edges, so a field that is read from a wrong place shows. Then
        each condition is made to hold, for as many rounds as what hangs on it needs.
        """
        last = self.choice()
        self.add(last)
        while last.round + 1 < last.rounds_of_free:
            last = self.choice(round=last.round + 1)
            self.add(last)
        for case in self.cases():
            last = self.choice(**case)
            self.add(last)
            while last.round + 1 < last.rounds_of_conditional:
                last = self.choice(round=last.round + 1, **case)
                self.add(last)
            if any(when.may_be_missing for when in conditions(self.message)):
                self.add(self.choice(short=True, leave_out=True, **case))
        if self.message.contexts:
            self.add(self.choice(context=self.everything()))

    def lengths(self) -> None:
        """Lists and texts that are empty, of one element, as long as documented, as can be."""
        for path, member in variable_parts(self.message.fields):
            case: dict[str, Any] = {"context": self.everything()}
            if member.when and not member.when.from_context:
                case["forced"] = {member.when.source: satisfying(member.when)[0]}
            if member.dim in ("counted", "rest") and not path.endswith("[]"):
                documented = documented_length(self.message.fields, member)
                lengths = {0, 1, documented, member.capacity}
            else:
                empty = compose(self.message, self.choice(short=True, lengths={path: 0}, **case))
                lengths = {0, 1, 255 - len(encode(self.message, empty))}
            for length in sorted(lengths):
                choice = self.choice(short=True, lengths={path: length}, **case)
                self.add(choice, f"{path} of length {length}")

    def random(self) -> None:
        """Bodies of any bytes, some of which mean nothing."""
        numbers = _Random(zlib.crc32(f"{self.message.direction} {self.message.name}".encode()))
        for number in (1, 2):
            size = numbers.between(self.message.min_size, self.message.max_size)
            body = bytes(numbers.between(0, 255) for _ in range(size))
            self.add_body(body, self.everything(), f"random {number}")

    def tails(self) -> None:
        """What later firmware appends: one byte, and as much as fits."""
        if not self.message.keeps_tail:
            return
        context = self.everything()
        body = encode(self.message, compose(self.message, self.choice(short=True, context=context)))
        for size in sorted({1, 255 - len(body)}):
            tail = bytes((251 * i + 165) % 256 for i in range(size))
            self.add_body(body + tail, context, f"{size} more bytes than are known")

    def truncated(self) -> None:
        """Bodies that end too early, one for each way that is reported, and one too long."""
        context = self.everything()
        choice = self.choice(context=context)
        whole = encode(self.message, compose(self.message, choice))
        reported: set[tuple[str, str]] = set()
        for size in (len(whole) + 1, *range(len(whole) - 1, -1, -1)):
            body = (whole + b"\x5a")[:size]
            try:
                decode(self.message, body, context)
            except CodecError as error:
                if (error.code, error.field) not in reported:
                    reported.add((error.code, error.field))
                    self.add_body(body, context, f"{size} bytes instead of {len(whole)}")

    # What it is made from

    def choice(self, **options: Any) -> Choice:
        """A choice for this message."""
        return Choice(self.places, **options)

    def cases(self) -> Iterator[dict[str, Any]]:
        """For each condition, what makes it hold."""
        seen = []
        for when in conditions(self.message):
            for value in satisfying(when):
                key = "context" if when.from_context else "forced"
                case = {key: {when.source: value}}
                if case not in seen:
                    seen.append(case)
                    yield case

    def everything(self) -> Fields:
        """A context in which all that hangs on flags is there."""
        context: Fields = {}
        for when in conditions(self.message):
            if when.from_context:
                context[when.source] = context.get(when.source, 0) | when.mask
        return context

    # How it is added

    def add(self, choice: Choice, why: str = "") -> None:
        """Add what comes out of composing; if it does not fit into a body, as an error."""
        fields = compose(self.message, choice)
        why = why or choice.why()
        try:
            body = encode(self.message, fields)
        except CodecError as error:
            self._add(Vector(self.message, why, None, fields, choice.context, error))
        else:
            self.add_body(body, choice.context, why)

    def add_body(self, body: bytes, context: Fields, why: str) -> None:
        """Add a body and what it decodes to, be it an error."""
        try:
            fields = decode(self.message, body, context)
        except CodecError as error:
            self._add(Vector(self.message, why, body, None, context, error))
        else:
            self._add(Vector(self.message, why, body, fields, context))

    def _add(self, vector: Vector) -> None:
        key = repr((vector.body if vector.body is not None else vector.fields, vector.context))
        if key not in self.seen:
            self.seen.add(key)
            self.vectors.append(vector)


class _Random:
    """A linear congruential generator, the same in every version of Python."""

    def __init__(self, seed: int) -> None:
        self.state = seed

    def between(self, low: int, high: int) -> int:
        """A number from low to high."""
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % (1 << 64)
        return low + (self.state >> 33) % (max(low, high) - low + 1)


def _of_no_message(layout: Layout) -> Iterator[dict[str, Any]]:
    """Bodies that are no message: sizes that fit no form, ids that a direction does not know."""
    for direction in ("from_board", "to_board"):
        known = {m.id for m in layout.messages if m.direction == direction}
        other = {m.id for m in layout.messages if m.direction != direction} - known
        unused = set(range(1, 256)) - known - other
        for number in (*sorted(known), *sorted(other)[:1], *sorted(unused)[:1], *sorted(unused)[-1:]):
            for size in range(layout.framing.max_body + 1):
                try:
                    choose_message(layout, direction, number, size)
                except CodecError as error:
                    ...
