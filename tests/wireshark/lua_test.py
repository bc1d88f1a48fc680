"""The dissector makes the same trees under Lua 5.2 to 5.4 as in Wireshark, which has one of them."""

from __future__ import annotations

import json
import math
import subprocess
import xml.etree.ElementTree as xml
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from damaged_frames import damaged
from line import DISSECTOR, ROOT, Packet, line, tshark
from sbgc_command import frame

LONGEST_LABEL = 200  # Wireshark cuts longer ones


def packets() -> Iterator[Packet]:
    """Every third vector in a session of its own, behind the messages that it needs; then damaged frames."""
    paths = sorted((ROOT / "generated" / "vectors").glob("*.jsonl"))
    texts = [text for path in paths for text in path.read_text("utf-8").splitlines()]
    vectors = [vector for vector in map(json.loads, texts) if "hex" in vector]
    for host, vector in enumerate(vectors[::3]):
        for one in (*vector.get("after", ()), vector):
            direction = 1 if one["direction"] == "from_board" else 2
            yield Packet(frame(one["id"], bytes.fromhex(one["hex"])), direction, host)
    yield from damaged(500)


@pytest.fixture(scope="module", name="captured")
def captured_packets(tmp_path_factory: pytest.TempPathFactory) -> tuple[str, list[Any]]:
    """The packets for the stand-in, and what tshark shows of them."""
    file = tmp_path_factory.mktemp("lua") / "packets"
    file.write_bytes(line(packets()))
    sent, host = [], None
    for one in packets():
        if one.host != host:
            sent.append("1 ")
        host = one.host
        sent.append(f"{2 - one.direction} {one.data.hex()}")
    out = xml.fromstring(tshark(file, "-T", "pdml", "-J", "sbgc"))
    protos = (proto for proto in out.iter("proto") if proto.get("name") == "sbgc")
    shown = [e for proto in protos for e in proto.iter() if is_of_lua(str(e.get("name")))]
    return "\n".join(sent) + "\n", shown


@pytest.mark.parametrize("version", ["5.2", "5.3", "5.4"])
def test_trees_do_not_depend_on_lua(version: str, captured: tuple[str, list[Any]]) -> None:
    sent, shown = captured
    done = subprocess.run(
        [f"lua{version}", Path(__file__).with_name("stand_in.lua"), DISSECTOR],
        input=sent,
        stdout=subprocess.PIPE,
        text=True,
        timeout=300,
        check=True,
    )
    made = [text.split("\t") for text in done.stdout.splitlines()]
    for (name, at, size, kind, text), element in zip(made, shown):
        label = str(element.get("showname"))
        assert name == element.get("name"), (text, element.attrib)
        if not name.startswith("sbgc.expert."):
            assert (at, size) == (element.get("pos"), element.get("size")), element.attrib
        if kind == "number":
            assert is_close(float(text), str(element.get("show"))), (text, element.attrib)
        elif "\\x" not in text and len(label) < LONGEST_LABEL:
            is_same = {"is": label == text, "ends": label.endswith(text), "value": text in label}
            assert is_same.get(kind, True), (kind, text, element.attrib)
    assert len(made) == len(shown) > 50_000


def is_of_lua(name: str) -> bool:
    return name.startswith("sbgc") or name == "_ws.lua.text"


def is_close(number: float, show: str) -> bool:
    found = float(int(show, 16)) if show.startswith("0x") else float(show)
    return math.isnan(number) == math.isnan(found) and (
        math.isnan(number) or math.isclose(number, found, rel_tol=1e-5, abs_tol=1e-30)
    )
