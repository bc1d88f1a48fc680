"""Tests of requests with surplus: bytes after the largest form, which boards ignore."""

from __future__ import annotations

import json
from typing import Any

import pytest

from emulated_gimbal import emulated_gimbal
from sbgc_command import MODEL, decode, decode_one, frame, run

REQUESTS = [m for m in MODEL["messages"] if m["direction"] == "to_board"]
FORMS = {
    name: [m for m in REQUESTS if m["command"] == name] for name in {m["command"] for m in REQUESTS}
}


def takes_surplus(form: dict[str, Any]) -> bool:
    """A form that ends after fields of known number is followed by surplus."""
    is_grown = "sizes" in form  # later firmware has appended fields
    return not form["keeps_tail"] and not any(
        leaf["count"] is None
        or (leaf.get("may_be_missing") and not leaf.get("when") and not is_grown)
        for leaf in form["layout"]
    )


def encoded(lines: list[Any]) -> bytes:
    result = run("encode", "--no-validate", stdin="\n".join(map(json.dumps, lines)))
    assert result.status == 0, result
    return result.out


@pytest.mark.parametrize(
    "text, message, surplus",
    [
        ("3e49014a0101", "GetAnglesRequest", "01"),
        ("3e4d014e0101", "MotorsOn", "01"),
        ("3e6d026f0100" + "01", "MotorsOffExt", "00"),
    ],
)
def test_a_request_with_a_byte_too_many(text: str, message: str, surplus: str) -> None:
    line = decode_one(text, "--hex", "--from", "auto")
    assert (line["message"], line["direction"]) == (message, "to_board")
    assert line["fields"]["tail"] == surplus
    assert encoded([line]).hex() == text
    assert "tail" in run("decode", "--hex", stdin=text).text
    (row,) = run("decode", "--hex", "--format", "csv", stdin=text).text.splitlines()[1:]
    assert row.endswith(f",{surplus}")
    values = decode_one(text, "--hex", "--real")["values"]
    assert values["tail"]["raw"] == surplus


@pytest.mark.parametrize("command", sorted(FORMS))
def test_every_request_at_every_size(command: str) -> None:
    """As the model says, for the newest firmware; what decodes encodes to the same bytes."""
    forms = FORMS[command]
    largest = max(forms, key=lambda form: form["max_size"])
    frames = [frame(largest["id"], bytes(size)) for size in range(256)]
    lines = decode(b"".join(frames), "--from", "host")
    assert len(lines) == 256
    for size, line in enumerate(lines):
        known = [f for f in forms if f["min_size"] <= size <= f["max_size"]]
        is_surplus = size > largest["max_size"] and takes_surplus(largest)
        assert ("tail" in line.get("fields", {})) == is_surplus or largest["keeps_tail"], size
        if is_surplus:
            assert line["message"] == largest["name"]
            # Flags that are 0 announce nothing, so a form with flags is its shortest then.
            assert len(line["fields"]["tail"]) // 2 in (
                size - largest["min_size"],
                size - largest["max_size"],
            )
        elif any(form["min_size"] == form["max_size"] for form in known):
            assert "error" not in line, size
        elif not known and takes_surplus(largest):
            assert line["error"]["code"] in ("unknown_form", "too_short"), size
    sizes = [size for size, line in enumerate(lines) if "error" not in line]
    good = [lines[size] for size in sizes]
    assert encoded(good) == b"".join(frames[size] for size in sizes)


def test_an_answer_that_is_too_short_is_no_request_with_much_surplus() -> None:
    answer = frame(73, bytes(12))  # of 18
    assert decode_one(answer)["direction"] == "from_board"
    assert decode_one(answer)["error"]["code"] == "too_short"
    assert decode_one(answer, "--from", "host")["fields"]["tail"] == bytes(12).hex()


@pytest.mark.parametrize(
    "message, fields",
    [
        ("Control", {"tail": "0000"}),  # would be another form
        ("ControlExtCommand", {"data_set": 0, "tail": "00"}),  # too short for surplus
        ("EncodersCalibOffset4", {"tail": "0000"}),  # the first byte would be a field
        ("MotorsOn", {"tail": "00" * 256}),
    ],
)
def test_a_tail_that_would_be_read_otherwise_is_refused(message: str, fields: Any) -> None:
    line = json.dumps({"message": message, "fields": fields})
    result = run("encode", "--defaults", stdin=line)
    assert result.status == 1 and result.out == b""
    assert "tail" in result.error


def test_it_is_sent_and_refused_only_by_a_strict_board() -> None:
    arguments = ("send", "get_angles", "tail=01", "--format", "jsonl")
    assert run(*arguments, "--dry-run").objects[0]["frame"] == "3e49014a0101"
    with emulated_gimbal() as gimbal:
        answer = run(*arguments, "-p", gimbal.address)
        assert (answer.status, answer.objects[0]["message"]) == (0, "GetAngles"), answer
        # Before 2.68b7 it would not be a safe stop, but an end of all power.
        refused = run(
            "send", "motors_off", "mode=SAFE_STOP", "tail=01", "--yes", "-p", gimbal.address
        )
        assert refused.status == 1
        assert "in this form needs firmware 2.68b7" in refused.error
    with emulated_gimbal("--strict") as gimbal:
        refused = run(*arguments, "-p", gimbal.address)
        assert refused.status == 1
        assert "CMD_SIZE" in refused.error
        assert run("send", "get_angles", "-p", gimbal.address).status == 0
