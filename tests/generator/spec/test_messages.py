"""Tests of messages: names, forms, shared bodies, response policies, contexts."""

from __future__ import annotations

from pathlib import Path

import pytest

from sbgcgen.build import load_protocol
from sbgcgen.model import largest_forms
from sbgcgen.spec.diagnostics import SpecError
from support import layout_of, message_of, write_spec


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
        simple: {summary: Move a bit.}
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
    layout = layout_of(tmp_path, FORMS)
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
    layout = layout_of(tmp_path, FORMS)
    assert message_of(layout, "Move").keeps_tail
    assert not message_of(layout, "MoveFailure").keeps_tail
    assert not message_of(layout, "MoveRequestExt").keeps_tail, "requests stay small"


def test_the_largest_form_of_a_request_takes_surplus(tmp_path: Path) -> None:
    layout = layout_of(tmp_path, FORMS)
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
    paths = "before a.roll a.pitch a.yaw reserved_1 after reserved_2".split()
    assert [leaf.path for leaf in made.leaves] == paths
    assert [leaf.offset for leaf in made.leaves] == [0, 1, 3, 5, 7, 8, 9]


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
