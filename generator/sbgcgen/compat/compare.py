"""Compares two versions of the protocol; see `changes.Level` for the severity of changes."""

from __future__ import annotations

from sbgcgen.compat.changes import Change, Changes, Level
from sbgcgen.compat.fields import compare_fields, compare_rules, compare_structs, places
from sbgcgen.compat.types import (
    compare_enum,
    compare_packed,
    compare_quantity,
    pair_named,
    same_enum,
    same_packed,
    same_quantity,
)
from sbgcgen.model import (
    Answer,
    AnswerCase,
    Command,
    Condition,
    Effect,
    EffectCase,
    Framing,
    Layout,
    Message,
    Position,
    Struct,
    Until,
    Variable,
)
from sbgcgen.spec.load import MAIN_FILE


def compare(old: Layout, new: Layout) -> list[Change]:
    """All changes, the worst first; those of equal severity are grouped by kind of entry."""
    changes = Changes(new.versions)
    _compare_framings(old, new, changes)
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


def _compare_framings(old: Layout, new: Layout, changes: Changes) -> None:
    at = Position(f"spec/{MAIN_FILE}")
    now = {framing.name: framing for framing in new.framings}
    for framing in old.framings:
        if framing.name in now:
            _compare_framing(framing, now[framing.name], changes)
        else:
            changes.deleted(Level.WIRE, f"framing {framing.name}", at)
    known = [framing.name for framing in old.framings]
    for name in now:
        if name not in known:
            changes.added(f"framing {name}", at)


def _compare_framing(old: Framing, new: Framing, changes: Changes) -> None:
    at = Position(f"spec/{MAIN_FILE}")
    framing = f"framing {new.name}"
    for key in ("start", "header", "trailer", "max_body"):
        changes.compare(Level.WIRE, f"{framing}: {key}", getattr(old, key), getattr(new, key), at)
    for checksum in new.checksums:
        other = old.checksum(checksum.name)
        if other is not None:
            what = f"{framing}: {checksum.name}"
            for key in ("kind", "covers", "crc"):
                before, now = getattr(other, key), getattr(checksum, key)
                changes.compare(Level.WIRE, f"{what}: {key}", before, now, at)


def _compare_versions(old: Layout, new: Layout, changes: Changes) -> None:
    at = Position(f"spec/{MAIN_FILE}")
    for kind in ("firmware", "board"):
        names = [
            found.name if found else ""
            for found in map(lambda v: v.of(kind), (old.versions, new.versions))
        ]
        if names[0]:
            changes.compare(Level.MEANING, f"versions: {kind}", names[0], names[1], at)
    newest = (old.newest_firmware, new.newest_firmware)
    if newest[0]:
        changes.compare(Level.COMPATIBLE, "newest firmware", newest[0], newest[1], at)


def _compare_line(old: Layout, new: Layout, changes: Changes) -> None:
    """Changed pauses and additional rates are compatible."""
    at = new.line.at if new.line.at.file else Position(f"spec/{MAIN_FILE}")
    for key in ("baud_rates", "parities"):
        before, now = getattr(old.line, key), getattr(new.line, key)
        level = Level.MEANING if set(before) - set(now) else Level.COMPATIBLE
        changes.compare(level, f"line: {key}", list(before), list(now), at)
    for key in ("shortest_pause_ms", "longest_pause_ms"):
        before, now = getattr(old.line, key), getattr(new.line, key)
        changes.compare(Level.COMPATIBLE, f"line: {key}", before, now, at)


def _compare_directions(old: Layout, new: Layout, changes: Changes) -> None:
    """A direction that was not known may be named."""
    before = {direction.axis: direction for direction in old.directions}
    for now in new.directions:
        was = before.pop(now.axis, None)
        words = (was and was.positive, now.positive)
        level = Level.MEANING if words[0] else Level.COMPATIBLE
        changes.compare(level, f"direction of {now.axis}", *words, now.at)
    for axis, gone in before.items():
        changes.deleted(Level.MEANING, f"direction of {axis}", gone.at, gone.positive)


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
        what = f"struct {now.name}"
        compare_structs(what, before, now, changes)
        sizes = [s.size if s.is_region else None for s in (before, now)]
        changes.compare(Level.WIRE, f"{what}: size", sizes[0], sizes[1], now.at)
        changes.compare(Level.SOURCE, f"{what}: family", before.family, now.family, now.at)
        changes.compare(Level.COMPATIBLE, f"{what}: summary", before.summary, now.summary, now.at)


def _same_struct(old: Struct, new: Struct) -> bool:
    names = [[(f.spec_name, f.name) for f in struct.fields] for struct in (old, new)]
    return names[0] == names[1] and places(old.fields) == places(new.fields)


def _compare_revisions(old: Layout, new: Layout, changes: Changes) -> None:
    """Revisions are documentation, so all changes are compatible."""
    before = {r.number: (r.date, [a.text for a in r.adds], r.changes) for r in old.revisions}
    for revision in new.revisions:
        now = (revision.date, [a.text for a in revision.adds], revision.changes)
        what = f"revision {revision.number}"
        changes.compare(Level.COMPATIBLE, what, before.pop(revision.number, None), now, revision.at)
    for number in before:
        at = next(r.at for r in old.revisions if r.number == number)
        changes.deleted(Level.COMPATIBLE, f"revision {number}", at)


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
                changes.deleted(Level.WIRE, what, command.at, command.id)
                continue
            come.remove(now)
            is_alias = command.identifier in {a.name for a in now.aliases}
            level = Level.COMPATIBLE if is_alias else Level.SOURCE
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
    changes.compare(Level.WIRE, f"{what}: id", old.id, new.id, new.at)
    if old.name == new.name:
        names = (old.identifier, new.identifier)
        changes.compare(Level.SOURCE, f"{what}: C++ name", names[0], names[1], new.at)
    changes.since(what, old.since, new.since, new.at)
    marks = (old.undocumented, new.undocumented)
    changes.compare(Level.COMPATIBLE, f"{what}: undocumented", marks[0], marks[1], new.at)
    marks = (old.unconfirmed, new.unconfirmed)
    changes.compare(Level.COMPATIBLE, f"{what}: unconfirmed", marks[0], marks[1], new.at)
    changes.compare(Level.COMPATIBLE, f"{what}: summary", old.summary, new.summary, new.at)


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
            changes.deleted(Level.WIRE, what, message.at, f"{message.direction}, {message.id}")
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
    what = f"message {new.name}"
    changes.compare(Level.WIRE, f"{what}: direction", old.direction, new.direction, new.at)
    plain = {old.form, new.form} == {None, "simple"}
    level = Level.COMPATIBLE if plain else Level.WIRE
    changes.compare(level, f"{what}: form", old.form, new.form, new.at)


def _compare_message(old: Message, new: Message, renamed: dict[str, str], changes: Changes) -> None:
    what = f"message {new.name}"
    changes.compare(Level.SOURCE, f"{what}: C++ name", old.name, new.name, new.at)
    changes.compare(Level.SOURCE, f"{what}: family", old.family, new.family, new.at)
    if old.keeps_tail != new.keeps_tail:
        level = Level.COMPATIBLE if new.keeps_tail else Level.WIRE
        changes.add(level, f"{what}: keeps its tail", old.keeps_tail, new.keeps_tail, new.at)
    if old.max_size != new.max_size and _lengths(old) == _lengths(new):
        level = Level.COMPATIBLE if new.max_size > old.max_size else Level.WIRE
        changes.add(level, f"{what}: max_size", old.max_size, new.max_size, new.at)
    contexts = [[(c.name, c.type.name if c.type else None) for c in m.contexts] for m in (old, new)]
    changes.compare(Level.SOURCE, f"{what}: context", contexts[0], contexts[1], new.at)
    sources = [[(c.sources, c.announced) for c in m.contexts] for m in (old, new)]
    if contexts[0] == contexts[1]:
        changes.compare(
            Level.MEANING, f"{what}: source of its context", sources[0], sources[1], new.at
        )
    _compare_answers(what, old, new, renamed, changes)
    _compare_effects(what, old.effect, new.effect, new.at, changes)
    changes.compare(Level.MEANING, f"{what}: stops", old.stops, new.stops, new.at)
    _compare_roles(what, old, new, changes)
    stores = renamed.get(old.stores, old.stores)
    changes.compare(Level.MEANING, f"{what}: stores", stores, new.stores, new.at)
    changes.since(what, old.since, new.since, new.at)
    ends = [_until_words(m.until, renamed if m is old else {}, changes) for m in (old, new)]
    changes.compare(Level.MEANING, f"{what}: until", ends[0], ends[1], new.at)
    marks = (bool(old.deprecated), bool(new.deprecated))
    changes.compare(Level.COMPATIBLE, f"{what}: deprecated", marks[0], marks[1], new.at)
    changes.compare(Level.COMPATIBLE, f"{what}: summary", old.summary, new.summary, new.at)
    texts = (old.description, new.description)
    changes.compare(Level.COMPATIBLE, f"{what}: description", texts[0], texts[1], new.at)
    texts = (old.preparation, new.preparation)
    changes.compare(Level.COMPATIBLE, f"{what}: preparation", texts[0], texts[1], new.at)


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


def _compare_answers(
    what: str, old: Message, new: Message, renamed: dict[str, str], changes: Changes
) -> None:
    """A client must still receive each response, and a safe retry must stay safe."""
    before, now = old.answer or NO_ANSWER, new.answer or NO_ANSWER
    names = tuple(renamed.get(name, name) for name in before.messages)
    lost = set(names) - set(now.messages)
    was_silent = not names and before.confirm == "never"
    level = Level.MEANING if lost or was_silent else Level.COMPATIBLE
    changes.compare(level, f"{what}: answered by", sorted(names), sorted(now.messages), new.at)
    confirm = (before.confirm, now.confirm)
    changes.compare(_level_of(confirm), f"{what}: confirmed", confirm[0], confirm[1], new.at)
    if confirm[0] == confirm[1]:
        counts = (before.confirmations, now.confirmations)
        changes.compare(Level.MEANING, f"{what}: confirmations", counts[0], counts[1], new.at)
    level = Level.COMPATIBLE if now.retry_safe else Level.MEANING
    changes.compare(level, f"{what}: safe to retry", before.retry_safe, now.retry_safe, new.at)
    times = (before.timeout_ms, now.timeout_ms)
    changes.compare(Level.COMPATIBLE, f"{what}: timeout_ms", times[0], times[1], new.at)
    ends = [max(case.finish_ms for case in answer.cases) for answer in (before, now)]
    changes.compare(Level.COMPATIBLE, f"{what}: finish_ms", ends[0], ends[1], new.at)
    conditions = [[_condition_words(case) for case in answer.cases] for answer in (before, now)]
    changes.compare(Level.MEANING, f"{what}: answered when", conditions[0], conditions[1], new.at)
    if conditions[0] != conditions[1]:
        return
    for index, (first, second) in enumerate(zip(before.cases, now.cases)):
        case = f"{what}: case {index + 1}" if len(now.cases) > 1 else what
        kept = sorted(renamed.get(name, name) for name in first.messages)
        if len(now.cases) > 1:
            changes.compare(
                Level.MEANING, f"{case}: answered by", kept, sorted(second.messages), new.at
            )
            pair = (first.confirm, second.confirm)
            changes.compare(_level_of(pair), f"{case}: confirmed", pair[0], pair[1], new.at)
        correlation = [sorted(c.correlation) for c in (first, second)]
        changes.compare(Level.MEANING, f"{case}: repeats", correlation[0], correlation[1], new.at)
        ends_it = (first.restarts, second.restarts)
        changes.compare(Level.MEANING, f"{case}: restarts the board", *ends_it, new.at)
        results = [c.result.field.spec_name if c.result else "" for c in (first, second)]
        changes.compare(Level.MEANING, f"{case}: result", results[0], results[1], new.at)


def _compare_effects(
    what: str, old: Effect | None, new: Effect | None, at: Position, changes: Changes
) -> None:
    """Programs may rely on the effect, for example to confirm requests that move the camera.

    New values of an enum may have any.
    """
    before, now = ([_effect_words(c) for c in e.cases] if e else [] for e in (old, new))
    level = Level.MEANING if before else Level.COMPATIBLE
    values = _effects_by_value(old, new)
    changed = [name for name, (was, is_) in values.items() if was != is_]
    if values and before != now:
        for name in changed:
            was, is_ = (" ".join(words) for words in values[name])
            changes.add(level, f"{what}: effect of {name}", was, is_, at)
        if not changed:
            changes.add(Level.COMPATIBLE, f"{what}: effect", before, now, at)
        return
    changes.compare(level, f"{what}: effect", before, now, at)


Words = tuple[str, ...]


def _effects_by_value(old: Effect | None, new: Effect | None) -> dict[str, tuple[Words, Words]]:
    """The effects for each old value of the enum that both depend on; empty if there is none."""
    if old is None or new is None:
        return {}
    conditions = [*_conditions(old), *_conditions(new)]
    enums = [when.enum for when in _conditions(old) if when.enum and not when.is_on_flags]
    if not enums or len({(when.source, when.from_context) for when in conditions}) != 1:
        return {}
    return {
        value.name: (_effect_at(old, value.value), _effect_at(new, value.value))
        for value in enums[0].values
    }


def _conditions(effect: Effect) -> list[Condition]:
    return [case.when for case in effect.cases if case.when]


def _effect_at(effect: Effect, value: int) -> Words:
    """The words of the first case that holds for a value."""
    cases = (case for case in effect.cases if case.when is None or case.when.holds(value))
    return tuple(next((case.words for case in cases), ()))


def _effect_words(case: EffectCase) -> str:
    words = " ".join(case.words)
    return f"{words} if {_condition_words(case)}" if case.when else words


def _level_of(confirm: tuple[str, str]) -> Level:
    """Clients do not wait for uncertain confirmations, so their likelihood may change."""
    before, now = confirm
    is_kept = before != "always" and now in ("unlikely", "possible")
    return Level.COMPATIBLE if is_kept else Level.MEANING


def _condition_words(case: AnswerCase | EffectCase) -> str:
    """The condition of a case in words; "else" if it has none."""
    when = case.when
    if when is None:
        return "else"
    return f"{when.source} {when.words}"


def _compare_roles(what: str, old: Message, new: Message, changes: Changes) -> None:
    """Compare roles, by which programs find messages."""
    kinds = [m.role.kind if m.role else "" for m in (old, new)]
    level = Level.COMPATIBLE if not kinds[0] else Level.MEANING
    changes.compare(level, f"{what}: role", kinds[0], kinds[1], new.at)
    if not (old.role and new.role and kinds[0] == kinds[1]):
        return
    parts = [{part: f.spec_name for part, f in m.parts.items()} for m in (old.role, new.role)]
    for part in sorted({*parts[0], *parts[1]}):
        pair = [names.get(part, "") for names in parts]
        level = Level.MEANING if pair[0] else Level.COMPATIBLE
        changes.compare(level, f"{what}: role: {part}", pair[0], pair[1], new.at)
    for key in ("interval_us", "end", "cycle", "cycle_us", "delay_ms"):
        pair = [getattr(role, key) for role in (old.role, new.role)]
        changes.compare(Level.MEANING, f"{what}: role: {key}", pair[0], pair[1], new.at)
    limits = [role.limit or None for role in (old.role, new.role)]
    level = Level.COMPATIBLE if limits[0] is None else Level.MEANING
    changes.compare(level, f"{what}: role: limit", limits[0], limits[1], new.at)
    messages = [set(role.messages) for role in (old.role, new.role)]
    level = Level.MEANING if messages[0] - messages[1] else Level.COMPATIBLE
    changes.compare(
        level, f"{what}: role: messages", sorted(messages[0]), sorted(messages[1]), new.at
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
            changes.add(Level.MEANING, f"variable {variable.id}", *names, other.at)
        else:
            changes.deleted(Level.WIRE, what, variable.at, variable.id)
    names_before = {variable.name for variable in old.variables}
    ids_before = {variable.id for variable in old.variables}
    for variable in new.variables:
        if variable.name not in names_before and variable.id not in ids_before:
            changes.added(f"variable {variable.name}", variable.at, variable.id)


def _compare_variable(what: str, old: Variable, new: Variable, changes: Changes) -> None:
    changes.compare(Level.WIRE, f"{what}: id", old.id, new.id, new.at)
    changes.compare(Level.WIRE, f"{what}: type", old.scalar.name, new.scalar.name, new.at)
    changes.compare(Level.SOURCE, f"{what}: C++ name", old.identifier, new.identifier, new.at)
    units = [
        (v.quantity.unit, v.quantity.scale, v.quantity.offset) if v.quantity else None
        for v in (old, new)
    ]
    level = Level.MEANING if old.quantity else Level.COMPATIBLE
    changes.compare(level, f"{what}: unit", units[0], units[1], new.at)
    narrowed = new.minimum > old.minimum or new.maximum < old.maximum
    level = Level.MEANING if narrowed else Level.COMPATIBLE
    ranges = [f"{v.minimum}..{v.maximum}" for v in (old, new)]
    changes.compare(level, f"{what}: range", ranges[0], ranges[1], new.at)
    changes.since(what, old.since, new.since, new.at)
    level = Level.MEANING if old.settings else Level.COMPATIBLE
    sets = [" ".join(f"{s.message}.{s.path}" for s in v.settings) for v in (old, new)]
    changes.compare(level, f"{what}: sets", sets[0], sets[1], new.at)
    changes.compare(level, f"{what}: as_switch", old.is_switch, new.is_switch, new.at)
    changes.compare(Level.COMPATIBLE, f"{what}: summary", old.summary, new.summary, new.at)
