"""Worked examples of specs unlike that of the project."""

from __future__ import annotations

from pathlib import Path

from sbgcgen.build import load_layout
from sbgcgen.oracle.example import example_of
from sbgcgen.targets import target
from support import layout_of, message_of, write_spec

PACKED = """\
family: probe
summary: A packed value, one part of which has a unit.
packed:
  Pack:
    type: u16
    summary: Two values.
    source: L1
    parts:
      - {name: low, bits: 0..7, type: Small, summary: An angle.}
      - {name: high, bits: 8..15, summary: A number.}
quantities:
  Small: {type: i16, unit: deg, accessor: degrees, scale: 1/2, summary: A small angle.}
commands:
  CMD_GET_PACK:
    id: 9
    summary: A packed value.
    from_board:
      source: L10
      fields:
        - {name: PACK, type: Pack, typical: 300, summary: Packed.}
  CMD_SET_PACK:
    id: 10
    summary: Sets a packed value.
    to_board:
      source: L10
      effect: sets
      answer: none
      fields:
        - {name: PACK, type: Pack, typical: 300, summary: Packed.}
"""


def test_part_of_a_packed_value_with_a_unit(tmp_path: Path) -> None:
    layout = layout_of(tmp_path, PACKED)
    read, write = (
        target("cpp").examples(example_of(message_of(layout, name), layout))[-1]
        for name in ("GetPack", "SetPack")
    )
    assert r'std::printf("pack: low %g deg\n", message.pack.low().degrees());' in read.text
    assert read.output == ("pack: low 22 deg", "pack: high 1")
    assert "message.pack.set_low(22.0_deg);" in write.text or "set_low(22_deg)" in write.text
    assert "using namespace sbgc::literals;" in write.text
    assert "message.pack.set_high(1);" in write.text


def test_site_of_a_protocol_without_requests_that_have_a_body(tmp_path: Path) -> None:
    spec = write_spec(tmp_path)
    base = spec / "base.yaml"
    text, _, rest = base.read_text("utf-8").partition("\n  CMD_USE:")
    assert rest
    base.write_text(text + "\n")
    files = dict(target("site").files(load_layout(spec), tmp_path))
    assert b"3E" in files["framing.html"]
