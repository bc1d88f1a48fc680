"""Invalid uses of literals do not compile, and the compiler's message explains the alternative."""

from __future__ import annotations

import re

import pytest

from compiler import COMPILERS, Compiler

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

WRONG = {
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
RIGHT = """
Both both{.ours = 45_deg, .standard = -45_deg};
void use(double x, msg::Control& control) {
  if (const auto angle = msg::Angle14::from_degrees(x)) control.axes.yaw.angle = *angle;
}
constexpr msg::Angle14 counts(5);
static_assert(counts.raw() == 5 && msg::Angle14{-5}.raw() == -5);
static_assert(!std::is_convertible_v<int, msg::Angle14>);
"""


@pytest.fixture(name="compiler", params=COMPILERS, scope="module")
def each_compiler(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> Compiler:
    return Compiler(request.param, HEAD, tmp_path_factory.mktemp(request.param))


def test_right_forms_compile(compiler: Compiler) -> None:
    done = compiler.compile(RIGHT)
    assert done.returncode == 0 and not done.stderr, done.stderr


def test_an_ignored_conversion_is_warned_of(compiler: Compiler) -> None:
    done = compiler.compile("void use(double x) { msg::Angle14::from_degrees(x); }")
    assert "nodiscard" in done.stderr


@pytest.mark.parametrize("case", WRONG)
def test_wrong_forms_do_not_compile(case: str, compiler: Compiler) -> None:
    source, sentence = WRONG[case]
    done = compiler.compile(source)
    said = [line for line in done.stderr.splitlines() if re.search(r"\b(error|note)\b", line)]
    assert done.returncode != 0 and re.search(sentence, "\n".join(said)), done.stderr
