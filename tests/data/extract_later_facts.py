#!/usr/bin/env python3
"""Extracts the facts of the notes on the later protocol into later_facts.json.

    extract_later_facts.py later-protocol.md [later_facts.json]

Tables, lists of fields, lists with @offsets and lists of numbered names are read mechanically. What is in
prose is in later_facts_by_hand.yaml, beside this script, with the number of its line. Neither reads spec/.
Lines from which nothing was taken are listed under `not_parsed`; the file by hand has to account for each.
"""

from __future__ import annotations

import hashlib
import json
import re
import sys
from pathlib import Path
from typing import Any

import yaml

from later_notation import Fact, parse_fields, parse_values, split, version_of

BY_HAND = Path(__file__).with_name("later_facts_by_hand.yaml")
COMMAND = re.compile(r"(CMD_[A-Z0-9_]+)(?: (\d+))?")
AT = re.compile(r"@(\d+) ([A-Z][A-Z0-9_]* (?:[uif]\d+|bytes)\b)")
# Where the numbered names of a list occur: a command's field, or any field of that name.
PLACES = {
    "error codes": "CMD_ERROR.ERROR_CODE",
    "file codes": "CMD_READ_FILE.ERR_CODE",
    "StateFlags": "SYSTEM_STATE_FLAGS",
    "MENU_CMD": "CMD_EXECUTE_MENU.CMD_ID",
    "MOTOR_OUTPUT": "OUTPUT_*",
    "SERIAL_SPEED": "SERIAL_SPEED",
    "device": "CMD_TRANSPARENT_SAPI.TARGET:device",
    "CMD_ID of the GPS_IMU protocol": "CMD_EXT_SENS_CMD.CMD_ID",
}
FLAGS = ("FLAGS", "FEATURES", "StateFlags")


class Extractor:
    """The facts of the notes, line by line."""

    def __init__(self, lines: list[str]) -> None:
        self.lines = lines
        self.section = 0
        self.command = ""
        self.parsed: set[int] = set()
        self.facts: dict[str, list[Fact]] = {
            "commands": [],
            "bodies": [],
            "offsets": [],
            "enums": [],
            "variables": [],
        }

    def run(self) -> dict[str, list[Fact]]:
        for number, text in enumerate(self.lines, 1):
            heading = re.match(r"## (\d)\.", text)
            if heading:
                self.section, self.command = int(heading[1]), ""
            elif 2 <= self.section <= 7 and text.strip() and not text.startswith("```"):
                before = self.count()
                self.line(number, text)
                if self.count() > before:
                    self.parsed.add(number)
                elif number not in self.parsed:
                    self.facts.setdefault("not_parsed", []).append({"line": number})
        return self.facts

    def count(self) -> int:
        return sum(len(found) for found in self.facts.values()) - len(
            self.facts.get("not_parsed", [])
        )

    def line(self, number: int, text: str) -> None:
        if self.section in (2, 7):
            self.table_row(number, text)
            return
        command = COMMAND.match(text)
        if command and not text.startswith("CMD_READ/"):
            self.command = command[1]
        elif text.startswith("CMD_READ/WRITE_"):
            self.command = "CMD_READ_" + text.split()[0].split("WRITE_")[1]
        if self.section == 3:
            self.body(number, text)
        if self.section in (4, 5):
            self.offsets(number, text)
        if self.section in (3, 5, 6):
            self.enum(number, text)

    # Tables

    def table_row(self, number: int, text: str) -> None:
        cells = [cell.strip() for cell in text.strip("|").split("|")]
        if len(cells) != 4 or not cells[0][:1].isdigit():
            return
        ids = _numbers(cells[0])
        names = re.split(r", | / ", cells[1])
        if self.section == 7:  # in section 2 a suffix does not say what it replaces
            names = _suffixed(names)
        if len({name.split("_")[0] for name in names}) > 1 and names[0][:4] != "CMD_":
            return  # names without their first word
        if len(names) != len(ids) or not all(re.fullmatch(r"[A-Z][A-Z0-9_]*", n) for n in names):
            return
        if self.section == 2:
            board = re.search(r"board (\d\.\d)", cells[3])
            for id_, name in zip(ids, names):
                fact: Fact = {"name": name, "id": id_, "body": cells[2] == "yes", "line": number}
                if version_of(cells[3]):
                    fact["since"] = version_of(cells[3])
                self.facts["commands"].append({**fact, "board": board[1]} if board else fact)
            return
        ranges = re.split(r" / ", cells[2])
        ranges = ranges * len(ids) if len(ranges) == 1 else ranges
        for id_, name, limits in zip(ids, names, ranges):
            low, high = limits.split("..")
            fact = {"name": name, "id": id_, "range": [int(low), int(high)], "line": number}
            if version_of(cells[3]):
                fact["since"] = version_of(cells[3])
            self.facts["variables"].append(fact)

    # Bodies

    def body(self, number: int, text: str) -> None:
        for match in re.finditer(r"\b(H and B|H|B): (repeated \{|\[)", text):
            opening = match.end() - 1
            end = _closing(text, opening)
            inner = text[opening + 1 : end]
            if match[2] != "[":
                inner = f"repeated {{{inner}}}"
            fields = parse_fields(inner, number)
            if fields is not None:
                for way in match[1].split(" and "):
                    self.add_body(way, fields, number)
        if text.strip() == "H:":
            items = []
            for offset, line in enumerate(self.lines[number:], number + 1):
                item = re.match(r"    - (.*)", line)
                if item is None:
                    break
                items.append((offset, _without_braces_comment(item[1])))
            parsed = [parse_fields(item, line) for line, item in items]
            if None not in parsed:
                self.parsed |= {line for line, _ in items}
                self.add_body("H", [f for fields in parsed for f in fields or []], number)

    def add_body(self, way: str, fields: list[Fact], number: int) -> None:
        direction = {"H": "to_board", "B": "from_board"}[way]
        fact: Fact = {"command": self.command, "direction": direction, "fields": fields}
        self.facts["bodies"].append({**fact, "line": number})

    def offsets(self, number: int, text: str) -> None:
        """Fields with @offsets; a version in parentheses at the end of a line is of its fields before."""
        starts = [match.start() for match in AT.finditer(text)]
        for start, end in zip(starts, [*starts[1:], len(text)]):
            part = re.split(r"; *$|, *$|\"", split(text[start:end], ";")[0])[0]
            offset, rest = part[1:].split(" ", 1)
            fields = parse_fields(rest.split(" = ")[0], number)
            if fields:
                at = {"command": self.command, "direction": "from_board", "offset": int(offset)}
                if self.command in ("CMD_HELPER_DATA", "CMD_DATA_STREAM_INTERVAL"):
                    at["direction"] = "to_board"
                self.facts["offsets"].append({**at, **fields[0]})

    def enum(self, number: int, text: str) -> None:
        match = re.match(r"\s*([A-Za-z][\w ]*?)(?: ?\([^)]*\))?( bits)?: \{?(=?.*)", text)
        if match is None or match[1] in ("H", "B", "CAN_IMU_EXT_SENS_TYPE"):
            return  # sensors are named in prose
        body = match[3].split("}")[0] if "{" in text.split(":")[1][:3] else match[3]
        if not re.match(r"\d", body) or self.section == 3 and not re.search(r": \{", text):
            return
        kind = "flags" if any(word in match[1] for word in FLAGS) or match[2] else "enum"
        if self.section == 3 and kind == "flags":
            return  # bits in braces there are by hand
        place = PLACES.get(match[1], match[1])
        if self.section == 3 and "." not in place:
            place = f"{self.command}.{place}"
        values = parse_values(body.replace("OC ", "").replace("BK ", ""), number)
        if values:
            self.facts["enums"].append(
                {"place": place, "kind": kind, "values": values, "line": number}
            )


def _numbers(text: str) -> list[int]:
    """'97,98', '128-131', '79 / 80'"""
    found: list[int] = []
    for part in re.split(r",| / ", text):
        first, _, last = part.strip().partition("-")
        found += range(int(first), int(last or first) + 1)
    return found


def _suffixed(names: list[str]) -> list[str]:
    """Expands '_PITCH' to the first name with another last word."""
    stem = names[0].rpartition("_")[0]
    return [stem + name if name.startswith("_") else name for name in names]


def _closing(text: str, opening: int) -> int:
    depth = 0
    for i in range(opening, len(text)):
        depth += (text[i] in "[{(") - (text[i] in "]})")
        if depth == 0:
            return i
    return len(text)


def _without_braces_comment(text: str) -> str:
    """Keeps of a comment what states a unit: its first words."""
    field, _, comment = text.partition("#")
    words = split(comment, ",;")[:1] if re.match(r"\s*\d+(\.\d+)? [A-Za-z]+\s*$", comment) else []
    return " ".join([field.strip(), *words])


def extract(text: str, by_hand: dict[str, Any]) -> dict[str, Any]:
    """Returns the facts of the notes and of the file by hand."""
    facts = Extractor(text.splitlines()).run()
    for entry in by_hand["bodies"]:
        fields = parse_fields(entry["fields"], entry["line"]) if entry["fields"] else []
        assert fields is not None, f"not in the notation: {entry}"
        facts["bodies"].append({**entry, "fields": fields})
    for entry in by_hand["offsets"]:
        fields = parse_fields(entry["field"], entry["line"])
        assert fields, f"not in the notation: {entry}"
        rest = {key: value for key, value in entry.items() if key != "field"}
        facts["offsets"].append({**rest, **fields[0]})
    for entry in by_hand["enums"]:
        values = parse_values(str(entry["values"]), entry["line"])
        assert len(values) >= len(
            split(str(entry["values"]), ",;")
        ), f"not in the notation: {entry}"
        facts["enums"].append({**entry, "values": values})
    for entry in [*by_hand["structs"], *by_hand["streams"]]:
        entry["fields"] = parse_fields(entry["fields"], entry["line"])
        assert entry["fields"], f"not in the notation: {entry}"
    for key in ("commands", "variables", "structs", "parts", "streams"):
        facts[key] = facts.get(key, []) + by_hand[key]
    digest = hashlib.sha256(text.encode("utf-8")).hexdigest()
    return {"document": {"sha256": digest, "lines": len(text.splitlines())}, **facts}


def dump(facts: dict[str, Any]) -> str:
    """One fact a line."""
    parts = []
    for key, value in facts.items():
        if isinstance(value, list):
            rows = ",\n".join("  " + json.dumps(row, ensure_ascii=False) for row in value)
            parts.append(f'"{key}": [\n{rows}\n]')
        else:
            parts.append(f'"{key}": {json.dumps(value)}')
    return "{\n" + ",\n".join(parts) + "\n}\n"


def main() -> None:
    text = Path(sys.argv[1]).read_text(encoding="utf-8")
    target = Path(
        sys.argv[2] if len(sys.argv) > 2 else Path(__file__).with_name("later_facts.json")
    )
    by_hand = yaml.safe_load(BY_HAND.read_text(encoding="utf-8"))
    target.write_text(dump(extract(text, by_hand)), encoding="utf-8")


if __name__ == "__main__":
    main()
