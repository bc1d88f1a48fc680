"""Resolves the response policies of requests."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from sbgcgen.model import Answer, AnswerCase, CorrelationField, Enum, Field
from sbgcgen.model import OptionalPart, Message, Position, Response, Result, Struct, scalar_of
from sbgcgen.spec.diagnostics import did_you_mean
from sbgcgen.spec.load import List, Map
from sbgcgen.spec.resolve.fields import FieldResolver
from sbgcgen.spec.resolve.roles import RoleResolver

# Limits of the runtime.
MAX_CORRELATION_FIELDS = 2
MAX_RESPONSES = 2


class AnswerResolver:
    """Resolves the `answer` of messages: answer() needs the message's own fields, settle() all messages."""

    def __init__(self, fields: FieldResolver) -> None:
        self.types = fields.types
        self.fields = fields
        self.found = fields.found
        self.roles = RoleResolver(self.types.versions.versions, self.found)
        self.defaults = fields.spec.main.get("defaults", {})
        self.nodes: dict[Position, Map] = {}  # resolved nodes, for positions of their keys

    def answer(self, node: Any, name: str, fields: tuple[Field, ...], at: Position) -> Answer:
        """Resolve the value of `answer:`; `node` is None if it is absent."""
        if node is None:
            hint = "say 'answer: none', or which message or confirmation answers it"
            self.found.add(at, "SBGC032", f"{name} does not state what answers it", hint)
        nodes = node if isinstance(node, list) else [node]
        places = node.items_at if isinstance(node, List) else [at]
        for index, (case, place) in enumerate(zip(nodes, places)):
            is_last = index == len(nodes) - 1
            if is_last == (isinstance(case, Map) and "when" in case):
                message = f"the last case of the answer of {name} has a condition"
                if not is_last:
                    message = f"a case of the answer of {name} has no condition"
                where = case.at("when") if isinstance(case, Map) and "when" in case else place
                hint = "every case but the last needs a 'when'; the last may be 'none'"
                self.found.add(where, "SBGC035", message, hint)
        return Answer(tuple(self._case(n, fields, p) for n, p in zip(nodes, places)))

    def _case(self, node: Any, fields: tuple[Field, ...], at: Position) -> AnswerCase:
        timeout = int(self.defaults.get("answer_timeout_ms", 0))
        if not isinstance(node, Map):
            return AnswerCase(None, (), "never", 0, timeout, 0, False, False, (), (), at=at)
        self.nodes[node.position] = node
        names = node.get("message", [])
        confirm = str(node.get("confirm", "never"))
        return AnswerCase(
            when=self.fields.references.condition(node, list(fields), ()),
            messages=tuple(str(n) for n in (names if isinstance(names, list) else [names])),
            confirm=confirm,
            confirmations=int(node.get("confirmations", 0 if confirm == "never" else 1)),
            timeout_ms=int(node.get("timeout_ms", timeout)),
            finish_ms=int(node.get("finish_ms", 0)),
            retry_safe=node.get("retry", "unsafe") == "safe",
            restarts=node.get("then") == "restart",
            correlation=tuple(str(name) for name in node.get("correlation", ())),
            errata=self.types.errata(node),
            series=str(node.get("series", "")),
            at=node.position,
        )

    def settle(self, messages: list[Message]) -> list[Message]:
        """Complete answers and roles with facts about the board's messages."""
        self.roles.check(messages)
        board = {m.name: m for m in messages if m.direction == "from_board"}
        confirmations = [m for m in messages if m.role and m.role.kind == "confirmation"]
        confirmation = confirmations[0] if confirmations else None
        streams = [m for m in messages if m.role and m.role.kind == "stream_request"]
        result = []
        for message in messages:
            answer, role = message.answer, message.role
            if answer is not None:
                cases = [self._settle(c, message, board, confirmation) for c in answer.cases]
                for stream in streams:
                    cases = [_with_configs(c, message, board, stream) for c in cases]
                answer = Answer(tuple(cases))
            if role is not None and role.messages:
                known = [
                    self._board(n, board, self.roles.nodes[role.at].at("messages"))
                    for n in role.messages
                ]
                samples = tuple(_response(message, m) for m in known if m is not None)
                role = replace(role, streams=samples)
            if answer is not message.answer or role is not message.role:
                message = replace(message, answer=answer, role=role)
            result.append(message)
        return result

    def _board(self, name: str, board: dict[str, Message], at: Position) -> Message | None:
        """The board's message with this name; reports an unknown one at `at`."""
        if name not in board:
            hint = did_you_mean(name, board) or "name a message under 'from_board'"
            self.found.add(at, "SBGC021", f"the board sends no message '{name}'", hint)
        return board.get(name)

    def _settle(
        self,
        case: AnswerCase,
        request: Message,
        board: dict[str, Message],
        confirmation: Message | None,
    ) -> AnswerCase:
        answers = [self._board(n, board, self.nodes[case.at].at("message")) for n in case.messages]
        responses = [_response(request, message) for message in answers if message is not None]
        if len(responses) > MAX_RESPONSES:
            text = f"{request.name} has {len(responses)} answers; {MAX_RESPONSES} are possible"
            at = self.nodes[case.at].at("message")
            self.found.add(at, "SBGC041", text, "let the forms of one message be one answer")
        by_name = {field.spec_name: field for field in request.fields}
        confirmed: CorrelationField | None = None
        at = self.nodes[case.at].at("correlation") if case.correlation else case.at
        for name in case.correlation:
            field = by_name.get(name)
            problem = _why_not_repeated(field)
            if field is None or problem:
                hint = did_you_mean(name, by_name) if field is None else ""
                hint = hint or "name a number of the request"
                self.found.add(at, "SBGC036", f"'{name}' of {request.name} {problem}", hint)
                continue
            found = False
            for index, message in enumerate(m for m in answers if m is not None):
                offset = _place(field, message.fields)
                if offset is None:
                    continue
                found = True
                repeated = CorrelationField(field, offset, _size_of_one(field))
                responses[index] = replace(
                    responses[index], correlation=(*responses[index].correlation, repeated)
                )
            if case.confirm != "never" and confirmation is not None:
                data = confirmation_data(confirmation, request.command)
                for other, offset in data:
                    if other.spec_name == field.spec_name and other.size == field.size:
                        found, confirmed = True, CorrelationField(field, offset, field.size or 0)
            if not found:
                text = f"no response of {request.name} has '{name}' at a fixed offset"
                hint = "a field of the same name and size, before the fields of varying size"
                self.found.add(at, "SBGC036", text, hint)
        if len(case.correlation) > MAX_CORRELATION_FIELDS:
            text = f"{len(case.correlation)} fields of {request.name} are repeated"
            self.found.add(at, "SBGC036", text, f"at most {MAX_CORRELATION_FIELDS} are possible")
        result = None
        if case.confirm != "never" and confirmation is not None:
            result = _result(confirmation, request.command)
        series_id = 0
        if case.series:
            series = self._board(case.series, board, self.nodes[case.at].at("series"))
            series_id = series.id if series else 0
        return replace(
            case,
            series_id=series_id,
            responses=tuple(responses),
            confirmation=confirmed,
            result=result,
        )


def _why_not_repeated(field: Field | None) -> str:
    if field is None:
        return "does not exist"
    scalar = scalar_of(field.type)
    is_one = field.dim in ("one", "counted") and not field.is_counter
    if not is_one or scalar is None or scalar.is_float or field.may_be_absent:
        return "is not an integer that is always present"
    return ""


def _size_of_one(field: Field) -> int:
    """The size of an integer, or of an element of a list of integers."""
    scalar = scalar_of(field.type)
    return scalar.size if scalar else 0


def _place(field: Field, fields: tuple[Field, ...]) -> int | None:
    """The offset of the response's field with this name and size; None unless always present.

    The first element of a list is repeated in the first entry of the response's list.
    """
    for other in fields:
        if other.dim == field.dim == "counted" and isinstance(other.type, Struct):
            inner = next((f for f in other.type.fields if f.spec_name == field.spec_name), None)
            if inner and inner.dim == "one" and inner.size == _size_of_one(field):
                known = other.offset is not None and inner.offset is not None
                return (other.offset or 0) + (inner.offset or 0) if known else None
        if (other.spec_name, other.dim, other.size) == (field.spec_name, "one", field.size):
            return None if other.may_be_absent else other.offset
    return None


def confirmation_data(confirmation: Message, command: str) -> Iterator[tuple[Field, int]]:
    """The fields that a confirmation of `command` can have, with their offsets."""
    assert confirmation.role is not None
    names = confirmation.role.parts["command"].name
    offset = 0
    for field in confirmation.fields:
        if field.size is None or field.appended:
            return
        if field.when is None:
            offset += field.size
        elif field.when.source == names and command in [v.name for v in field.when.values]:
            yield field, offset
            offset += field.size


def _result(confirmation: Message, command: str) -> Result | None:
    for field, offset in confirmation_data(confirmation, command):
        if isinstance(field.type, Enum) and field.type.success:
            return Result(field, offset, field.size or 0, field.type.success)
    return None


def _response(request: Message, message: Message) -> Response:
    """The board's message as a response to this request."""
    known = {
        context.name: path
        for context in message.contexts
        for name, path in context.sources
        if name == request.name
    }
    growth = []
    for field in message.fields:
        when = field.when
        if when and when.from_context and when.source in known and field.size is not None:
            path = known[when.source]
            growth.append(OptionalPart(path, _is_optional(path, request.fields), when, field.size))
    return Response(
        message=message.name,
        id=message.id,
        is_error=message.form == "error",
        min_size=message.min_size,
        max_size=message.max_size,
        is_open=message.keeps_tail or message.is_open,
        growth=tuple(growth),
    )


def _with_configs(
    case: AnswerCase, request: Message, board: dict[str, Message], stream: Message
) -> AnswerCase:
    responses = [
        replace(r, config=_config(request, board[r.message], stream)) for r in case.responses
    ]
    return replace(case, responses=tuple(responses))


def _config(
    request: Message, message: Message, stream: Message
) -> tuple[CorrelationField, ...] | None:
    """The fields of the request that configure the stream with samples like its answer, `message`."""
    role = stream.role
    assert role is not None
    whole = role.parts["config"]
    if message.name not in role.messages or not isinstance(whole.type, Struct):
        return None
    origin = {(name, path): c.name for c in message.contexts for name, path in c.sources}
    own = {
        origin[request.name, f.name]: f for f in request.fields if (request.name, f.name) in origin
    }
    found: list[CorrelationField] = []
    offset = 0
    for field in whole.type.fields:
        is_rest = field.when is None and field.dim == "rest"
        if is_rest or (field.when and message.command not in [v.name for v in field.when.values]):
            continue
        same = own.get(origin.get((stream.name, f"{whole.name}.{field.name}"), ""))
        if same is None or same.size is None or same.size != field.size:
            return None
        found.append(CorrelationField(same, offset, same.size))
        offset += same.size
    used = [f.field for f in found]
    return tuple(found) if all(f in used or f.reserved for f in request.fields) else None


def _is_optional(path: str, fields: tuple[Field, ...]) -> bool:
    """True if the value at a path may be missing."""
    first, _, rest = path.partition(".")
    field = next((f for f in fields if f.name == first), None)
    if field is None or field.may_be_absent:
        return True
    return isinstance(field.type, Struct) and _is_optional(rest, field.type.fields)
