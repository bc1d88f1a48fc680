"""Compares two versions of the protocol; see `changes.Level` for the severity of changes."""

from __future__ import annotations

from sbgcgen.compat.changes import COMPATIBLE, MEANING, SOURCE, WIRE, Change, Changes, Level, Pair
from sbgcgen.compat.fields import compare_fields, compare_rules, compare_structs, places
from sbgcgen.compat.types import compare_enum, compare_packed, compare_quantity, pair_named
from sbgcgen.compat.types import same_enum, same_packed, same_quantity, unit_of
from sbgcgen.model import Answer, AnswerCase, Command, Condition, Effect, EffectCase, Framing
from sbgcgen.model import Layout, Message, Position, Struct, Until, Variable


def compare(old: Layout, new: Layout) -> list[Change]:
    """All changes, the worst first; those of equal severity are grouped by kind of entry."""
    changes = Changes(new.versions)
    _compare_names(old, new, changes)
    _compare_framings(old, new, changes)
    _compare_effect_kinds(old, new, changes)
    _compare_versions(old, new, changes)
    _compare_line(old, new, changes)
    _compare_directions(old, new, changes)
    commands = _compare_commands(old, new, changes)
    _compare_messages(old, new, commands, changes)
    _compare_named_types(old, new, changes)
    _compare_variables(old, new, changes)
    _compare_revisions(old, new, changes)
    rank = list(Level)
    return sorted(changes.found, key=lambda change: rank.index(change.level))


def _main(layout: Layout) -> Position:
    """The place of facts of the whole protocol."""
    return Position(f"spec/{layout.main_file}")


def _compare_names(old: Layout, new: Layout, changes: Changes) -> None:
    """Compare the names of the model's file, and of the namespace."""
    at = _main(new)
    if old.main_file:
        changes.compare(SOURCE, "main file", old.main_file, new.main_file, at)
    before, now = (layout.protocol.get("namespace", "sbgc") for layout in (old, new))
    changes.compare(SOURCE, "namespace", before, now, at)
    changes.compare(COMPATIBLE, "prefix of commands", old.command_prefix, new.command_prefix, at)


def _compare_effect_kinds(old: Layout, new: Layout, changes: Changes) -> None:
    now = {kind.word: kind for kind in new.effects}
    for kind in old.effects:
        what, other = f"effect {kind.word}", now.pop(kind.word, None)
        if other is None:
            changes.deleted(SOURCE, what, _main(new))
            continue
        changes.compare(MEANING, f"{what}: risk", kind.risk, other.risk, _main(new))
        changes.compare(COMPATIBLE, f"{what}: summary", kind.summary, other.summary, _main(new))
    for word in now:
        changes.added(f"effect {word}", _main(new))


def _compare_framings(old: Layout, new: Layout, changes: Changes) -> None:
    at = _main(new)
    now = {framing.name: framing for framing in new.framings}
    for framing in old.framings:
        if framing.name in now:
            _compare_framing(framing, now[framing.name], at, changes)
        else:
            changes.deleted(WIRE, f"framing {framing.name}", at)
    known = [framing.name for framing in old.framings]
    for name in now:
        if name not in known:
            changes.added(f"framing {name}", at)


def _compare_framing(old: Framing, new: Framing, at: Position, changes: Changes) -> None:
    framing = f"framing {new.name}"
    for key in ("start", "header", "trailer", "max_body"):
        changes.compare(WIRE, f"{framing}: {key}", getattr(old, key), getattr(new, key), at)
    for checksum in new.checksums:
        other = old.checksum(checksum.name)
        for key in ("kind", "covers", "crc") if other else ():
            what = f"{framing}: {checksum.name}: {key}"
            changes.compare(WIRE, what, getattr(other, key), getattr(checksum, key), at)


def _compare_versions(old: Layout, new: Layout, changes: Changes) -> None:
    at = _main(new)
    for kind in ("firmware", "board"):
        before, now = (layout.versions.of(kind) for layout in (old, new))
        if before:
            name = now.name if now else ""
            changes.compare(MEANING, f"versions: {kind}", before.name, name, at)
    if old.newest_firmware:
        newest = (old.newest_firmware, new.newest_firmware)
        changes.compare(COMPATIBLE, "newest firmware", *newest, at)


def _compare_line(old: Layout, new: Layout, changes: Changes) -> None:
    """Changed pauses and additional rates are compatible."""
    at = new.line.at if new.line.at.file else _main(new)
    for key in ("baud_rates", "parities"):
        before, now = getattr(old.line, key), getattr(new.line, key)
        level = MEANING if set(before) - set(now) else COMPATIBLE
        changes.compare(level, f"line: {key}", list(before), list(now), at)
    for key in ("shortest_pause_ms", "longest_pause_ms"):
        before, now = getattr(old.line, key), getattr(new.line, key)
        changes.compare(COMPATIBLE, f"line: {key}", before, now, at)


def _compare_directions(old: Layout, new: Layout, changes: Changes) -> None:
    """A direction that was not known may be named."""
    before = {direction.axis: direction for direction in old.directions}
    for now in new.directions:
        was = before.pop(now.axis, None)
        words = (was and was.positive, now.positive)
        level = MEANING if words[0] else COMPATIBLE
        changes.compare(level, f"direction of {now.axis}", *words, now.at)
    for axis, gone in before.items():
        changes.deleted(MEANING, f"direction of {axis}", gone.at, gone.positive)


def _compare_named_types(old: Layout, new: Layout, changes: Changes) -> None:
    for quantity in pair_named("quantity", old.quantities, new.quantities, same_quantity, changes):
        compare_quantity(*quantity, changes)
    ours = [tuple(e for e in layout.enums if e.at.file) for layout in (old, new)]
    for enum in pair_named("enum", ours[0], ours[1], same_enum, changes):
        compare_enum(*enum, changes)
    for packed in pair_named("packed", old.packed, new.packed, same_packed, changes):
        compare_packed(*packed, changes)
    structs = [tuple(s for f in layout.families for s in f.structs) for layout in (old, new)]
    for before, now in pair_named("struct", structs[0], structs[1], _same_struct, changes):
        pair = changes.pair(f"struct {now.name}", before, now)
        compare_structs(pair.what, before, now, changes)
        pair.compare(WIRE, "size", lambda struct: struct.size if struct.is_region else None)
        pair.compare(SOURCE, "family")
        pair.compare(COMPATIBLE, "summary")


def _same_struct(old: Struct, new: Struct) -> bool:
    names = [[(f.spec_name, f.name) for f in struct.fields] for struct in (old, new)]
    return names[0] == names[1] and places(old.fields) == places(new.fields)


def _compare_revisions(old: Layout, new: Layout, changes: Changes) -> None:
    """Revisions are documentation, so all changes are compatible."""
    before = {r.number: (r.date, [a.text for a in r.adds], r.changes) for r in old.revisions}
    for revision in new.revisions:
        now = (revision.date, [a.text for a in revision.adds], revision.changes)
        what = f"revision {revision.number}"
        changes.compare(COMPATIBLE, what, before.pop(revision.number, None), now, revision.at)
    for number in before:
        at = next(r.at for r in old.revisions if r.number == number)
        changes.deleted(COMPATIBLE, f"revision {number}", at)


# Commands


def _compare_commands(old: Layout, new: Layout, changes: Changes) -> dict[str, str]:
    """Compare the commands; returns the new name of each old command."""
    now_by_name = {command.name: command for command in new.commands}
    old_names = {command.name for command in old.commands}
    come = [command for command in new.commands if command.name not in old_names]
    same: dict[str, str] = {}
    for command in old.commands:
        what = f"command {command.name}"
        now = now_by_name.get(command.name)
        if now is None:
            now = next((c for c in come if _is_renamed(command, old, c, new)), None)
            if now is None:
                changes.deleted(WIRE, what, command.at, command.id)
                continue
            come.remove(now)
            is_known = command.identifier in {now.identifier, *(a.name for a in now.aliases)}
            level = COMPATIBLE if is_known else SOURCE
            changes.add(level, f"{what}: name", command.name, now.name, now.at)
        same[command.name] = now.name
        _compare_command(what, command, now, changes)
    for command in come:
        changes.added(f"command {command.name}", command.at, command.id)
    return same


def _is_renamed(old: Command, in_old: Layout, new: Command, in_new: Layout) -> bool:
    """True if a command has the id and the directions of another."""
    directions = [
        {m.direction for m in layout.messages if m.command == command.name}
        for layout, command in ((in_old, old), (in_new, new))
    ]
    return old.id is not None and old.id == new.id and directions[0] == directions[1]


def _compare_command(what: str, old: Command, new: Command, changes: Changes) -> None:
    pair = changes.pair(what, old, new)
    pair.compare(WIRE, "id")
    if old.name == new.name:
        pair.compare(SOURCE, "C++ name", "identifier")
    pair.compare_since()
    pair.compare_needs()
    for key in ("undocumented", "unconfirmed", "summary"):
        pair.compare(COMPATIBLE, key)


# Messages

Key = tuple[str, str, object]


def _compare_messages(old: Layout, new: Layout, commands: dict[str, str], changes: Changes) -> None:
    now_by_key: dict[Key, Message] = {(m.command, m.direction, m.form): m for m in new.messages}
    pairs: list[tuple[Message, Message]] = []
    left: list[Message] = []
    for message in old.messages:
        key = (commands.get(message.command, ""), message.direction, message.form)
        now = now_by_key.pop(key, None)
        if now is None:
            left.append(message)
        else:
            pairs.append((message, now))
    for message in left:
        twin = _other_form(message, commands, now_by_key)
        if twin is None:
            what = f"message {message.name}"
            changes.deleted(WIRE, what, message.at, f"{message.direction}, {message.id}")
            continue
        now_by_key.pop((twin.command, twin.direction, twin.form))
        pairs.append((message, twin))
        _compare_ways(message, twin, changes)
    for message in now_by_key.values():
        changes.added(f"message {message.name}", message.at, message.direction)
    renamed = {before.name: now.name for before, now in pairs}
    bodies: set[tuple[int, int]] = set()
    for before, now in pairs:
        _compare_message(before, now, renamed, changes)
        if (id(before.body), id(now.body)) not in bodies:
            bodies.add((id(before.body), id(now.body)))
            compare_rules(now.name, before.body, now.body, changes)
            compare_fields(now.name, before.fields, now.fields, changes, before.keeps_tail)


def _other_form(
    message: Message, commands: dict[str, str], left: dict[Key, Message]
) -> Message | None:
    """The same message as another form or in the other direction, found by its name or body."""
    command = commands.get(message.command, "")
    candidates = [m for m in left.values() if m.command == command]
    for candidate in candidates:
        if candidate.name == message.name:
            return candidate
    same_way = [m for m in candidates if m.direction == message.direction]
    for candidate in same_way:
        if places(candidate.fields) == places(message.fields):
            return candidate
    return same_way[0] if len(same_way) == 1 and message.form is None else None


def _compare_ways(old: Message, new: Message, changes: Changes) -> None:
    """Compare direction and form. Adding further forms to the only one changes no body."""
    pair = changes.pair(f"message {new.name}", old, new)
    pair.compare(WIRE, "direction")
    pair.compare(COMPATIBLE if {old.form, new.form} == {None, "simple"} else WIRE, "form")


def _compare_message(old: Message, new: Message, renamed: dict[str, str], changes: Changes) -> None:
    pair = changes.pair(f"message {new.name}", old, new)
    pair.compare(SOURCE, "C++ name", "name")
    pair.compare(SOURCE, "family")
    pair.compare(COMPATIBLE if new.keeps_tail else WIRE, "keeps its tail", "keeps_tail")
    if _lengths(old) == _lengths(new):
        pair.compare(COMPATIBLE if new.max_size > old.max_size else WIRE, "max_size")
    pair.compare(SOURCE, "context", _contexts)
    if _contexts(old) == _contexts(new):
        pair.compare(
            MEANING,
            "source of its context",
            lambda message: [(c.sources, c.announced) for c in message.contexts],
        )
    _compare_answers(pair, renamed)
    _compare_effects(pair)
    pair.compare(MEANING, "stops", _stops)
    _compare_roles(pair)
    pair.mark(MEANING, "stores", renamed.get(old.stores, old.stores), new.stores)
    pair.compare_since()
    pair.compare_needs()
    ends = [_until_words(m.until, renamed if m is old else {}, changes) for m in (old, new)]
    pair.mark(MEANING, "until", *ends)
    pair.compare(COMPATIBLE, "deprecated", lambda message: bool(message.deprecated))
    for key in ("summary", "description", "preparation"):
        pair.compare(COMPATIBLE, key)


def _contexts(message: Message) -> list[object]:
    return [(c.name, c.type.name if c.type else None) for c in message.contexts]


def _until_words(until: Until | None, renamed: dict[str, str], changes: Changes) -> str | None:
    if until is None:
        return None
    instead = renamed.get(until.instead, until.instead)
    return changes.versions(until.versions) + (f", then {instead}" if instead else "")


def _lengths(message: Message) -> tuple[object, ...]:
    """The properties that determine the largest size of a body, apart from `max_size`."""
    limits = [(field.max_count, field.maximum) for field in message.fields]
    return (places(message.fields), limits)


NO_ANSWER = Answer((AnswerCase(None, (), "never", 0, 0, 0, False, False, (), ()),))


def _compare_answers(messages: Pair, renamed: dict[str, str]) -> None:
    """A client must still receive each response, and a safe retry must stay safe."""
    before, now = (message.answer or NO_ANSWER for message in (messages.old, messages.new))
    pair = messages.inner("", before, now)
    names = tuple(renamed.get(name, name) for name in before.messages)
    lost = set(names) - set(now.messages)
    was_silent = not names and before.confirm == "never"
    level = MEANING if lost or was_silent else COMPATIBLE
    pair.mark(level, "answered by", sorted(names), sorted(now.messages))
    _compare_confirm(pair)
    if before.confirm == now.confirm:
        pair.compare(MEANING, "confirmations")
    level = COMPATIBLE if now.retry_safe else MEANING
    pair.compare(level, "safe to retry", "retry_safe")
    pair.compare(COMPATIBLE, "timeout_ms")
    pair.compare(COMPATIBLE, "finish_ms", lambda answer: max(c.finish_ms for c in answer.cases))
    pair.compare(MEANING, "answered when", _conditions_of_answer)
    if _conditions_of_answer(before) != _conditions_of_answer(now):
        return
    for index, (first, second) in enumerate(zip(before.cases, now.cases)):
        is_only = len(now.cases) == 1
        case = messages.inner("" if is_only else f": case {index + 1}", first, second)
        if not is_only:
            kept = sorted(renamed.get(name, name) for name in first.messages)
            case.mark(MEANING, "answered by", kept, sorted(second.messages))
            _compare_confirm(case)
        case.compare(MEANING, "repeats", lambda one: sorted(one.correlation))
        case.compare(MEANING, "preceded by", "series")
        case.compare(MEANING, "restarts the board", "restarts")
        case.compare(MEANING, "result", lambda one: one.result and one.result.field.spec_name)


def _conditions_of_answer(answer: Answer) -> list[str]:
    return [_condition_words(case) for case in answer.cases]


def _compare_effects(messages: Pair) -> None:
    """Programs may rely on the effect, for example to confirm requests that move the camera.

    New values of an enum may have any.
    """
    old, new = messages.old.effect, messages.new.effect
    before, now = ([_effect_words(c) for c in e.cases] if e else [] for e in (old, new))
    level = MEANING if before else COMPATIBLE
    values = _effects_by_value(old, new) if before != now else {}
    changed = [name for name, (was, is_) in values.items() if was != is_]
    for name in changed:
        messages.mark(level, f"effect of {name}", *(" ".join(words) for words in values[name]))
    if not changed:
        messages.mark(COMPATIBLE if values else level, "effect", before, now)


Words = tuple[str, ...]


def _effects_by_value(old: Effect | None, new: Effect | None) -> dict[str, tuple[Words, Words]]:
    """The effects for each old value of the enum that both depend on; empty if there is none."""
    if old is None or new is None:
        return {}
    conditions = [*_conditions(old), *_conditions(new)]
    enums = [when.enum for when in _conditions(old) if when.enum and not when.is_on_flags]
    if not enums or len({(when.subject, when.from_context) for when in conditions}) != 1:
        return {}
    return {
        value.name: (_effect_at(old, value.value), _effect_at(new, value.value))
        for value in enums[0].values
    }


def _conditions(effect: Effect) -> list[Condition]:
    return [case.when for case in effect.cases if case.when]


def _effect_at(effect: Effect, value: int) -> Words:
    """The words of the first case that holds for a value."""
    cases = (case for case in effect.cases if case.when is None or case.when.accepts(value))
    return tuple(next((case.words for case in cases), ()))


def _effect_words(case: EffectCase) -> str:
    words = " ".join(case.words)
    return f"{words} if {_condition_words(case)}" if case.when else words


def _compare_confirm(pair: Pair) -> None:
    """Clients do not wait for uncertain confirmations, so their likelihood may change."""
    is_kept = pair.old.confirm != "always" and pair.new.confirm in ("unlikely", "possible")
    pair.compare(COMPATIBLE if is_kept else MEANING, "confirmed", "confirm")


def _condition_words(case: AnswerCase | EffectCase) -> str:
    """The condition of a case in words; "else" if it has none."""
    return case.when.words if case.when else "else"


def _stops(message: Message) -> list[list[str]]:
    """The patterns of values that stop all motion, by the names of the protocol."""
    names = {leaf.path: leaf.spec_name for leaf in message.leaves}
    return [
        sorted(f"{names.get(v.path, v.path)} & {v.mask:#x} = {v.value}" for v in pattern)
        for pattern in message.stops
    ]


def _compare_roles(messages: Pair) -> None:
    """Compare roles, by which programs find messages."""
    old, new = messages.old.role, messages.new.role
    kinds = [role.kind if role else "" for role in (old, new)]
    messages.mark(MEANING if old else COMPATIBLE, "role", *kinds)
    if not old or not new or old.kind != new.kind:
        return
    pair = messages.inner(": role", old, new)
    for part in sorted({*old.parts, *new.parts}):
        level = MEANING if part in old.parts else COMPATIBLE
        pair.mark(
            level, part, *(r.parts[part].spec_name if part in r.parts else "" for r in (old, new))
        )
    for key in ("interval_us", "end", "cycle", "cycle_us", "delay_ms"):
        pair.compare(MEANING, key)
    pair.compare(MEANING, "limit", lambda role: role.limit or None, added=COMPATIBLE)
    is_less = set(old.messages) - set(new.messages)
    pair.compare(
        MEANING if is_less else COMPATIBLE, "messages", lambda role: sorted(set(role.messages))
    )


# Adjustable variables


def _compare_variables(old: Layout, new: Layout, changes: Changes) -> None:
    by_name = {variable.name: variable for variable in new.variables}
    by_id = {variable.id: variable for variable in new.variables}
    for variable in old.variables:
        now = by_name.get(variable.name)
        what = f"variable {variable.name}"
        if now is not None:
            _compare_variable(what, variable, now, changes)
        elif variable.id in by_id:
            other = by_id[variable.id]
            names = (variable.name, other.name)
            changes.add(MEANING, f"variable {variable.id}", *names, other.at)
        else:
            changes.deleted(WIRE, what, variable.at, variable.id)
    names_before = {variable.name for variable in old.variables}
    ids_before = {variable.id for variable in old.variables}
    for variable in new.variables:
        if variable.name not in names_before and variable.id not in ids_before:
            changes.added(f"variable {variable.name}", variable.at, variable.id)


def _compare_variable(what: str, old: Variable, new: Variable, changes: Changes) -> None:
    pair = changes.pair(what, old, new)
    pair.compare(WIRE, "id")
    pair.compare(WIRE, "type", "scalar.name")
    pair.compare(SOURCE, "C++ name", "identifier")
    pair.compare(
        MEANING,
        "unit",
        lambda v: v.quantity and unit_of(v.quantity),
        added=COMPATIBLE,
    )
    narrowed = new.minimum > old.minimum or new.maximum < old.maximum
    pair.compare(
        MEANING if narrowed else COMPATIBLE, "range", lambda v: f"{v.minimum}..{v.maximum}"
    )
    pair.compare_since()
    level = MEANING if old.settings else COMPATIBLE
    pair.compare(level, "sets", lambda v: " ".join(f"{s.message}.{s.path}" for s in v.settings))
    pair.compare(level, "as_switch", "is_switch")
    pair.compare(COMPATIBLE, "summary")
