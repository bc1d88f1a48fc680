"""Measure sbgc.read_capture() against a description of RealtimeData4 in `construct`, on the same file.

usage: captures.py PACKAGE_FOLDER    (writes the format of Google Benchmark)

The case "read" gives the array of all messages, "columns" all values in their units as well; "construct"
parses the same bytes with a description of the record, the frame and the message, "construct_compiled" with
one that construct has compiled to Python.
"""

from __future__ import annotations

import json
import random
import struct
import sys
import tempfile
import time
import zlib
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, sys.argv[1] if len(sys.argv) == 2 else sys.exit(__doc__))

construct: Any = import_module("construct")
sbgc: Any = import_module("sbgc")

MESSAGES, REPETITIONS = 200_000, 9
# construct parses this many in a few seconds.
PARSED = 4_000
TYPES = {
    "i8": construct.Int8sl,
    "u8": construct.Int8ul,
    "i16": construct.Int16sl,
    "u16": construct.Int16ul,
    "i32": construct.Int32sl,
    "u32": construct.Int32ul,
    "f32": construct.Float32l,
}


def facts() -> Any:
    model = json.loads((ROOT / "generated/simplebgc.json").read_text())
    return next(m for m in model["messages"] if m["name"] == "RealtimeData4")


def records(message: Any) -> bytes:
    """Records with a frame of random content each, as a line at full speed gives them."""
    numbers = random.Random(1)
    parts = []
    size = message["max_size"]
    head = bytes([message["id"], size, (message["id"] + size) % 256])
    for index in range(MESSAGES):
        body = numbers.randbytes(size)
        frame = b">" + head + body + bytes([sum(body) % 256])
        record = struct.pack("<BBHQ", 0xA5, 1, len(frame), index * 10_000) + frame
        parts.append(record + struct.pack("<I", zlib.crc32(record)))
    return b"".join(parts)


def description(message: Any) -> Any:
    """Counts the records, with construct."""
    fields = []
    for leaf in message["layout"]:
        kind = TYPES.get(leaf["type"])
        if kind is None:
            kind = construct.Bytes(leaf["count"])
        elif leaf["count"] != 1:
            kind = construct.Array(leaf["count"], kind)
        fields.append(leaf["path"].replace(".", "_").replace("[", "_").replace("]", "") / kind)
    frame = construct.Struct(
        "start" / construct.Const(b">"),
        "id" / construct.Int8ul,
        "size" / construct.Int8ul,
        "header_checksum" / construct.Int8ul,
        "body" / construct.Struct(*fields),
        "checksum" / construct.Int8ul,
    )
    record = construct.Struct(
        "mark" / construct.Const(b"\xa5"),
        "kind" / construct.Int8ul,
        "size" / construct.Int16ul,
        "time" / construct.Int64ul,
        "frame" / frame,
        "checksum" / construct.Int32ul,
    )
    return record


def entries(name: str, action: Callable[[], object], size: int) -> list[dict[str, Any]]:
    result = []
    for _ in range(REPETITIONS):
        start = time.process_time()
        action()
        seconds = time.process_time() - start
        # The time of a megabyte, because not all take the whole file.
        result.append(
            {
                "name": f"captures/{name}",
                "cpu_time": seconds * 1e6 / size,
                "time_unit": "s",
                "bytes_per_second": size / seconds,
            }
        )
    return result


def main() -> int:
    message = facts()
    head = b"\x89SBGC\r\n\x1a" + struct.pack("<HHQ", 1, 0, 0)
    data = records(message)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "capture.sbgc"
        path.write_bytes(head + struct.pack("<I", zlib.crc32(head)) + data)
        size = path.stat().st_size

        def read() -> Any:
            table = sbgc.read_capture(path)[sbgc.msg.RealtimeData4]
            assert len(table.array) == MESSAGES
            return table

        def columns() -> None:
            assert len(read().columns()) > 50

        part = PARSED * (len(data) // MESSAGES)

        def by_construct(described: Any) -> None:
            with path.open("rb") as file:
                file.seek(size - len(data))
                for _ in range(PARSED):
                    described.parse_stream(file)

        measured = entries("read", read, size)
        measured += entries("columns", columns, size)
        described = description(message)
        measured += entries("construct", lambda: by_construct(described), part)
        compiled = described.compile()
        measured += entries("construct_compiled", lambda: by_construct(compiled), part)
    json.dump({"benchmarks": measured}, sys.stdout, indent=1)
    return 0


if __name__ == "__main__":
    sys.exit(main())
