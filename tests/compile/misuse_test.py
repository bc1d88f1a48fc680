"""Mistakes that do not compile: the compiler reports exactly one error, with a helpful message."""

from __future__ import annotations

import re
import subprocess
from dataclasses import dataclass
from pathlib import Path

import pytest

from compiler import COMPILERS, INCLUDES, ROOT, Compiler


@dataclass(frozen=True)
class Misuse:
    """`code` with the placeholder WRONG: with `wrong` it fails to compile, with `right` it compiles.

    `says` is part of the only error.
    """

    name: str
    code: str
    wrong: str
    right: str
    says: str


# Not sbgc/responses/, whose absence is one of the mistakes.
HEADERS = """
#include <sbgc/client/client.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/session.hpp>
"""
STREAM = """
void use(sbgc::Client& client) {
  static_cast<void>(client.stream<sbgc::msg::WRONG>(std::chrono::milliseconds(20), [](const auto&) {}));
}
"""

MISUSES = [
    Misuse(
        "send_without_its_header",
        "WRONG\nvoid use(sbgc::Session& session) { session.send(sbgc::msg::MotorsOn{}); }",
        wrong="",
        right="#include <sbgc/responses/control.hpp>",
        says="include <sbgc/responses/all.hpp>",
    ),
    Misuse(
        "send_what_the_board_sends",
        "#include <sbgc/responses/all.hpp>\n"
        + "void use(sbgc::Session& session) { session.send(sbgc::msg::WRONG{}); }",
        wrong="BoardInfo",
        right="BoardInfoRequest",
        says="only the board sends this message",
    ),
    Misuse(
        "call_with_an_answer",
        "void use(sbgc::Client& client) { static_cast<void>(client.call(sbgc::msg::WRONG{})); }",
        wrong="GetAngles",
        right="GetAnglesRequest",
        says="a call takes the request that it answers",
    ),
    Misuse(
        "stream_of_a_message_without_one",
        STREAM,
        wrong="GetAngles",
        right="RealtimeData4",
        says="the board has no data stream of this message",
    ),
    Misuse(
        "stream_of_a_request",
        STREAM,
        wrong="BoardInfoRequest",
        right="AhrsHelper",
        says="the board has no data stream of this message",
    ),
]


def errors_of(compiler: Compiler, source: str) -> list[str]:
    """Compiles `source` and returns the lines with errors."""
    done = compiler.compile(source)
    errors = [line for line in done.stderr.splitlines() if "error: " in line]
    assert (done.returncode != 0) == bool(errors), done.stderr
    return errors


@pytest.fixture(name="compiler", params=COMPILERS, scope="module")
def each_compiler(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> Compiler:
    return Compiler(request.param, HEADERS, tmp_path_factory.mktemp(request.param))


@pytest.mark.parametrize("misuse", MISUSES, ids=lambda misuse: misuse.name)
def test_the_compiler_says_what_is_wrong(compiler: Compiler, misuse: Misuse) -> None:
    assert not errors_of(compiler, misuse.code.replace("WRONG", misuse.right))
    errors = errors_of(compiler, misuse.code.replace("WRONG", misuse.wrong))
    assert len(errors) == 1 and misuse.says in errors[0], errors


@pytest.mark.parametrize("name", COMPILERS)
@pytest.mark.parametrize(
    "header", ["client/client.hpp", "messages.hpp", "units.hpp", "enums.hpp", "any.hpp"]
)
def test_older_cpp_is_refused_in_one_sentence(name: str, header: str) -> None:
    done = subprocess.run(
        [
            name,
            "-std=c++17",
            *(f"-I{path}" for path in INCLUDES),
            "-fsyntax-only",
            "-x",
            "c++",
            "-",
        ],
        input=f"#include <sbgc/{header}>\n",
        capture_output=True,
        text=True,
        check=False,
    )
    said, missing = [line for line in done.stderr.splitlines() if "error: " in line]
    assert "sbgc needs C++20: compile with -std=c++20" in said
    assert "fatal error: " in missing and "the_compiler_stops_here" in missing


@pytest.mark.parametrize("name", COMPILERS)
def test_generated_headers_of_another_generator_do_not_compile(name: str, tmp_path: Path) -> None:
    header = (ROOT / "generated/include/sbgc/messages/scripting.hpp").read_text(encoding="utf-8")
    source = header.replace("#pragma once", "")
    other = re.sub(r"(?<=codec_version == )\d+", "1", source)
    assert other != source
    compiler = Compiler(name, "#include <sbgc/codec.hpp>\n", tmp_path)
    assert not errors_of(compiler, source)
    errors = errors_of(compiler, other)
    assert len(errors) == 1 and "generated code and runtime do not match" in errors[0], errors
