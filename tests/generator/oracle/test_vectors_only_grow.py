"""Additions of a later firmware to the spec add vectors, and leave existing ones unchanged."""

from __future__ import annotations

import json
import re
import shutil
from functools import cache
from pathlib import Path
from typing import Any

from sbgcgen.build import load_layout
from sbgcgen.model import Enum, Layout
from sbgcgen.targets import target
from support import PROJECT, project_layout

SINCE = "since: {firmware: 2.99}, summary: It is new."


def lines_of(layout: Layout) -> list[str]:
    files = dict(target("vectors").files(layout, PROJECT))
    return [line for content in files.values() for line in content.decode().splitlines()]


@cache
def lines() -> list[str]:
    """Those of the project; test_output.py compares the files with the spec."""
    files = [*(PROJECT / "generated" / "vectors").iterdir(), PROJECT / "generated" / "frames.jsonl"]
    return [line for file in files for line in file.read_text(encoding="utf-8").splitlines()]


def with_edits(folder: Path, *edits: tuple[str, str]) -> Layout:
    """The protocol with texts of the spec followed by others."""
    shutil.copytree(PROJECT / "spec", folder / "spec")
    for after, text in edits:
        paths = [p for p in (folder / "spec").iterdir() if p.suffix == ".yaml"]
        (path,) = [p for p in paths if after in p.read_text(encoding="utf-8")]
        content = path.read_text(encoding="utf-8")
        assert content.count(after) == 1
        path.write_text(content.replace(after, after + text), encoding="utf-8")
    return load_layout(folder / "spec")


def free_value(enum: Enum) -> int | None:
    """A value of an enum, or a bit of a flag set, that has no name and fits wherever it is used."""
    taken = {value.value for value in enum.values}
    parts = [
        part for packed in project_layout().packed for part in packed.parts if part.enum == enum
    ]
    bits = 8 * enum.scalar.size
    flags = [1 << bit for bit in range(bits)]
    for value in flags if enum.kind == "flags" else range(1, 1 << min(bits - 1, 16)):
        if value not in taken and all(value << p.shift & ~p.mask == 0 for p in parts):
            return value
    return None


def test_a_value_of_every_enum_and_flag_set(tmp_path: Path) -> None:
    texts = [path.read_text("utf-8") for path in (PROJECT / "spec").glob("*.yaml")]
    extended = {name for text in texts for name in re.findall(r"extends: (\w+)", text)}
    edits = []
    for enum in project_layout().enums:
        head = rf"^  {enum.name}:\n(?:    .*\n)*?    values:\n"
        found = [place for text in texts for place in re.findall(head, text, re.MULTILINE)]
        value = free_value(enum)
        if found and value is not None and enum.name not in extended:
            name = f"FURTHER_{enum.name.upper()}"
            edits.append((found[0], f"      {name}: {{value: {value}, {SINCE}}}\n"))
    assert len(edits) > 60
    grown = lines_of(with_edits(tmp_path, *edits))
    lost = set(lines()) - set(grown)
    assert not lost, f"{len(lost)} lines, such as {min(lost, key=len)}"
    assert len(grown) > len(lines())


def test_a_command(tmp_path: Path) -> None:
    command = f"""
  CMD_FURTHER:
    id: 199
    {SINCE.replace(", summary", chr(10) + "    summary")}
    from_board:
      source: Later firmware
      fields: [{{name: KIND, type: MenuCommand, summary: It is new.}}]
"""
    family = (PROJECT / "spec/scripting.yaml").read_text(encoding="utf-8")
    grown = lines_of(with_edits(tmp_path, (family[-500:], command)))
    assert not set(lines()) - set(grown)
    assert any('"message":"Further"' in line for line in grown)


def values_of(of: list[str], message: str, without: str = "") -> list[dict[str, Any]]:
    """The values in the vectors of a message, without a field."""
    vectors = [json.loads(line) for line in of]
    found = [
        v["fields"] for v in vectors if v.get("message") == message and "hex" in v and "fields" in v
    ]
    return [{key: value for key, value in fields.items() if key != without} for fields in found]


def test_an_appended_field(tmp_path: Path) -> None:
    """Bodies get longer, or end before it; the other fields keep their values."""
    last = "summary: Checks to omit.}\n"
    field = f"        - {{name: FURTHER, type: u16, {SINCE}}}\n"
    grown = values_of(
        lines_of(with_edits(tmp_path, (last, field))), "EncodersCalibFldOffset4", "further"
    )
    kept = [
        fields for fields in values_of(lines(), "EncodersCalibFldOffset4") if "tail" not in fields
    ]
    assert len(kept) > 5
    assert [fields for fields in kept if fields not in grown] == []
