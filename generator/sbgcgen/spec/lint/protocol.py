"""Rules for the resolved protocol. Rules for single entries are checked while resolving."""

from __future__ import annotations

from sbgcgen.model import Command, Enum, Field, Layout, Packed, Quantity, Scalar, Settings
from sbgcgen.model import Variable, conditions, constants, copy_field, scalar_of
from sbgcgen.spec.diagnostics import Diagnostics, did_you_mean
from sbgcgen.spec.load import Spec, directions_of

# The runtime counts copies in a byte.
MAX_COPIES = 255
# Findings that drop fields from a body, so that its size is unknown.
_UNSIZED = ("SBGC010", "SBGC021", "SBGC025", "SBGC029", "SBGC031")


def lint(spec: Spec, layout: Layout, found: Diagnostics) -> None:
    """Check the whole protocol; findings go into `found`."""
    _check_ids(spec, layout, found)
    _check_forms(layout, found)
    _check_until(layout, found)
    _check_features(layout, found)
    _check_bodies(layout, found)
    _check_variables(layout, found)
    _check_stores(layout, found)
    _check_roles(layout, found)


def _check_ids(spec: Spec, layout: Layout, found: Diagnostics) -> None:
    nodes = {name: node for _, name, node, _ in spec.entries("commands")}
    for command in layout.commands:
        node = nodes[command.name]
        if command.id is None and ("from_board" in node or "to_board" in node):
            text = f"{command.name} has a body but no id"
            found.add(node.at("id"), "SBGC034", text, "nothing can be sent without an id")
    for direction in ("from_board", "to_board"):
        seen: dict[int, Command] = {}
        for command in layout.commands:
            if direction not in directions_of(nodes[command.name]) or command.id is None:
                continue
            first = seen.setdefault(command.id, command)
            if first is not command:
                message = f"{command.name} has the id {command.id} of {first.name} ({direction})"
                hint = f"see {first.at}; an id may be shared only in opposite directions"
                found.add(nodes[command.name].at("id"), "SBGC011", message, hint)


def _check_forms(layout: Layout, found: Diagnostics) -> None:
    messages = layout.messages
    if found.any_of(_UNSIZED):
        return
    for index, message in enumerate(messages):
        for other in messages[:index]:
            same = (message.command, message.direction) == (other.command, other.direction)
            asked = layout.asked_forms(message)
            if asked and other in asked.forms and all(map(asked.asks_for, (message, other))):
                continue
            if same and message.min_size <= other.max_size and other.min_size <= message.max_size:
                text = f"{message.name} and {other.name} can have the same size"
                hint = f"forms are distinguished by size; see {other.at}"
                if message.direction == "from_board":
                    hint += "; or each is the only answer of another request"
                found.add(message.at, "SBGC014", text, hint)


def _check_features(layout: Layout, found: Diagnostics) -> None:
    """Boards must report each required feature, or nobody knows which boards have it."""
    told = {field.type for m in layout.messages for field, _, _ in layout.reports(m)}
    for flags in layout.feature_sets:
        if flags not in told:
            text = f"no message reports the features in {flags.name}"
            hint = "a message from the board has a field of this type that is always there"
            found.add(flags.at, "SBGC050", text, hint)


def _check_until(layout: Layout, found: Diagnostics) -> None:
    """The replacement of a form must be available in time, with the same answer and fields."""
    by_key = {(m.name, m.direction): m for m in layout.messages}
    for message in layout.messages:
        until = message.until
        if until is None:
            continue
        if not until.versions.firmware > message.since.firmware or until.versions.board:
            text = f"{message.name} ends before it starts"
            hint = "write 'until: {firmware: 2.68b7}', later than its 'since'"
            found.add(until.at, "SBGC047", text, hint)
        other = by_key.get((until.instead, message.direction))
        if other is None:
            continue
        if other.since.firmware > until.versions.firmware:
            text = f"{other.name} starts after {message.name} ends"
            found.add(until.at, "SBGC047", text, f"see {other.at}")
        answers = [m.answer.messages if m.answer else () for m in (message, other)]
        if answers[0] != answers[1]:
            text = f"{other.name}, which replaces {message.name}, has a different answer"
            found.add(until.at, "SBGC047", text, f"see {other.at}")
        fields = {f.name: f for f in other.fields}
        for field in message.fields:
            if field.name not in fields or not _can_hold(fields[field.name], field):
                text = f"{other.name} has no place for '{field.name}' of {message.name}"
                hint = "the same field, or one that is a wider integer"
                found.add(field.at, "SBGC047", text, hint)


def _can_hold(wide: Field, narrow: Field) -> bool:
    """True if one field can hold every value of another one with the same meaning."""
    if (wide.dim, wide.count, wide.when) != (narrow.dim, narrow.count, narrow.when):
        return False
    if wide.type == narrow.type:
        return True
    has, room = scalar_of(narrow.type), scalar_of(wide.type)
    if wide.dim != "one" or has is None or has.minimum is None or has.maximum is None:
        return False
    if room is None or room.is_float:
        return False
    return room.holds(has.minimum) and room.holds(has.maximum)


def _check_bodies(layout: Layout, found: Diagnostics) -> None:
    taken = {s.name: s.at for family in layout.families for s in family.structs}
    types: list[Quantity | Enum | Packed] = [*layout.quantities, *layout.enums, *layout.packed]
    taken.update({type_.name: type_.at for type_ in types})
    taken.update({enum.member: enum.at for enum in layout.enums})
    for struct in (s for family in layout.families for s in family.structs):
        _check_constants(struct.fields, found)
    for message in layout.messages:
        if not message.same_as:
            _check_constants(message.fields, found)
        if message.name in taken:
            text = f"message {message.name} has the name of a type (at {taken[message.name]})"
            found.add(message.at, "SBGC028", text, "give the message another one with 'as'")


def _check_constants(fields: tuple[Field, ...], found: Diagnostics) -> None:
    """Names of special values share a scope with those of fields."""
    members = {f.name: f.at for f in fields}
    known = {c.name: c for c in constants(fields)}
    for field in fields:
        for special in field.special:
            if special.name in members:
                text = f"'{special.name}' is the name of another member"
                hint = "give the special value another name"
                found.add(special.at, "SBGC012", text, hint)
            first = known.get(special.name)
            if first and (first.value != special.value or first.scalar != scalar_of(field.type)):
                text = f"'{special.name}' is the name of another special value"
                found.add(special.at, "SBGC012", text, f"see {first.at}")


def _check_variables(layout: Layout, found: Diagnostics) -> None:
    ids: dict[int, Variable] = {}
    for variable in layout.variables:
        first = ids.setdefault(variable.id, variable)
        if first is not variable:
            text = f"{variable.name} has the id {variable.id} of {first.name}"
            found.add(variable.at, "SBGC011", text, f"see {first.at}")


def _check_stores(layout: Layout, found: Diagnostics) -> None:
    by_name = {m.name: m for m in layout.messages}
    for message in layout.messages:
        if message.stores and message.stores not in by_name:
            text = f"{message.name} stores '{message.stores}', which is not a message"
            found.add(message.at, "SBGC021", text, did_you_mean(message.stores, by_name))


def _check_roles(layout: Layout, found: Diagnostics) -> None:
    """Fields with a role must be in settings, where the role has an effect."""
    for settings in layout.settings:
        if not settings.readers:
            text = f"nothing reads the settings {settings.message.name} that a message stores"
            hint = "name it as the answer of a request"
            found.add(settings.message.at, "SBGC037", text, hint)
        _check_copies(settings, found)
        _check_marked(settings, found)
    stored = {s.message.name for s in layout.settings}
    readers = {id(m) for s in layout.settings for m in s.readers}
    for struct in (s for family in layout.families for s in family.structs):
        for field in struct.fields:
            if field.role:
                text = f"the role of '{field.name}' has no effect inside {struct.name}"
                found.add(field.at, "SBGC037", text, "only fields of a message have a role")
    for message in layout.messages:
        if message.same_as or message.name in stored:
            continue
        for field in message.fields:
            if field.role and not (field.role == "copy" and id(message) in readers):
                text = f"{message.name} neither holds nor requests settings"
                found.add(field.at, "SBGC037", text, "a 'role' belongs to what a message 'stores'")


def _check_copies(settings: Settings, found: Diagnostics) -> None:
    own = copy_field(settings.message)
    for message in (settings.message, *settings.readers):
        copies = [f for f in message.fields if f.role == "copy"]
        for extra in copies[1:]:
            text = f"{message.name} has two fields that select its copy"
            found.add(extra.at, "SBGC037", text, "only one field may select the copy")
        field = copies[0] if copies else None
        if field is None and own is not None:
            text = f"{message.name} does not say which copy of {settings.message.name} it requests"
            found.add(message.at, "SBGC037", text, "mark its field with 'role: copy'")
        if field is None:
            continue
        is_one = field.dim == "one" and not field.may_be_absent and not field.is_counter
        is_limited = field.maximum is not None and field.maximum < MAX_COPIES
        is_number = isinstance(field.type, Scalar) and field.minimum == 0
        if not is_one or not is_number or not is_limited:
            text = f"'{field.name}' cannot count the copies of the settings"
            hint = f"it is one integer with a range within 0..{MAX_COPIES - 1} that starts at 0"
            found.add(field.at, "SBGC037", text, hint)
        elif own is not None and own.maximum not in (None, field.maximum):
            both = f"'{field.name}' and '{own.name}' of {settings.message.name}"
            text = f"{both} have different ranges"
            found.add(field.at, "SBGC037", text, "both count the same copies")


def _check_marked(settings: Settings, found: Diagnostics) -> None:
    """Fields with the role "state" or "general" must be usable by code that only sees bytes."""
    tests = [test for when in conditions(settings.message) for test in when.tests]
    shaping = {test.source.split(".")[0] for test in tests if not test.from_context}
    for field in settings.message.fields:
        if field.role not in ("general", "state"):
            continue
        scalar = getattr(field.type, "scalar", field.type)
        is_number = isinstance(scalar, Scalar) and not scalar.is_float
        if not is_number or field.dim != "one" or field.may_be_absent:
            text = f"'{field.name}' is not an integer that is always present"
            found.add(field.at, "SBGC037", text, f"only one integer has the role '{field.role}'")
        elif field.is_counter or field.name in shaping:
            text = f"'{field.name}' determines the layout of {settings.message.name}"
            hint = f"no layout depends on a field of role '{field.role}'"
            found.add(field.at, "SBGC037", text, hint)
        elif field.offset is None:
            text = f"'{field.name}' has no fixed offset"
            found.add(field.at, "SBGC037", text, "put it before the fields of varying size")
        elif field.role == "general" and settings.copies == 1:
            text = f"there is only one copy of {settings.message.name}"
            hint = "without a field with 'role: copy' all settings are those of the whole board"
            found.add(field.at, "SBGC037", text, hint)
