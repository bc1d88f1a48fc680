"""The dissector shows every vector as `sbgc decode` does: raw values, values in their units, and names."""

from __future__ import annotations

import json
import math
import re
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from captures import FROM_BOARD, TO_BOARD, record, session
from line import ROOT, Shown, shown
from sbgc_command import MODEL, frame, run

VECTORS = sorted((ROOT / "generated" / "vectors").glob("*.jsonl"))
HIDDEN = "(hidden)"
PASSWORD_COMMAND = 137
LONGEST_LABEL = 200  # Wireshark cuts longer ones
# Error codes of `sbgc decode` for which there is no message at all.
WITHOUT_MESSAGE = {"unknown_command", "unknown_form"}


def capture() -> bytes:
    """Every vector in a session of its own, behind the messages that it needs."""
    made = []
    for path in VECTORS:
        for vector in map(json.loads, path.read_text("utf-8").splitlines()):
            if "hex" not in vector:
                continue
            made.append(session(len(made)))
            for one in (*vector.get("after", ()), vector):
                kind = FROM_BOARD if one["direction"] == "from_board" else TO_BOARD
                made.append(record(kind, 0.001, frame(one["id"], bytes.fromhex(one["hex"]))))
    return b"".join(made)


@pytest.fixture(scope="module", name="pairs")
def all_pairs(tmp_path_factory: pytest.TempPathFactory) -> list[tuple[Any, Shown]]:
    """What `sbgc decode` prints of each frame, and what tshark shows."""
    folder = tmp_path_factory.mktemp("vectors")
    (folder / "capture").write_bytes(capture())
    (folder / "packets").write_bytes(
        run("decode", "--format", "pcapng", str(folder / "capture")).out
    )
    decoded = run("decode", "--format", "jsonl", "--real", str(folder / "capture")).objects
    frames = list(shown(folder / "packets", "-J", "sbgc"))
    assert len(decoded) == len(frames) > 5000
    return list(zip(decoded, frames))


def leaves(value: Any, path: str = "") -> Iterator[tuple[str, str, Any]]:
    """The values of a message in order: the path of the display filter, the whole path, the value."""
    for key, inner in value.items():
        yield from _leaves(inner, f"{path}.{key}" if path else key)


def _leaves(inner: Any, path: str) -> Iterator[tuple[str, str, Any]]:
    if isinstance(inner, dict):
        yield from leaves(inner, path)
    elif isinstance(inner, list):
        for i, one in enumerate(inner):
            is_announced = isinstance(one, dict) and one.keys() <= {
                "u8",
                "i8",
                "u16",
                "i16",
                "u32",
                "i32",
                "f32",
            }
            yield from _leaves(*(one.values() if is_announced else (one,)), f"{path}[{i}]")
    else:
        *steps, last = re.sub(r"\[\d+\]", "", path).split(".")
        yield ".".join([*(s for s in steps if s != "axes"), last]), path, inner


def is_same(wanted: Any, element: Any) -> bool:
    """True if tshark shows this raw value."""
    value, show = str(element.get("value", "")), str(element.get("show", ""))
    data = bytes.fromhex(value)
    if isinstance(wanted, int):
        return (
            int(show, 0) == wanted
            if re.fullmatch(r"-?(0x)?[0-9a-f]+", show)
            else float(show) == wanted
        )
    if (
        isinstance(wanted, float)
        or str(wanted) in ("inf", "-inf")
        or str(wanted).startswith("nan:")
    ):
        (number,) = struct.unpack("<f" if len(data) == 4 else "<d", data)
        if math.isnan(number):
            return str(wanted) == f"nan:{int.from_bytes(data, 'little'):0{2 * len(data)}x}"
        return number == float(wanted)
    if (
        len(data) == 8
        and re.fullmatch(r"-?\d+", wanted)
        and re.fullmatch(r"-?(0x)?[0-9a-f]+", show)
    ):
        return int(show, 0) == int(wanted) or wanted == value
    return wanted in (value, _text(data.rstrip(b"\0") if not show else data))


def _text(data: bytes) -> str:
    """The text that stands for bytes in JSON."""
    found = data.decode("utf-8", "surrogateescape")
    found = re.sub(
        "[\uf780-\uf7ff]", lambda m: "".join(chr(0xF700 + b) for b in m[0].encode()), found
    )
    return re.sub("[\udc80-\udcff]", lambda m: chr(ord(m[0]) - 0xDC00 + 0xF700), found)


def test_all_raw_values_are_shown(pairs: list[tuple[Any, Shown]]) -> None:
    for wanted, frame_shown in pairs:
        assert int(frame_shown.text("sbgc.id")) == wanted["id"]
        code = wanted.get("error", {}).get("code")
        assert ("malformed" in frame_shown.experts) == (
            code is not None and code not in WITHOUT_MESSAGE
        ), wanted
        assert ("unknown" in frame_shown.experts) == (code in WITHOUT_MESSAGE), wanted
        if code is not None:
            body = frame_shown.text("sbgc.body").replace(":", "")
            # A value that may be a password is hidden, here also if it is no text.
            assert body == wanted["body"] or (
                body == "" and wanted["id"] == PASSWORD_COMMAND
            ), wanted
            continue
        assert frame_shown.text("sbgc.message") == wanted["message"]
        prefix = prefix_of(wanted)
        expected: dict[str, list[Any]] = {}
        for name, _, value in leaves(wanted["fields"]):
            if value not in ("", HIDDEN):
                expected.setdefault(prefix + name, []).append(value)
        for name, values in expected.items():
            found = frame_shown.all(f"{name}.raw") or frame_shown.all(name)
            if len(found) != len(values):  # an empty text is shown, an empty list is not
                found = [one for one in found if one.get("show")]
            assert len(found) == len(values), (wanted, name)
            for value, one in zip(values, found):
                assert is_same(value, one), (wanted, name, value, one.attrib)


def test_values_have_units_and_names(pairs: list[tuple[Any, Shown]]) -> None:
    for wanted, frame_shown in pairs:
        if "error" in wanted:
            continue
        prefix = prefix_of(wanted)
        paths: dict[str, list[str]] = {}
        for name, path, _ in leaves(wanted["fields"]):
            paths.setdefault(prefix + name, []).append(path)
        for name, several in paths.items():
            elements = frame_shown.all(name)
            for path, one in zip(several, elements):
                value = wanted["values"].get(path, {})
                if "real" in value and frame_shown.all(f"{name}.raw"):
                    assert math.isclose(
                        float(one.get("show")), value["real"], rel_tol=1e-5, abs_tol=1e-9
                    ), (wanted, path, one.attrib)
                if value.get("unit") and "text" not in value and frame_shown.all(f"{name}.raw"):
                    assert f" {value['unit']}" in one.get("showname"), (wanted, path, one.attrib)
                if "text" in value and len(value["text"]) < LONGEST_LABEL:
                    assert value["text"] in one.get("showname"), (wanted, path, one.attrib)


def prefix_of(wanted: Any) -> str:
    return "sbgc." + re.sub(r"(?<=[a-z])(?=[A-Z])", "_", wanted["message"]).lower() + "."
