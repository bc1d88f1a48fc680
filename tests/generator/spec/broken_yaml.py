"""Specs that someone has broken: any YAML tree with wrong nodes, and any text with wrong bytes.

`generator/python tests/generator/spec/broken_yaml.py` tries thousands of them with the spec of the project.
Each must be read, or refused with findings that name a place: no traceback and no hang.
"""

from __future__ import annotations

import argparse
import copy
import random
import re
import shutil
import signal
import sys
import tempfile
import traceback
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import yaml

from sbgcgen.build import load_protocol
from sbgcgen.spec.diagnostics import Diagnostic, SpecError

PROJECT = Path(__file__).resolve().parents[3]
# The longest time for one spec, in seconds; a busy machine needs a tenth of it.
LIMIT = 60

_WORDS = """0 -1 255 256 65536 -2147483649 18446744073709551616 1e999 .nan .inf -.Inf 0x 0xZZ 0b11 0o17 010 1_000
    1:30 2001-01-01 2001-01-01T00:00:00Z yes on null ~ = << . .. ... -- 1.. ..1 5..1 1..2..3 -1..-9
    0..99999999999999999999 1/0 0/1 1/ 2.50 2.999 99.99 u8 i64 f64 u0 u-8 text[] bytes[] bytes[0] bytes[256]
    bytes[-1] bytes[99999999999999999999] text[N] A[] A[B] A[[1]] A[999999999] A{1..999999999} A{9..1} {AXIS}
    axes[axis] class int if __init__ true! &a *a @ ` % ! | > ? : , \\ / ' " # CMD_CONTROL E001 E999 always never
    none safe reads L0 L99999999 L9-L1 \N{BOM} \N{NO-BREAK SPACE} \N{RIGHT-TO-LEFT OVERRIDE}x \N{GRINNING FACE}
    \N{LINE SEPARATOR} \N{LATIN SMALL LETTER E}\N{COMBINING ACUTE ACCENT}"""
_SCALARS = [word.strip() for word in _WORDS.split(" ")]
_SCALARS += ["", " ", "\t", "\n", "a\nb", "\x1b[31m", "\x7f", "\x85"]
_HUGE = [
    *("9" * 5000, "-" + "9" * 20000, "0x" + "F" * 5000, "a" * 100_000, "A_" * 20_000, "(" * 20_000),
    *("1.." * 10_000, "CMD_X " * 10_000, "0." + "1" * 10_000),
]
_TAGS = ["!!str", "!!int", "!!binary", "!!set", "!!python/object/apply:os.abort", "!x", "!<y>"]

Change = Callable[[random.Random, Any], None]
Edit = Callable[[random.Random, bytes], bytes]


# Trees of YAML nodes.


def _walk(node: Any, seen: set[int] | None = None) -> Iterator[Any]:
    seen = set() if seen is None else seen
    if id(node) in seen:
        return
    seen.add(id(node))
    yield node
    if isinstance(node, yaml.MappingNode):
        for key, value in node.value:
            yield from _walk(key, seen)
            yield from _walk(value, seen)
    elif isinstance(node, yaml.SequenceNode):
        for item in node.value:
            yield from _walk(item, seen)


# A change that finds no node to change raises IndexError, or ValueError for the place of one.


def _any(chance: random.Random, root: Any, *kinds: type) -> Any:
    return chance.choice([node for node in _walk(root) if isinstance(node, kinds or yaml.Node)])


def _collection(chance: random.Random, root: Any) -> Any:
    return _any(chance, root, yaml.MappingNode, yaml.SequenceNode)


def _keys(parent: Any) -> list[Any]:
    return [key for key, _ in parent.value if isinstance(key, yaml.ScalarNode)]


def _scalar(text: str, chance: random.Random) -> yaml.ScalarNode:
    style = chance.choice([None, None, None, "'", '"', "|", ">"])
    return yaml.ScalarNode(_TAG, text, style=style)


_TAG = "tag:yaml.org,2002:str"
_TAG_OF = {
    yaml.ScalarNode: _TAG,
    yaml.MappingNode: "tag:yaml.org,2002:map",
    yaml.SequenceNode: "tag:yaml.org,2002:seq",
}


def _become(node: Any, other: Any) -> None:
    """Makes a node, which others may refer to, one like `other`."""
    node.__class__ = other.__class__
    node.__dict__.update(other.__dict__)


def _replace(chance: random.Random, root: Any, new: Any) -> None:
    """Puts a node in the place of a random value or key."""
    parent = _collection(chance, root)
    at = chance.randrange(len(parent.value))
    if isinstance(parent, yaml.SequenceNode):
        parent.value[at] = new
    else:
        key, value = parent.value[at]
        parent.value[at] = (new, value) if chance.random() < 0.3 else (key, new)


def _drop(chance: random.Random, root: Any) -> None:
    parent = _collection(chance, root)
    del parent.value[chance.randrange(len(parent.value))]


def _empty(chance: random.Random, root: Any) -> None:
    _collection(chance, root).value = []


def _repeat(chance: random.Random, root: Any) -> None:
    """The same key or item again, up to many times."""
    parent = _collection(chance, root)
    item = chance.choice(parent.value)
    for _ in range(chance.choice((1, 1, 2, 300))):
        parent.value.insert(chance.randrange(len(parent.value) + 1), copy.deepcopy(item))


def _multiply(chance: random.Random, root: Any) -> None:
    """Many entries like one, each with a key of its own."""
    parent = _any(chance, root, yaml.MappingNode)
    key = chance.choice(_keys(parent))
    value = next(value for other, value in parent.value if other is key)
    for number in range(chance.choice((20, 400))):
        parent.value.append((yaml.ScalarNode(_TAG, f"{key.value}{number}"), copy.deepcopy(value)))


def _transplant(chance: random.Random, root: Any) -> None:
    """A node where another kind of node belongs."""
    _replace(chance, root, copy.deepcopy(_any(chance, root)))


def _exchange(chance: random.Random, root: Any) -> None:
    one, other = _any(chance, root, yaml.ScalarNode), _any(chance, root, yaml.ScalarNode)
    one.value, other.value = other.value, one.value


def _rename(chance: random.Random, root: Any) -> None:
    """Another key: misspelled, of another node, or odd."""
    key = chance.choice(_keys(_any(chance, root, yaml.MappingNode)))
    other = _any(chance, root, yaml.ScalarNode).value
    at = chance.randrange(len(key.value) + 1)
    misspelled = key.value[:at] + key.value[at + 1 :]
    key.value = chance.choice((misspelled, other, chance.choice(_SCALARS)))


def _odd(chance: random.Random, root: Any) -> None:
    _replace(chance, root, _scalar(chance.choice(_SCALARS), chance))


def _number(chance: random.Random, root: Any) -> None:
    nodes = [node for node in _walk(root) if isinstance(node, yaml.ScalarNode)]
    node = chance.choice([node for node in nodes if re.search("[0-9]", node.value)])
    number = chance.choice(("0", "-1", "1", "256", "70000", str(2**31), str(2**64), "9" * 400))
    run = chance.choice(list(re.finditer("[0-9]+", node.value)))
    node.value = node.value[: run.start()] + number + node.value[run.end() :]


def _huge(chance: random.Random, root: Any) -> None:
    _replace(chance, root, _scalar(chance.choice(_HUGE), chance))


def _retype(chance: random.Random, root: Any) -> None:
    """A list, a mapping or nothing in place of a value, around it or from its parts."""
    node = _any(chance, root)
    inner = copy.deepcopy(node)
    pair = (yaml.ScalarNode(_TAG, "name"), inner)
    values = {
        yaml.SequenceNode: ([inner], [inner, copy.deepcopy(inner)], []),
        yaml.MappingNode: ([pair], []),
        yaml.ScalarNode: ("", str(inner.value)[:200]),
    }
    kind, value = chance.choice([(kind, value) for kind in values for value in values[kind]])
    _become(node, kind(_TAG_OF[kind], value))


def _deepen(chance: random.Random, root: Any) -> None:
    inner = _any(chance, root)
    result = copy.deepcopy(inner)
    for _ in range(chance.choice((1, 2, 5, 40))):
        kind = chance.choice((yaml.SequenceNode, yaml.MappingNode))
        pair: Any = (yaml.ScalarNode(_TAG, "fields"), result)
        result = kind(_TAG_OF[kind], [result if kind is yaml.SequenceNode else pair])
    _become(inner, result)


def _alias(chance: random.Random, root: Any) -> None:
    """The same node at two places, possibly in itself; perhaps as a merge key."""
    if chance.random() < 0.3:
        merge = yaml.ScalarNode(_TAG, "<<")
        _any(chance, root, yaml.MappingNode).value.append((merge, _collection(chance, root)))
    else:
        _replace(chance, root, _any(chance, root))


def _bomb(chance: random.Random, root: Any) -> None:
    """Aliases of aliases: a billion nodes if someone writes them out."""
    bomb: Any = yaml.SequenceNode(_TAG_OF[yaml.SequenceNode], [_scalar("x", chance)] * 2)
    for _ in range(30):
        bomb = yaml.SequenceNode(_TAG_OF[yaml.SequenceNode], [bomb] * 9)
    _replace(chance, root, bomb)


def _tag(chance: random.Random, root: Any) -> None:
    _any(chance, root).tag = chance.choice(_TAGS)


CHANGES: list[Change] = [
    *(_drop, _empty, _repeat, _multiply, _transplant, _exchange, _rename, _odd, _number, _huge),
    *(_retype, _deepen, _alias, _bomb, _tag),
]


class _Dumper(yaml.CDumper):
    """Writes scalars as they are told to be written."""

    def resolve(self, kind: Any, value: Any, implicit: Any) -> str:
        return _TAG_OF[kind]


def _changed(chance: random.Random, content: bytes) -> bytes:
    """The YAML with one or more wrong nodes."""
    root = yaml.compose(content.decode(), Loader=yaml.CBaseLoader)  # type: ignore[no-untyped-call]
    for _ in range(chance.choice((1, 1, 1, 2, 4))):
        with suppress(IndexError, ValueError):
            chance.choice(CHANGES)(chance, root)
    for node in _walk(root):
        node.tag = node.tag or _TAG_OF[type(node)]
    text: str = yaml.serialize(root, Dumper=_Dumper, width=200, allow_unicode=True)
    return text.encode("utf-8", "surrogatepass")


# Text.

_PIECES = [
    *(b"\t", b"\t- x", b"\0", b"\x1b", b"\xff", b"\xc3", b"\xed\xa0\x80", b"\xf4\x90\x80\x80"),
    *(b"\xef\xbb\xbf", b"\r", b"\xc2\x85", b"\xe2\x80\xa8", b"---\n", b"...\n"),
    *(b"%YAML 3.0\n---\n", b"%TAG ! tag:x\n", b"&a ", b"*a ", b"*nowhere ", b"? "),
    *(b"? [a, b]\n: c\n", b"|9\n", b">-\n", b"!!binary ", b"!<", b"@", b"`", b"'", b'"', b'"\\x'),
    *(b'"\\ud800"', b"{", b"}", b"[" * 50, b"{a: " * 3000, b"[" * 100_000, b"- " * 5000),
    *(b"a: &a [" + b"*a, " * 20 + b"]\n", b": ", b"#", b" "),
]


def _cut(chance: random.Random, content: bytes) -> bytes:
    return content[: chance.randrange(len(content))]


def _insert(chance: random.Random, content: bytes) -> bytes:
    at = chance.randrange(len(content) + 1)
    return content[:at] + chance.choice(_PIECES) + content[at:]


def _overwrite(chance: random.Random, content: bytes) -> bytes:
    at = chance.randrange(len(content))
    return content[:at] + bytes([chance.randrange(256)]) + content[at + 1 :]


def _remove(chance: random.Random, content: bytes) -> bytes:
    at = chance.randrange(len(content))
    return content[:at] + content[at + chance.choice((1, 2, 7, 300)) :]


def _reorder(chance: random.Random, content: bytes) -> bytes:
    lines = content.splitlines(keepends=True)
    one, other = chance.randrange(len(lines)), chance.randrange(len(lines))
    lines[one], lines[other] = lines[other], lines[one]
    return b"".join(lines)


def _indent(chance: random.Random, content: bytes) -> bytes:
    lines = content.splitlines(keepends=True)
    at = chance.randrange(len(lines))
    for line in range(at, min(at + chance.choice((1, 3)), len(lines))):
        lines[line] = chance.choice((b" ", b"  ", b"\t", b"      ")) + lines[line]
    return b"".join(lines)


EDITS: list[Edit] = [_cut, _insert, _overwrite, _remove, _reorder, _indent]


def broken(seed: int, content: bytes) -> bytes:
    """The content of a spec file, broken in the way that the seed stands for."""
    chance = random.Random(seed)
    if seed % 3:
        return _changed(chance, content)
    for _ in range(chance.choice((1, 1, 2))):
        content = chance.choice(EDITS)(chance, content) or b"a: b\n"
    return content


# Trials.


@contextmanager
def _time_limit(seconds: int) -> Iterator[None]:
    def end(*_: object) -> None:
        raise TimeoutError(f"no result after {seconds} s")

    before = signal.signal(signal.SIGALRM, end)
    signal.alarm(seconds)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)


def _lines_in(content: bytes) -> int:
    """The number of lines as YAML counts them."""
    return len(re.split(rb"\r\n|[\n\r]|\xc2\x85|\xe2\x80[\xa8\xa9]", content))


def _check_finding(finding: Diagnostic, lines: dict[str, int]) -> None:
    """Fails for a finding that would not help its reader; `lines` has the number of lines per file."""
    assert re.fullmatch(r"SBGC0[0-9][0-9]", finding.code), finding.code
    folder, _, name = finding.position.file.partition("/")
    assert folder == "spec" and name, finding.position
    assert 1 <= finding.position.line <= lines.get(name, 0) + 1, finding.position
    assert finding.position.column >= 1, finding.position
    assert finding.message
    shown = str(finding).split("\n    hint: ")
    assert len(shown) <= 2
    for text in shown:
        assert text.isprintable() and len(text) < 2000, repr(text[:200])


def outcome(spec: Path) -> list[Diagnostic]:
    """Reads a spec. Returns its findings, which must be clean; raises what the generator must not."""
    try:
        with _time_limit(LIMIT):
            load_protocol(spec)
    except SpecError as error:
        lines = {path.name: _lines_in(path.read_bytes()) for path in spec.iterdir()}
        for finding in error.diagnostics:
            _check_finding(finding, lines)
        return error.diagnostics
    return []


def _main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cases", type=int, default=1000)
    parser.add_argument("--first", type=int, default=0, help="the first seed")
    options = parser.parse_args()
    failures = refused = 0
    with tempfile.TemporaryDirectory() as folder:
        spec = Path(folder) / "spec"
        shutil.copytree(PROJECT / "spec", spec)
        names = sorted(path.name for path in spec.glob("*.yaml"))
        for seed in range(options.first, options.first + options.cases):
            file = spec / random.Random(-seed).choice(names)
            original = file.read_bytes()
            file.write_bytes(broken(seed, original))
            try:
                refused += bool(outcome(spec))
            except Exception:
                failures += 1
                kept = Path(tempfile.gettempdir()) / f"broken-{seed}-{file.name}"
                shutil.copy(file, kept)
                told = traceback.format_exc(limit=-6, chain=False)
                print(f"seed {seed}, {kept}:\n{told}", flush=True)
            file.write_bytes(original)
    print(f"{options.cases} broken specs: {refused} refused, {failures} failures")
    return 1 if failures or not refused else 0


if __name__ == "__main__":
    sys.exit(_main())
