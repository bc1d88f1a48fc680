"""Rules for resolved bodies, which a codec must be able to decode and encode."""

from __future__ import annotations

import re

from sbgcgen.spec.diagnostics import Diagnostics
from sbgcgen.model import Announced, Blob, Context, Enum, Field, Layout, Message, Packed
from sbgcgen.model import Quantity, Scalar, Struct
from sbgcgen.model.names import is_name, parse_lines
from sbgcgen.spec.resolve.sizes import size_of


def lint_bodies(layout: Layout, found: Diagnostics) -> None:
    """Check every message and struct; findings go into `found`."""
    for family in layout.families:
        for struct in family.structs:
            _check_list(struct.fields, found)
            _check_struct(struct, found)
    _check_grown_elements(layout, found)
    _check_families(layout, found)
    for message in layout.messages:
        _check_list(message.fields, found)
        _check_message(message, layout.max_body, found)
        _check_regions(message, found)
        _check_groups(message, found)
        _check_same_as(message, layout, found)
        _check_contexts(message, layout, found)
        _check_alternatives(message, message.fields, found)
        _check_source(message.source, message, found)
    types: list[Enum | Packed] = [*layout.enums, *layout.packed]
    for type_ in types:
        _check_source(type_.source, type_, found)


def _check_message(message: Message, max_body: int, found: Diagnostics) -> None:
    if not is_name(message.name):
        text = f"'{message.name}' cannot be a name"
        found.add(message.at, "SBGC022", text, "give the message another one with 'as'")
    if not message.min_size <= message.max_size <= max_body and message.min_size <= max_body:
        text = f"{message.name} has at least {message.min_size} bytes, at most {message.max_size}"
        hint = f"'max_size' is between the minimum size of the fields and {max_body}"
        found.add(message.at, "SBGC042", text, hint)


def _check_same_as(message: Message, layout: Layout, found: Diagnostics) -> None:
    """Messages with the same body share its codec, so they must agree on the tail."""
    owner = next(m for m in layout.messages if m.body is message.body)
    if owner.keeps_tail != message.keeps_tail:
        word = "keeps" if message.keeps_tail else "refuses"
        text = f"{message.name} {word} a tail, {owner.name} with the same body does not"
        found.add(message.at, "SBGC041", text, "give both of them the same 'tail'")


def _check_families(layout: Layout, found: Diagnostics) -> None:
    """A family's header includes those of the families that it uses, so cycles are errors."""
    uses = {family.name: set(family.uses) for family in layout.families}
    for name in uses:
        reached: set[str] = set()
        following = uses[name]
        while following - reached:
            reached |= following
            following = {n for other in following for n in uses[other]}
        if name in reached:
            family = next(f for f in layout.families if f.name == name)
            at = [*(m.at for m in family.messages), *(s.at for s in family.structs)][0]
            text = f"the family '{name}' depends on itself through other families"
            hint = "move what both need into a third family"
            found.add(at, "SBGC029", text, hint)
            return


def _check_source(source: str, owner: Message | Enum | Packed, found: Diagnostics) -> None:
    """A line range must not end before it starts. Later additions may name no lines."""
    if any(last < first for first, last in parse_lines(source)):
        text = f"the source of {owner.name} has a line range that ends before it starts"
        hint = "write it like 'Variables L1005-L1009'"
        found.add(owner.at, "SBGC020", text, hint)


# Lists of fields


def _check_list(fields: tuple[Field, ...], found: Diagnostics) -> None:
    by_name = {field.name: field for field in fields}
    counted: set[str] = set()
    for field in fields:
        _check_varying(field, found)
        most = field.capacity if field.max_count is None else field.max_count
        if field.min_count > most:
            text = f"'{field.name}' has at least {field.min_count} elements, at most {most}"
            found.add(field.at, "SBGC042", text, "lower 'min_count'")
        if field.max_count is not None and field.max_count > field.capacity:
            text = f"{field.max_count} elements of '{field.name}' do not fit into a body"
            found.add(field.at, "SBGC042", text, f"at most {field.capacity} fit")
        if isinstance(field.type, Struct) and _takes_rest(field.type):
            if field.dim != "one" or field is not fields[-1]:
                text = f"{field.type.name} takes the rest of the body, but something follows it"
                hint = "such a struct occurs once, and last"
                found.add(field.at, "SBGC027", text, hint)
        if field.counter:
            problem = _counter_problem(by_name.get(field.counter), field, counted)
            if problem:
                text = f"'{field.counter}' cannot count '{field.name}': {problem}"
                hint = "a counter is a single u8, u16 or u32 in the same list of fields"
                found.add(field.at, "SBGC043", text, hint)
            counted.add(field.counter)


def _check_varying(field: Field, found: Diagnostics) -> None:
    """Report fields whose end a decoder cannot determine."""
    is_list = field.dim in ("counted", "rest")
    if field.when is not None and field.has_hidden_counter:
        text = f"the list '{field.name}' has a condition"
        found.add(field.at, "SBGC043", text, "make it part of a struct, and give that the 'when'")
    elif field.fits and (field.when is not None or is_list or field.is_counter):
        text = f"a decoder cannot tell whether '{field.name}' fits"
        found.add(field.at, "SBGC043", text, "it is a text or has one size, and has no 'when'")
    elif field.appended and (is_list or field.is_counter):
        text = f"the body may end before '{field.name}', which is part of a list"
        hint = "make the list and its counter a struct, and give that the 'since'"
        found.add(field.at, "SBGC043", text, hint)
    elif field.when is not None and field.when.may_be_missing and field.size is None:
        text = f"'{field.name}' varies in size, so a decoder cannot tell whether it is missing"
        found.add(field.at, "SBGC026", text, "leave out 'may_be_missing'")
    if isinstance(field.type, Announced) and field.dim != "rest":
        text = f"'{field.name}' is announced, but does not take the rest of the body"
        found.add(field.at, "SBGC043", text, "write NAME[]; the announcement determines the count")
    if field.secret and not isinstance(field.type, Blob):
        text = f"'{field.name}' is secret, but neither a text nor bytes"
        found.add(field.at, "SBGC079", text, "only these are hidden")


# Tagged unions


def _check_struct(struct: Struct, found: Diagnostics) -> None:
    for field in struct.fields:
        if isinstance(field.type, Announced):
            text = f"the announced '{field.name}' is in a struct"
            found.add(field.at, "SBGC026", text, "only messages have contexts")
        if isinstance(field.type, Struct) and field.type.is_region:
            text = f"'{field.name}', which has its own size, is in a struct"
            found.add(field.at, "SBGC033", text, "move it into the message")
        if isinstance(field.type, Struct) and field.type.looks_outside:
            text = f"'{field.name}', which depends on fields outside, is in a struct"
            found.add(field.at, "SBGC033", text, "move it into the message")
        if struct.is_region and field.name == "rest" and not field.optional:
            text = "'rest' is a member of every struct with its own size"
            found.add(field.at, "SBGC022", text, "give the field another name with 'as'")


def _check_grown_elements(layout: Layout, found: Diagnostics) -> None:
    """A struct that grew must have the same sizes in all lists, and must not be used elsewhere."""
    structs = {s.name: s for family in layout.families for s in family.structs}
    for fields in (*(m.fields for m in layout.messages), *(s.fields for s in structs.values())):
        for field in fields:
            struct = structs.get(field.type.name) if isinstance(field.type, Struct) else None
            if struct is None or not struct.element_sizes:
                continue
            is_list = field.dim in ("counted", "rest") and field is fields[-1]
            if field.type != struct or not is_list:
                text = (
                    f"elements of '{struct.name}' grew, so it is only for lists of these elements"
                )
                found.add(field.at, "SBGC071", text, "write its fields out again")


def _check_regions(message: Message, found: Diagnostics) -> None:
    """A tagged union is a single field at a fixed offset, after the fields that it depends on."""
    earlier: dict[str, Field] = {}
    for field in message.fields:
        if isinstance(field.type, Struct) and field.type.is_region:
            counts = any(f.is_counter for f in message.fields)
            if field.dim != "one" or field.offset is None or field.may_be_absent or counts:
                text = f"'{field.name}', which has its own size, is not always present"
                hint = "it occurs once, without a condition, in a message without counted lists"
                found.add(field.at, "SBGC033", text, hint)
            inner = [inner.when for inner in field.type.fields if inner.when]
            for when in (test for condition in inner for test in condition.tests):
                source = earlier.get(re.split(r"[.\[]", when.source)[0])
                known = source is not None
                if source is not None and source.name == when.source and when.part is None:
                    known = when.enum is None or source.type == when.enum
                if when.from_context or not known:
                    text = (
                        f"'{field.name}' depends on '{when.source}', which is not an earlier field"
                    )
                    hint = "only fields of the enclosing message can select its content"
                    found.add(field.at, "SBGC033", text, hint)
                    break
        earlier[field.name] = field


def _check_groups(message: Message, found: Diagnostics) -> None:
    """A group that depends on fields of the message must always be present, and only there."""
    for field in message.fields:
        if not isinstance(field.type, Struct) or not field.type.looks_outside:
            continue
        if field.dim in ("counted", "rest") or field.may_be_absent:
            text = f"'{field.name}', which depends on fields outside, varies in number"
            hint = "it occurs once, or for each element of an index"
            found.add(field.at, "SBGC033", text, hint)


def _takes_rest(struct: Struct) -> bool:
    if not struct.fields or struct.size is not None:
        return False
    last = struct.fields[-1]
    return last.dim == "rest" or (isinstance(last.type, Struct) and _takes_rest(last.type))


def _counter_problem(counter: Field | None, field: Field, counted: set[str]) -> str:
    if counter is None:
        return "it is not in the same list"
    if field.counter and not field.has_hidden_counter:
        part = field.counter_part
        if part is not None and (part.enum or part.quantity or part.limits[0]):
            return f"its part '{part.name}' is not an unsigned number"
        if counter.dim != "one":
            return "it is not a single field"
        return "it is not always present" if counter.may_be_absent else ""
    if field.counting == "bytes" and size_of(field.type) is None:
        return "the elements vary in size"
    if counter.name in counted:
        return "it counts another list"
    scalar = counter.scalar if isinstance(counter.type, (Scalar, Quantity)) else None
    if scalar is None or scalar.minimum != 0 or scalar.size == 3:
        return "it is not an unsigned number"
    if counter.dim != "one":
        return "it is not a single field"
    return "it is not always present" if counter.when is not None else ""


# References to other fields and messages


def _check_alternatives(message: Message, fields: tuple[Field, ...], found: Diagnostics) -> None:
    for field in fields:
        other = field.alternative
        if isinstance(field.type, Struct):
            _check_alternatives(message, field.type.fields, found)
        if other is None:
            continue
        if not (
            isinstance(field.type, Quantity)
            and field.type.scalar == other.quantity.scalar
            and field.type.unit == other.quantity.unit
        ):
            text = f"{other.quantity.name} is not another scale of '{field.name}'"
            hint = "both are quantities in one unit over the same number"
            found.add(field.at, "SBGC026", text, hint)
        around = fields if other.in_group else message.fields
        source = next((f for f in around if f.name == other.source), None)
        if source is None:
            wanted = other.source.upper()
            text = f"the unit of '{field.name}' depends on {wanted}, which {message.name} does not have"
            found.add(field.at, "SBGC026", text, "'of' names a field of the same message")
            continue
        sets = [source.type] if isinstance(source.type, Enum) else []
        if isinstance(source.type, Packed):
            sets = [part.enum for part in source.type.parts if part.enum]
        if not any(other.flag in enum.values for enum in sets):
            text = f"'{source.name}' of {message.name} has no flag {other.flag.name}"
            hint = "'of' names the field whose flags choose the unit"
            found.add(field.at, "SBGC026", text, hint)


def _check_contexts(message: Message, layout: Layout, found: Diagnostics) -> None:
    messages = {m.name: m for m in layout.messages}
    known = {context.name: context for context in message.contexts}
    for field in message.fields:
        wanted = field.type.context if isinstance(field.type, Announced) else ""
        if field.when is not None and field.when.from_context:
            wanted = field.when.source
        context_type = field.when.enum if field.when else None
        if wanted and (wanted not in known or known[wanted].type != context_type):
            text = f"{message.name} has no context '{wanted.upper()}' for '{field.name}'"
            hint = "list it under 'context' (with 'announced_by' for announced numbers)"
            found.add(field.at, "SBGC026", text, hint)
        fixed = len(message.body.fixed_part)
        if field.repeats_context and (
            field is not message.fields[fixed]
            or not message.keeps_tail
            or not (field.when and field.when.flags)
        ):
            text = f"'{field.name}' of {message.name} cannot repeat a context"
            hint = "it comes before all that depends on the context, if that 'has' a flag"
            found.add(field.at, "SBGC026", text, hint)
        if field.fits_rest:
            rest = [(f.dim, f.type) for f in message.fields[message.fields.index(field) + 1 :]]
            is_string = isinstance(field.type, Blob) and field.dim == "one"
            if not is_string or rest != [("rest", Blob("bytes", None))]:
                text = f"'{field.name}' of {message.name} is not followed by the rest of the body"
                hint = "a text that fits comes right before a last field of type bytes[]"
                found.add(field.at, "SBGC043", text, hint)
        elif field.fits and not message.keeps_tail:
            text = f"'{field.name}' of {message.name} is not in a message from the board"
            found.add(field.at, "SBGC043", text, "only these may have another size")
    used = {f.when.source for f in message.fields if f.when and f.when.from_context}
    used |= {f.type.context for f in message.fields if isinstance(f.type, Announced)}
    seen: set[str] = set()
    for context in message.contexts:
        if context.name not in used and (context.type or context.announced):
            text = f"the context '{context.name}' of {message.name} is not used"
            found.add(message.at, "SBGC050", text, "delete it, or let a field depend on it")
        if context.name in seen:
            text = f"duplicate context '{context.name}' in {message.name}"
            found.add(message.at, "SBGC012", text, "one of them is enough")
        seen.add(context.name)
        for name, path in context.sources:
            _check_source_of(context, name, path, messages.get(name), message, found)
        if context.announced and not context.announced.types:
            text = f"nothing announces the context '{context.name}' of {message.name}"
            hint = (
                "'announced_by' is a counted list of structs; its elements have 'kind' and 'count'"
            )
            found.add(message.at, "SBGC026", text, hint)


def _check_source_of(
    context: Context,
    name: str,
    path: str,
    source: Message | None,
    message: Message,
    found: Diagnostics,
) -> None:
    field = _find(source.fields if source else (), path.split("."))
    if field is None:
        text = f"the context '{context.name}' of {message.name} has no source field"
        hint = f"there is no single field '{name}.{path}'; write it like BoardInfo.FIRMWARE_VER"
        found.add(message.at, "SBGC026", text, hint)
    elif context.type is not None and field.type != context.type:
        text = f"the context '{context.name}' of {message.name} comes from a field of another type"
        hint = f"'{name}.{path}' must be of type {context.type.name}"
        found.add(message.at, "SBGC026", text, hint)


def _find(fields: tuple[Field, ...], path: list[str]) -> Field | None:
    """The field at a path through structs that are always present."""
    for field in fields:
        if field.name == path[0] and field.dim == "one":
            if len(path) == 1:
                return field
            if isinstance(field.type, Struct) and not field.may_be_absent:
                return _find(field.type.fields, path[1:])
    return None
