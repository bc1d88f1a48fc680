"""Decodes bodies of messages with nothing but simplebgc.json, as a pattern for other languages.

    python3 decode.py simplebgc.json from_board 86 1e1e0a000300000000000009001c2e0d280a

The result is that of `sbgc decode`: raw integers, bytes as hex, texts, lists, and objects for groups.
"""

from __future__ import annotations

import json
import math
import re
import struct
import sys
from collections.abc import Callable
from typing import Any

Object = dict[str, Any]
FLOATS = {"f32": "<f", "f64": "<d"}


class Malformed(Exception):
    """The bytes are no body of the message."""


class Body:
    """The bytes of a body, or of an element of a list that grew, that have not been read."""

    def __init__(self, data: bytes, is_element: bool = False) -> None:
        self.left = data
        self.is_element = is_element

    def take(self, size: int) -> bytes:
        """The next bytes."""
        if size > len(self.left):
            raise Malformed("too short")
        data, self.left = self.left[:size], self.left[size:]
        return data


class Decoder:
    """Decodes bodies as the model describes them."""

    def __init__(self, model: Object) -> None:
        self.messages: list[Object] = model["messages"]
        self.enums = {
            e["name"]: {v["name"]: v["value"] for v in e["values"]} for e in model["enums"]
        }
        self.parts = {p["name"]: {x["name"]: x for x in p["parts"]} for p in model["packed"]}

    def choose(self, direction: str, number: int, size: int, request: str = "") -> Object:
        """The message of a body. The longest form of a command may be longer than described.

        Of several forms of one size, it is the one that the last request asked for, or else the first.
        """
        known = [m for m in self.messages if (m["direction"], m["id"]) == (direction, number)]
        known.sort(key=lambda m: (int(m["max_size"]), request not in m.get("asked_by", ())))
        forms = list({(m["min_size"], m["max_size"]): m for m in known[::-1]}.values())[::-1]
        for form in forms:
            if form["min_size"] <= size <= form["max_size"] or form is forms[-1]:
                return form
        raise Malformed("no such message")

    def decode(self, message: Object, data: bytes, context: Object) -> Object:
        """The fields of a body. `context` has the facts from earlier messages that it needs.

        A body may repeat such a fact. The first of both that fits exactly counts.
        """
        contexts = [context]
        if any("fits" in leaf for leaf in message["layout"]):
            contexts.append({**context, "": True})  # with the field that may fit
        for fact in message["context"]:
            if "repeated_by" in fact:
                leaf = next(n for n in message["layout"] if n["path"] == fact["repeated_by"])
                flag = self.enums[fact["enum"]][leaf["when"]["has"][0]]
                given = context.get(fact["name"], 0)
                own = data[leaf["offset"] :][: size_of(leaf)].ljust(size_of(leaf), b"\0")
                value = int.from_bytes(own, "little")
                values = [given & ~flag, *([value] if value & flag else [])]
                order = -1 if given & flag else 1
                contexts = [{**context, fact["name"]: value} for value in values[::order]]
        for known in contexts:
            try:
                fields = self.decode_with(message, data, known)
            except Malformed:
                continue
            if "tail" not in fields:
                return fields
        return self.decode_with(message, data, contexts[0])

    def decode_with(self, message: Object, data: bytes, context: Object) -> Object:
        """The fields of a body with a context that is certain."""
        self.groups = {group["path"]: group for group in message.get("groups", ())}
        self.enum_of_context = {c["name"]: c.get("enum") for c in message["context"]}
        self.context = context
        body = Body(data)
        fields = self.read_group(tree(message["layout"]), body, "", [])
        is_longer = message["takes_surplus"] and len(data) > message["max_size"]
        if body.left and not (message["keeps_tail"] or is_longer):
            raise Malformed("too long")
        return {**fields, "tail": body.left.hex()} if body.left else fields

    def read_group(self, nodes: Object, body: Body, path: str, around: list[Any]) -> Object:
        """The fields of one level; `around` has those of the levels around it, and their facts."""
        values: Object = {}
        levels = [(values, nodes), *around]
        for name, node in nodes.items():
            facts = node if "type" in node else self.groups.get(path + name, {})
            when = facts.get("when")
            if when and not self.holds(when, levels):
                continue
            if facts.get("fits") and node.get("type") == "string":
                size = len(body.left) - 1  # all that is left, or nothing
                if (
                    not 0 < size <= node["max_length"]
                    or body.left[0] != size
                    or min(body.left[1:]) < 32
                ):
                    continue
            elif facts.get("fits"):
                if "" not in self.context:
                    continue
            elif facts.get("may_be_missing") and not body.left and (not path or body.is_element):
                continue  # inside another group, the key says that the group may be missing
            if when and when["may_be_missing"] and len(body.left) < size_of(node):
                continue
            values[name] = self.read(node, facts, body, path + name, levels)
        return values

    def holds(self, when: Object, levels: list[Any]) -> bool:
        """True if a condition holds. A condition on a missing field does not."""
        for joined, together in (("all", all), ("one_of", any)):
            if joined in when:
                return together(self.holds(term, levels) for term in when[joined])
        if "context" in when:
            value, enum = (
                self.context.get(when["context"], 0),
                self.enum_of_context[when["context"]],
            )
        else:
            first, *steps = re.findall(r"\w+", when["field"])
            value, node = next((v.get(first), n[first]) for v, n in levels if first in n)
            for step in steps:
                value = value[int(step) if isinstance(value, list) else step]
                node = node.get(step, node)
            enum = node.get("enum")
        if value is None:
            return False
        value = int(value)
        if "part" in when:
            part = self.parts[node["packed"]][when["part"]]
            value, enum = number_in(part, value), part["enum"]
        numbers = self.enums.get(enum, {})
        asked = {key: [numbers.get(n, n) for n in when.get(key, ())] for key in KEYS_OF_CONDITION}
        has = {n for key in ("has", "any", "has_not") for n in asked[key] if value & n == n}
        return (
            has.issuperset(asked["has"])
            and (not asked["any"] or not has.isdisjoint(asked["any"]))
            and has.isdisjoint(asked["has_not"])
            and (not asked["is"] or value in asked["is"])
            and value not in asked["is_not"]
            and when.get("at_least", value) <= value <= when.get("at_most", value)
        )

    def read(self, node: Object, facts: Object, body: Body, path: str, levels: list[Any]) -> Any:
        """A value, list or group."""
        if "[]" in node:
            inner = node["[]"]
            return self.read_list(
                lambda b: self.read_group(inner, b, f"{path}.", levels), facts, body, levels
            )
        if "type" not in node:
            if not all(key.isdigit() for key in node):
                return self.read_group(node, body, f"{path}.", levels)
            there = (n for n in node.values() if body.left or not n.get("may_be_missing"))
            return [self.read(n, n, body, path, levels) for n in there]
        kind, count = node["type"], node.get("element_count", node["count"])
        if "announced" in node:
            return list(announced(self.context.get(node["announced"], []), body))
        if "cases" in node:
            union = Body(body.take(count))
            cases = [{**case, "path": case["path"].partition(".")[2]} for case in node["cases"]]
            fields = self.read_group(tree(cases), union, f"{path}.", levels)
            return {**fields, "rest": union.left.hex()}
        if kind == "string":
            data = body.take(body.take(1)[0])
            if len(data) > node["max_length"]:
                raise Malformed("text too long")
            return text(data)
        if kind == "text":
            return text(body.take(count).rstrip(b"\0"))
        if kind == "bytes" and count is not None:
            return body.take(count).hex()
        if kind == "bytes":
            return b"".join(self.read_list(lambda b: b.take(1), facts, body, levels)).hex()
        if count is None:
            return self.read_list(lambda b: number(kind, b), facts, body, levels)
        if count == 1 and not node.get("is_list"):
            return number(kind, body)
        return [number(kind, body) for _ in range(count)]

    def read_list(
        self, element: Callable[[Body], Any], facts: Object, body: Body, levels: list[Any]
    ) -> list[Any]:
        """The elements that a field counts, or those up to the end of the body."""
        if "counted_by" in facts:
            values, nodes = levels[0]
            count, counts = int(values[facts["counted_by"]]), facts.get("counted_in")
            if "counted_by_part" in facts:
                parts = self.parts[nodes[facts["counted_by"]]["packed"]]
                count = number_in(parts[facts["counted_by_part"]], count)
            if counts != "bytes":
                count = {"bits": bin(count).count("1"), "minus_1": count + 1}.get(counts, count)
                if "element_sizes" in facts:
                    return grown(element, facts["element_sizes"], count, body)
                return [element(body) for _ in range(count)]
            body = Body(body.take(count))
        if "element_sizes" in facts:
            fits = [size for size in facts["element_sizes"] if len(body.left) % size == 0]
            return grown(element, fits, len(body.left) // min(fits, default=1), body)
        found = []
        while body.left:
            found.append(element(body))
        if len(found) < facts.get("min_count", 0):
            raise Malformed("too few elements")
        return found


def grown(element: Callable[[Body], Any], sizes: list[int], count: int, body: Body) -> list[Any]:
    """Elements that share the rest of the body: all of one of these sizes."""
    if count and (len(body.left) % count or len(body.left) // count not in sizes):
        raise Malformed("no firmware has elements of this size")
    size = len(body.left) // max(1, count)
    return [element(Body(body.take(size), True)) for _ in range(count)]


KEYS_OF_CONDITION = ("has", "any", "has_not", "is", "is_not")


def tree(leaves: list[Object]) -> Object:
    """The leaves of a layout by the steps of their paths, such as `axes.roll.p` and `vars[].type`."""
    root: Object = {}
    for leaf in leaves:
        *steps, last = re.findall(r"\w+|\[\]", leaf["path"])
        node = root
        for step in steps:
            node = node.setdefault(step, {})
        node[last] = leaf
    return root


def size_of(node: Object) -> int:
    """The size of a field or group that always has the same size."""
    if "type" not in node:
        return sum(size_of(inner) for inner in node.values())
    width = int(re.sub(r"\D", "", node["type"]) or 8) // 8
    return width * int(node["count"])


def number(kind: str, body: Body) -> Any:
    """An integer, as text if it has 64 bits; a float, as text if JSON has no number for it."""
    data = body.take(int(kind[1:]) // 8)
    raw = int.from_bytes(data, "little", signed=kind[0] == "i")
    if kind not in FLOATS:
        return str(raw) if kind[1:] == "64" else raw
    (value,) = struct.unpack(FLOATS[kind], data)
    if math.isnan(value):
        return f"nan:{raw:0{2 * len(data)}x}"
    return str(value) if math.isinf(value) else value


def number_in(part: Object, raw: int) -> int:
    """The number in a part of a packed value."""
    if part["mask"] is None:  # decimal digits
        raw //= part["divide"] or 1
        return raw % part["modulo"] if part["modulo"] else raw
    value, most = (raw & part["mask"]) >> part["shift"], part["mask"] >> part["shift"]
    if part.get("signed") and value > most // 2:
        return int(value - most - 1)
    return int(-value if raw & part.get("sign", 0) else value)


def announced(types: list[str], body: Body) -> Any:
    """Numbers whose types an earlier message has announced, as far as the body goes."""
    for kind in types:
        if len(body.left) < int(kind[1:]) // 8:
            break
        yield {kind: number(kind, body)}


def text(data: bytes) -> str:
    """Text; a byte that is not UTF-8 becomes the character U+F700 + byte, as do such characters."""
    found = data.decode("utf-8", "surrogateescape")
    found = re.sub(
        "[\uf780-\uf7ff]", lambda m: "".join(chr(0xF700 + b) for b in m[0].encode()), found
    )
    return re.sub("[\udc80-\udcff]", lambda m: chr(ord(m[0]) - 0xDC00 + 0xF700), found)


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as file:
        decoder = Decoder(json.load(file))
    content = bytes.fromhex(sys.argv[4])
    chosen = decoder.choose(sys.argv[2], int(sys.argv[3]), len(content))
    print(chosen["name"], json.dumps(decoder.decode(chosen, content, {}), indent=2))
