"""Mistakes that do not compile: the compiler reports exactly one error, with a helpful message; for literals, it
explains the alternative. What is deprecated in the protocol warns where a program names it, and nowhere else."""

from __future__ import annotations

import re
import subprocess
from dataclasses import dataclass
from pathlib import Path

import pytest

from compiler import COMPILERS, INCLUDES, LAST_COMPILER, ROOT, Compiler


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


@pytest.fixture(name="compiler", params=LAST_COMPILER, scope="module")
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


HEAD = """
#include <optional>
#include <sbgc/messages/control.hpp>
#include <sbgc/visit.hpp>
using namespace sbgc;
using namespace sbgc::literals;
struct Both {
  Optional<msg::Angle14> ours;
  std::optional<msg::Angle14> standard;
};
"""
TEST_IT = r"a number known at run time may not fit: test it, .* then use \*angle"
DOES_NOT_FIT = "this physical value does not fit into the number of the quantity on the wire"
NO_UNIT = "a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees"
NO_MESSAGE = "accepts no message: let it take one as in"
VISIT = """
void use(const Frame& frame) { visit(frame, Direction::to_board, %s); }
"""

WRONG_LITERALS = {
    "out of range": ("msg::Angle14 angle = 800_deg;", DOES_NOT_FIT),
    "below the range": ("msg::SmallDegrees angle = -1_deg;", DOES_NOT_FIT),
    "out of range in a message": (
        "msg::Control control{.axes = {.yaw = {.angle = -721_deg}}};",
        DOES_NOT_FIT,
    ),
    "out of range in an optional field": ("Both both{.ours = 800_deg};", DOES_NOT_FIT),
    "out of range in a standard optional": ("Both both{.standard = 800_deg};", DOES_NOT_FIT),
    "another unit": (
        "msg::Control control{.axes = {.yaw = {.angle = 20_deg_per_s}}};",
        r"conver\w+ .*from .*Physical<.*deg_per_s.* to .*Angle14",
    ),
    "another unit in an optional field": (
        "Both both{.ours = 12.6_V};",
        r"Physical<.*unit::V.*Optional<(sbgc::)?msg::Angle14>",
    ),
    "no unit": ("msg::Angle14 angle = -30;", NO_UNIT),
    "no unit and decimals": ("msg::Angle14 angle = -30.5;", NO_UNIT),
    "no unit in a message": ("msg::Control control{.axes = {.yaw = {.angle = -30}}};", NO_UNIT),
    "no unit in an argument": ("void go(msg::Angle14); void use() { go(-30); }", NO_UNIT),
    "no unit in an optional field": ("Both both{.ours = -30};", NO_UNIT),
    "no unit in a standard optional": (
        "Both both{.standard = -30};",
        r"from .*int.* to .*optional<.*Angle14>",
    ),
    "not decimal": (
        "msg::Angle14 angle = 0x10_deg;",
        "write the number of a physical value in decimal",
    ),
    "octal": ("msg::Angle14 angle = 010_deg;", "write the number of a physical value in decimal"),
    "too many digits": (
        "msg::Angle14 angle = 1.23456789012345678_deg;",
        "this physical value has too many digits",
    ),
    "untested": (
        "msg::Angle14 use(double x) { return msg::Angle14::from_degrees(x); }",
        TEST_IT,
    ),
    "untested in a message": (
        "void use(double x, msg::Control& c) { c.axes.yaw = {.angle = msg::Angle14::from_degrees(x)}; }",
        TEST_IT,
    ),
    "untested in an optional field": (
        "void use(double x, Both& both) { both.ours = msg::Angle14::from_degrees(x); }",
        TEST_IT,
    ),
    "a constant that does not fit": (
        "constexpr msg::Angle14 angle = *msg::Angle14::from_degrees(800);",
        "the_number_does_not_fit_into_the_quantity",
    ),
    "a real number as counts": (
        "msg::Angle14 use(double x) { return msg::Angle14(x); }",
        r"write a physical value as a literal, such as 45_deg, or with a function such as",
    ),
    "visitor of what is not const": (VISIT % "[](msg::Control&) {}", NO_MESSAGE),
    "visitor of no message": (VISIT % "[](const msg::ControlAxis&) {}", NO_MESSAGE),
    "visitor without a parameter": (VISIT % "[] {}", NO_MESSAGE),
    "one of several visitors": (
        VISIT % "[](const msg::GetAngles&) {}, [](msg::Control&) {}",
        NO_MESSAGE,
    ),
    "one function of a visitor": (
        VISIT % "overloaded{[](msg::Control&) {}, [](const auto&) {}}",
        NO_MESSAGE,
    ),
}
RIGHT_LITERALS = """
Both both{.ours = 45_deg, .standard = -45_deg};
void use(double x, msg::Control& control) {
  if (const auto angle = msg::Angle14::from_degrees(x)) control.axes.yaw.angle = *angle;
}
constexpr msg::Angle14 counts(5);
static_assert(counts.raw() == 5 && msg::Angle14{-5}.raw() == -5);
static_assert(!std::is_convertible_v<int, msg::Angle14>);
"""


@pytest.fixture(name="of_literals", params=LAST_COMPILER, scope="module")
def compiler_of_literals(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> Compiler:
    return Compiler(request.param, HEAD, tmp_path_factory.mktemp(request.param))


def test_right_forms_compile(of_literals: Compiler) -> None:
    done = of_literals.compile(RIGHT_LITERALS)
    assert done.returncode == 0 and not done.stderr, done.stderr


def test_an_ignored_conversion_is_warned_of(of_literals: Compiler) -> None:
    done = of_literals.compile("void use(double x) { msg::Angle14::from_degrees(x); }")
    assert "nodiscard" in done.stderr


@pytest.mark.parametrize("case", WRONG_LITERALS)
def test_wrong_forms_do_not_compile(case: str, of_literals: Compiler) -> None:
    source, sentence = WRONG_LITERALS[case]
    done = of_literals.compile(source)
    said = [line for line in done.stderr.splitlines() if re.search(r"\b(error|note)\b", line)]
    assert done.returncode != 0 and re.search(sentence, "\n".join(said)), done.stderr


ALL_HEADERS = """
#include <sbgc/client/client.hpp>
#include <sbgc/json.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/responses/all.hpp>
#include <sbgc/session.hpp>
#include <sbgc/text.hpp>
#include <sbgc/validate.hpp>
#include <sbgc/visit.hpp>
"""
# All messages through codec, text, JSON, validation and session.
ALL = """
template <class M>
void use(const M& message, sbgc::Session& session) {
  M copy = message;
  std::array<std::uint8_t, sbgc::max_frame_size> frame;
  static_cast<void>(sbgc::encode_frame(copy, frame));
  static_cast<void>(to_string(copy) + sbgc::to_json(copy));
  static_cast<void>(sbgc::is_valid(copy) && copy == message);
  if constexpr (M::direction != sbgc::Direction::from_board) session.send(copy);
}
void use_all(sbgc::Session& session) {
  sbgc::AllMessages::for_each([&]<class M>(sbgc::Type<M>) { use(M{}, session); });
}
"""
NAMED = {
    "sbgc::msg::ReadParams request{}": "use CMD_READ_PARAMS_3",
    "auto pin = sbgc::msg::RcInput::ext_fc_input_pitch_analog": "use adc4",
    "auto command = sbgc::msg::CommandToBoard::sign_message_3": "use sign_message",
}


@pytest.fixture(params=LAST_COMPILER, name="of_all", scope="module")
def with_headers(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> Compiler:
    folder = tmp_path_factory.mktemp("headers")
    return Compiler(request.param, ALL_HEADERS, folder)


def test_headers_and_code_for_any_message_say_nothing(of_all: Compiler) -> None:
    done = of_all.compile(ALL)
    assert done.returncode == 0 and not done.stderr


@pytest.mark.parametrize("code", NAMED)
def test_a_name_warns(of_all: Compiler, code: str) -> None:
    done = of_all.compile(f"void f() {{ [[maybe_unused]] {code}; }}\n")
    warnings = {line for line in done.stderr.splitlines() if "warning: " in line}
    assert done.returncode == 0
    assert len(warnings) == 1 and NAMED[code] in warnings.pop(), done.stderr
