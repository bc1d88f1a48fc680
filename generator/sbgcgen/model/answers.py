"""What a request is answered with, and what a message is in the conversation."""

from __future__ import annotations

from dataclasses import dataclass, field

from sbgcgen.model.position import NOWHERE, Position
from sbgcgen.model.bodies import Condition, Field
from sbgcgen.model.values import EnumValue


@dataclass(frozen=True)
class CorrelationField:
    """A number of the request that stands again in what answers it, `offset` bytes from its start.

    A special value of the request's `field` is not repeated.
    """

    field: Field
    offset: int
    size: int


@dataclass(frozen=True)
class Growth:
    """`size` bytes that a body has if `when` holds for the value at `path` of the request.

    `optional`: that value may be missing; then it does not hold.
    """

    path: str
    optional: bool
    when: Condition
    size: int


@dataclass(frozen=True)
class Response:
    """One message of the board that answers a request, or that it makes the board send."""

    message: str
    id: int
    is_error: bool
    min_size: int
    max_size: int
    is_open: bool
    correlation: tuple[CorrelationField, ...] = ()
    growth: tuple[Growth, ...] = ()


@dataclass(frozen=True)
class Result:
    """The place in the data of a confirmation that tells whether the request has succeeded."""

    field: Field
    offset: int
    size: int
    success: EnumValue


@dataclass(frozen=True)
class AnswerCase:
    """What a request is answered with, if `when` holds for it.

    `correlation` are the fields that are repeated. `responses`, `confirmation` (what the data of a
    confirmation repeat) and `result` follow from them and from the messages of the board.
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
    responses: tuple[Response, ...] = ()
    confirmation: CorrelationField | None = None
    result: Result | None = None
    at: Position = field(default=NOWHERE, compare=False, repr=False)


@dataclass(frozen=True)
class Answer:
    """What a request is answered with: the first case that holds; the last one always does."""

    cases: tuple[AnswerCase, ...]

    @property
    def messages(self) -> tuple[str, ...]:
        """All messages that may answer."""
        return tuple(dict.fromkeys(name for case in self.cases for name in case.messages))

    @property
    def confirm(self) -> str:
        """What holds of all cases: "always", "never", "unlikely" at most, or else "possible"."""
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
        """Whether one of the messages comes in every case."""
        return all(case.messages for case in self.cases)


@dataclass(frozen=True)
class Role:
    """What a message is in the conversation (`kind`), and which of its fields tell what about it.

    A board restarts `delay_ms` after its reset message.
    `streams` are the messages that a stream request makes the board send; its interval is in units
    of `interval_us`, `end` ends the stream and `cycle` stands for `cycle_us`. There are at most
    `limit` streams at a time over all ports; 0 if that is not known.
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
