"""The headers for microcontrollers: each compiles alone, freestanding, without exceptions and RTTI, and
includes nothing that needs an operating system; the code calls only functions such as memcpy.

JSON and text output are not for microcontrollers.
"""

from __future__ import annotations

import re
import subprocess
from collections.abc import Iterable
from functools import cache
from pathlib import Path

import pytest

from compiler import COMPILERS, INCLUDES, LAST_COMPILER, ROOT, Compiler, cross_compilers

HOSTED = re.compile(
    r"^sbgc/(any|field_type|value_text|json|parse_json|to_json|from_json|text|explain|fmt|ostream|error|result"
    r"|io/|analysis/|doctor/|client/|internal/(characters|find_by|foreign_kind|own_json"
    r"|parse_number|parse_real|suggestions|words))"
)
FLAGS = [
    "-std=c++20",
    "-ffreestanding",
    "-fno-exceptions",
    "-fno-rtti",
    "-Wall",
    "-Wextra",
    "-Werror",
]
FLAGS += [f"-I{folder}" for folder in INCLUDES]
TARGETS = {**{name: [name] for name in COMPILERS}, **cross_compilers()}

# The headers that may be included. Headers that these include in turn are up to the standard
# library.
ALLOWED = {
    "array",
    "bit",
    "compare",
    "concepts",
    "cstddef",
    "cstdint",
    "initializer_list",
    "limits",
    "new",
    "span",
    "type_traits",
    "utility",
}
# Functions that a compiler may call in freestanding code; the last one is in its own library.
RUNTIME_CALLS = {"memcpy", "memmove", "memset", "memcmp", "bcmp", "__popcountdi2"}


def headers() -> list[str]:
    found = [
        path.relative_to(folder).as_posix() for folder in INCLUDES for path in folder.rglob("*.hpp")
    ]
    return sorted(name for name in found if not HOSTED.match(name))


def compile_text(target: str, source: str, *options: str) -> str:
    """Compiles `source` and returns the standard output; fails with the compiler's messages."""
    command = [*TARGETS[target], *FLAGS, "-x", "c++", *options, "-"]
    done = subprocess.run(command, input=source, capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{' '.join(command)}\n{source}\n{done.stderr}"
    return done.stdout


def read_files(target: str, source: str) -> set[str]:
    """Returns the files that compiling `source` reads."""
    rule = compile_text(target, source, "-M").replace("\\\n", " ")
    names = [name.replace("\\ ", " ") for name in re.findall(r"(?:\\.|\S)+", rule)]
    return {str(Path(name).resolve()) for name in names[1:] if name != "-"}


def is_own(path: str) -> bool:
    return any(Path(path).is_relative_to(folder) for folder in INCLUDES)


def including(names: Iterable[str]) -> str:
    return "".join(f"#include <{name}>\n" for name in names)


def test_there_are_headers() -> None:
    assert {"sbgc/codec.hpp", "sbgc/parser.hpp", "sbgc/dispatch.hpp"} <= set(headers())


def test_direct_includes() -> None:
    wrong = []
    for name in headers():
        for include in direct_includes(name):
            if include == "the_compiler_stops_here":  # before C++20
                continue
            if include not in ALLOWED and not (
                include.startswith("sbgc/") and not HOSTED.match(include)
            ):
                wrong.append(f"{name} includes {include}")
    assert not wrong


def direct_includes(name: str) -> list[str]:
    path = next(folder / name for folder in INCLUDES if (folder / name).exists())
    text = path.read_text(encoding="utf-8")
    return re.findall(r'^\s*#\s*include\s*[<"]([^>"]+)', text, re.MULTILINE)


@cache
def all_includes(name: str) -> frozenset[str]:
    """Returns the headers that one of ours reads, also by way of others."""
    direct = direct_includes(name) if name.startswith("sbgc/") else []
    return frozenset(direct).union(*map(all_includes, direct))


def chains() -> list[list[str]]:
    """Divides the headers into lists in which each header includes all that those before it include.

    A header in a list sees no declaration that it does not include itself, as if it were alone. So one run
    of the compiler checks all headers of a list.
    """
    left = sorted(headers(), key=lambda name: (len(all_includes(name)), name))
    found = []
    while left:
        chain = [left.pop()]
        for name in reversed(left):
            if {name, *all_includes(name)} <= all_includes(chain[0]):
                chain.insert(0, name)
        left = [name for name in left if name not in chain]
        found.append(chain)
    return found


def test_chains() -> None:
    seen: list[str] = []
    for chain in chains():
        seen += chain
        for name, following in zip(chain, chain[1:]):
            assert {name, *all_includes(name)} <= all_includes(following)
    assert sorted(seen) == headers()


def test_each_header_alone(tmp_path: Path) -> None:
    """Checks with one compiler, because a missing include does not depend on it.

    If all headers of a chain include those of `common`, the compiler reads these from a precompiled header.
    """
    common = ["sbgc/codec.hpp", "sbgc/enums.hpp", "sbgc/literals.hpp"]
    included = frozenset(common).union(*map(all_includes, common))
    compilers = []
    for number, head in enumerate((list[str](), common)):
        (tmp_path / f"{number}").mkdir()
        compilers.append(Compiler(COMPILERS[-1], including(head), tmp_path / f"{number}", FLAGS))
    for chain in chains():
        done = compilers[included <= all_includes(chain[0])].compile(including(chain))
        assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("target", TARGETS)
def test_all_headers_together(target: str) -> None:
    compile_text(target, including(headers()), "-fsyntax-only")


@pytest.mark.parametrize("target", TARGETS)
def test_nothing_else_is_read(target: str) -> None:
    """Apart from sbgc's own headers, only files that the allowed headers include are read."""
    allowed = read_files(target, including(sorted(ALLOWED)))
    everything = read_files(target, including(headers()))
    assert any(is_own(path) for path in everything)
    assert {path for path in everything if not is_own(path)} <= allowed


USE_EVERYTHING = """
#include <sbgc/detector.hpp>
#include <sbgc/responses/all.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/message.hpp>
#include <sbgc/session.hpp>
#include <sbgc/validate.hpp>
#include <sbgc/visit.hpp>

sbgc::Session session;

unsigned talk(const std::uint8_t* bytes, std::size_t size, std::int64_t now) {
  unsigned result = 0;
  const auto sink = [&](const sbgc::Event& event) { result += event.frame.id; };
  result += static_cast<unsigned>(session.send(sbgc::msg::ReadParams3Request{}).status);
  session.feed({bytes, size}, {now}, sink);
  result += static_cast<unsigned>(session.poll({now}, sink).bytes.size());
  session.cancel({result}, sink);
  session.abandon(sink);
  return result + static_cast<unsigned>(session.statistics().timeouts);
}

unsigned search(const std::uint8_t* bytes, std::size_t size, std::int64_t now) {
  static constinit sbgc::Detector detector;
  detector.feed({bytes, size});
  return static_cast<unsigned>(detector.next({now}).kind) + detector.introduction().id;
}

unsigned use(const std::uint8_t* bytes, std::size_t size, std::span<std::uint8_t> out) {
  unsigned result = 0;
  sbgc::Contexts contexts;
  static constinit sbgc::Parser parser;
  parser.feed({bytes, size}, [&](const sbgc::Frame& frame) {
    sbgc::visit(frame, sbgc::Direction::from_board, [&](const auto& message) {
      contexts.learn(message);
      result += sbgc::is_valid(message);
      result += static_cast<unsigned>(sbgc::encode_frame(message, out).size);
    }, contexts);
  });
  return result;
}
"""


@pytest.mark.parametrize("target", LAST_COMPILER)
def test_code_needs_nothing(target: str, tmp_path: Path) -> None:
    """No allocation, exceptions or library: only functions that freestanding compilers expect."""
    program = tmp_path / "use.o"
    compile_text(target, USE_EVERYTHING, "-Os", "-c", "-o", str(program))
    listing = subprocess.run(
        ["nm", "-u", program], capture_output=True, text=True, check=True
    ).stdout
    undefined = {line.split()[-1] for line in listing.splitlines()}
    assert undefined - {"_GLOBAL_OFFSET_TABLE_"} <= RUNTIME_CALLS


HEADER = "runtime/core/include/sbgc/internal/compiler.hpp"
PECULIAR = re.compile(
    r"__builtin|__attribute__|__restrict|\b(?:gnu|clang|msvc)::"
    r"|__(?:GNUC|clang|SSE|x86_64|arm|aarch64|BYTE_ORDER)|_MSC_VER|_WIN32|#pragma (?!once)"
)
# The modules of the site are compiled by one compiler, and export functions to JavaScript.
FREE = {HEADER, "web/modules/exchange.hpp"}


def peculiar_lines(path: str) -> list[str]:
    lines = (ROOT / path).read_text(encoding="utf-8").splitlines()
    # A name that is deprecated is used in the headers themselves.
    lines = [line for line in lines if not line.startswith("#pragma GCC diagnostic ")]
    return [line for line in lines if PECULIAR.search(line.split("//")[0])]


@pytest.mark.parametrize("folder", ["runtime", "generated/include", "emulator", "tools"])
def test_other_files_are_standard_cpp(folder: str) -> None:
    files = [p.relative_to(ROOT).as_posix() for p in (ROOT / folder).rglob("*.[ch]pp")]
    assert files
    found = {path: peculiar_lines(path) for path in files if path not in FREE}
    assert {path: lines for path, lines in found.items() if lines} == {}


def test_the_header_has_them() -> None:
    assert len(peculiar_lines(HEADER)) > 5
