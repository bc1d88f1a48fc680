#!/usr/bin/env python3
"""Extracts the facts of the specification's text into specification_facts.json, mechanically.

    extract_facts.py SPEC.txt [specification_facts.json]

Facts are names, types, counts, ids, limits, constants, units, bits and versions with their line
numbers; no sentence of the document is copied. Nothing is corrected: what is misspelt, misplaced
or missing in the text is so in the facts, and tests/data/fidelity_exceptions.yaml names the
erratum. Lines that hold no recognised fact, and numbers that are part of none, are listed under
`not_parsed` and have to be accounted for there, too.
"""

from __future__ import annotations

import hashlib
import json
import re
import sys
from pathlib import Path
from typing import Any, Iterator

Fact = dict[str, Any]

NAME = r"[A-Za-z][A-Za-z0-9_]*"
TYPE = r"\d+[usfb]"
DASH = r"\s*[–-]\s*"
TAG = re.compile(r"</?(?:p|i|ul|li)\b[^>]*>")
HEADING = re.compile(rf"(CMD_[A-Z0-9_]+(?:, *CMD_[A-Z0-9_]+)*)(?: *(,)$|{DASH}|$)")
FORM = re.compile(
    r"(Simple|Extended) form(?:at)?\b|In case of (success|errors):|" r"(Extended) form supported"
)
FIELD = re.compile(
    rf"(?P<name>{NAME})(?:\[(?P<array>[^\]]+)\])?(?:{DASH}| (?=\d+b\b))"
    rf"(?:(?P<type>{TYPE})\b(?: ?\* ?(?P<count>\d+))?|(?P<word>string|float)\b"
    rf"|array of (?P<list>{TYPE}) elements, size (?P<least>\d+)\.\.(?P<most>\d+)"
    r"|(?P<variable>depends on|variable length|remaining bytes|(?:0 or )?any size|size that was"
    r"|size undefined|\d+\.\.\d+ byte|<size and type))"
)
LOOP = re.compile(r"for\((?:(\w+) in \[([^\]]+)\]|(\d)\.\.(\d)|i=0; i<(\w+); i\+\+)\)")
VERSION = re.compile(r"\b(\d\.\d\d(?:b\d)?)\+?(?!\d)")
SINCE = re.compile(r"(?:ver\.|version) ?(?P<version>\d\.\d\d)\+?(?!\d)")
NUMBER = re.compile(r"(?<![\w.])-?\d+(?:[.,]\d+)?")

# What remarks say, in words that recur. Each pattern is taken out of the text once recognised.
SHIFT = re.compile(rf"(?P<name>{NAME})\s*=?\s*\(1<<(?P<shift>\d+)\)")
CONSTANT = re.compile(
    r"(?P<name>(?<!\w)-?(?:[A-Z][A-Za-z0-9_]*|\d+))\*{0,2} ?= ?(?P<value>-?\d+)(?![\d.])"
    r"(?: *\((?:IEEE-754|default)\))?(?P<board> *\(BOARD_VER ?>= ?30\))?"
)
BARE_CONSTANT = re.compile(r"\b(?P<name>[A-Z]+_[A-Z0-9_]+) (?P<value>\d+)(?= [A-Z]|$)")
BITS = [
    re.compile(r"\b[Bb]its? ?(?P<first>\d+)(?:(?:\.{2,3}|,)(?P<last>\d+))?\b"),
    re.compile(r"\b(?P<first>\d+)(?:\.\.(?P<last>\d+)) bits\b"),
    re.compile(r"\b(?P<first>\d+) ?(?:rd|th) bit\b"),
]
UNIT_WORD = (
    r"degrees?/sec ?²|degrees?/sec|degrees?|gyro sensor unit|of gyro sensor(?:'s)? units?"
    r"|volt|V|mA|ms|us|Hz|Celsius|dB|G|m/s²"
)
UNITS = [
    re.compile(r"1 ?page = (?P<number>\d+) ?(?P<unit>byte)"),
    re.compile(r"Unit vector=(?P<divisor>\d+)"),
    re.compile(r"(?P<divisor>512) - (?P<number>100)(?P<unit>%)"),
    re.compile(r"[Uu]nits: *1(?P<unit> ?[gG])?/(?P<divisor>\d+)(?P<same> G)?"),
    re.compile(rf"[Uu]nits: *(?P<number>\d+(?:[.,]\d+)?)? ?(?P<unit>{UNIT_WORD})?(?![\w/])"),
    re.compile(rf"\bor (?P<number>\d+(?:[.,]\d+)?) (?P<unit>{UNIT_WORD})(?=, if)"),
    re.compile(r"\b(?P<number>10) (?P<unit>Hz) per unit"),
    re.compile(r"\bx(?P<number>2) (?P<unit>Hz)"),
    re.compile(r"(?:, |\bin )(?P<unit>Hz|dB|ms|us|Celsius|milliseconds|percents|bytes)(?=\W|$)"),
    re.compile(r"\b(?:[Mm]ultiplied|divided) by (?P<divisor>\d+)\b"),
    re.compile(r"(?P<add>0\.1) \+ \w+\[axis\]\*(?P<number>0\.02)"),
    re.compile(r"1\.0f → (?P<divisor>256)"),
]
REFERENCE = re.compile(
    r"[Ss]ee (?:the )?'?([A-Z_]+)'? (?:parameter inside|in)(?: the)? (CMD_[A-Z0-9_]+)"
)
DIGITS = re.compile(r"(\w+)_ver = (?:\(int\))?(\(*[A-Z_]+(?:[/%]\d+\)*)+);")
SPECIAL = [
    re.compile(r"[Ss]pecial value \"?(?P<value>-?\d+)"),
    re.compile(r"\bspecify (?P<value>\d+)"),
    re.compile(r"(?P<value>-?\d+) is for 'undefined'"),
    re.compile(r"If set to (?P<value>\d+)"),
    re.compile(r"\bValue (?P<value>\d+) means"),
    re.compile(r"\bvalue = (?P<value>\d+):"),
    re.compile(r"(?<!\d)(?P<value>\d+) ?[–-] (?:disabled|erase|no decay)"),
]
RANGE = re.compile(r"(?<![\w.])(?P<low>-?\d+)\.{2,3}(?P<high>-?\d+)(?!\w|\.\d)")
PLUS = re.compile(r"\+ (?P<value>\d+)\b")
VALUE = re.compile(r"(?<![\w.,-])(?P<value>\d+)(?: - | ?– ?)(?=[A-Za-z\d“])")
WORD_VALUE = re.compile(r"(?:^|(?<= ))(?P<value>\d) (?=Auto|DSM)")
ALIGN = re.compile(r"(?P<align>\d+)-byte aligned")


class Text:
    """A line whose recognised parts are taken away, so that what is left can be reported."""

    def __init__(self, text: str) -> None:
        self.rest = text

    def take(self, *patterns: re.Pattern[str]) -> Iterator[re.Match[str]]:
        for pattern in patterns:
            for match in list(pattern.finditer(self.rest)):
                if match.group().strip():
                    blank = " " * len(match.group())
                    self.rest = self.rest[: match.start()] + blank + self.rest[match.end() :]
                    yield match

    def numbers(self) -> list[str]:
        return NUMBER.findall(self.rest)


def remark_facts(text: Text, own_name: str = "") -> Fact:
    """Whatever a remark says about its field, as lists by kind; empty kinds are left out."""
    digits = [[m[1], re.findall(r"[/%]\d+", m[2])] for m in text.take(DIGITS)]
    units = []
    for match in text.take(*UNITS):
        unit = {k: v.replace(",", ".").strip() for k, v in match.groupdict().items() if v}
        if "same" in unit:
            unit["unit"] = unit.pop("same")
        if unit:
            units.append(unit)
    special = []
    constants = []
    for match in text.take(SHIFT):
        constants.append({"name": match["name"], "value": 1 << int(match["shift"])})
    for match in text.take(CONSTANT, BARE_CONSTANT):
        constant: Fact = {"name": match["name"], "value": int(match["value"])}
        if match.groupdict().get("board"):
            constant["board"] = "3.0"
        if match["name"] == own_name or match["name"] == "Disabled":
            special.append(constant["value"])
        else:
            constants.append(constant)
    facts: Fact = {
        "constants": constants,
        "units": units,
        "digits": digits,
        "references": [[m[1], m[2]] for m in text.take(REFERENCE)],
        "align": [int(m["align"]) for m in text.take(ALIGN)],
        "special": special + [int(m["value"]) for m in text.take(*SPECIAL)],
        "bits": [[int(m[1]), int(m.groupdict().get("last") or m[1])] for m in text.take(*BITS)],
        "ranges": [[int(m["low"]), int(m["high"])] for m in text.take(RANGE)],
        "values": [int(m["value"]) for m in text.take(PLUS, VALUE, WORD_VALUE)],
        "since": [m["version"] for m in text.take(SINCE)],
    }
    return {kind: found for kind, found in facts.items() if found}


class Lists:
    """Reads the sections of incoming and outgoing commands: bodies as lists of fields."""

    def __init__(self, not_parsed: list[Fact]) -> None:
        self.bodies: list[Fact] = []
        self.codes: list[Fact] = []
        self.answers: list[Fact] = []
        self.not_parsed = not_parsed
        self.direction = ""
        self.group: list[str] = []
        self.joined = False
        self.loops: list[list[str]] = []
        self.loop_start = 0
        self.here: Fact = {}
        self.pending: list[Fact] = []

    def read(self, lines: list[tuple[int, str]], direction: str) -> None:
        self.direction = direction
        for number, raw in lines:
            text = raw.replace("\\_", "_").replace("\\n", "").strip()
            if text in ("", "-", "```", "- ```"):
                continue
            if not self._line(number, text):
                self.not_parsed.append({"line": number, "numbers": NUMBER.findall(text)})
        self._finish()

    def _line(self, number: int, text: str) -> bool:
        heading = HEADING.match(text)
        if heading:
            self._heading(number, text, heading)
        found = self._answers(number, text)
        if heading:
            return True
        if FORM.match(text):
            return self._form(number, text)
        if "same as" in text and "CMD_" in text:
            self.here["same_as"] = re.findall(r"CMD_[A-Z0-9_]+(?:xx)?", text)[0]
            return True
        if text.startswith("See corresponding outgoing command"):
            self.here["same_as"] = self.group[0]
            return True
        text = re.sub(r"^-\s*", "", text)
        loop = LOOP.match(text)
        if loop:
            return self._open_loop(loop)
        if text == "}":
            return self._close_loop()
        if text.startswith("..all data from"):
            self.here["includes"] = re.findall(r"CMD_[A-Z0-9_]+", text)[0]
            return True
        field = FIELD.match(text)
        if field and not text.startswith(("Size ", "Data ")):
            return self._field(number, text[field.end() :], field)
        code = re.fullmatch(r"([A-Z_]+) = (\d+)", text)
        if code:
            self.codes.append(
                {
                    "command": self.group[0],
                    "name": code[1],
                    "value": int(code[2]),
                    "line": number,
                }
            )
            return True
        return self._repetition(text) or self._remark(number, text) or found

    def _heading(self, number: int, text: str, heading: re.Match[str]) -> None:
        commands = heading[1].replace(" ", "").split(",")
        if not self.joined:
            self._finish()
            self.group = []
        self.group += commands
        self.joined = bool(heading[2])
        self.here = {"form": None, "line": number, "fields": []}
        since = VERSION.search(text[heading.end() :])
        if since:
            self.here["since"] = since[1]
        self.pending = [self.here]

    def _form(self, number: int, text: str) -> bool:
        match = FORM.match(text)
        assert match is not None
        word = (match[1] or match[2] or match[3]).lower()
        if "not implemented" in text:
            return True
        first = self.pending[0]
        if first["form"] is None:
            if first["fields"]:
                first["form"] = "simple"
            else:
                self.pending.remove(first)
        self.here = {
            "form": {"errors": "error"}.get(word, word),
            "line": number,
            "fields": [],
        }
        since = VERSION.search(text)
        if since or "since" in first:
            self.here["since"] = since[1] if since else first["since"]
        self.pending.append(self.here)
        return True

    def _finish(self) -> None:
        for body in self.pending:
            for command in self.group:
                self.bodies.append({"command": command, "direction": self.direction, **body})
        self.pending = []

    def _open_loop(self, loop: re.Match[str]) -> bool:
        if loop[2]:
            words = [word.strip() for word in loop[2].split(",")]
        elif loop[3]:
            words = [str(i) for i in range(int(loop[3]), int(loop[4]) + 1)]
        elif loop[5].isdigit():
            words = [str(i) for i in range(int(loop[5]))]
        else:
            words = [f"<{loop[5]}"]
        self.loops.append(words)
        self.loop_start = len(self.here["fields"])
        return True

    def _close_loop(self) -> bool:
        fields = self.here["fields"]
        body = fields[self.loop_start :]
        fields[self.loop_start :] = [
            {**field, "index": word} for word in self.loops.pop() for field in body
        ]
        return True

    def _field(self, number: int, rest: str, match: re.Match[str]) -> bool:
        field: Fact = {"name": match["name"], "line": number}
        array = match["array"]
        if match["list"]:
            field.update(type=match["list"], count=None, most=int(match["most"]))
        elif match["variable"]:
            field.update(type="variable", count=None)
        else:
            field.update(type=match["type"] or match["word"], count=int(match["count"] or 1))
            if array and array.isdigit() and int(array) != field["count"]:
                raise ValueError(f"line {number}: {array} elements or {field['count']}?")
        if array and not array[0].isdigit():
            field["index"] = array
        text = Text(rest)
        values = [int(m[1]) for m in text.take(re.compile(r"(?<=[(\s])(\d+) [–-] "))]
        values += [int(m[1]) for m in text.take(re.compile(r"checked=(\d)"))]
        field.update(remark_facts(text, match["name"]))
        amount = RANGE.match(match["variable"] or "")
        if amount:
            field["ranges"] = [[int(amount["low"]), int(amount["high"])]]
        if values:
            field["values"] = values + field.get("values", [])
        self.here["fields"].append(field)
        if text.numbers():
            self.not_parsed.append({"line": number, "numbers": text.numbers()})
        return True

    def _repetition(self, text: str) -> bool:
        """'...', between numbered names, and '...repeat for remaining parameters...'."""
        fields = self.here["fields"]
        if text == "...":
            fields.append({"name": "..."})
            return True
        if not text.startswith("...repeat"):
            return False
        once = [f for f in fields if re.search(r"(?<=[A-Z])1_", f["name"])]
        self.here["fields"] = [f for f in fields if not re.search(r"[A-Z]\d_", f["name"])]
        for field in once:
            name = re.sub(r"(?<=[A-Z])1_", "<N>_", field["name"])
            self.here["fields"].append({**field, "name": name, "index": "<NUM_VARS"})
        return True

    def _remark(self, number: int, text: str) -> bool:
        """A line that only adds to the field above it: values, bits."""
        if not self.here.get("fields") or not re.match(r"(\d+ [–-]|bit\d)", text):
            return False
        found = Text(text)
        last = self.here["fields"][-1]
        last.setdefault("more_lines", []).append(number)
        for kind, facts in remark_facts(found).items():
            last.setdefault(kind, []).extend(facts)
        if found.numbers():
            self.not_parsed.append({"line": number, "numbers": found.numbers()})
        return True

    def _answers(self, number: int, text: str) -> bool:
        """Which command is said to be sent in response."""
        patterns = (
            r"response is (CMD_\w+)",
            r"(CMD_\w+)(?: incoming)?(?: command)? is sent\b",
            r"sent in the incoming command (CMD_\w+)",
            r"(?:Returns|command) (CMD_\w+)(?: with| will be sent back)",
            r"[Cc]onfirmation (?:is sent|send)\b",
        )
        found = False
        if self.direction != "to_board":
            return found
        for pattern in patterns:
            for match in re.finditer(pattern, text):
                answer = match[1] if match.groups() else "CMD_CONFIRM"
                for command in self.group:
                    fact = {"command": command, "answer": answer, "line": number}
                    if fact not in self.answers:
                        self.answers.append(fact)
                found = True
        return found


def expand_bodies(bodies: list[Fact]) -> None:
    """Write out VAL_CH1 ... VAL_CH32, and the body that another one includes."""
    by_command = {(b["command"], b["direction"]): b for b in bodies}
    for body in bodies:
        fields: list[Fact] = []
        if "includes" in body:
            fields += by_command[(body["includes"], body["direction"])]["fields"]
        for before, field, after in zip(
            [{}, *body["fields"]], body["fields"], [*body["fields"][1:], {}]
        ):
            if field["name"] != "...":
                fields.append(field)
                continue
            stem, first = re.fullmatch(r"(\w+?)(\d+)", before["name"]).groups()  # type: ignore
            last = int(re.fullmatch(r"\w+?(\d+)", after["name"])[1])  # type: ignore
            fields += [{**before, "name": f"{stem}{i}"} for i in range(int(first) + 1, last)]
        body["fields"] = fields


class Table:
    """Reads the table of the variables: five columns, broken by pages and narrow columns."""

    def __init__(self, known: dict[str, set[str]], not_parsed: list[Fact]) -> None:
        self.known = known
        self.rows: list[Fact] = []
        self.not_parsed = not_parsed

    def read(self, lines: list[tuple[int, str]]) -> None:
        commands: list[str] = []
        direction: str | None = None
        since: str | None = None
        cells: list[list[str]] = []
        for number, line in lines:
            if not line.strip():
                continue
            cells = [[cell.strip()] for cell in line.split("\t")]
            row = [cell[0] for cell in cells] + [""] * 5
            text = TAG.sub(" ", row[0])
            if row[0].startswith("CMD_") and not row[1]:
                commands = re.findall(r"CMD_[A-Z0-9_]+", re.split(r" [–-] ", text)[0])
                words = {" request ": "to_board", " response ": "from_board"}
                direction = next((d for w, d in words.items() if w in f" {text} "), None)
                version = VERSION.search(text)
                since = version[1] if version else None
            elif row[1] or (self.rows and re.fullmatch(r"(?:[A-Z0-9_.]+ ?)*", row[0])):
                self._row(number, row, commands, direction, since)
            else:
                self.not_parsed.append({"line": number, "numbers": NUMBER.findall(text)})
        for fact in self.rows:
            fact["names"] = list(self._names(fact["names"], fact["commands"]))

    def _row(
        self, number: int, row: list[str], commands: list[str], direction: str | None, since: Any
    ) -> None:
        text = Text(TAG.sub(" ", row[4]).replace("  ", " "))
        facts = {k: [*v] for k, v in self._parts(text).items()}
        facts.update(remark_facts(text))
        for constant in facts.get("constants", []):
            constant["line"] = number
        if text.numbers():
            self.not_parsed.append({"line": number, "numbers": text.numbers()})
        if not row[1]:  # what a page break cut off the row above
            last = self.rows[-1]
            last["names"] += " " + row[0]
            for kind, found in facts.items():
                last.setdefault(kind, []).extend(found)
            last.setdefault("more_lines", []).append(number)
            return
        type_ = re.fullmatch(rf"({TYPE}|string)(?: ?\* ?(\d+))?", row[1])
        assert type_ is not None, number
        fact: Fact = {"commands": commands, "line": number, "names": row[0], "type": type_[1]}
        if direction:
            fact["direction"] = direction
        if since:
            fact["version"] = since
        if type_[2]:
            fact["count"] = int(type_[2])
        for key, cell in (("min", row[2]), ("max", row[3])):
            if re.search(r"\d", cell):
                fact[key] = float(cell[:-1]) if cell.endswith("f") else int(cell)
        fact.update(facts)
        self.rows.append(fact)

    def _parts(self, text: Text) -> dict[str, list[Fact]]:
        """Fields that a remark describes inside a field: 'flags - 4u'."""
        pattern = re.compile(rf"(?:CMD_\w+\s+)?\b([a-z_]+){DASH}({TYPE})\b")
        parts = [{"name": m[1], "type": m[2]} for m in text.take(pattern)]
        return {"parts": parts} if parts else {}

    def _names(self, text: str, commands: list[str]) -> Iterator[str]:
        """Names of a cell. Halves of a name that a narrow column split are put together."""
        words = [w for w in re.split(r"[ *]+", text) if w and not re.match(r"[a-z.]+:?$", w)]
        known = set().union(*(self.known.get(c, set()) for c in commands))
        numbered = re.fullmatch(r"(\w+?)(\d+) \.\. \w+?(\d+)", text)
        if numbered:
            yield from (f"{numbered[1]}{i}" for i in range(int(numbered[2]), int(numbered[3]) + 1))
            return
        while words:
            for amount in range(min(4, len(words)), 0, -1):
                name = "".join(words[:amount])
                if amount == 1 or re.sub(r"\[\w+\]$", "", name) in known:
                    break
            del words[:amount]
            several = re.fullmatch(r"(\w+_)(\d)\.\.(\d)", name)
            if several:
                first, last = int(several[2]), int(several[3])
                yield from (f"{several[1]}{i}" for i in range(first, last + 1))
            else:
                yield name


def read_defines(lines: list[tuple[int, str]]) -> list[Fact]:
    """The ids; a comment 'Board v3.x only' holds for all that follow in its block."""
    found: list[Fact] = []
    board = None
    for number, line in lines:
        define = re.fullmatch(r"#define (CMD_\w+) (\d+)", line.strip())
        if line.startswith("// Board v"):
            board = "3.0"
        elif line.startswith("```"):
            board = None
        elif define:
            fact: Fact = {"name": define[1], "value": int(define[2]), "line": number}
            found.append({**fact, "board": board} if board else fact)
    return found


def read_notation(lines: list[tuple[int, str]]) -> list[Fact]:
    """The types that the notation defines."""
    pattern = re.compile(rf"- (\d[usf]|Nb|string){DASH}(?:(\d) bytes? (\w+)|(\w+))")
    matches = ((n, pattern.match(line)) for n, line in lines)
    return [{"type": m[1], "word": m[3] or m[4], "line": n} for n, m in matches if m]


def read_framing(lines: list[tuple[int, str]]) -> list[Fact]:
    """The bytes around a body, and the bytes of the example."""
    facts: list[Fact] = []
    for number, line in lines:
        part = re.match(rf"([a-zA-Z_ ]+?)(?: =.*)?{DASH}1u\b", line)
        start = re.match(r"character '(.)'", line)
        if start:
            facts.append({"part": "start", "value": ord(start[1]), "line": number})
        elif part:
            facts.append({"part": part[1], "line": number})
        elif line.startswith("0x"):
            example = [int(b, 16) for b in re.findall(r"0x([0-9A-F]{2})", line)]
            facts.append({"part": "example", "bytes": example, "line": number})
    return facts


def read_variables(lines: list[tuple[int, str]], not_parsed: list[Fact]) -> list[Fact]:
    """Appendix B."""
    found: list[Fact] = []
    for number, line in lines:
        cells = [cell.strip() for cell in line.split("\t")] + [""] * 6
        if not line.strip() or cells[0] == "NAME":
            continue
        remark = Text(cells[5])
        facts = remark_facts(remark)
        table = "\t" in line
        if not table or remark.numbers():
            not_parsed.append({"line": number, "numbers": remark.numbers()})
        if not table:
            continue
        if not cells[0]:
            for kind, more in facts.items():
                found[-1].setdefault(kind, []).extend(more)
        else:
            fact: Fact = {"name": cells[0], "id": int(cells[1]), "type": cells[2]}
            fact.update(min=int(cells[3]), max=int(cells[4]), line=number, **facts)
            found.append(fact)
    return found


def extract(text: str) -> Fact:
    """All facts of the specification."""
    lines = list(enumerate(text.splitlines(), 1))
    titles = {
        "format": "Message format",
        "notation": "Data type notation",
        "ids": "Command ID definitions",
        "incoming": "Incoming commands",
        "outgoing": "Outgoing command",
        "table": "Variables description and range",
        "rest": "Appendix A: Examples and libraries",
        "appendix": "Appendix B: Definition of dynamically configurable parameters",
    }
    start = {key: next(n for n, line in lines if line == title) for key, title in titles.items()}
    order = [*start.values(), len(lines) + 1]
    part = {key: lines[number : order[i + 1] - 1] for i, (key, number) in enumerate(start.items())}
    not_parsed: list[Fact] = []
    lists = Lists(not_parsed)
    lists.read(part["incoming"], "from_board")
    lists.read(part["outgoing"], "to_board")
    expand_bodies(lists.bodies)
    known: dict[str, set[str]] = {}
    for body in lists.bodies:
        known.setdefault(body["command"], set()).update(f["name"] for f in body["fields"])
    table = Table(known, not_parsed)
    table.read(part["table"][2:])
    variables = read_variables(part["appendix"], not_parsed)
    return {
        "specification": {
            "sha256": hashlib.sha256(text.encode()).hexdigest(),
            "lines": len(lines),
        },
        "framing": read_framing(part["format"]),
        "notation": read_notation(part["notation"]),
        "defines": read_defines(part["ids"]),
        "bodies": lists.bodies,
        "codes": lists.codes,
        "answers": lists.answers,
        "rows": table.rows,
        "variables": variables,
        "mentions": mentions(lines),
        "not_parsed": sorted(not_parsed, key=lambda f: int(f["line"])),
    }


def mentions(lines: list[tuple[int, str]]) -> Fact:
    """The lines on which each command is named."""
    found: dict[str, list[int]] = {}
    for number, line in lines:
        for word in sorted(set(re.findall(r"\bCMD_[A-Z0-9_]+\b", line))):
            found.setdefault(word, []).append(number)
    return dict(sorted(found.items()))


def dump_item(item: Fact) -> str:
    """One fact in one line; the fields of a body have lines of their own."""
    if not item.get("fields"):
        return json.dumps(item, ensure_ascii=False)
    head = json.dumps({k: v for k, v in item.items() if k != "fields"}, ensure_ascii=False)
    fields = (f"    {json.dumps(field, ensure_ascii=False)}" for field in item["fields"])
    return f'{head[:-1]}, "fields": [\n' + ",\n".join(fields) + "\n  ]}"


def dump(facts: Fact) -> str:
    """JSON with one fact a line, so that a difference can be read."""
    parts = []
    for key, value in facts.items():
        if isinstance(value, list):
            items = ",\n".join(f"  {dump_item(item)}" for item in value)
            parts.append(f'"{key}": [\n{items}\n]')
        elif key == "mentions":
            items = ",\n".join(f"  {json.dumps(k)}: {json.dumps(v)}" for k, v in value.items())
            parts.append(f'"{key}": {{\n{items}\n}}')
        else:
            parts.append(f'"{key}": {json.dumps(value)}')
    return "{\n" + ",\n".join(parts) + "\n}\n"


def main(arguments: list[str]) -> int:
    if len(arguments) not in (1, 2):
        print(__doc__, file=sys.stderr)
        return 2
    text = Path(arguments[0]).read_text(encoding="utf-8")
    default = Path(__file__).with_name("specification_facts.json")
    target = Path(arguments[1]) if len(arguments) == 2 else default
    target.write_text(dump(extract(text)), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
