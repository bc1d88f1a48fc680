"""Response policies of requests, and the roles of messages in the conversation."""

from __future__ import annotations

from dataclasses import dataclass, field

from sbgcgen.model.position import NOWHERE, Position
from sbgcgen.model.bodies import Field
from sbgcgen.model.conditions import Condition
from sbgcgen.model.values import EnumValue


@dataclass(frozen=True)
class CorrelationField:
    """An integer field of the request that the response repeats, `offset` bytes from its start.

    A special value of the request's `field` is not repeated. For a list, it is the first element.
    """

    field: Field
    offset: int
    size: int


@dataclass(frozen=True)
class OptionalPart:
    """`size` more bytes of a body if `when` holds for the value at `path` of the request.

    If that value is optional (`optional`) and missing, the condition is false.
    """

    path: str
    optional: bool
    when: Condition
    size: int


@dataclass(frozen=True)
class Response:
    """One message of the board that answers a request or belongs to a stream that it starts.

    `config` are the fields of the request that form the configuration of the stream whose samples
    have the same content; None if there is no such stream.
    """

    message: str
    id: int
    is_error: bool
    min_size: int
    max_size: int
    is_open: bool
    correlation: tuple[CorrelationField, ...] = ()
    growth: tuple[OptionalPart, ...] = ()
    config: tuple[CorrelationField, ...] | None = None


@dataclass(frozen=True)
class Result:
    """The value in the data of a confirmation that reports success or failure of the request."""

    field: Field
    offset: int
    size: int
    success: EnumValue


@dataclass(frozen=True)
class AnswerCase:
    """The response policy of a request for which `when` holds.

    `correlation` names the fields that responses repeat. `responses`, `confirmation` (the field
    that a confirmation repeats in its data) and `result` are derived from it and the board's
    messages. `series` names a message that comes before the response, any number of times, and
    `series_id` is its id; "" and 0 if there is none.
    """

    when: Condition | None
    messages: tuple[str, ...]
    confirm: str
    confirmations: int
    timeout_ms: int
    finish_ms: int
    retry_safe: bool
    restarts: bool
    correlation: tuple[str, ...]
    errata: tuple[str, ...]
    series: str = ""
    series_id: int = 0
    responses: tuple[Response, ...] = ()
    confirmation: CorrelationField | None = None
    result: Result | None = None
    at: Position = field(default=NOWHERE, compare=False, repr=False)


@dataclass(frozen=True)
class Answer:
    """The response policy of a request: the first matching case. The last case always matches."""

    cases: tuple[AnswerCase, ...]

    @property
    def messages(self) -> tuple[str, ...]:
        """All messages that may answer the request."""
        return tuple(dict.fromkeys(name for case in self.cases for name in case.messages))

    @property
    def alike(self) -> Response | None:
        """The only answer, if it has the content of a stream's samples."""
        found = [r for case in self.cases for r in case.responses]
        return found[0] if len(found) == 1 and found[0].config is not None else None

    @property
    def confirm(self) -> str:
        """The common value of all cases; if they differ, "unlikely" (with "never") or "possible"."""
        said = {case.confirm for case in self.cases}
        if said == {"never", "unlikely"}:
            return "unlikely"
        return said.pop() if len(said) == 1 else "possible"

    @property
    def confirmations(self) -> int:
        return max(case.confirmations for case in self.cases)

    @property
    def timeout_ms(self) -> int:
        return max(case.timeout_ms for case in self.cases)

    @property
    def retry_safe(self) -> bool:
        return all(case.retry_safe for case in self.cases)

    @property
    def errata(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys(number for case in self.cases for number in case.errata))

    @property
    def is_certain(self) -> bool:
        """True if every case has a message as its response."""
        return all(case.messages for case in self.cases)


@dataclass(frozen=True)
class Role:
    """The role of a message in the conversation (`kind`), and the fields that it needs (`parts`).

    A board restarts `delay_ms` after its reset message.
    `streams` are the messages that a stream request can start. Its interval is in units of
    `interval_us`; the interval `end` ends the stream, and `cycle` stands for `cycle_us`. The board
    has at most `limit` streams over all ports; 0 if the limit is unknown.
    """

    kind: str
    parts: dict[str, Field] = field(hash=False)
    messages: tuple[str, ...] = ()
    streams: tuple[Response, ...] = ()
    interval_us: int = 0
    end: int = 0
    cycle: int | None = None
    cycle_us: int = 0
    limit: int = 0
    delay_ms: int = 0
    at: Position = field(default=NOWHERE, compare=False, repr=False)
