"""Compares commands and messages: their correspondence, and the answers and effects of requests."""

from __future__ import annotations

from dataclasses import replace
from typing import Optional

from sbgcgen.compat.changes import COMPATIBLE, MEANING, SOURCE, WIRE, Level
from sbgcgen.compat.difference import Each, Pair, Row
from sbgcgen.compat.fields import compare_fields, compare_rules
from sbgcgen.compat.wire import places
from sbgcgen.model import Answer, AnswerCase, Command, Effect, EffectCase, Message, Until

Key = tuple[str, str, Optional[str]]


def compare_commands(layouts: Pair) -> None:
    """Compare commands and their messages; a renamed command keeps its id and directions."""
    ways: dict[str, set[str]] = {}
    for message in (*layouts.old.messages, *layouts.new.messages):
        ways.setdefault(message.command, set()).add(message.direction)

    def content(command: Command) -> object:
        return None if command.id is None else (command.id, ways.get(command.name))

    commands = Each("commands", "command ", WIRE, shown="id", content=content, renamed=_renamed)
    names = {}
    for pair in commands.pairs(layouts):
        names[pair.old.name] = pair.new.name
        pair.compare()
    _compare_messages(layouts, names)


def _renamed(old: Command, new: Command) -> Level:
    """The former name of a command may stay as an alias."""
    is_known = old.identifier in {new.identifier, *(alias.name for alias in new.aliases)}
    return COMPATIBLE if is_known else SOURCE


def _compare_messages(layouts: Pair, commands: dict[str, str]) -> None:
    """Compare the messages, with the new name of each old command."""
    changes = layouts.changes
    left = {(m.command, m.direction, m.form): m for m in layouts.new.messages}
    pairs, without = [], []
    for message in layouts.old.messages:
        key = (commands.get(message.command, ""), message.direction, message.form)
        if key in left:
            pairs.append((message, left.pop(key)))
        else:
            without.append(message)
    for message in without:
        twin = _other_form(message, commands.get(message.command, ""), left)
        if twin is None:
            shown = f"{message.direction}, {message.id}"
            changes.deleted(WIRE, f"message {message.name}", message.at, shown)
            continue
        pairs.append((message, left.pop((twin.command, twin.direction, twin.form))))
        layouts.inner(f"message {twin.name}", message, twin, at=twin.at).compare(OTHER_FORM)
    for message in left.values():
        changes.added(f"message {message.name}", message.at, message.direction)
    names = {before.name: now.name for before, now in pairs}
    bodies: set[tuple[int, int]] = set()
    for before, now in pairs:
        layouts.inner(f"message {now.name}", before, now, at=now.at, names=names).compare()
        if (id(before.body), id(now.body)) not in bodies:
            bodies.add((id(before.body), id(now.body)))
            owner = layouts.inner(now.name, before.body, now.body)
            compare_rules(owner)
            compare_fields(owner, before.fields, now.fields, before.keeps_tail)


def _other_form(message: Message, command: str, left: dict[Key, Message]) -> Message | None:
    """Find the same message as another form or in the other direction, by name or body."""
    candidates = [m for m in left.values() if m.command == command]
    same_way = [m for m in candidates if m.direction == message.direction]
    found = [m for m in candidates if m.name == message.name]
    found += [m for m in same_way if places(m.fields) == places(message.fields)]
    found += same_way if len(same_way) == 1 and message.form is None else []
    return found[0] if found else None


# Adding forms to a command with a single form changes no body.
OTHER_FORM = (
    Row("direction", WIRE),
    Row("form", lambda old, new: COMPATIBLE if {old, new} == {None, "simple"} else WIRE),
)


# Facts about messages


def contexts(message: Message) -> list[object]:
    """The facts that a message needs from earlier ones."""
    return [(c.name, c.type.name if c.type else None) for c in message.contexts]


def sources(message: Message) -> list[object]:
    """The sources of these facts."""
    return [(c.sources, c.announced) for c in message.contexts]


def lengths(message: Message) -> tuple[object, ...]:
    """The properties that determine the largest size of a body, apart from `max_size`."""
    limits = [(field.max_count, field.maximum) for field in message.fields]
    return (places(message.fields), limits)


def stops(message: Message) -> list[list[str]]:
    """The patterns of values that stop all motion, by the names of the protocol."""
    names = {leaf.path: leaf.spec_name for leaf in message.leaves}
    return [
        sorted(f"{names.get(v.path, v.path)} & {v.mask:#x} = {v.value}" for v in pattern)
        for pattern in message.stops
    ]


def compare_ends(messages: Pair) -> None:
    """Compare the versions that no longer accept a message, and its replacement."""
    old, new = messages.both("until")
    if old is not None:
        old = replace(old, instead=messages.names.get(old.instead, old.instead))
    messages.mark(MEANING, "until", *(until and _end(until) for until in (old, new)))


def _end(until: Until) -> list[object]:
    return [until.versions, *([f"then {until.instead}"] if until.instead else [])]


def compare_roles(messages: Pair) -> None:
    """Compare roles, which programs use to find messages."""
    old, new = messages.both("role")
    if old and new and old.kind == new.kind:
        roles = messages.inner(": role", old, new)
        for part in sorted({*old.parts, *new.parts}):
            level = MEANING if part in old.parts else COMPATIBLE
            names = (r.parts[part].spec_name if part in r.parts else "" for r in (old, new))
            roles.mark(level, part, *names)
        roles.compare()


# Answers

NO_ANSWER = Answer((AnswerCase(None, (), "never", 0, 0, 0, False, False, (), ()),))


def compare_answers(messages: Pair) -> None:
    """A client must still receive each response, and a safe retry must stay safe."""
    answers = messages.inner("", *(answer or NO_ANSWER for answer in messages.both("answer")))
    old, new = answers.old, answers.new
    names, now = [messages.names.get(name, name) for name in old.messages], new.messages
    was_silent = not names and old.confirm == "never"
    level = MEANING if set(names) - set(now) or was_silent else COMPATIBLE
    answers.mark(level, "answered by", sorted(names), sorted(now))
    answers.compare()
    if conditions(old) != conditions(new):
        return
    for number, (before, now) in enumerate(zip(old.cases, new.cases), 1):
        case = answers.inner(f": case {number}" if len(new.cases) > 1 else "", before, now)
        if len(new.cases) > 1:
            names = [messages.names.get(name, name) for name in before.messages]
            case.mark(MEANING, "answered by", sorted(names), sorted(now.messages))
            case.compare((CONFIRMED,))
        case.compare()


def confirmation_level(old: str, new: str) -> Level:
    """Clients do not wait for uncertain confirmations, so their likelihood may change."""
    return COMPATIBLE if old != "always" and new in ("unlikely", "possible") else MEANING


CONFIRMED = Row("confirmed", confirmation_level, "confirm")


def conditions(answer: Answer) -> list[str]:
    """The conditions of an answer in words."""
    return [_condition_words(case) for case in answer.cases]


def _condition_words(case: AnswerCase | EffectCase) -> str:
    """The condition of a case in words; "else" if it has none."""
    return case.when.words if case.when else "else"


# Effects


def compare_effects(messages: Pair) -> None:
    """Programs may rely on the effect, for example to confirm requests that move the camera.

    New values of an enum may have any effect.
    """
    old, new = messages.both("effect")
    before, now = ([_effect_words(c) for c in e.cases] if e else [] for e in (old, new))
    level = MEANING if before else COMPATIBLE
    values = _effects_by_value(old, new) if before != now else {}
    changed = {name: words for name, words in values.items() if words[0] != words[1]}
    for name, words in changed.items():
        messages.mark(level, f"effect of {name}", *words)
    if not changed:
        messages.mark(COMPATIBLE if values else level, "effect", before, now)


def _effects_by_value(old: Effect | None, new: Effect | None) -> dict[str, tuple[str, str]]:
    """The effects for each old value of the enum that both depend on; empty if there is none."""
    if old is None or new is None:
        return {}
    before, now = ([case.when for case in e.cases if case.when] for e in (old, new))
    enums = [when.enum for when in before if when.enum and not when.is_on_flags]
    if not enums or len({(when.subject, when.from_context) for when in before + now}) != 1:
        return {}
    return {v.name: (_effect_at(old, v.value), _effect_at(new, v.value)) for v in enums[0].values}


def _effect_at(effect: Effect, value: int) -> str:
    """The words of the first case that holds for a value."""
    cases = (case for case in effect.cases if case.when is None or case.when.accepts(value))
    return next((" ".join(case.words) for case in cases), "")


def _effect_words(case: EffectCase) -> str:
    words = " ".join(case.words)
    return f"{words} if {_condition_words(case)}" if case.when else words
