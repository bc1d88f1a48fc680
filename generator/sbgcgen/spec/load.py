"""Reads spec/*.yaml into plain values with positions.

Implicit conversions of YAML are disabled: `2.50` is the text "2.50" (a firmware version), `on` is a
word, and `010` is not octal. A repeated key is an error.
"""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any, Iterator

import yaml

from sbgcgen.model import Position
from sbgcgen.spec.diagnostics import Diagnostics

try:
    from yaml import CSafeLoader as _SafeLoader
except ImportError:  # a PyYAML without libyaml: slower, same result
    from yaml import SafeLoader as _SafeLoader  # type: ignore[assignment]

# A key that only the main file has, at the start of a line.
_MAIN_KEY = re.compile(rb"^(\xef\xbb\xbf)?(protocol|framings|families):", re.MULTILINE)
_ERRATA = "errata.yaml"

_INT = re.compile(r"[-+]?(0|[1-9][0-9]{0,17})$")
_WORDS = {"true": True, "false": False, "null": None, "~": None, "": None}
# Direction marks and other characters that editors do not show.
_INVISIBLE = re.compile("[\u00ad\u061c\u200b-\u200f\u202a-\u202e\u2060-\u2069\ufeff]")
_QUOTED = re.compile(r"\"[^\"]*\"|'[^']*'")
_HEX = re.compile(r"0x[0-9A-Fa-f]{1,16}$")


class Map(dict[str, Any]):
    """A mapping with its own position and those of its keys."""

    position: Position
    keys_at: dict[str, Position]

    def at(self, key: str) -> Position:
        """The position of `key`, or that of the mapping if it has no such key."""
        return self.keys_at.get(key, self.position)

    def listed(self, key: str) -> list[tuple[Any, Position]]:
        """The items under `key` with their positions: those of a list, a single value, or none."""
        value = self.get(key, ())
        if isinstance(value, List):
            return list(zip(value, value.items_at))
        return [(value, self.at(key))] if key in self else []


class List(list[Any]):
    """A sequence with its own position and those of its items."""

    position: Position
    items_at: list[Position]


@dataclass
class Spec:
    """The contents of the YAML files: the main file, the families and the errata."""

    main: Map
    families: dict[str, Map] = field(default_factory=dict)
    errata: Map = field(default_factory=lambda: empty_map(Position(f"spec/{_ERRATA}")))
    files: list[Path] = field(default_factory=list)

    @property
    def main_file(self) -> str:
        return Path(self.main.position.file).name

    @property
    def command_prefix(self) -> str:
        return str(self.main.get("protocol", {}).get("command_prefix", "CMD_"))

    @cached_property
    def maps(self) -> dict[str, list[Map]]:
        """The mappings in each family, in file order."""
        return {family: maps_in(content) for family, content in self.families.items()}

    def entries(self, section: str) -> Iterator[tuple[str, str, Any, Position]]:
        """Every (family, name, value, position) of one section, in file order."""
        for family, content in self.families.items():
            part = content.get(section)
            if isinstance(part, Map):
                for name, value in part.items():
                    yield family, name, value, part.at(name)


def directions_of(command: Map) -> tuple[str, ...]:
    """The directions in which the spec describes a command; both if it describes neither."""
    both = ("from_board", "to_board")
    return tuple(direction for direction in both if direction in command) or both


def maps_in(node: Map | list[Any]) -> list[Map]:
    """A node and the nodes in it that are mappings, in the order of the file."""
    found = [node] if isinstance(node, Map) else []
    for value in node.values() if isinstance(node, Map) else node:
        if isinstance(value, (Map, list)):
            found += maps_in(value)
    return found


def empty_map(position: Position) -> Map:
    result = Map()
    result.position = position
    result.keys_at = {}
    return result


def _scalar(node: yaml.ScalarNode) -> Any:
    if node.style in ("'", '"', "|", ">"):
        return node.value
    text = str(node.value)
    if text in _WORDS:
        return _WORDS[text]
    if text[0] not in "+-0123456789":
        return text
    if _INT.match(text):
        return int(text)
    if _HEX.match(text):
        return int(text, 16)
    return text


class _Builder:
    def __init__(self, file: str, found: Diagnostics) -> None:
        self.file = file
        self.found = found
        self.seen: set[int] = set()

    def position(self, node: yaml.Node) -> Position:
        return Position(self.file, node.start_mark.line + 1, node.start_mark.column + 1)

    def build(self, node: yaml.Node) -> Any:
        if id(node) in self.seen:  # an alias; the node could contain itself
            hint = "write it out, or make it a struct or 'same_as'"
            self.found.add(self.position(node), "SBGC001", "YAML anchors cannot be used here", hint)
            return None
        self.seen.add(id(node))
        if isinstance(node, yaml.MappingNode):
            return self.mapping(node)
        if isinstance(node, yaml.SequenceNode):
            result = List(self.build(item) for item in node.value)
            result.position = self.position(node)
            result.items_at = [self.position(item) for item in node.value]
            return result
        assert isinstance(node, yaml.ScalarNode)
        return _scalar(node)

    def mapping(self, node: yaml.MappingNode) -> Map:
        result = empty_map(self.position(node))
        for key_node, value_node in node.value:
            if not isinstance(key_node, yaml.ScalarNode):
                hint = "put quotes around a name that contains brackets or braces"
                self.found.add(self.position(key_node), "SBGC001", "a key is a single word", hint)
                continue
            key = str(key_node.value)
            at = self.position(key_node)
            if key in result:
                first = result.keys_at[key]
                message = f"key '{key}' occurs twice (first at {first})"
                self.found.add(at, "SBGC002", message, "keep one of them")
                continue
            result[key] = self.build(value_node)
            result.keys_at[key] = at
        return result


def _read(path: Path, name: str, found: Diagnostics) -> Map:
    at = Position(name)
    try:
        content = path.read_bytes()
    except OSError as error:
        found.add(at, "SBGC001", f"cannot read the file: {error.strerror}")
        return empty_map(at)
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        at = _position_of(name, content[: error.start])
        found.add(at, "SBGC001", "the file is not UTF-8", "save it as UTF-8 in your editor")
        return empty_map(at)
    for match in _INVISIBLE.finditer(text):
        at = _position_of(name, text[: match.start()].encode())
        what = f"U+{ord(match[0]):04X} {unicodedata.name(match[0], '')}".rstrip()
        found.add(at, "SBGC001", f"an invisible character: {what}", "delete it")
    at = Position(name)
    try:
        root = yaml.compose(text, Loader=_SafeLoader)  # type: ignore[no-untyped-call]
    except yaml.reader.ReaderError as error:
        at = _position_of(name, text.encode()[: error.position])
        found.add(at, "SBGC001", f"not valid YAML: {error.reason}", "delete the character")
        return empty_map(at)
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        if mark is not None:
            at = Position(name, mark.line + 1, mark.column + 1)
        problem = getattr(error, "problem", None) or str(error)
        hint = _advice(text, mark, getattr(error, "context_mark", None))
        found.add(at, "SBGC001", f"not valid YAML: {problem}", hint)
        return empty_map(at)
    if not isinstance(root, yaml.MappingNode) or not root.value:
        found.add(at, "SBGC001", "a spec file is a mapping", "start with 'family:' or 'protocol:'")
        return empty_map(at)
    try:
        built = _Builder(name, found).build(root)
    except RecursionError:
        found.add(at, "SBGC001", "not valid YAML: nested too deeply", "check brackets and braces")
        return empty_map(at)
    assert isinstance(built, Map)
    return built


def _advice(text: str, mark: Any, context: Any) -> str:
    """A hint for repairing a syntax error: the character that usually causes such an error."""
    if mark is not None:
        first = context.line if context is not None else mark.line
        lines = text.split("\n")
        for number in range(max(0, mark.line - 1), min(mark.line + 1, len(lines))):
            line = lines[number]
            plain = _QUOTED.sub("", line)
            before, hash_, _ = plain.partition(" #")
            if hash_ and before.count("{") > before.count("}"):
                return "'#' after a blank starts a comment: put quotes around the text"
            is_text = re.search(r":\s+[^\s,{}][^,{}]*[{]|:\s+[{][^{}:,]*[}]\s*[^\s,}]", plain)
            if is_text and number >= first:
                return "put quotes around a text or name that contains braces"
    return "check indentation and quotes"


def _position_of(name: str, before: bytes) -> Position:
    """The position after the bytes `before`."""
    lines = before.decode("utf-8", errors="replace").split("\n")
    return Position(name, len(lines), len(lines[-1]) + 1)


def _main_file(spec_dir: Path) -> str | None:
    """The name of the file that describes the whole protocol."""
    for path in sorted(spec_dir.glob("*.yaml")):
        if path.name != _ERRATA and path.is_file() and _MAIN_KEY.search(path.read_bytes()):
            return path.name
    return None


def load(spec_dir: Path, found: Diagnostics) -> Spec:
    """Read the main file, the families it lists and the errata; findings go into `found`."""

    def read(file: str) -> Map:
        path = spec_dir / file
        spec.files.append(path)
        return _read(path, f"{spec_dir.name}/{file}", found)

    spec = Spec(main=empty_map(Position(spec_dir.name)))
    main_file = _main_file(spec_dir)
    if main_file is None:
        hint = "the main file describes the protocol with it"
        found.add(spec.main.position, "SBGC001", "no file has the key 'protocol'", hint)
        return spec
    spec.main = read(main_file)
    families = spec.main.get("families", [])
    for family in families if isinstance(families, list) else []:
        if isinstance(family, str) and family.isidentifier():
            spec.families[family] = read(f"{family}.yaml")
    if (spec_dir / _ERRATA).exists():
        spec.errata = read(_ERRATA)
    for path in sorted(spec_dir.glob("*.y*ml")) if spec.families else []:
        if path not in spec.files:
            text = f"the file is not listed under 'families' in {main_file}"
            hint = f"add '{path.stem}' there (files end in .yaml), or delete the file"
            found.add(Position(f"{spec_dir.name}/{path.name}"), "SBGC003", text, hint)
    return spec
