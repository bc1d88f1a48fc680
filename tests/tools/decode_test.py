"""Tests of sbgc decode. The keys and their meaning are a contract (design, section 8)."""

from __future__ import annotations

import csv
import gzip
import io
import json
import os
import random
import re
import struct
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from sbgc_command import (
    MODEL,
    ON_WINDOWS,
    PROGRAM,
    ROOT,
    decode,
    decode_one,
    frame,
    run,
    valid_frames,
)

BOARD_INFO = bytes.fromhex("3e5612681f8709000200010000000000000000000000b2")
GET_ANGLES = frame(73)
V2_FRAMES = json.loads((ROOT / "tests" / "data" / "v2_frames.json").read_text(encoding="utf-8"))
NAMES = [m["name"] for m in MODEL["messages"]]
BOTH_WAYS = {name for name in NAMES if NAMES.count(name) == 2}


def test_the_contract_to_the_letter() -> None:
    result = run("decode", "--format", "jsonl", stdin=b"\x00\x01" + BOARD_INFO)
    assert result.status == 0
    assert result.text == (
        '{"offset":2,"command":"CMD_BOARD_INFO","id":86,"message":"BoardInfo",'
        '"direction":"from_board","framing":"v1","fields":{"board_ver":31,"firmware_ver":2439,'
        '"debug_mode":0,"board_features":2,"connection_flags":1,"frw_extra_id":0,'
        '"board_features_ext":0,"main_imu_sens_model":0,"frame_imu_sens_model":0,'
        '"build_number":0,"base_frw_ver":0}}\n'
    )


@pytest.mark.parametrize("vector", V2_FRAMES, ids=lambda vector: vector["meaning"][:20])
def test_frames_of_the_second_framing(vector: dict) -> None:
    data = bytes.fromhex(vector["hex"])
    sender = "board" if vector["direction"] == "from_board" else "host"
    for before in (b"", GET_ANGLES, b"\x24\x3e"):
        line = decode(before + data, "--from", sender)[-1]
        assert line["framing"] == "v2" and line["offset"] == len(before)
        assert (line["command"], line["fields"]) == (vector["command"], vector["fields"])
        encoded = run("encode", stdin=json.dumps(line))
        assert encoded.out == data


def test_what_is_nearly_a_frame_of_the_second_framing_is_explained() -> None:
    motors_on = bytes.fromhex("244d004d440a")
    for data, reason in (
        (motors_on[:-1] + b"\x0b", "but the CRC-16 is 0x0b44, not 0x0a44"),
        (motors_on[:-2], "but the CRC-16, 0x0a44, is missing at the end"),
        (motors_on[:-1], "but the last of its 6 bytes is missing"),
    ):
        result = run("decode", stdin=data)
        assert result.status == 1 and reason in result.text


def test_firmware_that_does_not_know_it() -> None:
    control = frame(67, bytes([0x87, 0, 0]) + bytes(12))  # MODE_IGNORE with high resolution
    text = run("decode", "--from", "host", "--firmware", "2.55b5", stdin=control).text
    assert "MODE_IGNORE needs firmware 2.70b4" in text
    assert "CONTROL_FLAG_HIGH_RES_SPEED needs firmware" in text
    line = decode_one(control, "--from", "host", "--firmware", "2.70b4")
    assert line["objections"] == {}
    assert "objections" not in decode_one(control)
    quaternion = frame(141, bytes(4))
    text = run("decode", "--from", "host", "--firmware", "2.72", stdin=quaternion).text
    assert "ControlQuatStatusRequest  needs firmware 2.73" in text
    line = decode_one(quaternion, "--from", "host", "--firmware", "2.59")
    assert line["objections"][""] == "needs firmware 2.73"
    assert run("decode", "--firmware", "new", stdin=control).status == 2


def test_values_that_are_not_allowed() -> None:
    (one,) = (m["id"] for m in MODEL["messages"] if m["name"] == "ReadParams3Request")
    lines = decode(
        frame(one, b"\x05") + frame(one, b"\x04"), "--from", "host", "--firmware", "2.59"
    )
    assert [line["objections"] for line in lines] == [{"profile_id": "is above 4"}, {}]
    (two,) = (m["id"] for m in MODEL["messages"] if m["name"] == "EepromReadRequest")
    bad = frame(two, struct.pack("<IH", 1, 256))
    for line in decode(bad + bad, "--from", "host", "--firmware", "2.59"):
        assert line["objections"] == {
            "addr": "is not a multiple of 64",
            "size": "is above 192 byte",
        }


def test_what_a_firmware_changed() -> None:
    """P of roll as an adjustable variable: its scale is another one from firmware 2.73.1 on."""
    variable = frame(31, bytes.fromhex("010046000000")).hex()
    info = bytearray(18)
    info[1:3] = (2745).to_bytes(2, "little")

    def text(stdin: str, *options: str) -> str:
        return run("decode", *options, stdin=stdin).text

    assert "70 (before firmware 2.73.1)" in text(variable)
    for firmware, shown in (("2.73", "70"), ("2.74.5", "9.7921")):
        line = next(x for x in text(variable, "--firmware", firmware).splitlines() if "value" in x)
        assert shown in line and "before" not in line, line
    assert "9.7921" in text(frame(86, bytes(info)).hex() + variable)


def test_fields_nest_as_the_struct_does() -> None:
    control = frame(67, bytes([0, 1, 2]) + struct.pack("<6h", 1, -2, 3, -4, 5, -6))
    assert decode_one(control)["fields"] == {
        "control_mode": {"roll": 0, "pitch": 1, "yaw": 2},
        "axes": {
            "roll": {"speed": 1, "angle": -2},
            "pitch": {"speed": 3, "angle": -4},
            "yaw": {"speed": 5, "angle": -6},
        },
    }
    variables = frame(31, bytes([2, 19]) + struct.pack("<iBi", 100, 20, -1))
    assert decode_one(variables)["fields"] == {
        "num_vars": 2,
        "params": [{"param_id": 19, "param_value": 100}, {"param_id": 20, "param_value": -1}],
    }
    melody = frame(89, bytes.fromhex("00807d00000000000000000ab80b0852"))
    assert decode_one(melody)["fields"] == {
        "mode": 0x8000,
        "note_length": 125,
        "decay_factor": 0,
        "reserved": "000000000000000a",
        "note_freq_hz": [3000, 21000],
    }


def test_a_request_for_the_version_may_have_a_body_of_any_size() -> None:
    frames = b"".join(frame(86, bytes(range(size))) for size in range(256))
    told = decode(frames, "--from", "host")
    assert len(told) == 256
    assert {line["command"] for line in told} == {"CMD_BOARD_INFO"}
    assert not [line for line in told if "error" in line]
    assert told[0]["fields"] == {}
    asked = decode_one(bytes.fromhex("3e5601570000"), "--from", "host")
    assert (asked["message"], asked["fields"]) == ("BoardInfoRequestOneByte", {"reserved": "00"})
    assert told[2]["fields"] == {"cfg": 0x0100, "reserved": ""}
    assert told[5]["fields"] == {"cfg": 0x0100, "reserved": "020304"}


PASSWORD = b"sesame open"
OPENS = frame(86, b"\x0a\x00" + bytes([len(PASSWORD)]) + PASSWORD)
PROTECTS = frame(137, bytes(8) + bytes([len(PASSWORD)]) + PASSWORD)
TOO_SHORT = frame(137, bytes(8) + bytes([len(PASSWORD) + 1]) + PASSWORD)


@pytest.mark.parametrize(
    "options",
    (
        [],
        ["--format", "jsonl"],
        ["--format", "jsonl", "--real"],
        ["--format", "csv", "-m", "PassProtectWrite"],
        ["--firmware", "2.74"],
        ["-m", "BoardInfoRequestExt", "--where", "cfg=10ms"],
    ),
    ids=" ".join,
)
def test_passwords_are_hidden_unless_they_are_to_be_shown(options: list[str]) -> None:
    broken = OPENS[:-1] + bytes([OPENS[-1] ^ 1])
    input = OPENS + PROTECTS + (b"" if "csv" in options else TOO_SHORT + broken)
    result = run("decode", "--from", "host", *options, stdin=input)
    assert result.status == 0 and "(hidden)" in result.text
    assert PASSWORD.decode() not in result.text + result.error
    assert PASSWORD.hex() not in result.text + result.error
    shown = run("decode", "--from", "host", "--show-passwords", *options, stdin=input)
    assert shown.status == 0 and "(hidden)" not in shown.text
    assert PASSWORD.decode() in shown.text or PASSWORD.hex() in shown.text


def test_a_line_with_a_shown_password_can_be_encoded() -> None:
    hidden = run("decode", "--from", "host", "--format", "jsonl", stdin=OPENS)
    refused = run("encode", "--hex", stdin=hidden.out)
    assert refused.status == 1 and "password: it is hidden" in refused.error
    shown = run("decode", "--from", "host", "--format", "jsonl", "--show-passwords", stdin=OPENS)
    assert run("encode", stdin=shown.out).out == OPENS


def test_an_attitude_has_its_mode_in_front() -> None:
    later = "3e381a52010000000000000000000000803f0000803f00000000000000007f"
    line = decode_one(bytes.fromhex(later), "--from", "host")
    assert line["message"] == "AhrsHelperRequestExtWide"
    up, north = {"x": 0, "y": 0, "z": 1}, {"x": 1, "y": 0, "z": 0}
    assert line["fields"] == {"mode": 1, "z1_vector": up, "h1_vector": north}
    earlier = frame(56, bytes([1]) + struct.pack("<6f", 0, 0, 1, 1, 0, 0))
    assert decode_one(earlier, "--from", "host")["fields"] == line["fields"]
    modes = [decode_one(frame(56, body), "--from", "host") for body in (b"\x02", b"\x02\x04")]
    assert [one["fields"] for one in modes] == [{"mode": 2}, {"mode": 0x0402}]


@pytest.mark.parametrize("count", [1, 31, 32])
def test_virtual_channels_are_as_many_as_are_sent(count: int) -> None:
    body = struct.pack(f"<{count}h", *range(-100, -100 + count))
    line = decode_one(frame(45, body), "--from", "host")
    assert line["fields"] == {"val_ch": list(range(-100, -100 + count))}


@pytest.mark.parametrize(("size", "code"), [(0, "too_short"), (63, "too_short"), (66, "too_long")])
def test_no_virtual_channels_and_too_many_are_errors(size: int, code: str) -> None:
    line = decode_one(frame(45, bytes(size)), "--from", "host")
    assert line["error"]["code"] == code


def test_floats_are_numbers_and_texts_are_strings() -> None:
    stream = frame(85, struct.pack("<BHI", 88, 100, 0x40) + bytes(14))
    vectors = struct.pack("<H6f", 7, 0.5, -0.25, 1, 0, 1e-30, -1)
    lines = decode(stream + frame(88, vectors))
    assert lines[0]["message"] == "DataStreamInterval"
    assert lines[1]["fields"]["z1_vector"] == {"x": 0.5, "y": -0.25, "z": 1}
    assert isinstance(lines[1]["fields"]["z1_vector"]["z"], float)
    h1 = lines[1]["fields"]["h1_vector"]
    assert struct.pack("<3f", h1["x"], h1["y"], h1["z"]) == vectors[14:]

    names = "Fußgänger".encode().ljust(48, b"\0") + bytes(4 * 48)
    fields = decode_one(frame(28, names), "--from", "board")["fields"]
    assert fields["profile_name"][0] == "Fußgänger"


def test_a_request_tells_what_its_answer_holds() -> None:
    request = frame(88, struct.pack("<I", 0x10) + bytes(6))
    lines = decode(request + frame(88, struct.pack("<H3h", 7, 1, 2, 3)))
    assert lines[0]["message"] == "RealtimeDataCustomRequest"
    assert lines[1]["fields"] == {"timestamp_ms": 7, "gyro_data": {"roll": 1, "pitch": 2, "yaw": 3}}


def test_the_request_decides_between_answers_of_one_size() -> None:
    answer = frame(46, bytes.fromhex("00201200c00000c03f6400000010c0"))
    alone = decode_one(answer)
    assert (alone["message"], alone["fields"]["analog_value"]) == ("AdjVarsState", 1069547520)
    after = [decode(frame(46, bytes(size)) + answer)[-1] for size in (2, 7)]
    assert after[0]["fields"] == alone["fields"]
    values = [
        after[1]["fields"][name] for name in ("analog_var_value", "lut_src_value", "lut_var_value")
    ]
    assert (after[1]["message"], values) == ("AdjVarsStateExt", [1.5, 100, -2.25])
    text = run("decode", stdin=answer).text
    assert "after AdjVarsStateRequestExt, it is AdjVarsStateExt:\n" in text and "  1.5\n" in text


@pytest.mark.parametrize("vector", valid_frames(), ids=lambda v: v["meaning"][:40])
def test_vectors_from_outside(vector: dict) -> None:
    sender = "host" if vector["direction"] == "to_board" else "board"
    line = decode_one(vector["bytes"], "--from", sender)
    known = {m["id"] for m in MODEL["messages"] if m["direction"] in (vector["direction"], "both")}
    if vector["bytes"][1] in known:
        assert "error" not in line
        assert line["message"] in {m["name"] for m in MODEL["messages"]}
    else:
        assert line["error"]["code"] == "unknown_command"
    assert line["offset"] == 0
    assert line["id"] == vector["bytes"][1]
    assert line["direction"] == vector["direction"]
    # Without the direction, it finds the same message; only the sender may be ambiguous.
    guessed = decode_one(vector["bytes"])
    assert {**guessed, "direction": line["direction"]} == line
    if line["message"] not in BOTH_WAYS:
        assert guessed == line


def test_noise_between_frames() -> None:
    noise = bytes.fromhex("3e3e ff00 3e56680a00")
    lines = decode(noise + BOARD_INFO + noise + GET_ANGLES + noise)
    assert [line["offset"] for line in lines] == [len(noise), 2 * len(noise) + len(BOARD_INFO)]


def test_a_cut_off_frame_hides_none() -> None:
    lines = decode(BOARD_INFO[:10] + GET_ANGLES)
    assert [(line["offset"], line["id"]) for line in lines] == [(10, 73)]


CONTROL = frame(67, bytes([0, 0, 2]) + struct.pack("<6h", 0, 0, 0, 0, 0, 2048))
BAD_SUM = GET_ANGLES[:-1] + b"\x01"


@pytest.mark.parametrize(
    "data, sender, reason",
    [
        # The message whose direction and size match; 67 is CMD_CONFIRM as well.
        (
            CONTROL[:-1] + b"\x0b",
            "auto",
            "looks like CMD_CONTROL (67) from the host with a body of 15 bytes, "
            "but the checksum of its body is 0x0b, not 0x0a",
        ),
        (
            frame(67, b"\x4d")[:-1] + b"\x00",
            "auto",
            "looks like CMD_CONFIRM (67) from the board with a body of 1 byte, "
            "but the checksum of its body is 0x00, not 0x4d",
        ),
        (
            CONTROL[:-1] + b"\x0b",
            "board",
            "looks like CMD_CONFIRM (67) from the board with a body of 15 bytes, an invalid size "
            "(valid for CMD_CONTROL from the host), but",
        ),
        (
            frame(67, bytes(50))[:-1] + b"\x01",
            "auto",
            "looks like CMD_CONTROL (67) from the host or CMD_CONFIRM (67) from the board with a body of "
            "50 bytes, an invalid size for both, but",
        ),
        # Two messages match.
        (
            frame(114)[:-1] + b"\x01",
            "auto",
            "looks like CMD_RESET (114) from the host or the board with",
        ),
        (frame(114)[:-1] + b"\x01", "host", "looks like CMD_RESET (114) from the host with"),
        (
            frame(252)[:-1] + b"\x01",
            "auto",
            "looks like the unknown id 252 with a body of 0 bytes, but",
        ),
        # The checksum of the body is missing, at the end and before another frame.
        (CONTROL[:-1], "auto", "but the checksum of its body, 0x0a, is missing at the end"),
        (
            CONTROL[:-1] + GET_ANGLES[:-1],
            "auto",
            "but the checksum of its body, 0x0a, is missing: the next frame begins in its place",
        ),
        (
            GET_ANGLES[:-1],
            "auto",
            "but the checksum of its empty body, 0x00, is missing at the end",
        ),
        (
            GET_ANGLES[:-1] * 2,
            "auto",
            "but the checksum of its empty body, 0x00, is missing: the next frame begins in its place",
        ),
        (
            CONTROL[:-3],
            "auto",
            "with a body of 15 bytes, but the last 3 of its 20 bytes are missing",
        ),
    ],
)
def test_what_is_nearly_a_frame_is_explained(data: bytes, sender: str, reason: str) -> None:
    for noise in (b"", b"\x00\x3e\x01\x00"):
        text = run("decode", "--from", sender, stdin=noise + data)
        assert text.status == 1
        (line, *_) = [line for line in text.text.splitlines() if line.startswith("    @")]
        assert line.startswith(f"    @{len(noise)}: looks like") and reason in line
        # JSON lines contain only frames.
        lines = run("decode", "--format", "jsonl", "--from", sender, stdin=noise + data)
        assert lines.status == 1 and lines.out == b""
        assert line in lines.error


def test_explanations_stand_where_the_gap_is() -> None:
    text = run("decode", stdin=GET_ANGLES + CONTROL[:-1] + GET_ANGLES + BAD_SUM * 5 + GET_ANGLES)
    assert text.status == 0
    shown = [re.sub(r" with a body.* but", ",", line) for line in text.text.splitlines()]
    heading = "CMD_GET_ANGLES (73)  host to board, 0 bytes  GetAnglesRequest"
    bad = "looks like CMD_GET_ANGLES (73) from the host, the checksum of its body is 0x01, not 0x00"
    missing = "the checksum of its body, 0x0a, is missing: the next frame begins in its place"
    assert shown == [
        f"@0  {heading}",
        "@5  no frame: 19 bytes",
        f"    @5: looks like CMD_CONTROL (67) from the host, {missing}",
        f"@24  {heading}",
        "@29  no frame: 25 bytes",
        f"    @29: {bad}",
        f"    @34: {bad}",
        f"    @39: {bad}",
        f"@54  {heading}",
        "3 frames, 44 bytes skipped (bad headers: 0, bad bodies: 6)",
    ]


def test_explanations_do_not_depend_on_how_the_bytes_arrive(tmp_path: Path) -> None:
    generator = random.Random(4)
    parts = [GET_ANGLES, CONTROL, CONTROL[:-1], BAD_SUM, b"\x3e\x3e", bytes(700), BOARD_INFO[:9]]
    data = b"".join(generator.choices(parts, k=300))
    whole = run("decode", stdin=data)
    with subprocess.Popen(
        [PROGRAM, "decode"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0
    ) as process:
        assert process.stdin and process.stdout
        with ThreadPoolExecutor(1) as pool:
            shown = pool.submit(process.stdout.read)
            while data:
                size = generator.randrange(1, 100)
                process.stdin.write(data[:size])
                data = data[size:]
            process.stdin.close()
            assert shown.result() == whole.out


@pytest.mark.parametrize(
    "data, options, guess",
    [
        (b"3e 49 00 49 00\n", ["--raw"], "this looks like hex text: use --hex"),
        (b"Hello, world", [], "this is text without bytes"),
        (b"12 xy", [], "this is text, but not of bytes: hex text, line 1 column 4: 'x' is not"),
        (b'{"message":"MotorsOn","fields":{}}\n', [], "use sbgc encode"),
        (gzip.compress(GET_ANGLES), [], "this is compressed: unpack it first"),
        (b"\xd4\xc3\xb2\xa1" + bytes(20), [], "this is a capture of network packets"),
        (bytes.fromhex("3e95847d46211b0000"), [], "its baud rate or parity may be wrong"),
    ],
)
def test_input_without_a_frame(data: bytes, options: list[str], guess: str) -> None:
    for form in ("text", "jsonl"):
        result = run("decode", "--format", form, *options, stdin=data)
        assert result.status == 1
        assert result.error.startswith(f"sbgc: found no frame in {len(data)} bytes; ")
        assert guess in result.error
        assert form == "text" or result.out == b""


def test_noise_is_not_explained_as_frames() -> None:
    """Among many start bytes, some are followed by an accidental header."""
    noise = bytes(random.Random(5).choices(range(256), k=200_000))
    result = run("decode", "--format", "jsonl", stdin=noise)
    assert result.status == 1
    assert "parity may be wrong" in result.error and "looks like" not in result.error


def test_raw_bytes_are_no_hex_text() -> None:
    assert "for raw bytes, use --raw" in run("decode", "--hex", stdin=GET_ANGLES).error
    assert "--raw" not in run("decode", "--hex", stdin="3e 49 zz").error


@pytest.mark.parametrize(
    "text",
    ["3e 49 00 49 00\n", "# a capture\n0x3e,0x49, 00,\n49 00", "3E4900", "\n\n3e:49:00:49:00"],
)
def test_hex_text_is_recognized(text: str) -> None:
    assert run("decode", stdin=text) == run("decode", "--hex", stdin=text)
    if text.startswith("3e"):
        assert decode_one(text)["message"] == "GetAnglesRequest"


@pytest.mark.parametrize(
    "text",
    ["{0x3E, 0x49, 0x00, 0x49, 0x00};", "[3e][49] (00) 49 00", r'"\x3e\x49\x00\x49\x00"'],
)
def test_bytes_of_source_code_are_recognized(text: str) -> None:
    assert decode_one(text)["message"] == "GetAnglesRequest"


def test_a_frame_without_a_direction_is_what_can_be_decoded() -> None:
    line = decode_one(frame(254, bytes(14)))
    assert (line["message"], line["direction"]) == ("DebugVars3", "from_board")


def test_a_bad_body_without_a_direction_shows_its_own_values() -> None:
    """Those of the direction that is named, not of the other one, which was tried as well."""
    for size in (3, 14):
        bad = frame(35, bytes(range(1, size + 1)))
        text = run("decode", stdin=bad).text
        assert "host to board (a guess)" in text and "too_short" in text, "the nearest"
        assert text.replace(" (a guess)", "") == run("decode", "--from", "host", stdin=bad).text


def test_a_body_between_two_forms_is_shown_as_the_longer_one() -> None:
    text = run("decode", "--from", "board", stdin=frame(53, b"\x02\x01")).text
    assert "unknown_form" in text and "file_size  258" in text and "err_code" not in text


def padded(leaves: list[dict], fill: int) -> tuple[bytes, bytes]:
    """A body, and the same as a C struct that is not packed, of leaves of a message."""
    packed, struct_ = b"", b""
    alignments = []
    for i, leaf in enumerate(leaves):
        size = int(leaf["type"][1:]) // 8
        alignments.append(1 if size == 3 else size)
        for element in range(leaf["count"]):
            value = bytes((17 * i + element + k) % 4 for k in range(size))
            struct_ += bytes([fill]) * (-len(struct_) % alignments[-1]) + value
            packed += value
    return packed, struct_ + bytes([fill]) * (-len(struct_) % max(alignments))


def test_a_struct_with_padding_is_recognized() -> None:
    """In each request of numbers at fixed places, unless another form has this size."""
    found = 0
    for message in MODEL["messages"]:
        leaves = message["layout"]
        is_fixed = message["direction"] == "to_board" and message["min_size"] == message["max_size"]
        if not is_fixed or any(not re.fullmatch(r"[uif]\d+", leaf["type"]) for leaf in leaves):
            continue
        if not leaves or any("when" in leaf for leaf in leaves):
            continue
        packed, with_padding = padded(leaves, 0xAA)
        size = len(with_padding)
        others = [m for m in MODEL["messages"] if m["id"] == message["id"] and m is not message]
        if len(packed) != message["min_size"] or size == len(packed):
            continue
        if any(m["min_size"] <= size <= m["max_size"] for m in others):
            continue
        text = run("decode", "--from", "host", stdin=frame(message["id"], with_padding)).text
        assert "padding behind" in text, message["name"]
        if "without the padding:" in text:
            if any(other["direction"] == "to_board" for other in others):
                continue  # several forms may have this size with padding
            values = text.split("without the padding:\n")[1].split("1 frame")[0]
            right = run("decode", "--from", "host", stdin=frame(message["id"], packed)).text
            assert values in right
        found += 1
    assert found > 5


def test_a_request_that_fits_neither_direction() -> None:
    """From a forum: a struct of C with 14 bytes, not an answer with another id."""
    data = "3e430e510200f5000000f5001c07f50055055e"
    result = run("decode", data)
    assert result.status == 1 and "the body fits" not in result.text
    assert "CMD_CONTROL (67)  host to board (a guess), 14 bytes\n" in result.text
    assert (
        "14 bytes; the nearest form, Control, has 13; padding behind control_mode, as in a C "
        "struct that is not packed, explains the size (unknown_form, offset 0, valid: 13, 15)"
    ) in result.text
    assert re.search(r"axes.yaw.angle +1365 +29.99\d* deg", result.text)
    (line,) = decode(data)  # JSON lines: a frame with an error, as the contract says
    assert line["error"] == {"code": "unknown_form", "field": "", "offset": 0}
    assert line["direction"] == "to_board" and line["body"] == data[8:-2]
    text = run("decode", "--from", "host", stdin=frame(67, bytes(12))).text
    assert "Control, has 13: 1 byte missing, perhaps a field that was left out" in text
    assert "(a guess)" not in text
    many = run("decode", stdin=bytes.fromhex(data) + GET_ANGLES)
    assert many.status == 0, "others can be decoded"


@pytest.mark.parametrize(
    "data, is_guess",
    [
        (GET_ANGLES, False),
        (BOARD_INFO, False),
        (frame(67, bytes(13)), False),
        (frame(67, b"\x55"), False),
        (frame(88, bytes(10)), True),  # the answer has any size
        (frame(31, b"\x01\x02" + bytes(4)), True),  # the same in both directions
        (frame(252, b"\x01"), True),
    ],
)
def test_a_guess_is_called_one(data: bytes, is_guess: bool) -> None:
    assert ("(a guess)" in run("decode", stdin=data).text) == is_guess
    assert "(a guess)" not in run("decode", "--from", "board", stdin=data).text


def test_custom_data_without_its_request() -> None:
    """The flags of the request decide; some blocks would fit."""
    words = "the flags of the request decide what the tail holds"
    answer = frame(88, bytes.fromhex("c10efdff0c004900"))
    text = run("decode", stdin=answer).text
    assert f"{words}; its size is that of IMU_ANGLES, TARGET_ANGLES, " in text
    assert "ACC_DATA" in text and "RC_DATA" not in text
    both = run("decode", stdin=frame(88, bytes(2 + 6 + 12))).text
    assert re.search(words + "; its size is that of .*IMU_ANGLES with RC_DATA", both) or (
        "IMU_ANGLES_RAD" not in both
    )
    assert words + "\n" in run("decode", stdin=frame(88, bytes(3))).text
    request = frame(88, struct.pack("<I6x", 0x10))
    assert words not in run("decode", stdin=request + answer).text


@pytest.mark.parametrize(
    "data, words",
    [
        (
            frame(85, b"\x18" + bytes(20)),
            "24  has no name; the nearest are CMD_REALTIME_DATA_3 (23) and CMD_REALTIME_DATA_4 (25)",
        ),
        (frame(67, b"\x4c" + bytes(12)), "has no name for mode 12; the nearest is MODE_"),
        (frame(85, b"\x19" + bytes(20)), None),
        (frame(85, bytes(21)), None),  # 0 is none of them
    ],
)
def test_enum_values_without_a_name(data: bytes, words: str | None) -> None:
    text = run("decode", "--from", "host", stdin=data).text
    assert ("has no name" in text) == (words is not None)
    assert re.sub(" +", " ", words or "") in re.sub(" +", " ", text)
    objections = decode_one(data, "--from", "host", "--firmware", "2.74.5")["objections"]
    assert any("has no name" in text for text in objections.values()) == (words is not None)


def test_a_short_body_shows_the_fields_that_arrived() -> None:
    body = struct.pack("<9h", *range(100, 1000, 100))
    for size in range(18):
        lines = run("decode", "--from", "board", stdin=frame(73, body[:size])).text.splitlines()
        unit = "byte" if size == 1 else "bytes"
        assert f"error: {size} {unit}, the message needs 18 (too_short, " in lines[1]
        shown = [int(line.split()[1]) for line in lines[3:-1]]
        assert shown == list(range(100, 1000, 100))[: size // 2]
    (line,) = decode(frame(73, body[:5]), "--from", "board", "--real")
    assert line["body"] == body[:5].hex() and "fields" not in line
    assert [value["raw"] for value in line["values"].values()] == [100, 200]
    row = run("decode", "--format", "csv", "--from", "board", stdin=frame(73, body[:5])).text
    assert row.splitlines()[1].endswith("," * 7) and "2.197265625" in row
    for condition, count in (("roll.imu_angle=raw:100", 1), ("pitch.imu_angle=0", 0)):
        options = ("--from", "board", "-w", condition)
        assert len(decode(frame(73, body[:5]), *options)) == count
        text = run("decode", *options, stdin=frame(73, body[:5])).text
        assert text.endswith("none of them is selected\n") == (count == 0)


IMU_ANGLES, TARGET_ANGLES, RC_DATA, ENCODER_RAW24, IMU_ANGLES_RAD = 1, 2, 0x20, 0x800, 0x1000


@pytest.mark.parametrize(
    "flags, size, words",
    [
        (
            IMU_ANGLES | TARGET_ANGLES | RC_DATA | ENCODER_RAW24,
            26,
            "26 bytes, the flags need 35, and 26 without ENCODER_RAW24",
        ),
        (  # two blocks of this size
            IMU_ANGLES | TARGET_ANGLES | ENCODER_RAW24,
            17,
            "17 bytes, the flags need 23",
        ),
        (IMU_ANGLES, 5, "5 bytes, the flags need 8"),
        (
            ENCODER_RAW24 | IMU_ANGLES_RAD,
            14,
            "14 bytes, the flags need 23, and 14 without ENCODER_RAW24",
        ),
    ],
)
def test_a_body_without_an_announced_block(flags: int, size: int, words: str) -> None:
    """Blocks after the missing one are elsewhere, so only what precedes all blocks has a value."""
    request = frame(88, struct.pack("<I6x", flags))
    answer = frame(88, b"\x2c\x01" + bytes(range(1, size - 1)))
    _, line = decode(request + answer)
    assert line["message"] == "RealtimeDataCustom" and "fields" not in line
    assert line["error"]["code"] == "too_short" and line["body"] == answer[4:-1].hex()
    text = run("decode", stdin=request + answer).text.split("board to host")[1]
    assert f"error: {words} (too_short, " in text
    assert re.findall(r"^    (\w[\w.]*)  +(\d+)", text, re.MULTILINE) == [("timestamp_ms", "300")]
    (_, values) = decode(request + answer, "--real")
    assert list(values["values"]) == ["timestamp_ms"]


def test_empty_input() -> None:
    assert decode(b"") == []
    assert decode(b"# only a comment\n", "--hex") == []
    assert run("decode", "--format", "text").status == 0


def test_a_large_capture() -> None:
    """The input is larger than one block, so frames cross the block boundaries."""
    parts = []
    offsets = []
    generator = random.Random(1)
    at = 0
    while at < 300_000:
        gap = bytes(generator.choices(range(0x3D), k=generator.randrange(4)))
        offsets.append(at + len(gap))
        parts.append(gap + BOARD_INFO)
        at += len(parts[-1])
    assert [line["offset"] for line in decode(b"".join(parts))] == offsets


@pytest.mark.parametrize("direction", ["board", "host"])
def test_unknown_command(direction: str) -> None:
    line = decode_one(frame(252, b"\x01\x02"), "--from", direction)
    assert line["command"] is None
    assert line["message"] is None
    assert line["error"] == {"code": "unknown_command", "field": "", "offset": 0}
    assert line["body"] == "0102"
    assert "fields" not in line


def test_wrong_size() -> None:
    line = decode_one(frame(86, bytes(5)), "--from", "board")
    assert line["command"] == "CMD_BOARD_INFO"
    assert line["message"] == "BoardInfo"
    assert line["error"]["code"] == "too_short"
    assert line["error"]["offset"] == 5
    assert line["error"]["field"] == "board_features"
    assert line["body"] == "0000000000"
    assert "fields" not in line
    line = decode_one(frame(67, b"\x01"), "--from", "host")
    assert line["message"] is None
    assert line["error"]["code"] == "unknown_form"
    line = decode_one(frame(31, b"\x02\x01\x00\x00\x00\x00\x01"), "--from", "board")
    assert line["error"] == {"code": "too_short", "field": "params", "offset": 7}


def test_id_67_depends_on_who_speaks() -> None:
    control = frame(67, bytes(13))
    assert decode_one(control, "--from", "host")["message"] == "Control"
    assert decode_one(control, "--from", "board")["message"] == "Confirm"
    assert decode_one(control)["message"] == "Control"
    confirm = frame(67, b"\x55")
    assert decode_one(confirm)["message"] == "Confirm"
    assert decode_one(confirm)["command"] == "CMD_CONFIRM"
    assert decode_one(confirm, "--from", "host")["error"]["code"] == "unknown_form"
    assert decode_one(confirm, "--from", "host")["command"] == "CMD_CONTROL"


def test_bytes_that_later_firmware_appends() -> None:
    line = decode_one(frame(86, bytes(18) + b"\xab\xcd"), "--from", "board")
    assert line["fields"]["tail"] == "abcd"


def test_hex_input() -> None:
    text = "# a capture\n3E 49:00,49 00 # a frame\n0x3e 0x49\t0x00 0X49 0x00\r\n3e49004900"
    assert [line["offset"] for line in decode(text, "--hex")] == [0, 5, 10]


def test_every_digit_of_hex_text() -> None:
    data = frame(151, bytes(range(0x00, 0xFF, 0x11)) + bytes([0xAF, 0xFA]))
    raw = run("decode", "--raw", stdin=data).text
    for text in (data.hex(), data.hex().upper()):
        assert run("decode", "--hex", stdin=text).text == raw


def test_file_and_dash(tmp_path: Path) -> None:
    capture = tmp_path / "capture.bin"
    capture.write_bytes(GET_ANGLES)
    assert decode(b"", str(capture)) == decode(GET_ANGLES, "-") == decode(GET_ANGLES)


def test_live_input_comes_out_at_once() -> None:
    """A frame is printed as soon as it is complete, not at the end of the input."""
    with subprocess.Popen(
        [PROGRAM, "decode", "--format", "jsonl"], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as process:
        assert process.stdin and process.stdout
        process.stdin.write(GET_ANGLES)
        process.stdin.flush()
        assert json.loads(process.stdout.readline())["id"] == 73
        process.stdin.close()
        assert process.wait(10) == 0


def test_every_command_in_both_directions() -> None:
    """Every frame yields exactly one line, with fields or with an error."""
    generator = random.Random(2)
    for direction in ("board", "host"):
        frames = [
            frame(command, bytes(generator.choices(range(256), k=size)))
            for command in range(1, 256)
            for size in (0, 1, generator.randrange(256), 255)
        ]
        lines = decode(b"".join(frames), "--from", direction)
        # A body can be taken for a frame only if the frame around it is broken; here none is.
        assert [line["id"] for line in lines] == [data[1] for data in frames]
        for line, data in zip(lines, frames):
            keys = ["offset", "command", "id", "message", "direction", "framing"]
            assert list(line) == keys + (["error", "body"] if "error" in line else ["fields"])
            if "error" in line:
                assert line["body"] == data[4:-1].hex()
                assert set(line["error"]) == {"code", "field", "offset"}


def test_a_failed_command_has_the_name_of_a_command() -> None:
    """67 is CMD_CONFIRM only where a confirmation itself is meant."""
    error = run("decode", stdin=frame(255, bytes.fromhex("430a01000000"))).text
    assert "CMD_CONTROL" in error and "CMD_CONFIRM" not in error


def test_a_body_too_short_for_every_form() -> None:
    """What arrived is shown as in the next longer form."""
    text = run("decode", "--from", "host", stdin=frame(67, bytes([1, 2, 3, 4]))).text
    assert "(unknown_form, offset 0, valid: 13, 15)" in text
    assert re.search(r"control_mode +1 +MODE_SPEED\n +axes\.roll\.speed +770 ", text)
    (line,) = decode(frame(67, bytes([1, 2, 3, 4])), "--from", "host", "--real")
    assert line["message"] is None and "values" not in line


def test_text() -> None:
    """The text form of a few frames, as people read it. After an intended change, update it with:
    sbgc decode --hex tests/tools/capture.hex > tests/tools/capture.txt"""
    folder = ROOT / "tests" / "tools"
    result = run("decode", "--format", "text", "--hex", str(folder / "capture.hex"))
    assert result.status == 0
    assert result.text == (folder / "capture.txt").read_text(encoding="utf-8")
    assert run("decode", "--hex", str(folder / "capture.hex")) == result, "text is the default"


def control(yaw: int) -> bytes:
    return frame(67, bytes([2]) + struct.pack("<6h", 0, 0, 0, -100, 0, yaw))


FRAMES = GET_ANGLES + control(10) + frame(73, struct.pack("<9h", *range(9))) + control(4096)


@pytest.mark.parametrize(
    "options, offsets",
    [
        (["-m", "GetAngles"], [23]),
        (["-m", "CMD_GET_ANGLES"], [0, 23]),
        (["-m", "get_angles"], [0, 23]),
        (["-m", "67"], [5, 46]),
        (["-m", "0x43"], [5, 46]),
        (["-m", "67", "-m", "GetAngles"], [5, 23, 46]),
        (["-w", "yaw.angle = 90deg"], [46]),
        (["-w", "axes.yaw.angle != 90deg"], [5]),
        (["-w", "yaw.angle > 0"], [5, 46]),
        (["-w", "yaw.angle>=raw:11"], [46]),
        (["-w", "yaw.angle<raw:11"], [5]),
        (["-w", "yaw.angle<raw:10"], []),
        (["-w", "yaw.angle<=raw:10"], [5]),
        (["-w", "yaw.angle<=raw:9"], []),
        # Any axis.
        (["-w", "imu_angle = raw:3"], [23]),
        (["-w", "axes.roll.angle=0", "-m", "67"], [5, 46]),
    ],
)
def test_filters(options: list[str], offsets: list[int]) -> None:
    assert [line["offset"] for line in decode(FRAMES, *options)] == offsets
    text = run("decode", *options, stdin=FRAMES).text
    assert [int(at) for at in re.findall(r"^@(\d+)", text, re.MULTILINE)] == offsets


def test_flags_are_filtered_one_by_one() -> None:
    both, one, none = (frame(86, bytes(4) + bytes([flags]) + bytes(13)) for flags in (3, 2, 0))
    stream = both + one + none
    name = "board_features & BOARD_FEATURE_BAT_MONITORING"
    assert [line["offset"] for line in decode(stream, "-w", name)] == [0, len(both)]
    name = "board_features & BOARD_FEATURE_3AXIS"
    assert [line["offset"] for line in decode(stream, "-w", name)] == [0]


@pytest.mark.parametrize(
    "options, words",
    [
        (["-m", "GetAngels"], "no message 'GetAngels'; did you mean"),
        (["-m", "300"], "no message '300'"),
        (["-w", "imu_angel=3"], "no message has a field 'imu_angel'; did you mean 'imu_angle'"),
        (["-w", "imu_angle"], "is no condition"),
        (["-w", "mode=MODE_SPEEED"], "'MODE_SPEEED' is not a name of"),
        (["-w", "cycle_time > 70000"], "70000 does not fit: 0 us to 65535 us"),
        (["-w", "config > 3"], "is a group; name one of its fields"),
        (["-m", "CMD_CONTROL", "-w", "cycle_time > 7"], "the selected messages have no such field"),
        (["-w", "=3"], "is no condition"),
        (["--to", "1"], "only a capture has times"),
        (["--from", "board", "--from", "3s"], "only a capture has times"),
        (["--to", "later"], "'later' is not a time"),
        (["--from", "board", "--from", "host"], "--from takes one sender and one time"),
        (["--from", "3", "--to", "1"], "the time of --from is after that of --to"),
        (["--real"], "--real is for --format jsonl"),
    ],
)
def test_filters_that_cannot_be(options: list[str], words: str) -> None:
    result = run("decode", *options, stdin=FRAMES)
    assert result.status == 2 and words in result.error and result.out == b""


def test_what_is_like_no_word_at_all_has_no_suggestion() -> None:
    name = "system_power_state.motors.pitch.mot_current"
    for length, is_like_it in ((57, True), (58, False)):
        result = run("decode", "-w", f"{name:x<{length}}=3")
        assert result.status == 2
        assert (f"did you mean '{name}'" in result.error) == is_like_it


def test_csv() -> None:
    rows = run("decode", "--format", "csv", "-m", "GetAngles", stdin=FRAMES * 2).text.splitlines()
    header = rows[0].split(",")
    assert header[:3] == ["offset", "axes.roll.imu_angle[deg]", "axes.roll.rc_target_angle[deg]"]
    assert len(rows) == 3 and all(len(row.split(",")) == len(header) == 10 for row in rows)
    values = [float(value) for value in rows[2].split(",")]
    assert values[0] == len(FRAMES) + 23
    scales = [360 / 2**14, 360 / 2**14, 0.1220740379]
    assert values[1:] == pytest.approx([i * scales[i % 3] for i in range(9)], rel=1e-6)
    mixed = run("decode", "--format", "csv", stdin=FRAMES)
    assert mixed.status == 1 and "choose with --message" in mixed.error


def test_csv_of_texts() -> None:
    names = ["plain", 'a "b"', "c, d", '",', ""]
    body = b"".join(name.encode().ljust(48, b"\0") for name in names)
    rows = run("decode", "--format", "csv", "--from", "board", stdin=frame(28, body)).text
    assert rows.splitlines()[1] == '0,plain,"a ""b""","c, d",""",",'
    (_, row) = csv.reader(io.StringIO(rows))
    assert row[1:] == names


def test_real_values() -> None:
    (line,) = decode(control(4096), "--real")
    assert line["values"]["axes.yaw.angle"] == {"raw": 4096, "real": 90.0, "unit": "deg"}
    assert line["values"]["control_mode"] == {"raw": 2, "text": "MODE_ANGLE"}
    plain = decode_one(control(4096))
    assert {key: line[key] for key in plain} == plain and list(line)[-1] == "values"


@pytest.mark.skipif(ON_WINDOWS, reason="Wine takes no pseudo-terminal for a console")
def test_colors_only_on_a_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    def on_a_terminal() -> str:
        outside, inside = os.openpty()
        run("decode", "--hex", stdin=FRAMES.hex(), stdout=inside)
        os.close(inside)
        shown = b""
        try:
            while block := os.read(outside, 65536):
                shown += block
        except OSError:  # the end
            pass
        os.close(outside)
        return shown.decode().replace("\r\n", "\n")

    plain = run("decode", "--hex", stdin=FRAMES.hex()).text
    assert "\x1b" not in plain
    colored = on_a_terminal()
    assert "\x1b[1mCMD_CONTROL\x1b[0m" in colored
    assert re.sub(r"\x1b\[\d*m", "", colored) == plain
    monkeypatch.setenv("NO_COLOR", "1")
    assert on_a_terminal() == plain
