"""Rules for single entries of the spec that a JSON Schema cannot express."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterator

from sbgcgen.spec.diagnostics import Diagnostics
from sbgcgen.spec.load import Map, Spec
from sbgcgen.model.names import KNOWN_FORMS, FieldName, is_name, parse_field_name
from sbgcgen.spec.resolve.types import parse_bits

_REST = re.compile(r"(bytes|text)\[\]$")


def check_syntax(spec: Spec, found: Diagnostics) -> None:
    """Report contradictory entries. The spec must match the schema."""
    max_body = min(int(node["max_body"]) for node in spec.main["framings"].values())
    for family, content in spec.families.items():
        if content["family"] != family:
            text = f"the family '{content['family']}' is in {family}.yaml"
            found.add(content.at("family"), "SBGC003", text, "a family has the name of its file")
    for words in spec.main.get("indices", {}).values():
        for word, position in zip(words, words.items_at):
            if not is_name(word):
                text = f"'{word}' cannot be a name"
                found.add(position, "SBGC022", text, "call the element by another name")
    for _, _, packed, _ in spec.entries("packed"):
        for part in packed["parts"]:
            _check_part(part, found)
    for _, name, group, _ in spec.entries("structs"):
        _check_fields(group, name, True, max_body, found)
    for _, name, command, _ in spec.entries("commands"):
        _check_command(name, command, found)
        for _, body in _messages(command):
            _check_fields(body, name, False, max_body, found)


def _messages(command: Map) -> Iterator[tuple[str, Map]]:
    """The nodes of a command's directions and their forms."""
    for direction in ("from_board", "to_board"):
        if direction in command:
            yield direction, command[direction]
            for form in command[direction].get("forms", {}).values():
                if form is not None:
                    yield direction, form


# Commands and messages


def _check_form_names(node: Map, found: Diagnostics) -> None:
    """A form may have any name, but one that resembles a known form is probably a typo."""
    forms = node.get("forms", Map())
    for form in forms:
        close = difflib.get_close_matches(form, KNOWN_FORMS, n=1, cutoff=0.8)
        if form not in KNOWN_FORMS and form.isalpha() and close:
            hint = f"did you mean '{close[0]}'?"
            found.add(forms.at(form), "SBGC004", f"unknown form '{form}'", hint)
        elif not is_name(form):
            text = f"'{form}' cannot be the name of a form"
            found.add(forms.at(form), "SBGC022", text, "a name is a single word")


def _check_command(name: str, command: Map, found: Diagnostics) -> None:
    if not any(key in command for key in ("from_board", "to_board", "undocumented")):
        message = f"{name} has neither 'from_board' nor 'to_board'"
        hint = "say who sends it, or mark it with 'undocumented: true'"
        found.add(command.position, "SBGC041", message, hint)
    for direction, node in _messages(command):
        _check_form_names(node, found)
        for first, second in (("forms", "fields"), ("forms", "same_as"), ("same_as", "fields")):
            if first in node and second in node:
                message = f"{name} has both '{first}' and '{second}'"
                found.add(node.at(second), "SBGC041", message, "one of them describes the body")
        answer = node.get("answer")
        if answer is not None and direction == "from_board":
            message = f"{name} of the board has an answer"
            found.add(node.at("answer"), "SBGC041", message, "'answer' belongs to 'to_board'")
        for case in answer if isinstance(answer, list) else [answer]:
            if isinstance(case, Map):
                _check_answer(name, case, found)


def _check_answer(name: str, answer: Map, found: Diagnostics) -> None:
    never = answer.get("confirm", "never") == "never"
    if never and not answer.get("message") and "confirm" not in answer:
        hint = "name a 'message', say 'confirm: always', or write 'answer: none'"
        found.add(answer.position, "SBGC032", f"{name} does not state what answers it", hint)
    if "confirmations" in answer and never == (answer["confirmations"] > 0):
        message = f"'confirmations' of {name} contradicts 'confirm'"
        hint = "'never' means 0, every other value at least 1"
        found.add(answer.at("confirmations"), "SBGC041", message, hint)
    if "series" in answer and ("message" not in answer or answer.get("retry") == "safe"):
        message = f"the series of {name} needs a 'message' that ends it, and no retry"
        hint = "name the board's last message; a repeated request would start another series"
        found.add(answer.at("series"), "SBGC041", message, hint)
    if "finish_ms" in answer and answer.get("confirmations", 1) < 2 and "series" not in answer:
        hint = "for a single one, say 'timeout_ms'"
        message = f"'finish_ms' of {name} is about the last of several confirmations, or a series"
        found.add(answer.at("finish_ms"), "SBGC041", message, hint)


# Fields


def _check_fields(
    owner: Map, name: str, in_struct: bool, max_body: int, found: Diagnostics
) -> None:
    if in_struct and not owner["fields"]:
        found.add(owner.at("fields"), "SBGC040", f"{name} has no fields", "leave the struct out")
    for field in owner.get("fields", []):
        if "include" in field:
            _check_include(field, in_struct, found)
        elif isinstance(field.get("reserved"), int) and not isinstance(field["reserved"], bool):
            _check_reserved(field, found)
        else:
            _check_field(field, max_body, found)
        if "fields" in field:
            _check_fields(field, str(field.get("struct", name)), True, max_body, found)


def _check_include(field: Map, in_struct: bool, found: Diagnostics) -> None:
    if in_struct:
        hint = "only a message can include another; refer to a struct with 'type'"
        found.add(field.at("include"), "SBGC040", "'include' is in a struct", hint)
    for key in field:
        if key != "include":
            hint = "'include' takes the fields of the message unchanged"
            found.add(field.at(key), "SBGC040", f"'{key}' is next to 'include'", hint)


def _check_reserved(field: Map, found: Diagnostics) -> None:
    count = field["reserved"]
    for key in ("name", "type", "struct", "fields"):
        if key in field:
            message = f"'{key}' is next to 'reserved: {count}', which means unnamed bytes"
            hint = f"for a reserved field with a name: type: bytes[{count}], reserved: true"
            found.add(field.at(key), "SBGC040", message, hint)


def _check_field(field: Map, max_body: int, found: Diagnostics) -> None:
    if "name" not in field:
        hint = "name: NAME, or reserved: 3 for bytes without one, or include: MESSAGE"
        found.add(field.position, "SBGC040", "a field has no name", hint)
        return
    text = str(field["name"])
    problem = ""
    at, hint = field.at("name"), ""
    if "type" in field and "fields" in field:
        at, problem, hint = field.at("fields"), "both 'type' and 'fields'", "leave one of them out"
    elif "type" in field and "struct" in field:
        at, problem, hint = field.at("struct"), "both 'type' and 'struct'", "leave 'struct' out"
    elif "fields" in field and "struct" not in field:
        at, problem = field.at("fields"), "fields, but no name for their struct"
        hint = "give it one: struct: AxisState"
    elif "struct" in field and "fields" not in field:
        at, problem = field.at("struct"), "a struct, but no fields"
        hint = "refer to a struct defined elsewhere with 'type'"
    elif "type" not in field and "fields" not in field:
        problem, hint = "no type", "u8 … f64, bytes[N], text[N], or a name from the spec"
    elif "size" in field and "fields" not in field:
        at, problem = field.at("size"), "a size of its own"
        hint = "'size' belongs beside 'fields'; bytes have theirs in the type: bytes[8]"
    if problem:
        found.add(at, "SBGC040", f"{text} has {problem}", hint)
    name = parse_field_name(text)
    if name is not None:
        _check_repetition(field, name, max_body, found)


def _check_repetition(field: Map, name: FieldName, max_body: int, found: Diagnostics) -> None:
    at = field.at("name")
    rest = bool(_REST.match(str(field.get("type", ""))))
    if rest and (name.index is not None or name.expand is not None):
        message = f"{field['name']} repeats a type that takes the rest of the body"
        found.add(at, "SBGC043", message, "leave out the brackets of the name")
    for key in ("min_count", "max_count"):
        is_named = key == "min_count" and name.expand is not None and name.expand[0].isdigit()
        if key not in field or rest or name.index == "" or is_named:
            continue
        message = f"{field['name']} does not take the rest of the body"
        hint = f"'{key}' belongs to NAME[] and bytes[]; limit a counter with 'range'"
        found.add(field.at(key), "SBGC040", message, hint)
    first, last = 1, 1
    if name.expand is not None and name.expand[0].isdigit():
        first, last = parse_bits(name.expand)
    elif name.index is not None and name.index.isdigit():
        last = int(name.index)
    if last < first:
        message = f"{field['name']} has no elements"
        found.add(at, "SBGC043", message, "count upwards, and at least one")
    elif last - first >= max_body:
        message = f"{field['name']} has {last - first + 1} elements; {max_body} bytes fit"
        found.add(at, "SBGC013", message, "a body is sent in one frame")


# Packed integers


def _check_part(part: Map, found: Diagnostics) -> None:
    said = [key for key in ("bits", "mask") if key in part]
    said += ["divide and modulo"] if "divide" in part or "modulo" in part else []
    if len(said) != 1:
        what = " and ".join(said) if said else "no bits"
        hint = "bits: 0..2, or mask: 0xF0, or divide and modulo for decimal digits"
        found.add(part.at("name"), "SBGC040", f"part '{part['name']}' has {what}", hint)
    if "bits" in part:
        first, last = parse_bits(part["bits"])
        if last < first:
            message = f"the bits of '{part['name']}' are reversed"
            found.add(part.at("bits"), "SBGC017", message, f"write {last}..{first}")
