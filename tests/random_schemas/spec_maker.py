"""Random spec folders that use all features of the spec language and have no findings.

The same seed makes the same spec. Names of fields, flags and enum values are unique in a spec, so any two
lists of fields can be combined; their meaning is random.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import yaml

from message_maker import MessageMaker
from spec_parts import MAX_BODY, Node
from type_maker import TEXTS


class SpecMaker(MessageMaker):
    """Makes one random spec; `size` is the approximate number of commands."""

    def make(self) -> dict[str, Node]:
        """Returns the files of the spec."""
        count = self.random.randint(1, 4)
        self.families = {
            name: {"family": name, "summary": self.random.choice(TEXTS)}
            for name in ("alpha", "beta", "gamma", "delta")[:count]
        }
        self.make_types()
        self.make_variables()
        for _ in range(3):
            family, name = self.any_family(), self.unique("Struct")
            kind, node = self.make_struct(name, family, 30, 1)
            self.section(family, "structs")[name] = self.said(node, False)
            self.structs.append(kind)
        self.make_messages()
        self.use_structs()
        self.drop_unused()
        self.mark_spelling()
        self.features = self.add_features()
        files = {f"{name}.yaml": content for name, content in self.families.items()}
        return {**files, "simplebgc.yaml": self.main_file(), "errata.yaml": self.errata_file()}

    def add_features(self) -> list[str]:
        """Lets fields and values need features, and returns the flag sets of these."""
        sets = {
            name: node
            for content in self.families.values()
            for name, node in content.get("flags", {}).items()
            if "extends" not in node
        }
        told = {
            field["type"]
            for node in _nodes(self.families)
            for side in ("from_board", "to_board")
            for field in node.get(side, {}).get("fields", ())
            if field.get("type") in sets and field["name"].isidentifier()
            if not {"when", "since", "fits"} & set(field)
        }
        chosen = self.random.sample(sorted(told), min(len(told), 2))
        names = [
            name
            for one in chosen
            for name, value in sets[one]["values"].items()
            if value["value"] > 0 and re.fullmatch("[A-Z][A-Z0-9_]*", name)
        ]
        nodes = _nodes(self.families)
        able = [node for node in nodes if "value" in node and "summary" in node]
        able += [field for node in nodes for field in node.get("fields", ()) if "name" in field]
        for node in able:
            if names and self.chance(0.05):
                node["needs"] = self.random.choice(names)
        return chosen

    def use_structs(self) -> None:
        """Adds a message with the structs that no other message has."""
        _, family, node = self.new_command("to_board", family=list(self.families)[-1])
        used = {inner.get("type") for inner in _nodes(self.families)}
        scope = self.scope(family)
        self.add_number(scope)
        for kind in self.structs:
            if kind.name.startswith("Struct") and kind.name not in used:
                self.put(scope, kind)
        self.end(node, "to_board", "Using", scope)

    def drop_unused(self) -> None:
        """Removes types that nothing refers to, which would be findings."""
        while True:
            used = {
                node[key]
                for node in _nodes(self.families)
                for key in ("type", "names")
                if isinstance(node.get(key), str)
            }
            used |= {"FirmwareVersion", "BoardVersion"}
            unused = [
                (content[section], name)
                for content in self.families.values()
                for section in ("quantities", "enums", "flags", "packed", "structs")
                for name in content.get(section, {})
                if name not in used
            ]
            for part, name in unused:
                del part[name]
            if not unused:
                return

    def mark_spelling(self) -> None:
        """Marks names of numbers that are not in upper case as intended."""
        nodes = _nodes(self.families)
        structs = {
            name for content in self.families.values() for name in content.get("structs", {})
        }
        structs |= {node["struct"] for node in nodes if "struct" in node}
        for field in (field for node in nodes for field in node.get("fields", ())):
            name = re.sub(r"\[.*|\{.*?\}", "", field.get("name", ""))
            if "type" in field and field["type"] not in structs and name != name.upper():
                field["verbatim"] = True

    def main_file(self) -> Node:
        """Returns simplebgc.yaml."""
        line = {
            "more_baud_rates": self.random.sample(range(1, 1_000_000), self.random.randint(1, 4)),
            "parities": self.random.sample(("none", "even"), self.random.randint(1, 2)),
            "pause_ms": "1..9",
            "source": "Line L1",
        }
        return {
            **({"line": line} if self.chance(0.7) else {}),
            "protocol": {"name": "Random", "revision": "1"},
            "framings": self.framings(),
            "versions": {"firmware": "FirmwareVersion", "board": "BoardVersion"},
            **({"features": self.features} if self.features else {}),
            "indices": {"axis": ["ROLL", "PITCH", "YAW"], "xyz": ["X", "Y", "Z"]},
            "families": list(self.families),
        }

    def framings(self) -> Node:
        """Returns one or two framings with checksums of any kind."""
        header = {"kind": "sum8", "covers": ["id", "size"]}
        parts = ["start", *self.random.sample(("id", "size"), 2), "header_checksum"]
        common = {
            "header": parts,
            "max_body": MAX_BODY,
            "source": "Framing L1",
            "errata": ["E001"],
        }
        first = {"header_checksum": header, "body_checksum": self.checksum(parts)}
        second = {"header_checksum": header, "frame_checksum": self.checksum(parts)}
        found: Node = {
            "v1": {"start": 0x3E, **common, "trailer": ["body_checksum"], "checksums": first}
        }
        if self.chance(0.7):
            since = {"firmware": "2.68"}
            found["v2"] = {"start": 0x24, "since": since, **common, "trailer": ["frame_checksum"]}
            found["v2"]["checksums"] = second
        return found

    def checksum(self, header: list[str]) -> Node:
        """Returns a checksum of the body, or of all from a part of the header on."""
        covered = [*header, "body"][self.random.choice((0, 1, len(header))) :]
        kind = self.random.choice(("sum8", "sum16", "xor8", "crc8", "crc16", "crc32"))
        if not kind.startswith("crc"):
            return {"kind": kind, "covers": covered}
        most = (1 << int(kind[3:])) - 1
        node: Node = {"kind": kind, "covers": covered, "polynomial": self.random.randint(1, most)}
        for key in ("initial", "final_xor"):
            node[key] = self.random.choice((0, most, self.random.randint(0, most)))
        for key in ("reflect_in", "reflect_out"):
            node[key] = self.chance(0.5)
        return node

    def errata_file(self) -> Node:
        """Returns errata.yaml."""
        entry = {"kind": "text", "lines": ["L1"], "problem": "Something.", "reading": "Anything."}
        return {"errata": {"E001": entry}}


def _nodes(value: Any) -> list[Node]:
    """Returns all mappings in a value."""
    if isinstance(value, dict):
        return [value, *(node for inner in value.values() for node in _nodes(inner))]
    if isinstance(value, list):
        return [node for inner in value for node in _nodes(inner)]
    return []


class _Dumper(yaml.SafeDumper):
    def ignore_aliases(self, data: Any) -> bool:
        """Disables anchors, which are not allowed in a spec."""
        return True


def write_spec(folder: Path, seed: int, size: int) -> None:
    """Writes the random spec of this seed."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, content in SpecMaker(seed, size).make().items():
        text = yaml.dump(content, Dumper=_Dumper, sort_keys=False, allow_unicode=True, width=100)
        (folder / name).write_text(text, encoding="utf-8")
