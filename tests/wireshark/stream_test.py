"""Exactly the frames of the reference semantics, however the bytes are cut into packets."""

from __future__ import annotations

import json
import random
from collections.abc import Iterator
from pathlib import Path

import pytest

from line import CARRIERS, DECODE_AS, HOST_PORT, ROOT, Packet, shown, tshark
from sbgc_command import frame

HIDDEN = "(hidden)"
WITH_PASSWORDS = (86, 137)
Found = tuple[int, str]  # id and body


def crc16(data: bytes) -> bytes:
    """The checksum of v2, bit by bit."""
    register = 0
    for byte in data:
        for bit in range(8):
            out = register >> 15 ^ byte >> bit & 1
            register = (register << 1 & 0xFFFF) ^ (0x8005 if out else 0)
    return register.to_bytes(2, "little")


def frame_v2(id_: int, body: bytes) -> bytes:
    """A frame of the second framing."""
    head = bytes((id_, len(body), (id_ + len(body)) % 256))
    return b"$" + head + body + crc16(head + body)


def frames_in(data: bytes) -> list[Found]:
    """The frames in bytes by the reference semantics."""
    found, at = [], 0
    while at < len(data):
        if data[at : at + 1] in (b">", b"$") and len(data) > at + 3 and data[at + 1]:
            body = data[at + 4 : at + 4 + data[at + 2]]
            make = frame if data[at] == ord(">") else frame_v2
            whole = make(data[at + 1], body)
            if len(body) == data[at + 2] and data.startswith(whole, at):
                found.append((data[at + 1], body.hex()))
                at += len(whole)
                continue
        at += 1
    return found


def streams() -> list[bytes]:
    """Those of the generator, and random ones: frames, also inside others and torn, and noise."""
    lines = (ROOT / "generated/frames.jsonl").read_text("utf-8").splitlines()
    found = [bytes.fromhex(json.loads(one)["stream"]) for one in lines]
    chance = random.Random(7)

    def piece(depth: int) -> bytes:
        kind = chance.randrange(6)
        if kind == 0:
            return bytes(chance.choices(b">>>$$$\x01\x00\x02\x56", k=chance.randint(1, 9)))
        inner = (
            piece(depth + 1) if depth < 3 and kind < 4 else chance.randbytes(chance.randint(0, 30))
        )
        whole = chance.choice((frame, frame_v2))(chance.randint(0, 255), inner[:255])
        return whole[: chance.randint(1, len(whole))] if kind == 1 else whole

    return found + [b"".join(piece(0) for _ in range(chance.randint(1, 9))) for _ in range(150)]


def cut(data: bytes, chance: random.Random) -> Iterator[bytes]:
    """The bytes in packets, of one byte or more."""
    most = chance.choice((2, 10, 100, len(data)))
    while data:
        size = chance.randint(1, most)
        yield data[:size]
        data = data[size:]


@pytest.mark.parametrize("carrier", CARRIERS)
def test_the_frames_of_every_cut(carrier: str, tmp_path: Path) -> None:
    chance = random.Random(carrier)
    packets: list[Packet] = []
    wanted: dict[int, list[Found]] = {}
    for host, stream in enumerate(filter(None, streams()), HOST_PORT):
        direction = chance.choice((1, 2))
        packets += [Packet(data, direction, host) for data in cut(stream, chance)]
        wanted[host] = frames_in(stream)
    hosts = [one.host for one in packets]
    if carrier == "line":  # each session begins with a packet of its own
        hosts = [
            host for i, host in enumerate(hosts) for _ in range(1 + (hosts[i - 1 : i] != [host]))
        ]
    else:  # other conversations are in between
        order = sorted(range(len(packets)), key=lambda i: (chance.random(), i))
        by_host = {host: iter([p for p in packets if p.host == host]) for host in wanted}
        packets = [next(by_host[packets[i].host]) for i in order]
        hosts = [one.host for one in packets]
    (tmp_path / "packets").write_bytes(CARRIERS[carrier](packets))
    found: dict[int, list[Found]] = {host: [] for host in wanted}
    for one in shown(tmp_path / "packets", "-2", "-J", "sbgc", *DECODE_AS):
        if not one.text("sbgc.id"):
            continue
        body = "".join(str(e.get("value")) for e in one.all("sbgc.body"))
        if not body and one.text("sbgc.size") != "0":
            body = HIDDEN
        found[hosts[one.packet - 1]].append((int(one.text("sbgc.id")), body))
    for host, frames in wanted.items():
        assert [id_ for id_, _ in found[host]] == [id_ for id_, _ in frames]
        for (id_, body), (_, expected) in zip(found[host], frames):
            assert body == expected or body == HIDDEN and id_ in WITH_PASSWORDS, host


def test_a_filter_and_a_second_pass_show_the_same(tmp_path: Path) -> None:
    chance = random.Random(1)
    frames = b"".join(frame(87, bytes(chance.randbytes(20))) + b">\x07" for _ in range(50))
    (tmp_path / "packets").write_bytes(
        CARRIERS["udp"](Packet(d) for d in cut(frames + frame(86), chance))
    )

    def seen(*options: str) -> list[list[dict[str, str]]]:
        found = shown(tmp_path / "packets", "-J", "sbgc", *options, *DECODE_AS)
        return [[dict(e.items()) for e in one.fields] for one in found]

    once = seen()
    assert once == seen("-2") == seen("-Y", "sbgc") == seen("-2", "-R", "sbgc", "-Y", "udp")
    text = tshark(tmp_path / "packets", "-V", *DECODE_AS)
    assert text.count("no frame: 2 bytes") == 50
    ids = tshark(tmp_path / "packets", "-Tfields", "-esbgc.id", "-Ysbgc.id==87", *DECODE_AS)
    assert ids.replace("\n", ",").count("87") == 50


def test_a_candidate_waits_for_the_end_of_the_conversation(tmp_path: Path) -> None:
    """A frame inside an incomplete candidate counts only if the rest of that never comes."""
    inner = frame(86)
    outer = frame(87, inner + bytes(20))
    for name, data, ids in (("whole", outer, ["87"]), ("torn", outer[:-4], ["86"])):
        (tmp_path / name).write_bytes(
            CARRIERS["line"]([Packet(data[:12], 2), Packet(data[12:], 2)])
        )
        found = [one.text("sbgc.id") for one in shown(tmp_path / name, "-2")]
        assert [one for one in found if one] == ids
    torn = tshark(tmp_path / "torn")
    assert "goes on" in torn and "BoardInfo" not in torn


def test_heuristics_find_the_frames_and_the_board(tmp_path: Path) -> None:
    for carrier in ("tcp", "udp"):
        packets = [Packet(frame(86, bytes(18)), 1), Packet(frame(86), 2), Packet(b"nothing", 2)]
        (tmp_path / carrier).write_bytes(CARRIERS[carrier](packets))
        found = list(shown(tmp_path / carrier))
        assert [one.text("sbgc.message") for one in found] == ["BoardInfo", "BoardInfoRequest", ""]
        assert found[2].experts == {"skipped"}
