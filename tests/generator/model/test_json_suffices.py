"""simplebgc.json alone says how to decode every body: examples/python/decode.py reads nothing else."""

from __future__ import annotations

import importlib.util
import json
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from sbgcgen.cli import main
from sbgcgen.model.export.messages import message_json
from sbgcgen.oracle.codec import CodecError
from sbgcgen.oracle.decoding import decode
from sbgcgen.oracle.encoding import encode
from support import GENERATOR, PROJECT, layout_of, message_of, probe, write_spec

EXAMPLE = PROJECT / "examples/python/decode.py"
MODEL: dict[str, Any] = json.loads((PROJECT / "generated/simplebgc.json").read_text("utf-8"))
VECTORS = sorted((PROJECT / "generated/vectors").iterdir())


def example() -> Any:
    spec = importlib.util.spec_from_file_location("decode", EXAMPLE)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("path", VECTORS, ids=[path.stem for path in VECTORS])
def test_the_example_decodes_every_vector(path: Path) -> None:
    module = example()
    decoder = module.Decoder(MODEL)
    by_name = {(m["name"], m["direction"]): m for m in MODEL["messages"]}
    for vector in map(json.loads, path.read_text("utf-8").splitlines()):
        if "hex" not in vector:
            continue  # fields that cannot be encoded
        body, direction = bytes.fromhex(vector["hex"]), vector["direction"]
        context = vector.get("context", {})
        request = ""
        for earlier in vector.get("after", ()):
            size = len(earlier["hex"]) // 2
            request = decoder.choose(earlier["direction"], earlier["id"], size)["name"]
        message = by_name.get((vector.get("message"), direction))
        if "fields" in vector:
            assert message is not None
            assert decoder.decode(message, body, context) == vector["fields"], vector
        else:
            with pytest.raises(module.Malformed):
                found = message or decoder.choose(direction, vector["id"], len(body), request)
                decoder.decode(found, body, context)
        wanted = vector.get("chosen", vector.get("message"))
        if wanted is not None:
            chosen = decoder.choose(direction, vector["id"], len(body), request)
            assert chosen["name"] == wanted, vector


CONDITIONS = """family: probe
summary: Conditions of every kind.
packed:
  Setup:
    type: u16
    summary: Several things.
    source: L1
    parts:
      - {name: mode, bits: 0..1, type: Mode, summary: What to do.}
      - {name: count, bits: 2..4, summary: How many.}
      - {name: offset, bits: 5..7, signed: true, summary: How far.}
      - {name: on, bits: 8, summary: Whether at all.}
commands:
  CMD_PROBE:
    id: 9
    summary: All of them.
    from_board:
      source: L1
      fields:
        - {name: S, type: Setup, summary: Setup.}
        - {name: ANGLE, type: Angle, summary: An angle.}
        - {name: "N[3]", type: u8, summary: Numbers.}
        - {name: "M[axis]", type: Setup, summary: Setups.}
        - {name: COUNT, type: Share, summary: How many.}
        - {name: "L[S.count]", type: u16, summary: Numbers.}
        - {name: "K[COUNT]", type: u8, summary: Numbers.}
        - {name: A, type: u8, when: {field: S.mode, is: MODE_ON}, summary: One.}
        - {name: B, type: u8, when: {field: S.offset, at_most: -2}, summary: One.}
        - {name: C, type: u16, when: {field: ANGLE, at_least: 5, at_most: 7}, summary: One.}
        - {name: D, type: u8, when: {field: "N[1]", is_not: [0, 3]}, summary: One.}
        - {name: E, type: u16, when: {field: M.yaw.on, is: 1}, summary: One.}
        - {name: F, type: u8, when: {all: [{field: S.on, is: 1}, {field: A, is: 2}]}, summary: One.}
        - name: G
          type: u8
          when: {one_of: [{field: "N[2]", at_least: 9}, {all: [{field: S.on, is: 0}, {field: M.roll.count, is: 5}]}]}
          summary: One.
quantities:
  Share: {type: u8, unit: "%", accessor: percent, scale: 1, summary: A share.}
"""


def test_the_example_decodes_conditions_of_every_kind(tmp_path: Path) -> None:
    spec = write_spec(tmp_path, CONDITIONS)
    assert main(["generate", "--spec", str(spec), "--output", str(tmp_path / "out")]) == 0
    model = json.loads((tmp_path / "out/simplebgc.json").read_text("utf-8"))
    (message,) = [m for m in model["messages"] if m["name"] == "Probe"]
    decoder, whole = example().Decoder(model), set()
    for vector in map(json.loads, (tmp_path / "out/vectors/probe.jsonl").open(encoding="utf-8")):
        body = bytes.fromhex(vector.get("hex", ""))
        if "hex" in vector and "fields" in vector:
            assert decoder.decode(message, body, {}) == vector["fields"], vector
            whole |= vector["fields"].keys()
        elif "hex" in vector:
            with pytest.raises(Exception, match="too short|too long"):
                decoder.decode(message, body, {})
    each = "s angle n m count l k a b c d e f g"
    assert whole - {"tail"} == set(each.split()), "each occurs"


GROWN = """        - {name: NUM, type: u8, summary: How many.}
        - name: LAMPS[NUM]
          struct: Lamp
          summary: Lamps.
          fields:
            - {name: LEVEL, type: u8, summary: Brightness.}
            - {name: COLOR, type: u16, since: {firmware: 2.70}, summary: Color.}
            - {name: X, type: u8, since: {firmware: 2.73}, summary: Place.}
            - {name: Y, type: u8, since: {firmware: 2.73}, summary: Place.}
"""
UNCOUNTED = """        - name: LAMPS[]
          struct: Lamp
          summary: Lamps.
          fields:
            - {name: NAME, type: "text[19]", summary: Name.}
            - {name: COLOR, type: u16, since: {firmware: 2.70}, summary: Color.}
"""


@pytest.mark.parametrize(
    "fields, hex_, wanted",
    [
        (GROWN, "020105", [{"level": 1}, {"level": 5}]),
        (GROWN, "02010203040506", [{"level": 1, "color": 0x302}, {"level": 4, "color": 0x605}]),
        (GROWN, "010102030405", [{"level": 1, "color": 0x302, "x": 4, "y": 5}]),
        (GROWN, "0101020304", "count_mismatch"),  # 4 bytes, which no firmware sends
        (GROWN, "02010203", "count_mismatch"),
        (GROWN, "00", []),
        (UNCOUNTED, "41" + 18 * "00" + "0201", [{"name": "A", "color": 0x102}]),
        (UNCOUNTED, 2 * ("41" + 18 * "00"), [{"name": "A"}, {"name": "A"}]),
        (UNCOUNTED, 20 * "41", "too_short"),
    ],
)
def test_elements_that_grew(tmp_path: Path, fields: str, hex_: str, wanted: Any) -> None:
    layout = layout_of(tmp_path, probe(fields))
    message = message_of(layout, "Probe")
    model = json.loads(json.dumps(message_json(message, layout)))
    schema = json.loads((GENERATOR / "schema/simplebgc.schema.json").read_text("utf-8"))
    jsonschema.validate(model, {"$defs": schema["$defs"], "$ref": "#/$defs/message"})
    decoder = example().Decoder({"messages": [model], "enums": [], "packed": []})
    body = bytes.fromhex(hex_)
    if isinstance(wanted, str):
        with pytest.raises(CodecError, match=wanted):
            decode(message, body)
        with pytest.raises(Exception, match="size|short"):
            decoder.decode(model, body, {})
        return
    said = decode(message, body)
    assert said["lamps"] == wanted and encode(message, said) == body
    assert decoder.decode(model, body, {}) == said


def test_the_model_has_a_schema() -> None:
    schema = json.loads((GENERATOR / "schema/simplebgc.schema.json").read_text("utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    errors = list(jsonschema.Draft202012Validator(schema).iter_errors(MODEL))
    assert not errors, errors[0]
