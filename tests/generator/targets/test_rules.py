"""The rules of targets for a spec: names that C++ and Python do not accept, and the limits of the dissector."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from sbgcgen.targets.cpp.lint import TYPES, WORDS, can_be_a_name
from sbgcgen.targets.python.target import TAKEN
from sbgcgen.targets.wireshark.tables import lua
from support import PROJECT, findings, project_layout


def test_names_of_cpp() -> None:
    assert can_be_a_name("acc_limiter3")
    assert not any(can_be_a_name(word) for word in WORDS)
    assert not can_be_a_name("a__b")


def test_words_of_cpp20_are_complete() -> None:
    """[lex.key], [lex.digraph] of C++20; a missing word breaks the user's build."""
    for word in ("concept", "requires", "co_await", "char8_t", "char16_t", "char32_t", "consteval"):
        assert word in WORDS
    for word in ("and_eq", "not_eq", "or_eq", "xor_eq", "const_cast"):
        assert word in WORDS
    assert "final" not in WORDS, "it is a keyword only in some contexts"


def test_types_that_messages_use_are_complete() -> None:
    """A message of the same name would hide them."""
    own = {message.name for message in project_layout().messages}
    assert (declared() & used()) - own == TYPES - {"I24"}  # no message has one today


_NAMESPACE = re.compile(r"(?:inline )?namespace ([\w:]+) \{")
_TYPE = re.compile(
    r"(?:template <.*> )?(?:class|struct|enum class|union|using|concept)"
    r" (?:\[\[\w+\]\] |\w+\(\w+\) )?([A-Z]\w*)(?! *<)\b"
)


def declared_in(text: str) -> Iterator[str]:
    """The names of the types in the namespace `sbgc` itself; its contents are not indented."""
    inside: list[str] = []
    for line in text.splitlines():
        if opened := _NAMESPACE.match(line):
            inside.append(opened[1])
        elif line.startswith("}  // namespace"):
            inside.pop()
        elif inside == ["sbgc"] and (declared := _TYPE.match(line)):
            yield declared[1]


def declared() -> set[str]:
    """The types that all headers of the library declare."""
    folders = [p for p in (PROJECT / "runtime").iterdir() if (p / "include").is_dir()]
    headers: list[Path] = [h for f in folders for h in (f / "include").rglob("*.hpp")]
    headers += (PROJECT / "generator/sbgcgen/targets/cpp/templates").rglob("*.hpp.j2")
    return {name for header in headers for name in declared_in(header.read_text("utf-8"))}


def used() -> set[str]:
    """The words in the namespace of messages, where a type of the spec would hide one of these."""
    words: set[str] = set()
    for header in (PROJECT / "generated/include").rglob("*.hpp"):
        for part in header.read_text("utf-8").split("namespace sbgc::msg {\n")[1:]:
            code = re.sub(r"//.*", "", part.partition("}  // namespace sbgc::msg")[0])
            words.update(re.findall(r"(?<!::)\b[A-Z]\w*", code))
    return words


def needed(source: str) -> Iterator[str]:
    """The names that a module imports from elsewhere, or has besides the types of the spec."""
    for node in ast.parse(source).body:
        if isinstance(node, ast.ImportFrom) and node.module != "__future__":
            yield from (name.asname or name.name for name in node.names if name.name != "*")
        elif isinstance(node, ast.Assign):
            yield from (one.id for one in node.targets if isinstance(one, ast.Name))


def test_names_that_modules_need_are_complete() -> None:
    """A type of the same name would take the place of what the modules need."""
    modules = list((PROJECT / "generated/python/sbgc/msg").glob("*.py"))
    assert len(modules) > 10
    found = {name for path in modules for name in needed(path.read_text(encoding="utf-8"))}
    assert found - {"__all__"} | {"Framing"} == TAKEN


LONG = "A" * 60
WIDE = """  V:
    type: u64
    summary: Parts.
    source: L1
    parts:
      - {name: wide, bits: 0..39, summary: A wide part.}
"""


@pytest.mark.parametrize(
    ("field", "packed", "problem"),
    [
        ("{name: A, type: Angle, summary: One.}", "", ""),
        (f"{{name: {LONG}, type: P, summary: One.}}", "", "has over 128 characters"),
        ("{name: A, type: u8, summary: One.}", WIDE, "has over 32 bits"),
    ],
)
def test_limits(tmp_path: Path, field: str, packed: str, problem: str) -> None:
    text = f"""family: probe
summary: Limits.
packed:
  P:
    type: u8
    summary: Parts.
    source: L1
    parts:
      - {{name: {'part_' * 12}, bits: 0..3, summary: A part with a long name.}}
{packed}commands:
  CMD_PROBE:
    id: 9
    summary: A command.
    from_board:
      source: L1
      fields:
        - {field}
"""
    found = [str(one) for one in findings(tmp_path, text) if "SBGC022" in one.code]
    assert any(problem in one for one in found) if problem else not found, found


def test_literals_of_lua() -> None:
    assert lua({"a": 1, "end": "x", 3: True, "no": False, "none": None, "empty": []}) == (
        '{a = 1, ["end"] = "x", [3] = true}'
    )
    assert lua('"\\\n') == '"\\"\\\\\\n"'
