"""Tests of sbgc decode. The keys and their meaning are a contract (design, section 8)."""

from __future__ import annotations

import csv
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


CONTROL = frame(67, bytes([0, 0, 2]) + struct.pack("<6h", 0, 0, 0, 0, 0, 2048))
BAD_SUM = GET_ANGLES[:-1] + b"\x01"


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
    data = b"".join(generator.choices(parts, k=3000))
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


def test_noise_is_not_explained_as_frames() -> None:
    """Among many start bytes, some are followed by an accidental header."""
    noise = bytes(random.Random(5).choices(range(256), k=200_000))
    result = run("decode", "--format", "jsonl", stdin=noise)
    assert result.status == 1
    assert "parity may be wrong" in result.error and "looks like" not in result.error


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
