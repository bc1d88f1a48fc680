"""Runs tshark with the dissector, on packets that the tests make.

The environment variable SBGC names the sbgc command, as in tests/tools.
"""

from __future__ import annotations

import re
import struct
import subprocess
import xml.etree.ElementTree as xml
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Optional

ROOT = Path(__file__).resolve().parents[2]
DISSECTOR = ROOT / "generated" / "wireshark" / "simplebgc.lua"
LUA_PROBLEM = re.compile(r"Lua Error|Lua: |stack traceback")
BOARD_PORT, HOST_PORT = 33000, 52000  # nobody else's in Wireshark 4.4


def tshark(file: Path, *options: str, dissector: Path = DISSECTOR) -> str:
    """The output of tshark for a file; nothing may go wrong in Lua."""
    done = subprocess.run(
        ["tshark", "-n", "-X", f"lua_script:{dissector}", "-r", str(file), *options],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        timeout=300,
        check=False,
    )
    out, problems = done.stdout.decode(errors="replace"), done.stderr.decode()
    assert done.returncode == 0, problems
    assert not LUA_PROBLEM.search(problems), problems
    assert "Lua Error" not in out, re.findall(".*Lua Error.*", out)[:3]
    return out


@dataclass
class Shown:
    """A frame as tshark shows it, or bytes that are none."""

    packet: int
    fields: list[Any] = field(default_factory=list)  # elements of PDML, in order

    def all(self, name: str) -> list[Any]:
        return [one for one in self.fields if one.get("name") == name]

    def text(self, name: str) -> str:
        return str(self.all(name)[0].get("show")) if self.all(name) else ""

    @property
    def experts(self) -> set[str]:
        names = (str(one.get("name")) for one in self.fields)
        return {n.rpartition(".")[2] for n in names if n.startswith("sbgc.expert.")}


def shown(file: Path, *options: str, dissector: Path = DISSECTOR) -> Iterator[Shown]:
    """Yields the fields that tshark shows of each frame, in order."""
    out = tshark(file, "-T", "pdml", *options, dissector=dissector)
    for number, packet in enumerate(xml.fromstring(out), 1):
        for proto in packet.iter("proto"):
            if proto.get("name") == "sbgc":
                yield Shown(number, [one for one in proto.iter("field")])


def _block(kind: int, content: bytes) -> bytes:
    size = struct.pack("<I", len(content) + 12)
    return struct.pack("<I", kind) + size + content + size


def _padded(data: bytes) -> bytes:
    return data + bytes(-len(data) % 4)


def pcapng(packets: Iterable[tuple[float, int, bytes]], link: int = 160) -> bytes:
    """A file of packets with time, direction (1 from the board, 2 to it) and bytes."""
    found = [
        _block(0x0A0D0D0A, struct.pack("<IHHq", 0x1A2B3C4D, 1, 0, -1)),
        _block(1, struct.pack("<HHI", link, 0, 0)),
    ]
    for seconds, direction, data in packets:
        count = round(seconds * 1e6)
        head = struct.pack("<IIIII", 0, count >> 32, count & 0xFFFFFFFF, len(data), len(data))
        flags = struct.pack("<HHIHH", 2, 4, direction, 0, 0)
        found.append(_block(6, head + _padded(data) + flags))
    return b"".join(found)


def _ip(protocol: int, is_from_board: bool, data: bytes) -> bytes:
    ends = bytes((127, 0, 0, 1)), bytes((127, 0, 0, 2))
    source, target = ends if is_from_board else ends[::-1]
    head = struct.pack(">BBHHHBBH", 0x45, 0, 20 + len(data), 0, 0, 64, protocol, 0)
    return head + source + target + data


@dataclass(frozen=True)
class Packet:
    """Bytes of one direction (1 from the board, 2 to it). Hosts differ in their port."""

    data: bytes
    direction: int = 1
    host: int = HOST_PORT
    time: Optional[float] = None


def _ports(packet: Packet) -> tuple[int, int]:
    return (BOARD_PORT, packet.host) if packet.direction == 1 else (packet.host, BOARD_PORT)


def line(packets: Iterable[Packet]) -> bytes:
    """The packets as a recorded line; each other host begins a session."""
    made, host, now = [], None, 0.0
    for packet in packets:
        now = now + 0.001 if packet.time is None else packet.time
        if packet.host != host:
            made.append((now, 0, b""))
        host = packet.host
        made.append((now, packet.direction, packet.data))
    return pcapng(made)


def udp(packets: Iterable[Packet]) -> bytes:
    """The packets as datagrams between boards and hosts."""
    made = []
    for number, packet in enumerate(packets):
        head = struct.pack(">HHHH", *_ports(packet), 8 + len(packet.data), 0)
        made.append((number / 1000, 0, _ip(17, packet.direction == 1, head + packet.data)))
    return pcapng(made, link=101)


def tcp(packets: Iterable[Packet]) -> bytes:
    """The packets as segments of connections."""
    at: dict[tuple[int, int], int] = {}
    made = []
    for number, packet in enumerate(packets):
        own, other = (packet.host, packet.direction), (packet.host, 3 - packet.direction)
        sent, seen = at.setdefault(own, 1000), at.setdefault(other, 1000)
        head = struct.pack(">HHIIBBHHH", *_ports(packet), sent, seen, 0x50, 0x18, 8192, 0, 0)
        made.append((number / 1000, 0, _ip(6, packet.direction == 1, head + packet.data)))
        at[own] += len(packet.data)
    return pcapng(made, link=101)


CARRIERS = {"line": line, "udp": udp, "tcp": tcp}
DECODE_AS = [f"-dudp.port=={BOARD_PORT},sbgc", f"-dtcp.port=={BOARD_PORT},sbgc"]
