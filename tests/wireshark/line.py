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
BOARD_PORT, HOST_PORT = 5000, 40000


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


def shown(file: Path, *options: str) -> Iterator[Shown]:
    """What tshark shows of each frame, in order."""
    for number, packet in enumerate(xml.fromstring(tshark(file, "-T", "pdml", *options)), 1):
        for proto in packet.iter("proto"):
            if proto.get("name") == "sbgc":
                yield Shown(number, [one for one in proto.iter("field")])


def _block(kind: int, content: bytes) -> bytes:
    size = struct.pack("<I", len(content) + 12)
    return struct.pack("<I", kind) + size + content + size


def _padded(data: bytes) -> bytes:
    return data + bytes(-len(data) % 4)


def pcapng(
    packets: Iterable[tuple[float, int, bytes]], link: int = 160, begins: Optional[float] = None
) -> bytes:
    """A file of packets with time, direction (1 from the board, 2 to it) and bytes."""
    found = _block(0x0A0D0D0A, struct.pack("<IHHq", 0x1A2B3C4D, 1, 0, -1))
    found += _block(1, struct.pack("<HHI", link, 0, 0))
    for seconds, direction, data in packets:
        count = round(seconds * 1e6)
        head = struct.pack("<IIIII", 0, count >> 32, count & 0xFFFFFFFF, len(data), len(data))
        flags = struct.pack("<HHIHH", 2, 4, direction, 0, 0)
        found += _block(6, head + _padded(data) + flags)
    return found


def _ip(protocol: int, is_from_board: bool, data: bytes) -> bytes:
    ends = bytes((127, 0, 0, 1)), bytes((127, 0, 0, 2))
    source, target = ends if is_from_board else ends[::-1]
    head = struct.pack(">BBHHHBBH", 0x45, 0, 20 + len(data), 0, 0, 64, protocol, 0)
    return head + source + target + data


def _ports(is_from_board: bool) -> tuple[int, int]:
    return (BOARD_PORT, HOST_PORT) if is_from_board else (HOST_PORT, BOARD_PORT)


def udp(packets: Iterable[tuple[float, int, bytes]]) -> bytes:
    """The packets as datagrams between a board and a host."""

    def datagram(direction: int, data: bytes) -> bytes:
        head = struct.pack(">HHHH", *_ports(direction == 1), 8 + len(data), 0)
        return _ip(17, direction == 1, head + data)

    return pcapng([(t, 0, datagram(d, data)) for t, d, data in packets], link=101)


def tcp(packets: Iterable[tuple[float, int, bytes]]) -> bytes:
    """The packets as segments of a connection."""
    at = {1: 1000, 2: 2000}
    made = []
    for seconds, direction, data in packets:
        ports = _ports(direction == 1)
        head = struct.pack(
            ">HHIIBBHHH", *ports, at[direction], at[3 - direction], 0x50, 0x18, 8192, 0, 0
        )
        made.append((seconds, 0, _ip(6, direction == 1, head + data)))
        at[direction] += len(data)
    return pcapng(made, link=101)
