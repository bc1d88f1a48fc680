"""Tests of messages: names, forms, shared bodies, response policies, contexts."""

from __future__ import annotations

from pathlib import Path

import pytest

from sbgcgen.build import load_protocol
from sbgcgen.model import largest_forms
from sbgcgen.spec.diagnostics import SpecError
from support import layout_of, message_of, write_spec

BOTH = """\
  CMD_LONG_NAME_3:
    id: 9
    summary: Something long.
    since: {firmware: 2.60}
    from_board:
      source: Incoming commands L10
      fields:
        - {name: A, type: u16, summary: A number.}
    to_board:
      source: Outgoing commands L20
      effect: reads
      summary: Ask for it.
      answer: {message: LongName3, retry: safe, timeout_ms: 250}
"""


def test_names_follow_the_direction(tmp_path: Path) -> None:
    layout = layout_of(tmp_path, BOTH)
    answer = message_of(layout, "LongName3")
    request = message_of(layout, "LongName3Request")
    assert (answer.command, answer.id, answer.direction) == ("CMD_LONG_NAME_3", 9, "from_board")
    assert (request.command, request.id, request.direction) == ("CMD_LONG_NAME_3", 9, "to_board")
    assert (request.min_size, request.max_size, request.fields) == (0, 0, ())
    assert answer.summary == "Something long."
    assert request.summary == "Ask for it."
    assert answer.since.firmware == request.since.firmware == 2600
    assert answer.source == "Incoming commands L10"
    assert answer.form is None and request.form is None


def test_answer(tmp_path: Path) -> None:
    layout = layout_of(tmp_path, BOTH)
    answer = message_of(layout, "LongName3Request").answer
    assert answer is not None
    assert answer.messages == ("LongName3",)
    assert (answer.confirm, answer.confirmations) == ("never", 0)
    assert (answer.timeout_ms, answer.retry_safe) == (250, True)
    assert message_of(layout, "LongName3").answer is None, "the board's messages have none"


def test_answer_is_unsafe_and_takes_the_default_time_unless_it_says_more(tmp_path: Path) -> None:
    text = """\
  CMD_GO:
    id: 9
    summary: Go.
    to_board:
      source: L1
      effect: reads
      answer: {confirm: always, confirmations: 2}
"""
    answer = message_of(layout_of(tmp_path, text), "Go").answer
    assert answer is not None
    assert (answer.messages, answer.confirm, answer.confirmations) == ((), "always", 2)
    assert (answer.timeout_ms, answer.retry_safe) == (500, False)


FORMS = """\
  CMD_MOVE:
    id: 9
    summary: Move.
    to_board:
      source: L1
      effect: reads
      errata: [E001]
      answer: none
      forms:
        simple:
        extended:
          since: {firmware: 2.61}
          summary: Move further.
          fields:
            - {name: HOW, type: u8, summary: How.}
    from_board:
      source: L2
      forms:
        success:
          summary: It moved.
          fields:
            - {name: WHERE, type: u16, summary: Where.}
        error:
          as: MoveFailure
          summary: It did not.
          fields:
            - {name: WHY, type: u8, summary: Why.}
"""


def test_forms(tmp_path: Path) -> None:
    layout = layout_of(tmp_path, FORMS.replace("simple:\n", "simple: {summary: Move a bit.}\n"))
    assert [(m.name, m.direction, m.form, m.max_size) for m in layout.messages if m.id == 9] == [
        ("Move", "from_board", "success", 2),
        ("MoveFailure", "from_board", "error", 1),
        ("MoveRequest", "to_board", "simple", 0),
        ("MoveRequestExt", "to_board", "extended", 1),
    ]
    extended = message_of(layout, "MoveRequestExt")
    assert extended.since.firmware == 2610
    assert extended.errata == ("E001",)
    assert extended.source == "L1"
    assert extended.answer is not None, "keys of the direction apply to each form"


def test_only_the_longest_form_keeps_a_tail(tmp_path: Path) -> None:
    layout = layout_of(tmp_path, FORMS.replace("simple:\n", "simple: {summary: Move a bit.}\n"))
    assert message_of(layout, "Move").keeps_tail
    assert not message_of(layout, "MoveFailure").keeps_tail
    assert not message_of(layout, "MoveRequestExt").keeps_tail, "requests stay small"


def test_the_largest_form_of_a_request_takes_surplus(tmp_path: Path) -> None:
    layout = layout_of(tmp_path, FORMS.replace("simple:\n", "simple: {summary: Move a bit.}\n"))
    requests = layout.messages_of("CMD_MOVE", "to_board")
    assert [message.takes_surplus for message in requests] == [False, True]
    assert not any(
        message.takes_surplus for message in layout.messages_of("CMD_MOVE", "from_board")
    )
    sizes = [(form.message.name, form.size) for form in largest_forms(requests)]
    assert sizes == [("MoveRequestExt", 1), ("MoveRequest", 0)]


def test_include_puts_the_fields_of_another_message_first(tmp_path: Path) -> None:
    text = """\
  CMD_MORE:
    id: 9
    summary: More.
    from_board:
      source: L1
      fields:
        - {name: BEFORE, type: u8, summary: Before.}
        - include: Less
        - {name: AFTER, type: u8, summary: After.}
        - {reserved: 2}
  CMD_LESS:
    id: 10
    summary: Less, though it comes later.
    from_board:
      source: L1
      fields:
        - {name: "A[axis]", type: i16, summary: Numbers.}
        - {reserved: 1}
"""
    made = message_of(layout_of(tmp_path, text), "More")
    assert [(leaf.path, leaf.offset) for leaf in made.leaves] == [
        ("before", 0),
        ("a.roll", 1),
        ("a.pitch", 3),
        ("a.yaw", 5),
        ("reserved_1", 7),
        ("after", 8),
        ("reserved_2", 9),
    ]


def test_same_as_another_message(tmp_path: Path) -> None:
    text = """\
  CMD_WRITE:
    id: 9
    summary: Write.
    to_board:
      source: L1
      effect: reads
      answer: {confirm: always}
      stores: Ping
      same_as: Ping
"""
    layout = layout_of(tmp_path, text)
    made, original = message_of(layout, "Write"), message_of(layout, "Ping")
    assert made.body is original.body
    assert (made.same_as, made.stores) == ("Ping", "Ping")
    assert [leaf.path for leaf in made.leaves] == [leaf.path for leaf in original.leaves]


def test_same_body_in_both_directions_is_one_type(tmp_path: Path) -> None:
    text = """\
  CMD_VALUES:
    id: 9
    summary: Values.
    to_board:
      source: L1
      effect: reads
      summary: Set them.
      answer: none
      fields:
        - {name: A, type: u8, summary: A number.}
    from_board:
      source: L2
      summary: They are so.
      same_as: Values
"""
    layout = layout_of(tmp_path, text)
    to_board = message_of(layout, "Values", "to_board")
    from_board = message_of(layout, "Values", "from_board")
    assert to_board.body == from_board.body
    assert to_board.in_both_directions and from_board.in_both_directions
    assert [m.name for m in layout.definitions].count("Values") == 1


def test_one_id_in_two_directions_may_be_two_commands(tmp_path: Path) -> None:
    text = """\
  CMD_ORDER:
    id: 9
    summary: An order.
    to_board:
      source: L1
      effect: reads
      answer: none
  CMD_REPORT:
    id: 9
    summary: A report.
    from_board:
      source: L1
      fields: []
"""
    layout = layout_of(tmp_path, text)
    assert [(m.name, m.id) for m in layout.messages if m.id == 9] == [("Order", 9), ("Report", 9)]


def test_context_comes_from_the_request(tmp_path: Path) -> None:
    text = """\
  CMD_CUSTOM:
    id: 9
    summary: What was asked for.
    from_board:
      source: L1
      context:
        - {name: FLAGS, type: Options, from: [CustomRequest.FLAGS], summary: Those of the request.}
      fields:
        - {name: "A[3]", type: u16, when: {context: FLAGS, has: OPTION_FAST}, summary: Numbers.}
        - {name: B, type: u8, when: {context: FLAGS, has: OPTION_FINE}, summary: A number.}
    to_board:
      source: L2
      effect: reads
      summary: Ask.
      answer: {message: Custom}
      fields:
        - {name: FLAGS, type: Options, summary: What to send.}
"""
    made = message_of(layout_of(tmp_path, text), "Custom")
    (context,) = made.contexts
    assert context.type is not None
    assert (context.name, context.type.name) == ("flags", "Options")
    assert context.sources == (("CustomRequest", "flags"),)
    conditions = [f.when for f in made.fields]
    assert [(w.from_context, w.mask) for w in conditions if w] == [(True, 0x01), (True, 0x80)]
    assert (made.min_size, made.max_size) == (0, 7)


def test_max_size_that_is_known_otherwise(tmp_path: Path) -> None:
    text = BOTH.replace("      fields:\n", "      max_size: 6\n      fields:\n")
    assert message_of(layout_of(tmp_path, text), "LongName3").max_size == 6


SAME_AS_A_FORM = """\
  CMD_LATER:
    id: 9
    summary: The body of a message that comes later, and has that of a form.
    from_board: {source: L1, same_as: Middle}
  CMD_MIDDLE:
    id: 10
    summary: The body of a form.
    from_board: {source: L1, same_as: Probe}
  CMD_PROBE:
    id: 11
    summary: Two forms.
    from_board:
      source: L1
      forms:
        simple: {fields: [{name: A, type: u8, summary: A number.}]}
        extended: {fields: [{name: B, type: u16, summary: A number.}]}
"""


def test_max_size_of_a_list_whose_elements_vary_in_size(tmp_path: Path) -> None:
    text = """\
        - {name: NUM, type: u8, range: 0..20, summary: How many.}
        - name: ITEMS[NUM]
          summary: The items.
          struct: Item
          fields:
            - {name: KIND, type: u8, summary: A number.}
            - {name: NAME, type: "string[5]", summary: A name.}
"""
    message = message_of(layout_of(tmp_path, text), "Probe")
    assert (message.min_size, message.max_size) == (1, 1 + 20 * (1 + 6))


@pytest.mark.parametrize("key, most", [("counted_in: bytes", 8), ("counted_from: 1", 18)])
def test_max_size_of_a_list_depends_on_how_it_is_counted(
    tmp_path: Path, key: str, most: int
) -> None:
    text = f"""\
        - {{name: NUM, type: u8, range: 0..8, summary: How many.}}
        - {{name: "ITEMS[NUM]", type: u16, {key}, summary: The items.}}
"""
    assert message_of(layout_of(tmp_path, text), "Probe").max_size == 1 + most


def test_body_of_a_form_grows_as_that_does(tmp_path: Path) -> None:
    """The codec is the same, so all messages with the body of the form keep its properties."""
    layout = layout_of(tmp_path, SAME_AS_A_FORM)
    for name in ("Probe", "Middle", "Later"):
        assert not message_of(layout, name).keeps_tail, name
    names = [m.name for m in layout.families[-1].definitions]
    assert names.index("Probe") < names.index("Middle") < names.index("Later")


CIRCLE = """family: probe
summary: A circle.
structs:
  Mine:
    summary: A struct that another family uses.
    fields:
      - {name: A, type: u8, summary: A number.}
      - {name: B, type: Pair, summary: A struct of that family.}
"""


def test_families_use_each_other_in_one_direction(tmp_path: Path) -> None:
    """Otherwise their headers would include each other."""
    spec = write_spec(tmp_path, CIRCLE)
    with (spec / "base.yaml").open("a", encoding="utf-8") as base:
        base.write("        - {name: MINE, type: Mine, summary: A struct of another family.}\n")
    with pytest.raises(SpecError) as raised:
        load_protocol(spec)
    (finding,) = raised.value.diagnostics
    assert finding.code == "SBGC029" and "third family" in finding.hint


OTHER_FORMS = """\
  CMD_AIM:
    id: 9
    summary: Aim.
    to_board:
      source: Outgoing commands L20
      effect: moves
      answer: none
      forms:
        simple:
          summary: At nothing.
        one_byte:
          summary: Nearly at nothing.
          fields:
            - {reserved: 1}
        extended:
          summary: At something.
          until: {firmware: 2.68b7, instead: extended_wide}
          fields:
            - {name: WHAT, type: u16, summary: At what.}
        extended_wide:
          since: {firmware: 2.68b7}
          summary: At something else.
          fields:
            - {name: WHAT, type: u32, summary: At what.}
"""


def test_forms_of_any_name(tmp_path: Path) -> None:
    messages = [m for m in layout_of(tmp_path, OTHER_FORMS).messages if m.command == "CMD_AIM"]
    assert [(m.name, m.form, m.call, m.min_size, m.max_size) for m in messages] == [
        ("Aim", "simple", "aim", 0, 0),
        ("AimOneByte", "one_byte", "aim_one_byte", 1, 1),
        ("AimExt", "extended", "aim_ext", 2, 2),
        ("AimExtWide", "extended_wide", "aim_ext_wide", 4, 4),
    ]


def test_a_form_ends_where_another_takes_its_place(tmp_path: Path) -> None:
    layout = layout_of(tmp_path, OTHER_FORMS)
    until = message_of(layout, "AimExt").until
    assert until is not None
    assert (until.versions.firmware, until.instead) == (2687, "AimExtWide")
    assert message_of(layout, "AimExtWide").until is None


def test_forms_have_enumerators_in_the_order_of_the_protocol(tmp_path: Path) -> None:
    known = ("simple", "extended", "success", "error")
    assert layout_of(tmp_path, OTHER_FORMS).forms == (*known, "one_byte", "extended_wide")
